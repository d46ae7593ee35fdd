//! Quadratic interpolation through six colours, at the vertices and at the middles of the edges on the screen
//! (Abbas 2003 ch. 7; Hast 2004 §3.3.5): I = Σ λᵢ(2λᵢ − 1)·Iᵢ + Σ 4·λᵢλⱼ·Iᵢⱼ.
//!
//! Position and normal of a mid-edge are the perspective-correct ones at the screen middle of the snapped edge, weights
//! wᵢ/(wᵢ + wⱼ) with w = 1/w; the formula is symmetric in i and j, so both triangles at an edge get the same bits.

use super::barycentric::weights;
use super::case::Case;
use super::differences::{Differences, Interpolant};
use super::shader::Shader;
use super::{gouraud, shared, unit_normal};
use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::{Point, Span};
use glam::DVec3;

/// The vertices at the ends of each mid-edge knot.
pub const EDGES: [(usize, usize); 3] = [(0, 1), (0, 2), (1, 2)];

/// RGB at vertices 0, 1, 2 and mid-edges 01, 02, 12; LSB, 0..=[`super::KNOT_MAX`].
#[must_use]
pub fn knots(p: &Prepared, t: &ScreenTriangle) -> [[f64; 3]; 6] {
    let v = gouraud::knots(p, t);
    [
        v[0],
        v[1],
        v[2],
        middle(p, t, 0),
        middle(p, t, 1),
        middle(p, t, 2),
    ]
}

/// RGB at the middle of edge `k` of [`EDGES`].
pub(crate) fn middle(p: &Prepared, t: &ScreenTriangle, k: usize) -> [f64; 3] {
    let (i, j) = EDGES[k];
    let (qi, qj) = middle_weights(t, k);
    let position = t.world[i] * qi + t.world[j] * qj;
    super::knot(p.surroundings.shade(t.material, position, mid_normal(t, k)))
}

/// The unit normal in the middle of edge `k` of [`EDGES`].
pub(crate) fn mid_normal(t: &ScreenTriangle, k: usize) -> DVec3 {
    let (i, j) = EDGES[k];
    let (qi, qj) = middle_weights(t, k);
    unit_normal(t, t.normal[i] * qi + t.normal[j] * qj)
}

/// Perspective weights of the ends of edge `k` in its middle on the screen.
pub(crate) fn middle_weights(t: &ScreenTriangle, k: usize) -> (f64, f64) {
    let (i, j) = EDGES[k];
    let sum = t.inv_w[i] + t.inv_w[j];
    (t.inv_w[i] / sum, t.inv_w[j] / sum)
}

/// Whether the normals at the ends of edge `k` cancel, so that its knot takes the normal of the face and is not shared.
pub(crate) fn cancels(t: &ScreenTriangle, k: usize) -> bool {
    let (i, j) = EDGES[k];
    let (qi, qj) = middle_weights(t, k);
    (t.normal[i] * qi + t.normal[j] * qj).length_squared() <= super::CANCELLED
}

/// RGB at the centre of pixel (`x`, `y`), LSB, not limited.
#[must_use]
pub fn value(position: &[Point; 3], knots: &[[f64; 3]; 6], x: i32, y: i32) -> [f64; 3] {
    blend(knots, weights(position, x, y))
}

/// RGB where the weights on the screen are `w`, LSB, not limited.
pub(crate) fn blend(knots: &[[f64; 3]; 6], w: [f64; 3]) -> [f64; 3] {
    let basis = [
        w[0] * (2.0 * w[0] - 1.0),
        w[1] * (2.0 * w[1] - 1.0),
        w[2] * (2.0 * w[2] - 1.0),
        4.0 * w[0] * w[1],
        4.0 * w[0] * w[2],
        4.0 * w[1] * w[2],
    ];
    [0, 1, 2].map(|c| (0..6).map(|k| basis[k] * knots[k][c]).sum())
}

/// Bound on the error, LSB, for far lights and a far viewer; measured (fitted to the sweep of `tests/accuracy`):
/// third-order in spread·√n for the highlight and in the spread for the diffuse term, and the kinks of both at their
/// terminators. Otherwise the whole range, which six knots overshoot by up to a third (proved: their basis functions
/// have negative parts that sum to −1/3).
#[must_use]
pub fn bound(case: &Case) -> f64 {
    let s = case.spread;
    if !case.is_far_and_acute() || case.shininess < 1.0 {
        return 4.0 / 3.0 * case.whole();
    }
    let z = s * case.shininess.sqrt();
    let diffuse = 0.02 * s.powi(3) + 0.1 * s;
    let specular = 0.02 * z.powi(3) + 0.1 * s.powf(case.shininess);
    case.terms(diffuse.min(4.0 / 3.0), specular.min(4.0 / 3.0))
}

/// The method for the renderer: knots shared between triangles, then forward differences.
pub struct Quadratic {
    knots: Vec<[[f64; 3]; 6]>,
}

impl Quadratic {
    /// Shades every knot of a scene once.
    #[must_use]
    pub fn new(p: &Prepared) -> Self {
        Self {
            knots: shared::square(p),
        }
    }
}

impl Shader for Quadratic {
    type Triangle = Interpolant;
    type Run<'a> = Differences;

    fn triangle(&self, p: &Prepared, index: usize) -> Interpolant {
        Interpolant::quadratic(p.triangles[index].position, &self.knots[index])
    }

    fn start<'a>(&'a self, _: &'a Prepared, i: &'a Interpolant, span: Span) -> Differences {
        i.start(span.start, span.y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_knots_are_met() {
        // Pixel centres: all even and odd multiples of 128 that are 128 mod 256.
        let at = |x: i32, y: i32| Point {
            x: x * 256 + 128,
            y: y * 256 + 128,
        };
        let p = [at(2, 1), at(10, 5), at(4, 21)];
        let knots = [10.0, 20.0, 35.0, 70.0, 5.0, 90.0].map(|v| [v, 2.0 * v, -v]);
        let places = [(2, 1), (10, 5), (4, 21), (6, 3), (3, 11), (7, 13)];
        for (k, (x, y)) in places.into_iter().enumerate() {
            let v = value(&p, &knots, x, y);
            for c in 0..3 {
                assert!((v[c] - knots[k][c]).abs() < 1e-10, "knot {k}: {v:?}");
            }
        }
    }

    #[test]
    fn linear_knots_give_linear_values() {
        let p = [(100, 300), (5000, 700), (1300, 9000)].map(|(x, y)| Point { x, y });
        let three = [[1.0, 50.0, 200.0], [90.0, 7.0, 3.0], [40.0, 120.0, 0.0]];
        let mid = |i: usize, j: usize| [0, 1, 2].map(|c: usize| (three[i][c] + three[j][c]) / 2.0);
        let six = [
            three[0],
            three[1],
            three[2],
            mid(0, 1),
            mid(0, 2),
            mid(1, 2),
        ];
        for (x, y) in [(3, 4), (9, 20), (0, 0)] {
            let (a, b) = (gouraud::value(&p, &three, x, y), value(&p, &six, x, y));
            for c in 0..3 {
                assert!((a[c] - b[c]).abs() < 1e-9);
            }
        }
    }
}
