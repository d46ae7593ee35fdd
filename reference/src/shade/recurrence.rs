//! I(k) = I_a·cos(kK + φ) + I_t·sin(kK + φ) for k = 0, 1, 2 … without a sine or cosine per step: the three ways of Hast
//! 2004 (section 3.2) and Hast, Barrera and Bengtsson 2003, over any float.
//!
//! | way | per step | error after k steps of f32 |
//! |---|---|---|
//! | [`DeMoivre`], Zᵏ⁺¹ = Zᵏ·Z (the recurrence behind eq. 23 of the paper, which prints only the square) | 6 mul 3 add | ~k·2⁻²⁴ |
//! | [`Chebyshev`], Iₖ₊₁ = 2cos K·Iₖ − Iₖ₋₁ (3.38–3.45) | 1 mul 1 add | ~k²·2⁻²⁴/K: unusable in few bits |
//! | [`Difference`], d −= κ·I, I += d, κ = 4sin²(K/2) (Chebyshev's with the K kept whole) | 1 mul 2 add | ~k·2⁻²⁴ |
//!
//! De Moivre's power Z needs 4 mul 2 add and could be shared by all terms of a span whose turn is the same.

use std::ops::{Add, Mul, Sub};

/// A float.
pub trait Real: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {}

impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T>> Real for T {}

/// A value that changes from pixel to pixel.
pub trait Recurrence {
    /// What the values are.
    type Value;

    /// The current value.
    fn value(&self) -> Self::Value;

    /// Moves one pixel to the right.
    fn step(&mut self);
}

/// By powers of a complex number.
#[derive(Clone, Copy, Debug)]
pub struct DeMoivre<T> {
    /// I_a and I_t.
    pub along: (T, T),
    /// (cos, sin) of the current angle.
    pub z: (T, T),
    /// (cos K, sin K).
    pub unit: (T, T),
}

impl<T: Real> Recurrence for DeMoivre<T> {
    type Value = T;

    fn value(&self) -> T {
        self.along.0 * self.z.0 + self.along.1 * self.z.1
    }

    fn step(&mut self) {
        let ((x, y), (c, s)) = (self.z, self.unit);
        self.z = (x * c - y * s, x * s + y * c);
    }
}

/// By Chebyshev's recurrence.
#[derive(Clone, Copy, Debug)]
pub struct Chebyshev<T> {
    /// Iₖ.
    pub current: T,
    /// Iₖ₋₁.
    pub previous: T,
    /// 2·cos K.
    pub twice: T,
}

impl<T: Real> Recurrence for Chebyshev<T> {
    type Value = T;

    fn value(&self) -> T {
        self.current
    }

    fn step(&mut self) {
        let next = self.twice * self.current - self.previous;
        self.previous = self.current;
        self.current = next;
    }
}

/// By Chebyshev's recurrence on differences.
#[derive(Clone, Copy, Debug)]
pub struct Difference<T> {
    /// Iₖ.
    pub value: T,
    /// Iₖ − Iₖ₋₁.
    pub change: T,
    /// κ = 4·sin²(K/2) = 2 − 2·cos K.
    pub kappa: T,
}

impl<T: Real> Recurrence for Difference<T> {
    type Value = T;

    fn value(&self) -> T {
        self.value
    }

    fn step(&mut self) {
        self.change = self.change - self.kappa * self.value;
        self.value = self.value + self.change;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Worst error, in fractions of full scale, of each way in f32 and f64 along `k` steps over `degrees`, for a wave
    /// that begins at its crest and for one that begins on its slope.
    fn drift(degrees: f64, k: u32) -> [[f64; 2]; 3] {
        let mut worst = [[0.0f64; 2]; 3];
        for offset in [0.0, 0.9] {
            let step = degrees.to_radians() / f64::from(k);
            let truth = |i: f64| (i * step - offset).cos();
            let along = (offset.cos(), offset.sin());
            let (sin, cos) = step.sin_cos();
            let single = |v: f64| v as f32;
            let mut m64 = DeMoivre {
                along,
                z: (1.0, 0.0),
                unit: (cos, sin),
            };
            let mut m32 = DeMoivre {
                along: (along.0 as f32, along.1 as f32),
                z: (1.0, 0.0),
                unit: (cos as f32, sin as f32),
            };
            let (before, now) = (truth(-1.0), truth(0.0));
            let mut c64 = Chebyshev {
                current: now,
                previous: before,
                twice: 2.0 * cos,
            };
            let mut c32 = Chebyshev {
                current: single(now),
                previous: single(before),
                twice: single(2.0 * cos),
            };
            let mut d64 = Difference {
                value: now,
                change: now - before,
                kappa: 4.0 * (step / 2.0).sin().powi(2),
            };
            let mut d32 = Difference {
                value: single(now),
                change: single(now - before),
                kappa: single(4.0 * (step / 2.0).sin().powi(2)),
            };
            for i in 0..k {
                let want = truth(f64::from(i));
                let got = [
                    [f64::from(m32.value()), m64.value()],
                    [f64::from(c32.value()), c64.value()],
                    [f64::from(d32.value()), d64.value()],
                ];
                for (w, g) in worst.iter_mut().flatten().zip(got.iter().flatten()) {
                    *w = w.max((g - want).abs());
                }
                m32.step();
                m64.step();
                c32.step();
                c64.step();
                d32.step();
                d64.step();
            }
        }
        worst
    }

    /// The rows on drift of the notes: Chebyshev's error in f32 grows with the square of the steps (6e-4 of full scale
    /// at 20°/256 px, 8e-3 at 20°/1024, 0.14 at 45°/4096), that of the other two does not.
    #[test]
    fn in_single_precision_only_chebyshev_drifts() {
        for (degrees, k, cheb) in [(20.0, 256, 6e-4), (20.0, 1024, 8e-3), (45.0, 4096, 1.4e-1)] {
            let [[m, _], [c, _], [d, _]] = drift(degrees, k);
            println!(
                "{degrees} deg, {k} px: De Moivre {m:.1e}, Chebyshev {c:.1e}, difference {d:.1e}"
            );
            assert!(m < 1.5e-4, "De Moivre {m}");
            assert!(d < 2e-5, "difference {d}");
            // Rounding of one cosine decides: within a factor of six of the printed figure, never harmless.
            assert!(
                c > cheb / 6.0 && c < cheb * 6.0,
                "Chebyshev {c} against {cheb}"
            );
            assert!(c > 20.0 * d);
        }
        for degrees in [5.0, 20.0, 45.0, 90.0] {
            assert!(drift(degrees, 1024)[2][0] < 3e-6, "{degrees}");
        }
    }

    /// In f64 all three hold over the longest span, so the methods of this crate may use any of them.
    #[test]
    fn in_double_precision_none_drifts() {
        for degrees in [1e-3, 1.0, 20.0, 90.0] {
            let [[_, m], [_, c], [_, d]] = drift(degrees, 2048);
            assert!(m < 1e-12 && d < 1e-12, "{degrees}: {m} {d}");
            assert!(c < 1e-9, "{degrees}: {c}");
        }
    }
}
