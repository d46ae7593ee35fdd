//! The direct set-up (Hast 2004, eqs 3.159–3.175 and 3.213–3.233): coefficients over the ortho-normalised triangle, which
//! need no product, and from them the forward differences without a polynomial of x and y. The vertices are sorted from
//! top to bottom; which side the middle one is on (the sign of K) decides between one left edge and two.

use super::{Knots, Part, Walk};
use crate::shade::quadric::Quadric;

/// The walk; `None` without area.
#[must_use]
pub fn walk(knots: &Knots) -> Option<Walk> {
    let sorted = knots.sorted();
    let area = sorted.area2();
    if area == 0.0 || knots.area2() == 0.0 {
        return None;
    }
    let [_, y1, _, y2] = sorted.sides();
    let Quadric { a, b, c, d, e, f } = Quadric::quadratic(sorted.value);
    let delta = 1.0 / area;
    let bend = (y2 * y2 * a + y1 * y1 * b - y1 * y2 * c) * delta * delta;
    let part = |edge: Part, p: f64, [second, first]: [f64; 2], slope: f64, cross: f64| {
        let j = 1.0 / edge.lines;
        let k1 = second * j * j;
        Part {
            p,
            dp: k1 + first * j,
            d2p: 2.0 * k1,
            q: bend + slope * delta,
            dq: cross * j * delta,
            d2r: 2.0 * bend,
            ..edge
        }
    };
    let top = d * y2 - e * y1;
    let [upper, lower] = sorted.left_edges();
    let parts = if area > 0.0 {
        [
            upper.map(|s| part(s, f, [b, e], top, c * y2 - 2.0 * b * y1)),
            None,
        ]
    } else {
        [
            upper.map(|s| part(s, f, [a, d], top, 2.0 * a * y2 - c * y1)),
            lower.map(|s| {
                part(
                    s,
                    sorted.value[1],
                    [a + b - c, c - 2.0 * a - d + e],
                    y2 * (2.0 * a + d) - y1 * (c + e),
                    y1 * (c - 2.0 * b) + y2 * (c - 2.0 * a),
                )
            }),
        ]
    };
    Some(Walk { parts })
}
