//! The methods that interpolate angles: equal to their definitions at every pixel, to each other where they must be, exact at
//! the ends of spans, and finite whatever comes in.

mod single;

use glam::DVec3;
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_reference::raster::{Point, Viewport, Walk};
use shadegate_reference::render::{render, RenderOptions};
use shadegate_reference::shade::case::Case;
use shadegate_reference::shade::dispatch::{dispatch, Visitor};
use shadegate_reference::shade::exact;
use shadegate_reference::shade::shader::{Draw, Run, Shader};
use shadegate_reference::skips::Skips;
use shadegate_reference::{Method, Prepared};
use single::{pixels, Single};
use std::path::Path;

const CIRCULAR: [Method; 15] = [
    Method::Spherical,
    Method::SphericalIndependent,
    Method::SphericalCos2,
    Method::SphericalCos2Minimax,
    Method::SphericalCos2Rom4,
    Method::SphericalCos2Rom6,
    Method::SphericalCos2Rom8,
    Method::SphericalCosN,
    Method::Blake,
    Method::BlakeRefit,
    Method::BlakeTrapezium,
    Method::Slerp,
    Method::SlerpChebyshev,
    Method::SlerpDeMoivre,
    Method::SlerpTrigFree,
];

/// Slerp by the definition, with sines; ends closer than `1e-9` do not turn.
fn slerp(a: DVec3, b: DVec3, t: f64) -> DVec3 {
    let g = a.cross(b).length().atan2(a.dot(b));
    if g < 1e-9 {
        return a;
    }
    (a * ((1.0 - t) * g).sin() + b * (t * g).sin()) / g.sin()
}

/// N at a pixel as the papers define it: slerped along two edges and between them, all places from the real geometry.
fn normal(s: &Single, v: &[DVec3; 3], x: i32, y: i32) -> DVec3 {
    let row = f64::from(y) + 0.5;
    let p = s
        .position
        .map(|p| (f64::from(p.x) / 256.0, f64::from(p.y) / 256.0));
    let mut cuts: Vec<(f64, DVec3)> = [(0, 1), (0, 2), (1, 2)]
        .into_iter()
        .filter_map(|(i, j): (usize, usize)| {
            let t = (row - p[i].1) / (p[j].1 - p[i].1);
            (0.0..=1.0)
                .contains(&t)
                .then(|| (p[i].0 + t * (p[j].0 - p[i].0), slerp(v[i], v[j], t)))
        })
        .collect();
    cuts.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (l, r) = (cuts[0], cuts[cuts.len() - 1]);
    let t = if r.0 > l.0 {
        (f64::from(x) + 0.5 - l.0) / (r.0 - l.0)
    } else {
        0.0
    };
    slerp(l.1, r.1, t)
}

#[test]
fn slerped_methods_are_their_definition_at_every_pixel() {
    let mut rng = StdRng::seed_from_u64(21);
    let mut worst = 0.0f64;
    for _ in 0..60 {
        let s = Single::random(&mut rng, 60, 1.0);
        let p = s.prepare();
        let (l, h) = s.far();
        for m in [
            Method::Spherical,
            Method::SphericalIndependent,
            Method::SlerpDeMoivre,
        ] {
            for (x, y, c) in pixels(&p, m) {
                let n = normal(&s, &s.normal, x, y);
                let want = s.colour(n.dot(l), n.dot(h));
                worst = worst.max((c - want).abs());
            }
        }
    }
    println!("{worst:e} LSB");
    assert!(worst < 1e-6, "{worst}");
}

#[test]
fn blake_on_triangles_is_blake_on_trapezia() {
    let mut rng = StdRng::seed_from_u64(22);
    let mut worst = 0.0f64;
    for k in 0..200 {
        let mut s = Single::random(&mut rng, 60, [0.02, 0.5, 1.4][k % 3]);
        match k % 8 {
            // Level edges, equal normals on one edge or everywhere, all normals in one plane.
            1 => s.position[1].y = s.position[0].y,
            2 => s.normal[1] = s.normal[0],
            3 => s.normal = [s.normal[0]; 3],
            4 => s.normal[2] = slerp(s.normal[0], s.normal[1], 0.3),
            5 => s.near = Some((DVec3::new(0.4, 1.5, 3.0), DVec3::new(1.0, 0.0, 4.0))),
            _ => {}
        }
        let p = s.prepare();
        let pairs = pixels(&p, Method::Blake)
            .into_iter()
            .zip(pixels(&p, Method::BlakeTrapezium));
        for (a, b) in pairs {
            worst = worst.max((a.2 - b.2).abs());
        }
    }
    println!("{worst:e} LSB");
    assert!(worst < 1e-5, "{worst}");
}

#[test]
fn blended_slerp_is_exact_at_both_ends_of_every_span_in_perspective_too() {
    let mut rng = StdRng::seed_from_u64(23);
    for _ in 0..60 {
        let mut s = Single::random(&mut rng, 90, 1.2);
        s.inv_w = [0; 3].map(|_| rng.random_range(0.3..1.0));
        let p = s.prepare();
        let t = &p.triangles[0];
        for m in [Method::Slerp, Method::SlerpChebyshev] {
            let all = pixels(&p, m);
            for (i, (x, y, c)) in all.iter().enumerate() {
                let first = i == 0 || all[i - 1].1 != *y;
                let last = i + 1 == all.len() || all[i + 1].1 != *y;
                if first || last {
                    let want = exact::value(&p, t, *x, *y)[0];
                    assert!((c - want).abs() < 1e-5, "{m} ({x}, {y}): {c} {want}");
                }
            }
        }
    }
}

/// One method's work has no memory of another's scene: the same pixels whether or not the span begins in the frame.
#[test]
fn slerped_edges_do_not_feel_the_border_of_the_frame() {
    let mut rng = StdRng::seed_from_u64(24);
    let s = Single::random(&mut rng, 60, 0.8);
    let mut moved = s.clone();
    for p in &mut moved.position {
        p.x -= 20 * 256;
    }
    for m in [
        Method::Spherical,
        Method::SphericalCosN,
        Method::Blake,
        Method::SlerpDeMoivre,
    ] {
        let whole = pixels(&s.prepare(), m);
        for (x, y, c) in pixels(&moved.prepare(), m) {
            let same = whole
                .iter()
                .find(|w| (w.0, w.1) == (x + 20, y))
                .expect("covered");
            assert!((same.2 - c).abs() < 1e-8, "{m}");
        }
    }
}

#[test]
fn degenerate_input_gives_finite_colours_within_the_range() {
    let base = Single::random(&mut StdRng::seed_from_u64(25), 40, 0.5);
    let mut cases: Vec<(&str, Single)> = Vec::new();
    let mut case = |name, change: &dyn Fn(&mut Single)| {
        let mut s = base.clone();
        change(&mut s);
        cases.push((name, s));
    };
    case("equal normals", &|s| s.normal = [DVec3::Z; 3]);
    case("almost equal normals", &|s| {
        s.normal = [
            DVec3::Z,
            (DVec3::Z + DVec3::X * 1e-9).normalize(),
            (DVec3::Z + DVec3::Y * 1e-12).normalize(),
        ];
    });
    case("opposite normals", &|s| {
        s.normal = [DVec3::X, DVec3::NEG_X, DVec3::X]
    });
    case("normals all around", &|s| {
        s.normal = [DVec3::X, DVec3::Y, DVec3::new(-1.0, -1.0, -0.2).normalize()]
    });
    case("light square to all normals", &|s| {
        s.normal = [DVec3::X, DVec3::Y, DVec3::NEG_X];
        s.light = DVec3::Z;
    });
    case("light from the viewer's back", &|s| s.view = Some(-s.light));
    case("light in a vertex", &|s| {
        s.near = Some((s.world()[1], DVec3::new(0.0, 0.0, 5.0)))
    });
    case("eye in a vertex", &|s| {
        s.near = Some((DVec3::new(0.0, 0.0, 5.0), s.world()[2]))
    });
    case("light in the plane", &|s| {
        s.near = Some((DVec3::new(0.3, 0.3, 0.0), DVec3::new(0.0, 0.0, 2.0)))
    });
    case("a row of one pixel", &|s| {
        s.position = [(256, 100), (512, 140), (256, 300)].map(|(x, y)| Point { x, y });
    });
    case("level edge", &|s| s.position[1].y = s.position[0].y);
    case("needle", &|s| {
        s.position = [(0, 0), (10_000, 257), (9_990, 256)].map(|(x, y)| Point { x, y });
    });
    for (name, s) in &cases {
        for n in [0.0, 0.3, 1.0, 1.5, 2.0, 50.0, 10_000.0] {
            let mut s = s.clone();
            s.shininess = n;
            let p = s.prepare();
            let mut all = CIRCULAR.to_vec();
            all.extend([
                Method::QuadraticDots,
                Method::QuadraticAdaptive,
                Method::QuadraticAdaptiveCentre,
            ]);
            for m in all {
                let colours = pixels(&p, m);
                assert!(!colours.is_empty() || *name == "needle", "{name}");
                for (x, y, c) in colours {
                    // A third more than everything at once, for the overshoot of quadratics.
                    assert!(
                        c.is_finite() && c > -90.0 && c < 1.35 * 255.0,
                        "{m} {name} n={n} ({x}, {y}): {c}"
                    );
                }
            }
        }
    }
}

/// The red of a run's first pixel.
struct Red;

impl Draw for Red {
    type Out = f64;

    fn draw(self, run: impl Run) -> f64 {
        run.colour()[0]
    }
}

/// Spans of one pixel: what the skip gives, and what a start does.
struct OnePixel<'a>(&'a Prepared);

impl Visitor for OnePixel<'_> {
    type Out = Vec<(i32, i32, [f64; 2])>;

    fn visit<S: Shader>(self, shader: &S) -> Self::Out {
        let p = self.0;
        let setup = shader.triangle(p, 0);
        let viewport = Viewport {
            width: p.width,
            height: p.height,
        };
        let mut out = Vec::new();
        for walk in Walk::new(p.triangles[0].position, viewport).iter() {
            for span in walk.spans(p.width).filter(|s| s.end - s.start == 1) {
                let short = shader.one_pixel(p, &setup, span, Red);
                let whole = shader.start(p, &setup, span).colour()[0];
                out.push((span.start, span.y, [short, whole]));
            }
        }
        out
    }
}

#[test]
fn spans_of_one_pixel_are_the_truth_and_within_the_bound_of_what_a_start_gives() {
    let mut rng = StdRng::seed_from_u64(77);
    let (mut tried, mut moved) = (0, 0.0f64);
    for k in 0..600 {
        let s = Single::random(&mut rng, 6 + k % 40, 1.2);
        let p = s.prepare();
        let angle = |i: usize, j: usize| s.normal[i].angle_between(s.normal[j]);
        let case = Case {
            spread: angle(0, 1).max(angle(0, 2)).max(angle(1, 2)),
            turn: 0.0,
            shininess: s.shininess,
            diffuse: 0.4,
            specular: 0.5,
        };
        for m in CIRCULAR {
            let bound = m.bound(&case).unwrap();
            for (x, y, [short, whole]) in dispatch(&p, m, OnePixel(&p)).unwrap() {
                let truth = exact::value(&p, &p.triangles[0], x, y)[0];
                assert!((short - truth).abs() < 1e-9, "{m}: {short} {truth}");
                let e = (short - whole).abs();
                assert!(e <= bound + 1e-9, "{m}: {e} > {bound}");
                let blended = [Method::Slerp, Method::SlerpChebyshev, Method::SlerpTrigFree];
                if blended.contains(&m) {
                    assert!(e < 1e-9, "{m}: {e}");
                }
                moved = moved.max(e);
                tried += 1;
            }
        }
    }
    assert!(tried > 3000, "{tried}");
    // Otherwise there is nothing to bound.
    assert!(moved > 0.1, "{moved}");
}

#[test]
fn spans_of_one_pixel_are_counted_and_change_no_frame_of_blended_ends() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/teapot.toml");
    let scene = shadegate_reference::scene::load(&file).unwrap();
    let p = Prepared::new(&scene, None, &Skips::all()).unwrap();
    let viewport = Viewport {
        width: p.width,
        height: p.height,
    };
    let walks = p.triangles.iter();
    let walks = walks.filter_map(|t| Walk::new(t.position, viewport));
    let ones: usize = walks
        .map(|w| w.spans(p.width).filter(|s| s.end - s.start == 1).count())
        .sum();
    let frame = |m, skips| {
        let o = RenderOptions {
            skips,
            ..RenderOptions::default()
        };
        render(&p, m, &o)
    };
    for m in CIRCULAR {
        let (with, stats) = frame(m, Skips::all());
        assert_eq!(stats.skipped["one-pixel"], ones as u64, "{m}");
        if [Method::Slerp, Method::SlerpChebyshev, Method::SlerpTrigFree].contains(&m) {
            let (without, stats) = frame(m, Skips::all().but("one-pixel"));
            assert!(with == without, "{m}");
            assert_eq!(stats.skipped.get("one-pixel"), None);
        }
    }
    assert!(ones > 1000, "{ones}");
}
