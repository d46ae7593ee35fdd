//! Objects beside the frustum: when all eight corners of a bounding box lie outside one plane, so does all within.

use super::camera::View;
use super::clip::Planes;
use glam::DVec3;

/// Whether nothing of `points` can be seen.
#[must_use]
pub fn outside_frustum(view: &View, points: &[DVec3]) -> bool {
    let (mut lo, mut hi) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for p in points {
        (lo, hi) = (lo.min(*p), hi.max(*p));
    }
    let planes = Planes::frustum(view);
    (0..Planes::COUNT).any(|i| {
        (0..8).all(|k| {
            let pick = |axis: usize| {
                if k >> axis & 1 == 0 {
                    lo[axis]
                } else {
                    hi[axis]
                }
            };
            planes.distance(i, view.clip(DVec3::new(pick(0), pick(1), pick(2)))) < 0.0
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Camera, Projection};

    #[test]
    fn before_beside_and_behind() {
        let camera = Camera {
            eye: DVec3::ZERO,
            target: DVec3::NEG_Z,
            up: DVec3::Y,
            projection: Projection::Perspective { fov: 90.0 },
            near: 0.1,
            far: 50.0,
        };
        let view = View::new(&camera, 100, 100);
        let around = |c: DVec3| [c - DVec3::ONE, c + DVec3::ONE];
        assert!(!outside_frustum(&view, &around(DVec3::NEG_Z * 5.0)));
        assert!(!outside_frustum(&view, &around(DVec3::new(5.5, 0.0, -5.0))));
        assert!(outside_frustum(&view, &around(DVec3::new(8.0, 0.0, -5.0))));
        assert!(outside_frustum(&view, &around(DVec3::Z * 5.0)));
        assert!(outside_frustum(&view, &around(DVec3::NEG_Z * 60.0)));
    }
}
