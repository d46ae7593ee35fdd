//! The Pareto front: what is worth choosing when both coordinates cost something (Pareto 1906).

/// Whether `a` is nowhere worse than `b` and somewhere better.
fn beats(a: (f64, f64), b: (f64, f64)) -> bool {
    a.0 <= b.0 && a.1 <= b.1 && (a.0 < b.0 || a.1 < b.1)
}

/// For every point whether no other beats it: none is at most as dear in both coordinates and cheaper in one. Of equal
/// points all are on the front or none. What is not a number is never on it.
#[must_use]
pub fn front(points: &[(f64, f64)]) -> Vec<bool> {
    let number = |p: (f64, f64)| !p.0.is_nan() && !p.1.is_nan();
    points
        .iter()
        .map(|p| number(*p) && !points.iter().any(|q| beats(*q, *p)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_front_of_made_up_points() {
        let points = [
            (1.0, 9.0),           // the fastest
            (2.0, 4.0),           // between
            (2.0, 5.0),           // as fast as that, and worse
            (3.0, 4.0),           // as good as that, and slower
            (5.0, 0.0),           // the best
            (5.0, 0.0),           // the best again
            (9.0, 0.0),           // as good, slower
            (f64::NAN, 0.0),      // nothing
            (4.0, f64::INFINITY), // beaten by all but the slowest
        ];
        assert_eq!(
            front(&points),
            [true, true, false, false, true, true, false, false, false]
        );
        assert_eq!(front(&[]), [false; 0]);
    }

    proptest! {
        /// From the other side: sorted by the first coordinate, the front descends strictly in the second, and everything
        /// off it lies above some point of it.
        #[test]
        fn it_descends_and_covers(points in prop::collection::vec((0u8..20, 0u8..20), 1..40)) {
            let points: Vec<(f64, f64)> = points.iter().map(|p| (p.0.into(), p.1.into())).collect();
            let on = front(&points);
            let mut chosen: Vec<(f64, f64)> = points.iter().zip(&on).filter(|p| *p.1).map(|p| *p.0).collect();
            chosen.sort_by(|a, b| a.0.total_cmp(&b.0));
            chosen.dedup();
            prop_assert!(!chosen.is_empty());
            prop_assert!(chosen.windows(2).all(|w| w[0].0 < w[1].0 && w[0].1 > w[1].1));
            for (p, on) in points.iter().zip(&on) {
                let below = chosen.iter().any(|q| q.0 <= p.0 && q.1 <= p.1);
                prop_assert!(below && *on == chosen.contains(p));
            }
        }
    }
}
