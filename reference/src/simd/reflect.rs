//! The reflection model with Blinn's half-way vector for eight normals at a time, in f32:
//! I = ambient + Σ diffuse·max(0, N·L) + specular·max(0, N·H)ⁿ.
//!
//! Vectors that vary are made unit here; their lengths must be 1 at most and have no meaning. A cosine is off by no more
//! than 1.2e-6, which the power magnifies by n.

use super::real::{dot, inverse_length, splat, vector, Exponent, Vector};
use super::three;
use fearless_simd::{prelude::*, Simd};
use glam::DVec3;

/// One light.
#[derive(Clone, Copy)]
pub(crate) struct Term<S: Simd> {
    /// Towards the light where that is the same everywhere.
    light: Option<Vector<S>>,
    /// Half-way between light and viewer where that is the same everywhere.
    half: Option<Vector<S>>,
    diffuse: Vector<S>,
    specular: Vector<S>,
    lit: bool,
    shines: bool,
}

/// Up to `N` lights, viewer and material.
pub(crate) struct Model<S: Simd, const N: usize> {
    /// Towards the viewer where that is the same everywhere.
    view: Option<Vector<S>>,
    terms: [Term<S>; N],
    ambient: Vector<S>,
    shininess: Exponent<S>,
}

impl<S: Simd> Term<S> {
    /// No light.
    #[inline(always)]
    pub(crate) fn none(simd: S) -> Self {
        let zero = [splat(simd, 0.0); 3];
        Self {
            light: None,
            half: None,
            diffuse: zero,
            specular: zero,
            lit: false,
            shines: false,
        }
    }

    /// A light: its direction and the viewer's where they are constant, its colours in LSB.
    #[inline(always)]
    pub(crate) fn new(
        simd: S,
        light: Option<DVec3>,
        view: Option<DVec3>,
        diffuse: DVec3,
        specular: DVec3,
    ) -> Self {
        let half = match (light, view) {
            (Some(l), Some(v)) => Some((l + v).try_normalize().unwrap_or_default()),
            _ => None,
        };
        let known = |v: Option<DVec3>| v.unwrap_or_default();
        let (l, h) = (vector(simd, known(light)), vector(simd, known(half)));
        Self {
            light: if light.is_some() { Some(l) } else { None },
            half: if half.is_some() { Some(h) } else { None },
            diffuse: vector(simd, diffuse),
            specular: vector(simd, specular),
            lit: diffuse != DVec3::ZERO,
            shines: specular != DVec3::ZERO,
        }
    }

    /// Whether the light's direction must be given.
    #[inline(always)]
    pub(crate) fn is_near(&self) -> bool {
        self.light.is_none() && (self.lit || self.shines)
    }
}

/// The unit vector, or one that is known.
#[inline(always)]
fn unit<S: Simd>(simd: S, known: &Option<Vector<S>>, v: &Vector<S>) -> Vector<S> {
    match known {
        Some(v) => *v,
        None => {
            let scale = inverse_length(simd, v);
            three!(c => v[c] * scale)
        }
    }
}

impl<S: Simd, const N: usize> Model<S, N> {
    /// From the viewer's direction where it is constant, the lights, and what is the same for all.
    #[inline(always)]
    pub(crate) fn new(
        simd: S,
        view: Option<DVec3>,
        terms: [Term<S>; N],
        ambient: DVec3,
        shininess: f64,
    ) -> Self {
        Self {
            view: if view.is_some() {
                Some(vector(simd, view.unwrap_or_default()))
            } else {
                None
            },
            terms,
            ambient: vector(simd, ambient),
            shininess: Exponent::new(simd, shininess),
        }
    }

    /// The lights.
    #[inline(always)]
    pub(crate) fn terms(&self) -> &[Term<S>; N] {
        &self.terms
    }

    /// Whether the direction of the viewer must be given.
    #[inline(always)]
    pub(crate) fn is_near(&self) -> bool {
        self.view.is_none()
    }

    /// Colours, LSB, not limited; directions that are constant are not looked at.
    #[inline(always)]
    pub(crate) fn colour(
        &self,
        simd: S,
        normal: &Vector<S>,
        view: &Vector<S>,
        lights: &[Vector<S>; N],
    ) -> Vector<S> {
        let zero = splat(simd, 0.0);
        let scale = inverse_length(simd, normal);
        let n: Vector<S> = three!(c => normal[c] * scale);
        let view = unit(simd, &self.view, view);
        let mut sum = self.ambient;
        for (t, towards) in self.terms.iter().zip(lights) {
            if !(t.lit || t.shines) {
                continue;
            }
            let light = unit(simd, &t.light, towards);
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
                let shine = self.shininess.of(simd, cosine.min(splat(simd, 1.0)));
                sum = three!(c => sum[c] + t.specular[c] * shine);
            }
        }
        sum
    }
}
