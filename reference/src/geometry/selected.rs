//! What is drawn of some faces of an object, and why the others are not.

use super::facing::Facing;
use super::pool::{face_normal, Placed, Pool, Stand};
use super::ScreenTriangle;
use crate::scene::Object;
use crate::skips;
use glam::{DVec2, DVec3};

/// Why a triangle or a piece of one is not drawn; of several pieces, the last reason stands for the triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reason {
    BackFace,
    ClippedAway,
    Degenerate,
    Outside,
    Uncovered,
}

impl Reason {
    /// In the order of declaration, with the names that they are counted under.
    pub(super) const NAMES: [&'static str; 5] = [
        skips::BACK_FACE,
        skips::CLIPPED_AWAY,
        skips::DEGENERATE,
        skips::OUTSIDE,
        skips::UNCOVERED,
    ];
}

/// A triangle that is drawn.
#[derive(Clone, Copy, Debug)]
pub(super) enum Piece {
    /// A face as it is, with the places of its vertices in the pool.
    Whole { places: [u32; 3], face: u32 },
    /// Made by clipping: its number among those that were.
    Cut(u32),
}

/// An object that may be seen.
#[derive(Debug)]
pub(super) struct Subject<'a> {
    pub object: &'a Object,
    /// Its number in the scene.
    pub index: usize,
    pub stand: Stand,
    pub facing: Option<Facing>,
}

impl Subject<'_> {
    /// The texture coordinates at the corners of a face; zero where the mesh has none.
    pub(super) fn uv(&self, face: u32) -> [DVec2; 3] {
        match self.object.mesh.uv.get(face as usize) {
            Some(uv) => self.stand.ordered(*uv),
            None => [DVec2::ZERO; 3],
        }
    }

    /// A triangle of a face; `bare` where a vertex may have no normal.
    #[inline(always)]
    pub(super) fn triangle(
        &self,
        [a, b, c]: [&Placed; 3],
        depth: [f64; 3],
        uv: [DVec2; 3],
        face: u32,
        bare: bool,
    ) -> ScreenTriangle {
        let mut normal = [a.normal, b.normal, c.normal];
        if bare {
            let flat = face_normal([a.world, b.world, c.world]).normalize_or_zero();
            for n in normal.iter_mut().filter(|n| **n == DVec3::ZERO) {
                *n = flat;
            }
        }
        ScreenTriangle {
            // Pieces without positions are not kept.
            position: [
                a.position.unwrap_or_default(),
                b.position.unwrap_or_default(),
                c.position.unwrap_or_default(),
            ],
            inv_w: [a.inv_w, b.inv_w, c.inv_w],
            depth,
            world: [a.world, b.world, c.world],
            normal,
            uv,
            material: self.object.material,
            object: self.index,
            face: face as usize,
        }
    }
}

/// What is drawn of some faces of an object.
#[derive(Debug)]
pub(super) struct Selected {
    pub pool: Pool,
    pub front: Vec<Piece>,
    pub back: Vec<Piece>,
    pub cut: Vec<ScreenTriangle>,
    /// Least and greatest nearness of what is visible whatever is skipped: front faces that cover a pixel.
    pub range: [f64; 2],
    /// Faces that were cut.
    pub clipped: u64,
    /// Faces not drawn at all, by [`Reason`].
    pub skipped: [u64; Reason::NAMES.len()],
}

impl Selected {
    /// For so many faces, of which none is looked at yet.
    pub(super) fn new(pool: Pool, faces: usize) -> Self {
        Self {
            pool,
            // About half of the faces of a closed object show their front.
            front: Vec::with_capacity(faces / 2),
            back: Vec::new(),
            cut: Vec::new(),
            range: [f64::INFINITY, f64::NEG_INFINITY],
            clipped: 0,
            skipped: [0; Reason::NAMES.len()],
        }
    }

    /// The finished triangle of a piece, its depth mapped by `fit`.
    #[inline(always)]
    pub(super) fn triangle(
        &self,
        subject: &Subject,
        piece: Piece,
        fit: impl Fn(f64) -> f64,
    ) -> ScreenTriangle {
        match piece {
            Piece::Whole { places, face } => {
                let [a, b, c] = places.map(|i| self.pool.get(i));
                let depth = [fit(a.depth), fit(b.depth), fit(c.depth)];
                subject.triangle([a, b, c], depth, subject.uv(face), face, self.pool.bare)
            }
            Piece::Cut(k) => {
                let t = self.cut[k as usize];
                let depth = t.depth.map(fit);
                ScreenTriangle { depth, ..t }
            }
        }
    }

    /// The numbers in the mesh of the vertices of a piece; none where a vertex is its own.
    #[inline]
    pub(super) fn numbers(&self, piece: Piece) -> [Option<u32>; 3] {
        match piece {
            Piece::Whole { places, .. } => places.map(|i| {
                let own = self.pool.bare && self.pool.get(i).normal == DVec3::ZERO;
                (!own).then(|| self.pool.number(i))
            }),
            Piece::Cut(_) => [None; 3],
        }
    }

    #[inline]
    pub(super) fn put(&mut self, piece: Piece, back: bool) {
        let list = if back {
            &mut self.back
        } else {
            &mut self.front
        };
        list.push(piece);
    }
}
