//! A span through the leaves of a triangle: forward differences within each, set up anew where the next one begins.

use super::tree::{Leaf, Tree};
use crate::geometry::Prepared;
use crate::raster::Span;
use crate::shade::barycentric::{steps, weights};
use crate::shade::exact;
use crate::shade::quadric::Forward;
use crate::shade::shader::Run;

/// What a triangle keeps.
pub struct Cut {
    /// Its number in the scene.
    pub index: usize,
    /// Its pieces.
    pub tree: Tree,
}

/// The current pixel of a span.
pub struct Along<'a> {
    prepared: &'a Prepared,
    cut: &'a Cut,
    x: i32,
    y: i32,
    /// Pixels of this leaf from the current one on.
    left: u32,
    /// None where the leaf is drawn by the definition.
    forward: Option<[Forward; 3]>,
}

impl<'a> Along<'a> {
    /// At the first pixel of a span.
    #[must_use]
    pub fn new(prepared: &'a Prepared, cut: &'a Cut, span: Span) -> Self {
        let mut along = Self {
            prepared,
            cut,
            x: span.start,
            y: span.y,
            left: 0,
            forward: None,
        };
        along.enter();
        along
    }

    /// Finds the leaf of the current pixel, from exact weights.
    fn enter(&mut self) {
        let position = &self.prepared.triangles[self.cut.index].position;
        let (w, s) = (weights(position, self.x, self.y), steps(position));
        let (leaf, w, s) = self.cut.tree.find(w, s);
        // The weights fall to zero where the leaf ends. The conversion saturates.
        let pixels = |i: usize| {
            if s[i] < 0.0 {
                (w[i] / -s[i]) as u32
            } else {
                u32::MAX
            }
        };
        self.left = pixels(0).min(pixels(1)).min(pixels(2)).saturating_add(1);
        self.forward = match leaf {
            Leaf::Smooth(q) => Some(q.map(|q| q.start((w[1], w[2]), (s[1], s[2])))),
            Leaf::Direct => None,
        };
    }
}

impl Run for Along<'_> {
    fn colour(&self) -> [f64; 3] {
        match &self.forward {
            Some(f) => f.map(|f| f.r),
            None => exact::value(
                self.prepared,
                &self.prepared.triangles[self.cut.index],
                self.x,
                self.y,
            ),
        }
    }

    fn step(&mut self) {
        self.x += 1;
        self.left -= 1;
        if self.left == 0 {
            self.enter();
        } else if let Some(f) = &mut self.forward {
            f.iter_mut().for_each(Forward::step);
        }
    }
}
