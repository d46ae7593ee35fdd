//! Per-pixel shading with bumps whose normals are brought to unit length as their material says: the method `phong` for
//! scenes with bump maps. With exact normalisation it draws what the truth is.

use super::Normalise;
use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::Span;
use crate::shade::exact;
use crate::shade::shader::{Run, Shader};

/// RGB at the centre of pixel (`x`, `y`), LSB, not limited.
#[must_use]
pub fn value(p: &Prepared, t: &ScreenTriangle, x: i32, y: i32) -> [f64; 3] {
    let bump = &p.surroundings.material(t.material).bump;
    let way = bump
        .as_ref()
        .map_or(Normalise::Exact, |b| b.relief().normalise);
    exact::with(p, t, x, y, way)
}

/// The method for the renderer.
pub struct Bumped;

/// The current pixel of a triangle.
pub struct At<'a> {
    prepared: &'a Prepared,
    triangle: &'a ScreenTriangle,
    x: i32,
    y: i32,
}

impl Shader for Bumped {
    type Triangle = usize;
    type Run<'a> = At<'a>;

    fn triangle(&self, _: &Prepared, index: usize) -> usize {
        index
    }

    fn start<'a>(&'a self, p: &'a Prepared, index: &'a usize, span: Span) -> At<'a> {
        At {
            prepared: p,
            triangle: &p.triangles[*index],
            x: span.start,
            y: span.y,
        }
    }
}

impl Run for At<'_> {
    fn colour(&self) -> [f64; 3] {
        value(self.prepared, self.triangle, self.x, self.y)
    }

    fn step(&mut self) {
        self.x += 1;
    }
}
