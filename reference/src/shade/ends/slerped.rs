//! Ends of spans by slerp along the edges, where the row cuts them (Abbas 2003, eq. 6.5; Hast, Barrera and Bengtsson
//! 2003). The weights of perspective are not used: edges and spans are interpolated on the screen, as in the papers.
//!
//! Per triangle: three arcs for the normals. Per span: two cuts, two vectors (2 sines and cosines each), and for lights
//! or viewers near by the same again for L and H.

use super::super::circular::{Ends, Sweeps};
use super::super::corners::{Corners, Term};
use super::super::cut::{Cut, Side};
use super::super::quadratic::EDGES;
use super::super::sweep::Sweep;
use super::super::turn::Arc;
use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::Span;
use glam::DVec3;
use smallvec::SmallVec;

/// Slerped ends.
pub struct Slerped;

/// The arcs along the three edges.
#[must_use]
pub fn arcs(v: &[DVec3; 3]) -> [Arc; 3] {
    EDGES.map(|(i, j)| Arc::new(v[i], v[j]))
}

/// The vectors where a row cuts the edges.
#[must_use]
pub fn between(arcs: &[Arc; 3], cut: &Cut) -> [DVec3; 2] {
    [cut.left, cut.right].map(|s: Side| arcs[s.edge].at(s.t))
}

/// A light or half-way vector at the ends of a row.
#[must_use]
pub fn other(v: &[DVec3; 3], term: &Term, cut: &Cut) -> [DVec3; 2] {
    if term.constant {
        [v[0]; 2]
    } else {
        between(&arcs(v), cut)
    }
}

impl Ends for Slerped {
    type Triangle = [Arc; 3];

    fn triangle(&self, _: &Prepared, _: &ScreenTriangle, c: &Corners) -> [Arc; 3] {
        arcs(&c.normal)
    }

    fn sweeps(
        &self,
        t: &ScreenTriangle,
        c: &Corners,
        setup: &[Arc; 3],
        span: Span,
    ) -> SmallVec<[Sweeps; 2]> {
        let cut = Cut::new(&t.position, span);
        let n = between(setup, &cut);
        let sweep =
            |v: &[DVec3; 3], term: &Term| Sweep::new(n, other(v, term, &cut), cut.first, cut.step);
        c.terms
            .iter()
            .map(|term| {
                let highlight = term.shines().then(|| sweep(&term.half, term));
                (sweep(&term.light, term), highlight)
            })
            .collect()
    }
}
