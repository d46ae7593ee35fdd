//! What the methods share that take N·L and N·H along a span for oscillations, cos θ(t) = A·cos(tg − α): they differ only
//! in [`Ends`] (how the vectors at the ends of a span are found) and in [`Response`] (how the cosine and its power are
//! produced from pixel to pixel). Colours that differ between vertices are blended linearly; those of far lights do not.

use super::barycentric::{steps, weights};
use super::corners::Corners;
use super::one_pixel;
use super::shader::{Constant, Draw, Run, Shader};
use super::sweep::Sweep;
use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::{Point, Span};
use glam::DVec3;
use smallvec::SmallVec;

/// The two dot products of one light along a span; none for a highlight that cannot be seen.
pub type Sweeps = (Sweep, Option<Sweep>);

/// How the ends of spans are found.
pub trait Ends: Sync {
    /// What is worked out once per triangle.
    type Triangle: Send + Sync;

    /// The set-up of a triangle.
    fn triangle(&self, p: &Prepared, t: &ScreenTriangle, corners: &Corners) -> Self::Triangle;

    /// The weights of vectors at a pixel from those on the screen: what the blend is made with that the ends stand for.
    fn weights(&self, _: &Corners, w: [f64; 3]) -> [f64; 3] {
        w
    }

    /// The dot products of every light along a span.
    fn sweeps(
        &self,
        t: &ScreenTriangle,
        corners: &Corners,
        setup: &Self::Triangle,
        span: Span,
    ) -> SmallVec<[Sweeps; 2]>;
}

/// max(0, N·L) or max(0, N·H)ⁿ, or what stands for it, along a span.
pub trait Factor {
    /// At the current pixel, 0..=1.
    fn value(&self) -> f64;

    /// Moves one pixel to the right.
    fn step(&mut self);
}

/// How factors are produced.
pub trait Response: Sync {
    /// The diffuse factor.
    type Diffuse<'a>: Factor
    where
        Self: 'a;
    /// The factor of the highlight.
    type Specular<'a>: Factor
    where
        Self: 'a;

    /// Starts the diffuse factor of a span.
    fn diffuse<'a>(&'a self, s: &Sweep) -> Self::Diffuse<'a>;

    /// Starts the highlight of a span; `material` indexes what was worked out per material.
    fn specular<'a>(&'a self, s: &Sweep, material: usize, n: f64) -> Self::Specular<'a>;
}

/// A method: ends and response.
pub struct Circular<E, R> {
    /// How the ends of spans are found.
    pub ends: E,
    /// How factors are produced.
    pub response: R,
}

/// What a triangle keeps.
pub struct Setup<T> {
    index: usize,
    corners: Corners,
    ends: T,
}

/// A colour that changes linearly along a span.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ramp {
    value: DVec3,
    change: DVec3,
}

impl Ramp {
    /// From colours at the vertices, the weights at the first pixel and their steps. Equal colours stay the same bits.
    #[must_use]
    pub fn new(colour: &[DVec3; 3], w: &[f64; 3], s: &[f64; 3]) -> Self {
        let [a, b, c] = *colour;
        if a == b && b == c {
            return Self {
                value: a,
                change: DVec3::ZERO,
            };
        }
        Self {
            value: a * w[0] + b * w[1] + c * w[2],
            change: a * s[0] + b * s[1] + c * s[2],
        }
    }

    /// The current colour.
    #[must_use]
    pub fn value(&self) -> DVec3 {
        self.value
    }

    /// Moves one pixel to the right.
    pub fn step(&mut self) {
        self.value += self.change;
    }
}

/// One light along a span.
pub struct Lit<D, S> {
    diffuse: (D, Ramp),
    specular: Option<(S, Ramp)>,
}

/// The current pixel of a span.
pub struct Along<D, S> {
    ambient: DVec3,
    lights: SmallVec<[Lit<D, S>; 2]>,
}

impl<E: Ends, R: Response> Shader for Circular<E, R> {
    const ONE_PIXEL: bool = true;
    type Triangle = Setup<E::Triangle>;
    type Run<'a>
        = Along<R::Diffuse<'a>, R::Specular<'a>>
    where
        Self: 'a;

    fn triangle(&self, p: &Prepared, index: usize) -> Self::Triangle {
        let corners = Corners::new(p, index);
        Setup {
            index,
            ends: self.ends.triangle(p, &p.triangles[index], &corners),
            corners,
        }
    }

    fn start<'a>(
        &'a self,
        p: &'a Prepared,
        setup: &'a Self::Triangle,
        span: Span,
    ) -> Self::Run<'a> {
        let (t, c) = (&p.triangles[setup.index], &setup.corners);
        let (w, s) = at(&t.position, span);
        let sweeps = self.ends.sweeps(t, c, &setup.ends, span);
        let lights = sweeps.iter().zip(&c.terms);
        Along {
            ambient: c.ambient,
            lights: lights
                .map(|((d, h), term)| Lit {
                    diffuse: (self.response.diffuse(d), Ramp::new(&term.diffuse, &w, &s)),
                    specular: h.as_ref().map(|h| {
                        let factor = self.response.specular(h, t.material, c.shininess);
                        (factor, Ramp::new(&term.specular, &w, &s))
                    }),
                })
                .collect(),
        }
    }

    fn one_pixel<D: Draw>(
        &self,
        p: &Prepared,
        setup: &Self::Triangle,
        span: Span,
        draw: D,
    ) -> D::Out {
        let (t, c) = (&p.triangles[setup.index], &setup.corners);
        let w = weights(&t.position, span.start, span.y);
        let colour = one_pixel::colour(t, c, w, self.ends.weights(c, w));
        draw.draw(Constant(colour))
    }
}

/// Weights at the first pixel of a span, and their steps.
#[must_use]
pub fn at(position: &[Point; 3], span: Span) -> ([f64; 3], [f64; 3]) {
    (weights(position, span.start, span.y), steps(position))
}

impl<D: Factor, S: Factor> Run for Along<D, S> {
    fn colour(&self) -> [f64; 3] {
        let mut sum = self.ambient;
        for light in &self.lights {
            sum += light.diffuse.1.value * light.diffuse.0.value();
            if let Some((factor, colour)) = &light.specular {
                sum += colour.value * factor.value();
            }
        }
        sum.to_array()
    }

    fn step(&mut self) {
        for light in &mut self.lights {
            light.diffuse.0.step();
            light.diffuse.1.step();
            if let Some((factor, colour)) = &mut light.specular {
                factor.step();
                colour.step();
            }
        }
    }
}

/// Something worked out for each material of a scene.
pub(crate) fn per_material<T>(p: &Prepared, f: impl Fn(f64) -> T) -> Vec<T> {
    let count = p
        .triangles
        .iter()
        .map(|t| t.material + 1)
        .max()
        .unwrap_or(0);
    (0..count)
        .map(|m| f(p.surroundings.material(m).shininess))
        .collect()
}
