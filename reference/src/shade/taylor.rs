//! Phong shading by a Taylor polynomial (Bishop and Weimer 1986; Abbas 2003, eqs 5.9–5.15): N·L = p/√q and N·H likewise,
//! expanded to the second order about one point of the triangle, are quadratic functions of the place on the screen.
//!
//! The printed coefficients are those of the series with errors (T₄ of 5.12; T₅ and T₄ of 5.15). Here the series is worked
//! out by its rules, which leaves nothing to mistype: with p, q and r (= |L|² or |H|², 1 for a far light) as polynomials
//! of two weights about the point, f = p·q^(−1/2)·r^(−1/2) up to the second order; the tests hold it to the corrected
//! T₄ and to numerical derivatives.
//!
//! The point decides: the centroid is far better than a vertex (spread 20°, n = 50: 3.9 against 38 LSB), so `taylor` has
//! the one and `taylor-vertex`, for comparison, the other. Neighbours expand about different points, so shared edges do
//! not match. Values above 1 occur and are limited before the power; from a spread of 40° on they are poor. Blended
//! vectors are weighted, so expansions are perspective-correct.
//!
//! Work for one light: per triangle two series (Blake counts 273 operations, 732 with a near light); per span 18
//! multiplications a function; per pixel 2 + 2 additions, a power, 1 + 3 additions and multiplications.

use super::case::Case;
use super::corners::{Corners, Term};
use super::form::{Form, Slide};
use super::lit::{directions, weighted, Cosines};
use super::series::Series;
use glam::DVec3;

/// Where to expand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Taylor {
    /// About the centroid.
    Centroid,
    /// About vertex 0.
    Vertex,
}

impl Taylor {
    fn point(self) -> [f64; 3] {
        match self {
            Self::Centroid => [1.0 / 3.0; 3],
            Self::Vertex => [1.0, 0.0, 0.0],
        }
    }

    /// The expansion of the cosine between two blended vectors; `constant`: the second is a unit vector everywhere.
    pub(super) fn cosine(self, n: &[DVec3; 3], v: &[DVec3; 3], constant: bool) -> Form {
        let at = self.point();
        let p = Series::of(&Form::product(n, v), at);
        let q = Series::of(&Form::product(n, n), at);
        let r = if constant {
            Series::constant(1.0)
        } else {
            Series::of(&Form::product(v, v), at)
        };
        match (q * r).inverse_root() {
            Some(root) => (p * root).form(at),
            // Vectors cancel where the series should begin: dot products take its place.
            None => Form::linear([0, 1, 2].map(|i| n[i].dot(v[i]))),
        }
    }
}

impl Cosines for Taylor {
    type Shared = ();
    type Own = [Form; 2];

    fn shared(&self, _: &Corners) {}

    fn own(&self, c: &Corners, t: &Term) -> [Form; 2] {
        let n = weighted(c, c.normal);
        [t.light, t.half].map(|v| self.cosine(&n, &directions(c, t, v), t.constant))
    }

    fn cosines((): &(), own: &[Slide; 2]) -> [f64; 2] {
        own.map(|c| c.r)
    }
}

impl Taylor {
    /// Length (least, greatest) of the vector that stands for the unit normal, and its angle to it, rad, for a spread up
    /// to 90° and equal perspective weights. Measured over random triangles, with some room: worst where two normals
    /// coincide, at the third, where the series ends r = 2s/3 or s from its point: r³/2 in angle.
    #[must_use]
    pub fn deviation(self, s: f64) -> ([f64; 2], f64) {
        let (cube, fourth) = (s.powi(3), s.powi(4));
        match self {
            Self::Centroid => (
                [
                    1.0 - 0.0047 * fourth * (1.0 + 0.38 * s * s),
                    1.0 + 2.0 / 27.0 * fourth * (1.0 + 0.32 * s * s),
                ],
                4.0 / 27.0 * cube * (1.0 + 0.05 * s * s),
            ),
            Self::Vertex => ([1.0, 1.0 + 0.626 * fourth], 0.5005 * cube),
        }
    }

    fn bound(self, case: &Case) -> f64 {
        case.replaced_when_acute(|s| self.deviation(s))
    }
}

/// Bound on the error about the centroid, LSB, for a far light and viewer and a spread up to 90°, the whole range
/// otherwise. Proved but for the figures of [`Taylor::deviation`], which are measured.
#[must_use]
pub fn bound(case: &Case) -> f64 {
    Taylor::Centroid.bound(case)
}

/// Bound on the error about a vertex, LSB, likewise.
#[must_use]
pub fn vertex_bound(case: &Case) -> f64 {
    Taylor::Vertex.bound(case)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shade::probe::{deviation, normals, Shape, SPREADS};
    use rand::rngs::StdRng;
    use rand::SeedableRng;

    const BOTH: [Taylor; 2] = [Taylor::Centroid, Taylor::Vertex];

    #[test]
    fn the_vector_in_place_of_the_normal_stays_where_it_is_stated_to_be() {
        for m in BOTH {
            for s in SPREADS {
                let s = s.to_radians();
                let found = deviation(s, |n, w| {
                    let part = |a: DVec3| m.cosine(n, &[a; 3], true).at(w);
                    DVec3::new(part(DVec3::X), part(DVec3::Y), part(DVec3::Z))
                });
                let ([least, greatest], angle) = m.deviation(s);
                assert!(
                    found.shortest >= least - 1e-12,
                    "{m:?} {s}: {found:?} {least}"
                );
                assert!(found.longest <= greatest, "{m:?} {s}: {found:?} {greatest}");
                assert!(found.angle <= angle, "{m:?} {s}: {found:?} {angle}");
                assert!(s > 0.4 || found.angle > 0.8 * angle, "{m:?} {s}");
                assert!(s > 0.4 || found.longest - 1.0 > 0.8 * (greatest - 1.0));
            }
        }
    }

    fn random(k: u64) -> ([DVec3; 3], [DVec3; 3]) {
        let mut rng = StdRng::seed_from_u64(k);
        let n = normals(&mut rng, 0.1 + 0.01 * k as f64, Shape::Any);
        (n, normals(&mut rng, 0.3, Shape::Any))
    }

    fn blend(w: [f64; 3], v: &[DVec3; 3]) -> DVec3 {
        v[0] * w[0] + v[1] * w[1] + v[2] * w[2]
    }

    /// First and second derivatives by central differences, along three directions on the triangle.
    #[test]
    fn the_series_has_the_derivatives_of_the_cosine() {
        for k in 0..100 {
            let (n, h) = random(k);
            for (m, constant) in [(BOTH[0], false), (BOTH[0], true), (BOTH[1], false)] {
                let h = if constant { [h[0]; 3] } else { h };
                let form = m.cosine(&n, &h, constant);
                let truth = |w: [f64; 3]| blend(w, &n).normalize().dot(blend(w, &h).normalize());
                for d in [[-1.0, 1.0, 0.0], [-1.0, 0.0, 1.0], [1.0, 1.0, -2.0]] {
                    let at = |e: f64| [0, 1, 2].map(|i| m.point()[i] + e * d[i]);
                    let e = 1e-3;
                    let slope = |f: &dyn Fn([f64; 3]) -> f64| (f(at(e)) - f(at(-e))) / (2.0 * e);
                    let bend = |f: &dyn Fn([f64; 3]) -> f64| {
                        (f(at(e)) - 2.0 * f(at(0.0)) + f(at(-e))) / (e * e)
                    };
                    let polynomial = |w: [f64; 3]| form.at(w);
                    assert!((truth(at(0.0)) - form.at(at(0.0))).abs() < 1e-14);
                    assert!((slope(&truth) - slope(&polynomial)).abs() < 1e-4, "{m:?}");
                    assert!((bend(&truth) - bend(&polynomial)).abs() < 1e-4, "{m:?}");
                }
            }
        }
    }

    /// The corrected coefficient of XY in 5.12: (3cgh − 2cei − 2bgi − 2ahi)/(4i²√i); the printed 2ah errs.
    #[test]
    fn the_mixed_coefficient_is_the_corrected_one() {
        for k in 0..100 {
            let (n, [l, ..]) = random(k);
            // Weights λ₁ and λ₂ as X and Y about the centroid: N = AX + BY + C.
            let (va, vb, vc) = (n[1] - n[0], n[2] - n[0], blend([1.0 / 3.0; 3], &n));
            let (a, b, c) = (va.dot(l), vb.dot(l), vc.dot(l));
            let (e, g, h, i) = (
                2.0 * va.dot(vb),
                2.0 * va.dot(vc),
                2.0 * vb.dot(vc),
                vc.dot(vc),
            );
            let t4 = (3.0 * c * g * h - 2.0 * c * e * i - 2.0 * b * g * i - 2.0 * a * h * i)
                / (4.0 * i * i * i.sqrt());
            let form = Taylor::Centroid.cosine(&n, &[l; 3], true);
            let got = Series::of(&form, Taylor::Centroid.point()).second[1];
            assert!((got - t4).abs() < 1e-13, "{got} {t4}");
            let printed = t4 - (2.0 * a * h - 2.0 * a * h * i) / (4.0 * i * i * i.sqrt());
            assert!((got - printed).abs() > 1e-6 || (a * h).abs() < 1e-3);
        }
    }

    #[test]
    fn nothing_to_expand_about_gives_dot_products() {
        let n = [DVec3::X, DVec3::NEG_X, DVec3::ZERO];
        let form = Taylor::Centroid.cosine(&n, &[DVec3::X; 3], true);
        assert_eq!(form, Form::linear([1.0, -1.0, 0.0]));
    }
}
