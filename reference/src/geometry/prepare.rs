//! The pass over all triangles that makes a [`Prepared`]: first which are drawn, part by part of the faces, on vertices
//! that are transformed once in each part and only when a face that may be seen needs them; then, when the depth range
//! is known, the list itself. The list is the same however the faces are divided.

use super::camera::View;
use super::clip::Planes;
use super::cull::{box_outside, corners};
use super::facing::Facing;
use super::front_to_back;
use super::list::{starts, List};
use super::pool::Stand;
use super::select::{Memory, Selection, SkipsOn};
use super::selected::{Reason, Selected, Subject};
use super::{Prepared, TriangleCounts, Wires};
use crate::parallel;
use crate::raster::Viewport;
use crate::scene::{Draw, Scene, SceneError, IMAGE_LIMIT};
use crate::shade::reach::missing;
use crate::shade::Surroundings;
use crate::skips::{Skips, FRONT_TO_BACK, FRUSTUM, SPOT, VERTEX};
use std::collections::BTreeMap;
use std::ops::Range;

/// Least number of faces worth a part of their own.
const LEAST: usize = 1024;
/// Parts for each thread: those of the far side of an object are soon done.
const PARTS: usize = 8;

impl Prepared {
    /// Prepares a scene for its own frame size or another one.
    ///
    /// # Errors
    /// A frame size of zero or beyond [`IMAGE_LIMIT`].
    pub fn new(scene: &Scene, size: Option<(u32, u32)>, skips: &Skips) -> Result<Self, SceneError> {
        Self::in_parts(scene, size, skips, |faces| {
            parallel::share(faces, LEAST, PARTS)
        })
    }

    /// With parts of so many faces.
    fn in_parts(
        scene: &Scene,
        size: Option<(u32, u32)>,
        skips: &Skips,
        part: impl Fn(usize) -> usize,
    ) -> Result<Self, SceneError> {
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
        let selection = Selection {
            view,
            guard: Planes::guard(&view),
            frustum: Planes::frustum(&view),
            viewport: Viewport { width, height },
            skips: SkipsOn::new(skips),
        };
        let mut counts = TriangleCounts::default();
        let mut skipped = BTreeMap::new();
        let subjects = subjects(scene, &selection, skips, &mut counts, &mut skipped);
        let cast = Cast::new(&subjects);
        let parts = parallel::parts(
            cast.faces(),
            part(cast.faces()),
            Memory::default,
            |memory, faces| cast.select(&selection, faces, memory),
        );
        let parts: Vec<_> = parts.into_iter().flatten().collect();
        let ranks = ranks(&subjects, &parts, skips, &mut skipped);
        let list = List::new(&cast, &parts, &ranks);
        for (_, part) in &parts {
            counts.clipped += part.clipped;
            for (reason, n) in Reason::NAMES.into_iter().zip(part.skipped) {
                counts.culled += n;
                count(&mut skipped, reason, n);
            }
        }
        counts.drawn = list.len as u64;
        // Not at the same time: a thread is to find the pieces that it has made itself.
        let triangles = parallel::fill(list.len, |i| list.triangle(i));
        let (vertices, untouched) = parallel::both(
            list.len,
            || parallel::fill(list.len, |i| list.numbers(i)),
            || cast.untouched(&parts),
        );
        if selection.skips.vertex {
            count(&mut skipped, VERTEX, untouched);
        }
        let surroundings = Surroundings::new(scene).skipping_spots(skips.is_on(SPOT));
        count(&mut skipped, SPOT, missing(&surroundings, &triangles));
        let wires = Wires::new(scene, &view, skips, &mut skipped);
        Ok(Self {
            scene_name: scene.name.clone(),
            width,
            height,
            background: scene.image.background,
            triangles,
            counts,
            skipped,
            vertices,
            surroundings,
            wires,
        })
    }
}

/// Counts what there is to count; reasons that do not occur are left out.
fn count(skipped: &mut BTreeMap<&'static str, u64>, reason: &'static str, n: u64) {
    if n > 0 {
        *skipped.entry(reason).or_default() += n;
    }
}

/// The objects that may be seen and are drawn as surfaces.
fn subjects<'a>(
    scene: &'a Scene,
    selection: &Selection,
    skips: &Skips,
    counts: &mut TriangleCounts,
    skipped: &mut BTreeMap<&'static str, u64>,
) -> Vec<Subject<'a>> {
    let Selection { view, guard, .. } = selection;
    let mut subjects = Vec::new();
    for (index, object) in scene.objects.iter().enumerate() {
        if object.draw != Draw::Shaded {
            continue;
        }
        let faces = object.mesh.triangles.len() as u64;
        counts.in_ += faces;
        let around = corners(&object.mesh.positions);
        let beside = |c| box_outside(view, object.transform, c);
        if skips.is_on(FRUSTUM) && around.as_ref().is_some_and(beside) {
            counts.culled += faces;
            count(skipped, FRUSTUM, faces);
            continue;
        }
        let facing = around
            .filter(|_| selection.skips.vertex && selection.skips.back_face)
            .and_then(|c| Facing::new(view, guard, object.transform, &c));
        subjects.push(Subject {
            object,
            index,
            stand: Stand::new(object.transform),
            facing,
        });
    }
    subjects
}

/// The place of each subject in the order of drawing; triangles that come before farther ones for it are counted.
fn ranks(
    subjects: &[Subject],
    parts: &[(usize, Selected)],
    skips: &Skips,
    skipped: &mut BTreeMap<&'static str, u64>,
) -> Vec<usize> {
    let mut ranks: Vec<usize> = (0..subjects.len()).collect();
    let fronts_only = parts.iter().all(|(_, part)| part.back.is_empty());
    if subjects.len() < 2 || !fronts_only || !skips.is_on(FRONT_TO_BACK) {
        return ranks;
    }
    let mut ranges = vec![[f64::INFINITY, f64::NEG_INFINITY]; subjects.len()];
    let mut pieces = vec![0; subjects.len()];
    for (k, part) in parts {
        let [lo, hi] = ranges[*k];
        ranges[*k] = [lo.min(part.range[0]), hi.max(part.range[1])];
        pieces[*k] += part.front.len() as u64;
    }
    let order = front_to_back::order(&ranges);
    let mut first_later = usize::MAX;
    for (rank, k) in order.into_iter().enumerate().rev() {
        ranks[k] = rank;
        if k > first_later {
            count(skipped, FRONT_TO_BACK, pieces[k]);
        }
        if pieces[k] > 0 {
            first_later = first_later.min(k);
        }
    }
    ranks
}

/// All subjects, their faces and vertices numbered one after another.
pub(super) struct Cast<'a> {
    pub(super) subjects: &'a [Subject<'a>],
    /// Where the faces of each begin, and of all of them the end.
    faces: Vec<usize>,
    /// Likewise of vertices.
    pub(super) vertices: Vec<usize>,
}

impl<'a> Cast<'a> {
    fn new(subjects: &'a [Subject<'a>]) -> Self {
        let meshes = || subjects.iter().map(|s| &s.object.mesh);
        Self {
            subjects,
            faces: starts(meshes().map(|m| m.triangles.len())),
            vertices: starts(meshes().map(|m| m.positions.len())),
        }
    }

    fn faces(&self) -> usize {
        self.faces.last().copied().unwrap_or(0)
    }

    /// Looks at a part of all faces: for each subject that it is of, what is drawn.
    fn select(
        &self,
        selection: &Selection,
        faces: Range<usize>,
        memory: &mut Memory,
    ) -> Vec<(usize, Selected)> {
        let first = self.faces.partition_point(|start| *start <= faces.start) - 1;
        let parts = (first..self.subjects.len()).take_while(|k| self.faces[*k] < faces.end);
        let select = |k: usize| {
            let (start, end) = (self.faces[k], self.faces[k + 1]);
            let own = faces.start.max(start) - start..faces.end.min(end) - start;
            (k, selection.select(&self.subjects[k], own, memory))
        };
        parts.map(select).collect()
    }

    /// Vertices that no part transformed.
    fn untouched(&self, parts: &[(usize, Selected)]) -> u64 {
        let all = self.vertices.last().copied().unwrap_or(0);
        let mut untouched = all;
        for of_one in parts.chunk_by(|a, b| a.0 == b.0) {
            if let [(_, part)] = of_one {
                untouched -= part.pool.numbers().len();
                continue;
            }
            let k = of_one[0].0;
            let mut seen = vec![false; self.vertices[k + 1] - self.vertices[k]];
            for number in of_one.iter().flat_map(|(_, part)| part.pool.numbers()) {
                seen[*number as usize] = true;
            }
            untouched -= seen.iter().filter(|s| **s).count();
        }
        untouched as u64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    /// Scenes of one and of many objects, some of them cut, some textured, some mirrored; whatever is skipped.
    #[test]
    fn parts_do_not_matter() {
        let (mut cut, mut back) = (0, 0);
        for name in [
            "sphere-690",
            "teapot",
            "gem",
            "rings",
            "perspective-floor",
            "tiles",
        ] {
            let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../scenes/{name}.toml"));
            let scene = crate::scene::load(&file).unwrap();
            for without in ["", "vertex", "back-face,uncovered", "frustum,outside"] {
                let skips = Skips::without(without).unwrap();
                let whole = Prepared::in_parts(&scene, None, &skips, |_| usize::MAX).unwrap();
                for part in [1, 7, 100, 1000] {
                    let parts = Prepared::in_parts(&scene, None, &skips, |_| part).unwrap();
                    assert_eq!(
                        whole.triangles, parts.triangles,
                        "{name}, {without}, {part}"
                    );
                    assert_eq!(whole.vertices, parts.vertices, "{name}, {without}, {part}");
                    assert_eq!(whole.skipped, parts.skipped, "{name}, {without}, {part}");
                    assert_eq!(whole.counts, parts.counts, "{name}, {without}, {part}");
                }
                cut += whole.counts.clipped;
                back += u64::from(without.contains("back")) * whole.counts.drawn;
            }
        }
        assert!(cut > 0 && back > 0);
    }
}
