//! What lies beside the picture, and which texels belong to a place. Texel i covers i..i + 1 along its axis and has its
//! centre at i + ½.

/// What lies beside the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// The picture again and again.
    #[default]
    Repeat,
    /// The texels of its border.
    Clamp,
}

/// x modulo n, in 0..n.
pub(super) fn fold(x: f64, n: f64) -> f64 {
    let r = x - (x / n).floor() * n;
    // Rounding may reach either end.
    if (0.0..n).contains(&r) {
        r
    } else {
        0.0
    }
}

impl Wrap {
    /// The texel of `n` that covers `x`.
    #[must_use]
    pub fn texel(self, x: f64, n: usize) -> usize {
        let x = match self {
            Self::Repeat => fold(x, n as f64),
            Self::Clamp => x,
        };
        // The conversion truncates and saturates.
        (x as usize).min(n - 1)
    }

    /// The two texels of `n` whose centres enclose `x`, and how far it is from the first to the second, 0..=1.
    #[must_use]
    pub fn pair(self, x: f64, n: usize) -> ([usize; 2], f64) {
        let last = n - 1;
        let x = match self {
            Self::Repeat => fold(x - 0.5, n as f64),
            Self::Clamp => (x - 0.5).clamp(0.0, last as f64),
        };
        let i = (x as usize).min(last);
        let next = match self {
            Self::Repeat if i == last => 0,
            _ => (i + 1).min(last),
        };
        ([i, next], x - i as f64)
    }

    /// The texel `offset` columns or rows from texel `i` of `n`.
    #[must_use]
    pub fn neighbour(self, i: usize, offset: isize, n: usize) -> usize {
        let n = n as isize;
        let j = i as isize + offset;
        (match self {
            Self::Repeat => j.rem_euclid(n),
            Self::Clamp => j.clamp(0, n - 1),
        }) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn texels_by_hand() {
        let (r, c) = (Wrap::Repeat, Wrap::Clamp);
        for (x, repeated, clamped) in [
            (0.0, 0, 0),
            (3.9, 3, 3),
            (4.0, 0, 3),
            (-0.1, 3, 0),
            (9.5, 1, 3),
        ] {
            assert_eq!((r.texel(x, 4), c.texel(x, 4)), (repeated, clamped), "{x}");
        }
        assert_eq!(r.pair(0.25, 4), ([3, 0], 0.75));
        assert_eq!(c.pair(0.25, 4), ([0, 1], 0.0));
        assert_eq!(r.pair(1.75, 4), ([1, 2], 0.25));
        assert_eq!(c.pair(3.75, 4), ([3, 3], 0.0));
        assert_eq!((r.neighbour(0, -1, 4), c.neighbour(0, -1, 4)), (3, 0));
        assert_eq!((r.neighbour(3, 2, 4), c.neighbour(3, 2, 4)), (1, 3));
    }

    proptest! {
        /// Any number whatever names a texel that exists.
        #[test]
        fn nothing_leads_outside(x in prop::num::f64::ANY, n in 1usize..5000) {
            for w in [Wrap::Repeat, Wrap::Clamp] {
                prop_assert!(w.texel(x, n) < n);
                let ([i, j], f) = w.pair(x, n);
                prop_assert!(i < n && j < n && (f.is_nan() || (0.0..=1.0).contains(&f)));
            }
        }

        #[test]
        fn a_whole_turn_changes_nothing(k in -50i32..50, x in 0.0..37.0f64) {
            let far = x + f64::from(k) * 37.0;
            let ([i, _], f) = Wrap::Repeat.pair(x, 37);
            let ([j, _], g) = Wrap::Repeat.pair(far, 37);
            let apart = (i as f64 + f - j as f64 - g).abs();
            prop_assert!(apart < 1e-9 || (apart - 37.0).abs() < 1e-9);
        }
    }
}
