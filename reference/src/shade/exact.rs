//! The truth: at every pixel centre, position and normal by perspective-correct interpolation
//! qᵢ = λᵢwᵢ / Σλw (w = 1/w; Heckbert 1989), the normal normalised and bent by the bump map if there is one, and the full reflection model with a true power.

use super::barycentric::weights;
use super::shader::{Run, Shader};
use super::unit_normal;
use crate::bump::Normalise;
use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::Span;

/// RGB at the centre of pixel (`x`, `y`), LSB, not limited. Meant for pixels inside the triangle.
#[must_use]
pub fn value(p: &Prepared, t: &ScreenTriangle, x: i32, y: i32) -> [f64; 3] {
    with(p, t, x, y, Normalise::Exact)
}

/// [`value`] with the normals of bumps brought to unit length in some way.
pub(crate) fn with(p: &Prepared, t: &ScreenTriangle, x: i32, y: i32, way: Normalise) -> [f64; 3] {
    let w = weights(&t.position, x, y);
    let q = [0, 1, 2].map(|i| w[i] * t.inv_w[i]);
    let sum = q[0] + q[1] + q[2];
    let q = q.map(|v| v / sum);
    let blend = |v: [glam::DVec3; 3]| v[0] * q[0] + v[1] * q[1] + v[2] * q[2];
    let mut normal = unit_normal(t, blend(t.normal));
    if let Some(bump) = &p.surroundings.material(t.material).bump {
        normal = bump.bend(t, q, normal, way);
    }
    p.surroundings
        .shade(t.material, blend(t.world), normal)
        .to_array()
}

/// The method for the renderer: nothing is kept from pixel to pixel.
pub struct Exact;

/// The current pixel of a triangle.
pub struct At<'a> {
    prepared: &'a Prepared,
    triangle: &'a ScreenTriangle,
    x: i32,
    y: i32,
}

impl Shader for Exact {
    const EXACT: bool = true;
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
