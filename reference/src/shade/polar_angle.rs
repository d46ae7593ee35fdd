//! Polar-angle interpolation: the angles between N and L and between N and H at the vertices are blended, and their
//! cosines taken at every pixel (Abbas 2003, eq. 5.5).
//!
//! Exact where the normals lie on a great circle through L, on the same side of it. Otherwise no better than blending
//! cosines: an angle within the triangle is never less than the least at its vertices, so a highlight within is missed.
//!
//! Work for one light: per triangle 6 dot products and 6 arc cosines (of arguments limited to ±1); per span 9
//! multiplications an angle; per pixel 2 additions, 2 cosines, a power and 4 multiplications (table 9.2 of the study
//! counts the same).

use super::case::{mean_angle, Case};
use super::corners::{Corners, Term};
use super::form::{Form, Slide};
use super::lit::Cosines;

/// The method; see [`super::lit::Lit`].
pub struct PolarAngle;

impl Cosines for PolarAngle {
    type Shared = ();
    type Own = [Form; 2];

    fn shared(&self, _: &Corners) {}

    fn own(&self, c: &Corners, t: &Term) -> [Form; 2] {
        let angle = |v: &[glam::DVec3; 3], i: usize| c.normal[i].dot(v[i]).clamp(-1.0, 1.0).acos();
        [t.light, t.half].map(|v| Form::linear([0, 1, 2].map(|i| angle(&v, i))))
    }

    fn cosines((): &(), own: &[Slide; 2]) -> [f64; 2] {
        own.map(|angle| angle.r.cos())
    }
}

/// Bound on the error, LSB; proved for a spread and a turn up to 90°, the whole range otherwise: |Σ λᵢ(θᵢ − θ)| is at
/// most Σ λᵢ times the angles between the vectors at the vertices and the blended ones, see [`mean_angle`].
#[must_use]
pub fn bound(case: &Case) -> f64 {
    if !case.is_acute() {
        return case.whole();
    }
    case.direction(mean_angle(case.spread) + mean_angle(case.turn))
}
