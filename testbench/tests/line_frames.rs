//! Wireframes through the line cores: every engine gives the integer model's frame, the frame is the software renderer's,
//! and what no core draws is refused.

mod support;

use shadegate_reference::line::LineFilter;
use shadegate_reference::{Method, Scene};
use shadegate_testbench::cosim::{cosim, CosimError, CosimReport};
use shadegate_testbench::engine::Engine;
use support::{load, options};

fn run(scene: &Scene, engine: Engine, size: Option<(u32, u32)>) -> CosimReport {
    let r = cosim(scene, &options(Method::Quadratic, engine, size))
        .unwrap_or_else(|e| panic!("{} {engine}: {e}", scene.name));
    let (name, line) = (&scene.name, scene.render.line);
    println!(
        "{name} {line} {engine}: {} pixels, {:.3} per clock, method {:?}, arithmetic {:?}",
        r.pixels, r.pixels_per_cycle, r.method_f64, r.arithmetic
    );
    assert_eq!(
        r.mismatches, 0,
        "{name} {line} {engine}: {:?}",
        r.first_mismatch
    );
    assert_eq!(r.core, line.name());
    assert_eq!(r.method, line.name());
    assert!(r.holds());
    assert!(r.pixels > 500, "{name} {line}: {} pixels", r.pixels);
    r
}

/// The frame of the core and that of the renderer: equal, but for the box filter's ties.
fn same_frame(r: &CosimReport, line: LineFilter) {
    let most = u8::from(line == LineFilter::Box);
    assert!(r.method_f64.max_lsb <= most, "{line}: {:?}", r.method_f64);
    assert!(r.method_f64.rms_lsb < 0.05, "{line}: {:?}", r.method_f64);
}

#[test]
fn every_filter_in_every_engine() {
    let mut scene = load("wire-48.toml");
    for line in LineFilter::ALL {
        scene.render.line = line;
        for engine in Engine::ALL {
            // The builds of two cores more would only take time.
            let slow = matches!(engine, Engine::Verilator | Engine::Cxxrtl);
            if slow && line != LineFilter::Cone {
                continue;
            }
            same_frame(&run(&scene, engine, None), line);
        }
    }
}

#[test]
fn depth_cueing_and_hidden_lines() {
    for name in ["wire-40.toml", "wire-cue.toml"] {
        let mut scene = load(name);
        for line in LineFilter::ALL {
            scene.render.line = line;
            same_frame(&run(&scene, Engine::Compiled, None), line);
        }
    }
}

#[test]
fn a_large_frame_takes_the_wide_addresses() {
    let scene = load("wire-cue.toml");
    for size in [(800, 600), (2040, 60)] {
        same_frame(&run(&scene, Engine::Compiled, Some(size)), LineFilter::Cone);
    }
}

#[test]
fn wires_over_faces_are_refused() {
    let e = cosim(
        &load("depth-cue.toml"),
        &options(Method::Quadratic, Engine::Compiled, None),
    )
    .expect_err("a mixture");
    assert!(
        matches!(
            e,
            CosimError::Mixture {
                wireframe: 1,
                shaded: 0
            }
        ),
        "{e}"
    );
    assert_eq!(
        e.to_string(),
        "object[1] of the scene is a wireframe and object[0] is shaded, and no core draws both; expected the same draw for every object"
    );
}
