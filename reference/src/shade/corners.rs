//! What the methods that interpolate angles, dot products or vectors share: at the three vertices of a triangle the unit
//! normals and, for each light, the unit vectors towards it and half-way to the viewer, and the colours they act with.
//!
//! I = ambient + Σ diffuse·max(0, N·L) + specular·max(0, N·H)ⁿ, all in LSB. Where light or viewer are near, L and H and
//! (with fall-off) the colours differ from vertex to vertex; methods blend them linearly on the screen.

use super::quadratic::EDGES;
use super::unit_normal;
use crate::geometry::Prepared;
use glam::DVec3;
use smallvec::SmallVec;

/// One light as a triangle sees it.
#[derive(Clone, Copy, Debug)]
pub struct Term {
    /// Unit vectors towards the light at the vertices; zero where the light lies in the vertex.
    pub light: [DVec3; 3],
    /// Unit half-way vectors at the vertices; zero where L = −V (no highlight).
    pub half: [DVec3; 3],
    /// Light and viewer are infinitely far: the three `light` are equal, and so are the three `half`.
    pub constant: bool,
    /// Colour of the diffuse reflection at the vertices, LSB.
    pub diffuse: [DVec3; 3],
    /// Colour of the highlight at the vertices, LSB; zero for matt materials.
    pub specular: [DVec3; 3],
}

impl Term {
    /// Whether the light can cause a highlight at all.
    #[must_use]
    pub fn shines(&self) -> bool {
        self.specular.iter().any(|s| *s != DVec3::ZERO)
    }
}

/// The vertices of a triangle as interpolating methods want them.
#[derive(Clone, Debug)]
pub struct Corners {
    /// Unit normals at the vertices.
    pub normal: [DVec3; 3],
    /// Perspective weights 1/w at the vertices: the blend Σ λᵢwᵢnᵢ has the direction of the perspective-correct normal.
    pub weight: [f64; 3],
    /// Colour without any light, LSB.
    pub ambient: DVec3,
    /// The exponent n of the highlight.
    pub shininess: f64,
    /// The lights.
    pub terms: SmallVec<[Term; 2]>,
}

impl Corners {
    /// The corners of triangle `index` of a scene.
    #[must_use]
    pub fn new(p: &Prepared, index: usize) -> Self {
        let t = &p.triangles[index];
        let s = &p.surroundings;
        let material = s.material(t.material);
        let view = t.world.map(|x| s.view(x));
        let term = |k: usize| {
            let at = t.world.map(|x| s.incident(k, x));
            let light = at.map(|i| i.direction);
            Term {
                light,
                half: [0, 1, 2].map(|i| (light[i] + view[i]).try_normalize().unwrap_or_default()),
                constant: s.is_constant(k),
                diffuse: at.map(|i| i.colour * material.diffuse * 255.0),
                specular: at.map(|i| i.colour * material.specular * 255.0),
            }
        };
        Self {
            normal: t.normal.map(|n| unit_normal(t, n)),
            weight: t.inv_w,
            ambient: material.ambient * 255.0,
            shininess: material.shininess,
            terms: (0..s.lights()).map(term).collect(),
        }
    }

    /// cᵢⱼ = nᵢ·nⱼ of the edges 01, 02, 12: they belong to edges of the mesh and do not change when it turns.
    #[must_use]
    pub fn cosines(&self) -> [f64; 3] {
        EDGES.map(|(i, j)| self.normal[i].dot(self.normal[j]))
    }
}
