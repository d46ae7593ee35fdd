//! Quadratic colours on triangles cut in four through their mid-edges where the interpolated colour at the centre is too
//! far from the shaded one (Abbas 2003, section 7.1). Kept to show what such a probe misses: a highlight off the centre, or a
//! terminator, goes unnoticed, with errors of up to 115 LSB at a threshold of 4; and where only one of two neighbours is
//! cut, their common edge opens by up to the threshold and more. [`super::quadratic_adaptive`] does neither.
//!
//! | work | |
//! |---|---|
//! | pixel | 6 additions, as `quadratic` |
//! | triangle | one shading at the centre of every piece, and 3 to 9 knots for each cut |

use super::case::Case;
use super::quadric::Quadric;
use super::shader::Shader;
use super::subdivision::{along::Cut, Along, Corner, Corners, Leaf, Node, Piece, Tree};
use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::Span;

/// The difference at the centre that is let pass, LSB.
pub const THRESHOLD: f64 = 4.0;
/// Cuts one inside another.
const LEVELS: u32 = 6;

/// The method.
pub struct QuadraticAdaptiveCentre;

impl QuadraticAdaptiveCentre {
    /// The pieces of a triangle.
    #[must_use]
    pub fn cut(p: &Prepared, t: &ScreenTriangle) -> Tree {
        let (mut corners, whole) = Corners::new(p, t);
        let mut tree = Tree::new(Leaf::Direct);
        piece(p, t, &mut corners, &mut tree, (0, LEVELS), &whole);
        tree
    }
}

/// The difference at the centre, all channels.
fn probe(
    p: &Prepared,
    t: &ScreenTriangle,
    corners: &Corners<'_>,
    piece: &Piece,
    q: &[Quadric; 3],
) -> f64 {
    let truth = Corner::centre(piece.vertex.map(|i| corners.get(i))).shade(p, t);
    (0..3)
        .map(|c| (q[c].value(1.0 / 3.0, 1.0 / 3.0) - truth[c]).abs())
        .fold(0.0, f64::max)
}

fn piece(
    p: &Prepared,
    t: &ScreenTriangle,
    corners: &mut Corners<'_>,
    tree: &mut Tree,
    (at, levels): (u32, u32),
    here: &Piece,
) {
    let q = corners.quadrics(here);
    if levels == 0 || probe(p, t, corners, here, &q) <= THRESHOLD {
        tree.set(at, Node::Leaf(Leaf::Smooth(q)));
        return;
    }
    let first = tree.grow(4);
    tree.set(at, Node::Quarters { first });
    for (k, child) in corners.quarter(here).iter().enumerate() {
        piece(p, t, corners, tree, (first + k as u32, levels - 1), child);
    }
}

impl Shader for QuadraticAdaptiveCentre {
    type Triangle = Cut;
    type Run<'a> = Along<'a>;

    fn triangle(&self, p: &Prepared, index: usize) -> Cut {
        Cut {
            index,
            tree: Self::cut(p, &p.triangles[index]),
        }
    }

    fn start<'a>(&'a self, p: &'a Prepared, cut: &'a Cut, span: Span) -> Along<'a> {
        Along::new(p, cut, span)
    }
}

/// Bound on |method − truth|, LSB: that of `quadratic` on a whole triangle. The probe promises nothing better.
#[must_use]
pub fn bound(case: &Case) -> f64 {
    super::quadratic::bound(case)
}
