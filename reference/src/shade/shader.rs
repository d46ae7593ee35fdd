//! A shading method as the renderer runs it: work per triangle, per span and per pixel, kept apart as the papers count it.

use crate::geometry::Prepared;
use crate::raster::Span;

/// A shading method, ready for one prepared scene: whatever is worked out once per frame or material (tables, shared
/// knots) is in the value itself.
pub trait Shader: Sync {
    /// Whether this is the truth, or promises its distance from it, so that nothing put around it may be approximated.
    const EXACT: bool = false;
    /// Whether a span of one pixel is drawn with less work than another one's start.
    const ONE_PIXEL: bool = false;
    /// What is worked out once per triangle.
    type Triangle: Send + Sync;
    /// What changes along a span.
    type Run<'a>: Run
    where
        Self: 'a;

    /// The set-up of triangle `index` of `p.triangles`.
    fn triangle(&self, p: &Prepared, index: usize) -> Self::Triangle;

    /// The first pixel of a span. Every span starts anew, from exact weights at its first pixel centre, so that no frame
    /// depends on the spans before.
    fn start<'a>(
        &'a self,
        p: &'a Prepared,
        triangle: &'a Self::Triangle,
        span: Span,
    ) -> Self::Run<'a>;

    /// Draws a span of one pixel: without a start where [`Shader::ONE_PIXEL`] says so.
    fn one_pixel<D: Draw>(
        &self,
        p: &Prepared,
        triangle: &Self::Triangle,
        span: Span,
        draw: D,
    ) -> D::Out {
        draw.draw(self.start(p, triangle, span))
    }
}

/// What is done with a run.
pub trait Draw {
    /// Result.
    type Out;

    /// Does it.
    fn draw(self, run: impl Run) -> Self::Out;
}

/// A walk along the pixels of a span.
pub trait Run {
    /// RGB at the current pixel, LSB, not limited; never called for pixels that are hidden.
    fn colour(&self) -> [f64; 3];

    /// Moves one pixel to the right.
    fn step(&mut self);
}

/// A colour that does not change.
#[derive(Clone, Copy, Debug)]
pub struct Constant(pub [f64; 3]);

impl Run for Constant {
    fn colour(&self) -> [f64; 3] {
        self.0
    }

    fn step(&mut self) {}
}
