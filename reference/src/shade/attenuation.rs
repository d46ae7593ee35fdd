//! How light falls off with the distance d from its source: 1/(c + l·d + q·d²), "a polynomial of the second degree in
//! |B|" as used in practice (Loisel 1996, lighting models). The inverse square law is c = l = 0. With c = q = 0 diffuse
//! light needs no square root: N·(P − x)/d · 1/(l·d) = N·(P − x)/(l·d²).
//!
//! The factor is limited to 1, so a light never shines brighter than its colour: near the source the law of a point
//! would grow without bound, and in it (|B| = 0) divide by zero.

use crate::scene::Attenuation;

/// The factor at `distance` ≥ 0 (world units), 0..=1; never increases with the distance.
#[must_use]
pub fn factor(a: &Attenuation, distance: f64) -> f64 {
    (1.0 / (a.constant + (a.linear + a.quadratic * distance) * distance)).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    fn law(constant: f64, linear: f64, quadratic: f64) -> Attenuation {
        Attenuation {
            constant,
            linear,
            quadratic,
        }
    }

    #[test]
    fn the_polynomial_by_hand() {
        assert_eq!(factor(&law(1.0, 0.5, 0.25), 2.0), 1.0 / 3.0);
        assert_eq!(factor(&law(0.0, 0.0, 1.0), 4.0), 1.0 / 16.0);
        assert_eq!(factor(&Attenuation::NONE, 1e9), 1.0);
    }

    #[test]
    fn in_the_source_and_close_to_it_there_is_full_light() {
        for a in [
            law(0.0, 1.0, 0.0),
            law(0.0, 0.0, 1e-300),
            law(0.5, 0.0, 0.0),
        ] {
            assert_eq!(factor(&a, 0.0), 1.0);
            assert_eq!(factor(&a, 1e-200), 1.0);
        }
        assert_eq!(factor(&law(4.0, 0.0, 0.0), 0.0), 0.25);
        let far = factor(&law(0.0, 0.0, 1e12), 1e13);
        assert!((far / 1e-38 - 1.0).abs() < 1e-12);
    }

    /// The identity that saves the square root of linear fall-off.
    #[test]
    fn linear_fall_off_needs_no_square_root() {
        let n = DVec3::new(0.48, 0.64, 0.6);
        let b = DVec3::new(1.5, -0.3, 2.0);
        let with_root = n.dot(b.normalize()) * factor(&law(0.0, 3.0, 0.0), b.length());
        assert!((with_root - n.dot(b) / (3.0 * b.length_squared())).abs() < 1e-15);
    }
}
