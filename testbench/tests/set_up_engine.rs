//! Scenes through the core that sets triangles up itself: every engine gives the integer model's frame, which covers the
//! same pixels as the one that the host sets up, with at most one LSB of arithmetic error on every pixel.

mod support;

use shadegate_gen::scene::SetUp;
use shadegate_gen::stimulus::StimulusOptions;
use shadegate_reference::{Method, Scene};
use shadegate_testbench::cosim::{cosim_by, prelude_by, CosimError, CosimReport};
use shadegate_testbench::engine::Engine;
use std::collections::BTreeSet;
use support::load;

fn run(
    scene: &Scene,
    method: Method,
    engine: Engine,
    size: Option<(u32, u32)>,
) -> Result<CosimReport, CosimError> {
    let o = support::options(method, engine, size);
    cosim_by(scene, &o, SetUp::Engine)
}

fn judge(r: &CosimReport) {
    assert_eq!(
        r.mismatches, 0,
        "{} {}: {:?}",
        r.scene, r.engine, r.first_mismatch
    );
    assert!(
        r.arithmetic["max_lsb"] <= 1.0 && r.method_f64.max_lsb <= 1,
        "{}: {:?} {:?}",
        r.scene,
        r.arithmetic,
        r.method_f64
    );
    assert!(r.error_bound_lsb < 1.0, "{}", r.error_bound_lsb);
}

#[test]
fn every_engine_draws_the_sphere() {
    let scene = load("sphere-168.toml");
    for engine in Engine::ALL {
        let r = run(&scene, Method::Quadratic, engine, None).unwrap_or_else(|e| panic!("{e}"));
        judge(&r);
        assert!(r.pixels > 10_000, "{}", r.pixels);
    }
}

#[test]
fn other_scenes_and_the_wide_formats() {
    for (name, size) in [
        ("torus-288.toml", None),
        ("gem.toml", None),
        ("sphere-168.toml", Some((640, 480))),
        ("sphere-374.toml", Some((1500, 1024))),
    ] {
        let r = run(&load(name), Method::Quadratic, Engine::Compiled, size);
        judge(&r.unwrap_or_else(|e| panic!("{name}: {e}")));
    }
}

#[test]
fn coverage_is_that_of_the_host_s_set_up() {
    for name in ["sphere-690.toml", "teapot.toml"] {
        let scene = load(name);
        let drawn = |set_up| {
            let o = StimulusOptions::default();
            let p = prelude_by(&scene, Method::Quadratic, set_up, Some((160, 120)), &o);
            let p = p.unwrap_or_else(|e| panic!("{name}: {e}"));
            let pixels = p.trace.pixels.iter().map(|p| (p.y, p.x, p.triangle));
            pixels.collect::<BTreeSet<_>>()
        };
        let (host, engine) = (drawn(SetUp::Host), drawn(SetUp::Engine));
        // Which of two triangles is nearer may hang on the last bit of a depth; who covers what does not.
        let places = |of: &BTreeSet<(u16, u16, usize)>| -> BTreeSet<(u16, u16)> {
            of.iter().map(|p| (p.0, p.1)).collect()
        };
        assert_eq!(places(&host), places(&engine), "{name}");
        let other = host.symmetric_difference(&engine).count();
        assert!(
            other * 1000 <= host.len(),
            "{name}: {other} of {}",
            host.len()
        );
    }
}

#[test]
fn a_method_without_an_engine_is_refused() {
    let scene = load("sphere-168.toml");
    let e = run(&scene, Method::Gouraud, Engine::Compiled, None).expect_err("refused");
    assert_eq!(
        e.to_string(),
        "core 'gouraud' has no set-up engine; expected a method that has one: quadratic"
    );
}
