//! The cuts of a triangle as a tree: from weights to the leaf they lie in, and to the weights of that leaf.

use crate::shade::quadric::Quadric;
use smallvec::{smallvec, SmallVec};

/// What a piece is drawn with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Leaf {
    /// Interpolants of its own weights 1 and 2, three channels.
    Smooth([Quadric; 3]),
    /// Too few pixels for a set-up that would be good enough: the definition at each.
    Direct,
}

/// A piece of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Node {
    /// Not cut.
    Leaf(Leaf),
    /// Cut in two on the edge between places `i` and `j`: nodes `first` (at `i`) and `first` + 1.
    Halves {
        /// A place of the cut edge.
        i: u8,
        /// The other one.
        j: u8,
        /// Number of the first half.
        first: u32,
    },
    /// Cut in four: nodes `first`.. at vertices 0, 1, 2 and the one between.
    Quarters {
        /// Number of the first quarter.
        first: u32,
    },
}

/// The pieces of a triangle; a triangle that is not cut needs no memory of its own.
#[derive(Clone, Debug)]
pub struct Tree {
    nodes: SmallVec<[Node; 1]>,
}

impl Node {
    /// The child that weights lie in, and their weights there; 0 and the same weights for a leaf.
    #[must_use]
    pub fn child(&self, w: [f64; 3]) -> (usize, [f64; 3]) {
        match *self {
            Self::Leaf(_) => (0, w),
            Self::Halves { i, j, .. } => {
                let child = usize::from(w[i as usize] < w[j as usize]);
                (child, self.map(child, w))
            }
            Self::Quarters { .. } => {
                let sum = w[0] + w[1] + w[2];
                let child = (0..3).find(|c| 2.0 * w[*c] >= sum).unwrap_or(3);
                (child, self.map(child, w))
            }
        }
    }

    /// Weights, or steps of weights, of a child: linear, exact up to one rounding.
    #[must_use]
    pub fn map(&self, child: usize, w: [f64; 3]) -> [f64; 3] {
        match *self {
            Self::Leaf(_) => w,
            Self::Halves { i, j, .. } => {
                let (kept, replaced) = if child == 0 { (i, j) } else { (j, i) };
                let (kept, replaced) = (kept as usize, replaced as usize);
                let mut out = w;
                out[kept] = w[kept] - w[replaced];
                out[replaced] = 2.0 * w[replaced];
                out
            }
            Self::Quarters { .. } if child < 3 => {
                let (a, b) = ((child + 1) % 3, (child + 2) % 3);
                let mut out = w.map(|v| 2.0 * v);
                out[child] = w[child] - w[a] - w[b];
                out
            }
            Self::Quarters { .. } => [w[1] + w[2] - w[0], w[0] + w[2] - w[1], w[0] + w[1] - w[2]],
        }
    }
}

impl Tree {
    /// A triangle that is not cut.
    #[must_use]
    pub fn new(leaf: Leaf) -> Self {
        Self {
            nodes: smallvec![Node::Leaf(leaf)],
        }
    }

    /// Puts a node in its place.
    pub fn set(&mut self, at: u32, node: Node) {
        self.nodes[at as usize] = node;
    }

    /// Makes room for the `count` children of a node and gives the number of the first.
    pub fn grow(&mut self, count: u32) -> u32 {
        let first = self.nodes.len();
        self.nodes
            .resize(first + count as usize, Node::Leaf(Leaf::Direct));
        first as u32
    }

    /// The leaf at weights `w` of the triangle, and both `w` and the steps `s` as weights of that leaf.
    #[must_use]
    pub fn find(&self, mut w: [f64; 3], mut s: [f64; 3]) -> (&Leaf, [f64; 3], [f64; 3]) {
        let mut at = 0;
        loop {
            let node = &self.nodes[at];
            let first = match node {
                Node::Leaf(leaf) => return (leaf, w, s),
                Node::Halves { first, .. } | Node::Quarters { first } => *first,
            };
            let child;
            (child, w) = node.child(w);
            s = node.map(child, s);
            at = first as usize + child;
        }
    }

    /// How many leaves there are.
    #[must_use]
    pub fn leaves(&self) -> usize {
        self.nodes
            .iter()
            .filter(|n| matches!(n, Node::Leaf(_)))
            .count()
    }
}
