//! Dot-product interpolation: N·L and N·H of the vertices are blended (Abbas 2003, eq. 5.4; Claussen 1990).
//!
//! Work for one light: per triangle 6 dot products; per span 9 multiplications a cosine; per pixel 2 additions, a power
//! and 4 multiplications (table 9.2 of the study counts the same).

use super::case::{shortest, Case};
use super::corners::{Corners, Term};
use super::form::{Form, Slide};
use super::lit::Cosines;

/// The method; see [`super::lit::Lit`].
pub struct DotProduct;

impl Cosines for DotProduct {
    type Shared = ();
    type Own = [Form; 2];

    fn shared(&self, _: &Corners) {}

    fn own(&self, c: &Corners, t: &Term) -> [Form; 2] {
        [t.light, t.half].map(|v| Form::linear([0, 1, 2].map(|i| c.normal[i].dot(v[i]))))
    }

    fn cosines((): &(), own: &[Slide; 2]) -> [f64; 2] {
        own.map(|c| c.r)
    }
}

/// Bound on the error, LSB; proved. With a far light and viewer it is that of [`super::normals`]. Otherwise the blend
/// of products exceeds the product of blends by Σ λᵢλⱼ(nᵢ − nⱼ)·(Lᵢ − Lⱼ), at most (4/3)·sin(s/2)·sin(t/2) for a spread
/// s and a turn t, and the errors add up.
#[must_use]
pub fn bound(case: &Case) -> f64 {
    let length = shortest(case.spread) * shortest(case.turn);
    let excess = 4.0 / 3.0 * (case.spread / 2.0).sin() * (case.turn / 2.0).sin();
    let short = case.replaced([length, 1.0], 0.0);
    (short + case.cosine(excess)).min(case.whole())
}
