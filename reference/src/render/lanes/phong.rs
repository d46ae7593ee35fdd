//! Phong shading (Phong 1975) with the half-way vector: the normal is blended, made unit and put into the reflection
//! model at every pixel, in f32.
//!
//! The vectors that are blended carry the perspective weights wᵢ, and their blend along a row is linear; its direction is
//! that of the perspective-correct vector. Near lights and a near eye are blended the same way, P − x being linear in
//! the same weights, so nothing is approximated but the arithmetic: below 10⁻⁶·n + 10⁻⁴ of each term.

use super::kernel::{rows_anew, Kernel};
use super::patch::Patch;
use super::{Direction, Phong};
use crate::simd::real::{pixels, Vector, Walk};
use crate::simd::reflect::{Model, Term};
use fearless_simd::{u32x8, Simd};
use glam::DVec3;

/// A blended vector over the triangle.
#[derive(Clone, Copy)]
struct Blend {
    at: DVec3,
    du: DVec3,
    dv: DVec3,
}

impl Blend {
    #[inline(always)]
    fn new(a: &[DVec3; 3]) -> Self {
        Self {
            at: a[0],
            du: a[1] - a[0],
            dv: a[2] - a[0],
        }
    }

    /// What is constant needs no blend.
    #[inline(always)]
    fn of(d: &Direction) -> Self {
        match d {
            Direction::Constant(_) => Self::new(&[DVec3::ZERO; 3]),
            Direction::Blend(a) => Self::new(a),
        }
    }

    #[inline(always)]
    fn start<S: Simd>(&self, simd: S, [u, v]: [f64; 2], [du, dv]: [f64; 2]) -> Walk<S> {
        let at = self.at + self.du * u + self.dv * v;
        Walk::new(simd, at, self.du * du + self.dv * dv)
    }
}

/// Up to `N` lights.
pub(super) struct PhongKernel<S: Simd, const N: usize> {
    normal: Blend,
    view: Blend,
    lights: [Blend; N],
    model: Model<S, N>,
    dx: [f64; 2],
}

#[derive(Clone, Copy)]
pub(super) struct State<S: Simd, const N: usize> {
    normal: Walk<S>,
    view: Walk<S>,
    lights: [Walk<S>; N],
}

impl<S: Simd, const N: usize> PhongKernel<S, N> {
    #[inline(always)]
    pub(super) fn new(simd: S, patch: &Patch, p: &Phong) -> Self {
        let mut lights = [Blend::new(&[DVec3::ZERO; 3]); N];
        let mut terms = [Term::none(simd); N];
        let view = p.view.constant();
        for ((blend, to), t) in lights.iter_mut().zip(&mut terms).zip(&p.terms) {
            *blend = Blend::of(&t.light);
            *to = Term::new(simd, t.light.constant(), view, t.diffuse, t.specular);
        }
        Self {
            normal: Blend::new(&p.normal),
            view: Blend::of(&p.view),
            lights,
            model: Model::new(simd, view, terms, p.ambient, p.shininess),
            dx: patch.dx,
        }
    }
}

impl<S: Simd, const N: usize> Kernel<S> for PhongKernel<S, N> {
    type Run = State<S, N>;

    rows_anew!();

    #[inline(always)]
    fn start(&self, simd: S, uv: [f64; 2], _: [i32; 2]) -> State<S, N> {
        let normal = self.normal.start(simd, uv, self.dx);
        let mut lights = [normal; N];
        for ((to, blend), t) in lights.iter_mut().zip(&self.lights).zip(self.model.terms()) {
            if t.is_near() {
                *to = blend.start(simd, uv, self.dx);
            }
        }
        State {
            normal,
            view: if self.model.is_near() {
                self.view.start(simd, uv, self.dx)
            } else {
                normal
            },
            lights,
        }
    }

    #[inline(always)]
    fn pixels(&self, simd: S, run: &State<S, N>) -> u32x8<S> {
        let mut lights: [Vector<S>; N] = [*run.normal.value(); N];
        for (to, walk) in lights.iter_mut().zip(&run.lights) {
            *to = *walk.value();
        }
        let sum = self
            .model
            .colour(simd, run.normal.value(), run.view.value(), &lights);
        pixels(simd, &sum)
    }

    #[inline(always)]
    fn advance(&self, run: &mut State<S, N>) {
        run.normal.advance();
        if self.model.is_near() {
            run.view.advance();
        }
        for (t, walk) in self.model.terms().iter().zip(&mut run.lights) {
            if t.is_near() {
                walk.advance();
            }
        }
    }
}
