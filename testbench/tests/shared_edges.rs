//! Shared edges: neighbours own every pixel between them exactly once. A million random pairs and fans in the integer
//! model of the raster shell, a sample of them through whole cores in every engine. (The software walk has its own
//! million in `reference`.)

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_gen::package::{package, rtl};
use shadegate_gen::setup::shell_words;
use shadegate_gen::stimulus::{build, StimulusOptions, Triangle};
use shadegate_gen::vectors::Trace;
use shadegate_hdl::raster::shell::{ShellInputs, ShellModel, FRAME_WIDTH};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::{covers, Point, Viewport, Walk};
use shadegate_testbench::engine::{run, Engine};
use std::collections::HashMap;

const VIEW: Viewport = Viewport {
    width: 48,
    height: 40,
};

fn point(r: &mut StdRng, reach: i32) -> Point {
    let mut c = |size: u32| {
        let v = size as i32 * 128 + r.random_range(-reach..=reach);
        // Often on a pixel centre or a pixel corner, where ties are.
        if r.random_ratio(1, 3) {
            v / 128 * 128
        } else {
            v
        }
    };
    Point {
        x: c(VIEW.width),
        y: c(VIEW.height),
    }
}

/// Triangles around one centre that share edges pairwise and together cover a polygon (star-shaped round the centre),
/// or a pair over a common edge. Random vertex order in each.
fn patch(r: &mut StdRng) -> Vec<[Point; 3]> {
    // Sub-pixel, small, frame-sized, and ten times the frame: mirrored points reach three times as far, which is what
    // the core's 2048 rows allow.
    let reach = [40, 1_000, 6_000, 120_000][[0, 1, 1, 1, 2, 2, 2, 3][r.random_range(0..8)]];
    let mut triangles = if r.random() {
        let (a, b) = (point(r, reach), point(r, reach));
        let side = |p: Point| {
            let v = |q: Point| (i64::from(q.x), i64::from(q.y));
            let ((ax, ay), (bx, by), (px, py)) = (v(a), v(b), v(p));
            (bx - ax) * (py - ay) - (by - ay) * (px - ax)
        };
        let (mut c, mut d) = (point(r, reach), point(r, reach));
        if r.random_ratio(1, 3) {
            // A sliver along the common edge.
            let t = r.random_range(1..8);
            c = Point {
                x: a.x + (b.x - a.x) / 8 * t + r.random_range(-3..=3),
                y: a.y + (b.y - a.y) / 8 * t + r.random_range(-3..=3),
            };
        }
        if side(c).signum() * side(d).signum() > 0 {
            d = Point {
                x: a.x + b.x - d.x,
                y: a.y + b.y - d.y,
            };
        }
        if side(c).signum() * side(d).signum() >= 0 {
            vec![]
        } else {
            vec![[a, b, c], [b, a, d]]
        }
    } else {
        let centre = point(r, reach / 4);
        let n = r.random_range(3..7usize);
        let radius = f64::from(reach.max(64));
        let turn: f64 = r.random_range(0.0..1.0);
        let ring: Vec<Point> = (0..n)
            .map(|i| {
                let angle = std::f64::consts::TAU * (i as f64 + turn) / n as f64;
                let far = radius * r.random_range(0.1..1.0);
                Point {
                    x: centre.x + (far * angle.cos()) as i32,
                    y: centre.y + (far * angle.sin()) as i32,
                }
            })
            .collect();
        (0..n)
            .map(|i| [centre, ring[i], ring[(i + 1) % n]])
            .collect()
    };
    for t in &mut triangles {
        let k = r.random_range(0..3);
        t.rotate_left(k);
        if r.random() {
            t.swap(0, 1);
        }
    }
    triangles
}

/// Fragments of one triangle from the integer model of the shell.
fn fragments(model: &mut ShellModel, words: &[u64; 11], mut f: impl FnMut(u64, u64)) {
    let go = ShellInputs {
        go: true,
        ..ShellInputs::default()
    };
    for (word, data) in words.iter().enumerate() {
        model.clock(&ShellInputs {
            write: Some((word, *data)),
            start: word == 10,
            ..go
        });
    }
    loop {
        let o = model.outputs(&go);
        if !o.busy {
            return;
        }
        if o.fragment {
            f(o.x, o.y);
        }
        model.clock(&go);
    }
}

#[test]
fn a_million_triangles_in_pairs_and_fans_through_the_integer_model() {
    let mut r = StdRng::seed_from_u64(77);
    let mut model = ShellModel::new(17);
    model.clock(&ShellInputs {
        write: Some((FRAME_WIDTH, u64::from(VIEW.width))),
        ..ShellInputs::default()
    });
    let want_triangles = if cfg!(debug_assertions) {
        20_000
    } else {
        2_000_000
    };
    let (mut triangles, mut pixels, mut shared) = (0u64, 0u64, 0u64);
    let mut counts = vec![0u8; (VIEW.width * VIEW.height) as usize];
    let mut touched: Vec<usize> = vec![];
    while triangles < want_triangles {
        let patch = patch(&mut r);
        for t in &patch {
            triangles += 1;
            let Some(walk) = Walk::new(*t, VIEW) else {
                continue;
            };
            let words = shell_words(*t, &walk, VIEW.width).unwrap_or_else(|e| panic!("{t:?}: {e}"));
            fragments(&mut model, &words, |x, y| {
                let at = (y * u64::from(VIEW.width) + x) as usize;
                counts[at] += 1;
                touched.push(at);
            });
        }
        pixels += touched.len() as u64;
        for at in &touched {
            let (x, y) = (*at as u32 % VIEW.width, *at as u32 / VIEW.width);
            assert_eq!(counts[*at], 1, "pixel {x} {y} of {patch:?}");
        }
        // None lost either: on a sample, against the rule itself.
        if triangles % 64 == 0 {
            for y in 0..VIEW.height as i32 {
                for x in 0..VIEW.width as i32 {
                    let owners = patch.iter().filter(|t| covers(**t, x, y)).count();
                    assert!(
                        owners <= 1,
                        "the rule gives pixel {x} {y} of {patch:?} to {owners} triangles"
                    );
                    let drawn = counts[(y as u32 * VIEW.width + x as u32) as usize];
                    assert_eq!(usize::from(drawn), owners, "pixel {x} {y} of {patch:?}");
                }
            }
            shared += 1;
        }
        for at in touched.drain(..) {
            counts[at] = 0;
        }
    }
    assert!(
        pixels > triangles && shared > triangles / 1_000,
        "{pixels} pixels, {shared} checked patches"
    );
}

#[test]
fn a_sample_through_cores_in_every_engine() {
    let mut r = StdRng::seed_from_u64(78);
    let core = Core::for_frame(Order::Linear, VIEW.width, VIEW.height).expect("in range");
    let mut list = vec![];
    let mut patch_of = vec![];
    let mut patches = 0usize;
    while list.len() < 1_500 {
        for position in patch(&mut r) {
            // Each triangle nearer than the ones before, so that the depth test hides nothing.
            let depth = [list.len() as f64 + 1.0; 3];
            list.push(Triangle {
                position,
                depth,
                knots: vec![[100.0; 3]; 3],
                material: None,
                covering: None,
                relief: None,
                label: format!("patch {patches}"),
            });
            patch_of.push(patches);
        }
        patches += 1;
    }
    let stimulus =
        build(&core, &list, VIEW, &StimulusOptions::default()).unwrap_or_else(|e| panic!("{e}"));
    let trace = Trace::record(core, &stimulus, |_| true);
    let mut seen = HashMap::new();
    for p in &trace.pixels {
        let patch = patch_of[p.triangle];
        let n = seen.entry((patch, p.x, p.y)).or_insert(0);
        *n += 1;
        assert_eq!(*n, 1, "pixel {} {} of patch {patch}", p.x, p.y);
        assert!(covers(
            list[p.triangle].position,
            i32::from(p.x),
            i32::from(p.y)
        ));
    }
    for (i, t) in list.iter().enumerate() {
        for y in 0..VIEW.height as i32 {
            for x in 0..VIEW.width as i32 {
                let drawn = seen.contains_key(&(patch_of[i], x as u16, y as u16));
                assert!(
                    drawn || !covers(t.position, x, y),
                    "pixel {x} {y} of triangle {i} is lost"
                );
            }
        }
    }
    let files = package(
        &rtl(&core).expect("emits"),
        &trace,
        (VIEW.width, VIEW.height),
        None,
    )
    .expect("packs")
    .files;
    for engine in Engine::ALL {
        let scratch = tempfile::tempdir().expect("temporary directory");
        let r = run(engine, &trace, &files, scratch.path(), None).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(r.mismatches, 0, "{engine}: {:?}", r.first);
        let want: Vec<_> = trace.pixels.iter().map(|p| (p.x, p.y, p.rgb)).collect();
        assert_eq!(r.pixels, want, "{engine}");
    }
}
