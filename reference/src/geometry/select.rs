//! The pass over a part of the faces of an object: which triangles are drawn, and why the others are not. Parts know
//! nothing of each other, so they can be looked at at the same time; a vertex that faces of two parts share is
//! transformed for both, to the same bits.

use super::camera::View;
use super::clip::{clip, Planes, Vertex};
use super::cull::outside;
use super::pool::{face_normal, transform, Placed, Places, Pool};
use super::selected::{Piece, Reason, Selected, Subject};
use crate::raster::{area2, covers_any, Point, Viewport, SUBPIXELS};
use crate::skips::{self, Skips};
use glam::DVec3;
use smallvec::SmallVec;
use std::ops::Range;

/// The skips that are asked for every triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct SkipsOn {
    pub vertex: bool,
    pub back_face: bool,
    outside: bool,
    uncovered: bool,
}

impl SkipsOn {
    pub(super) fn new(skips: &Skips) -> Self {
        Self {
            vertex: skips.is_on(skips::VERTEX),
            back_face: skips.is_on(skips::BACK_FACE),
            outside: skips.is_on(skips::OUTSIDE),
            uncovered: skips.is_on(skips::UNCOVERED),
        }
    }
}

/// What decides about every triangle of the scene.
#[derive(Debug)]
pub(super) struct Selection {
    pub view: View,
    pub guard: Planes,
    pub frustum: Planes,
    pub viewport: Viewport,
    pub skips: SkipsOn,
}

/// What is kept from part to part by whoever looks at them.
#[derive(Debug, Default)]
pub(super) struct Memory {
    places: Places,
    polygon: Vec<Vertex>,
}

impl Selection {
    /// Looks at some faces of an object.
    pub(super) fn select(
        &self,
        subject: &Subject,
        faces: Range<usize>,
        memory: &mut Memory,
    ) -> Selected {
        let mesh = &subject.object.mesh;
        let Memory { places, polygon } = memory;
        let pool = Pool::new(mesh, faces.len(), places);
        let mut out = Selected::new(pool, faces.len());
        let made = |i| transform(&self.view, &self.guard, &subject.stand, mesh, i);
        if !self.skips.vertex {
            // As many of all vertices as these faces are of all faces.
            let (vertices, all) = (mesh.positions.len() as u64, mesh.triangles.len() as u64);
            let share = |face: usize| (vertices * face as u64 / all.max(1)) as u32;
            for i in share(faces.start)..share(faces.end) {
                out.pool.place(places, i, || made(i));
            }
        }
        let mut back = 0;
        for face in faces {
            let t = mesh.triangles[face];
            if let Some(f) = &subject.facing {
                if f.is_back(t.map(|i| mesh.positions[i as usize])) {
                    back += 1;
                    continue;
                }
            }
            let corners = subject.stand.ordered(t);
            let at = corners.map(|i| out.pool.place(places, i, || made(i)));
            if let Err(reason) = self.face(subject, at, face as u32, polygon, &mut out) {
                out.skipped[reason as usize] += 1;
            }
        }
        out.skipped[Reason::BackFace as usize] += back;
        out.pool.leave(places);
        out
    }

    /// Keeps what is visible of a face, or says why nothing is.
    #[inline]
    fn face(
        &self,
        subject: &Subject,
        places: [u32; 3],
        face: u32,
        polygon: &mut Vec<Vertex>,
        out: &mut Selected,
    ) -> Result<(), Reason> {
        let v = places.map(|i| out.pool.get(i));
        let flat = face_normal(v.map(|v| v.world));
        if flat == DVec3::ZERO || !flat.is_finite() {
            return Err(Reason::Degenerate);
        }
        if !v.iter().all(|v| v.inside) {
            let v = v.map(|v| *v);
            return self.cut(subject, v, face, polygon, out);
        }
        let back = self.judge(v, &mut out.range)?;
        out.put(Piece::Whole { places, face }, back);
        Ok(())
    }

    /// As [`Selection::face`] for a triangle that reaches out of the guard band.
    fn cut(
        &self,
        subject: &Subject,
        v: [Placed; 3],
        face: u32,
        polygon: &mut Vec<Vertex>,
        out: &mut Selected,
    ) -> Result<(), Reason> {
        let clips = v.map(|v| self.view.clip(v.world));
        if self.skips.outside && outside(&self.frustum, &clips) {
            return Err(Reason::Outside);
        }
        let flat = face_normal(v.map(|v| v.world)).normalize_or_zero();
        let uv = subject.uv(face);
        let corner = |i: usize| Vertex {
            clip: clips[i],
            world: v[i].world,
            normal: if v[i].normal == DVec3::ZERO {
                flat
            } else {
                v[i].normal
            },
            uv: uv[i],
        };
        clip(&self.guard, [0, 1, 2].map(corner), polygon);
        let placed: SmallVec<[Placed; 9]> = polygon
            .iter()
            .map(|v| Placed::new(&self.view, &self.guard, v.clip, v.world, v.normal))
            .collect();
        let mut reason = Reason::ClippedAway;
        let mut drawn = false;
        for k in 2..placed.len() {
            let corners = [0, k - 1, k];
            let v = corners.map(|i| &placed[i]);
            match self.judge(v, &mut out.range) {
                Ok(back) => {
                    let piece = Piece::Cut(out.cut.len() as u32);
                    let uv = corners.map(|i| polygon[i].uv);
                    let depth = v.map(|v| v.depth);
                    out.cut.push(subject.triangle(v, depth, uv, face, true));
                    out.put(piece, back);
                    drawn = true;
                }
                Err(why) => reason = why,
            }
        }
        if drawn {
            out.clipped += 1;
            return Ok(());
        }
        Err(reason)
    }

    /// Whether a triangle inside the guard band shows its back, or why it is not drawn.
    #[inline]
    fn judge(&self, [p, q, r]: [&Placed; 3], range: &mut [f64; 2]) -> Result<bool, Reason> {
        let (Some(a), Some(b), Some(c)) = (p.position, q.position, r.position) else {
            return Err(Reason::Degenerate);
        };
        let position = [a, b, c];
        let area = area2(position);
        if area == 0 {
            return Err(Reason::Degenerate);
        }
        let back = area > 0;
        if back && self.skips.back_face {
            return Err(Reason::BackFace);
        }
        if self.skips.outside && self.beside(position) {
            return Err(Reason::Outside);
        }
        let covers = covers_any(position, self.viewport);
        if !covers && self.skips.uncovered {
            return Err(Reason::Uncovered);
        }
        if covers && !back {
            let [lo, hi] = *range;
            let least = p.depth.min(q.depth).min(r.depth);
            let most = p.depth.max(q.depth).max(r.depth);
            *range = [lo.min(least), hi.max(most)];
        }
        Ok(back)
    }

    /// Whether the snapped triangle lies wholly on one side of the viewport.
    fn beside(&self, p: [Point; 3]) -> bool {
        let edge = |pixels: u32| pixels as i32 * SUBPIXELS;
        let (w, h) = (edge(self.viewport.width), edge(self.viewport.height));
        let [x, y] = [p.map(|q| q.x), p.map(|q| q.y)];
        let most = |v: [i32; 3]| v[0].max(v[1]).max(v[2]);
        let least = |v: [i32; 3]| v[0].min(v[1]).min(v[2]);
        most(x) <= 0 || least(x) >= w || most(y) <= 0 || least(y) >= h
    }
}
