//! The pass over all triangles that makes a [`Prepared`].

use super::camera::View;
use super::clip::{clip, Planes, Vertex};
use super::cull::outside_frustum;
use super::{Prepared, ScreenTriangle, TriangleCounts, UNSHARED};
use crate::raster::{area2, Viewport, Walk};
use crate::scene::{Object, Scene, SceneError, IMAGE_LIMIT};
use crate::shade::Surroundings;
use crate::skips::{Skips, BACK_FACE, CLIPPED_AWAY, DEGENERATE, FRUSTUM, OUTSIDE, UNCOVERED};
use glam::{DMat3, DVec3};
use std::collections::BTreeMap;

/// Why a triangle or a piece of one is not drawn; of several pieces, the last reason stands for the triangle.
type Reason = &'static str;

struct Pass<'a> {
    view: View,
    viewport: Viewport,
    skips: &'a Skips,
    front: Vec<(ScreenTriangle, [u32; 3])>,
    back: Vec<(ScreenTriangle, [u32; 3])>,
    /// Vertices of the objects before this one.
    vertices: usize,
    /// Least and greatest nearness of what is visible whatever is skipped: front faces that cover a pixel.
    range: [f64; 2],
    counts: TriangleCounts,
    skipped: BTreeMap<Reason, u64>,
    polygon: Vec<Vertex>,
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
        let mut pass = Pass {
            view: View::new(&scene.camera, width, height),
            viewport: Viewport { width, height },
            skips,
            front: Vec::new(),
            back: Vec::new(),
            vertices: 0,
            range: [f64::INFINITY, f64::NEG_INFINITY],
            counts: TriangleCounts::default(),
            skipped: BTreeMap::new(),
            polygon: Vec::new(),
        };
        for (i, object) in scene.objects.iter().enumerate() {
            pass.object(i, object);
        }
        // Back faces behind the front faces in order, so that of equal depths the front wins.
        let all = pass.front.into_iter().chain(pass.back);
        let (mut triangles, vertices): (Vec<_>, Vec<_>) = all.unzip();
        fit_depth(&mut triangles, pass.range);
        pass.counts.drawn = triangles.len() as u64;
        Ok(Self {
            scene_name: scene.name.clone(),
            width,
            height,
            background: scene.image.background,
            triangles,
            counts: pass.counts,
            skipped: pass.skipped,
            vertices,
            surroundings: Surroundings::new(scene),
        })
    }
}

/// Maps nearness from `range` to 0..=1; a frame of one depth is all nearest. The range does not depend on what is
/// skipped, so neither does the frame; triangles that are drawn only because a skip is off may lie outside it.
fn fit_depth(triangles: &mut [ScreenTriangle], [lo, hi]: [f64; 2]) {
    for d in triangles.iter_mut().flat_map(|t| &mut t.depth) {
        *d = if hi > lo { (*d - lo) / (hi - lo) } else { 1.0 };
    }
}

impl Pass<'_> {
    fn object(&mut self, index: usize, object: &Object) {
        let mesh = &object.mesh;
        let total = mesh.triangles.len() as u64;
        self.counts.in_ += total;
        let world: Vec<DVec3> = mesh
            .positions
            .iter()
            .map(|p| object.transform.transform_point3(*p))
            .collect();
        if self.skips.is_on(FRUSTUM) && outside_frustum(&self.view, &world) {
            self.counts.culled += total;
            *self.skipped.entry(FRUSTUM).or_default() += total;
            return;
        }
        // Normals are covariant; a mirroring transform turns the winding (the inverse transpose keeps normals outward).
        let linear = DMat3::from_mat4(object.transform);
        let turn = linear.try_inverse().map_or(linear, |i| i.transpose());
        let mirrored = linear.determinant() < 0.0;
        let normals: Vec<DVec3> = mesh
            .normals
            .iter()
            .map(|n| (turn * *n).normalize_or_zero())
            .collect();
        for (face, t) in mesh.triangles.iter().enumerate() {
            let corner = if mirrored { [t[0], t[2], t[1]] } else { *t }.map(|i| i as usize);
            let number = |i: usize| {
                let own = normals[i] == DVec3::ZERO;
                let n = u32::try_from(self.vertices + i).unwrap_or(UNSHARED);
                if own {
                    UNSHARED
                } else {
                    n
                }
            };
            let names = (index, object.material, face);
            let numbers = corner.map(number);
            let reason = self.triangle(
                names,
                corner.map(|i| world[i]),
                corner.map(|i| normals[i]),
                numbers,
            );
            if let Some(reason) = reason {
                self.counts.culled += 1;
                *self.skipped.entry(reason).or_default() += 1;
            }
        }
        self.vertices += mesh.positions.len();
    }

    /// Draws what is visible of a triangle, or says why nothing is.
    fn triangle(
        &mut self,
        (object, material, face): (usize, usize, usize),
        world: [DVec3; 3],
        mut normal: [DVec3; 3],
        numbers: [u32; 3],
    ) -> Option<Reason> {
        let flat = (world[1] - world[0]).cross(world[2] - world[0]);
        if flat == DVec3::ZERO || !flat.is_finite() {
            return Some(DEGENERATE);
        }
        for n in &mut normal {
            if *n == DVec3::ZERO {
                *n = flat.normalize_or_zero();
            }
        }
        let vertices = [0, 1, 2].map(|i| Vertex {
            clip: self.view.clip(world[i]),
            world: world[i],
            normal: normal[i],
        });
        let mut polygon = std::mem::take(&mut self.polygon);
        let cut = clip(&Planes::guard(&self.view), vertices, &mut polygon);
        let mut reason = (polygon.len() < 3).then_some(CLIPPED_AWAY);
        let numbers = if cut { [UNSHARED; 3] } else { numbers };
        let mut drawn = false;
        for k in 2..polygon.len() {
            match self.piece([polygon[0], polygon[k - 1], polygon[k]]) {
                Ok((mut t, back, covers)) => {
                    (t.material, t.object, t.face) = (material, object, face);
                    if covers && !back {
                        let [lo, hi] = &mut self.range;
                        for d in t.depth {
                            (*lo, *hi) = (lo.min(d), hi.max(d));
                        }
                    }
                    if back {
                        self.back.push((t, numbers));
                    } else {
                        self.front.push((t, numbers));
                    }
                    drawn = true;
                }
                Err(why) => reason = Some(why),
            }
        }
        self.polygon = polygon;
        if drawn {
            self.counts.clipped += u64::from(cut);
            return None;
        }
        reason
    }

    /// Projects one triangle of a clipped polygon; also says whether it shows its back and covers a pixel.
    fn piece(&self, v: [Vertex; 3]) -> Result<(ScreenTriangle, bool, bool), Reason> {
        let mut position = [crate::raster::Point::default(); 3];
        for i in 0..3 {
            position[i] = self.view.screen(v[i].clip).ok_or(DEGENERATE)?;
        }
        let area = area2(position);
        if area == 0 {
            return Err(DEGENERATE);
        }
        let back = area > 0;
        if back && self.skips.is_on(BACK_FACE) {
            return Err(BACK_FACE);
        }
        if self.skips.is_on(OUTSIDE) && self.beside(position) {
            return Err(OUTSIDE);
        }
        let covers = Walk::new(position, self.viewport)
            .is_some_and(|w| w.spans(self.viewport.width).next().is_some());
        if !covers && self.skips.is_on(UNCOVERED) {
            return Err(UNCOVERED);
        }
        let triangle = ScreenTriangle {
            position,
            inv_w: v.map(|v| 1.0 / v.clip.w),
            depth: v.map(|v| self.view.nearness(v.clip)),
            world: v.map(|v| v.world),
            normal: v.map(|v| v.normal),
            material: 0,
            object: 0,
            face: 0,
        };
        Ok((triangle, back, covers))
    }

    /// Whether the snapped triangle lies wholly on one side of the viewport.
    fn beside(&self, p: [crate::raster::Point; 3]) -> bool {
        let edge = |pixels: u32| i64::from(pixels) * i64::from(crate::raster::SUBPIXELS);
        let (w, h) = (edge(self.viewport.width), edge(self.viewport.height));
        let all =
            |f: &dyn Fn(i64, i64) -> bool| p.iter().all(|q| f(i64::from(q.x), i64::from(q.y)));
        all(&|x, _| x <= 0) || all(&|x, _| x >= w) || all(&|_, y| y <= 0) || all(&|_, y| y >= h)
    }
}
