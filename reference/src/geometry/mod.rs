//! From a scene to triangles on the screen: transform, cull, clip, project, snap, and fit the depth range.

pub mod camera;
pub mod clip;
pub mod cull;
pub mod facing;
mod front_to_back;
mod list;
mod pool;
mod prepare;
mod select;
mod selected;
mod wire;

pub use wire::{WireEdge, Wires};

use crate::raster::Point;
use crate::shade::Surroundings;
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;

/// A triangle ready to be drawn. Seen from its front, its vertices turn counter-clockwise on the screen (so
/// [`crate::raster::area2`] is negative).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScreenTriangle {
    /// Snapped positions, 1/256 pixel.
    pub position: [Point; 3],
    /// 1/w at the vertices, > 0: the weights of perspective-correct interpolation. All 1 without perspective.
    pub inv_w: [f64; 3],
    /// Reversed depth, 0..=1, fitted to the drawn triangles: 1 = nearest, 0 = farthest of this frame. Affine on the
    /// screen. Only triangles that are drawn because a skip is switched off may lie outside the range.
    pub depth: [f64; 3],
    /// World positions.
    pub world: [DVec3; 3],
    /// World normals: unit at vertices of the mesh, a plain linear blend at vertices made by clipping.
    pub normal: [DVec3; 3],
    /// Texture coordinates, u to the right and v upwards; zero where the mesh has none.
    pub uv: [DVec2; 3],
    /// Index of the material.
    pub material: usize,
    /// Index of the object.
    pub object: usize,
    /// Index of the triangle in the object's mesh.
    pub face: usize,
}

impl ScreenTriangle {
    /// The unit normal of the flat face, towards its front; zero when the face has no area.
    #[must_use]
    pub fn face_normal(&self) -> DVec3 {
        let [a, b, c] = self.world;
        (b - a).cross(c - a).normalize_or_zero()
    }
}

/// What became of the triangles of the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TriangleCounts {
    /// In the scene.
    pub in_: u64,
    /// Of these, not drawn at all.
    pub culled: u64,
    /// Of these, cut by a plane.
    pub clipped: u64,
    /// In the list: clipping may make several of one.
    pub drawn: u64,
}

/// A scene prepared for one frame size.
#[derive(Clone, Debug)]
pub struct Prepared {
    /// Name of the scene.
    pub scene_name: String,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Colour of pixels that nothing covers.
    pub background: [u8; 3],
    /// What is drawn, in order: front faces of all objects, near objects first where that cannot change the frame, then back
    /// faces if they are not skipped.
    pub triangles: Vec<ScreenTriangle>,
    /// What became of the triangles of the scene.
    pub counts: TriangleCounts,
    /// Triangles skipped, and edges of wireframes, by reason.
    pub skipped: BTreeMap<&'static str, u64>,
    /// For every triangle, numbers of its vertices: corners with equal numbers are one vertex of one mesh, with the
    /// same attributes. [`UNSHARED`] where clipping or a missing normal made the corner the triangle's own.
    pub(crate) vertices: Vec<[u32; 3]>,
    /// What is drawn as wireframe, over the shaded frame.
    pub wires: Wires,
    /// Lights, materials and viewer.
    pub(crate) surroundings: Surroundings,
}

impl Prepared {
    /// Triangles that are on the screen already, as a benchmark or a test wants them: drawn in this order, nothing
    /// culled, no vertex shared.
    #[must_use]
    pub fn from_triangles(
        size: (u32, u32),
        background: [u8; 3],
        triangles: Vec<ScreenTriangle>,
        surroundings: Surroundings,
    ) -> Self {
        let count = triangles.len() as u64;
        Self {
            scene_name: "triangles".to_owned(),
            width: size.0,
            height: size.1,
            background,
            counts: TriangleCounts {
                in_: count,
                drawn: count,
                ..TriangleCounts::default()
            },
            skipped: BTreeMap::new(),
            vertices: vec![[UNSHARED; 3]; triangles.len()],
            triangles,
            wires: Wires::default(),
            surroundings,
        }
    }

    /// Whether any triangle that is drawn has a texture.
    #[must_use]
    pub fn is_textured(&self) -> bool {
        let s = &self.surroundings;
        s.has_textures()
            && self
                .triangles
                .iter()
                .any(|t| s.material(t.material).texture.is_some())
    }

    /// Whether the material of any drawn triangle has a bump map.
    #[must_use]
    pub fn has_bumps(&self) -> bool {
        let s = &self.surroundings;
        let bumpy = |t: &ScreenTriangle| s.material(t.material).bump.is_some();
        s.materials().iter().any(|m| m.bump.is_some()) && self.triangles.iter().any(bumpy)
    }

    /// Lights, materials and viewer.
    #[must_use]
    pub fn surroundings(&self) -> &Surroundings {
        &self.surroundings
    }
}

/// The vertex number of a corner that belongs to one triangle only.
pub(crate) const UNSHARED: u32 = u32::MAX;
