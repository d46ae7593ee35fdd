//! One colour per triangle: the full model at the centroid with the normal of the face (Bouknight 1970).

use crate::geometry::{Prepared, ScreenTriangle};

/// The colour of a triangle, LSB, 0..=[`super::KNOT_MAX`].
#[must_use]
pub fn knot(p: &Prepared, t: &ScreenTriangle) -> [f64; 3] {
    let centroid = (t.world[0] + t.world[1] + t.world[2]) / 3.0;
    super::knot(p.surroundings.shade(t.material, centroid, t.face_normal()))
}
