//! Real scenes through the span cores: every engine gives the integer model's frame, and every pixel is within one LSB
//! of its method in f64 (for tables: of a word that the method may have there).

mod support;

use shadegate_reference::{Method, Scene};
use shadegate_testbench::cosim::{cosim, CosimReport};
use shadegate_testbench::engine::Engine;
use support::{load, options};

const METHODS: [Method; 9] = [
    Method::Slerp,
    Method::SlerpChebyshev,
    Method::SphericalCos2Rom4,
    Method::SphericalCos2Rom6,
    Method::SphericalCos2Rom8,
    Method::SphericalCosN,
    Method::Blake,
    Method::BlakeRefit,
    Method::BlakeTrapezium,
];

fn run(s: &Scene, method: Method, engine: Engine, size: Option<(u32, u32)>) -> CosimReport {
    let r = cosim(s, &options(method, engine, size))
        .unwrap_or_else(|e| panic!("{} {method} {engine}: {e}", s.name));
    assert_eq!(
        r.mismatches, 0,
        "{} {method} {engine}: {:?}",
        s.name, r.first_mismatch
    );
    assert!(
        r.arithmetic["max_lsb"] <= 1.0,
        "{} {method} {engine}: {:?}",
        s.name,
        r.arithmetic
    );
    println!(
        "{} {method} {engine}: {} triangles, {} writes, {:.3} pixels per clock, {:?}",
        s.name, r.host.triangles, r.host.writes, r.pixels_per_cycle, r.arithmetic
    );
    r
}

#[test]
fn spheres_in_this_process() {
    for name in ["sphere-168.toml", "sphere-690.toml"] {
        let scene = load(name);
        for method in METHODS {
            let r = run(&scene, method, Engine::Compiled, None);
            assert!(r.host.triangles > 80 && r.pixels > 30_000);
        }
    }
    let r = run(
        &load("sphere-168.toml"),
        Method::Slerp,
        Engine::RustHdl,
        None,
    );
    assert!(r.pixels_per_cycle > 0.5, "{}", r.pixels_per_cycle);
}

#[test]
fn perspective_and_large_frames() {
    for method in [Method::Slerp, Method::SphericalCosN] {
        run(&load("gem.toml"), method, Engine::RustHdl, None);
        run(&load("torus-288.toml"), method, Engine::Compiled, None);
    }
    let wide = run(
        &load("sphere-168.toml"),
        Method::Slerp,
        Engine::Compiled,
        Some((640, 480)),
    );
    assert_eq!(wide.width, 640);
}

#[test]
fn emitted_verilog_in_other_simulators() {
    let scene = load("sphere-168.toml");
    for method in [
        Method::Slerp,
        Method::SlerpChebyshev,
        Method::SphericalCos2Rom6,
        Method::BlakeTrapezium,
    ] {
        run(&scene, method, Engine::Icarus, Some((96, 72)));
    }
    // Its C++ takes seconds to build; the netlist is the same that Icarus reads.
    run(&scene, Method::Slerp, Engine::Verilator, Some((96, 72)));
}

#[test]
fn what_a_span_core_does_not_draw_is_said_in_one_line() {
    let refused = |name: &str, method: Method| {
        let e = cosim(
            &load(name),
            &options(method, Engine::RustHdl, Some((32, 24))),
        );
        e.expect_err("refused").to_string()
    };
    let lights = refused("two-lights.toml", Method::Slerp);
    assert!(
        lights.ends_with("two-lights.toml: the scene has 2 lights, which the slerp core does not draw; expected one light, or the command render"),
        "{lights}"
    );
    let near = refused("gem.toml", Method::Blake);
    assert!(
        near.contains("the camera or the light is near, which the blake core does not draw"),
        "{near}"
    );
    let model = refused("materials.toml", Method::Slerp);
    assert!(model.contains("cannot draw material"), "{model}");
    let without = refused("gem.toml", Method::DotProduct);
    assert!(without.contains("slerp-chebyshev"), "{without}");
}
