//! cosⁿx ≈ cos²(ax) for |x| < π/(2a), else 0 (Abbas 2003, eq. 6.11), so that one ROM serves every exponent.
//!
//! a(n) makes the integrals ∫ f(x)·sin x dx of both equal: (2a²(1 − cos(π/2a)) − 1)/(4a² − 1) = 1/(n + 1) (eq. 6.12),
//! solved here by bisection (the left side falls as a grows). Table 6.1 holds some of its roots, correctly. The a of
//! least maximal error ("minimax") is better by a quarter: 13.4 LSB of full scale for large n in place of 18.4.
//! Below n = 2 the support would reach beyond π/2 and light what lies behind, so there cosⁿ itself is taken.

use super::{distance, least, power, Curve};
use std::f64::consts::FRAC_PI_2;

/// Exponents below this one have a < 1.
pub const LEAST_EXPONENT: f64 = 2.0;

/// The approximation for one exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cos2 {
    /// a; 0 stands for cosⁿ itself.
    a: f64,
    n: f64,
}

impl Cos2 {
    /// With the a of eq. 6.12.
    #[must_use]
    pub fn new(n: f64) -> Self {
        Self::with(n, matched)
    }

    /// With the a of least maximal error.
    #[must_use]
    pub fn minimax(n: f64) -> Self {
        Self::with(n, minimax)
    }

    fn with(n: f64, a: impl Fn(f64) -> f64) -> Self {
        let a = if n < LEAST_EXPONENT { 0.0 } else { a(n) };
        Self { a, n }
    }

    /// a, or none where cosⁿ itself is taken.
    #[must_use]
    pub fn a(&self) -> Option<f64> {
        (self.a > 0.0).then_some(self.a)
    }
}

impl Curve for Cos2 {
    fn at(&self, x: f64) -> f64 {
        if self.a == 0.0 {
            return power(x, self.n);
        }
        let y = self.a * x;
        if y.abs() < FRAC_PI_2 {
            y.cos().powi(2)
        } else {
            0.0
        }
    }
}

/// a(n) of eq. 6.12, for n from 1.
#[must_use]
pub fn matched(n: f64) -> f64 {
    // 1 − cos(π/2a) = 2·sin²(π/4a) keeps its digits for large a.
    let integral = |a: f64| {
        let sin = (FRAC_PI_2 / 2.0 / a).sin();
        (4.0 * a * a * sin * sin - 1.0) / (4.0 * a * a - 1.0)
    };
    let (mut low, mut high) = (0.6, 1.0 + n.sqrt());
    for _ in 0..64 {
        let middle = (low + high) / 2.0;
        if integral(middle) > 1.0 / (n + 1.0) {
            low = middle;
        } else {
            high = middle;
        }
    }
    (low + high) / 2.0
}

/// a(n) of least maximal error, for n from [`LEAST_EXPONENT`].
#[must_use]
pub fn minimax(n: f64) -> f64 {
    let a = matched(n);
    least(0.98 * a, 1.05 * a, 40, |a| {
        distance(n, 1024, &Cos2 { a, n })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Abbas 2003, Table 6.1, and the figures that the notes measured for it: n, a, error, minimax a, error (LSB).
    const TABLE: [(f64, f64, f64, f64, f64); 7] = [
        (2.0, 1.0000, 0.0, 1.0000, 0.0),
        (5.0, 1.4502, 10.1, 1.4614, 8.8),
        (10.0, 1.9845, 14.1, 2.0182, 11.2),
        (20.0, 2.7582, 16.2, 2.8215, 12.3),
        (50.0, 4.3143, 17.5, 4.4310, 13.0),
        (100.0, 6.0791, 18.0, 6.2524, 13.2),
        (500.0, 13.5535, 18.3, 13.9560, 13.4),
    ];

    #[test]
    fn table_6_1_to_its_four_decimals() {
        for (n, a, ..) in TABLE {
            assert!((matched(n) - a).abs() <= 0.5e-4, "{n}: {}", matched(n));
        }
    }

    #[test]
    fn errors_are_the_measured_ones_and_minimax_is_better() {
        for (n, _, error, best, least) in TABLE {
            let e = 255.0 * distance(n, 4096, &Cos2::new(n));
            let m = 255.0 * distance(n, 4096, &Cos2::minimax(n));
            println!(
                "n={n}: a={:.4} {e:.2} LSB, minimax a={:.4} {m:.2} LSB",
                matched(n),
                minimax(n)
            );
            assert!(
                (e - error).abs() < 0.06 && (m - least).abs() < 0.06,
                "{n}: {e} {m}"
            );
            assert!((minimax(n) - best).abs() < 3e-4, "{n}: {}", minimax(n));
            assert!(m <= e + 1e-6);
        }
        // The limit: a = 0.62385·√n, 13.4 LSB.
        let n = 10_000.0;
        assert!((minimax(n) / n.sqrt() - 0.62385).abs() < 1e-3);
    }

    /// Eq. 6.12 against its meaning: both integrals by Simpson's rule.
    #[test]
    fn the_matched_a_matches_the_integrals() {
        for n in [2.0, 3.7, 20.0, 300.0] {
            let c = Cos2::new(n);
            let steps = 20_000;
            let h = FRAC_PI_2 / f64::from(steps);
            let simpson = |f: &dyn Fn(f64) -> f64| {
                let sum: f64 = (0..=steps)
                    .map(|i| {
                        let weight = match i {
                            0 => 1.0,
                            i if i == steps => 1.0,
                            i if i % 2 == 1 => 4.0,
                            _ => 2.0,
                        };
                        let x = f64::from(i) * h;
                        weight * f(x) * x.sin()
                    })
                    .sum();
                sum * h / 3.0
            };
            let (ours, true_one) = (
                simpson(&|x| c.at(x)),
                simpson(&|x| x.cos().max(0.0).powf(n)),
            );
            assert!(
                (ours - true_one).abs() < 1e-8 && (true_one - 1.0 / (n + 1.0)).abs() < 1e-8,
                "{n}"
            );
        }
    }

    #[test]
    fn small_exponents_light_nothing_behind() {
        for n in [0.0, 0.5, 1.0, 1.9] {
            for c in [Cos2::new(n), Cos2::minimax(n)] {
                assert_eq!(c.a(), None);
                assert_eq!(c.at(1.6), 0.0);
                assert!((c.at(0.5) - 0.5f64.cos().powf(n)).abs() < 1e-15);
            }
        }
    }
}
