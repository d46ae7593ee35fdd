//! X-shading: N·L and N·H are quadratic functions through values at the vertices and at mid-edges, found without a root
//! or a division (Hast 2004, eqs 3.254–3.260):
//!
//!   n₁₂ = (5 − c)/8·(n₁ + n₂),  φ = Σ λᵢIᵢ + Σ kᵢⱼλᵢλⱼ,  kᵢⱼ = (Iᵢ + Iⱼ)(1 − cᵢⱼ)/2,  c = nᵢ·nⱼ.
//!
//! (The form in weights is the same polynomial in any order of the vertices.) The mid-edge vector is one Newton step
//! towards unit length, x(3 − x²)/2 with x = cos(s/2), short by 3s⁴/128. `x-shading-cached` has (nᵢ + nⱼ)/√(2 + 2c) in its
//! place, the normalised vector: kᵢⱼ = (Iᵢ + Iⱼ)(4/√(2 + 2c) − 2), the full six-knot quadratic at the same cost once the
//! factors, which belong to mesh edges, are kept with the mesh (a prepared scene has no edges: here they are worked out
//! per triangle). Near opposite normals that factor has no limit; it is
//! taken at c ≥ −1 + 1e-12, where the sum of the intensities is as small.
//!
//! Near lights: mid-edge values are products of mid-edge N and mid-edge L, each by its own factor.
//!
//! Work for one light: per triangle 6 dot products and 3 multiplications, 9 additions a function; per span 18
//! multiplications a function (3 additions in the paper, which steps along edges); per pixel 2 additions a function and
//! a power (section 12 of the study on Hast).

use super::case::Case;
use super::corners::{Corners, Term};
use super::form::{Form, Slide};
use super::lit::Cosines;
use super::quadratic::EDGES;
use glam::DVec3;

/// The two ways to a mid-edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum XShading {
    /// (5 − c)/8.
    Newton,
    /// 1/√(2 + 2c), kept per mesh edge.
    Cached,
}

impl XShading {
    /// What the sum of two unit vectors is multiplied with; `c` is the cosine of the angle between them.
    #[must_use]
    pub fn factor(self, c: f64) -> f64 {
        match self {
            Self::Newton => (5.0 - c) / 8.0,
            Self::Cached => 1.0 / (2.0 + 2.0 * c.max(-1.0 + 1e-12)).sqrt(),
        }
    }

    /// N·V for the three normals and a light or half-way vector at the vertices.
    pub(super) fn form(self, normal: &[DVec3; 3], v: &[DVec3; 3], constant: bool) -> Form {
        let middle = EDGES.map(|(i, j)| {
            let n = (normal[i] + normal[j]) * self.factor(normal[i].dot(normal[j]));
            let half = if constant {
                v[i]
            } else {
                (v[i] + v[j]) * self.factor(v[i].dot(v[j]))
            };
            n.dot(half)
        });
        Form::knots([0, 1, 2].map(|i| normal[i].dot(v[i])), middle)
    }
}

impl Cosines for XShading {
    type Shared = ();
    type Own = [Form; 2];

    fn shared(&self, _: &Corners) {}

    fn own(&self, c: &Corners, t: &Term) -> [Form; 2] {
        [t.light, t.half].map(|v| self.form(&c.normal, &v, t.constant))
    }

    fn cosines((): &(), own: &[Slide; 2]) -> [f64; 2] {
        own.map(|c| c.r)
    }
}

impl XShading {
    /// Length (least, greatest) of the vector that stands for the unit normal, and its angle to it, rad, for a spread up
    /// to 90°. Measured over random triangles, with some room: the least length, in the middle of an equilateral
    /// triangle, is 1 − s⁴/24 or 1 − s⁴/96 to the fourth order; no vector was longer than 1.
    #[must_use]
    pub fn deviation(self, s: f64) -> ([f64; 2], f64) {
        let short = match self {
            Self::Newton => s.powi(4) / 24.0,
            Self::Cached => s.powi(4) / 96.0 * (1.0 + 0.28 * s * s),
        };
        ([1.0 - short, 1.0], 0.0258 * s.powi(3))
    }

    fn bound(self, case: &Case) -> f64 {
        case.replaced_when_acute(|s| self.deviation(s))
    }
}

/// Bound on the error of the Newton form, LSB, for a far light and viewer and a spread up to 90°, the whole range
/// otherwise. Proved but for the figures of [`XShading::deviation`], which are measured.
#[must_use]
pub fn bound(case: &Case) -> f64 {
    XShading::Newton.bound(case)
}

/// Bound on the error of the cached form, LSB, likewise.
#[must_use]
pub fn cached_bound(case: &Case) -> f64 {
    XShading::Cached.bound(case)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shade::probe::{deviation, normals, Shape, SPREADS};
    use rand::rngs::StdRng;
    use rand::SeedableRng;

    const BOTH: [XShading; 2] = [XShading::Newton, XShading::Cached];

    #[test]
    fn the_vector_in_place_of_the_normal_stays_where_it_is_stated_to_be() {
        for m in BOTH {
            for s in SPREADS {
                let s = s.to_radians();
                let found = deviation(s, |n, w| {
                    let part = |a: DVec3| m.form(n, &[a; 3], true).at(w);
                    DVec3::new(part(DVec3::X), part(DVec3::Y), part(DVec3::Z))
                });
                let ([least, greatest], angle) = m.deviation(s);
                assert!(found.shortest >= least, "{m:?} {s}: {found:?} {least}");
                assert!(found.longest <= greatest + 1e-12, "{m:?} {s}: {found:?}");
                assert!(found.angle <= angle, "{m:?} {s}: {found:?} {angle}");
                // And is not far from it.
                assert!(1.0 - found.shortest > 0.85 * (1.0 - least), "{m:?} {s}");
                assert!(s > 0.6 || found.angle > 0.9 * angle, "{m:?} {s}");
            }
        }
    }

    fn random(k: u64) -> ([DVec3; 3], DVec3) {
        let mut rng = StdRng::seed_from_u64(k);
        let n = normals(&mut rng, 0.1 + 0.01 * k as f64, Shape::Any);
        (n, normals(&mut rng, 1.0, Shape::Any)[0])
    }

    /// The published coefficients: kᵢⱼ = (Iᵢ + Iⱼ)(1 − c)/2, or with 4/√(2 + 2c) − 2 for the cached factor.
    #[test]
    fn bows_are_those_of_the_paper() {
        for k in 0..100 {
            let (n, l) = random(k);
            for m in BOTH {
                let form = m.form(&n, &[l; 3], true);
                for (e, (i, j)) in EDGES.into_iter().enumerate() {
                    let c = n[i].dot(n[j]);
                    let g = match m {
                        XShading::Newton => (1.0 - c) / 2.0,
                        XShading::Cached => 4.0 / (2.0 + 2.0 * c).sqrt() - 2.0,
                    };
                    let want = (n[i].dot(l) + n[j].dot(l)) * g;
                    assert!((form.bow[e] - want).abs() < 1e-14, "{m:?}");
                }
            }
        }
    }

    #[test]
    fn mid_edges_are_a_newton_step_and_the_exact_normal() {
        for k in 0..100 {
            let (n, l) = random(k);
            let middle = (n[0] + n[1]) / 2.0;
            let step = middle / 2.0 * (3.0 - middle.length_squared());
            let at = |m: XShading| m.form(&n, &[l; 3], true).at([0.5, 0.5, 0.0]);
            assert!((at(XShading::Newton) - step.dot(l)).abs() < 1e-15);
            assert!((at(XShading::Cached) - middle.normalize().dot(l)).abs() < 1e-15);
        }
    }

    #[test]
    fn opposite_normals_stay_finite() {
        let n = [DVec3::X, DVec3::NEG_X, DVec3::Y];
        for m in BOTH {
            let form = m.form(&n, &[DVec3::new(0.6, 0.0, 0.8); 3], true);
            assert!(
                form.bow.iter().all(|k| k.is_finite() && k.abs() < 10.0),
                "{form:?}"
            );
        }
    }
}
