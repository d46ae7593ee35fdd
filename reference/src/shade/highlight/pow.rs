//! The power: f(ε) = εⁿ for ε > 0, else 0 (Phong 1975; Blinn 1977). The definition that the others are judged by.

/// The power function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pow {
    /// The exponent n, at least 0.
    pub n: f64,
}

impl Pow {
    /// The value at cosine `e`.
    #[must_use]
    pub fn value(&self, e: f64) -> f64 {
        if e > 0.0 {
            e.powf(self.n)
        } else {
            0.0
        }
    }
}

/// The cosine γ(n) = (1/510)^(1/n) at which a highlight of full scale is half an LSB (Hast 2004, 3.5.6, made exact):
/// below, a highlight that is rounded by itself is black; one that is added to other light before rounding changes it
/// by one LSB at most.
#[must_use]
pub fn threshold_of_visibility(n: f64) -> f64 {
    (1.0f64 / 510.0).powf(1.0 / n)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_an_lsb_is_left_at_the_threshold() {
        let table = [
            (5.0, 0.2874),
            (20.0, 0.7322),
            (50.0, 0.8828),
            (75.0, 0.9202),
            (100.0, 0.9396),
            (200.0, 0.9693),
            (485.0, 0.9872),
        ];
        for (n, want) in table {
            let g = threshold_of_visibility(n);
            assert!((g - want).abs() <= 5.001e-5, "{n}: {g}");
            assert!((Pow { n }.value(g) * 255.0 - 0.5).abs() < 1e-12);
        }
    }

    #[test]
    fn behind_there_is_nothing_whatever_the_exponent() {
        for n in [0.0, 1.0, 2.0, 3.5] {
            assert_eq!(Pow { n }.value(-0.5), 0.0);
            assert_eq!(Pow { n }.value(0.0), 0.0);
        }
    }
}
