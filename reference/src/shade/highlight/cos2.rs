//! A squared cosine of a multiple of the angle x = arccos ε: f = cos²(a·x) for x < π/(2a), else 0 (Abbas 2003, 6.11),
//! the product that a table of one period of cos² makes.
//!
//! a(n) gives f the same integral over the sphere as the power has (6.12):
//! (2a²(1 − cos(π/2a)) − 1)/(4a² − 1) = 1/(n + 1). [`matched`] solves it.
//!
//! Largest error: [`Cos2::bound`], rising from 0 at n = 2 to 18.4 LSB.

use crate::shade::curve::cos2::matched;
use std::f64::consts::FRAC_PI_2;

/// A squared cosine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cos2 {
    /// The factor a of the angle.
    pub a: f64,
}

impl Cos2 {
    /// The function with the integral of εⁿ, n ≥ 1.
    #[must_use]
    pub fn new(n: f64) -> Self {
        Self { a: matched(n) }
    }

    /// The value at cosine `e`.
    #[must_use]
    pub fn value(&self, e: f64) -> f64 {
        let x = self.a * e.clamp(-1.0, 1.0).acos();
        if x < FRAC_PI_2 {
            x.cos().powi(2)
        } else {
            0.0
        }
    }

    /// A bound on the error against εⁿ in LSB, for n from 1 to 500.
    #[must_use]
    pub fn bound(n: f64) -> f64 {
        if n < 2.0 {
            25.9
        } else {
            18.4
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{exponents, worst};
    use super::*;

    /// Table 6.1 of Abbas, from the equation.
    #[test]
    fn the_printed_table() {
        let table = [
            (2.0, 1.0000, 0.0),
            (5.0, 1.4502, 10.1),
            (10.0, 1.9845, 14.1),
            (20.0, 2.7582, 16.2),
            (50.0, 4.3143, 17.5),
            (100.0, 6.0791, 18.0),
            (500.0, 13.5535, 18.3),
        ];
        for (n, a, error) in table {
            let c = Cos2::new(n);
            assert!((c.a - a).abs() <= 5.001e-5, "{n}: {}", c.a);
            let e = worst(n, |e| c.value(e));
            assert!((e - error).abs() < 0.06, "{n}: {e}");
        }
        assert!((Cos2::new(1.0).a - 0.7938).abs() < 5.001e-5);
        assert!((Cos2::new(3.0).a - 1.1697).abs() < 5.001e-5);
    }

    /// The closed form against the integral itself, by Simpson's rule.
    #[test]
    fn the_integral_is_that_of_the_power() {
        for n in [1.0, 3.5, 20.0, 10_000.0] {
            let a = Cos2::new(n).a;
            let (end, steps) = (FRAC_PI_2 / a, 2000);
            let f = |i: i32| {
                let x = end * f64::from(i) / f64::from(steps);
                (a * x).cos().powi(2) * x.sin()
            };
            let sum: f64 = (0..steps)
                .step_by(2)
                .map(|i| f(i) + 4.0 * f(i + 1) + f(i + 2))
                .sum();
            let integral = sum * end / f64::from(3 * steps);
            assert!((integral * (n + 1.0) - 1.0).abs() < 1e-9, "{n}");
        }
    }

    #[test]
    fn errors_stay_within_the_bound() {
        let mut most = (0.0f64, 0.0f64);
        for n in exponents() {
            let c = Cos2::new(n);
            let e = worst(n, |e| c.value(e));
            assert!(e <= Cos2::bound(n), "{n}: {e}");
            if n < 2.0 {
                most.0 = most.0.max(e);
            } else {
                most.1 = most.1.max(e);
            }
        }
        println!("cos2: n = 1 {:.2}, from 2 {:.2} LSB", most.0, most.1);
        assert!(most.0 > 0.97 * Cos2::bound(1.0) && most.1 > 0.97 * Cos2::bound(500.0));
    }
}
