//! Phong shading (Phong 1975; Abbas 2003, eq. 5.2): the normal is blended and normalised at every pixel, and the full
//! reflection model is worked out there. Vectors are in single precision, as a graphics unit has them.
//!
//! The blend is Σ λᵢwᵢnᵢ, so it is perspective-correct at no cost; the position, which near lights and viewers need, is
//! Σ λᵢwᵢxᵢ/Σ λᵢwᵢ, with the xᵢ relative to vertex 0 so that the distance from the origin costs no digits. The vectors
//! of a pixel are v₀ + k·dv with k its number in the span: no rounding piles up.
//!
//! Work: per span 12 (24) multiplications; per pixel 3 (7) multiply-adds, 1 root and 4 multiplications to normalise, (1
//! division), and the reflection model for every light. In brackets: near lights or viewer.

use super::barycentric::{steps, weights};
use super::case::Case;
use super::shader::{Run, Shader};
use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::Span;
use glam::{DVec3, Vec3};

/// The method for the renderer.
pub struct Phong {
    /// Whether any colour depends on the position.
    near: bool,
}

impl Phong {
    /// Looks at the lights of a scene.
    #[must_use]
    pub fn new(p: &Prepared) -> Self {
        let s = p.surroundings();
        Self {
            near: (0..s.lights()).any(|k| !s.is_constant(k)),
        }
    }
}

/// A triangle: what is blended is weighted by 1/w relative to the greatest of the three.
pub struct Vectors {
    index: usize,
    weight: [f64; 3],
    normal: [DVec3; 3],
    offset: [DVec3; 3],
    origin: DVec3,
}

/// A vector along a span.
#[derive(Clone, Copy, Debug)]
struct Ray {
    from: Vec3,
    step: Vec3,
}

impl Ray {
    fn new(v: &[DVec3; 3], w: [f64; 3], d: [f64; 3]) -> Self {
        let sum = |w: [f64; 3]| (v[0] * w[0] + v[1] * w[1] + v[2] * w[2]).as_vec3();
        Self {
            from: sum(w),
            step: sum(d),
        }
    }

    fn at(&self, k: f32) -> Vec3 {
        self.from + self.step * k
    }
}

/// A span.
pub struct Pixels<'a> {
    prepared: &'a Prepared,
    triangle: &'a ScreenTriangle,
    origin: DVec3,
    k: f32,
    normal: Ray,
    /// Position, and the sum of the weights.
    place: Option<(Ray, [f32; 2])>,
}

impl Shader for Phong {
    type Triangle = Vectors;
    type Run<'a> = Pixels<'a>;

    fn triangle(&self, p: &Prepared, index: usize) -> Vectors {
        let t = &p.triangles[index];
        let greatest = t.inv_w[0].max(t.inv_w[1]).max(t.inv_w[2]);
        let weight = t.inv_w.map(|w| w / greatest);
        Vectors {
            index,
            weight,
            normal: [0, 1, 2].map(|i| t.normal[i] * weight[i]),
            offset: [0, 1, 2].map(|i| (t.world[i] - t.world[0]) * weight[i]),
            origin: t.world[0],
        }
    }

    fn start<'a>(&'a self, p: &'a Prepared, v: &'a Vectors, span: Span) -> Pixels<'a> {
        let t = &p.triangles[v.index];
        let (w, d) = (weights(&t.position, span.start, span.y), steps(&t.position));
        let sum = |w: [f64; 3]| (0..3).map(|i| w[i] * v.weight[i]).sum::<f64>() as f32;
        Pixels {
            prepared: p,
            triangle: t,
            origin: v.origin,
            k: 0.0,
            normal: Ray::new(&v.normal, w, d),
            place: self
                .near
                .then(|| (Ray::new(&v.offset, w, d), [sum(w), sum(d)])),
        }
    }
}

impl Run for Pixels<'_> {
    fn colour(&self) -> [f64; 3] {
        let t = self.triangle;
        let blend = self.normal.at(self.k);
        let normal = match blend.try_normalize() {
            Some(n) => n.as_dvec3(),
            None => t.face_normal(),
        };
        let position = match self.place {
            Some((place, [from, step])) => {
                self.origin + (place.at(self.k) / (from + step * self.k)).as_dvec3()
            }
            None => self.origin,
        };
        self.prepared
            .surroundings()
            .shade(t.material, position, normal)
            .to_array()
    }

    fn step(&mut self) {
        self.k += 1.0;
    }
}

/// Bound on the error, LSB, proved for a spread up to 90° and a far light and viewer: the blend has a length of at least
/// 1/√3 and its components errors of at most 2 ulp each where it starts, in its step times up to 16384 pixels (both are
/// roundings of what is at most 2 in size) and in their sum, 2⁻²² in all, and normalising adds as much: the direction
/// errs by less than 2⁻²⁰ rad and the length by less than 2⁻²². Near lights and viewers err with the position besides,
/// and are not bounded.
#[must_use]
pub fn bound(case: &Case) -> f64 {
    if !case.is_far_and_acute() {
        return case.whole();
    }
    let e = 2f64.powi(-20);
    case.replaced([1.0 - e, 1.0 + e], e)
}
