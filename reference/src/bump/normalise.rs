//! The normal of a bump without a square root (Hast 2004 §3.4, paper IX). The bump's own normal is (−F_u, −F_v, 1), with
//! g² = F_u² + F_v²:
//!
//! - exact: divided by √(g² + 1);
//! - reflection: t = 4/(g² + 4), (−F_u·t, −F_v·t, 2t − 1). Of unit length, turned too far: the angle is 2·atan(g/2) in
//!   place of atan g, an error below g³/4 (3.269–3.271);
//! - Newton: the first step towards the reciprocal square root, 1 − g²/2, times the vector. True in direction, too short
//!   by at most 3g⁴/8. From g² = 2 on it would turn the normal around, so g² is limited to 2, where nothing is left of it.
//!
//! The thesis stores gradients with their sign turned and adds where this subtracts.

use glam::DVec3;
use num_traits::Float;

fn two<T: Float>() -> T {
    T::one() + T::one()
}

/// Factors of (−F_u, −F_v) and of 1, in that order.
fn exact_factors<T: Float>(g2: T) -> [T; 2] {
    let s = (g2 + T::one()).sqrt().recip();
    [s, s]
}

fn reflection_factors<T: Float>(g2: T) -> [T; 2] {
    let four = two::<T>() + two();
    let t = four / (g2 + four);
    [t, t + t - T::one()]
}

fn newton_factors<T: Float>(g2: T) -> [T; 2] {
    let k = T::one() - g2.min(two()) / two();
    [k, k]
}

fn vector<T: Float>(fu: T, fv: T, [across, along]: [T; 2]) -> [T; 3] {
    [-fu * across, -fv * across, along]
}

/// The unit normal of the gradient (F_u, F_v): one square root and one division.
#[must_use]
pub fn exact<T: Float>(fu: T, fv: T) -> [T; 3] {
    vector(fu, fv, exact_factors(fu * fu + fv * fv))
}

/// A vector of unit length near the normal: one division.
#[must_use]
pub fn reflection<T: Float>(fu: T, fv: T) -> [T; 3] {
    vector(fu, fv, reflection_factors(fu * fu + fv * fv))
}

/// A vector along the normal, at most of unit length: neither.
#[must_use]
pub fn newton<T: Float>(fu: T, fv: T) -> [T; 3] {
    vector(fu, fv, newton_factors(fu * fu + fv * fv))
}

/// How the normal of a bump is brought to unit length.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Normalise {
    /// By the square root.
    #[default]
    Exact,
    /// By one division.
    Reflection,
    /// By multiplications alone.
    Newton,
}

impl Normalise {
    /// `normal` − `gradient`, normalised in this way; `normal` is a unit vector and `gradient` at right angles to it.
    #[must_use]
    pub fn bend(self, normal: DVec3, gradient: DVec3) -> DVec3 {
        let g2 = gradient.length_squared();
        let [across, along] = match self {
            Self::Exact => exact_factors(g2),
            Self::Reflection => reflection_factors(g2),
            Self::Newton => newton_factors(g2),
        };
        normal * along - gradient * across
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn of(v: [f64; 3]) -> DVec3 {
        DVec3::from_array(v)
    }

    /// Angle to the true normal in degrees, from its definition.
    fn angle(v: DVec3, g: f64) -> f64 {
        (v.x.hypot(v.y).atan2(v.z) - g.atan()).abs().to_degrees()
    }

    /// The table of the literature study, within its rounding.
    #[test]
    fn errors_by_gradient() {
        for (g, degrees, angle_rounding, length, length_rounding) in [
            (0.1, 0.014, 0.0006, 0.99996, 0.000_006),
            (0.25, 0.21, 0.006, 0.9986, 0.00006),
            (0.5, 1.5, 0.06, 0.978, 0.0006),
            (0.75, 4.2, 0.06, 0.898, 0.0006),
            (1.0, 8.1, 0.06, 0.707, 0.0006),
            (2f64.sqrt(), 16.0, 0.6, 0.0, 1e-12),
        ] {
            for turn in [0.0, 1.0, 2.5, -2.0f64] {
                let (fu, fv) = (g * turn.cos(), g * turn.sin());
                let r = of(reflection(fu, fv));
                assert!(
                    (angle(r, g) - degrees).abs() < angle_rounding,
                    "{g}: {}",
                    angle(r, g)
                );
                let n = of(newton(fu, fv)).length();
                assert!((n - length).abs() < length_rounding, "{g}: {n}");
            }
        }
    }

    proptest! {
        #[test]
        fn bounds_hold(fu in -40.0..40.0f64, fv in -40.0..40.0f64, small in 0.0..1.0f64) {
            for s in [1.0, small, small * 0.01] {
                let (fu, fv) = (fu * s, fv * s);
                let g = fu.hypot(fv);
                let (e, r, n) = (of(exact(fu, fv)), of(reflection(fu, fv)), of(newton(fu, fv)));
                // The definition.
                let want = DVec3::new(-fu, -fv, 1.0) / (1.0 + g * g).sqrt();
                prop_assert!(e.distance(want) < 1e-15);
                prop_assert!((r.length() - 1.0).abs() < 1e-14);
                prop_assert!(angle(r, g).to_radians() <= g.powi(3) / 4.0 + 1e-12);
                prop_assert!((n.length() - n.dot(want)).abs() < 1e-13 && n.z >= 0.0);
                prop_assert!(n.length() <= 1.0 + 1e-15 && 1.0 - n.length() <= 3.0 / 8.0 * g.powi(4) + 1e-14);
                // The same in single precision.
                let single = |f: fn(f32, f32) -> [f32; 3], d: DVec3| {
                    of(f(fu as f32, fv as f32).map(f64::from)).distance(d)
                };
                prop_assert!(single(exact, e) < 4e-7);
                prop_assert!(single(reflection, r) < 4e-7);
                prop_assert!(single(newton, n) < 4e-7 * (1.0 + g));
            }
        }

        #[test]
        fn in_space_as_in_its_own_frame(a in 0.0..3.1f64, b in 0.0..6.2f64, fu in -3.0..3.0f64, fv in -3.0..3.0f64) {
            let n = DVec3::new(a.sin() * b.cos(), a.sin() * b.sin(), a.cos());
            let (t, s) = n.any_orthonormal_pair();
            let g = t * fu + s * fv;
            for (way, f) in [
                (Normalise::Exact, exact::<f64> as fn(f64, f64) -> [f64; 3]),
                (Normalise::Reflection, reflection),
                (Normalise::Newton, newton),
            ] {
                let [x, y, z] = f(fu, fv);
                prop_assert!(way.bend(n, g).distance(t * x + s * y + n * z) < 1e-13);
            }
        }
    }
}
