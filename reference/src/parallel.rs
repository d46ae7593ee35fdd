//! Work on all processors, or on the calling thread alone. Results never depend on which.

use rayon::prelude::*;
use std::cell::Cell;
use std::collections::HashMap;
use std::ops::Range;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

thread_local! {
    /// Whether this thread works alone: waking another one costs more than a small frame.
    static ALONE: Cell<bool> = const { Cell::new(false) };
}

/// Least number of items worth handing to another thread.
const GRAIN: usize = 64;
/// The same for items that take some nanoseconds.
const FINE: usize = 2048;
/// Pieces of [`map`] for each thread, so that none of them waits long for the last.
const PIECES: usize = 16;

/// Runs `work` with so many threads; as many as there are processors for `None` and 0. What the renderer does inside,
/// [`crate::Prepared::new`] and [`crate::render`], then uses them, unless it is told a number of its own; results are the
/// same for any number. The threads are kept for the next time.
pub fn with<T: Send>(threads: Option<usize>, work: impl FnOnce() -> T + Send) -> T {
    static POOLS: OnceLock<Mutex<HashMap<usize, Arc<rayon::ThreadPool>>>> = OnceLock::new();
    match threads.filter(|n| *n > 0) {
        None => work(),
        Some(1) => {
            let before = ALONE.replace(true);
            let result = work();
            ALONE.set(before);
            result
        }
        Some(n) => {
            let pools = POOLS.get_or_init(Mutex::default);
            let pool = pools.lock().ok().and_then(|mut all| {
                if let Some(pool) = all.get(&n) {
                    return Some(pool.clone());
                }
                let new = rayon::ThreadPoolBuilder::new().num_threads(n).build();
                let pool = Arc::new(new.ok()?);
                all.insert(n, pool.clone());
                Some(pool)
            });
            match pool {
                Some(pool) => pool.install(work),
                None => work(),
            }
        }
    }
}

/// How many threads work here.
pub(crate) fn threads() -> usize {
    if ALONE.get() {
        1
    } else {
        rayon::current_num_threads()
    }
}

/// Into parts of how many items `count` of them are best divided: `parts` parts for each thread, but none of less than
/// `least` items; a single part for one thread.
pub(crate) fn share(count: usize, least: usize, parts: usize) -> usize {
    let whole = count.max(1);
    if count <= least {
        return whole;
    }
    match threads() {
        1 => whole,
        n => count.div_ceil(n * parts).max(least),
    }
}

/// `f` of 0, 1, … `count` − 1, in order.
pub(crate) fn map<T: Send>(count: usize, f: impl Fn(usize) -> T + Sync + Send) -> Vec<T> {
    spread(count, GRAIN, f)
}

/// As [`map`], where `f` takes some nanoseconds.
pub(crate) fn fill<T: Send>(count: usize, f: impl Fn(usize) -> T + Sync + Send) -> Vec<T> {
    spread(count, FINE, f)
}

fn spread<T: Send>(count: usize, grain: usize, f: impl Fn(usize) -> T + Sync + Send) -> Vec<T> {
    if count <= grain || ALONE.get() {
        return (0..count).map(f).collect();
    }
    let most = count.div_ceil(threads() * PIECES).max(grain);
    (0..count)
        .into_par_iter()
        .with_min_len(grain)
        .with_max_len(most)
        .map(f)
        .collect()
}

/// Both results, worked out at the same time when it is about more than a few items.
pub(crate) fn both<A: Send, B: Send>(
    count: usize,
    a: impl FnOnce() -> A + Send,
    b: impl FnOnce() -> B + Send,
) -> (A, B) {
    if count <= FINE || ALONE.get() {
        (a(), b())
    } else {
        rayon::join(a, b)
    }
}

/// `f` of every item, with its number and something that each thread makes once, in order. Each thread begins with a
/// share of its own, the same from call to call, since what it has just made is near to it; then it helps the others.
pub(crate) fn each<I, M, R>(
    mut items: I,
    memory: impl Fn() -> M + Sync + Send,
    f: impl Fn(&mut M, usize, I::Item) -> R + Sync + Send,
) -> Vec<R>
where
    I: ExactSizeIterator,
    I::Item: Send,
    R: Send,
{
    let count = items.len();
    if count < 2 || ALONE.get() {
        let mut memory = memory();
        let numbered = items.enumerate();
        return numbered.map(|(k, item)| f(&mut memory, k, item)).collect();
    }
    let workers = threads().min(count);
    let first = |w: usize| w * count / workers;
    let queue = |w: usize| {
        let own: Vec<_> = (first(w)..first(w + 1)).zip(items.by_ref()).collect();
        Mutex::new(own.into_iter())
    };
    let queues: Vec<_> = (0..workers).map(queue).collect();
    let queue = |w: usize| queues[w].lock().unwrap_or_else(PoisonError::into_inner);
    let next = |own: usize| {
        // Bound to a name, so that the queue is free again while the item is worked on.
        let item = queue(own).next();
        item.or_else(|| (1..workers).find_map(|k| queue((own + k) % workers).next_back()))
    };
    let work = |own: usize| {
        let mut memory = memory();
        let mut done = Vec::new();
        while let Some((k, item)) = next(own) {
            done.push((k, f(&mut memory, k, item)));
        }
        done
    };
    let workers = (0..workers).into_par_iter().with_max_len(1);
    let mut all: Vec<(usize, R)> = workers.flat_map_iter(work).collect();
    all.sort_unstable_by_key(|(k, _)| *k);
    all.into_iter().map(|(_, result)| result).collect()
}

/// [`each`] of the parts of `size` numbers that 0..`count` divides into.
pub(crate) fn parts<M, R: Send>(
    count: usize,
    size: usize,
    memory: impl Fn() -> M + Sync + Send,
    f: impl Fn(&mut M, Range<usize>) -> R + Sync + Send,
) -> Vec<R> {
    each(0..count.div_ceil(size), memory, |memory, k, _| {
        f(memory, k * size..count.min((k + 1) * size))
    })
}

/// The sum of `f` of parts that 0..`count` divides into.
pub(crate) fn sum(count: usize, f: impl Fn(Range<usize>) -> u64 + Sync + Send) -> u64 {
    let size = share(count, FINE, 4);
    let sums = parts(count, size, || (), |(), range| f(range));
    sums.into_iter().sum()
}

/// [`each`] of the chunks of `size` items; the results are added up.
pub(crate) fn chunks<T: Send, M, R: Send + Default + std::ops::Add<Output = R>>(
    items: &mut [T],
    size: usize,
    memory: impl Fn() -> M + Sync + Send,
    f: impl Fn(&mut M, usize, &mut [T]) -> R + Sync + Send,
) -> R {
    let sums = each(items.chunks_mut(size), memory, f);
    sums.into_iter().fold(R::default(), |a, b| a + b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_is_done_once_and_in_order() {
        for threads in [1, 2, 3, 7] {
            for count in [0, 1, 2, 63, 65, 2049, 20_000] {
                let want: Vec<usize> = (0..count).map(|i| 3 * i).collect();
                with(Some(threads), || {
                    assert_eq!(map(count, |i| 3 * i), want);
                    assert_eq!(fill(count, |i| 3 * i), want);
                    assert_eq!(both(count, || want.len(), || 2), (count, 2));
                    assert_eq!(super::sum(count, |r| r.len() as u64), count as u64);
                    for size in [1, 7, 4096] {
                        let lists = parts(count, size, || 3, |m, r| r.map(|i| *m * i).collect());
                        assert_eq!(lists.len(), count.div_ceil(size));
                        let lists: Vec<Vec<usize>> = lists;
                        assert_eq!(lists.concat(), want);
                        let mut items = want.clone();
                        let sum = chunks(
                            &mut items,
                            size,
                            || (),
                            |(), k, chunk| {
                                chunk.iter_mut().for_each(|v| *v += k);
                                chunk.len()
                            },
                        );
                        assert_eq!(sum, count);
                        let more = |(i, v): (usize, &usize)| *v == want[i] + i / size;
                        assert!(items.iter().enumerate().all(more));
                    }
                });
            }
        }
    }

    #[test]
    fn shares_are_enough_for_every_thread_and_not_small() {
        with(Some(1), || assert_eq!(share(100_000, 1000, 4), 100_000));
        with(Some(2), || {
            assert_eq!(share(0, 1000, 4), 1);
            assert_eq!(share(1000, 1000, 4), 1000);
            assert_eq!(share(3000, 1000, 4), 1000);
            assert_eq!(share(80_001, 1000, 4), 10_001);
        });
    }
}
