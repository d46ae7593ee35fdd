//! Normals shading: N, L and H are blended and not normalised, cosines are their products (Abbas 2003, eq. 5.3).
//!
//! With a far light and viewer N·L and N·H are linear and this *is* [`dot-product`](super::dot_product) interpolation;
//! otherwise they are quadratic. Both cut through the middle of the arc between the normals, so highlights within a
//! triangle are dimmed by |b|ⁿ.
//!
//! Work for one light: per triangle 6 dot products (12 with a near light); per span 9 or 18 multiplications a cosine;
//! per pixel 2 additions (4), a power and 4 multiplications (table 9.2 of the study counts the same).

use super::case::{shortest, Case};
use super::corners::{Corners, Term};
use super::form::{Form, Slide};
use super::lit::Cosines;

/// The method; see [`super::lit::Lit`].
pub struct Normals;

impl Cosines for Normals {
    type Shared = ();
    type Own = [Form; 2];

    fn shared(&self, _: &Corners) {}

    fn own(&self, c: &Corners, t: &Term) -> [Form; 2] {
        [t.light, t.half].map(|v| Form::product(&c.normal, &v))
    }

    fn cosines((): &(), own: &[Slide; 2]) -> [f64; 2] {
        own.map(|c| c.r)
    }
}

/// Bound on the error, LSB; proved: blended vectors have the right direction, and their lengths are at least
/// [`shortest`] of the spread and of the turn.
#[must_use]
pub fn bound(case: &Case) -> f64 {
    case.replaced([shortest(case.spread) * shortest(case.turn), 1.0], 0.0)
}
