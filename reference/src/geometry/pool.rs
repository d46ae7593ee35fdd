//! The transformed vertices that a part of an object's faces needs, each made when a face first needs it: vertices that
//! only culled faces use are never transformed, and what a vertex needs on the screen is worked out once for all faces
//! around it.

use super::camera::{Clip, View};
use super::clip::Planes;
use crate::mesh::Mesh;
use crate::raster::Point;
use glam::{DMat3, DMat4, DVec3};

/// Marks a vertex of the mesh that is not transformed yet.
const ABSENT: u32 = u32::MAX;

/// A vertex with what becomes of it on the screen.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    pub world: DVec3,
    /// Unit, or zero where the mesh has none.
    pub normal: DVec3,
    /// 1/w. Meaningless for vertices outside the guard band.
    pub inv_w: f64,
    /// The measure of nearness, not yet fitted to the frame.
    pub depth: f64,
    /// Snapped; none where it cannot be. Meaningless for vertices outside the guard band.
    pub position: Option<Point>,
    /// Inside all planes of the guard band.
    pub inside: bool,
}

impl Placed {
    #[inline]
    pub(super) fn new(
        view: &View,
        guard: &Planes,
        clip: Clip,
        world: DVec3,
        normal: DVec3,
    ) -> Self {
        Self {
            world,
            normal,
            inv_w: 1.0 / clip.w,
            depth: view.nearness(clip),
            position: view.screen(clip),
            inside: (0..Planes::COUNT).all(|i| guard.distance(i, clip) >= 0.0),
        }
    }
}

/// The normal of the flat face, not normalised.
#[inline]
pub(super) fn face_normal([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a)
}

/// How an object stands in the world.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stand {
    transform: DMat4,
    /// Takes normals, which are covariant, to the world: the inverse transpose, which keeps them outward.
    turn: DMat3,
    /// The transform turns the winding around.
    mirrored: bool,
}

impl Stand {
    pub(super) fn new(transform: DMat4) -> Self {
        let linear = DMat3::from_mat4(transform);
        Self {
            transform,
            turn: linear.try_inverse().map_or(linear, |i| i.transpose()),
            mirrored: linear.determinant() < 0.0,
        }
    }

    /// The corners of a face in the order in which they turn in the world.
    #[inline]
    pub(super) fn ordered<T: Copy>(&self, [a, b, c]: [T; 3]) -> [T; 3] {
        if self.mirrored {
            [a, c, b]
        } else {
            [a, b, c]
        }
    }
}

/// For each vertex of a mesh its place in the pool, or [`ABSENT`]; kept from pool to pool, all absent in between.
#[derive(Debug, Default)]
pub(super) struct Places(Vec<u32>);

/// Transformed vertices of one object.
#[derive(Debug, Default)]
pub(super) struct Pool {
    placed: Vec<Placed>,
    /// The number in the mesh of each.
    numbers: Vec<u32>,
    /// Some have no normal.
    pub bare: bool,
}

impl Pool {
    /// For so many vertices of a mesh.
    pub(super) fn new(mesh: &Mesh, room: usize, places: &mut Places) -> Self {
        if places.0.len() < mesh.positions.len() {
            places.0.resize(mesh.positions.len(), ABSENT);
        }
        let room = room.min(mesh.positions.len());
        Self {
            placed: Vec::with_capacity(room),
            numbers: Vec::with_capacity(room),
            bare: false,
        }
    }

    /// The place of a vertex of the mesh, which is transformed when it has none yet.
    #[inline]
    pub(super) fn place(
        &mut self,
        places: &mut Places,
        number: u32,
        transform: impl FnOnce() -> Placed,
    ) -> u32 {
        let place = &mut places.0[number as usize];
        if *place == ABSENT {
            *place = self.placed.len() as u32;
            let placed = transform();
            self.bare |= placed.normal == DVec3::ZERO;
            self.placed.push(placed);
            self.numbers.push(number);
        }
        *place
    }

    /// Forgets where vertices are, for the next pool.
    pub(super) fn leave(&self, places: &mut Places) {
        for number in &self.numbers {
            places.0[*number as usize] = ABSENT;
        }
    }

    #[inline]
    pub(super) fn get(&self, place: u32) -> &Placed {
        &self.placed[place as usize]
    }

    /// The number in the mesh of the vertex at a place.
    #[inline]
    pub(super) fn number(&self, place: u32) -> u32 {
        self.numbers[place as usize]
    }

    /// The numbers in the mesh of all vertices.
    pub(super) fn numbers(&self) -> &[u32] {
        &self.numbers
    }
}

/// Transforms a vertex of a mesh.
pub(super) fn transform(
    view: &View,
    guard: &Planes,
    stand: &Stand,
    mesh: &Mesh,
    number: u32,
) -> Placed {
    let world = stand
        .transform
        .transform_point3(mesh.positions[number as usize]);
    let normal = (stand.turn * mesh.normals[number as usize]).normalize_or_zero();
    Placed::new(view, guard, view.clip(world), world, normal)
}
