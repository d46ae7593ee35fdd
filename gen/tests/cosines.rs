//! The quadratic-dots core against an oracle of its own in f64: the reflection model from six knots, at pixel centres, by
//! barycentric weights and the six basis functions. Frames of 1024x1024 pixels with triangles as large as they come,
//! random materials and cosines, and cosines chosen to be hard: crests of narrow highlights, edges of the light.

#[path = "common/hunt.rs"]
mod hunt;

use hunt::{hunt, Effort};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_gen::stimulus::{build, Lobe, Material, StimulusOptions, Triangle};
use shadegate_gen::vectors::Trace;
use shadegate_hdl::shade::device::{longest_run, Core};
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::{Point, Viewport};

/// The colour of a pixel, not rounded.
fn oracle(t: &Triangle, x: u16, y: u16) -> [f64; 3] {
    let p = t
        .position
        .map(|p| (f64::from(p.x) / 256.0, f64::from(p.y) / 256.0));
    let c = (f64::from(x) + 0.5, f64::from(y) + 0.5);
    let cross = |a: (f64, f64), b: (f64, f64), o: (f64, f64)| {
        (a.0 - o.0) * (b.1 - o.1) - (a.1 - o.1) * (b.0 - o.0)
    };
    let area = cross(p[1], p[2], p[0]);
    let w = [
        cross(p[1], p[2], c) / area,
        cross(p[2], p[0], c) / area,
        cross(p[0], p[1], c) / area,
    ];
    let basis = [
        w[0] * (2.0 * w[0] - 1.0),
        w[1] * (2.0 * w[1] - 1.0),
        w[2] * (2.0 * w[2] - 1.0),
        4.0 * w[0] * w[1],
        4.0 * w[0] * w[2],
        4.0 * w[1] * w[2],
    ];
    let cosine = |k: usize| -> f64 { (0..6).map(|i| basis[i] * t.knots[i][k]).sum() };
    let light = cosine(0).clamp(0.0, 1.0);
    let m = t.material.expect("has one");
    let power = cosine(1).clamp(0.0, 1.0).powf(m.shininess);
    std::array::from_fn(|i| {
        (m.ambient[i] + m.diffuse[i] * light + m.specular[i] * power).clamp(0.0, 255.0)
    })
}

fn material(r: &mut StdRng) -> Material {
    let mut colour = |most: f64| std::array::from_fn(|_| r.random_range(0.0..=most));
    let [ambient, diffuse] = [colour(80.0), colour(255.0)];
    Material {
        ambient,
        diffuse,
        specular: [255.0, 128.0, 31.0],
        shininess: [1.0, 1.5, 5.0, 20.0, 50.0, 100.0, 128.0, 500.0, 2048.0][r.random_range(0..9)],
        lobe: Lobe::Power,
        cone: None,
    }
}

/// Knots of N·L and N·H. `kind` 0: anything, even beyond ±1; 1: a crest of the highlight within the triangle; 2: as
/// narrow as its power, so that all of the table is seen.
fn knots(r: &mut StdRng, kind: usize, n: f64) -> Vec<[f64; 3]> {
    let (cx, cy) = (r.random_range(-0.2..0.9), r.random_range(-0.2..0.9));
    let wide = match kind {
        1 => r.random_range(0.05..0.5),
        _ => 14.0 / n,
    };
    let at = [
        (0.0, 0.0),
        (1.0, 0.0),
        (0.0, 1.0),
        (0.5, 0.0),
        (0.0, 0.5),
        (0.5, 0.5),
    ];
    at.into_iter()
        .map(|(u, v)| {
            let far: f64 = (u - cx) * (u - cx) + (v - cy) * (v - cy);
            match kind {
                0 => [r.random_range(-1.5..1.5), r.random_range(-1.5..1.5), 0.0],
                _ => [u - v + 0.1, (1.0 - wide * far).max(-1.0), 0.0],
            }
        })
        .collect()
}

/// Draws triangles, one after the other and each nearer than the one before; each one's largest error beyond half an
/// LSB, the bound, and the number of pixels.
fn errors(size: (u32, u32), triangles: &[Triangle]) -> (Vec<f64>, f64, usize) {
    let (width, height) = size;
    let core = Core::for_frame(Order::QuadraticDots, width, height).expect("in range");
    let view = Viewport { width, height };
    let stimulus = build(&core, triangles, view, &StimulusOptions::default()).expect("in range");
    let trace = Trace::record(core, &stimulus, |_| true);
    let worst = hunt::errors(triangles.len(), &trace.pixels, |p| {
        oracle(&triangles[p.triangle], p.x, p.y)
    });
    let bound = core.error_bound(longest_run(width, height).expect("in range"));
    (worst, bound, trace.pixels.len())
}

/// The largest error of all, which must be within the bound.
fn worst(size: (u32, u32), triangles: &[Triangle]) -> (f64, usize) {
    let (each, bound, pixels) = errors(size, triangles);
    let worst = each.into_iter().fold(0.0, f64::max);
    assert!(worst <= bound, "{size:?}: {worst} beyond {bound}");
    assert!(bound < 0.25, "faithful: {bound}");
    (worst, pixels)
}

fn triangle(r: &mut StdRng, size: (u32, u32), i: usize) -> Triangle {
    let mut corner = |low: i32, high: i32| Point {
        x: r.random_range(low..=high) * size.0 as i32 / 4,
        y: r.random_range(low..=high) * size.1 as i32 / 4,
    };
    // Corners in quarters of 1/256 of the frame, up to a quarter beside it.
    let position = match i % 3 {
        0 => [corner(-256, 0), corner(1024, 1280), corner(-256, 1280)],
        _ => [corner(0, 1024), corner(0, 1024), corner(0, 1024)],
    };
    let m = material(r);
    Triangle {
        position,
        depth: [(100 * i + 1) as f64; 3],
        knots: knots(r, i % 4, m.shininess),
        material: Some(m),
        covering: None,
        relief: None,
        label: format!("case {i}"),
    }
}

#[test]
fn every_pixel_is_within_the_bound_on_large_triangles() {
    let mut r = StdRng::seed_from_u64(51);
    let mut all = (0.0f64, 0);
    for (size, count) in [((1024, 1024), 6), ((256, 192), 60)] {
        let triangles: Vec<_> = (0..count).map(|i| triangle(&mut r, size, i)).collect();
        let (error, pixels) = worst(size, &triangles);
        all = (all.0.max(error), all.1 + pixels);
    }
    println!("{} LSB beyond the rounding, {} pixels", all.0, all.1);
    assert!(all.1 > 1_000_000, "{} pixels", all.1);
}

/// A triangle by genes: where its corners are, its cosines, its colours and its exponent.
fn grown(genes: &[f64], size: (u32, u32), i: usize) -> Triangle {
    let corner = |k: usize| hunt::corner(&genes[2 * k..], 0.2, size);
    let cosine = |k: usize| [1.2 - 2.0 * genes[6 + k], 1.2 - 1.5 * genes[12 + k], 0.0];
    let colour = |k: usize| std::array::from_fn(|c| (255.0 * genes[k + c]).round());
    let exponent = 1.0 + 127.0 * genes[18] * genes[18];
    Triangle {
        position: [0, 1, 2].map(corner),
        depth: [(100 * i + 1) as f64; 3],
        knots: (0..6).map(cosine).collect(),
        material: Some(Material {
            ambient: [0.25, 0.5, 0.75],
            diffuse: colour(19),
            specular: colour(22),
            shininess: exponent,
            lobe: Lobe::Power,
            cone: None,
        }),
        covering: None,
        relief: None,
        label: format!("grown {i}"),
    }
}

#[test]
fn an_adversary_finds_no_pixel_beyond_the_bound() {
    for (size, generations, population) in [((1024, 1024), 4, 4), ((256, 192), 40, 12)] {
        let effort = Effort {
            genes: 25,
            generations,
            population,
        };
        let mut bound = 0.0;
        let found = hunt(effort, 53, |crowd| {
            let crowd = crowd.iter().enumerate();
            let triangles: Vec<_> = crowd.map(|(i, g)| grown(g, size, i)).collect();
            let (each, of, _) = errors(size, &triangles);
            bound = of;
            each
        });
        println!(
            "{size:?}: {:.4}, random {:.4}, bound {bound:.4}",
            found.worst, found.random
        );
        assert!(found.worst <= bound, "{found:?}");
    }
}

/// A wrong table, or a cosine off by 2^-12, is found.
#[test]
fn the_oracle_notices_a_small_error() {
    let mut r = StdRng::seed_from_u64(52);
    let size = (256, 192);
    let mut t = triangle(&mut r, size, 1);
    t.material = Some(Material {
        specular: [255.0; 3],
        shininess: 50.0,
        ..material(&mut r)
    });
    t.knots = knots(&mut r, 1, 50.0);
    let core = Core::for_frame(Order::QuadraticDots, size.0, size.1).expect("in range");
    let view = Viewport {
        width: size.0,
        height: size.1,
    };
    let error = |off: f64| {
        let mut sent = t.clone();
        sent.knots.iter_mut().for_each(|k| k[1] += off);
        let one = [sent];
        let stimulus = build(&core, &one, view, &StimulusOptions::default()).expect("in range");
        let trace = Trace::record(core, &stimulus, |_| true);
        let of = trace.pixels.iter().map(|p| {
            let want = oracle(&t, p.x, p.y);
            (0..3)
                .map(|c| (f64::from(p.rgb[c]) - want[c]).abs() - 0.5)
                .fold(0.0, f64::max)
        });
        of.fold(0.0, f64::max)
    };
    let bound = core.error_bound(longest_run(size.0, size.1).expect("in range"));
    assert!(error(0.0) <= bound);
    assert!(
        error(1.0 / 4096.0) > bound,
        "{} {bound}",
        error(1.0 / 4096.0)
    );
}

#[test]
fn what_the_core_cannot_draw_is_refused_by_number() {
    let core = Core::for_frame(Order::QuadraticDots, 64, 64).expect("in range");
    let refused = |change: &dyn Fn(&mut Triangle)| {
        let mut t = triangle(&mut StdRng::seed_from_u64(53), (64, 64), 0);
        t.label = "object 1, face 2".to_owned();
        change(&mut t);
        let view = Viewport {
            width: 64,
            height: 64,
        };
        let error = build(&core, &[t], view, &StimulusOptions::default()).expect_err("bad");
        let text = error.to_string();
        text.strip_prefix("triangle 0 (object 1, face 2): ")
            .expect("which")
            .to_owned()
    };
    let with = |change: &dyn Fn(&mut Material)| {
        refused(&|t| {
            let mut m = Material {
                ambient: [1.0; 3],
                diffuse: [2.0; 3],
                specular: [3.0; 3],
                shininess: 20.0,
                lobe: Lobe::Power,
                cone: None,
            };
            change(&mut m);
            t.material = Some(m);
        })
    };
    assert_eq!(refused(&|t| t.material = None), "no material");
    assert_eq!(
        refused(&|t| t.knots.truncate(3)),
        "3 knots where the core takes 6"
    );
    assert_eq!(
        refused(&|t| t.knots[1][0] = -2.5),
        "N·L -2.5 at a knot is outside -2 to 2"
    );
    assert_eq!(
        refused(&|t| t.knots[4][1] = f64::NAN),
        "N·H NaN at a knot is outside -2 to 2"
    );
    assert_eq!(
        with(&|m| m.shininess = 0.5),
        "shininess 0.5 is outside 1 to 2048"
    );
    assert_eq!(
        with(&|m| m.shininess = 3000.0),
        "shininess 3000 is outside 1 to 2048"
    );
    let sum = "do not add up to 0 to 2047";
    assert_eq!(
        with(&|m| m.diffuse[1] = 2044.0),
        format!("ambient, diffuse and specular colour 1, 2044 and 3 {sum}")
    );
    assert_eq!(
        with(&|m| m.ambient[2] = -1.0),
        format!("ambient, diffuse and specular colour -1, 2 and 3 {sum}")
    );
}

/// A material is written once, and again when it changes; a matt one needs no table.
#[test]
fn a_material_is_written_when_it_changes() {
    let core = Core::for_frame(Order::QuadraticDots, 64, 64).expect("in range");
    let view = Viewport {
        width: 64,
        height: 64,
    };
    let mut r = StdRng::seed_from_u64(54);
    let base = Material {
        ambient: [1.0; 3],
        diffuse: [90.0; 3],
        specular: [0.0; 3],
        shininess: 20.0,
        lobe: Lobe::Power,
        cone: None,
    };
    let gloss = Material {
        specular: [50.0; 3],
        ..base
    };
    let sharper = Material {
        shininess: 21.0,
        ..gloss
    };
    let triangles: Vec<_> = [base, base, gloss, gloss, sharper, base]
        .into_iter()
        .map(|m| Triangle {
            material: Some(m),
            ..triangle(&mut r, (64, 64), 0)
        })
        .collect();
    let stimulus = build(&core, &triangles, view, &StimulusOptions::default()).expect("in range");
    let count = |i: usize| {
        let writes = &stimulus.primitives[i].writes;
        let of = |select: u8| writes.iter().filter(|w| w.0 == select).count();
        let colours = writes
            .iter()
            .filter(|w| (0x40..0x49).contains(&w.0))
            .count();
        (of(12), colours, of(0x4a))
    };
    let seen: Vec<_> = (0..6).map(count).collect();
    assert_eq!(
        seen,
        [
            (1, 9, 0),
            (0, 0, 0),
            (1, 3, 512),
            (0, 0, 0),
            (1, 0, 512),
            (1, 3, 0)
        ]
    );
}
