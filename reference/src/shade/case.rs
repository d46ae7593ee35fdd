//! What a bound on a method's error is stated for, and the inequalities that such bounds are made of.
//!
//! The truth is I = ambient + Σ kd·max(0, N·L) + ks·max(0, N·H)ⁿ with N, L and H blended linearly between the vertices
//! and normalised at every pixel (Phong 1975; Abbas 2003, eq. 5.2). Let nᵢ be the unit vertex normals, c the least of
//! their dot products, and b = Σ λᵢnᵢ the blend at a pixel. What the bounds use:
//!
//! - **Length.** |b|² = 1 − 2·Σ λᵢλⱼ(1 − nᵢ·nⱼ) ≥ 1 − (2/3)(1 − c), since Σ λᵢλⱼ ≤ 1/3 over the three pairs. Hence
//!   [`shortest`].
//! - **Angle.** With dᵢ the angle between b and nᵢ, Σ λᵢ·cos dᵢ = |b|, and as the cosine is concave up to 90°,
//!   Σ λᵢ·dᵢ ≤ arccos |b|. Hence [`mean_angle`].
//! - **Slope.** d(cosⁿ θ)/dθ is largest where sin² θ = 1/n. Hence [`slope`].
//! - **Replacement.** A method whose cosines are M·L and M·H for some vector M(λ) in the place of N, limited to 0..=1,
//!   errs by no more than M does in direction and in length: [`Case::replaced`].

/// Rounding of all methods in f64 together, LSB; see [`super::differences`] for the largest part of it.
pub const ROUNDING: f64 = 1e-6;

/// A class of triangles, lights and materials (Lambert's or Blinn's model). Perspective weights are equal, except for
/// methods that say they are perspective-correct.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// Largest angle between two vertex normals, rad, 0 to π.
    pub spread: f64,
    /// Largest angle between two L, or between two H, of one light at the vertices, rad; 0 when light and viewer are
    /// infinitely far. Where it is not 0, the truth blends L and H as it blends N.
    pub turn: f64,
    /// The exponent n of the highlight, at least 0.
    pub shininess: f64,
    /// kd, fraction of full scale: the largest channel, summed over the lights.
    pub diffuse: f64,
    /// ks, likewise.
    pub specular: f64,
}

/// The least length of a blend of three unit vectors that are pairwise at most `spread` rad apart; 0 from 120° on.
#[must_use]
pub fn shortest(spread: f64) -> f64 {
    ((1.0 + 2.0 * spread.cos()) / 3.0).max(0.0).sqrt()
}

/// The largest mean angle Σ λᵢdᵢ between a blend and the vectors it is made of, rad; proved up to a spread of 90°.
#[must_use]
pub fn mean_angle(spread: f64) -> f64 {
    shortest(spread).min(1.0).acos()
}

/// The largest slope of cosⁿ, per rad: √n·(1 − 1/n)^((n − 1)/2) for n > 1; not finite below 1.
#[must_use]
pub fn slope(n: f64) -> f64 {
    if n < 1.0 {
        f64::INFINITY
    } else {
        n.sqrt() * (1.0 - 1.0 / n).powf((n - 1.0) / 2.0)
    }
}

/// The largest change of xⁿ, x in 0..=1, when x changes by at most `e`.
fn power_change(n: f64, e: f64) -> f64 {
    let e = e.clamp(0.0, 1.0);
    // Convex from 1 on: largest at x = 1. Concave below: largest at x = 0.
    if n >= 1.0 {
        1.0 - (1.0 - e).powf(n)
    } else if e > 0.0 {
        e.powf(n)
    } else {
        0.0
    }
}

impl Case {
    /// Whether light and viewer are infinitely far and no two vertex normals are more than 90° apart.
    #[must_use]
    pub fn is_far_and_acute(&self) -> bool {
        self.turn == 0.0 && self.is_acute()
    }

    /// Whether no two vectors of a kind are more than 90° apart, to rounding.
    #[must_use]
    pub fn is_acute(&self) -> bool {
        self.spread.max(self.turn) <= std::f64::consts::FRAC_PI_2 + 1e-9
    }

    /// Bounds from errors of the diffuse and of the specular term, as fractions of kd and ks.
    #[must_use]
    pub fn terms(&self, diffuse: f64, specular: f64) -> f64 {
        // `0 · ∞` must be 0: no highlight, no error of it.
        let part = |k: f64, e: f64| if k > 0.0 { k * e } else { 0.0 };
        255.0 * (part(self.diffuse, diffuse) + part(self.specular, specular)) + ROUNDING
    }

    /// What no method exceeds whose cosines are limited to 0..=1: both it and the truth lie between the ambient colour
    /// and kd + ks above it. The bound of a method that promises nothing better.
    #[must_use]
    pub fn whole(&self) -> f64 {
        self.terms(1.0, 1.0)
    }

    /// The part of [`Case::direction`] that comes from the highlight, as a fraction of ks.
    #[must_use]
    pub fn direction_of_highlight(&self, angle: f64) -> f64 {
        if angle > 0.0 {
            (angle * slope(self.shininess)).min(1.0)
        } else {
            0.0
        }
    }

    /// Bound for directions that are off by up to `angle` rad: cos and cosⁿ of angles that differ by that much.
    #[must_use]
    pub fn direction(&self, angle: f64) -> f64 {
        self.replaced([1.0; 2], angle)
    }

    /// Bound for cosines that are off by up to `e`.
    #[must_use]
    pub fn cosine(&self, e: f64) -> f64 {
        self.terms(e.min(1.0), power_change(self.shininess, e))
    }

    /// Bound for a vector of a length from `shortest` to `longest`, up to `angle` rad beside the unit normal, in its
    /// place: |M·L − N·L| splits into the change of length, which is largest at N = L, and the change of direction.
    #[must_use]
    pub fn replaced(&self, [shortest, longest]: [f64; 2], angle: f64) -> f64 {
        let n = self.shininess;
        // Beyond 1 the cosine is limited, so a vector that is too long errs most where N·L is one over its length.
        let least = shortest.clamp(0.0, 1.0).min(1.0 / longest.max(1.0));
        let (length, power) = (1.0 - least, 1.0 - least.powf(n));
        let turned = self.direction_of_highlight(angle);
        let turn = angle.clamp(0.0, std::f64::consts::FRAC_PI_2).sin();
        self.terms((length + turn).min(1.0), (power + turned).min(1.0))
    }

    /// [`Case::replaced`] by a vector whose length (least, greatest) and angle to the normal follow from the spread, for
    /// a far light and viewer and a spread up to 90°; the whole range otherwise.
    #[must_use]
    pub fn replaced_when_acute(&self, deviation: impl FnOnce(f64) -> ([f64; 2], f64)) -> f64 {
        if !self.is_far_and_acute() {
            return self.whole();
        }
        let (length, angle) = deviation(self.spread);
        self.replaced(length, angle)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CASE: Case = Case {
        spread: 0.5,
        turn: 0.0,
        shininess: 20.0,
        diffuse: 0.4,
        specular: 0.5,
    };

    #[test]
    fn the_centre_of_an_equilateral_triangle_is_the_shortest_blend() {
        // Vertices on the axes: 90° apart, the blend of equal parts has length 1/√3.
        assert!((shortest(std::f64::consts::FRAC_PI_2) - 1.0 / 3f64.sqrt()).abs() < 1e-15);
        assert_eq!(shortest(0.0), 1.0);
        assert_eq!(shortest(3.0), 0.0);
    }

    #[test]
    fn the_slope_is_the_largest_difference_quotient() {
        for n in [1.0, 1.5, 2.0, 5.0, 20.0, 100.0, 500.0] {
            let h = 1e-4;
            let steepest = (0..15_707)
                .map(|i| {
                    let a = f64::from(i) * h;
                    (a.cos().powf(n) - (a + h).cos().max(0.0).powf(n)) / h
                })
                .fold(0.0, f64::max);
            assert!(
                steepest <= slope(n) * (1.0 + 1e-9) && steepest > slope(n) * 0.999,
                "{n}"
            );
        }
        assert_eq!(slope(0.5), f64::INFINITY);
    }

    #[test]
    fn no_deviation_no_error_and_never_more_than_the_whole() {
        for n in [0.0, 0.5, 1.0, 3.0, 500.0] {
            let case = Case {
                shininess: n,
                ..CASE
            };
            assert!(case.direction(0.0) <= ROUNDING);
            assert!(case.cosine(0.0) <= ROUNDING);
            assert!(case.direction(7.0) <= case.whole());
            assert!(case.cosine(7.0) <= case.whole());
            assert!(case.replaced([0.0, 9.0], 0.0) <= case.whole());
        }
        assert!((CASE.whole() - 229.5).abs() < 1e-5);
        let matt = Case {
            specular: 0.0,
            shininess: 0.5,
            ..CASE
        };
        assert!((matt.direction(0.1) - 102.0 * 0.1f64.sin()).abs() < 1e-5);
    }

    #[test]
    fn replaced_vectors_stay_within() {
        // Every angle between normal and light, every sign of the deviation.
        for n in [1.0, 4.0, 30.0] {
            let case = Case {
                shininess: n,
                ..CASE
            };
            for (length, angle) in [(0.9f64, 0.0), (1.0, 0.1), (0.8, 0.2), (1.05, 0.05)] {
                let bound = case.replaced([length.min(1.0), length.max(1.0)], angle);
                for i in -314..314 {
                    let a = f64::from(i) * 0.01;
                    let value = |c: f64| {
                        let c = c.clamp(0.0, 1.0);
                        255.0 * (0.4 * c + 0.5 * c.powf(n))
                    };
                    let e = value(length * (a + angle).cos()) - value(a.cos());
                    assert!(e.abs() <= bound, "{n} {length} {angle} {a}");
                }
            }
        }
    }
}
