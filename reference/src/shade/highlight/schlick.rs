//! Schlick's quotient (1994): f(t) = t/(n − n·t + t) for t > 0, else 0. One division in place of a power; the same slope
//! n at t = 1, but a long tail. Largest error against tⁿ: [`Schlick::BOUND`], near it from n = 75 on.

/// The quotient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Schlick {
    /// The exponent n, at least 1.
    pub n: f64,
}

impl Schlick {
    /// A bound on the error against the power in LSB, for n from 1 to 500.
    pub const BOUND: f64 = 52.1;

    /// The value at cosine `e`.
    #[must_use]
    pub fn value(&self, e: f64) -> f64 {
        if e > 0.0 {
            let t = e.min(1.0);
            t / (self.n - self.n * t + t)
        } else {
            0.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{exponents, worst};
    use super::*;

    #[test]
    fn errors_stay_within_the_bound() {
        let mut most = 0.0f64;
        for n in exponents() {
            most = most.max(worst(n, |e| Schlick { n }.value(e)));
        }
        println!("schlick: {most:.2} LSB");
        assert!(
            (0.97 * Schlick::BOUND..=Schlick::BOUND).contains(&most),
            "{most}"
        );
        let at_75 = worst(75.0, |e| Schlick { n: 75.0 }.value(e)) / 255.0;
        assert!((at_75 - 0.20).abs() < 0.005, "{at_75}");
    }

    #[test]
    fn with_exponent_one_it_is_the_cosine() {
        for t in [0.0, 0.3, 1.0] {
            assert!((Schlick { n: 1.0 }.value(t) - t).abs() < 1e-15);
        }
    }
}
