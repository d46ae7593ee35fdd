//! The front-to-back hint: near objects are drawn first, so that the depth test hides what lies behind them before it is shaded.
//!
//! Of equal depths the first drawn wins, so an order is free only where depths cannot be equal: objects change places when
//! a gap of [`GAP`] of the frame's depth range lies between all of one and all of the other. Objects without such a gap, directly or
//! through others, stay together and in the order of the scene.

use std::cmp::Ordering;

/// Gap between two objects that may change places, in frame depth ranges: sixteen words of a 16-bit depth, while depths
/// differ from the exact ones by less than two in every renderer and core.
const GAP: f64 = 1.0 / 4096.0;

/// The order in which to draw objects whose least and greatest nearness are `ranges`, nearest first. What is never visible (a range
/// from infinity to minus infinity) comes last.
pub(super) fn order(ranges: &[[f64; 2]]) -> Vec<usize> {
    let least = ranges.iter().fold(f64::INFINITY, |a, r| a.min(r[0]));
    let most = ranges.iter().fold(f64::NEG_INFINITY, |a, r| a.max(r[1]));
    let gap = (most - least) * GAP;
    let mut order: Vec<usize> = (0..ranges.len()).collect();
    order.sort_by(|a, b| {
        let by_nearest = ranges[*b][1].partial_cmp(&ranges[*a][1]);
        by_nearest.unwrap_or(Ordering::Equal)
    });
    let mut start = 0;
    let mut farthest = f64::INFINITY;
    for k in 0..order.len() {
        let [lo, hi] = ranges[order[k]];
        if hi < farthest - gap {
            order[start..k].sort_unstable();
            start = k;
        }
        farthest = farthest.min(lo);
    }
    order[start..].sort_unstable();
    order
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn near_objects_come_first_and_neighbours_stay() {
        assert_eq!(order(&[]), [0usize; 0]);
        assert_eq!(order(&[[0.0, 1.0], [2.0, 3.0], [4.0, 5.0]]), [2, 1, 0]);
        // The second touches the first, the third the second.
        assert_eq!(order(&[[0.0, 1.0], [1.0, 3.0], [2.9, 5.0]]), [0, 1, 2]);
        assert_eq!(
            order(&[[0.0, 1.0], [8.0, 9.0], [0.5, 2.0], [8.5, 8.6]]),
            [1, 3, 0, 2]
        );
        // Apart, but by less than the gap.
        assert_eq!(order(&[[0.0, 1.0], [1.0001, 2.0]]), [0, 1]);
        assert_eq!(order(&[[0.0, 1.0], [1.001, 2.0]]), [1, 0]);
        let never = [f64::INFINITY, f64::NEG_INFINITY];
        assert_eq!(order(&[never, [0.0, 1.0]]), [1, 0]);
        assert_eq!(order(&[never, never]), [0, 1]);
        assert_eq!(order(&[[1.0, 1.0], [1.0, 1.0]]), [0, 1]);
    }

    proptest! {
        /// The components of "no gap between", found pair by pair, near ones first, each in the order of the scene.
        #[test]
        fn components_come_nearest_first(
            ends in prop::collection::vec((0.0..1.0f64, 0.0..0.2f64), 1..12)
        ) {
            let ranges: Vec<[f64; 2]> = ends.iter().map(|(lo, size)| [*lo, lo + size]).collect();
            let width = ranges.iter().fold(0.0f64, |a, r| a.max(r[1]))
                - ranges.iter().fold(1.0f64, |a, r| a.min(r[0]));
            let n = ranges.len();
            let mut component: Vec<usize> = (0..n).collect();
            for _ in 0..n {
                for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                    if ranges[i][0] <= ranges[j][1] + width * GAP
                        && ranges[j][0] <= ranges[i][1] + width * GAP
                    {
                        let least = component[i].min(component[j]);
                        (component[i], component[j]) = (least, least);
                    }
                }
            }
            let nearest = |c: usize| {
                let of = (0..n).filter(|i| component[*i] == c).map(|i| ranges[i][1]);
                of.fold(0.0f64, f64::max)
            };
            let mut expected: Vec<usize> = (0..n).collect();
            expected.sort_by(|a, b| {
                nearest(component[*b]).total_cmp(&nearest(component[*a])).then(a.cmp(b))
            });
            prop_assert_eq!(order(&ranges), expected);
        }
    }
}
