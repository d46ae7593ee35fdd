//! Where the row through the centres of a span cuts the edges of its triangle. The papers interpolate along edges first
//! and between them next; the places of both steps follow from the weights at one pixel centre, so they do not depend on
//! rows or pixels before, nor on what part of the row is in the picture.

use super::barycentric::{steps, weights};
use crate::raster::{Point, Span};

/// A place on an edge of a triangle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Side {
    /// The edge, an index into [`super::quadratic::EDGES`].
    pub edge: usize,
    /// From its first vertex (0) to its second (1).
    pub t: f64,
}

/// A row between two edges.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cut {
    /// Where the row enters the triangle.
    pub left: Side,
    /// Where it leaves it.
    pub right: Side,
    /// The first pixel centre of the span: 0 on the left edge, 1 on the right one.
    pub first: f64,
    /// From one pixel centre to the next, in the same measure.
    pub step: f64,
}

impl Cut {
    /// The cut of the row of a span, which must lie in the triangle.
    #[must_use]
    pub fn new(position: &[Point; 3], span: Span) -> Self {
        let (w, s) = (weights(position, span.start, span.y), steps(position));
        // Along the row weight i vanishes w/s pixels to the left when it grows to the right.
        let nearest = |sign: f64| {
            (0..3)
                .filter(|i| sign * s[*i] > 0.0)
                .map(|i| (i, (w[i] / (sign * s[i])).max(0.0)))
                .min_by(|a, b| a.1.total_cmp(&b.1))
                .unwrap_or((0, 0.0))
        };
        let side = |(i, distance): (usize, f64)| {
            let (j, k) = [(1, 2), (0, 2), (0, 1)][i];
            let [at_j, at_k] = [j, k].map(|m| (w[m] + s[m] * distance).max(0.0));
            let sum = at_j + at_k;
            Side {
                edge: 2 - i,
                t: if sum > 0.0 { at_k / sum } else { 0.0 },
            }
        };
        let ((i, left), (j, right)) = (nearest(1.0), nearest(-1.0));
        let width = left + right;
        let share = |v: f64| if width > 0.0 { v / width } else { 0.0 };
        Self {
            left: side((i, -left)),
            right: side((j, right)),
            first: share(left),
            step: share(1.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::{Viewport, Walk};
    use crate::shade::quadratic::EDGES;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn cuts_lie_on_the_edges_and_on_the_row(
            p in prop::array::uniform3((-20_000..80_000i32, -20_000..80_000i32)),
        ) {
            let p = p.map(|(x, y)| Point { x, y });
            let viewport = Viewport { width: 256, height: 256 };
            let Some(walk) = Walk::new(p, viewport) else { return Ok(()) };
            for span in walk.spans(256) {
                let c = Cut::new(&p, span);
                let place = |s: Side| {
                    let (a, b) = EDGES[s.edge];
                    let ((ax, ay), (bx, by)) = (p[a].pixels(), p[b].pixels());
                    (ax + (bx - ax) * s.t, ay + (by - ay) * s.t)
                };
                let ((lx, ly), (rx, ry)) = (place(c.left), place(c.right));
                let row = f64::from(span.y) + 0.5;
                prop_assert!((ly - row).abs() < 1e-6 && (ry - row).abs() < 1e-6, "{c:?}");
                let first = f64::from(span.start) + 0.5;
                prop_assert!((lx + c.first * (rx - lx) - first).abs() < 1e-6);
                prop_assert!((c.step * (rx - lx) - 1.0).abs() < 1e-6 || rx - lx < 1e-6);
                let last = c.first + c.step * f64::from(span.end - 1 - span.start);
                prop_assert!(c.first >= 0.0 && last < 1.0 + 1e-9);
            }
        }
    }
}
