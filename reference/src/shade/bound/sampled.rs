//! Errors of the linear and the quadratic interpolant where the colour is known: at fifteen points of a triangle, its corners,
//! the middles of its edges and the same of the four triangles that these cut it into.
//!
//! Between the points the error is that of interpolating in a small triangle, plus the difference of the two
//! interpolants there, which is linear or quadratic and known at its knots:
//!
//! * linear: the fifteen points are the corners of sixteen triangles of a quarter of the size, so
//!   |error| ≤ max |e| + (bound of the second derivative)/16;
//! * quadratic: they are the six knots of four triangles of half the size; e is zero at the corners of each, and a
//!   quadratic with values e₁, e₂, e₃ in the middles and zero at the corners is at most 4/3·max |eᵢ|, so
//!   |error| ≤ 4/3·max |e| + (bound of the third derivative)/8.
//!
//! Colours are evaluated in f32 ([`crate::simd::reflect`]); [`noise`] bounds what that does to either.

use crate::shade::paint::{Phong, LIGHTS};
use crate::simd::real::{vector, Vector};
use crate::simd::reflect::{Model, Term};
use crate::simd::{on_vectors, three};
use fearless_simd::{f32x8, prelude::*, Level, Simd};
use glam::DVec3;

/// Largest errors at the fifteen points, LSB, all channels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sampled {
    /// Of the linear interpolant.
    pub linear: f64,
    /// Of the quadratic one.
    pub quadratic: f64,
}

/// λ₁ and λ₂ of the points: corners, middles 01, 02, 12, quarters of the edges, middles of the inner triangle; the
/// last lane repeats the first.
const POINTS: [[f32; 16]; 2] = [
    [
        0.0, 1.0, 0.0, 0.5, 0.0, 0.5, 0.25, 0.75, 0.0, 0.0, 0.75, 0.25, 0.25, 0.5, 0.25, 0.0,
    ],
    [
        0.0, 0.0, 1.0, 0.0, 0.5, 0.5, 0.0, 0.0, 0.25, 0.75, 0.25, 0.75, 0.25, 0.25, 0.5, 0.0,
    ],
];

/// Bounds what f32 adds to either error, LSB: a colour is off by (2·10⁻⁶ + 1.4·10⁻⁶·n) of the sum of its terms, an error by
/// 1 + 5/3 times that, and the quadratic one counts 4/3.
#[must_use]
pub fn noise(p: &Phong) -> f64 {
    let sum: f64 = p
        .terms
        .iter()
        .map(|t| (t.diffuse + t.specular).max_element())
        .sum();
    sum * (8e-6 + 5e-6 * p.shininess)
}

/// The errors of a triangle that [`Phong`] describes.
#[must_use]
pub fn sample(level: Level, p: &Phong) -> Sampled {
    on_vectors!(level, simd => errors(simd, p))
}

/// Half of the points.
#[derive(Clone, Copy)]
struct Lanes<S: Simd> {
    u: f32x8<S>,
    v: f32x8<S>,
}

impl<S: Simd> Lanes<S> {
    #[inline(always)]
    fn new(simd: S, half: usize) -> Self {
        let at = |k: usize| f32x8::from_slice(simd, &POINTS[k][half * 8..half * 8 + 8]);
        Self { u: at(0), v: at(1) }
    }

    /// A blend of three vectors.
    #[inline(always)]
    fn blend(&self, simd: S, a: &[DVec3; 3]) -> Vector<S> {
        let (at, du, dv) = (
            vector(simd, a[0]),
            vector(simd, a[1] - a[0]),
            vector(simd, a[2] - a[0]),
        );
        three!(c => at[c] + du[c] * self.u + dv[c] * self.v)
    }

    #[inline(always)]
    fn colours(&self, simd: S, p: &Phong, model: &Model<S, LIGHTS>) -> Vector<S> {
        let normal = self.blend(simd, &p.normal);
        let view = self.blend(simd, &p.view.corners());
        let mut lights = [normal; LIGHTS];
        for (to, t) in lights.iter_mut().zip(&p.terms) {
            *to = self.blend(simd, &t.light.corners());
        }
        model.colour(simd, &normal, &view, &lights)
    }

    /// The values of the six basis functions.
    #[inline(always)]
    fn basis(&self) -> [f32x8<S>; 6] {
        let (b, c) = (self.u, self.v);
        let a = -(b + c) + 1.0;
        [
            a * (a * 2.0 - 1.0),
            b * (b * 2.0 - 1.0),
            c * (c * 2.0 - 1.0),
            a * b * 4.0,
            a * c * 4.0,
            b * c * 4.0,
        ]
    }

    /// The errors of one channel against knots: linear and quadratic.
    #[inline(always)]
    fn errors(&self, simd: S, colour: f32x8<S>, knots: &[f32; 8]) -> [f32x8<S>; 2] {
        let [k0, k1, k2] = three!(i => f32x8::splat(simd, knots[i]));
        let linear = k0 + (k1 - k0) * self.u + (k2 - k0) * self.v;
        let basis = self.basis();
        let mut quadratic = basis[0] * k0 + basis[1] * k1 + basis[2] * k2;
        for (phi, knot) in basis[3..].iter().zip(&knots[3..]) {
            quadratic += *phi * *knot;
        }
        [(colour - linear).abs(), (colour - quadratic).abs()]
    }
}

#[inline(always)]
fn errors<S: Simd>(simd: S, p: &Phong) -> Sampled {
    let mut terms = [Term::none(simd); LIGHTS];
    let view = p.view.constant();
    for (to, t) in terms.iter_mut().zip(&p.terms) {
        *to = Term::new(simd, t.light.constant(), view, t.diffuse, t.specular);
    }
    let model = Model::new(simd, view, terms, DVec3::ZERO, p.shininess);
    let (a, b) = (Lanes::new(simd, 0), Lanes::new(simd, 1));
    let (first, second) = (a.colours(simd, p, &model), b.colours(simd, p, &model));
    let mut worst = [f32x8::splat(simd, 0.0); 2];
    for c in 0..3 {
        let knots = first[c].to_array();
        let [l0, q0] = a.errors(simd, first[c], &knots);
        let [l1, q1] = b.errors(simd, second[c], &knots);
        worst = [worst[0].max(l0.max(l1)), worst[1].max(q0.max(q1))];
    }
    let largest = |v: f32x8<S>| v.to_array().into_iter().fold(0.0f32, f32::max);
    Sampled {
        linear: f64::from(largest(worst[0])),
        quadratic: f64::from(largest(worst[1])),
    }
}
