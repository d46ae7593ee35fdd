//! Culling before vertices are transformed: never another list of triangles than without it, and most of the work saved.

mod common;

use common::load;
use glam::{DMat4, DQuat, DVec3};
use proptest::prelude::*;
use shadegate_reference::mesh::{sphere::sphere, teapot::teapot, Mesh};
use shadegate_reference::scene::{Camera, Projection};
use shadegate_reference::{Prepared, Scene, Skips};

fn with(scene: &Scene, without: &str) -> Prepared {
    Prepared::new(scene, None, &Skips::without(without).unwrap()).unwrap()
}

/// One object of these triangles under this camera.
fn scene(mesh: Mesh, transform: DMat4, camera: Camera) -> Scene {
    let mut scene = load("gem");
    scene.camera = camera;
    scene.objects.truncate(1);
    scene.objects[0].mesh = mesh;
    scene.objects[0].transform = transform;
    scene
}

fn vector(r: f64) -> impl Strategy<Value = DVec3> {
    (-r..r, -r..r, -r..r).prop_map(|(x, y, z)| DVec3::new(x, y, z))
}

prop_compose! {
    fn transform()(
        scale in vector(1.0), power in -3..4i32, turn in vector(3.0), shift in vector(4.0), far in 0..4i32,
    ) -> DMat4 {
        let scale = scale.map(|v| (v.abs() + 0.05).copysign(v)) * 2f64.powi(power);
        let turn = DQuat::from_scaled_axis(turn);
        DMat4::from_scale_rotation_translation(scale, turn, shift * 100f64.powi(far))
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]
    /// Random triangles and such that are seen edge-on but for some parts in 10 to the `thin`: the ones in doubt.
    #[test]
    fn nothing_that_is_drawn_is_culled_in_object_space(
        transform in transform(),
        corners in prop::collection::vec((vector(1.0), vector(1.0), -3.0..3.0f64, 0..13i32, 0..4i32), 1..40),
        eye in vector(1.0), distance in 1.5..60.0f64, perspective: bool, zoom in 0.05..2.0f64,
    ) {
        let world = |p: DVec3| transform.transform_point3(p);
        let target = world(DVec3::ZERO);
        let size = [DVec3::X, DVec3::Y, DVec3::Z].map(|a| (world(a) - target).length()).iter().sum::<f64>();
        let eye = target + eye.normalize_or(DVec3::Z) * size * distance;
        let camera = Camera {
            eye,
            target,
            up: (eye - target).any_orthogonal_vector(),
            projection: if perspective {
                Projection::Perspective { fov: (zoom * 60.0 / distance).min(150.0) }
            } else {
                Projection::Orthographic { height: size * zoom * 2.0 }
            },
            near: size * 1e-3,
            far: size * 1e4,
        };
        let inverse = transform.inverse();
        let mut mesh = Mesh::default();
        for (a, b, along, thin, small) in corners {
            let b = a + (b - a) * 10f64.powi(-small);
            // The ray through a, in object space.
            let view = if perspective { a - inverse.transform_point3(eye) } else { inverse.transform_vector3(eye - target) };
            let c = a + view.normalize_or(DVec3::Y) * along * 10f64.powi(-small) + (b - a) * along + DVec3::splat(10f64.powi(-thin));
            let first = mesh.positions.len() as u32;
            mesh.positions.extend([a, b, c]);
            mesh.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 1]]);
        }
        mesh.normals = vec![DVec3::ZERO; mesh.positions.len()];
        let scene = scene(mesh, transform, camera);
        let (fast, slow) = (with(&scene, ""), with(&scene, "vertex"));
        prop_assert_eq!(&fast.triangles, &slow.triangles);
        prop_assert_eq!(fast.counts, slow.counts);
        // The whole-object and per-triangle tests against the frustum leave what is in the frame alone as well.
        let wide = with(&scene, "frustum,outside");
        let inside = |p: &Prepared| p.triangles.iter().map(|t| (t.position, t.depth.map(f64::to_bits))).collect::<Vec<_>>();
        prop_assert_eq!(inside(&fast), inside(&wide));
    }
}

#[test]
fn most_back_faces_are_found_before_their_vertices_are_transformed() {
    let mut ball = load("sphere-690");
    (ball.image.width, ball.image.height) = (640, 480);
    ball.objects[0].mesh = sphere(100, 100, 1.0);
    let mut pot = load("teapot");
    (pot.image.width, pot.image.height) = (640, 480);
    pot.objects[0].mesh = teapot(20);
    for (name, scene, share) in [("sphere", &ball, 0.45), ("teapot", &pot, 0.33)] {
        let (fast, slow) = (with(scene, ""), with(scene, "vertex"));
        assert_eq!(fast.triangles, slow.triangles);
        assert_eq!(slow.skipped.get("vertex"), None);
        let vertices: usize = scene.objects.iter().map(|o| o.mesh.positions.len()).sum();
        let skipped = fast.skipped["vertex"] as f64 / vertices as f64;
        assert!(
            skipped > share && skipped < 0.6,
            "{name}: {skipped} of the vertices"
        );
    }
}

#[test]
fn objects_that_lose_their_digits_or_reach_out_of_the_guard_band_are_left_to_the_screen() {
    let mut scene = load("sphere-690");
    assert!(with(&scene, "").skipped["vertex"] > 100);
    // So far away that positions in the world are rounded to 1/4096 of the sphere.
    let shift = DVec3::splat(1e12);
    scene.camera.eye += shift;
    scene.camera.target += shift;
    scene.objects[0].transform = DMat4::from_translation(shift) * scene.objects[0].transform;
    let p = with(&scene, "");
    assert!(p.counts.drawn > 0);
    assert_eq!(p.skipped.get("vertex"), None);

    let scene = load("two-lights");
    let (fast, slow) = (with(&scene, ""), with(&scene, "vertex"));
    assert!(fast.counts.clipped > 0);
    assert_eq!(fast.triangles, slow.triangles);
}
