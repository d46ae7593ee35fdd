//! Reflection shading: the blended normal n is doubled away from a unit vector u near it, n' = 2v(v·u)/(v·v) − u with
//! v = u + n, which has unit length always and the direction of n exactly where |n| = 1 (Hast 2004, eq. 3.7).
//!
//! u is the direction of the sum of the vertex normals (the paper takes that of the polygon). With v·u = 1 + n·u,
//! v·v = 1 + 2n·u + n·n and v·L = u·L + n·L,
//!
//!   n'·L = 2(v·L)(v·u)/(v·v) − u·L,
//!
//! two linear and one quadratic function for the first cosine, one more for each further one. Per pixel 4 additions, 2
//! multiplications, 1 division, 1 subtraction, and 1 + 1 + 1 for each further cosine (section 12 of the study on Hast).
//! v·v is at least 1 + 2n·u, so it cannot vanish while the normals stay within 90° of u; where it does (n = −u), n' is u.

use super::case::{shortest, Case};
use super::corners::{Corners, Term};
use super::form::{Form, Slide};
use super::lit::Cosines;
use glam::DVec3;

/// The method; see [`super::lit::Lit`].
pub struct Reflection;

/// Below this v·v is rounding.
const VANISHED: f64 = 1e-12;

impl Cosines for Reflection {
    /// v·u and v·v.
    type Shared = [Form; 2];
    /// v·L and v·H, u·L and u·H.
    type Own = [Form; 4];

    fn shared(&self, c: &Corners) -> [Form; 2] {
        let v = doubled(c);
        [Form::product(&v, &[axis(c); 3]), Form::product(&v, &v)]
    }

    fn own(&self, c: &Corners, t: &Term) -> [Form; 4] {
        let (v, u) = (doubled(c), [axis(c); 3]);
        [
            Form::product(&v, &t.light),
            Form::product(&v, &t.half),
            Form::product(&u, &t.light),
            Form::product(&u, &t.half),
        ]
    }

    fn cosines([vu, vv]: &[Slide; 2], [vl, vh, ul, uh]: &[Slide; 4]) -> [f64; 2] {
        let factor = if vv.r > VANISHED {
            2.0 * vu.r / vv.r
        } else {
            return [ul.r, uh.r];
        };
        [factor * vl.r - ul.r, factor * vh.r - uh.r]
    }
}

/// The unit vector near the normals.
fn axis(c: &Corners) -> DVec3 {
    let sum: DVec3 = c.normal.iter().sum();
    sum.try_normalize().unwrap_or(c.normal[0])
}

fn doubled(c: &Corners) -> [DVec3; 3] {
    let u = axis(c);
    c.normal.map(|n| n + u)
}

/// Bound on the error, LSB; proved for a far light and viewer and a spread up to 90°, the whole range otherwise.
///
/// With φ between u and n and ρ = |n| the direction errs by φ − 2·atan(ρ sin φ/(1 + ρ cos φ)), which grows with φ and
/// falls with ρ. ρ is at least [`shortest`]; cos φ is at least (1 + 2c)/√(5 + 4c), that of a vertex normal at angles
/// arccos c from two that coincide.
#[must_use]
pub fn bound(case: &Case) -> f64 {
    if !case.is_far_and_acute() {
        return case.whole();
    }
    let (c, m) = (case.spread.cos(), shortest(case.spread));
    let phi = ((1.0 + 2.0 * c) / (5.0 + 4.0 * c).sqrt()).min(1.0).acos();
    let reached = 2.0 * (m * phi.sin() / (1.0 + m * phi.cos())).atan();
    case.direction(phi - reached)
}
