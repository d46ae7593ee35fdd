//! Linear interpolation of vertex colours on the screen (Gouraud 1971): I = Σ λᵢ·Iᵢ.

use super::barycentric::weights;
use super::case::{mean_angle, shortest, Case};
use super::differences::{Differences, Interpolant};
use super::shader::Shader;
use super::{shared, unit_normal};
use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::{Point, Span};

/// RGB at the three vertices, LSB, 0..=[`super::KNOT_MAX`].
#[must_use]
pub fn knots(p: &Prepared, t: &ScreenTriangle) -> [[f64; 3]; 3] {
    [0, 1, 2].map(|i| vertex(p, t, i))
}

/// RGB at vertex `i`.
pub(crate) fn vertex(p: &Prepared, t: &ScreenTriangle, i: usize) -> [f64; 3] {
    super::knot(
        p.surroundings
            .shade(t.material, t.world[i], unit_normal(t, t.normal[i])),
    )
}

/// RGB at the centre of pixel (`x`, `y`), LSB, not limited.
#[must_use]
pub fn value(position: &[Point; 3], knots: &[[f64; 3]; 3], x: i32, y: i32) -> [f64; 3] {
    let w = weights(position, x, y);
    [0, 1, 2].map(|c| (0..3).map(|i| w[i] * knots[i][c]).sum())
}

/// Bound on the error, LSB; proved for far lights and a far viewer and vertex normals at most 90° apart, the whole
/// range otherwise.
///
/// Diffuse: with xᵢ = nᵢ·L and f = max(0, ·), convex, Σ λᵢf(xᵢ) ≥ f(Σ λᵢxᵢ). The two differ by no more than a quarter
/// of the range of the xᵢ, 2·sin(s/2) (two values ±r/2, half each, are the worst), and Σ λᵢxᵢ is the true cosine times
/// the length of the blend. Specular: |Σ λᵢ(cosⁿ θᵢ − cosⁿ θ)| ≤ Σ λᵢ|θᵢ − θ|·slope, and |θᵢ − θ| is at most the angle
/// between nᵢ and the blend.
#[must_use]
pub fn bound(case: &Case) -> f64 {
    if !case.is_far_and_acute() {
        return case.whole();
    }
    let diffuse = (1.0 - shortest(case.spread)).max((case.spread / 2.0).sin() / 2.0);
    let angle = mean_angle(case.spread);
    case.terms(diffuse, case.direction_of_highlight(angle))
}

/// The method for the renderer: knots shared between triangles, then forward differences.
pub struct Gouraud {
    knots: Vec<[[f64; 3]; 3]>,
}

impl Gouraud {
    /// Shades every knot of a scene once.
    #[must_use]
    pub fn new(p: &Prepared) -> Self {
        Self {
            knots: shared::linear(p),
        }
    }
}

impl Shader for Gouraud {
    type Triangle = Interpolant;
    type Run<'a> = Differences;

    fn triangle(&self, p: &Prepared, index: usize) -> Interpolant {
        Interpolant::linear(p.triangles[index].position, &self.knots[index])
    }

    fn start<'a>(&'a self, _: &'a Prepared, i: &'a Interpolant, span: Span) -> Differences {
        i.start(span.start, span.y)
    }
}
