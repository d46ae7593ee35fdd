//! Colour and depth of a triangle at any place in it.

use crate::geometry::{Prepared, ScreenTriangle};
use crate::method::Method;
use crate::parallel;
use crate::shade::differences::Interpolant;
use crate::shade::{exact, flat, gouraud, quadratic};

/// What the colours of a triangle are made from.
enum Paint {
    Exact,
    Constant([f64; 3]),
    Linear([[f64; 3]; 3]),
    Quadratic([[f64; 3]; 6]),
}

/// The colours of all triangles by one method.
pub(super) struct Painter {
    paints: Vec<Paint>,
}

impl Painter {
    /// Works out the knots of every triangle; `None` for methods whose colour is known at pixel centres only.
    pub(super) fn new(p: &Prepared, method: Method) -> Option<Self> {
        let of: fn(&Prepared, &ScreenTriangle) -> Paint = match method {
            Method::Exact => |_, _| Paint::Exact,
            Method::Flat => |p, t| Paint::Constant(flat::knot(p, t)),
            Method::Gouraud => |p, t| Paint::Linear(gouraud::knots(p, t)),
            Method::Quadratic => |p, t| Paint::Quadratic(quadratic::knots(p, t)),
            _ => return None,
        };
        Some(Self {
            paints: parallel::map(p.triangles.len(), |i| of(p, &p.triangles[i])),
        })
    }

    /// Colour where the weights are `w`, limited to 0..=255 LSB: what is brighter than full must not outweigh its
    /// neighbours in a mixed pixel.
    pub(super) fn colour(&self, p: &Prepared, index: usize, w: [f64; 3]) -> [f64; 3] {
        let colour = match &self.paints[index] {
            Paint::Exact => exact::blend(p, &p.triangles[index], w),
            Paint::Constant(c) => *c,
            Paint::Linear(knots) => gouraud::blend(knots, w),
            Paint::Quadratic(knots) => quadratic::blend(knots, w),
        };
        // What is not a number fails the comparison.
        colour.map(|c| if c >= 0.0 { c.min(255.0) } else { 0.0 })
    }

    /// The colour as a polynomial along rows, for methods that have one.
    pub(super) fn interpolant(&self, p: &Prepared, index: usize) -> Option<Interpolant> {
        let position = p.triangles[index].position;
        match &self.paints[index] {
            Paint::Exact => None,
            Paint::Constant(c) => Some(Interpolant::linear(position, &[*c; 3])),
            Paint::Linear(knots) => Some(Interpolant::linear(position, knots)),
            Paint::Quadratic(knots) => Some(Interpolant::quadratic(position, knots)),
        }
    }
}

/// Depth where the weights are `w`; greater is nearer.
pub(super) fn depth(t: &ScreenTriangle, w: [f64; 3]) -> f64 {
    (0..3).map(|i| t.depth[i] * w[i]).sum()
}

/// The weights of a place within the triangle instead of one beside it: negative ones become 0.
pub(super) fn within(w: [f64; 3]) -> [f64; 3] {
    let w = w.map(|v| v.max(0.0));
    let sum = w[0] + w[1] + w[2];
    if sum > 0.0 {
        w.map(|v| v / sum)
    } else {
        [1.0 / 3.0; 3]
    }
}
