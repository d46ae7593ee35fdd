//! Hybrid shading: a diffuse term as by Gouraud and the highlight as by Phong, without a root (Hast 2004, eqs 3.1–3.6).
//!
//! The paper's highlight is Phong's own, (R·V)ⁿ with R·V = l_z − 2n_z(n·l)/(n·n); that of the half-way vector, which this
//! crate draws, needs no root either: (N·H)ⁿ = ((n·H)²/(n·n))^(n/2) where n·H > 0. The diffuse term blends N·L between
//! the vertices and is limited at the pixel, not before, so that a terminator within the triangle is kept.
//!
//! The blend in the highlight is weighted, which makes it perspective-correct at no cost. A near light's H is blended
//! and normalised likewise.
//!
//! Work for one light: per triangle 6 dot products and three cᵢⱼ, which belong to mesh edges; per pixel 4 additions, 1
//! multiplication, 1 division and a power (section 12 of the study on Hast: 4 additions, 1 multiplication, 1 division,
//! 1 subtraction for R·V).

use super::case::Case;
use super::corners::{Corners, Term};
use super::form::{Form, Slide};
use super::lit::{directions, weighted, Cosines};
use super::{dot_product, duff};

/// The method; see [`super::lit::Lit`].
pub struct Hybrid;

impl Cosines for Hybrid {
    /// n·n.
    type Shared = Form;
    /// N·L and n·H, and H·H where it is not 1.
    type Own = ([Form; 2], Option<Form>);

    fn shared(&self, c: &Corners) -> Form {
        let n = weighted(c, c.normal);
        Form::product(&n, &n)
    }

    fn own(&self, c: &Corners, t: &Term) -> Self::Own {
        let (n, h) = (weighted(c, c.normal), directions(c, t, t.half));
        let nl = Form::linear([0, 1, 2].map(|i| c.normal[i].dot(t.light[i])));
        let hh = (!t.constant).then(|| Form::product(&h, &h));
        ([nl, Form::product(&n, &h)], hh)
    }

    /// N·L and the square of N·H.
    fn cosines(nn: &Slide, ([nl, nh], hh): &([Slide; 2], Option<Slide>)) -> [f64; 2] {
        let squares = nn.r * hh.map_or(1.0, |h| h.r);
        let lit = nh.r > 0.0 && squares > super::CANCELLED;
        [nl.r, if lit { nh.r * nh.r / squares } else { 0.0 }]
    }

    fn highlight(square: f64, n: f64) -> f64 {
        square.powf(n / 2.0)
    }
}

/// Bound on the error, LSB; proved: that of [`dot_product`] for the diffuse term, that of [`duff`] for the highlight.
#[must_use]
pub fn bound(case: &Case) -> f64 {
    let matt = Case {
        specular: 0.0,
        ..*case
    };
    dot_product::bound(&matt) + duff::bound(case)
}
