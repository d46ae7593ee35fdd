//! The truth: at every pixel centre, position and normal by perspective-correct interpolation
//! qᵢ = λᵢwᵢ / Σλw (w = 1/w; Heckbert 1989), the normal normalised and bent by the bump map if there is one, and the full reflection model with a true power.

use super::barycentric::weights;
use super::reach::Reaching;
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
    let lights = 0..p.surroundings.lights();
    blend_by(lights, p, t, weights(&t.position, x, y), way)
}

/// RGB where the weights on the screen are `w`, LSB, not limited.
pub(crate) fn blend(p: &Prepared, t: &ScreenTriangle, w: [f64; 3]) -> [f64; 3] {
    blend_by(0..p.surroundings.lights(), p, t, w, Normalise::Exact)
}

/// The same with some of the lights only.
fn blend_by(
    lights: impl Iterator<Item = usize>,
    p: &Prepared,
    t: &ScreenTriangle,
    w: [f64; 3],
    way: Normalise,
) -> [f64; 3] {
    let q = [0, 1, 2].map(|i| w[i] * t.inv_w[i]);
    let sum = q[0] + q[1] + q[2];
    let q = q.map(|v| v / sum);
    let blend = |v: [glam::DVec3; 3]| v[0] * q[0] + v[1] * q[1] + v[2] * q[2];
    let mut normal = unit_normal(t, blend(t.normal));
    if let Some(bump) = &p.surroundings.material(t.material).bump {
        normal = bump.bend(t, q, normal, way);
    }
    p.surroundings
        .shade_by(lights, t.material, blend(t.world), normal)
        .to_array()
}

/// The method for the renderer: nothing is kept from pixel to pixel but which lights reach the triangle.
pub struct Exact;

/// The current pixel of a triangle.
pub struct At<'a> {
    prepared: &'a Prepared,
    triangle: &'a ScreenTriangle,
    lights: Reaching,
    x: i32,
    y: i32,
}

impl Shader for Exact {
    const EXACT: bool = true;
    type Triangle = (usize, Reaching);
    type Run<'a> = At<'a>;

    fn triangle(&self, p: &Prepared, index: usize) -> (usize, Reaching) {
        (index, p.surroundings.reaching(&p.triangles[index].world))
    }

    fn start<'a>(&'a self, p: &'a Prepared, t: &'a (usize, Reaching), span: Span) -> At<'a> {
        At {
            prepared: p,
            triangle: &p.triangles[t.0],
            lights: t.1,
            x: span.start,
            y: span.y,
        }
    }
}

impl Run for At<'_> {
    fn colour(&self) -> [f64; 3] {
        let w = weights(&self.triangle.position, self.x, self.y);
        let lights = self.lights.iter();
        blend_by(lights, self.prepared, self.triangle, w, Normalise::Exact)
    }

    fn step(&mut self) {
        self.x += 1;
    }
}
