//! Two answers to what is seen, side by side.
//!
//! Vertices are snapped, which moves each by at most 1/512 pixel in x and in y, and with it the point of a face that lies
//! over a pixel centre. The depth there changes by at most the steepness of the face (|∂d/∂x| + |∂d/∂y|) over 512; two
//! faces may disagree by the sum. The tolerance is twice that, since the slopes are those of the snapped face, and what
//! the resolution of a depth buffer adds.

use super::{DepthPlane, Visible, NONE};
use crate::geometry::Prepared;

/// What came of a comparison, in pixels.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Comparison {
    /// The same triangle is seen.
    pub equal: u64,
    /// Another triangle, as near within the tolerance.
    pub ties: u64,
    /// Another triangle though one is nearer, or something here and nothing there.
    pub wrong: Vec<(u32, u32)>,
}

/// Twice 1/512 pixel.
const SNAP: f64 = 1.0 / 256.0;
/// Rounding of depths near 1.
const ROUNDING: f64 = 1e-12;

/// How far apart the reversed depths of triangles `a` and `b` may be and still tie.
#[must_use]
pub fn tolerance(p: &Prepared, a: u32, b: u32, resolution: f64) -> f64 {
    let steepness = |i: u32| DepthPlane::new(&p.triangles[i as usize]).steepness();
    resolution + ROUNDING + SNAP * (steepness(a) + steepness(b))
}

/// Compares pixel by pixel; `resolution` is the step of a depth buffer that took part, in units of reversed depth.
///
/// # Panics
/// When one of the two is not of the frame of `p`.
#[must_use]
pub fn compare(p: &Prepared, one: &Visible, other: &Visible, resolution: f64) -> Comparison {
    let mut result = Comparison::default();
    assert!(
        [one, other]
            .iter()
            .all(|v| (v.width, v.height) == (p.width, p.height)),
        "frames of one scene and size"
    );
    for (k, (a, b)) in one.ids.iter().zip(&other.ids).enumerate() {
        let (x, y) = (k as u32 % p.width, k as u32 / p.width);
        let depth = |i: u32| {
            DepthPlane::new(&p.triangles[i as usize]).at(f64::from(x) + 0.5, f64::from(y) + 0.5)
        };
        if a == b {
            result.equal += 1;
        } else if *a != NONE
            && *b != NONE
            && (depth(*a) - depth(*b)).abs() <= tolerance(p, *a, *b, resolution)
        {
            result.ties += 1;
        } else {
            result.wrong.push((x, y));
        }
    }
    result
}
