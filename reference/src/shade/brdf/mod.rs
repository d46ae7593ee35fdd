//! Reflection models: what part of the light from one direction a surface sends to the viewer.
//!
//! With unit vectors N (normal), L (to the light), V (to the viewer), H = (L + V)/|L + V| and R = 2N(N·L) − L:
//!
//! lambert        kd·max(0, N·L)
//! phong          kd·max(0, N·L) + ks·f(R·V) where N·L > 0        (Phong 1975)
//! blinn          kd·max(0, N·L) + ks·f(N·H)                      (Blinn 1977)
//! cook-torrance  kd·max(0, N·L) + the term of [`cook_torrance`]  (Cook and Torrance 1982)
//!
//! f is the power or one of the functions of [`super::highlight`]. R·V is taken only where N·L > 0 (the reflection of
//! light from behind is no highlight); Blinn's highlight is not switched off there. Where L = −V there is no half-way
//! vector and no highlight.

pub mod cook_torrance;

use super::highlight::Curve;
use crate::scene::{Brdf, Material};
use glam::DVec3;

/// A material ready to reflect.
#[derive(Clone, Copy, Debug)]
pub struct Reflectance {
    brdf: Brdf,
    diffuse: DVec3,
    specular: DVec3,
    curve: Curve,
}

/// Sums of two unit vectors with a squared length up to this have cancelled.
const OPPOSITE: f64 = 1e-24;

/// The unit vector half-way between two unit vectors; none where they are opposite.
#[must_use]
pub fn half_way(l: DVec3, v: DVec3) -> Option<DVec3> {
    let sum = l + v;
    (sum.length_squared() > OPPOSITE).then(|| sum.normalize())
}

impl Reflectance {
    /// The reflection of a material.
    #[must_use]
    pub fn new(m: &Material) -> Self {
        Self {
            brdf: m.brdf,
            diffuse: m.diffuse,
            specular: m.specular,
            curve: Curve::new(m.highlight, m.shininess),
        }
    }

    /// The highlight function of Phong's and Blinn's model.
    #[must_use]
    pub fn curve(&self) -> &Curve {
        &self.curve
    }

    /// The part of white light from `l` that goes to `v`, RGB: unit vectors, or zero where there is no direction. `half` is
    /// asked for their [`half_way`] vector where it is needed.
    #[must_use]
    pub fn reflect(
        &self,
        n: DVec3,
        l: DVec3,
        v: DVec3,
        half: impl FnOnce() -> Option<DVec3>,
    ) -> DVec3 {
        let facing = n.dot(l);
        let diffuse = self.diffuse * facing.max(0.0);
        if self.specular == DVec3::ZERO {
            return diffuse;
        }
        let specular = match self.brdf {
            Brdf::Lambert => None,
            Brdf::Phong => (facing > 0.0).then(|| {
                let reflected = n * (2.0 * facing) - l;
                self.specular * self.curve.value(reflected.dot(v))
            }),
            Brdf::Blinn => half().map(|h| self.specular * self.curve.value(n.dot(h))),
            Brdf::CookTorrance { roughness } => {
                half().map(|h| cook_torrance::specular(self.specular, roughness, n, l, v, h))
            }
        };
        diffuse + specular.unwrap_or(DVec3::ZERO)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Highlight;

    fn shiny(brdf: Brdf, shininess: f64) -> Reflectance {
        Reflectance::new(&Material {
            brdf,
            diffuse: DVec3::splat(0.25),
            specular: DVec3::splat(0.5),
            shininess,
            ..Material::default()
        })
    }

    fn reflect(r: &Reflectance, n: DVec3, l: DVec3, v: DVec3) -> DVec3 {
        r.reflect(n, l, v, || half_way(l, v))
    }

    fn at(degrees: f64) -> DVec3 {
        let a = degrees.to_radians();
        DVec3::new(a.sin(), 0.0, a.cos())
    }

    #[test]
    fn phong_by_hand() {
        // Light 30° left, viewer 50° right, normal up: the reflection leaves 20° beside the viewer.
        let c = reflect(&shiny(Brdf::Phong, 7.0), DVec3::Z, at(-30.0), at(50.0));
        let cos = |d: f64| d.to_radians().cos();
        let want = 0.25 * cos(30.0) + 0.5 * cos(20.0).powi(7);
        assert!((c - DVec3::splat(want)).length() < 1e-15);
    }

    /// The angle of R to V is twice that of N to H when all are in one plane.
    #[test]
    fn blinn_is_phong_at_half_the_angle() {
        let (n, l, v) = (DVec3::Z, at(-30.0), at(50.0));
        let c = reflect(&shiny(Brdf::Blinn, 7.0), n, l, v);
        let cos = |d: f64| d.to_radians().cos();
        let want = 0.25 * cos(30.0) + 0.5 * cos(10.0).powi(7);
        assert!((c - DVec3::splat(want)).length() < 1e-15);
    }

    #[test]
    fn light_from_behind_has_no_reflection_even_with_an_even_exponent() {
        for n in [1.0, 2.0] {
            let c = reflect(&shiny(Brdf::Phong, n), DVec3::Z, at(100.0), at(-80.0));
            assert_eq!(c, DVec3::ZERO);
            let c = reflect(&shiny(Brdf::Phong, n), DVec3::Z, at(80.0), at(80.0));
            assert!(c.x < 0.25 * 0.174, "R is 160° from V");
        }
    }

    #[test]
    fn lambert_shows_no_highlight_and_other_curves_are_used() {
        let matt = Material {
            brdf: Brdf::Lambert,
            ..Material::default()
        };
        let c = reflect(&Reflectance::new(&matt), DVec3::Z, DVec3::Z, DVec3::Z);
        assert_eq!(c, DVec3::splat(0.8));
        let quick = Material {
            diffuse: DVec3::ZERO,
            specular: DVec3::ONE,
            shininess: 3.0,
            highlight: Highlight::Schlick,
            ..Material::default()
        };
        let c = reflect(&Reflectance::new(&quick), at(60.0), DVec3::Z, DVec3::Z);
        assert!((c.x - 0.5 / (3.0 - 1.5 + 0.5)).abs() < 1e-15);
    }

    #[test]
    fn whatever_the_vectors_nothing_is_nan() {
        let directions = [
            DVec3::ZERO,
            DVec3::Z,
            DVec3::NEG_Z,
            DVec3::X,
            at(90.0 - 1e-9),
            at(90.0 + 1e-9),
            at(179.999_999_9),
        ];
        for brdf in [
            Brdf::Lambert,
            Brdf::Phong,
            Brdf::Blinn,
            Brdf::CookTorrance { roughness: 0.01 },
            Brdf::CookTorrance { roughness: 1.0 },
        ] {
            let r = shiny(brdf, 1e4);
            for n in directions {
                for l in directions {
                    for v in directions {
                        let c = reflect(&r, n, l, v);
                        assert!(
                            c.is_finite() && c.min_element() >= 0.0,
                            "{brdf:?} {n} {l} {v}"
                        );
                    }
                }
            }
        }
    }
}
