//! What lies beside the frustum: when all points of a convex set lie outside one plane, so does all within. Tested for
//! objects on the corners of their bounding box, and for triangles on their vertices.

use super::camera::{Clip, View};
use super::clip::Planes;
use crate::parallel;
use glam::{DMat4, DVec3};

/// Roundings on the way to a distance, relative to what it is computed from, stay far below this.
const SLACK: f64 = 1e-12;

/// The corners of the box around `points`; none for no points.
#[must_use]
pub fn corners(points: &[DVec3]) -> Option<[DVec3; 8]> {
    let first = *points.first()?;
    let part = |(lo, hi): (DVec3, DVec3), p: &DVec3| (lo.min(*p), hi.max(*p));
    let size = parallel::share(points.len(), 8192, 4);
    let boxes = parallel::parts(
        points.len(),
        size,
        || (),
        |(), range| points[range].iter().fold((first, first), part),
    );
    let whole = |(lo, hi): (DVec3, DVec3), b: (DVec3, DVec3)| (lo.min(b.0), hi.max(b.1));
    let (lo, hi) = boxes.into_iter().fold((first, first), whole);
    Some([0, 1, 2, 3, 4, 5, 6, 7].map(|k| {
        let pick = |axis: usize| if k >> axis & 1 == 0 { lo } else { hi }[axis];
        DVec3::new(pick(0), pick(1), pick(2))
    }))
}

/// Whether nothing of the box with these corners, in the space that `transform` takes to the world, can be seen.
#[must_use]
pub fn box_outside(view: &View, transform: DMat4, corners: &[DVec3; 8]) -> bool {
    let all = corners.map(|c| view.clip(transform.transform_point3(c)));
    // The terms that a distance is computed from may be larger than the distance.
    let size = |m: DMat4, p: DVec3| {
        let p = p.abs();
        [
            (m.x_axis, p.x),
            (m.y_axis, p.y),
            (m.z_axis, p.z),
            (m.w_axis, 1.0),
        ]
        .map(|(axis, by)| axis.truncate().abs().max_element() * by)
        .iter()
        .sum::<f64>()
    };
    let world = corners
        .iter()
        .map(|c| size(transform, *c))
        .fold(0.0, f64::max);
    let terms = size(view.to_view(), DVec3::splat(world)) * (1.0 + view.focal());
    beyond_a_plane(&Planes::frustum(view), &all, terms)
}

/// Whether nothing of the hull of `points` can be seen, because all are outside one and the same plane.
#[must_use]
pub fn outside(planes: &Planes, points: &[Clip]) -> bool {
    let terms = points
        .iter()
        .map(|c| c.x.abs() + c.y.abs() + c.w.abs() + c.depth.abs())
        .fold(0.0, f64::max);
    beyond_a_plane(planes, points, terms)
}

fn beyond_a_plane(planes: &Planes, points: &[Clip], terms: f64) -> bool {
    let outer = -SLACK * terms;
    (0..Planes::COUNT).any(|i| points.iter().all(|c| planes.distance(i, *c) < outer))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Camera, Projection};
    use proptest::prelude::*;

    fn view() -> View {
        let camera = Camera {
            eye: DVec3::ZERO,
            target: DVec3::NEG_Z,
            up: DVec3::Y,
            projection: Projection::Perspective { fov: 90.0 },
            near: 0.1,
            far: 50.0,
        };
        View::new(&camera, 100, 100)
    }

    #[test]
    fn before_beside_and_behind() {
        let around = |c: DVec3| {
            let corners = corners(&[DVec3::NEG_ONE, DVec3::ONE]).unwrap();
            box_outside(&view(), DMat4::from_translation(c), &corners)
        };
        assert!(!around(DVec3::NEG_Z * 5.0));
        assert!(!around(DVec3::new(5.5, 0.0, -5.0)));
        assert!(around(DVec3::new(8.0, 0.0, -5.0)));
        assert!(around(DVec3::Z * 5.0));
        assert!(around(DVec3::NEG_Z * 60.0));
        assert_eq!(corners(&[]), None);
    }

    fn point() -> impl Strategy<Value = DVec3> {
        (-9.0..9.0, -9.0..9.0, -60.0..9.0).prop_map(|(x, y, z)| DVec3::new(x, y, z))
    }

    proptest! {
        /// What is called outside has no point that projects into the frame between near and far.
        #[test]
        fn nothing_visible_is_outside(a in point(), b in point(), c in point(), s in 0.0..1.0f64, t in 0.0..1.0f64) {
            let view = view();
            let inside = |p: DVec3| {
                let w = -p.z;
                (0.1..=50.0).contains(&w) && p.x.abs() <= w && p.y.abs() <= w
            };
            let p = a + (b - a) * s + (c - b) * s * t;
            if inside(p) {
                prop_assert!(!outside(&Planes::frustum(&view), &[a, b, c].map(|p| view.clip(p))));
                let corners = corners(&[a, b, c]).unwrap();
                prop_assert!(!box_outside(&view, DMat4::IDENTITY, &corners));
            }
        }
    }
}
