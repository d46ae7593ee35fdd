//! A part of a triangle, cut off by lines on the screen. The pixels of a triangle are dealt out to its parts one by one,
//! by signs that both parts beside a cut compute in the same way: none is lost and none is drawn twice.

use super::{each_span, pixel};
use crate::geometry::Prepared;
use crate::shade::barycentric::weights;

/// One side of a cut: where Σ λᵢ·cᵢ ≥ 0, or where it is negative, with the barycentric weights λ of a pixel centre.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Side {
    values: [f64; 3],
    positive: bool,
}

/// A triangle, or what is left of it after some cuts.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Piece {
    /// Index of the triangle.
    pub triangle: usize,
    sides: Vec<Side>,
}

impl Piece {
    /// The whole triangle.
    pub(super) fn whole(triangle: usize) -> Self {
        Self {
            triangle,
            sides: Vec::new(),
        }
    }

    /// The parts where a function, affine on the screen with these values at the triangle's vertices, is not negative
    /// and where it is.
    pub(super) fn cut(&self, values: [f64; 3]) -> [Self; 2] {
        [true, false].map(|positive| {
            let mut part = self.clone();
            part.sides.push(Side { values, positive });
            part
        })
    }

    /// Calls `f` with the index of each pixel of the part.
    pub(super) fn each_pixel(&self, p: &Prepared, mut f: impl FnMut(usize)) {
        let t = &p.triangles[self.triangle];
        each_span(p, t, |span| {
            for x in span.start..span.end {
                if self.sides.is_empty() {
                    f(pixel(p, x, span.y));
                    continue;
                }
                let w = weights(&t.position, x, span.y);
                let inside = self.sides.iter().all(|s| {
                    let v = w[0] * s.values[0] + w[1] * s.values[1] + w[2] * s.values[2];
                    (v >= 0.0) == s.positive
                });
                if inside {
                    f(pixel(p, x, span.y));
                }
            }
        });
    }
}
