//! Ends of spans by the blend of all three vertices, normalised, at the centres of the first and the last pixel: with
//! the weights of perspective it is the true normal there, so the ends of every span are exact and only the pixels
//! between are interpolated. For a span of k steps the first pixel is 0 and the last one 1, as the trig-free set-up
//! (Hast 2004, section 3.2.7) needs it.
//!
//! Per span: two blends, normalised (9 mul 6 add, a root and a division each), and the same for L and H of near lights.

use super::super::barycentric::weights;
use super::super::circular::{Ends, Sweeps};
use super::super::corners::{Corners, Term};
use super::super::sweep::Sweep;
use super::super::unit_normal;
use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::Span;
use glam::DVec3;
use smallvec::SmallVec;

/// Blended ends.
pub struct Blended;

impl Ends for Blended {
    type Triangle = ();

    fn triangle(&self, _: &Prepared, _: &ScreenTriangle, _: &Corners) {}

    fn weights(&self, c: &Corners, w: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|i| w[i] * c.weight[i])
    }

    fn sweeps(
        &self,
        t: &ScreenTriangle,
        c: &Corners,
        (): &(),
        span: Span,
    ) -> SmallVec<[Sweeps; 2]> {
        let steps = span.end - 1 - span.start;
        let step = if steps > 0 {
            1.0 / f64::from(steps)
        } else {
            0.0
        };
        let q = [span.start, span.end - 1].map(|x| {
            let w = weights(&t.position, x, span.y);
            self.weights(c, w)
        });
        let blend = |v: &[DVec3; 3]| q.map(|q| v[0] * q[0] + v[1] * q[1] + v[2] * q[2]);
        let n = blend(&t.normal).map(|n| unit_normal(t, n));
        let sweep = |v: &[DVec3; 3], term: &Term| {
            let ends = if term.constant {
                [v[0]; 2]
            } else {
                blend(v).map(DVec3::normalize_or_zero)
            };
            Sweep::new(n, ends, 0.0, step)
        };
        c.terms
            .iter()
            .map(|term| {
                let highlight = term.shines().then(|| sweep(&term.half, term));
                (sweep(&term.light, term), highlight)
            })
            .collect()
    }
}
