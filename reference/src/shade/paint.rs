//! What a triangle is painted with, worked out once per triangle; how pixels come of it is the renderer's business.

use super::quadratic::{mid_normal, middle_weights, EDGES};
use super::unit_normal;
use crate::geometry::{Prepared, ScreenTriangle};
use crate::scene::{Attenuation, Brdf, Highlight, LightKind};
use glam::DVec3;
use smallvec::SmallVec;

/// Most lights that [`Dots`] and [`Phong`] take.
pub const LIGHTS: usize = 4;

/// The colour of a triangle.
#[derive(Clone, Debug)]
pub enum Paint {
    /// One colour, LSB.
    Constant([f64; 3]),
    /// Linear between the colours of the vertices.
    Linear([[f64; 3]; 3]),
    /// Quadratic through vertices 0, 1, 2 and mid-edges 01, 02, 12.
    Quadratic([[f64; 3]; 6]),
    /// Quadratic dot products, the reflection model per pixel.
    Dots(Dots),
    /// Blended vectors, the reflection model per pixel.
    Phong(Phong),
    /// The definition, per pixel.
    Exact,
}

/// Dot products through six knots (the order of [`Paint::Quadratic`]).
#[derive(Clone, Debug)]
pub struct Dots {
    /// The lights.
    pub terms: SmallVec<[DotsTerm; 1]>,
    /// Colour without any light, LSB.
    pub ambient: DVec3,
    /// The exponent.
    pub shininess: f64,
}

/// One light of [`Dots`].
#[derive(Clone, Copy, Debug)]
pub struct DotsTerm {
    /// N·L at the knots.
    pub light: [f64; 6],
    /// N·H at the knots.
    pub half: [f64; 6],
    /// Colour of the diffuse reflection, LSB.
    pub diffuse: DVec3,
    /// Colour of the highlight, LSB.
    pub specular: DVec3,
}

/// Blended vectors; their lengths have no meaning and are 1 at most.
#[derive(Clone, Debug)]
pub struct Phong {
    /// Normals at the vertices times perspective weights.
    pub normal: [DVec3; 3],
    /// Towards the viewer.
    pub view: Direction,
    /// The lights.
    pub terms: SmallVec<[PhongTerm; 1]>,
    /// Colour without any light, LSB.
    pub ambient: DVec3,
    /// The exponent.
    pub shininess: f64,
}

/// One light of [`Phong`].
#[derive(Clone, Copy, Debug)]
pub struct PhongTerm {
    /// Towards the light.
    pub light: Direction,
    /// Colour of the diffuse reflection, LSB.
    pub diffuse: DVec3,
    /// Colour of the highlight, LSB.
    pub specular: DVec3,
}

/// A unit vector, or the vertex values of a blend.
#[derive(Clone, Copy, Debug)]
pub enum Direction {
    /// The same everywhere.
    Constant(DVec3),
    /// At the vertices, with perspective weights.
    Blend([DVec3; 3]),
}

impl Direction {
    /// The vector where it is the same everywhere.
    #[must_use]
    pub fn constant(&self) -> Option<DVec3> {
        match self {
            Self::Constant(v) => Some(*v),
            Self::Blend(_) => None,
        }
    }

    /// Its values at the vertices.
    #[must_use]
    pub fn corners(&self) -> [DVec3; 3] {
        match self {
            Self::Constant(v) => [*v; 3],
            Self::Blend(a) => *a,
        }
    }
}

/// Vectors with weights, scaled so that the longest has length 1.
fn scaled(v: [DVec3; 3]) -> [DVec3; 3] {
    let longest = v.iter().fold(0.0f64, |m, v| m.max(v.length()));
    if longest > 0.0 {
        v.map(|v| v / longest)
    } else {
        v
    }
}

/// Whether the material of a triangle and all lights that reach it are of the kinds that [`Dots`] and [`Phong`] draw.
#[must_use]
pub fn is_plain(p: &Prepared, t: &ScreenTriangle) -> bool {
    let s = &p.surroundings;
    let m = s.material(t.material);
    let plain = |k: usize| match s.light(k).0.kind {
        LightKind::Directional { .. } => true,
        LightKind::Point { attenuation, .. } => attenuation == Attenuation::NONE,
        LightKind::Spot { .. } => false,
    };
    matches!(m.brdf, Brdf::Lambert | Brdf::Blinn)
        && m.highlight == Highlight::Pow
        && m.shadow == 0.0
        // Bumps bend normals from pixel to pixel.
        && m.bump.is_none()
        && s.reaching(&t.world).iter().count() <= LIGHTS
        && s.reaching(&t.world).iter().all(plain)
}

/// At the vertices, vectors from a triangle to a point, with perspective weights.
fn towards(t: &ScreenTriangle, x: DVec3) -> Direction {
    Direction::Blend(scaled([0, 1, 2].map(|i| (x - t.world[i]) * t.inv_w[i])))
}

impl Phong {
    /// The vectors of a triangle; `None` for materials and lights that it does not draw.
    #[must_use]
    pub fn new(p: &Prepared, t: &ScreenTriangle) -> Option<Self> {
        if !is_plain(p, t) {
            return None;
        }
        let s = &p.surroundings;
        let m = s.material(t.material);
        let lights = s.reaching(&t.world).iter().map(|k| s.light(k).0);
        let terms = lights.map(|light| PhongTerm {
            light: match light.kind {
                LightKind::Directional { direction } => Direction::Constant(-direction),
                LightKind::Point { position, .. } | LightKind::Spot { position, .. } => {
                    towards(t, position)
                }
            },
            diffuse: light.colour * m.diffuse * 255.0,
            specular: light.colour * m.specular * 255.0,
        });
        Some(Self {
            normal: scaled([0, 1, 2].map(|i| t.normal[i] * t.inv_w[i])),
            view: match s.eye() {
                Some(eye) => towards(t, eye),
                None => Direction::Constant(s.view(t.world[0])),
            },
            terms: terms.collect(),
            ambient: (m.emission + m.ambient) * 255.0,
            shininess: m.shininess,
        })
    }
}

/// A bound of what the f32 of [`Phong`] adds to the error of a triangle, LSB.
#[must_use]
pub fn arithmetic(p: &Prepared, t: &ScreenTriangle) -> f64 {
    let s = &p.surroundings;
    let m = s.material(t.material);
    let weight = |k: usize| (s.light(k).0.colour * (m.diffuse + m.specular)).max_element() * 255.0;
    let sum: f64 = s.reaching(&t.world).iter().map(weight).sum();
    sum * (1e-4 + 1e-6 * m.shininess)
}

impl Dots {
    /// Unit normals at the six knots of a triangle.
    #[must_use]
    pub fn normals(t: &ScreenTriangle) -> [DVec3; 6] {
        let vertex = |i: usize| unit_normal(t, t.normal[i]);
        let middle = |k: usize| mid_normal(t, k);
        [
            vertex(0),
            vertex(1),
            vertex(2),
            middle(0),
            middle(1),
            middle(2),
        ]
    }

    /// The knots of a triangle whose unit normals at the knots are `normal`, which triangles share ([`super::shared`]);
    /// `None` for materials and lights that it does not draw.
    #[must_use]
    pub fn new(p: &Prepared, t: &ScreenTriangle, normal: [DVec3; 6]) -> Option<Self> {
        if !is_plain(p, t) {
            return None;
        }
        let s = &p.surroundings;
        let m = s.material(t.material);
        let place = |k: usize| {
            if k < 3 {
                return t.world[k];
            }
            let (i, j) = EDGES[k - 3];
            let (qi, qj) = middle_weights(t, k - 3);
            t.world[i] * qi + t.world[j] * qj
        };
        let half = |l: DVec3, x: DVec3| (l + s.view(x)).normalize_or_zero();
        let shines = m.specular != DVec3::ZERO;
        let term = |light: usize| {
            let at = s.incident(light, t.world[0]);
            // L and H at the knots: the same everywhere where light and viewer are far.
            let vectors = if s.is_constant(light) {
                [(at.direction, half(at.direction, t.world[0])); 6]
            } else {
                [0, 1, 2, 3, 4, 5].map(|k| {
                    let x = place(k);
                    let l = s.incident(light, x).direction;
                    (l, half(l, x))
                })
            };
            DotsTerm {
                light: [0, 1, 2, 3, 4, 5].map(|k| normal[k].dot(vectors[k].0)),
                half: if shines {
                    [0, 1, 2, 3, 4, 5].map(|k| normal[k].dot(vectors[k].1))
                } else {
                    [0.0; 6]
                },
                diffuse: at.colour * m.diffuse * 255.0,
                specular: at.colour * m.specular * 255.0,
            }
        };
        Some(Self {
            terms: s.reaching(&t.world).iter().map(term).collect(),
            ambient: (m.emission + m.ambient) * 255.0,
            shininess: m.shininess,
        })
    }
}
