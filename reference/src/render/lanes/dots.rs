//! Six-knot quadratics of N·L and N·H, the power per pixel: two additions for each product, and the error of the products
//! alone (bounded in [`crate::shade::bound`]).

use super::kernel::{rows_anew, Kernel};
use super::patch::Patch;
use super::{Dots, DotsTerm};
use crate::shade::quadric::{Forward, Quadric};
use crate::simd::real::{pixels, ramp, splat, vector, Exponent, Vector};
use crate::simd::three;
use fearless_simd::{f32x8, prelude::*, u32x8, Simd};

/// One product along a row.
#[derive(Clone, Copy)]
struct Product<S: Simd> {
    value: f32x8<S>,
    step: f32x8<S>,
    grow: f32x8<S>,
}

impl<S: Simd> Product<S> {
    #[inline(always)]
    fn start(simd: S, q: &Quadric, [u, v]: [f64; 2], [du, dv]: [f64; 2]) -> Self {
        let Forward { r: value, dr, d2r } = q.start((u, v), (du, dv));
        let r = ramp(simd);
        let (d1, d2) = (splat(simd, dr), splat(simd, d2r));
        let pairs = f32x8::simd_from(simd, [0.0, 0.0, 1.0, 3.0, 6.0, 10.0, 15.0, 21.0]);
        let block = f32x8::simd_from(simd, [28.0, 36.0, 44.0, 52.0, 60.0, 68.0, 76.0, 84.0]);
        Self {
            value: splat(simd, value) + r * d1 + pairs * d2,
            step: d1 * 8.0 + block * d2,
            grow: d2 * 64.0,
        }
    }

    #[inline(always)]
    fn advance(&mut self) {
        self.value += self.step;
        self.step += self.grow;
    }
}

/// Up to `N` lights.
pub(super) struct DotsKernel<S: Simd, const N: usize> {
    terms: [Term<S>; N],
    ambient: Vector<S>,
    shininess: Exponent<S>,
    dx: [f64; 2],
}

#[derive(Clone, Copy)]
struct Term<S: Simd> {
    light: Quadric,
    half: Quadric,
    diffuse: Vector<S>,
    specular: Vector<S>,
    lit: bool,
    shines: bool,
}

#[derive(Clone, Copy)]
pub(super) struct State<S: Simd, const N: usize>([(Product<S>, Product<S>); N]);

impl<S: Simd, const N: usize> DotsKernel<S, N> {
    #[inline(always)]
    pub(super) fn new(simd: S, patch: &Patch, d: &Dots) -> Self {
        let zero = [splat(simd, 0.0); 3];
        let mut terms = [Term {
            light: Quadric::default(),
            half: Quadric::default(),
            diffuse: zero,
            specular: zero,
            lit: false,
            shines: false,
        }; N];
        for (to, from) in terms.iter_mut().zip(&d.terms) {
            let DotsTerm { light, half, .. } = from;
            *to = Term {
                light: Quadric::quadratic(*light),
                half: Quadric::quadratic(*half),
                diffuse: vector(simd, from.diffuse),
                specular: vector(simd, from.specular),
                lit: from.diffuse != glam::DVec3::ZERO,
                shines: from.specular != glam::DVec3::ZERO,
            };
        }
        Self {
            terms,
            ambient: vector(simd, d.ambient),
            shininess: Exponent::new(simd, d.shininess),
            dx: patch.dx,
        }
    }
}

impl<S: Simd, const N: usize> Kernel<S> for DotsKernel<S, N> {
    type Run = State<S, N>;

    rows_anew!();

    #[inline(always)]
    fn start(&self, simd: S, uv: [f64; 2], _: [i32; 2]) -> State<S, N> {
        let zero = splat(simd, 0.0);
        let none = Product {
            value: zero,
            step: zero,
            grow: zero,
        };
        let mut state = [(none, none); N];
        for (to, t) in state.iter_mut().zip(&self.terms) {
            if t.lit {
                to.0 = Product::start(simd, &t.light, uv, self.dx);
            }
            if t.shines {
                to.1 = Product::start(simd, &t.half, uv, self.dx);
            }
        }
        State(state)
    }

    #[inline(always)]
    fn pixels(&self, simd: S, run: &State<S, N>) -> u32x8<S> {
        let (zero, one) = (splat(simd, 0.0), splat(simd, 1.0));
        let mut sum = self.ambient;
        for (t, (light, half)) in self.terms.iter().zip(&run.0) {
            if t.lit {
                let cosine = light.value.max(zero);
                sum = three!(c => sum[c] + t.diffuse[c] * cosine);
            }
            if t.shines {
                let shine = self.shininess.of(simd, half.value.min(one));
                sum = three!(c => sum[c] + t.specular[c] * shine);
            }
        }
        pixels(simd, &sum)
    }

    #[inline(always)]
    fn advance(&self, run: &mut State<S, N>) {
        for (light, half) in &mut run.0 {
            light.advance();
            half.advance();
        }
    }
}
