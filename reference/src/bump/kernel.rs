//! The reconstruction filters of Mitchell and Netravali (Hast 2004, eq. 3.263, where |x| belongs for x):
//!
//! 6·h(x) = (12 − 9B − 6C)|x|³ + (−18 + 12B + 6C)|x|² + (6 − 2B) for |x| < 1,
//! 6·h(x) = (−B − 6C)|x|³ + (6B + 30C)|x|² + (−12B − 48C)|x| + (8B + 24C) for 1 ≤ |x| < 2, and 0 beyond.
//!
//! B = 1, C = 0 is the cubic B-spline, which blurs; B = 0, C = ½ is Catmull and Rom's, which passes through the samples.

/// A filter of the family.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kernel {
    b: f64,
    c: f64,
}

impl Kernel {
    /// The cubic B-spline.
    pub const B_SPLINE: Self = Self { b: 1.0, c: 0.0 };
    /// Catmull–Rom.
    pub const CATMULL_ROM: Self = Self { b: 0.0, c: 0.5 };

    /// Coefficients of |x|³, |x|², |x| and 1 around `x`, six times too large.
    fn piece(self, x: f64) -> [f64; 4] {
        let Self { b, c } = self;
        let x = x.abs();
        if x < 1.0 {
            [
                12.0 - 9.0 * b - 6.0 * c,
                -18.0 + 12.0 * b + 6.0 * c,
                0.0,
                6.0 - 2.0 * b,
            ]
        } else if x < 2.0 {
            [
                -b - 6.0 * c,
                6.0 * b + 30.0 * c,
                -12.0 * b - 48.0 * c,
                8.0 * b + 24.0 * c,
            ]
        } else {
            [0.0; 4]
        }
    }

    /// h(x).
    #[must_use]
    pub fn value(self, x: f64) -> f64 {
        let [p, q, r, s] = self.piece(x);
        let x = x.abs();
        (((p * x + q) * x + r) * x + s) / 6.0
    }

    /// h'(x).
    #[must_use]
    pub fn slope(self, x: f64) -> f64 {
        let [p, q, r, _] = self.piece(x);
        let a = x.abs();
        ((3.0 * p * a + 2.0 * q) * a + r) / 6.0 * x.signum()
    }

    /// Weights of the samples at −1, 0, 1 and 2 for a place `f` from 0 to 1.
    #[must_use]
    pub fn weights(self, f: f64) -> [f64; 4] {
        [1.0, 0.0, -1.0, -2.0].map(|shift| self.value(f + shift))
    }

    /// Their derivatives in `f`.
    #[must_use]
    pub fn slopes(self, f: f64) -> [f64; 4] {
        [1.0, 0.0, -1.0, -2.0].map(|shift| self.slope(f + shift))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOTH: [Kernel; 2] = [Kernel::B_SPLINE, Kernel::CATMULL_ROM];

    #[test]
    fn weights_sum_to_one_and_slopes_to_nothing() {
        for k in BOTH {
            for i in 0..=100 {
                let f = f64::from(i) / 100.0;
                let (w, s) = (k.weights(f), k.slopes(f));
                assert!((w.iter().sum::<f64>() - 1.0).abs() < 4e-15);
                assert!(s.iter().sum::<f64>().abs() < 4e-15);
                // A ramp of slope 1 has slope 1 and goes through its samples.
                let at = |w: [f64; 4]| -w[0] + w[2] + 2.0 * w[3];
                assert!((at(w) - f).abs() < 4e-15 && (at(s) - 1.0).abs() < 4e-15);
            }
        }
    }

    /// A B-spline is a box convolved with itself: Cox and de Boor's recurrence, at any place.
    fn b_spline(x: f64) -> f64 {
        fn basis(i: f64, degree: i32, x: f64) -> f64 {
            if degree == 0 {
                return f64::from(u8::from(i <= x && x < i + 1.0));
            }
            let n = f64::from(degree);
            (x - i) / n * basis(i, degree - 1, x)
                + (i + n + 1.0 - x) / n * basis(i + 1.0, degree - 1, x)
        }
        basis(-2.0, 3, x)
    }

    #[test]
    fn values_and_slopes_from_their_definitions() {
        for i in -240..=240 {
            let x = f64::from(i) / 100.0 + 0.003;
            assert!(
                (Kernel::B_SPLINE.value(x) - b_spline(x)).abs() < 1e-14,
                "{x}"
            );
            for k in BOTH {
                let h = 1e-6;
                let slope = (k.value(x + h) - k.value(x - h)) / (2.0 * h);
                assert!((k.slope(x) - slope).abs() < 1e-8, "{x}");
                assert_eq!(k.value(x), k.value(-x));
            }
        }
        assert_eq!(Kernel::CATMULL_ROM.weights(0.0), [0.0, 1.0, 0.0, 0.0]);
        assert_eq!(Kernel::CATMULL_ROM.weights(1.0), [0.0, 0.0, 1.0, 0.0]);
    }
}
