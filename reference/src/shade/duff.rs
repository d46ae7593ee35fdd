//! Phong shading by forward differences of numerator and squared length: N·L = p/√q with p linear and q quadratic
//! (Duff 1979; Hast 2004, eqs 2.44 and 3.234–3.241).
//!
//! With equal perspective weights q = 1 − Σ 2(1 − cᵢⱼ)·λᵢλⱼ follows from the three cᵢⱼ = nᵢ·nⱼ, which belong to mesh edges;
//! with weights the blend is Σ λᵢwᵢnᵢ, and the method is perspective-correct at no cost. Where a light or the viewer is
//! near, L and H are blended as well: p becomes quadratic and |L|², |H|² join q. Where opposite normals cancel there is
//! no direction, and the cosines are 0.
//!
//! Work for one light: per triangle 6 dot products and three cᵢⱼ; per span 9 multiplications a linear and 18 a quadratic
//! function; per pixel 3 additions, 1 division and 1 root for the first cosine, 1 addition and a multiplication for each
//! further one (section 12 of the study on Hast: 3 additions, 1 division, 1 root).

use super::case::Case;
use super::corners::{Corners, Term};
use super::form::{Form, Slide};
use super::lit::{directions, over_root, weighted, Cosines};

/// The method; see [`super::lit::Lit`].
pub struct Duff;

impl Cosines for Duff {
    /// |N|².
    type Shared = Form;
    /// N·L and N·H, and |L|² and |H|² where they are not 1.
    type Own = ([Form; 2], Option<[Form; 2]>);

    fn shared(&self, c: &Corners) -> Form {
        let n = weighted(c, c.normal);
        if n == c.normal {
            Form::squared_length(c.cosines())
        } else {
            Form::product(&n, &n)
        }
    }

    fn own(&self, c: &Corners, t: &Term) -> Self::Own {
        let n = weighted(c, c.normal);
        let v = [t.light, t.half].map(|v| directions(c, t, v));
        let squares = (!t.constant).then(|| v.map(|v| Form::product(&v, &v)));
        (v.map(|v| Form::product(&n, &v)), squares)
    }

    fn cosines(q: &Slide, (p, squares): &([Slide; 2], Option<[Slide; 2]>)) -> [f64; 2] {
        match squares {
            None => {
                let scale = over_root(1.0, q.r);
                p.map(|p| p.r * scale)
            }
            Some([l, h]) => [over_root(p[0].r, q.r * l.r), over_root(p[1].r, q.r * h.r)],
        }
    }
}

/// Bound on the error, LSB; proved for a spread and a turn up to 90°, the whole range otherwise: only the rounding of the
/// differences is left, 1e-13 in q ≥ 1/3 and a thousandfold of it for a highlight of n = 10 000.
#[must_use]
pub fn bound(case: &Case) -> f64 {
    if !case.is_acute() {
        return case.whole();
    }
    case.cosine(1e-12)
}
