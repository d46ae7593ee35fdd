//! The pass over all triangles that makes a [`Prepared`]: first which are drawn, on vertices that are transformed once
//! and only when a face that may be seen needs them; then, when the depth range is known, the list itself.

use super::camera::View;
use super::clip::{clip, Planes, Vertex};
use super::cull::{box_outside, corners, outside};
use super::facing::Facing;
use super::pool::{mirrors, Pool, Stand};
use super::{Prepared, ScreenTriangle, TriangleCounts, Wires, UNSHARED};
use crate::raster::{area2, covers_any, Point, Viewport};
use crate::scene::{Draw, Object, Scene, SceneError, IMAGE_LIMIT};
use crate::shade::reach::missing;
use crate::shade::Surroundings;
use crate::skips::{
    Skips, BACK_FACE, CLIPPED_AWAY, DEGENERATE, FRUSTUM, OUTSIDE, SPOT, UNCOVERED, VERTEX,
};
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;

/// Why a triangle or a piece of one is not drawn; of several pieces, the last reason stands for the triangle.
type Reason = &'static str;

/// A triangle that is drawn.
#[derive(Clone, Copy, Debug)]
struct Piece {
    /// Places in the pool.
    places: [u32; 3],
    object: u32,
    face: u32,
    /// Made by clipping: its vertices are its own.
    cut: bool,
}

struct Pass<'a> {
    pool: Pool,
    frustum: Planes,
    viewport: Viewport,
    skips: SkipsOn,
    front: Vec<Piece>,
    back: Vec<Piece>,
    /// Least and greatest nearness of what is visible whatever is skipped: front faces that cover a pixel.
    range: [f64; 2],
    counts: TriangleCounts,
    skipped: BTreeMap<Reason, u64>,
    polygon: Vec<Vertex>,
    scene: &'a Scene,
}

/// The skips that are asked for every triangle.
#[derive(Clone, Copy)]
struct SkipsOn {
    frustum: bool,
    vertex: bool,
    back_face: bool,
    outside: bool,
    uncovered: bool,
}

impl Prepared {
    /// Prepares a scene for its own frame size or another one.
    ///
    /// # Errors
    /// A frame size of zero or beyond [`IMAGE_LIMIT`].
    pub fn new(scene: &Scene, size: Option<(u32, u32)>, skips: &Skips) -> Result<Self, SceneError> {
        let (width, height) = size.unwrap_or((scene.image.width, scene.image.height));
        if width == 0 || height == 0 || width > IMAGE_LIMIT || height > IMAGE_LIMIT {
            return Err(SceneError::new(
                &scene.file,
                1,
                "size",
                &format!("is {width}x{height}"),
                &format!("expected 1x1 to {IMAGE_LIMIT}x{IMAGE_LIMIT}"),
            ));
        }
        let view = View::new(&scene.camera, width, height);
        let mut pass = Pass {
            pool: Pool::new(view),
            frustum: Planes::frustum(&view),
            viewport: Viewport { width, height },
            skips: SkipsOn {
                frustum: skips.is_on(FRUSTUM),
                vertex: skips.is_on(VERTEX),
                back_face: skips.is_on(BACK_FACE),
                outside: skips.is_on(OUTSIDE),
                uncovered: skips.is_on(UNCOVERED),
            },
            front: Vec::new(),
            back: Vec::new(),
            range: [f64::INFINITY, f64::NEG_INFINITY],
            counts: TriangleCounts::default(),
            skipped: BTreeMap::new(),
            polygon: Vec::new(),
            scene,
        };
        for (i, object) in scene.objects.iter().enumerate() {
            if object.draw == Draw::Shaded {
                pass.object(i as u32, object);
            }
        }
        pass.fit_depth();
        // Back faces behind the front faces in order, so that of equal depths the front wins.
        let mut pieces = std::mem::take(&mut pass.front);
        pieces.append(&mut pass.back);
        let triangles: Vec<_> = pieces.iter().map(|p| pass.triangle(p)).collect();
        let vertices = pieces.iter().map(|p| pass.numbers(p)).collect();
        pass.counts.drawn = triangles.len() as u64;
        let surroundings = Surroundings::new(scene).skipping_spots(skips.is_on(SPOT));
        let dark = missing(&surroundings, triangles.iter().map(|t| &t.world));
        if dark > 0 {
            pass.skipped.insert(SPOT, dark);
        }
        let wires = Wires::new(scene, &view, skips, &mut pass.skipped);
        Ok(Self {
            scene_name: scene.name.clone(),
            width,
            height,
            background: scene.image.background,
            triangles,
            counts: pass.counts,
            skipped: pass.skipped,
            vertices,
            surroundings,
            wires,
        })
    }
}

/// Counts what there is to count; reasons that do not occur are left out.
fn count(skipped: &mut BTreeMap<Reason, u64>, reason: Reason, n: u64) {
    if n > 0 {
        *skipped.entry(reason).or_default() += n;
    }
}

impl Pass<'_> {
    fn skip(&mut self, reason: Reason, triangles: u64) {
        self.counts.culled += triangles;
        count(&mut self.skipped, reason, triangles);
    }

    fn object(&mut self, index: u32, object: &Object) {
        let mesh = &object.mesh;
        self.counts.in_ += mesh.triangles.len() as u64;
        let around = corners(&mesh.positions);
        let beside = |c| box_outside(&self.pool.view, object.transform, c);
        if self.skips.frustum && around.as_ref().is_some_and(beside) {
            self.skip(FRUSTUM, mesh.triangles.len() as u64);
            return;
        }
        let stand = Stand::new(object.transform);
        self.pool.begin(mesh);
        let facing = around
            .filter(|_| self.skips.vertex && self.skips.back_face)
            .and_then(|c| Facing::new(&self.pool.view, &self.pool.guard, object.transform, &c));
        if !self.skips.vertex {
            for i in 0..mesh.positions.len() {
                self.pool.vertex(mesh, &stand, i as u32);
            }
        }
        // About half of the faces of a closed object show their front.
        self.front.reserve(mesh.triangles.len() / 2);
        let mut back = 0;
        for (face, t) in mesh.triangles.iter().enumerate() {
            let [i, j, k] = if stand.mirrored {
                [t[0], t[2], t[1]]
            } else {
                *t
            };
            if let Some(f) = &facing {
                let at = |i: u32| mesh.positions[i as usize];
                if f.is_back([at(t[0]), at(t[1]), at(t[2])]) {
                    back += 1;
                    continue;
                }
            }
            let mut place = |i| self.pool.vertex(mesh, &stand, i);
            let piece = Piece {
                places: [place(i), place(j), place(k)],
                object: index,
                face: face as u32,
                cut: false,
            };
            if let Some(reason) = self.place(piece) {
                self.skip(reason, 1);
            }
        }
        self.skip(BACK_FACE, back);
        if self.skips.vertex {
            count(&mut self.skipped, VERTEX, self.pool.untouched());
        }
    }

    /// Keeps what is visible of a triangle, or says why nothing is.
    fn place(&mut self, piece: Piece) -> Option<Reason> {
        let flat = self.pool.face_normal(piece.places);
        if flat == DVec3::ZERO || !flat.is_finite() {
            return Some(DEGENERATE);
        }
        if piece.places.iter().all(|i| self.pool.get(*i).inside) {
            return self.keep(piece).err();
        }
        self.cut(piece, flat)
    }

    /// As [`Pass::place`] for a triangle that reaches out of the guard band.
    fn cut(&mut self, piece: Piece, flat: DVec3) -> Option<Reason> {
        let mut vertices = piece.places.map(|i| self.pool.get(i).vertex);
        if self.skips.outside && outside(&self.frustum, &vertices.map(|v| v.clip)) {
            return Some(OUTSIDE);
        }
        for (v, uv) in vertices.iter_mut().zip(self.uv(&piece)) {
            v.uv = uv;
            if v.normal == DVec3::ZERO {
                v.normal = flat.normalize_or_zero();
            }
        }
        let mut polygon = std::mem::take(&mut self.polygon);
        clip(&self.pool.guard, vertices, &mut polygon);
        let mut reason = (polygon.len() < 3).then_some(CLIPPED_AWAY);
        let mut drawn = false;
        if polygon.len() >= 3 {
            let places: Vec<u32> = polygon.iter().map(|v| self.pool.add(*v)).collect();
            for k in 2..places.len() {
                let part = Piece {
                    places: [places[0], places[k - 1], places[k]],
                    cut: true,
                    ..piece
                };
                match self.keep(part) {
                    Ok(()) => drawn = true,
                    Err(why) => reason = Some(why),
                }
            }
        }
        self.polygon = polygon;
        if drawn {
            self.counts.clipped += 1;
            return None;
        }
        reason
    }

    /// Keeps a triangle inside the guard band, or says why it is not drawn.
    fn keep(&mut self, piece: Piece) -> Result<(), Reason> {
        let [p, q, r] = piece.places;
        let (p, q, r) = (self.pool.get(p), self.pool.get(q), self.pool.get(r));
        let (Some(a), Some(b), Some(c)) = (p.position, q.position, r.position) else {
            return Err(DEGENERATE);
        };
        let position = [a, b, c];
        let area = area2(position);
        if area == 0 {
            return Err(DEGENERATE);
        }
        let back = area > 0;
        if back && self.skips.back_face {
            return Err(BACK_FACE);
        }
        if self.skips.outside && self.beside(position) {
            return Err(OUTSIDE);
        }
        let covers = covers_any(position, self.viewport);
        if !covers && self.skips.uncovered {
            return Err(UNCOVERED);
        }
        if covers && !back {
            let [lo, hi] = self.range;
            let least = p.depth.min(q.depth).min(r.depth);
            let most = p.depth.max(q.depth).max(r.depth);
            self.range = [lo.min(least), hi.max(most)];
        }
        if back {
            self.back.push(piece);
        } else {
            self.front.push(piece);
        }
        Ok(())
    }

    /// Whether the snapped triangle lies wholly on one side of the viewport.
    fn beside(&self, p: [Point; 3]) -> bool {
        let edge = |pixels: u32| pixels as i32 * crate::raster::SUBPIXELS;
        let (w, h) = (edge(self.viewport.width), edge(self.viewport.height));
        let [x, y] = [p.map(|q| q.x), p.map(|q| q.y)];
        let most = |v: [i32; 3]| v[0].max(v[1]).max(v[2]);
        let least = |v: [i32; 3]| v[0].min(v[1]).min(v[2]);
        most(x) <= 0 || least(x) >= w || most(y) <= 0 || least(y) >= h
    }

    /// Maps nearness from the range to 0..=1; a frame of one depth is all nearest. The range does not depend on what is
    /// skipped, so neither does the frame; triangles that are drawn only because a skip is off may lie outside it.
    fn fit_depth(&mut self) {
        let [lo, hi] = self.range;
        for p in &mut self.pool.placed {
            p.depth = if hi > lo {
                (p.depth - lo) / (hi - lo)
            } else {
                1.0
            };
        }
    }

    /// The finished triangle of a piece.
    fn triangle(&self, piece: &Piece) -> ScreenTriangle {
        let [p, q, r] = piece.places;
        let (p, q, r) = (self.pool.get(p), self.pool.get(q), self.pool.get(r));
        let mut normal = [p.vertex.normal, q.vertex.normal, r.vertex.normal];
        if normal.contains(&DVec3::ZERO) {
            let flat = self.pool.face_normal(piece.places).normalize_or_zero();
            for n in normal.iter_mut().filter(|n| **n == DVec3::ZERO) {
                *n = flat;
            }
        }
        ScreenTriangle {
            // Pieces without positions are not kept.
            position: [p, q, r].map(|v| v.position.unwrap_or_default()),
            inv_w: [p.inv_w, q.inv_w, r.inv_w],
            depth: [p.depth, q.depth, r.depth],
            world: [p.vertex.world, q.vertex.world, r.vertex.world],
            normal,
            uv: if piece.cut {
                [p.vertex.uv, q.vertex.uv, r.vertex.uv]
            } else {
                self.uv(piece)
            },
            material: self.scene.objects[piece.object as usize].material,
            object: piece.object as usize,
            face: piece.face as usize,
        }
    }

    /// The texture coordinates at the corners of the face that a piece is of; zero where the mesh has none.
    fn uv(&self, piece: &Piece) -> [DVec2; 3] {
        let object = &self.scene.objects[piece.object as usize];
        match object.mesh.uv.get(piece.face as usize) {
            Some([a, b, c]) if mirrors(object.transform) => [*a, *c, *b],
            Some(uv) => *uv,
            None => [DVec2::ZERO; 3],
        }
    }

    /// The vertex numbers of a piece: places in the pool, where the vertex is the mesh's.
    fn numbers(&self, piece: &Piece) -> [u32; 3] {
        piece.places.map(|i| {
            let own = piece.cut || self.pool.get(i).vertex.normal == DVec3::ZERO;
            if own {
                UNSHARED
            } else {
                i
            }
        })
    }
}
