//! Highlights as functions of the cosine ε between normal and half-way vector (or between reflected light and viewer):
//! the power εⁿ and what has been put in its place to save the power. All of them are 1 at ε = 1 and never decrease
//! with ε. Each has its own file, with its largest distance from max(0, ε)ⁿ.
//!
//! The power ends at ε = 0. The others end where their own formula does, which for n below 2 (`cos2`) or 2.7 (`blake`)
//! lies a little beyond, so that none of them has a step.

pub mod blake;
pub mod cos2;
pub mod kappa;
pub mod pow;
pub mod schlick;

use crate::scene::Highlight;

/// A highlight function with its exponent, ready to be evaluated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Curve {
    /// The power.
    Pow(pow::Pow),
    /// κ(ε − γ)^d.
    Kappa(kappa::Kappa),
    /// cos²(a·angle).
    Cos2(cos2::Cos2),
    /// Quadratic pieces in the angle.
    Blake(blake::Blake),
    /// A quotient.
    Schlick(schlick::Schlick),
}

impl Curve {
    /// The function for exponent `n`: at least 0 for the power, the degree for [`Highlight::Kappa`], 1 for the others.
    #[must_use]
    pub fn new(highlight: Highlight, n: f64) -> Self {
        match highlight {
            Highlight::Pow => Self::Pow(pow::Pow { n }),
            Highlight::Kappa { degree } => Self::Kappa(kappa::Kappa::fitted(n, degree)),
            Highlight::Cos2 => Self::Cos2(cos2::Cos2::new(n)),
            Highlight::Blake => Self::Blake(blake::Blake::refitted(n)),
            Highlight::Schlick => Self::Schlick(schlick::Schlick { n }),
        }
    }

    /// The highlight at cosine `e`, 0..=1.
    #[must_use]
    pub fn value(&self, e: f64) -> f64 {
        match self {
            Self::Pow(c) => c.value(e),
            Self::Kappa(c) => c.value(e),
            Self::Cos2(c) => c.value(e),
            Self::Blake(c) => c.value(e),
            Self::Schlick(c) => c.value(e),
        }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// Largest |f(cos θ) − max(0, cos θ)ⁿ| times 255, over all angles, densest where the highlight is.
    pub(super) fn worst(n: f64, f: impl Fn(f64) -> f64) -> f64 {
        let scale = 8.0 / n.sqrt();
        let near = (0..=4000).map(|i| f64::from(i) / 4000.0 * scale);
        let all = (0..=4000).map(|i| f64::from(i) / 4000.0 * std::f64::consts::PI);
        near.chain(all)
            .filter(|angle| *angle <= std::f64::consts::PI)
            .map(|angle| {
                let e = angle.cos();
                255.0 * (f(e) - e.max(0.0).powf(n)).abs()
            })
            .fold(0.0, f64::max)
    }

    /// Whole exponents 1 to 500, few of the large ones.
    pub(super) fn exponents() -> impl Iterator<Item = f64> {
        (1..=40)
            .chain((45..=500).step_by(13))
            .chain([500])
            .map(f64::from)
    }

    #[test]
    fn all_are_one_on_the_axis_and_never_increase_beside_it() {
        let all = [
            Highlight::Pow,
            Highlight::Kappa { degree: 2 },
            Highlight::Kappa { degree: 5 },
            Highlight::Cos2,
            Highlight::Blake,
            Highlight::Schlick,
        ];
        for highlight in all {
            let least = if let Highlight::Kappa { degree } = highlight {
                f64::from(degree)
            } else {
                1.0
            };
            for n in exponents().chain([1.3, 10_000.0]).filter(|n| *n >= least) {
                let c = Curve::new(highlight, n);
                assert!((c.value(1.0) - 1.0).abs() < 1e-12, "{highlight:?} {n}");
                assert!(
                    (c.value(1.0 + 1e-15) - 1.0).abs() < 1e-9,
                    "{highlight:?} {n}"
                );
                let mut last = 1.0 + 1e-9;
                for i in (-500..=500).rev() {
                    let v = c.value(f64::from(i) / 500.0);
                    assert!((0.0..=last).contains(&v), "{highlight:?} {n} {i}: {v}");
                    last = v + 1e-15;
                }
                assert_eq!(c.value(-1.0), 0.0);
            }
        }
    }

    /// No step where they end.
    #[test]
    fn all_end_without_a_step() {
        for highlight in [
            Highlight::Kappa { degree: 2 },
            Highlight::Cos2,
            Highlight::Blake,
        ] {
            for n in [2.0, 3.0, 5.0, 100.0] {
                let c = Curve::new(highlight, n);
                let v: Vec<f64> = (-20_000..=20_000)
                    .map(|i| c.value(f64::from(i) / 20_000.0))
                    .collect();
                let step = v.windows(2).map(|w| w[1] - w[0]).fold(0.0, f64::max);
                assert!(step < 0.02, "{highlight:?} {n}: {step}");
            }
        }
    }
}
