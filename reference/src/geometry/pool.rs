//! The transformed vertices of a scene, each made when a face first needs it: vertices that only culled faces use are
//! never transformed, and what a vertex needs on the screen is worked out once for all faces around it.

use super::camera::View;
use super::clip::{Planes, Vertex};
use crate::mesh::Mesh;
use crate::raster::Point;
use glam::{DMat3, DMat4, DVec2, DVec3};

/// Marks a vertex of a mesh that is not transformed yet.
const ABSENT: u32 = u32::MAX;

/// A vertex with what becomes of it on the screen.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    pub vertex: Vertex,
    /// Snapped; none where it cannot be. Meaningless for vertices outside the guard band.
    pub position: Option<Point>,
    /// 1/w. Meaningless for vertices outside the guard band.
    pub inv_w: f64,
    /// First the measure of nearness, in the end the reversed depth of the frame.
    pub depth: f64,
    /// Inside all planes of the guard band.
    pub inside: bool,
}

/// How an object stands in the world.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stand {
    transform: DMat4,
    /// Takes normals, which are covariant, to the world: the inverse transpose, which keeps them outward.
    turn: DMat3,
    /// The transform turns the winding around.
    pub mirrored: bool,
}

impl Stand {
    pub(super) fn new(transform: DMat4) -> Self {
        let linear = DMat3::from_mat4(transform);
        Self {
            transform,
            turn: linear.try_inverse().map_or(linear, |i| i.transpose()),
            mirrored: mirrors(transform),
        }
    }
}

/// Whether a transform turns the winding around.
pub(super) fn mirrors(transform: DMat4) -> bool {
    DMat3::from_mat4(transform).determinant() < 0.0
}

/// Transformed vertices, and where those of the object at hand are.
#[derive(Debug)]
pub(super) struct Pool {
    pub view: View,
    pub guard: Planes,
    pub placed: Vec<Placed>,
    /// For each vertex of the mesh at hand its place, or [`ABSENT`].
    place: Vec<u32>,
}

impl Pool {
    pub(super) fn new(view: View) -> Self {
        Self {
            guard: Planes::guard(&view),
            view,
            placed: Vec::new(),
            place: Vec::new(),
        }
    }

    /// Turns to another mesh, of which nothing is transformed.
    pub(super) fn begin(&mut self, mesh: &Mesh) {
        self.place.clear();
        self.place.resize(mesh.positions.len(), ABSENT);
        self.placed.reserve(mesh.positions.len());
    }

    /// Vertices of the mesh at hand that were never needed.
    pub(super) fn untouched(&self) -> u64 {
        self.place.iter().filter(|p| **p == ABSENT).count() as u64
    }

    /// The place of a vertex of the mesh at hand.
    #[inline]
    pub(super) fn vertex(&mut self, mesh: &Mesh, stand: &Stand, index: u32) -> u32 {
        match self.place[index as usize] {
            ABSENT => self.transform(mesh, stand, index as usize),
            place => place,
        }
    }

    fn transform(&mut self, mesh: &Mesh, stand: &Stand, index: usize) -> u32 {
        let world = stand.transform.transform_point3(mesh.positions[index]);
        let place = self.add(Vertex {
            clip: self.view.clip(world),
            world,
            normal: (stand.turn * mesh.normals[index]).normalize_or_zero(),
            // Coordinates are those of corners, not of vertices, until a face is cut.
            uv: DVec2::ZERO,
        });
        self.place[index] = place;
        place
    }

    /// Adds a vertex and says where it is.
    #[inline]
    pub(super) fn add(&mut self, vertex: Vertex) -> u32 {
        let c = vertex.clip;
        let inside = (0..Planes::COUNT).all(|i| self.guard.distance(i, c) >= 0.0);
        self.placed.push(Placed {
            vertex,
            position: self.view.screen(c),
            inv_w: 1.0 / c.w,
            depth: self.view.nearness(c),
            inside,
        });
        (self.placed.len() - 1) as u32
    }

    #[inline]
    pub(super) fn get(&self, place: u32) -> &Placed {
        &self.placed[place as usize]
    }

    /// The normal of the flat face, not normalised.
    #[inline]
    pub(super) fn face_normal(&self, [a, b, c]: [u32; 3]) -> DVec3 {
        let world = |i| self.get(i).vertex.world;
        let (a, b, c) = (world(a), world(b), world(c));
        (b - a).cross(c - a)
    }
}
