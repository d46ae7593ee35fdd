//! One colour per triangle: the full model at the centroid with the normal of the face (Bouknight 1970).

use super::case::Case;
use super::shader::{Constant, Shader};
use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::Span;

/// The colour of a triangle, LSB, 0..=[`super::KNOT_MAX`].
#[must_use]
pub fn knot(p: &Prepared, t: &ScreenTriangle) -> [f64; 3] {
    let centroid = (t.world[0] + t.world[1] + t.world[2]) / 3.0;
    super::knot(p.surroundings.shade(t.material, centroid, t.face_normal()))
}

/// Bound on the error, LSB: nothing is promised, since the normal of the face need not be near those of the vertices.
/// Where it is at most φ rad from all of them, and so from all blends, [`Case::direction`]`(φ)` holds (proved).
#[must_use]
pub fn bound(case: &Case) -> f64 {
    case.whole()
}

/// The method for the renderer.
pub struct Flat;

impl Shader for Flat {
    type Triangle = [f64; 3];
    type Run<'a> = Constant;

    fn triangle(&self, p: &Prepared, index: usize) -> [f64; 3] {
        knot(p, &p.triangles[index])
    }

    fn start<'a>(&'a self, _: &'a Prepared, colour: &'a [f64; 3], _: Span) -> Constant {
        Constant(*colour)
    }
}
