//! Five answers to what is seen at each pixel, on the scenes and on what each of the ways finds hard.

mod common;

use common::{load, prepare, SCENES};
use glam::DVec3;
use proptest::prelude::*;
use shadegate_reference::mesh::Mesh;
use shadegate_reference::raster::covers;
use shadegate_reference::scene::{Camera, Projection};
use shadegate_reference::visibility::zbuffer::{Stored, Word};
use shadegate_reference::visibility::{
    bsp, compare, painter, raycast, scanline, zbuffer, Comparison, Visible, NONE,
};
use shadegate_reference::{render, Method, Prepared, RenderOptions, Scene, Skips};

/// All ways but the rays, by name.
fn all_ways(p: &Prepared) -> Vec<(&'static str, Visible)> {
    let tree = bsp::Tree::new(p);
    let (painted, counts) = painter::draw(p);
    assert_eq!(counts.unresolved, 0, "{counts:?}");
    vec![
        ("painter", painted),
        ("bsp back to front", tree.back_to_front(p)),
        ("bsp front to back", tree.front_to_back(p)),
        ("scan-line", scanline::draw(p)),
    ]
}

/// The same triangle everywhere but where depths tie.
fn assert_agree(name: &str, p: &Prepared) -> u64 {
    let z = zbuffer::draw(p, Stored::Real);
    let mut ties = 0;
    for (way, got) in all_ways(p) {
        let Comparison { ties: t, wrong, .. } = compare(p, &z, &got, 0.0);
        assert!(
            wrong.is_empty(),
            "{name}: {way}: {} pixels, first {:?}",
            wrong.len(),
            wrong[0]
        );
        assert!(got.written >= got.seen() && z.seen() == got.seen());
        if way.contains("front to back") || way == "scan-line" {
            assert_eq!(got.written, got.seen(), "{name}: {way}: once each");
        }
        ties += t;
    }
    ties
}

/// Rays know nothing of snapping: beside a border, another triangle may be seen. Pixels beside borders.
fn assert_rays_agree(name: &str, scene: &Scene, p: &Prepared) -> u64 {
    let z = zbuffer::draw(p, Stored::Real);
    let rays = raycast::Rays::new(&scene.camera, p.width, p.height);
    let cast = raycast::draw(p, &scene.camera);
    let mut beside = 0;
    for (x, y) in compare(p, &z, &cast, 0.0).wrong {
        // Some triangle's border runs past the pixel centre at less than 1/64 pixel.
        let around = |dx: f64, dy: f64| {
            let ray = rays.at(f64::from(x) + 0.5 + dx, f64::from(y) + 0.5 + dy);
            let inside = |t| raycast::hit(t, ray).is_some_and(|(d, w)| d > 0.0 && w >= 0.0);
            p.triangles.iter().map(inside).collect::<Vec<_>>()
        };
        let here = around(0.0, 0.0);
        let step = 1.0 / 64.0;
        let changes = [(step, 0.0), (-step, 0.0), (0.0, step), (0.0, -step)]
            .iter()
            .any(|(dx, dy)| around(*dx, *dy) != here);
        assert!(changes, "{name}: pixel {x} {y} is inside all it shows");
        beside += 1;
    }
    beside
}

#[test]
fn every_way_sees_the_same_in_every_scene() {
    for name in SCENES {
        for skips in [Skips::all(), Skips::without("back-face").unwrap()] {
            let p = Prepared::new(&load(name), Some((160, 120)), &skips).unwrap();
            let ties = assert_agree(name, &p);
            let seen = zbuffer::draw(&p, Stored::Real).seen();
            assert!(ties < seen / 20, "{name}: {ties} ties of {seen}");
        }
    }
}

#[test]
fn rays_see_the_same_in_every_scene() {
    for name in SCENES {
        let (scene, p) = (load(name), prepare(name, Some((72, 54))));
        let beside = assert_rays_agree(name, &scene, &p);
        assert!(beside * 50 <= 72 * 54, "{name}: {beside} pixels at borders");
    }
}

/// A scene of triangles that face a camera at z = 5.
fn triangles(all: &[[[f64; 3]; 3]]) -> Scene {
    let mut scene = load("gem");
    scene.camera = Camera {
        eye: DVec3::new(0.0, 0.0, 5.0),
        target: DVec3::ZERO,
        up: DVec3::Y,
        projection: Projection::Perspective { fov: 40.0 },
        near: 0.1,
        far: 100.0,
    };
    scene.objects.truncate(1);
    let mut mesh = Mesh::default();
    for t in all {
        let mut t = t.map(DVec3::from_array);
        if (t[1] - t[0])
            .cross(t[2] - t[0])
            .dot(scene.camera.eye - t[0])
            < 0.0
        {
            t.swap(1, 2);
        }
        let first = mesh.positions.len() as u32;
        mesh.positions.extend(t);
        mesh.triangles.push([first, first + 1, first + 2]);
    }
    mesh.normals = vec![DVec3::ZERO; mesh.positions.len()];
    scene.objects[0].mesh = mesh;
    scene.objects[0].transform = glam::DMat4::IDENTITY;
    scene
}

/// Three long triangles, each over the next.
fn cycle() -> Scene {
    let third = |k: f64| {
        let turn = |x: f64, y: f64, z: f64| {
            let (s, c) = (k * std::f64::consts::TAU / 3.0).sin_cos();
            [c * x - s * y, s * x + c * y, z]
        };
        [
            turn(-1.3, -0.65, 0.4),
            turn(1.3, -0.65, -0.4),
            turn(1.3, -0.25, -0.4),
        ]
    };
    triangles(&[third(0.0), third(1.0), third(2.0)])
}

#[test]
fn a_cycle_is_cut() {
    let scene = cycle();
    for size in [(80, 60), (320, 240)] {
        let p = Prepared::new(&scene, Some(size), &Skips::all()).unwrap();
        assert_eq!(p.triangles.len(), 3);
        let (_, counts) = painter::draw(&p);
        assert_eq!((counts.interpenetrating, counts.unresolved), (0, 0));
        assert!(counts.cycles >= 1 && counts.cuts >= 1, "{counts:?}");
        assert!(bsp::Tree::new(&p).splits >= 1);
        assert_agree("cycle", &p);
        assert_rays_agree("cycle", &scene, &p);
        // Without a cut no order is right, and the sort alone shows it.
        let z = zbuffer::draw(&p, Stored::Real);
        let cheap = painter::draw_by_farthest(&p);
        assert!(compare(&p, &z, &cheap, 0.0).wrong.len() > 5);
    }
}

#[test]
fn triangles_through_each_other_are_cut() {
    let scene = triangles(&[
        [[-1.5, -1.0, 0.5], [1.5, -1.0, -0.5], [0.0, 1.2, 0.0]],
        [[-1.5, -0.8, -0.6], [1.5, -0.8, 0.6], [0.1, 1.3, 0.1]],
        [[-1.0, 1.0, -0.7], [1.0, 1.0, -0.7], [0.0, -1.4, 0.9]],
    ]);
    let p = Prepared::new(&scene, Some((240, 180)), &Skips::all()).unwrap();
    let (_, counts) = painter::draw(&p);
    assert!(
        counts.interpenetrating >= 3 && counts.cuts >= 3,
        "{counts:?}"
    );
    assert!(bsp::Tree::new(&p).splits >= 2);
    assert_agree("through", &p);
    assert_rays_agree("through", &scene, &p);
    let z = zbuffer::draw(&p, Stored::Real);
    let cheap = painter::draw_by_farthest(&p);
    assert!(compare(&p, &z, &cheap, 0.0).wrong.len() > 500);
}

#[test]
fn of_coplanar_faces_the_first_is_seen() {
    // Facing the camera: for all but the z-buffer, whose weights are rounded, depths are the same numbers everywhere.
    let scene = triangles(&[
        [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]],
        [[-1.0, 0.8, 0.0], [1.0, 0.8, 0.0], [0.0, -1.2, 0.0]],
        [[-0.5, 0.0, 0.0], [1.5, 0.1, 0.0], [0.0, 1.2, 0.0]],
    ]);
    let p = Prepared::new(&scene, Some((160, 120)), &Skips::all()).unwrap();
    let first = |k: u32| {
        let at = ((k % 160) as i32, (k / 160) as i32);
        (0..3).find(|i| covers(p.triangles[*i as usize].position, at.0, at.1))
    };
    let want: Vec<u32> = (0..160 * 120).map(|k| first(k).unwrap_or(NONE)).collect();
    for (way, v) in all_ways(&p) {
        assert!(v.ids == want, "{way}");
    }
    assert!([0, 1, 2].iter().all(|id| want.contains(id)));
    assert_agree("coplanar", &p);
    // Tilted: ties to the last bit are luck, ties within the tolerance are not.
    let tilt = |[x, y, _]: [f64; 3]| [x, y, 0.3 * x - 0.7 * y];
    let scene = triangles(&[
        [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]].map(tilt),
        [[-1.0, 0.8, 0.0], [1.0, 0.8, 0.0], [0.0, -1.2, 0.0]].map(tilt),
    ]);
    let p = Prepared::new(&scene, Some((160, 120)), &Skips::all()).unwrap();
    assert_agree("tilted", &p);
}

fn corner() -> impl Strategy<Value = [f64; 3]> {
    (-2.0..2.0f64, -1.5..1.5f64, -3.0..3.0f64).prop_map(|(x, y, z)| [x, y, z])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(250))]
    /// Heaps of triangles in any position: most pass through each other.
    #[test]
    fn every_way_sees_the_same_in_a_heap(all in prop::collection::vec([corner(), corner(), corner()], 1..14)) {
        let scene = triangles(&all);
        let p = Prepared::new(&scene, Some((48, 36)), &Skips::all()).unwrap();
        assert_agree("heap", &p);
    }
}

#[test]
fn the_renderer_sees_what_the_z_buffer_sees() {
    // Each object in a flat colour of its own, so that colours are ids.
    for name in ["two-lights", "rings"] {
        let mut scene = load(name);
        scene.lights.clear();
        let model = scene.materials[0].clone();
        scene.materials = (0..scene.objects.len())
            .map(|i| {
                let mut m = model.clone();
                m.ambient = DVec3::splat((i + 1) as f64 * 20.0 / 255.0);
                m
            })
            .collect();
        for (i, o) in scene.objects.iter_mut().enumerate() {
            o.material = i;
        }
        let p = Prepared::new(&scene, Some((160, 120)), &Skips::all()).unwrap();
        let (frame, stats) = render(&p, Method::Exact, &RenderOptions::default());
        let z = zbuffer::draw(&p, Stored::Real);
        assert_eq!(stats.pixels_written, z.written, "{name}: overdraw");
        for (pixel, id) in frame.pixels.iter().zip(&z.ids) {
            let want = match *id {
                NONE => p.background,
                id => [(p.triangles[id as usize].object as u8 + 1) * 20; 3],
            };
            assert_eq!(*pixel, want, "{name}");
        }
    }
}

/// Two layers a given distance apart, seen by buffers of several word lengths: confused below the resolution and not
/// above it.
#[test]
fn words_of_a_depth_buffer_confuse_layers_below_their_resolution() {
    let layers = |z: f64, apart: f64| {
        // The farther one first, tilted so that every phase of the depth grid occurs.
        let quad = |z: f64| {
            let (w, t) = (0.3 * z, 0.01 * z);
            [
                [[-w, -w, -z - t], [w, -w, -z + t], [w, w, -z + t]],
                [[-w, -w, -z - t], [w, w, -z + t], [-w, w, -z - t]],
            ]
        };
        let mut all = quad(z + apart).to_vec();
        all.extend(quad(z));
        let mut scene = triangles(&all);
        scene.camera.eye = DVec3::ZERO;
        scene.camera.target = DVec3::NEG_Z;
        scene.camera.far = 1e6;
        Prepared::new(&scene, Some((200, 150)), &Skips::all()).unwrap()
    };
    for bits in [16, 18, 24] {
        for z in [2.0, 10.0, 100.0] {
            let word = Word {
                bits,
                near: 1.0,
                far: 1000.0,
            };
            for inverse in [true, false] {
                let (stored, resolution) = if inverse {
                    (Stored::Inverse(word), word.resolution_of_inverse(z))
                } else {
                    (Stored::Z(word), word.resolution_of_z())
                };
                let wrong = |apart: f64| {
                    let p = layers(z, apart * resolution);
                    let v = zbuffer::draw(&p, stored);
                    let far = v.ids.iter().filter(|id| **id < 2).count();
                    far as f64 / v.seen() as f64
                };
                // The tilt changes the resolution by 2 % to either side.
                let (half, clear) = (wrong(0.5), wrong(1.1));
                assert!(
                    (half - 0.5).abs() < 0.12 && clear == 0.0,
                    "F={bits} z={z} inverse={inverse}: {half} {clear}"
                );
            }
        }
    }
}

#[test]
fn on_the_scenes_24_bits_are_enough_and_words_of_z_and_of_its_inverse_agree() {
    for name in ["teapot", "two-lights", "rings"] {
        let p = prepare(name, Some((160, 120)));
        let z = zbuffer::draw(&p, Stored::Real);
        let word = Word::of(&p, 24);
        for stored in [Stored::Inverse(word), Stored::Z(word)] {
            let v = zbuffer::draw(&p, stored);
            // A step of 2^-24 of far/near, in units of reversed depth, on either side.
            let resolution = 4.0 * word.far / word.near / f64::from(1 << 24);
            let c = compare(&p, &z, &v, resolution);
            assert!(
                c.wrong.is_empty() && c.ties < 100,
                "{name} {stored:?} {c:?}"
            );
        }
    }
}
