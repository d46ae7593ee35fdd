//! The span cores against what their methods are by definition, over the longest spans; one pixel per clock; any
//! back pressure; and what they refuse.

mod common;
#[path = "common/hunt.rs"]
mod hunt;

use hunt::{hunt, Effort};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_gen::package::{registers, rtl};
use shadegate_gen::spans::{sample, Surface};
use shadegate_gen::stimulus::{build, sample_triangles, StimulusOptions, Triangle};
use shadegate_gen::vectors::{Pixel, Trace};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::shade::span_core::SpanKind;
use shadegate_reference::raster::{Point, Span, Viewport, Walk};
use shadegate_reference::shade::barycentric::weights;
use shadegate_reference::shade::circular::Ends;
use shadegate_reference::shade::curve::{Curve, Pieces};
use shadegate_reference::shade::ends::slerped::arcs;
use shadegate_reference::shade::ends::Slerped;
use std::collections::{BTreeMap, BTreeSet, HashMap};

const KINDS: [SpanKind; 8] = [
    SpanKind::Slerp,
    SpanKind::Chebyshev,
    SpanKind::Spherical(4),
    SpanKind::Spherical(6),
    SpanKind::SphericalPower(8),
    SpanKind::Blake,
    SpanKind::BlakeRefit,
    SpanKind::BlakeTrapezium,
];

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(a: Vector) -> Vector {
    let length = dot(a, a).sqrt();
    a.map(|v| v / length)
}

fn draw(kind: SpanKind, triangles: &[Triangle], view: Viewport) -> (Core, Trace) {
    let core = Core::for_frame(Order::Span(kind), view.width, view.height).expect("in range");
    let stimulus = build(&core, triangles, view, &StimulusOptions::default())
        .unwrap_or_else(|e| panic!("{kind:?}: {e}"));
    (core, Trace::record(core, &stimulus, |_| true))
}

/// One span by the definition of slerp: the normal at its ends blended and made unit, turned evenly between.
fn slerp(t: &Triangle, span: Span) -> Vec<Vector> {
    let end = |x: i32| {
        let w = weights(&t.position, x, span.y);
        let blend = |c: usize| (0..3).map(|i| w[i] * t.knots[i][c]).sum();
        unit([blend(0), blend(1), blend(2)])
    };
    let (a, b) = (end(span.start), end(span.end - 1));
    let cos = dot(a, b);
    let across = [0, 1, 2].map(|i| b[i] - cos * a[i]);
    let sin = dot(across, across).sqrt();
    let turn = sin.atan2(cos);
    let steps = f64::from((span.end - 1 - span.start).max(1));
    let colour = |x: i32| {
        let angle = turn * f64::from(x - span.start) / steps;
        let n = [0, 1, 2].map(|i| {
            let side = if sin > 0.0 { across[i] / sin } else { 0.0 };
            a[i] * angle.cos() + side * angle.sin()
        });
        let d = dot(n, t.knots[6]).max(0.0);
        let s = dot(n, t.knots[9]).max(0.0).powf(t.knots[16][0]);
        [0, 1, 2].map(|c| t.knots[13][c] + t.knots[14][c] * d + t.knots[15][c] * s)
    };
    (span.start..span.end).map(colour).collect()
}

/// One span by eq. 4 of Blake et al. at every pixel's own angle.
fn blake(t: &Triangle, span: Span, pieces: fn(f64) -> Pieces) -> Vec<Vector> {
    let s = Surface::new(t).expect("a surface");
    let (light, half) = Slerped.sweeps(&s.triangle, &s.corners, &arcs(&s.corners.normal), span)[0];
    let (light, half) = (light.phase(), half.expect("it shines").phase());
    let n = s.corners.shininess;
    let colour = |x: i32| {
        let k = f64::from(x - span.start);
        let d = light.amplitude * pieces(1.0).at(light.phase + k * light.step);
        let s = half.amplitude.powf(n) * pieces(n).at(half.phase + k * half.step);
        [0, 1, 2].map(|c| t.knots[13][c] + t.knots[14][c] * d + t.knots[15][c] * s)
    };
    (span.start..span.end).map(colour).collect()
}

/// Largest difference of a channel between a run and the definition, before the rounding of the definition, by triangle.
fn worst_of_each(
    triangles: &[Triangle],
    view: Viewport,
    pixels: &[Pixel],
    define: impl Fn(&Triangle, Span) -> Vec<Vector>,
) -> Vec<f64> {
    let mut want = HashMap::new();
    for (index, t) in triangles.iter().enumerate() {
        let walk = Walk::new(t.position, view).expect("covers");
        for span in walk.spans(view.width) {
            for (x, colour) in (span.start..span.end).zip(define(t, span)) {
                want.insert((index, x as u16, span.y as u16), colour);
            }
        }
    }
    assert_eq!(pixels.len(), want.len(), "every pixel once");
    let mut worst = vec![0.0f64; triangles.len()];
    for p in pixels {
        let want = want[&(p.triangle, p.x, p.y)];
        for (got, want) in p.rgb.into_iter().zip(want) {
            let error = (f64::from(got) - want.clamp(0.0, 255.0)).abs();
            worst[p.triangle] = worst[p.triangle].max(error);
        }
    }
    worst
}

/// The largest of all.
fn worst(
    triangles: &[Triangle],
    view: Viewport,
    pixels: &[Pixel],
    define: impl Fn(&Triangle, Span) -> Vec<Vector>,
) -> f64 {
    let each = worst_of_each(triangles, view, pixels, define);
    each.into_iter().fold(0.0, f64::max)
}

const VIEW: Viewport = Viewport {
    width: 1024,
    height: 6,
};

/// Triangles over the whole width, the later ones nearer: turns from nothing to 90°, towards and away from the light.
fn wide(count: usize, exponent: f64, seed: u64) -> Vec<Triangle> {
    let mut r = StdRng::seed_from_u64(seed);
    let corner = |x: i32, y: i32| Point {
        x: x * 256,
        y: y * 256,
    };
    let one = |i: usize| {
        let lean = [1e-7, 1e-4, 0.02, 0.2, 0.6, 1.0][i % 6];
        let tilt: [f64; 2] = [r.random_range(-0.8..0.8), r.random_range(-0.8..0.8)];
        let normals = [0; 3].map(|_| {
            let mut side = || r.random_range(-lean..=lean);
            [tilt[0] + side(), tilt[1] + side(), 1.0]
        });
        let colours = [[0.0, 10.0, 0.0], [255.0, 120.0, 60.0], [0.0, 110.0, 195.0]];
        Triangle {
            position: [corner(0, 0), corner(1024, 0), corner(0, 6)],
            depth: [1000.0 + 60_000.0 / count as f64 * i as f64; 3],
            knots: sample(normals, colours, exponent),
            material: None,
            covering: None,
            relief: None,
            label: format!("wide {i}"),
        }
    };
    (0..count).map(one).collect()
}

#[test]
fn slerp_is_faithful_over_the_longest_spans() {
    for (exponent, seed) in [(1.0, 1), (5.0, 2), (20.0, 3), (128.0, 4)] {
        let triangles = wide(36, exponent, seed);
        let (core, trace) = draw(SpanKind::Slerp, &triangles, VIEW);
        let error = worst(&triangles, VIEW, &trace.pixels, slerp);
        let bound = core.error_bound(1024);
        println!("n = {exponent}: {error:.3} LSB with the rounding, bound 0.5 + {bound:.3}");
        assert!(error <= 0.5 + bound, "n = {exponent}: {error}");
    }
}

/// The same multiplier and accumulators: what differs is the recurrence.
#[test]
fn chebyshev_drifts_with_the_square_of_the_span() {
    let triangles = wide(36, 1.0, 1);
    let long = draw(SpanKind::Chebyshev, &triangles, VIEW).1;
    let long = worst(&triangles, VIEW, &long.pixels, slerp);
    let narrow: Vec<Triangle> = triangles
        .iter()
        .map(|t| {
            let mut t = t.clone();
            t.position[1].x = 24 * 256;
            t
        })
        .collect();
    let (core, short) = draw(SpanKind::Chebyshev, &narrow, VIEW);
    let short = worst(&narrow, VIEW, &short.pixels, slerp);
    println!("1024 pixels: {long:.1} LSB, 24 pixels: {short:.2} LSB");
    assert!(long > 3.0 && short < 0.6, "{long} {short}");
    assert!(long <= 0.5 + core.error_bound(1024));
}

#[test]
fn blake_s_pieces_are_faithful_over_the_longest_spans() {
    for (kind, pieces) in [
        (SpanKind::Blake, Pieces::printed as fn(f64) -> Pieces),
        (SpanKind::BlakeRefit, Pieces::refit),
    ] {
        for exponent in [5.0, 20.0, 80.0] {
            let triangles = wide(24, exponent, 5);
            let (core, trace) = draw(kind, &triangles, VIEW);
            let error = worst(&triangles, VIEW, &trace.pixels, |t, s| blake(t, s, pieces));
            let bound = core.error_bound(1024);
            println!("{kind:?}, n = {exponent}: {error:.3} LSB, bound 0.5 + {bound:.3}");
            assert!(error <= 0.5 + bound, "{kind:?} {exponent}: {error}");
        }
    }
}

/// A triangle over the whole width by genes: normals from almost parallel to 90° apart.
fn grown(genes: &[f64], exponent: f64, i: usize) -> Triangle {
    let mut t = wide(1, exponent, 8).remove(0);
    let lean = 1e-7f64.powf(genes[8]);
    let side = |g: f64, most: f64| (2.0 * g - 1.0) * most;
    let normals = [0, 1, 2].map(|k| {
        let part = |c: usize| side(genes[c], 0.8) + side(genes[2 + 2 * k + c], lean);
        [part(0), part(1), 1.0]
    });
    let colours = [13, 14, 15].map(|k| t.knots[k]);
    t.knots = sample(normals, colours, exponent);
    t.depth = [1000.0 + 1000.0 * i as f64; 3];
    t
}

#[test]
fn an_adversary_finds_no_pixel_beyond_the_bounds() {
    let effort = Effort {
        genes: 9,
        generations: 12,
        population: 12,
    };
    type Define = fn(&Triangle, Span) -> Vec<Vector>;
    let kinds: [(SpanKind, f64, Define); 4] = [
        (SpanKind::Slerp, 1.0, slerp),
        (SpanKind::Slerp, 20.0, slerp),
        (SpanKind::Blake, 5.0, |t, s| blake(t, s, Pieces::printed)),
        (SpanKind::BlakeRefit, 20.0, |t, s| {
            blake(t, s, Pieces::refit)
        }),
    ];
    for (kind, exponent, define) in kinds {
        let mut bound = 0.0;
        let found = hunt(effort, 9, |crowd| {
            let crowd = crowd.iter().enumerate();
            let triangles: Vec<_> = crowd.map(|(i, g)| grown(g, exponent, i)).collect();
            let (core, trace) = draw(kind, &triangles, VIEW);
            bound = 0.5 + core.error_bound(1024);
            worst_of_each(&triangles, VIEW, &trace.pixels, define)
        });
        println!(
            "{kind:?}, n = {exponent}: {:.4}, random {:.4}, bound {bound:.4}",
            found.worst, found.random
        );
        assert!(found.worst <= bound, "{kind:?}: {found:?}");
    }
}

/// Triangles whose middle corner lies between the other two in height, on either side, so that each is two trapezia. The
/// definition turns the normals along the edges themselves. A turn of 1e-7 has lost its digits in the cosine that the
/// trapezia have of it, and is left out.
#[test]
fn blake_s_trapezia_are_faithful_on_both_sides_of_the_middle_corner() {
    let corner = |x: i32, y: i32| Point {
        x: x * 256,
        y: y * 256,
    };
    for exponent in [5.0, 80.0] {
        let mut triangles = wide(30, exponent, 11);
        let mut index = 0..;
        triangles.retain(|_| index.next().is_some_and(|i| i % 6 != 0));
        for (i, t) in triangles.iter_mut().enumerate() {
            let (far, middle) = ([1024, 0][i % 2], 1 + i as i32 % 5);
            let three = [
                corner(1024 - far, 0),
                corner(far, middle),
                corner(1024 - far, 6),
            ];
            t.position = [0, 1, 2].map(|k| three[(i + k) % 3]);
        }
        let (core, trace) = draw(SpanKind::BlakeTrapezium, &triangles, VIEW);
        let printed = |t: &Triangle, s: Span| blake(t, s, Pieces::printed);
        let error = worst(&triangles, VIEW, &trace.pixels, printed);
        let bound = core.error_bound(1024);
        println!("trapezia, n = {exponent}: {error:.3} LSB, bound 0.5 + {bound:.3}");
        assert!(error <= 0.5 + bound, "{exponent}: {error}");
    }
}

/// Against the curve that the table stands for, every core is within what it states.
#[test]
fn tables_keep_their_quantisation_over_the_longest_spans() {
    for bits in [4, 6, 8, 10] {
        let kind = SpanKind::Spherical(bits);
        let triangles = wide(24, 20.0, 6);
        let (core, trace) = draw(kind, &triangles, VIEW);
        let define = |t: &Triangle, span: Span| {
            let s = Surface::new(t).expect("a surface");
            let curves = (
                shadegate_gen::spans::Curves::diffuse(bits),
                shadegate_gen::spans::Curves::highlight(kind, s.corners.shininess),
            );
            let edges = arcs(&s.corners.normal);
            let (l, h) = Slerped.sweeps(&s.triangle, &s.corners, &edges, span)[0];
            let (l, h) = (l.phase(), h.expect("it shines").phase());
            let colour = |x: i32| {
                let k = f64::from(x - span.start);
                let d = l.amplitude * curves.0.at(l.phase + k * l.step);
                let s = h.amplitude.powf(20.0) * curves.1.at(h.phase + k * h.step);
                [0, 1, 2].map(|c| t.knots[13][c] + t.knots[14][c] * d + t.knots[15][c] * s)
            };
            (span.start..span.end).map(colour).collect()
        };
        let error = worst(&triangles, VIEW, &trace.pixels, define);
        let bound = core.error_bound(1024);
        println!("{bits} bits: {error:.2} LSB, bound 0.5 + {bound:.2}");
        assert!(error <= 0.5 + bound, "{bits}: {error}");
        assert!(
            error > 0.2 * bound,
            "a bound that means something: {error} {bound}"
        );
    }
}

#[test]
fn long_spans_follow_each_other_without_a_bubble() {
    for kind in KINDS {
        let triangles = wide(4, 20.0, 7);
        let (_, trace) = draw(kind, &triangles, VIEW);
        let clocks: Vec<usize> = trace.pixels.iter().map(|p| p.clock).collect();
        let bubbles = clocks.windows(2).filter(|w| w[1] != w[0] + 1).count();
        // Blake's parts may be shorter than their words take.
        let allowed = if kind.name() == "blake" { 40 } else { 0 };
        assert!(bubbles <= allowed, "{kind:?}: {bubbles}");
    }
}

#[test]
fn back_pressure_changes_no_pixel() {
    let view = Viewport {
        width: 48,
        height: 32,
    };
    for kind in KINDS {
        let core = Core::for_frame(Order::Span(kind), 48, 32).expect("in range");
        let triangles = sample_triangles(core.order, view, 30, 9);
        let stimulus =
            build(&core, &triangles, view, &StimulusOptions::default()).expect("in range");
        let strip = |t: Trace| {
            let pixel = |p: &Pixel| (p.x, p.y, p.rgb, p.depth, p.triangle);
            t.pixels.iter().map(pixel).collect::<Vec<_>>()
        };
        let want = strip(Trace::record(core, &stimulus, |_| true));
        assert!(want.len() > 500, "{kind:?}: {} pixels", want.len());
        for (seed, one_in) in [(1, 2), (2, 7)] {
            let mut r = StdRng::seed_from_u64(seed);
            let stalled = Trace::record(core, &stimulus, |_| r.random_ratio(1, one_in));
            assert!(strip(stalled) == want, "{kind:?}, one in {one_in}");
        }
    }
}

#[test]
fn the_register_map_is_what_a_host_writes() {
    for kind in KINDS {
        let core = Core::for_frame(Order::Span(kind), 320, 240).expect("in range");
        let view = Viewport {
            width: 320,
            height: 240,
        };
        let options = StimulusOptions {
            skip_unchanged: false,
            broadcast: false,
            ..StimulusOptions::default()
        };
        let triangles = sample_triangles(core.order, view, 60, 3);
        let stimulus = build(&core, &triangles, view, &options).expect("in range");
        let mut written: BTreeMap<(u8, &str), u64> = BTreeMap::new();
        for (select, data) in &stimulus.frame {
            *written.entry((*select, "frame")).or_default() |= data;
        }
        for (select, data) in stimulus.primitives.iter().flat_map(|p| &p.writes) {
            *written.entry((*select, "triangle")).or_default() |= data;
        }
        let map = registers(&core);
        let known: BTreeSet<(u8, &str)> = map.iter().map(|r| (r.select, r.per)).collect();
        assert_eq!(known.len(), map.len(), "a register twice");
        assert_eq!(known, written.keys().copied().collect(), "{kind:?}");
        for r in &map {
            let bits = written[&(r.select, r.per)];
            assert!(
                bits >> r.bits == 0,
                "{kind:?} {} {}: {bits:x}",
                r.target,
                r.name
            );
        }
    }
}

#[test]
fn what_does_not_fit_is_refused_with_its_reason() {
    let view = Viewport {
        width: 64,
        height: 6,
    };
    let refused = |kind: SpanKind, change: &dyn Fn(&mut Vec<Triangle>)| {
        let core = Core::for_frame(Order::Span(kind), 64, 6).expect("in range");
        let mut triangles = wide(6, 20.0, 8);
        change(&mut triangles);
        build(&core, &triangles, view, &StimulusOptions::default())
            .expect_err("refused")
            .to_string()
    };
    let says = |what: &str, change: &dyn Fn(&mut Vec<Triangle>)| {
        let said = refused(SpanKind::Slerp, change);
        assert!(said.contains(what), "{said}");
    };
    says("one more than the 4", &|t| {
        (0..6).for_each(|i| t[i].knots[16][2] = i as f64);
    });
    says("colour 700 is outside 0 to 681.5", &|t| {
        t[2].knots[14][1] = 700.0
    });
    says("shininess 0.5 is outside the 1 to 1024", &|t| {
        t[2].knots[16][0] = 0.5
    });
    says("3 knots where a span core takes 17 rows", &|t| {
        t[2].knots.truncate(3)
    });
    says("not a finite number", &|t| t[1].knots[0][0] = f64::NAN);
    says("depth 70000 is outside 0 to 65535", &|t| {
        t[1].depth[0] = 70_000.0
    });
    let steep = refused(SpanKind::SphericalPower(8), &|t| t[0].knots[16][0] = 2000.0);
    assert!(
        steep.contains("shininess 2000 is outside the 0 to 1024"),
        "{steep}"
    );
}

/// The example of a package, under Icarus: a bench that draws once and counts what is written.
#[test]
fn the_example_draws_its_triangle() {
    common::need("iverilog");
    let bench = "module bench; reg clock = 0; reg go = 1; wire idle, done, write; wire [20:0] address; wire [23:0] colour; \
                 wire [15:0] depth; TOP_example example (.clock(clock), .go(go), .idle(idle), .done(done), \
                 .frame_write(write), .frame_address(address), .frame_colour(colour), .frame_depth(depth)); \
                 always #5 clock = !clock; always @(posedge clock) begin if (write) $display(\"%0d\", address); \
                 if (done) $finish; #1 go = 0; end endmodule\n";
    for kind in KINDS {
        let made = common::make(Order::Span(kind), 20, 16, None, &[]);
        let directory = made.unpacked();
        let bench = bench.replace("TOP", &made.package.manifest.top);
        std::fs::write(directory.path().join("bench.v"), bench).expect("writable");
        let parts = [
            &["-g2001", "-o", "bench", "bench.v"],
            &made.paths("rtl/", ".v")[..],
            &made.paths("example/", ".v"),
        ];
        common::silent(directory.path(), "iverilog", &parts.concat());
        let (done, said) = common::run(directory.path(), "vvp", &["-N", "bench"]);
        let drawn: Vec<u32> = said.lines().filter_map(|l| l.parse().ok()).collect();
        // Centres inside the triangle over 12 columns and 6 rows.
        let row = |y: u32| (0..12).filter(move |x| (2 * x + 1) * 6 + (2 * y + 1) * 12 < 144);
        let want: Vec<u32> = (0..6)
            .flat_map(|y| row(y).map(move |x| y * 20 + x))
            .collect();
        assert!(done && drawn == want, "{kind:?}: {said}");
    }
}

#[test]
fn every_core_is_emitted_and_checked() {
    for bits in [4, 5, 7, 9, 10] {
        let core =
            Core::for_frame(Order::Span(SpanKind::Spherical(bits)), 64, 48).expect("in range");
        let files = rtl(&core).unwrap_or_else(|e| panic!("{bits}: {e}")).files;
        assert!(files.iter().any(|f| f.file_name() == "spherical_core.v"));
    }
}
