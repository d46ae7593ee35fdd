//! Paths through keys: cubic pieces with the slopes of Catmull and Rom (1974) at keys that need not be evenly spaced
//! (Loisel 1996). Between (x₁, y₁) and (x₂, y₂) the curve has the slopes (y₂ − y₀)/(x₂ − x₀) and (y₃ − y₁)/(x₃ − x₁) at
//! its ends, so that it is smooth at every key. The first and the last piece, which have no key beyond, take the slope of
//! the chord there.

use glam::DVec3;

/// A path through keys.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    keys: Vec<(f64, DVec3)>,
}

impl Path {
    /// The path through these keys, in the order of their times; none without keys or when two have one time.
    #[must_use]
    pub fn new(mut keys: Vec<(f64, DVec3)>) -> Option<Self> {
        keys.sort_by(|a, b| a.0.total_cmp(&b.0));
        let apart = keys.windows(2).all(|w| w[0].0 < w[1].0);
        (apart && !keys.is_empty()).then_some(Self { keys })
    }

    /// The slope at key `k`.
    fn slope(&self, k: usize) -> DVec3 {
        let before = self.keys[k.saturating_sub(1)];
        let after = self.keys[(k + 1).min(self.keys.len() - 1)];
        if after.0 > before.0 {
            (after.1 - before.1) / (after.0 - before.0)
        } else {
            DVec3::ZERO
        }
    }

    /// The place at a time; before the first and after the last key, at that key.
    #[must_use]
    pub fn at(&self, time: f64) -> DVec3 {
        let (k, u) = segment(self.keys.iter().map(|k| k.0), time);
        let Some((x2, y2)) = self.keys.get(k + 1).copied() else {
            return self.keys[k].1;
        };
        let (x1, y1) = self.keys[k];
        let width = x2 - x1;
        let (s1, s2) = (self.slope(k) * width, self.slope(k + 1) * width);
        // Hermite's cubic, by Horner's rule.
        let (a, b) = ((y1 - y2) * 2.0 + s1 + s2, (y2 - y1) * 3.0 - s1 * 2.0 - s2);
        ((a * u + b) * u + s1) * u + y1
    }
}

/// In which piece between ascending key times a time lies, and how far along it, 0 to 1.
pub(super) fn segment(
    times: impl ExactSizeIterator<Item = f64> + Clone,
    time: f64,
) -> (usize, f64) {
    let last = times.len().saturating_sub(1);
    let k = times
        .clone()
        .take_while(|t| *t <= time)
        .count()
        .saturating_sub(1);
    let mut from = times.skip(k);
    match (from.next(), from.next()) {
        (Some(a), Some(b)) => (k, ((time - a) / (b - a)).clamp(0.0, 1.0)),
        _ => (last, 0.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn path(keys: &[(f64, f64)]) -> Path {
        let keys = keys.iter().map(|(t, v)| (*t, DVec3::new(*v, -v, 2.0 * v)));
        Path::new(keys.collect()).unwrap()
    }

    #[test]
    fn keys_must_differ_in_time() {
        assert_eq!(Path::new(Vec::new()), None);
        assert_eq!(Path::new(vec![(1.0, DVec3::X), (1.0, DVec3::Y)]), None);
        let one = Path::new(vec![(1.0, DVec3::X)]).unwrap();
        assert_eq!([one.at(-5.0), one.at(1.0), one.at(9.0)], [DVec3::X; 3]);
    }

    proptest! {
        #[test]
        fn it_passes_through_its_keys_smoothly(
            gaps in prop::collection::vec(0.1..5.0f64, 1..7), values in prop::collection::vec(-9.0..9.0f64, 8),
        ) {
            let mut t = -2.0;
            let keys: Vec<(f64, f64)> = gaps.iter().zip(&values).map(|(g, v)| { t += g; (t, *v) }).collect();
            let p = path(&keys);
            for (k, (t, v)) in keys.iter().enumerate() {
                prop_assert!((p.at(*t).x - v).abs() < 1e-12);
                // The slope from either side is that of the neighbours' chord: at both ends of a piece, where the text
                // names the wrong keys.
                if k > 0 && k + 1 < keys.len() {
                    let h = 1e-7;
                    let want = (keys[k + 1].1 - keys[k - 1].1) / (keys[k + 1].0 - keys[k - 1].0);
                    let before = (p.at(*t).x - p.at(t - h).x) / h;
                    let after = (p.at(t + h).x - p.at(*t).x) / h;
                    prop_assert!((before - want).abs() < 1e-3 && (after - want).abs() < 1e-3);
                }
            }
            prop_assert_eq!(p.at(-1e9), p.at(keys[0].0));
            prop_assert_eq!(p.at(1e9), p.at(keys[keys.len() - 1].0));
        }

        #[test]
        fn what_moves_evenly_keeps_its_speed(gaps in prop::collection::vec(0.1..5.0f64, 2..7), s in 0.0..1.0f64) {
            let mut t = 0.0;
            let keys: Vec<(f64, f64)> = gaps.iter().map(|g| { t += g; (t, 3.0 * t - 1.0) }).collect();
            let time = keys[0].0 + s * (t - keys[0].0);
            prop_assert!((path(&keys).at(time).x - (3.0 * time - 1.0)).abs() < 1e-12 * (1.0 + t));
        }
    }

    #[test]
    fn between_even_keys_a_parabola_is_kept() {
        let p = path(&[(0.0, 0.0), (1.0, 1.0), (2.0, 4.0), (3.0, 9.0), (4.0, 16.0)]);
        for k in 0..=20 {
            let t = 1.0 + f64::from(k) / 10.0;
            assert!((p.at(t).x - t * t).abs() < 1e-12);
        }
    }
}
