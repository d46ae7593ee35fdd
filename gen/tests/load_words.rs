//! Several register words per clock: the same pixels in fewer clocks, the clocks told apart by what they are spent on,
//! and the Verilog of the port. After a deliberate change of that:
//! `SHADEGATE_BLESS=1 cargo test --release -p shadegate-gen --test load_words`.

mod common;

use common::{need, run};
use shadegate_gen::compile::CompiledCore;
use shadegate_gen::package::{package, package_with, rtl, Options, PackageError};
use shadegate_gen::scene::{order_of, triangles_of};
use shadegate_gen::stimulus::{build, sample, StimulusOptions};
use shadegate_gen::vectors::Trace;
use shadegate_gen::wrapper::Wrapper;
use shadegate_hdl::line::Filter;
use shadegate_hdl::shade::device::{Core, CoreSimulator};
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::shade::span_core::SpanKind;
use shadegate_reference::raster::Viewport;
use shadegate_reference::{scene, Method, Prepared, Skips};
use std::path::Path;

/// The run of a scene, and the triangles that cover something.
fn record(
    name: &str,
    method: Method,
    options: &StimulusOptions,
    ready: impl FnMut(u64) -> bool,
) -> (Trace, usize, u64) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let scene = scene::load(&folder.join(name)).expect("a scene");
    let (width, height) = (scene.image.width, scene.image.height);
    let prepared = Prepared::new(&scene, None, &Skips::all()).expect("prepared");
    let triangles = triangles_of(&prepared, method);
    let order = order_of(method).expect("a core");
    let core = Core::for_frame(order, width, height).expect("in range");
    let words = options.load_words.unwrap_or(core.load_words);
    let core = core.with_load_words(words).expect("a port");
    let viewport = Viewport { width, height };
    let stimulus = build(&core, &triangles, viewport, options).expect("set up");
    let drawn = triangles.len() - stimulus.skipped_uncovered as usize;
    let trace = Trace::record(core, &stimulus, ready);
    assert_eq!(trace.spent.total(), trace.cycles, "{name} {method}");
    (trace, drawn, stimulus.skipped_unchanged)
}

fn words(load_words: usize) -> StimulusOptions {
    StimulusOptions {
        load_words: Some(load_words),
        ..StimulusOptions::default()
    }
}

fn pixels(t: &Trace) -> Vec<(u16, u16, [u8; 3], u16)> {
    t.pixels
        .iter()
        .map(|p| (p.x, p.y, p.rgb, p.depth))
        .collect()
}

fn rate(t: &Trace) -> f64 {
    t.pixels.len() as f64 / t.cycles as f64
}

#[test]
fn the_teapot_is_not_bound_by_its_words() {
    let [one, two, four] =
        [1, 2, 4].map(|w| record("teapot.toml", Method::Quadratic, &words(w), |_| true).0);
    assert!(rate(&one) < 0.25 && rate(&two) > 0.35 && rate(&four) > 0.55);
    assert_eq!(pixels(&one), pixels(&two));
    assert_eq!(pixels(&one), pixels(&four));
    // What is drawn stays, what is loaded shrinks, and the rest is rows without pixels.
    for t in [&two, &four] {
        assert_eq!(t.spent.drawing, one.spent.drawing);
        assert_eq!(t.writes, one.writes);
    }
    assert!(one.spent.loading > 5 * four.spent.loading);
    assert!(four.spent.waiting() < four.cycles / 20);
    let (gouraud, ..) = record("teapot.toml", Method::Gouraud, &words(2), |_| true);
    assert!(rate(&gouraud) > 0.5, "{}", rate(&gouraud));
}

#[test]
fn spans_of_triangles_of_a_hundred_pixels() {
    for (name, method) in [
        ("sphere-168.toml", Method::Slerp),
        ("sphere-168.toml", Method::SphericalCos2Rom6),
        ("sphere-168.toml", Method::Blake),
        ("sphere-690.toml", Method::Slerp),
        ("sphere-690.toml", Method::SlerpChebyshev),
        ("sphere-690.toml", Method::SphericalCos2Rom4),
        ("sphere-690.toml", Method::SphericalCos2Rom6),
        ("sphere-690.toml", Method::SphericalCos2Rom8),
        ("sphere-690.toml", Method::SphericalCosN),
        ("sphere-690.toml", Method::Blake),
        ("sphere-690.toml", Method::BlakeRefit),
        ("sphere-690.toml", Method::BlakeTrapezium),
    ] {
        let (t, drawn, _) = record(name, method, &StimulusOptions::default(), |_| true);
        let each = t.pixels.len() / drawn;
        println!("{name} {method}: {each} pixels, {:.3}", rate(&t));
        assert_eq!(t.core.load_words, 2);
        assert!(each >= 100, "{name}: {each} pixels a triangle");
        assert!(rate(&t) >= 0.9, "{name} {method}: {}", rate(&t));
    }
}

#[test]
fn words_that_did_not_change_need_not_be_written() {
    for method in [Method::Quadratic, Method::Slerp] {
        for lanes in [1, 4] {
            let all = StimulusOptions {
                skip_unchanged: false,
                ..words(lanes)
            };
            let (few, _, skipped) = record("sphere-168.toml", method, &words(lanes), |_| true);
            let (every, _, none) = record("sphere-168.toml", method, &all, |_| true);
            assert_eq!(pixels(&few), pixels(&every), "{method} {lanes}");
            assert!(skipped > 100 && none == 0, "{method}: {skipped}, {none}");
            assert!(few.cycles <= every.cycles && few.writes < every.writes);
        }
    }
}

#[test]
fn back_pressure_is_counted_and_changes_no_pixel() {
    for method in [Method::Quadratic, Method::Slerp] {
        let (free, ..) = record("sphere-168.toml", method, &words(4), |_| true);
        // Three clocks of four.
        let (held, ..) = record("sphere-168.toml", method, &words(4), |clock| clock % 4 != 0);
        assert_eq!(pixels(&free), pixels(&held));
        assert_eq!(free.spent.back_pressure, 0);
        let more = held.cycles - free.cycles;
        assert!(held.spent.back_pressure.abs_diff(more) < more / 10);
        assert_eq!(free.spent.drawing, held.spent.drawing);
    }
}

#[test]
fn what_no_core_takes_is_refused() {
    let core = |order| Core::for_frame(order, 64, 48).expect("in range");
    let refused = |order, words| core(order).with_load_words(words).unwrap_err().to_string();
    assert_eq!(
        refused(Order::Quadratic, 3),
        "a load port of 3 register words per clock does not exist; expected 1, 2 or 4"
    );
    assert_eq!(
        refused(Order::Line(Filter::Cone), 2),
        "core 'cone' takes one register word per clock; expected 1 load word"
    );
    let two = core(Order::Linear).with_load_words(2).expect("a port");
    let viewport = Viewport {
        width: 64,
        height: 48,
    };
    let trace = Trace::record(two, &sample(&two, viewport, 4, 1).expect("set up"), |_| {
        true
    });
    let options = Options {
        wrappers: &[Wrapper::Axi],
        ..Options::default()
    };
    let rtl = rtl(&two).expect("emits");
    let made = package_with(&rtl, &trace, (64, 48), &options);
    assert!(matches!(made, Err(PackageError::LoadWords(2))));
    let plain = package_with(&rtl, &trace, (64, 48), &Options::default()).expect("packs");
    assert_eq!(plain.manifest.load_words, 2);
    let ports = plain.manifest.ports.iter().filter(|p| p.name == "data_1");
    assert_eq!(ports.map(|p| p.width).collect::<Vec<_>>(), [32]);
}

/// Only the top and the choice of words differ from the Verilog of the usual port.
#[test]
fn the_verilog_of_the_port() {
    for (order, words) in [(Order::Quadratic, 4), (Order::Span(SpanKind::Slerp), 1)] {
        let usual = Core::for_frame(order, 320, 240).expect("in range");
        let name = format!("{}-load-{words}", usual.name());
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("tests/expected")
            .join(name);
        let files = |core: &Core| {
            let rtl = rtl(core).expect("emits");
            let text = |t: &str| t.replace(&rtl.configuration, "-");
            let files = rtl.files.iter().map(|f| (f.file_name(), text(&f.text)));
            files.collect::<Vec<_>>()
        };
        let known = files(&usual);
        let other = files(&usual.with_load_words(words).expect("a port"));
        let own: Vec<_> = other.iter().filter(|f| !known.contains(f)).collect();
        let names: Vec<&str> = own.iter().map(|f| f.0.as_str()).collect();
        let top = format!("{}_core.v", usual.module());
        match (words, names.as_slice()) {
            (1, [only]) => assert_eq!(*only, top),
            (4, [lanes, last]) => assert!(lanes.starts_with("load_lanes") && *last == top),
            _ => panic!("{words} words: {names:?}"),
        }
        for (file, text) in own {
            let path = folder.join(file);
            if std::env::var_os("SHADEGATE_BLESS").is_some() {
                std::fs::create_dir_all(&folder).expect("writable");
                std::fs::write(&path, text).expect("writable");
            }
            let want = std::fs::read_to_string(&path).unwrap_or_default();
            assert!(want == *text, "{}: differs", path.display());
        }
    }
}

/// The cores that have the port, each with a number of words.
const WIDE: [(Order, usize); 8] = [
    (Order::Linear, 2),
    (Order::Quadratic, 4),
    (Order::QuadraticDots, 4),
    (Order::Duff, 2),
    (Order::Span(SpanKind::Slerp), 2),
    (Order::Span(SpanKind::Chebyshev), 4),
    (Order::Span(SpanKind::Spherical(6)), 4),
    (Order::Span(SpanKind::Blake), 2),
];

const SIZE: Viewport = Viewport {
    width: 64,
    height: 48,
};

/// Twenty triangles, with a consumer that is not ready in every fifth clock.
fn sampled(order: Order, words: usize) -> Trace {
    let core = Core::for_frame(order, SIZE.width, SIZE.height).expect("in range");
    let core = core.with_load_words(words).expect("a port");
    let stimulus = sample(&core, SIZE, 20, 3).expect("set up");
    Trace::record(core, &stimulus, |clock| clock % 5 != 0)
}

#[test]
fn description_and_compiled_netlist_follow_the_model() {
    for (order, words) in WIDE {
        let t = sampled(order, words);
        let one = sampled(order, 1);
        assert_eq!(pixels(&t), pixels(&one), "{order:?}");
        assert!(t.cycles < one.cycles && t.pixels.len() > 300, "{order:?}");
        let mut description = CoreSimulator::new(t.core).expect("connects");
        let mut compiled = CompiledCore::new(t.core).expect("compiles");
        for (clock, c) in t.clocks.iter().enumerate() {
            description.clock(&c.inputs);
            compiled.clock(&c.inputs);
            assert_eq!(description.outputs(), c.outputs, "{order:?} clock {clock}");
            assert_eq!(compiled.outputs(), c.outputs, "{order:?} clock {clock}");
        }
    }
}

#[test]
fn packages_pass_in_other_simulators() {
    for tool in ["iverilog", "verilator", "make", "g++"] {
        need(tool);
    }
    for (order, words) in WIDE {
        let t = sampled(order, words);
        let rtl = rtl(&t.core).expect("emits");
        let made = package(&rtl, &t, (SIZE.width, SIZE.height), None).expect("packs");
        let folder = tempfile::tempdir().expect("a folder");
        for f in &made.files {
            let path = folder.path().join(&f.path);
            std::fs::create_dir_all(path.parent().expect("a folder")).expect("writable");
            std::fs::write(path, &f.text).expect("writable");
        }
        // Verilator's C++ takes seconds to build.
        let goals: &[&str] = match order {
            Order::Quadratic => &["icarus", "lint", "verilator"],
            _ => &["icarus", "lint"],
        };
        for goal in goals {
            let (done, said) = run(folder.path(), "make", &[goal]);
            assert!(done, "{order:?} make {goal}: {said}");
            let pass = format!("PASS clocks={} ", t.clocks.len());
            assert!(*goal == "lint" || said.contains(&pass), "{order:?}: {said}");
            assert!(*goal != "lint" || !said.contains('%'), "{order:?}: {said}");
        }
    }
}
