//! Edges of objects that are drawn as wireframe, on the screen, and the faces that may hide them.
//!
//! Every edge of a mesh is there once, however many faces share it; vertices are told apart by their place, not their
//! number, since seams and creases have several vertices in one place. Edges are clipped as faces are, at the near and
//! far planes and the guard band, always from the same end. An edge of which no face shows its front is left out
//! (`back-edge`), which is right for closed objects: their front faces hide it.

use super::camera::{Clip, View};
use super::clip::{clip, Planes, Vertex};
use crate::line::cue::Cue;
use crate::line::hidden::{Occluder, Sight};
use crate::line::LineFilter;
use crate::raster::area2;
use crate::scene::{Draw, Object, Scene};
use crate::skips::{Skips, BACK_EDGE, BACK_FACE};
use glam::{DMat3, DVec3};
use std::collections::{BTreeMap, HashMap};

/// An edge to draw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WireEdge {
    /// Where it is on the screen, and how near.
    pub sight: Sight,
    /// World positions of its ends.
    pub world: [DVec3; 2],
    /// Depth along the view at its ends, world units.
    pub depth: [f64; 2],
    /// Colour before depth cueing, LSB, 0..=255.
    pub colour: [f64; 3],
    /// Index of the object.
    pub object: usize,
}

/// All that is drawn as wireframe.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Wires {
    /// Edges in the order of objects and faces.
    pub edges: Vec<WireEdge>,
    /// Faces that hide them: those of wireframe objects and those that are shaded.
    pub faces: Vec<Occluder>,
    /// How lines are drawn.
    pub filter: LineFilter,
    /// Depth cueing.
    pub cue: Cue,
    /// Least and greatest depth of the edges, the range of depth cueing.
    pub depth_range: [f64; 2],
}

impl Wires {
    /// Whether there is nothing to draw.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.edges.is_empty()
    }

    /// The wireframe objects of a scene, with the faces of all objects. What is left out is counted in `skipped`.
    pub(super) fn new(
        scene: &Scene,
        view: &View,
        skips: &Skips,
        skipped: &mut BTreeMap<&'static str, u64>,
    ) -> Self {
        let mut wires = Self {
            filter: scene.render.line,
            cue: scene.render.cue,
            depth_range: [f64::INFINITY, f64::NEG_INFINITY],
            ..Self::default()
        };
        if scene.objects.iter().all(|o| o.draw == Draw::Shaded) {
            return wires;
        }
        let mut without_front = 0;
        for (index, object) in scene.objects.iter().enumerate() {
            let faces = Corners::new(object);
            if object.draw == Draw::Wireframe {
                let m = &scene.materials[object.material];
                let colour = ((m.ambient + m.diffuse) * 255.0)
                    .to_array()
                    .map(|c| c.clamp(0.0, 255.0));
                without_front +=
                    wires.object(view, &faces, skips.is_on(BACK_EDGE), (index, colour));
            } else {
                // Not the triangles that are drawn: those that cover no pixel centre hide something all the same.
                let planes = Planes::guard(view);
                for corner in faces.iter() {
                    wires.face(view, &planes, corner, skips.is_on(BACK_FACE));
                }
            }
        }
        if without_front > 0 {
            *skipped.entry(BACK_EDGE).or_default() += without_front;
        }
        wires
    }

    /// Adds an object; gives how many edges were left out because they show no front face.
    fn object(
        &mut self,
        view: &View,
        faces: &Corners<'_>,
        skip: bool,
        (index, colour): (usize, [f64; 3]),
    ) -> u64 {
        let planes = Planes::guard(view);
        let mut known: HashMap<[Place; 2], usize> = HashMap::new();
        // Both ends, and whether a front face was met.
        let mut edges: Vec<([DVec3; 2], bool)> = Vec::new();
        for corner in faces.iter() {
            let front = self.face(view, &planes, corner, skip);
            for (a, b) in [(0, 1), (1, 2), (2, 0)] {
                let mut ends = [corner[a], corner[b]];
                let mut places = ends.map(place);
                if places[0] == places[1] {
                    continue;
                }
                if places[0] > places[1] {
                    ends.reverse();
                    places.reverse();
                }
                let slot = *known.entry(places).or_insert(edges.len());
                if slot == edges.len() {
                    edges.push((ends, false));
                }
                edges[slot].1 |= front;
            }
        }
        let mut left_out = 0;
        for (ends, front) in edges {
            let Some(kept) = clip_edge(&planes, ends.map(|p| view.clip(p))) else {
                continue;
            };
            let world = kept.map(|t| ends[0].lerp(ends[1], t));
            let ends = world.map(|p| view.clip(p));
            let (Some(a), Some(b)) = (view.screen(ends[0]), view.screen(ends[1])) else {
                continue;
            };
            let depth = ends.map(|c| c.depth);
            if front {
                let [lo, hi] = &mut self.depth_range;
                for d in depth {
                    (*lo, *hi) = (lo.min(d), hi.max(d));
                }
            } else if skip {
                left_out += 1;
                continue;
            }
            self.edges.push(WireEdge {
                sight: Sight {
                    ends: [a, b],
                    nearness: ends.map(|c| view.nearness(c)),
                },
                world,
                depth,
                colour,
                object: index,
            });
        }
        left_out
    }

    /// Adds what is visible of a face to those that hide, back faces only if nothing is skipped; true for a front face.
    fn face(&mut self, view: &View, planes: &Planes, corner: [DVec3; 3], skip: bool) -> bool {
        let mut polygon = Vec::new();
        let vertices = corner.map(|world| Vertex {
            clip: view.clip(world),
            world,
            normal: DVec3::ZERO,
            uv: glam::DVec2::ZERO,
        });
        clip(planes, vertices, &mut polygon);
        let mut front = false;
        for k in 2..polygon.len() {
            let piece = [polygon[0].clip, polygon[k - 1].clip, polygon[k].clip];
            let [Some(a), Some(b), Some(c)] = piece.map(|c| view.screen(c)) else {
                continue;
            };
            let area = area2([a, b, c]);
            front |= area < 0;
            if area < 0 || (area > 0 && !skip) {
                self.faces.push(Occluder {
                    position: [a, b, c],
                    nearness: piece.map(|c| view.nearness(c)),
                });
            }
        }
        front
    }
}

/// The faces of an object in the world, counter-clockwise from outside.
struct Corners<'a> {
    world: Vec<DVec3>,
    mirrored: bool,
    triangles: &'a [[u32; 3]],
}

impl<'a> Corners<'a> {
    fn new(object: &'a Object) -> Self {
        Self {
            world: object
                .mesh
                .positions
                .iter()
                .map(|p| object.transform.transform_point3(*p))
                .collect(),
            mirrored: DMat3::from_mat4(object.transform).determinant() < 0.0,
            triangles: &object.mesh.triangles,
        }
    }

    fn iter(&self) -> impl Iterator<Item = [DVec3; 3]> + '_ {
        self.triangles.iter().map(|t| {
            let t = if self.mirrored {
                [t[0], t[2], t[1]]
            } else {
                *t
            };
            t.map(|i| self.world[i as usize])
        })
    }
}

/// A position as its bits, −0 taken for 0, to find equal ones.
type Place = [u64; 3];

fn place(p: DVec3) -> Place {
    p.to_array().map(|v| (v + 0.0).to_bits())
}

/// What the planes leave of an edge, as shares of its length (Liang and Barsky 1984).
fn clip_edge(planes: &Planes, [a, b]: [Clip; 2]) -> Option<[f64; 2]> {
    let (mut from, mut to) = (0.0f64, 1.0f64);
    for i in 0..Planes::COUNT {
        let (da, db) = (planes.distance(i, a), planes.distance(i, b));
        if da < 0.0 && db < 0.0 {
            return None;
        }
        if da < 0.0 {
            from = from.max(da / (da - db));
        } else if db < 0.0 {
            to = to.min(da / (da - db));
        }
    }
    (from <= to).then_some([from, to])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Camera, Projection};
    use proptest::prelude::*;

    fn view() -> View {
        let camera = Camera {
            eye: DVec3::ZERO,
            target: DVec3::NEG_Z,
            up: DVec3::Y,
            projection: Projection::Perspective { fov: 70.0 },
            near: 0.5,
            far: 20.0,
        };
        View::new(&camera, 40, 30)
    }

    fn any_point() -> impl Strategy<Value = DVec3> {
        (-9.0..9.0, -9.0..9.0, -25.0..6.0).prop_map(|(x, y, z)| DVec3::new(x, y, z))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(3000))]
        /// A point of the segment is kept exactly when it is inside all planes.
        #[test]
        fn clipping_keeps_what_is_inside(a in any_point(), b in any_point(), t in 0.0..1.0f64) {
            let view = view();
            let planes = Planes::guard(&view);
            let ends = [a, b].map(|p| view.clip(p));
            let p = view.clip(a + (b - a) * t);
            let margin = (0..Planes::COUNT).map(|i| planes.distance(i, p)).fold(f64::INFINITY, f64::min);
            prop_assume!(margin.abs() > 1e-9);
            let kept = clip_edge(&planes, ends).is_some_and(|[from, to]| {
                for s in [from, to] {
                    let q = view.clip(a.lerp(b, s));
                    for i in 0..Planes::COUNT {
                        assert!(planes.distance(i, q) >= -1e-9);
                    }
                }
                (from..=to).contains(&t)
            });
            prop_assert_eq!(kept, margin > 0.0);
        }
    }
}
