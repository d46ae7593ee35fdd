//! Angular interpolation on a single path: only the place of L relative to N matters, so at every vertex L is turned by
//! the rotation that takes N to one fixed vector O, and the turned vectors Q are interpolated angularly along edges and
//! spans; with s the distance of O from the great circle of Q and q the angle along it from the foot of the perpendicular,
//!
//!   cos θ = cos(q + q_t)·cos s
//!
//! (Kuijk and Blake 1989; Abbas 2003, eq. 5.8, with q signed). One cosine a pixel and light even where L and N both turn.
//!
//! The papers fix O = (0, 0, 1). Rotations that do not share an axis do not keep the distances of the vertices, and the
//! farther N is from O the worse; at N = −O there is none. O is therefore the direction of the sum of the vertex
//! normals; the price is that neighbours have different O, so that values on their shared edge agree at its ends only.
//! A vertex normal opposite to O takes any half turn.
//!
//! Work for one light: per triangle 2 × 3 rotations; per span 2 × 3 arcs, 2 arc tangents, 2 roots; per pixel 2 additions,
//! 2 cosines, 2 multiplications and a power.

use super::angular::across;
use super::case::{slope, Case};
use super::corners::{Corners, Term};
use super::cut::Cut;
use super::form::{Quantity, Start, Step};
use super::lit::Cosines;
use super::turn::carry;
use glam::DVec3;

/// The method; see [`super::lit::Lit`].
pub struct AngularSingle;

/// The turned vectors Q of L and H at the vertices.
pub struct Turned {
    axis: DVec3,
    others: [[DVec3; 3]; 2],
}

/// amplitude·cos(phase): cos s and q + q_t.
#[derive(Clone, Copy, Debug)]
pub struct Wave {
    amplitude: f64,
    phase: f64,
    step: f64,
}

impl Step for Wave {
    fn step(&mut self) {
        self.phase += self.step;
    }
}

impl Quantity for Turned {
    type Walk = [Wave; 2];

    fn start(&self, at: &Start) -> [Wave; 2] {
        let cut = Cut::new(&at.position, at.span);
        self.others.each_ref().map(|q| {
            let arc = across(q, &cut);
            let (from, along) = arc.frame();
            let (x, y) = (from.dot(self.axis), along.dot(self.axis));
            Wave {
                amplitude: x.hypot(y),
                phase: arc.angle * cut.first - y.atan2(x),
                step: arc.angle * cut.step,
            }
        })
    }
}

impl Cosines for AngularSingle {
    type Shared = ();
    type Own = Turned;

    fn shared(&self, _: &Corners) {}

    fn own(&self, c: &Corners, t: &Term) -> Turned {
        let sum: DVec3 = c.normal.iter().sum();
        let axis = sum.try_normalize().unwrap_or(c.normal[0]);
        let turned = |v: [DVec3; 3]| {
            [0, 1, 2].map(|i| {
                carry(v[i], c.normal[i], axis).unwrap_or_else(|| {
                    let half_turn = axis.any_orthonormal_vector();
                    half_turn * (2.0 * half_turn.dot(v[i])) - v[i]
                })
            })
        };
        Turned {
            axis,
            others: [t.light, t.half].map(turned),
        }
    }

    fn cosines((): &(), own: &[Wave; 2]) -> [f64; 2] {
        own.map(|w| w.amplitude * w.phase.cos())
    }
}

/// Bound on the error, LSB, for a far light and viewer and a spread up to 90°, the whole range otherwise. Measured, with
/// some room: over random triangles, lights and rows an angle θ errs by at most s²/16·sin 2θ to the second order (rotations
/// about different axes do not commute), so that a highlight errs little more than a diffuse term as long as s·√n is
/// small.
#[must_use]
pub fn bound(case: &Case) -> f64 {
    let s = case.spread;
    if !case.is_far_and_acute() {
        return case.whole();
    }
    let angle = 0.065 * s * s * (1.0 + 0.45 * s * s);
    let steep = slope(case.shininess);
    // sup sin 2θ·n·sin θ·cosⁿ⁻¹θ is below 3/2; sin 2θ changes by no more than 2s from one place to another.
    let highlight = angle * steep.min(1.5 + 2.0 * s * steep);
    case.terms(
        angle.min(1.0),
        if s > 0.0 { highlight.min(1.0) } else { 0.0 },
    )
}
