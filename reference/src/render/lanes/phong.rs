//! Phong shading (Phong 1975) with the half-way vector: the normal is blended, made unit and put into the reflection
//! model at every pixel, in f32.
//!
//! The vectors that are blended carry the perspective weights wᵢ, and their blend along a row is linear; its direction is
//! that of the perspective-correct vector. Near lights and a near eye are blended the same way, P − x being linear in
//! the same weights, so nothing is approximated but the arithmetic: below 10⁻⁶·n + 10⁻⁴ of each term.

use super::fixed::three;
use super::kernel::{rows_anew, Kernel};
use super::patch::Patch;
use super::real::{dot, inverse_length, pixels, power, splat, vector, Vector, Walk};
use super::{Direction, Phong};
use fearless_simd::{f32x8, prelude::*, u32x8, Simd};
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

    #[inline(always)]
    fn start<S: Simd>(&self, simd: S, [u, v]: [f64; 2], [du, dv]: [f64; 2]) -> Walk<S> {
        let at = self.at + self.du * u + self.dv * v;
        Walk::new(simd, at, self.du * du + self.dv * dv)
    }
}

/// A direction that is constant or blended.
#[derive(Clone, Copy)]
struct Towards<S: Simd> {
    constant: Option<Vector<S>>,
    blend: Blend,
}

impl<S: Simd> Towards<S> {
    #[inline(always)]
    fn new(simd: S, d: &Direction) -> Self {
        match d {
            Direction::Constant(v) => Self {
                constant: Some(vector(simd, *v)),
                blend: Blend::new(&[DVec3::ZERO; 3]),
            },
            Direction::Blend(a) => Self {
                constant: None,
                blend: Blend::new(a),
            },
        }
    }
}

#[derive(Clone, Copy)]
struct Term<S: Simd> {
    light: Towards<S>,
    half: Option<Vector<S>>,
    diffuse: Vector<S>,
    specular: Vector<S>,
    lit: bool,
    shines: bool,
}

/// Up to `N` lights.
pub(super) struct PhongKernel<S: Simd, const N: usize> {
    normal: Blend,
    view: Towards<S>,
    terms: [Term<S>; N],
    ambient: Vector<S>,
    shininess: f32x8<S>,
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
        let zero = [splat(simd, 0.0); 3];
        let mut terms = [Term {
            light: Towards::new(simd, &Direction::Constant(DVec3::ZERO)),
            half: None,
            diffuse: zero,
            specular: zero,
            lit: false,
            shines: false,
        }; N];
        for (to, from) in terms.iter_mut().zip(&p.terms) {
            *to = Term {
                light: Towards::new(simd, &from.light),
                half: match (&from.light, &p.view) {
                    (Direction::Constant(l), Direction::Constant(v)) => {
                        Some(vector(simd, (*l + *v).try_normalize().unwrap_or_default()))
                    }
                    _ => None,
                },
                diffuse: vector(simd, from.diffuse),
                specular: vector(simd, from.specular),
                lit: from.diffuse != DVec3::ZERO,
                shines: from.specular != DVec3::ZERO,
            };
        }
        Self {
            normal: Blend::new(&p.normal),
            view: Towards::new(simd, &p.view),
            terms,
            ambient: vector(simd, p.ambient),
            shininess: splat(simd, p.shininess),
            dx: patch.dx,
        }
    }
}

/// A constant direction, or the unit vector of a blended one.
#[inline(always)]
fn unit<S: Simd>(simd: S, t: &Towards<S>, walk: &Walk<S>) -> Vector<S> {
    match t.constant {
        Some(v) => v,
        None => {
            let v = walk.value();
            let scale = inverse_length(simd, v);
            three!(c => v[c] * scale)
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
        for (to, t) in lights.iter_mut().zip(&self.terms) {
            if t.light.constant.is_none() {
                *to = t.light.blend.start(simd, uv, self.dx);
            }
        }
        State {
            normal,
            view: match self.view.constant {
                Some(_) => normal,
                None => self.view.blend.start(simd, uv, self.dx),
            },
            lights,
        }
    }

    #[inline(always)]
    fn pixels(&self, simd: S, run: &State<S, N>) -> u32x8<S> {
        let zero = splat(simd, 0.0);
        let n = run.normal.value();
        let scale = inverse_length(simd, n);
        let n: Vector<S> = three!(c => n[c] * scale);
        let view = unit(simd, &self.view, &run.view);
        let mut sum = self.ambient;
        for (t, walk) in self.terms.iter().zip(&run.lights) {
            if !(t.lit || t.shines) {
                continue;
            }
            let light = unit(simd, &t.light, walk);
            if t.lit {
                let cosine = dot(&n, &light).max(zero);
                sum = three!(c => sum[c] + t.diffuse[c] * cosine);
            }
            if t.shines {
                let cosine = match t.half {
                    Some(h) => dot(&n, &h),
                    None => {
                        let h: Vector<S> = three!(c => light[c] + view[c]);
                        dot(&n, &h) * inverse_length(simd, &h)
                    }
                };
                let shine = power(simd, cosine.min(splat(simd, 1.0)), self.shininess);
                sum = three!(c => sum[c] + t.specular[c] * shine);
            }
        }
        pixels(simd, &sum)
    }

    #[inline(always)]
    fn advance(&self, run: &mut State<S, N>) {
        run.normal.advance();
        if self.view.constant.is_none() {
            run.view.advance();
        }
        for (t, walk) in self.terms.iter().zip(&mut run.lights) {
            if t.light.constant.is_none() {
                walk.advance();
            }
        }
    }
}
