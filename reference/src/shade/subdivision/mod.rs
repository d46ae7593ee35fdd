//! Triangles cut into smaller ones, each with six knots of its own: what the adaptive quadratic methods share. Corners are
//! blends Σλᵢwᵢ·(nᵢ, xᵢ, 1), so the one in the middle of an edge is the mean of its ends whatever the perspective, and both
//! triangles at an edge get the same bits. Normals are normalised, and positions divided by their weight, when a corner is
//! shaded; it is shaded once, however many leaves meet there within a triangle's own cuts.

pub mod along;
pub mod tree;

pub use along::Along;
pub use tree::{Leaf, Node, Tree};

use super::quadratic::EDGES;
use super::quadric::Quadric;
use super::{knot, unit_normal};
use crate::geometry::{Prepared, ScreenTriangle};
use glam::DVec3;
use smallvec::{smallvec, SmallVec};

/// A corner: normal and position times the perspective weight, and that weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    normal: DVec3,
    world: DVec3,
    weight: f64,
}

impl Corner {
    /// Vertex `i` of a triangle.
    #[must_use]
    pub fn vertex(t: &ScreenTriangle, i: usize) -> Self {
        Self {
            normal: t.normal[i] * t.inv_w[i],
            world: t.world[i] * t.inv_w[i],
            weight: t.inv_w[i],
        }
    }

    /// In the middle between two corners on the screen.
    #[must_use]
    pub fn middle(a: &Self, b: &Self) -> Self {
        Self {
            normal: (a.normal + b.normal) * 0.5,
            world: (a.world + b.world) * 0.5,
            weight: (a.weight + b.weight) * 0.5,
        }
    }

    /// The middle of three corners.
    #[must_use]
    pub fn centre([a, b, c]: [&Self; 3]) -> Self {
        Self {
            normal: (a.normal + b.normal + c.normal) / 3.0,
            world: (a.world + b.world + c.world) / 3.0,
            weight: (a.weight + b.weight + c.weight) / 3.0,
        }
    }

    /// The unit normal; that of the face where opposite normals cancel.
    #[must_use]
    pub fn normal(&self, t: &ScreenTriangle) -> DVec3 {
        unit_normal(t, self.normal / self.weight)
    }

    /// The position in the world.
    #[must_use]
    pub fn world(&self) -> DVec3 {
        self.world / self.weight
    }

    /// The colour, LSB, 0..=[`super::KNOT_MAX`].
    #[must_use]
    pub fn shade(&self, p: &Prepared, t: &ScreenTriangle) -> [f64; 3] {
        knot(
            p.surroundings
                .shade(t.material, self.world(), self.normal(t)),
        )
    }
}

/// A triangle among corners: its vertices and the middles of its edges (in the order of [`EDGES`]), by number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Piece {
    /// Vertices.
    pub vertex: [u32; 3],
    /// Mid-edges.
    pub middle: [u32; 3],
}

/// The corners of the pieces of one triangle, shaded when first asked for.
pub struct Corners<'a> {
    prepared: &'a Prepared,
    triangle: &'a ScreenTriangle,
    corners: SmallVec<[(Corner, Option<[f64; 3]>); 6]>,
    /// How many were shaded.
    pub shaded: u32,
}

/// The edge between two places of a piece, an index into [`EDGES`].
#[must_use]
pub fn edge(i: usize, j: usize) -> usize {
    i + j - 1
}

impl<'a> Corners<'a> {
    /// The corners of a whole triangle.
    #[must_use]
    pub fn new(prepared: &'a Prepared, triangle: &'a ScreenTriangle) -> (Self, Piece) {
        let mut all = Self {
            prepared,
            triangle,
            corners: smallvec![],
            shaded: 0,
        };
        let vertex = [0, 1, 2].map(|i| all.add(Corner::vertex(triangle, i)));
        let middle = EDGES.map(|(i, j)| all.between(vertex[i], vertex[j]));
        (all, Piece { vertex, middle })
    }

    fn add(&mut self, c: Corner) -> u32 {
        self.corners.push((c, None));
        self.corners.len() as u32 - 1
    }

    /// A corner by number.
    #[must_use]
    pub fn get(&self, i: u32) -> &Corner {
        &self.corners[i as usize].0
    }

    /// A new corner in the middle between two.
    pub fn between(&mut self, i: u32, j: u32) -> u32 {
        let middle = Corner::middle(self.get(i), self.get(j));
        self.add(middle)
    }

    /// The colour of a corner.
    pub fn colour(&mut self, i: u32) -> [f64; 3] {
        let (corner, known) = &mut self.corners[i as usize];
        *known.get_or_insert_with(|| {
            self.shaded += 1;
            corner.shade(self.prepared, self.triangle)
        })
    }

    /// The interpolants of a piece, three channels.
    pub fn quadrics(&mut self, p: &Piece) -> [Quadric; 3] {
        let [a, b, c] = p.vertex.map(|i| self.colour(i));
        let [d, e, f] = p.middle.map(|i| self.colour(i));
        [0, 1, 2].map(|k| Quadric::quadratic([a, b, c, d, e, f].map(|v| v[k])))
    }

    /// Cuts a piece from the middle of the edge between places `i` and `j` to the third. The first half keeps place `i`,
    /// with the new vertex in place `j`; the second the other way round.
    pub fn halve(&mut self, p: &Piece, i: usize, j: usize) -> [Piece; 2] {
        let k = 3 - i - j;
        let m = p.middle[edge(i, j)];
        let median = self.between(m, p.vertex[k]);
        [(i, j), (j, i)].map(|(kept, replaced)| {
            let mut half = *p;
            half.vertex[replaced] = m;
            half.middle[edge(i, j)] = self.between(p.vertex[kept], m);
            half.middle[edge(replaced, k)] = median;
            half
        })
    }

    /// Cuts a piece in four through its mid-edges: three at its vertices, in their order and with the vertex in its
    /// place, and the one between, whose place `i` is the mid-edge opposite to vertex `i`.
    pub fn quarter(&mut self, p: &Piece) -> [Piece; 4] {
        let m = [p.middle[2], p.middle[1], p.middle[0]];
        let inner = EDGES.map(|(i, j)| self.between(m[i], m[j]));
        let centre = Piece {
            vertex: m,
            middle: inner,
        };
        let [a, b, c] = [0, 1, 2].map(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let mut out = centre;
            // Opposite to vertex k lies the middle of edge ij.
            out.vertex[i] = p.vertex[i];
            (out.vertex[j], out.vertex[k]) = (m[k], m[j]);
            out.middle[edge(i, j)] = self.between(p.vertex[i], m[k]);
            out.middle[edge(i, k)] = self.between(p.vertex[i], m[j]);
            out.middle[edge(j, k)] = inner[edge(j, k)];
            out
        });
        [a, b, c, centre]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shade::subdivision::tree::Node;

    /// Corners stand for their own weights when normals are the unit vectors: pieces must be where the tree says.
    #[test]
    fn pieces_lie_where_the_tree_looks_for_them() {
        let t = ScreenTriangle {
            uv: [glam::DVec2::ZERO; 3],
            position: Default::default(),
            inv_w: [1.0, 0.5, 2.0],
            depth: [0.0; 3],
            world: [DVec3::X * 1.0, DVec3::Y * 2.0, DVec3::Z * 0.5],
            normal: [DVec3::Z; 3],
            material: 0,
            object: 0,
            face: 0,
        };
        let p = Prepared::from_triangles(
            (1, 1),
            [0; 3],
            vec![t],
            super::super::Surroundings::of(
                vec![],
                vec![],
                &crate::scene::Camera {
                    eye: DVec3::Z,
                    target: DVec3::ZERO,
                    up: DVec3::Y,
                    projection: crate::scene::Projection::Orthographic { height: 1.0 },
                    near: 0.1,
                    far: 2.0,
                },
            ),
        );
        // With these numbers the blend of w·x is the weights themselves.
        let weights = |c: &Corner| c.world.to_array();
        let (mut corners, whole) = Corners::new(&p, &p.triangles[0]);
        let check = |corners: &Corners<'_>, parent: &Piece, node: Node, children: &[Piece]| {
            for (k, child) in children.iter().enumerate() {
                // The centre of the child, as weights of the parent.
                let at = |piece: &Piece| piece.vertex.map(|i| weights(corners.get(i)));
                let (up, down) = (at(parent), at(child));
                let centre = [0, 1, 2].map(|c| (down[0][c] + down[1][c] + down[2][c]) / 3.0);
                // The parent is the whole triangle here, so weights are its own.
                assert_eq!(up, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
                let (found, local) = node.child(centre);
                assert_eq!(found, k);
                assert!(
                    local.iter().all(|v| (v - 1.0 / 3.0).abs() < 1e-15),
                    "{local:?}"
                );
                for (e, (i, j)) in EDGES.into_iter().enumerate() {
                    let want =
                        Corner::middle(corners.get(child.vertex[i]), corners.get(child.vertex[j]));
                    assert_eq!(*corners.get(child.middle[e]), want);
                }
            }
        };
        for (i, j) in EDGES {
            let halves = corners.halve(&whole, i, j);
            check(
                &corners,
                &whole,
                Node::Halves {
                    i: i as u8,
                    j: j as u8,
                    first: 0,
                },
                &halves,
            );
        }
        let quarters = corners.quarter(&whole);
        check(&corners, &whole, Node::Quarters { first: 0 }, &quarters);
    }
}
