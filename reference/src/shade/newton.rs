//! Newton shading: the blended normal is lengthened by one Newton step of the reciprocal square root,
//! n' = (n/2)(3 − n·n), in the place of a division and a root (Hast 2004, eq. 3.270; Shah's register combiners).
//!
//! For |n| ≤ 1 the step never overshoots; |n'| = |n|(3 − |n|²)/2. At the middle of an edge n' is the vector
//! (5 − c)/8·(n₀ + n₁) of [`x_shading`](super::x_shading). The blend must be near unit length, so it is affine on the
//! screen.
//!
//! Work for one light: per triangle 6 dot products and c₀₁, c₀₂, c₁₂, which belong to mesh edges; per span 9
//! multiplications a cosine and 18 for n·n; per pixel 2 + 2 additions and for both terms together 1 subtraction and 3
//! multiplications (section 12 of the study on Hast: 3 additions, 1 multiplication, 1 subtraction a term; the halving is
//! folded into n·n).

use super::case::{shortest, Case};
use super::corners::{Corners, Term};
use super::form::{Form, Slide};
use super::lit::Cosines;

/// The method; see [`super::lit::Lit`].
pub struct Newton;

impl Cosines for Newton {
    /// (3 − n·n)/2.
    type Shared = Form;
    type Own = [Form; 2];

    fn shared(&self, c: &Corners) -> Form {
        let q = Form::squared_length(c.cosines());
        Form {
            corner: [1.0; 3],
            bow: q.bow.map(|k| -k / 2.0),
        }
    }

    fn own(&self, c: &Corners, t: &Term) -> [Form; 2] {
        [t.light, t.half].map(|v| Form::product(&c.normal, &v))
    }

    fn cosines(factor: &Slide, own: &[Slide; 2]) -> [f64; 2] {
        own.map(|c| c.r * factor.r)
    }
}

/// Bound on the error, LSB; proved: the direction is right and the length m(3 − m²)/2 grows with m, which is at least
/// [`shortest`]. L and H are not normalised.
#[must_use]
pub fn bound(case: &Case) -> f64 {
    let m = shortest(case.spread);
    case.replaced([m * (3.0 - m * m) / 2.0 * shortest(case.turn), 1.0], 0.0)
}
