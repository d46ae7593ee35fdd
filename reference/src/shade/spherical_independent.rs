//! Independent spherical interpolation (Abbas 2003, section 6.1): N, L and H are slerped each for itself along the span,
//! and multiplied per pixel. It has no error but that of slerp against the blend, whatever turns.
//!
//! Each vector is a·cos ψ + c·sin ψ with (cos ψ, sin ψ) by De Moivre's recurrence.
//!
//! | work for each light | |
//! |---|---|
//! | pixel | per vector that turns 10 mul 5 add, 2 dots (6 mul 4 add), 1 power |
//! | span | 2 slerps for each vector, its angle, 2 sines and cosines |
//! | triangle | 3 arcs |

use super::barycentric::weights;
use super::case::Case;
use super::circular::{at, Ramp};
use super::corners::Corners;
use super::cut::Cut;
use super::ends::{self, slerped};
use super::one_pixel;
use super::recurrence::{DeMoivre, Recurrence};
use super::shader::{Constant, Draw, Run, Shader};
use super::turn::Arc;
use crate::geometry::Prepared;
use crate::raster::Span;
use glam::DVec3;
use smallvec::SmallVec;

/// The method.
pub struct SphericalIndependent;

/// What a triangle keeps.
pub struct Setup {
    index: usize,
    corners: Corners,
    normals: [Arc; 3],
}

/// A unit vector that turns evenly, by De Moivre's recurrence on three components with one power.
#[derive(Clone, Copy, Debug)]
pub struct Turning {
    from: DVec3,
    across: DVec3,
    power: DeMoivre<f64>,
}

impl Turning {
    /// From the left to the right end; `first` and `step` as in [`Cut`].
    #[must_use]
    pub fn new([a, b]: [DVec3; 2], first: f64, step: f64) -> Self {
        let arc = Arc::new(a, b);
        let (from, across) = arc.frame();
        let turned = |t: f64| {
            let (sin, cos) = (t * arc.angle).sin_cos();
            (cos, sin)
        };
        Self {
            from,
            across,
            power: DeMoivre {
                along: (1.0, 0.0),
                z: turned(first),
                unit: turned(step),
            },
        }
    }

    /// The vector at the current pixel.
    #[must_use]
    pub fn value(&self) -> DVec3 {
        self.from * self.power.z.0 + self.across * self.power.z.1
    }

    /// Moves one pixel to the right.
    pub fn step(&mut self) {
        self.power.step();
    }
}

/// One light along a span.
struct Lit {
    light: Turning,
    half: Option<Turning>,
    diffuse: Ramp,
    specular: Ramp,
}

/// The current pixel of a span.
pub struct Along {
    ambient: DVec3,
    n: f64,
    normal: Turning,
    lights: SmallVec<[Lit; 2]>,
}

impl Shader for SphericalIndependent {
    const ONE_PIXEL: bool = true;
    type Triangle = Setup;
    type Run<'a> = Along;

    fn triangle(&self, p: &Prepared, index: usize) -> Setup {
        let corners = Corners::new(p, index);
        Setup {
            index,
            normals: slerped::arcs(&corners.normal),
            corners,
        }
    }

    fn start<'a>(&'a self, p: &'a Prepared, t: &'a Setup, span: Span) -> Along {
        let position = &p.triangles[t.index].position;
        let (w, s) = at(position, span);
        let cut = Cut::new(position, span);
        let turning = |ends| Turning::new(ends, cut.first, cut.step);
        Along {
            ambient: t.corners.ambient,
            n: t.corners.shininess,
            normal: turning(slerped::between(&t.normals, &cut)),
            lights: t
                .corners
                .terms
                .iter()
                .map(|term| Lit {
                    light: turning(slerped::other(&term.light, term, &cut)),
                    half: term
                        .shines()
                        .then(|| turning(slerped::other(&term.half, term, &cut))),
                    diffuse: Ramp::new(&term.diffuse, &w, &s),
                    specular: Ramp::new(&term.specular, &w, &s),
                })
                .collect(),
        }
    }

    fn one_pixel<D: Draw>(&self, p: &Prepared, t: &Setup, span: Span, draw: D) -> D::Out {
        let triangle = &p.triangles[t.index];
        let w = weights(&triangle.position, span.start, span.y);
        let colour = one_pixel::colour(triangle, &t.corners, w, w);
        draw.draw(Constant(colour))
    }
}

impl Run for Along {
    fn colour(&self) -> [f64; 3] {
        let normal = self.normal.value();
        let mut sum = self.ambient;
        for l in &self.lights {
            sum += l.diffuse.value() * normal.dot(l.light.value()).max(0.0);
            let cos = l.half.map_or(0.0, |h| normal.dot(h.value()));
            if cos > 0.0 {
                sum += l.specular.value() * cos.min(1.0).powf(self.n);
            }
        }
        sum.to_array()
    }

    fn step(&mut self) {
        self.normal.step();
        for l in &mut self.lights {
            l.light.step();
            if let Some(h) = &mut l.half {
                h.step();
            }
            l.diffuse.step();
            l.specular.step();
        }
    }
}

/// Bound on |method − truth|, LSB. Proved, up to a spread and a turn of 90°: see [`ends::triangle_lag`].
#[must_use]
pub fn bound(case: &Case) -> f64 {
    let [d, s] = ends::strays(case, ends::triangle_lag, false);
    case.terms(d, s)
}
