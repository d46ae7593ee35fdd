//! What a triangle is painted with, worked out once per triangle; how pixels come of it is the renderer's business.

use super::corners::Corners;
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
    /// The knots of a triangle; `None` for materials and lights that it does not draw.
    #[must_use]
    pub fn new(p: &Prepared, index: usize) -> Option<Self> {
        let t = &p.triangles[index];
        if !is_plain(p, t) {
            return None;
        }
        let corners = Corners::new(p, index);
        let s = &p.surroundings;
        let lights = s.reaching(&t.world).iter();
        // Unit normals, positions and views at the six knots.
        let mut normal = [DVec3::ZERO; 6];
        let mut place = [DVec3::ZERO; 6];
        for i in 0..3 {
            (normal[i], place[i]) = (corners.normal[i], t.world[i]);
        }
        for (k, (i, j)) in super::quadratic::EDGES.into_iter().enumerate() {
            let sum = t.inv_w[i] + t.inv_w[j];
            let (qi, qj) = (t.inv_w[i] / sum, t.inv_w[j] / sum);
            normal[3 + k] = super::unit_normal(t, t.normal[i] * qi + t.normal[j] * qj);
            place[3 + k] = t.world[i] * qi + t.world[j] * qj;
        }
        let view = place.map(|x| s.view(x));
        let term = |(k, corner): (usize, &super::corners::Term)| {
            let light = if corner.constant {
                [corner.light[0]; 6]
            } else {
                place.map(|x| s.incident(k, x).direction)
            };
            let knot = |i: usize| normal[i].dot((light[i] + view[i]).normalize_or_zero());
            DotsTerm {
                light: [0, 1, 2, 3, 4, 5].map(|i| normal[i].dot(light[i])),
                half: if !corner.shines() {
                    [0.0; 6]
                } else if corner.constant {
                    normal.map(|n| n.dot(corner.half[0]))
                } else {
                    [0, 1, 2, 3, 4, 5].map(knot)
                },
                diffuse: corner.diffuse[0],
                specular: corner.specular[0],
            }
        };
        Some(Self {
            terms: lights.zip(&corners.terms).map(term).collect(),
            ambient: corners.ambient,
            shininess: corners.shininess,
        })
    }
}
