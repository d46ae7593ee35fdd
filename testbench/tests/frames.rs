//! The issue of it all: real scenes through the cores. Every engine gives the integer model's frame, one pixel per clock
//! where the triangles are large enough, and at most one LSB of arithmetic error on every pixel.

mod support;

use shadegate_reference::{Method, Scene};
use shadegate_testbench::cosim::{cosim, CosimOptions, CosimReport};
use shadegate_testbench::engine::Engine;
use std::path::PathBuf;
use support::{load, options};

fn run(scene: &Scene, method: Method, engine: Engine, output: Option<PathBuf>) -> CosimReport {
    let o = CosimOptions {
        output,
        ..options(method, engine, None)
    };
    cosim(scene, &o).unwrap_or_else(|e| panic!("{} {method} {engine}: {e}", scene.name))
}

fn all_engines(name: &str, least_triangles: u64, least_pixels_per_cycle: f64) {
    let scene = load(name);
    for method in [Method::Quadratic, Method::Gouraud] {
        let directory = tempfile::tempdir().expect("temporary directory");
        let mut frames = vec![];
        for engine in Engine::ALL {
            let output = directory.path().join(engine.name());
            let r = run(&scene, method, engine, Some(output.clone()));
            assert_eq!(
                r.mismatches, 0,
                "{name} {method} {engine}: {:?}",
                r.first_mismatch
            );
            assert!(
                r.arithmetic["max_lsb"] <= 1.0,
                "{name} {method}: arithmetic error {:?}",
                r.arithmetic
            );
            assert!(
                r.method_f64.max_lsb <= 1,
                "{name} {method}: frame against f64 {:?}",
                r.method_f64
            );
            assert!(
                r.error_bound_lsb <= 0.25,
                "{name} {method}: bound {}",
                r.error_bound_lsb
            );
            assert!(
                r.pixels_per_cycle >= least_pixels_per_cycle,
                "{name} {method}: {} pixels per clock",
                r.pixels_per_cycle
            );
            assert!(
                r.host.triangles >= least_triangles,
                "{name}: {} triangles",
                r.host.triangles
            );
            frames.push(std::fs::read(output.join("simulated.png")).expect("frame written"));
            assert_eq!(
                std::fs::read(output.join("expected.png")).expect("frame written"),
                frames[0],
                "{name} {method} {engine}"
            );
        }
        assert!(
            frames.iter().all(|f| *f == frames[0]),
            "{name} {method}: engines draw different frames"
        );
    }
}

#[test]
fn sphere_of_690_triangles() {
    all_engines("sphere-690.toml", 300, 0.9);
}

#[test]
fn teapot() {
    all_engines("teapot.toml", 2000, 0.0);
}

#[test]
fn every_other_sphere() {
    all_engines("sphere-168.toml", 80, 0.9);
    all_engines("sphere-374.toml", 180, 0.9);
}

#[test]
fn every_other_scene() {
    for name in [
        "torus-288.toml",
        "two-lights.toml",
        "gem.toml",
        "rings.toml",
    ] {
        all_engines(name, 10, 0.0);
    }
}

#[test]
fn a_large_frame_takes_the_wide_formats() {
    let scene = load("sphere-168.toml");
    for method in [Method::Quadratic, Method::Gouraud] {
        let large = |engine| {
            let o = CosimOptions {
                size: Some((640, 480)),
                ..options(method, engine, None)
            };
            cosim(&scene, &o).unwrap_or_else(|e| panic!("{e}"))
        };
        let r = large(Engine::RustHdl);
        assert_eq!((r.mismatches, r.width), (0, 640));
        assert_eq!(large(Engine::Compiled).mismatches, 0);
        assert!(
            r.arithmetic["max_lsb"] <= 1.0 && r.error_bound_lsb <= 0.25,
            "{:?} {}",
            r.arithmetic,
            r.error_bound_lsb
        );
        assert_eq!(
            r.formats["colour"].frac,
            if method == Method::Quadratic { 24 } else { 14 }
        );
    }
}

/// The widest and the highest frame, of a scene that runs past every border: the guard band keeps it in range.
#[test]
fn the_largest_frames_stay_in_the_core_s_coordinates() {
    let scene = load("two-lights.toml");
    for size in [(2040, 40), (1500, 1024), (60, 1024)] {
        let o = CosimOptions {
            size: Some(size),
            ..options(Method::Gouraud, Engine::RustHdl, None)
        };
        let r = cosim(&scene, &o).unwrap_or_else(|e| panic!("{size:?}: {e}"));
        assert_eq!(r.mismatches, 0, "{size:?}: {:?}", r.first_mismatch);
        assert!(
            r.arithmetic["max_lsb"] <= 1.0 && r.pixels > 1_000,
            "{size:?}: {} {:?}",
            r.pixels,
            r.arithmetic
        );
    }
}

#[test]
fn what_the_host_leaves_out_changes_no_pixel() {
    let scene = load("two-lights.toml");
    let directory = tempfile::tempdir().expect("temporary directory");
    let mut frames = vec![];
    let mut writes = vec![];
    for (skip_unchanged, broadcast) in [(true, true), (true, false), (false, true), (false, false)]
    {
        let output = directory
            .path()
            .join(format!("{skip_unchanged}-{broadcast}"));
        let o = CosimOptions {
            output: Some(output.clone()),
            stimulus: shadegate_gen::stimulus::StimulusOptions {
                skip_unchanged,
                broadcast,
                ..Default::default()
            },
            ..options(Method::Quadratic, Engine::RustHdl, None)
        };
        let r = cosim(&scene, &o).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(r.mismatches, 0);
        assert_eq!(r.host.skipped["unchanged-words"] > 0, skip_unchanged);
        frames.push(std::fs::read(output.join("simulated.png")).expect("frame written"));
        writes.push(r.host.writes);
    }
    assert!(frames.iter().all(|f| *f == frames[0]));
    assert!(
        writes[0] <= writes[1] && writes[0] < writes[3],
        "{writes:?}"
    );
}
