//! A shifted low power: f(ε) = κ(ε − γ)^d with κ = 1/(1 − γ)^d for ε > γ, else 0 (Hast 2004, 3.276). One subtraction and
//! d multiplications; the degree d is 2 to 6. The test ε > γ cannot be left out: for even d the formula itself is
//! positive below γ, and grows (the text says it is negative, which holds for odd d only).
//!
//! For the γ that goes with an exponent n there are two rules. *Fitted*: the γ of least largest error against εⁿ. With
//! growing γ the excess of f over the power falls and its deficit grows, so the two are equal at the best γ, and
//! bisection finds it. *Half power*: f = 1/2 where εⁿ = 1/2, γ = (x − h)/(1 − h), x = 2^(−1/n), h = 2^(−1/d). Scenes use
//! the fitted one. Both need n ≥ d; then γ ≥ 0.
//!
//! Largest errors for n from d to 500: [`Kappa::BOUND`] and, at half power, [`Kappa::HALF_POWER_BOUND`].

/// A shifted low power.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kappa {
    /// The cosine γ where the highlight ends.
    pub gamma: f64,
    /// The degree d.
    pub degree: u8,
}

impl Kappa {
    /// Bounds on the error of [`Kappa::fitted`] for d = 2 to 6 and n ≥ d, LSB.
    pub const BOUND: [f64; 5] = [17.9, 11.5, 8.5, 6.7, 5.5];
    /// Bounds on the error of [`Kappa::half_power`] for d = 2 to 6 and n ≥ d, LSB.
    pub const HALF_POWER_BOUND: [f64; 5] = [28.4, 17.8, 12.9, 10.1, 8.3];

    /// The function of least error against εⁿ, n ≥ d.
    #[must_use]
    pub fn fitted(n: f64, degree: u8) -> Self {
        // Excess and deficit at γ are taken at the cosines where the power is 0, 1/N, …, 1.
        const STEPS: u32 = 256;
        let samples: Vec<(f64, f64)> = (0..=STEPS)
            .map(|i| f64::from(i) / f64::from(STEPS))
            .map(|power| (power.powf(1.0 / n), power))
            .collect();
        let excess_prevails = |gamma: f64| {
            let f = Self { gamma, degree };
            let (mut excess, mut deficit) = (0.0f64, 0.0f64);
            for (e, power) in &samples {
                let d = f.value(*e) - power;
                (excess, deficit) = (excess.max(d), deficit.max(-d));
            }
            excess > deficit
        };
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..48 {
            let middle = 0.5 * (low + high);
            if excess_prevails(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        Self { gamma: low, degree }
    }

    /// The function that equals 1/2 where εⁿ does.
    #[must_use]
    pub fn half_power(n: f64, degree: u8) -> Self {
        let (x, h) = (0.5f64.powf(1.0 / n), 0.5f64.powf(1.0 / f64::from(degree)));
        Self {
            gamma: (x - h) / (1.0 - h),
            degree,
        }
    }

    /// The value at cosine `e`.
    #[must_use]
    pub fn value(&self, e: f64) -> f64 {
        if e > self.gamma {
            ((e - self.gamma) / (1.0 - self.gamma)).powi(i32::from(self.degree))
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
    fn errors_stay_within_their_bounds() {
        for degree in 2..=6u8 {
            let [mut fitted, mut half] = [0.0f64; 2];
            for n in exponents().filter(|n| *n >= f64::from(degree)) {
                let k = Kappa::fitted(n, degree);
                fitted = fitted.max(worst(n, |e| k.value(e)));
                let k = Kappa::half_power(n, degree);
                half = half.max(worst(n, |e| k.value(e)));
            }
            println!("d = {degree}: fitted {fitted:.2}, half power {half:.2} LSB");
            let i = usize::from(degree) - 2;
            for (error, bound) in [
                (fitted, Kappa::BOUND[i]),
                (half, Kappa::HALF_POWER_BOUND[i]),
            ] {
                assert!(error <= bound && error > 0.98 * bound, "{degree}: {error}");
            }
        }
    }

    /// The best roots for n = 75 and errors nearly independent of n, as in the literature study.
    #[test]
    fn the_best_roots() {
        for (degree, gamma) in [(2, 0.9628), (3, 0.9503), (4, 0.9375), (6, 0.9113)] {
            let k = Kappa::fitted(75.0, degree);
            assert!((k.gamma - gamma).abs() < 3e-4, "{degree}: {}", k.gamma);
        }
        for (degree, error) in [(2, 0.07), (3, 0.044), (4, 0.032), (6, 0.020)] {
            for n in [75.0, 300.0] {
                let k = Kappa::fitted(n, degree);
                let e = worst(n, |e| k.value(e)) / 255.0;
                assert!((e / error - 1.0).abs() < 0.07, "{degree} {n}: {e}");
            }
        }
    }

    #[test]
    fn no_other_root_is_better() {
        for (n, degree) in [(3.0, 2), (9.0, 6), (20.0, 2), (75.0, 4), (500.0, 3)] {
            let best = Kappa::fitted(n, degree);
            let error = |gamma: f64| worst(n, |e| Kappa { gamma, degree }.value(e));
            let least = error(best.gamma);
            for step in [-0.02, 0.02] {
                let other = best.gamma + step * (1.0 - best.gamma);
                assert!(error(other) > least, "{n} {degree} {step}");
            }
        }
    }

    /// With γ = 0.92 and n = 75 the thesis chose a root, not a fit.
    #[test]
    fn errors_at_the_root_of_the_thesis() {
        for (degree, want) in [(2, 0.34), (3, 0.21), (4, 0.12), (5, 0.043), (6, 0.044)] {
            let k = Kappa {
                gamma: 0.92,
                degree,
            };
            let error = worst(75.0, |e| k.value(e)) / 255.0;
            assert!((error - want).abs() < 0.006, "{degree}: {error}");
        }
    }

    /// The text has the sign wrong for even degrees: without the test the highlight comes back behind γ.
    #[test]
    fn below_the_root_the_bare_formula_is_positive_for_even_degrees() {
        let bare = |e: f64, d: i32| ((e - 0.92) / (1.0 - 0.92)).powi(d);
        assert!((bare(0.80, 2) - 2.25).abs() < 1e-9);
        assert!(bare(0.80, 3) < 0.0);
        for degree in 2..=6 {
            let k = Kappa {
                gamma: 0.92,
                degree,
            };
            for e in [0.92, 0.80, 0.0, -1.0] {
                assert_eq!(k.value(e), 0.0);
            }
        }
    }
}
