//! A BSP tree of the triangles' planes in the world (Loisel 1996, section on BSP trees): nothing on the viewer's side
//! of a plane is hidden by anything beyond it. The tree does not depend on the viewer; walking it from the far side to
//! the near one is a painter's order without any sorting, the other way round an order in which every pixel is written
//! at most once.
//!
//! A triangle that reaches through a plane is split there. The plane that is chosen is the one of a few candidates that
//! splits least; no good rule is known. A convex object has all its triangles behind every one of them, so that its tree
//! is a list and building it takes time with the square of their number.

use super::piece::Piece;
use super::Visible;
use crate::geometry::Prepared;
use glam::DVec3;

/// Planes that are tried for each node.
const CANDIDATES: usize = 8;
/// What is nearer to a plane than this part of the scene's size lies on it.
const THICKNESS: f64 = 1e-9;

/// A plane n·x = d.
#[derive(Clone, Copy, Debug)]
struct Plane {
    normal: DVec3,
    offset: f64,
}

impl Plane {
    fn of(p: &Prepared, triangle: usize) -> Option<Self> {
        let t = &p.triangles[triangle];
        let normal = t.face_normal();
        (normal != DVec3::ZERO).then(|| Self {
            normal,
            offset: normal.dot(t.world[0]),
        })
    }

    fn distance(&self, x: DVec3) -> f64 {
        self.normal.dot(x) - self.offset
    }
}

/// A convex polygon, part of a triangle.
#[derive(Clone, Debug)]
struct Polygon {
    corners: Vec<DVec3>,
    piece: Piece,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    On,
    Front,
    Back,
    Across,
}

#[derive(Clone, Debug)]
struct Node {
    plane: Plane,
    /// The parts that lie on the plane, in the order of their triangles.
    on: Vec<Piece>,
    front: Option<usize>,
    back: Option<usize>,
}

/// The tree.
#[derive(Clone, Debug)]
pub struct Tree {
    nodes: Vec<Node>,
    /// How many times a triangle or a part of one was split.
    pub splits: u64,
}

/// A part of the triangles still to be made into a node, and where it will hang: the node above, and whether in front.
type Open = (Vec<Polygon>, Option<(usize, bool)>);

impl Tree {
    /// Builds the tree of all triangles.
    #[must_use]
    pub fn new(p: &Prepared) -> Self {
        let size = p
            .triangles
            .iter()
            .flat_map(|t| t.world)
            .fold(0.0, |m: f64, v| m.max(v.abs().max_element()));
        let thickness = size * THICKNESS;
        let all = p.triangles.iter().enumerate().map(|(i, t)| Polygon {
            corners: t.world.to_vec(),
            piece: Piece::whole(i),
        });
        let mut tree = Self {
            nodes: Vec::new(),
            splits: 0,
        };
        let mut open: Vec<Open> = vec![(all.collect(), None)];
        while let Some((polygons, above)) = open.pop() {
            let Some(plane) = choose(p, &polygons, thickness) else {
                continue;
            };
            let here = tree.nodes.len();
            match above {
                Some((node, true)) => tree.nodes[node].front = Some(here),
                Some((node, false)) => tree.nodes[node].back = Some(here),
                None => {}
            }
            let (mut on, mut front, mut back) = (Vec::new(), Vec::new(), Vec::new());
            for polygon in polygons {
                match place(&plane, &polygon.corners, thickness) {
                    Place::On => on.push(polygon.piece),
                    Place::Front => front.push(polygon),
                    Place::Back => back.push(polygon),
                    Place::Across => {
                        tree.splits += 1;
                        let [f, b] = split(p, &plane, &polygon);
                        front.push(f);
                        back.push(b);
                    }
                }
            }
            on.sort_by_key(|piece| piece.triangle);
            tree.nodes.push(Node {
                plane,
                on,
                front: None,
                back: None,
            });
            open.push((front, Some((here, true))));
            open.push((back, Some((here, false))));
        }
        tree
    }

    /// Planes in the tree.
    #[must_use]
    pub fn planes(&self) -> usize {
        self.nodes.len()
    }

    /// Calls `visit` for every node, from the far side to the near one or the other way round.
    fn walk<'a>(&'a self, p: &Prepared, far_first: bool, mut visit: impl FnMut(&'a Node)) {
        // Subtrees to be walked, and nodes whose first side is done.
        let mut todo: Vec<(usize, bool)> = (!self.nodes.is_empty())
            .then_some((0, false))
            .into_iter()
            .collect();
        while let Some((k, half)) = todo.pop() {
            let node = &self.nodes[k];
            let foot = node.plane.normal * node.plane.offset;
            let viewer_in_front = node.plane.normal.dot(p.surroundings.view(foot)) > 0.0;
            let (first, last) = if viewer_in_front == far_first {
                (node.back, node.front)
            } else {
                (node.front, node.back)
            };
            if half {
                visit(node);
                todo.extend(last.map(|n| (n, false)));
            } else {
                todo.push((k, true));
                todo.extend(first.map(|n| (n, false)));
            }
        }
    }

    /// Draws from back to front; what comes later covers what was there.
    #[must_use]
    pub fn back_to_front(&self, p: &Prepared) -> Visible {
        let mut visible = Visible::new(p);
        self.walk(p, true, |node| {
            for piece in node.on.iter().rev() {
                piece.each_pixel(p, |at| visible.write(at, piece.triangle));
            }
        });
        visible
    }

    /// Draws from front to back; what is there stays.
    #[must_use]
    pub fn front_to_back(&self, p: &Prepared) -> Visible {
        let mut visible = Visible::new(p);
        self.walk(p, false, |node| {
            for piece in &node.on {
                piece.each_pixel(p, |at| {
                    if visible.ids[at] == super::NONE {
                        visible.write(at, piece.triangle);
                    }
                });
            }
        });
        visible
    }
}

fn place(plane: &Plane, corners: &[DVec3], thickness: f64) -> Place {
    let (mut front, mut back) = (false, false);
    for c in corners {
        let d = plane.distance(*c);
        front |= d > thickness;
        back |= d < -thickness;
    }
    match (front, back) {
        (false, false) => Place::On,
        (true, false) => Place::Front,
        (false, true) => Place::Back,
        (true, true) => Place::Across,
    }
}

/// The plane of the polygon that splits the fewest others, of some.
fn choose(p: &Prepared, polygons: &[Polygon], thickness: f64) -> Option<Plane> {
    let stride = polygons.len().div_ceil(CANDIDATES).max(1);
    let planes = |stride| {
        polygons
            .iter()
            .step_by(stride)
            .filter_map(|polygon| Plane::of(p, polygon.piece.triangle))
    };
    let cost = |plane: &Plane| {
        let (mut across, mut uneven) = (0i64, 0i64);
        for polygon in polygons {
            match place(plane, &polygon.corners, thickness) {
                Place::On => {}
                Place::Front => uneven += 1,
                Place::Back => uneven -= 1,
                Place::Across => across += 1,
            }
        }
        8 * across + uneven.abs()
    };
    planes(stride).min_by_key(cost).or_else(|| planes(1).next())
}

fn split(p: &Prepared, plane: &Plane, polygon: &Polygon) -> [Polygon; 2] {
    let t = &p.triangles[polygon.piece.triangle];
    // The distance over w is affine on the screen.
    let values = [0, 1, 2].map(|i| t.inv_w[i] * plane.distance(t.world[i]));
    let pieces = polygon.piece.cut(values);
    let mut parts = [Vec::new(), Vec::new()];
    for (k, a) in polygon.corners.iter().enumerate() {
        let b = polygon.corners[(k + 1) % polygon.corners.len()];
        let (da, db) = (plane.distance(*a), plane.distance(b));
        parts[usize::from(da < 0.0)].push(*a);
        if (da < 0.0) != (db < 0.0) {
            let x = *a + (b - *a) * (da / (da - db));
            parts[0].push(x);
            parts[1].push(x);
        }
    }
    let [front, back] = parts;
    let [in_front, behind] = pieces;
    [
        Polygon {
            corners: front,
            piece: in_front,
        },
        Polygon {
            corners: back,
            piece: behind,
        },
    ]
}
