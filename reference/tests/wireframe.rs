//! Wireframes: every edge once, hidden where a ray says so, the edges of what is in front always there.

mod common;

use common::{difference, draw, load, prepare};
use glam::{DMat4, DVec3};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_reference::geometry::WireEdge;
use shadegate_reference::line::cue::Cue;
use shadegate_reference::line::wireframe::hidden_parts;
use shadegate_reference::line::LineFilter;
use shadegate_reference::scene::Projection;
use shadegate_reference::{render, Frame, Method, Prepared, RenderOptions, Scene, Skips};

const SCENES: [&str; 3] = ["wire-40", "wire-48", "depth-cue"];

fn prepared(scene: &Scene, skips: &str) -> Prepared {
    Prepared::new(scene, None, &Skips::without(skips).unwrap()).unwrap()
}

/// Euler: a closed surface like a ball has half as many edges again as faces.
#[test]
fn every_edge_is_there_once() {
    for (name, faces) in [("wire-40", 40), ("wire-48", 48)] {
        let scene = load(name);
        assert_eq!(scene.objects[0].mesh.triangles.len(), faces);
        let all = prepared(&scene, "back-edge");
        assert_eq!(all.wires.edges.len(), faces * 3 / 2, "{name}");
        assert!(all.skipped.is_empty());
        let front = prepared(&scene, "");
        let left = front.wires.edges.len() as u64;
        assert_eq!(left + front.skipped["back-edge"], faces as u64 * 3 / 2);
        assert!(left < faces as u64 * 3 / 2 && left > faces as u64 * 3 / 4);
        assert!(front.triangles.is_empty());
    }
    // A box keeps its vertices apart by face; its edges are shared nevertheless.
    let mut scene = load("depth-cue");
    scene.objects.remove(0);
    scene.objects.remove(0);
    assert_eq!(prepared(&scene, "back-edge").wires.edges.len(), 48 * 3 / 2);
}

/// Nearest hit of a ray with any triangle of the scene in the world.
fn cast(world: &[[DVec3; 3]], origin: DVec3, direction: DVec3) -> f64 {
    let mut nearest = f64::INFINITY;
    for [a, b, c] in world {
        let (e1, e2) = (*b - *a, *c - *a);
        let p = direction.cross(e2);
        let det = e1.dot(p);
        if det.abs() < 1e-14 {
            continue;
        }
        let s = origin - *a;
        let (u, q) = (s.dot(p) / det, s.cross(e1));
        let (v, d) = (direction.dot(q) / det, e2.dot(q) / det);
        if u >= 0.0 && v >= 0.0 && u + v <= 1.0 && d > 0.0 {
            nearest = nearest.min(d);
        }
    }
    nearest
}

/// The point of an edge at share `t` of its length on the screen.
fn point(e: &WireEdge, perspective: bool, t: f64) -> DVec3 {
    let [z0, z1] = e.depth;
    let s = if perspective && (z1 - z0).abs() > 1e-9 {
        (1.0 / ((1.0 - t) / z0 + t / z1) - z0) / (z1 - z0)
    } else {
        t
    };
    e.world[0].lerp(e.world[1], s)
}

#[test]
fn rays_agree_on_what_is_hidden() {
    for name in SCENES {
        let scene = load(name);
        let p = prepared(&scene, "back-edge");
        let world: Vec<[DVec3; 3]> = scene
            .objects
            .iter()
            .flat_map(|o| {
                let at = |i: u32| o.transform.transform_point3(o.mesh.positions[i as usize]);
                o.mesh
                    .triangles
                    .iter()
                    .map(move |t| t.map(at))
                    .collect::<Vec<_>>()
            })
            .collect();
        let camera = &scene.camera;
        let perspective = matches!(camera.projection, Projection::Perspective { .. });
        let hidden = hidden_parts(&p.wires, p.width, p.height);
        let (mut seen, mut unseen, mut doubtful) = (0, 0, 0);
        for (e, parts) in p.wires.edges.iter().zip(&hidden) {
            for k in 0..11 {
                let t = (f64::from(k) + 0.5) / 11.0;
                let at = point(e, perspective, t);
                // By how much the first face is in front of the point, for rays that pass it closely.
                let gaps =
                    [(0.0, 0.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)].map(|(u, v)| {
                        let view = (camera.target - camera.eye).normalize();
                        let right = view.cross(camera.up).normalize();
                        let at = at + (right * u + right.cross(view) * v) * 5e-4;
                        let (origin, far) = if perspective {
                            (camera.eye, camera.eye.distance(at))
                        } else {
                            (at - view * 9.0, 9.0)
                        };
                        far - cast(&world, origin, (at - origin).normalize())
                    });
                let least = gaps.iter().copied().fold(f64::INFINITY, f64::min);
                let most = gaps.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                let is_hidden = parts.iter().any(|[a, b]| (*a..=*b).contains(&t));
                if least > 0.02 {
                    assert!(is_hidden, "{name}: {e:?} at {t}: {parts:?} {gaps:?}");
                    unseen += 1;
                } else if most < 0.002 {
                    assert!(!is_hidden, "{name}: {e:?} at {t}");
                    seen += 1;
                } else {
                    doubtful += 1;
                }
            }
        }
        println!("{name}: {seen} seen, {unseen} hidden, {doubtful} too close to say");
        assert!(
            seen > 200 && unseen > 150 && doubtful * 3 < seen + unseen,
            "{name}"
        );
    }
}

/// A convex object in any position: edges of front faces are never hidden, not even partly; edges of back faces always,
/// but for what lies within a sub-pixel of the outline.
#[test]
fn front_edges_are_whole_and_back_edges_are_not_there() {
    let mut rng = StdRng::seed_from_u64(11);
    let (mut columns, mut shown) = (0, 0);
    for round in 0..300 {
        let mut scene = load("wire-48");
        if round % 2 == 0 {
            scene.objects[0].mesh = shadegate_reference::mesh::solids::cube(1 + round as u32 % 4);
        }
        if round % 3 == 0 {
            scene.camera.projection = Projection::Perspective { fov: 30.0 };
            scene.camera.eye.z = 6.0;
        }
        let turn = DMat4::from_euler(
            glam::EulerRot::XYZ,
            rng.random_range(0.0..6.3),
            rng.random_range(0.0..6.3),
            rng.random_range(0.0..6.3),
        );
        // A few positions are exactly level: faces edge-on.
        let turn = if round % 25 == 0 {
            DMat4::IDENTITY
        } else {
            turn
        };
        scene.objects[0].transform =
            turn * DMat4::from_scale(DVec3::splat(rng.random_range(0.05..0.6)));
        let front = prepared(&scene, "").wires;
        let parts = hidden_parts(&front, 320, 240);
        assert!(parts.iter().all(Vec::is_empty), "round {round}");
        let all = prepared(&scene, "back-edge").wires;
        let parts = hidden_parts(&all, 320, 240);
        for (e, parts) in all.edges.iter().zip(&parts) {
            if front.edges.iter().any(|f| f.sight == e.sight) {
                continue;
            }
            for k in 0..20 {
                let t = (f64::from(k) + 0.5) / 20.0;
                columns += 1;
                shown += usize::from(!parts.iter().any(|[a, b]| (*a..=*b).contains(&t)));
            }
        }
    }
    println!("{shown} of {columns} places on back edges are within a sub-pixel of the outline");
    assert!(
        columns > 50_000 && shown * 100 < columns,
        "{shown} of {columns}"
    );
}

#[test]
fn leaving_out_back_edges_leaves_the_frame_as_it_is() {
    for name in SCENES {
        let scene = load(name);
        let [with, without] =
            ["", "back-edge"].map(|s| draw(&prepared(&scene, s), Method::Gouraud));
        let (max, rms) = difference(&with, &without);
        assert_eq!(max, 0, "{name}: rms {rms}");
    }
}

#[test]
fn wires_are_the_same_for_all_methods_threads_and_orders_of_ends() {
    let p = prepare("wire-48", None);
    let want = draw(&p, Method::Exact);
    assert!(want.pixels.iter().filter(|c| **c != p.background).count() > 3000);
    for method in Method::ALL.iter().copied() {
        for threads in [1, 3] {
            let o = RenderOptions {
                threads: Some(threads),
                ..RenderOptions::default()
            };
            assert!(render(&p, method, &o).0 == want, "{method}");
        }
    }
    let mut scene = load("wire-48");
    for t in &mut scene.objects[0].mesh.triangles {
        t.rotate_left(1);
    }
    // Edges of one nearness are blended in the order of the mesh, which may turn a rounding.
    let (max, _) = difference(&draw(&prepared(&scene, ""), Method::Exact), &want);
    assert!(max <= 1, "{max}");
}

#[test]
fn filters_are_what_they_are_called() {
    let mut scene = load("wire-40");
    let mut lit = |filter| {
        scene.render.line = filter;
        let p = prepared(&scene, "");
        let frame = draw(&p, Method::Exact);
        let levels: std::collections::HashSet<_> = frame.pixels.iter().copied().collect();
        (
            frame.pixels.iter().filter(|c| **c != p.background).count(),
            levels.len(),
        )
    };
    let (bresenham, box_, cone) = (
        lit(LineFilter::Bresenham),
        lit(LineFilter::Box),
        lit(LineFilter::Cone),
    );
    assert_eq!(bresenham.1, 2, "two levels: line and background");
    assert!(
        bresenham.0 < box_.0 && box_.0 < cone.0,
        "{bresenham:?} {box_:?} {cone:?}"
    );
    assert!(box_.1 > 50 && cone.1 > 50);
}

#[test]
fn cueing_dims_with_distance() {
    let mut scene = load("wire-48");
    let mut frame = |near, far| {
        scene.render.cue = Cue { near, far };
        draw(&prepared(&scene, ""), Method::Exact)
    };
    let (plain, cued, half) = (frame(1.0, 1.0), frame(1.0, 0.4), frame(0.5, 0.5));
    let sum = |f: &Frame| {
        f.pixels
            .iter()
            .flatten()
            .map(|v| u64::from(*v))
            .sum::<u64>()
    };
    for (a, b) in plain.pixels.iter().zip(&cued.pixels) {
        assert!((0..3).all(|c| b[c] <= a[c]), "{a:?} {b:?}");
    }
    assert!(sum(&cued) < sum(&plain) && sum(&half) < sum(&cued));
    // The vertex nearest to the viewer keeps its brightness, those of the outline are half-way between.
    let brightest = |f: &Frame| f.pixels.iter().map(|c| c[0]).max().unwrap();
    assert!(brightest(&plain) - brightest(&cued) <= 6);
}

/// Faces of shaded objects hide wires, and wires do not change what is shaded beside them.
#[test]
fn shaded_objects_hide_wires_and_keep_their_colours() {
    let scene = load("depth-cue");
    let with = draw(&prepared(&scene, ""), Method::Exact);
    let mut ball = scene.clone();
    ball.objects.truncate(1);
    let alone = draw(&prepared(&ball, ""), Method::Exact);
    let lit = |f: &Frame, i: usize| f.pixels[i] != ball.image.background;
    let n = with.pixels.len();
    let ball_pixels = (0..n).filter(|i| lit(&alone, *i)).count();
    let kept = (0..n)
        .filter(|i| lit(&alone, *i) && with.pixels[*i] == alone.pixels[*i])
        .count();
    assert!(
        kept > ball_pixels / 3 && kept < ball_pixels,
        "{kept} of {ball_pixels}"
    );
    // Without the ball, wires show where it was.
    let mut wires = scene.clone();
    wires.objects.remove(0);
    let wires = draw(&prepared(&wires, ""), Method::Exact);
    let uncovered = (0..n)
        .filter(|i| lit(&wires, *i) && lit(&alone, *i) && with.pixels[*i] == alone.pixels[*i]);
    assert!(uncovered.count() > 50);
}

#[test]
fn wires_across_the_near_plane_and_the_frame_are_clipped() {
    let mut scene = load("depth-cue");
    scene.camera.eye = DVec3::new(0.4, 0.3, 1.1);
    scene.camera.near = 0.2;
    for e in [0.05, 0.7, 1.4] {
        scene.camera.eye.z = e;
        for skips in ["", "all"] {
            let p =
                Prepared::new(&scene, Some((120, 90)), &Skips::without(skips).unwrap()).unwrap();
            draw(&p, Method::Flat);
            for edge in &p.wires.edges {
                assert!(edge.depth.iter().all(|z| *z >= 0.2 - 1e-9));
            }
        }
    }
}
