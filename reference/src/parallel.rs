//! Work on all processors, or on the calling thread alone. Results never depend on which.

use rayon::prelude::*;
use std::cell::Cell;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock};

thread_local! {
    /// Whether this thread works alone: waking another one costs more than a small frame.
    static ALONE: Cell<bool> = const { Cell::new(false) };
}

/// Least number of items worth handing to another thread.
const GRAIN: usize = 64;

/// Runs `work` with so many threads; as many as there are processors for `None` and 0. Pools are kept.
pub(crate) fn with<T: Send>(threads: Option<usize>, work: impl FnOnce() -> T + Send) -> T {
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

/// `f` of 0, 1, … `count` − 1, in order.
pub(crate) fn map<T: Send>(count: usize, f: impl Fn(usize) -> T + Sync + Send) -> Vec<T> {
    if ALONE.get() {
        (0..count).map(f).collect()
    } else {
        (0..count)
            .into_par_iter()
            .with_min_len(GRAIN)
            .map(f)
            .collect()
    }
}

/// `f` of every chunk of `size` items, with the number of the chunk and something that each thread makes once; the
/// results are added up.
pub(crate) fn chunks<T: Send, M, R: Send + Default + std::ops::Add<Output = R>>(
    items: &mut [T],
    size: usize,
    memory: impl Fn() -> M + Sync + Send,
    f: impl Fn(&mut M, usize, &mut [T]) -> R + Sync + Send,
) -> R {
    if ALONE.get() {
        let mut memory = memory();
        let chunks = items.chunks_mut(size).enumerate();
        chunks.fold(R::default(), |sum, (k, chunk)| {
            sum + f(&mut memory, k, chunk)
        })
    } else {
        items
            .par_chunks_mut(size)
            .enumerate()
            .map_init(memory, |memory, (k, chunk)| f(memory, k, chunk))
            .reduce(R::default, |a, b| a + b)
    }
}
