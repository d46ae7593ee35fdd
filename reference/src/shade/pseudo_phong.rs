//! Pseudo-Phong shading: the triangle is divided into small ones, vectors at their vertices are those of Phong shading,
//! and Gouraud's method fills the small ones (as in Tektronix terminals, after Abbas 2003, section 5; neither that text
//! nor the others of this project say how deep to divide).
//!
//! Here: one division into four by the middles of the edges, whose normals are blended, normalised and shaded in full;
//! the knots are those of [`quadratic`](super::quadratic), shared between neighbours, so edges match. The colour is
//! continuous and linear in each part. Any reflection model will do, since only knots are shaded.
//!
//! Work, any number of lights: per triangle 6 shadings, shared; per span and once for each border between parts crossed
//! 27 multiplications; per pixel 3 additions.

use super::barycentric::{steps, weights};
use super::case::{mean_angle, shortest, Case};
use super::shader::{Run, Shader};
use super::shared;
use crate::geometry::Prepared;
use crate::raster::{Point, Span};

/// The method for the renderer.
pub struct PseudoPhong {
    knots: Vec<[[f64; 3]; 6]>,
}

impl PseudoPhong {
    /// Shades every knot of a scene once.
    #[must_use]
    pub fn new(p: &Prepared) -> Self {
        Self {
            knots: shared::square(p),
        }
    }
}

/// One of the four parts, at weights: its knots' weights and their changes.
fn part(w: [f64; 3], d: [f64; 3]) -> ([f64; 6], [f64; 6]) {
    // The mid-edges at the ends of a corner's edges, numbered as knots.
    const MIDDLES: [[usize; 3]; 3] = [[0, 3, 4], [3, 0, 5], [4, 5, 0]];
    let (mut at, mut change) = ([0.0; 6], [0.0; 6]);
    if let Some(i) = (0..3).find(|i| w[*i] > 0.5) {
        (at[i], change[i]) = (2.0 * w[i] - 1.0, 2.0 * d[i]);
        for j in (0..3).filter(|j| *j != i) {
            let m = MIDDLES[i][j];
            (at[m], change[m]) = (2.0 * w[j], 2.0 * d[j]);
        }
    } else {
        for (opposite, m) in [(2, 3), (1, 4), (0, 5)] {
            (at[m], change[m]) = (1.0 - 2.0 * w[opposite], -2.0 * d[opposite]);
        }
    }
    (at, change)
}

/// RGB at barycentric weights, LSB, not limited: the definition, without differences.
#[must_use]
pub fn value(w: [f64; 3], knots: &[[f64; 3]; 6]) -> [f64; 3] {
    blend(&part(w, [0.0; 3]).0, knots)
}

fn blend(w: &[f64; 6], knots: &[[f64; 3]; 6]) -> [f64; 3] {
    [0, 1, 2].map(|c| (0..6).map(|k| w[k] * knots[k][c]).sum())
}

/// Whole pixels until a weight crosses a half, counted from the current one.
fn stay(w: [f64; 3], d: [f64; 3]) -> i32 {
    let inside = (0..3).find(|i| w[*i] > 0.5);
    let crossing = |i: usize| match inside {
        // A corner ends where its own weight falls to a half, the middle where any rises to it.
        Some(corner) if corner == i && d[i] < 0.0 => (w[i] - 0.5) / -d[i],
        None if d[i] > 0.0 => (0.5 - w[i]) / d[i],
        _ => f64::INFINITY,
    };
    // The conversion saturates.
    (0..3).map(crossing).fold(f64::INFINITY, f64::min) as i32
}

/// A span.
pub struct Facets<'a> {
    position: &'a [Point; 3],
    knots: &'a [[f64; 3]; 6],
    x: i32,
    y: i32,
    /// The last pixel of the current part.
    last: i32,
    colour: [f64; 3],
    change: [f64; 3],
}

impl Facets<'_> {
    /// Starts anew in the part that the current pixel lies in.
    fn enter(&mut self) {
        let (w, d) = (weights(self.position, self.x, self.y), steps(self.position));
        let (at, change) = part(w, d);
        self.colour = blend(&at, self.knots);
        self.change = blend(&change, self.knots);
        self.last = self.x.saturating_add(stay(w, d));
    }
}

impl Run for Facets<'_> {
    fn colour(&self) -> [f64; 3] {
        self.colour
    }

    fn step(&mut self) {
        self.x += 1;
        if self.x > self.last {
            self.enter();
        } else {
            for c in 0..3 {
                self.colour[c] += self.change[c];
            }
        }
    }
}

impl Shader for PseudoPhong {
    type Triangle = ([Point; 3], [[f64; 3]; 6]);
    type Run<'a> = Facets<'a>;

    fn triangle(&self, p: &Prepared, index: usize) -> Self::Triangle {
        (p.triangles[index].position, self.knots[index])
    }

    fn start<'a>(
        &'a self,
        _: &'a Prepared,
        (position, knots): &'a Self::Triangle,
        span: Span,
    ) -> Facets<'a> {
        let mut run = Facets {
            position,
            knots,
            x: span.start,
            y: span.y,
            last: 0,
            colour: [0.0; 3],
            change: [0.0; 3],
        };
        run.enter();
        run
    }
}

/// Bound on the error, LSB; proved for a far light and viewer and a spread up to 90°, the whole range otherwise.
///
/// In each part the argument of [`gouraud`](super::gouraud::bound) holds for its own spread, at most that of the middle
/// part of an equilateral triangle, cos = (1 + 3c)/(2 + 2c), but for one thing: the true blend is that of mid-edges
/// before they are normalised, of lengths r = cos(s/2) to 1. It turns the blend of unit vectors, of length at least m,
/// by no more than the arc sine of (1/r − 1)·sin(s'/2)/m, s' the spread of the part, since what two halves of the
/// weights have too much and too little of is the difference of vectors within the part.
#[must_use]
pub fn bound(case: &Case) -> f64 {
    if !case.is_far_and_acute() {
        return case.whole();
    }
    let (c, r) = (case.spread.cos(), (case.spread / 2.0).cos());
    let spread = ((1.0 + 3.0 * c) / (2.0 + 2.0 * c)).min(1.0).acos();
    let turned = (1.0 / r - 1.0) * (spread / 2.0).sin() / shortest(spread);
    let turned = turned.min(1.0).asin();
    let diffuse = (1.0 - shortest(spread)).max((spread / 2.0).sin() / 2.0) + turned;
    let highlight = case.direction_of_highlight(mean_angle(spread) + turned);
    case.terms(diffuse, highlight)
}
