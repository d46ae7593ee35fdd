//! Which register writes share a clock in a core that takes several words per clock.

use shadegate_hdl::shade::lanes::{reaches, TARGETS};
use shadegate_hdl::shade::phong::FENCE_WORD;

/// Select code of the fence, before and behind which order matters between targets as well.
const FENCE: u8 = FENCE_WORD as u8;

/// The targets that a select code means, one bit each.
fn targets(select: u8) -> u8 {
    (0..TARGETS).fold(0, |set, t| set | u8::from(reaches(select, t)) << t)
}

/// The writes of a primitive, clock by clock: at most `lanes` in one, no two to the same target, those of a target in
/// order. A target with many words left goes first, since it takes one word per clock at best.
#[must_use]
pub fn clocks(writes: &[(u8, u64)], lanes: usize) -> Vec<Vec<(u8, u64)>> {
    let mut left = writes.to_vec();
    let mut out = vec![];
    while !left.is_empty() {
        if lanes == 1 || left[0].0 == FENCE {
            out.push(vec![left.remove(0)]);
            continue;
        }
        let fence = left.iter().position(|(select, _)| *select == FENCE);
        let open = &left[..fence.unwrap_or(left.len())];
        let words = |target: usize| open.iter().filter(|w| reaches(w.0, target)).count();
        let words: Vec<usize> = (0..TARGETS).map(words).collect();
        let most = |select: u8| {
            (0..TARGETS)
                .filter(|t| reaches(select, *t))
                .map(|t| words[t])
                .max()
        };
        // The first word of every target, where no earlier word of its other targets waits.
        let mut taken = 0u8;
        let mut first: Vec<usize> = vec![];
        for (index, (select, _)) in open.iter().enumerate() {
            if targets(*select) & taken == 0 {
                first.push(index);
            }
            taken |= targets(*select);
            if taken.count_ones() as usize == TARGETS {
                break;
            }
        }
        first.sort_by_key(|index| std::cmp::Reverse(most(open[*index].0)));
        first.truncate(lanes);
        first.sort_unstable();
        out.push(first.iter().map(|index| open[*index]).collect());
        for index in first.into_iter().rev() {
            left.remove(index);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Eleven words of the shell, ten of each colour, four of depth.
    fn quadratic() -> Vec<(u8, u64)> {
        let words = |mask: u8, count: u8| (0..count).map(move |w| (mask | w, u64::from(mask) + 1));
        let colours = (0..10).flat_map(|w| [0x10 | w, 0x20 | w, 0x40 | w].map(|s| (s, 1)));
        words(0, 11).chain(colours).chain(words(0x80, 4)).collect()
    }

    #[test]
    fn every_lane_is_used_while_targets_last() {
        let writes = quadratic();
        for (lanes, clocks_wanted) in [(1, 45), (2, 23), (4, 12)] {
            let got = clocks(&writes, lanes);
            assert_eq!(got.len(), clocks_wanted, "{lanes} lanes");
            assert!(got.iter().all(|c| c.len() <= lanes));
            let mut all: Vec<_> = got.concat();
            let mut want = writes.clone();
            all.sort_unstable();
            want.sort_unstable();
            assert_eq!(all, want);
        }
    }

    #[test]
    fn targets_keep_their_order_and_share_no_clock() {
        // A write to two colours waits for an earlier one to either, and a fence for everything.
        let writes = [
            (0x10, 1),
            (0x30, 2),
            (0x20, 3),
            (0x81, 4),
            (FENCE, 0),
            (0x40, 5),
            (0x40, 6),
            (0x00, 7),
        ];
        let got = clocks(&writes, 4);
        let want: [&[(u8, u64)]; 6] = [
            &[(0x10, 1), (0x81, 4)],
            &[(0x30, 2)],
            &[(0x20, 3)],
            &[(FENCE, 0)],
            &[(0x40, 5), (0x00, 7)],
            &[(0x40, 6)],
        ];
        assert_eq!(got, want);
    }
}
