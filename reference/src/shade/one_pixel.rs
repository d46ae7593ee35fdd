//! A span of one pixel for methods whose spans are dear to set up (arcs, phases, recurrences): the colour is that of the
//! blended, normalised vectors at the pixel, which is what those methods approximate,
//!
//!   I = ambient + Σ diffuse·max(0, N·L) + specular·max(0, N·H)ⁿ.
//!
//! Where the ends of spans are blends themselves, a span of one pixel has this value anyway, to rounding. Where they are slerped along
//! the edges, the frame differs by no more than the method's own bound, on the side of the truth.

use super::corners::{Corners, Term};
use super::lit::limit;
use super::unit_normal;
use crate::ScreenTriangle;
use glam::DVec3;

/// The colour at weights `w` on the screen and weights `q` for vectors, LSB.
#[must_use]
pub fn colour(t: &ScreenTriangle, c: &Corners, w: [f64; 3], q: [f64; 3]) -> [f64; 3] {
    let blend = |v: &[DVec3; 3], q: [f64; 3]| v[0] * q[0] + v[1] * q[1] + v[2] * q[2];
    let n = unit_normal(t, blend(&c.normal, q));
    let cosine = |v: &[DVec3; 3], term: &Term| {
        let v = if term.constant {
            v[0]
        } else {
            blend(v, q).normalize_or_zero()
        };
        limit(n.dot(v))
    };
    let mut sum = c.ambient;
    for term in &c.terms {
        sum += blend(&term.diffuse, w) * cosine(&term.light, term);
        let half = if term.shines() {
            cosine(&term.half, term)
        } else {
            0.0
        };
        if half > 0.0 {
            sum += blend(&term.specular, w) * half.powf(c.shininess);
        }
    }
    sum.to_array()
}
