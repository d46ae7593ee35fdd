//! Cores that take several register words per clock, in every engine: the frame is that of one word per clock, and all
//! outputs are the integer model's in every clock.

mod support;

use shadegate_gen::stimulus::StimulusOptions;
use shadegate_reference::{Method, Scene};
use shadegate_testbench::cosim::{cosim, CosimOptions, CosimReport};
use shadegate_testbench::engine::Engine;
use support::load;

fn run(scene: &Scene, method: Method, engine: Engine, words: usize) -> CosimReport {
    let options = CosimOptions {
        method,
        engine,
        size: Some((96, 72)),
        wave: None,
        output: None,
        stimulus: StimulusOptions {
            load_words: Some(words),
            ..StimulusOptions::default()
        },
        command: "test".into(),
    };
    let r = cosim(scene, &options)
        .unwrap_or_else(|e| panic!("{} {method} {engine} {words}: {e}", scene.name));
    let what = format!("{} {method} {engine} {words}", scene.name);
    assert_eq!(r.mismatches, 0, "{what}: {:?}", r.first_mismatch);
    assert!(r.arithmetic["max_lsb"] <= 1.0, "{what}: {:?}", r.arithmetic);
    let c = &r.clocks;
    assert_eq!(c.drawing + c.loading + c.waiting, r.cycles, "{what}");
    assert_eq!(c.waiting_for.values().sum::<u64>(), c.waiting, "{what}");
    assert_eq!(r.load_words, words);
    r
}

/// Every core that has the port, in this process.
#[test]
fn every_core_in_this_process() {
    let plain = load("sphere-168.toml");
    for method in [
        Method::Gouraud,
        Method::Quadratic,
        Method::QuadraticDots,
        Method::Duff,
        Method::Slerp,
        Method::SlerpChebyshev,
        Method::SphericalCos2Rom6,
        Method::Blake,
    ] {
        let [one, two, four] = [1, 2, 4].map(|w| run(&plain, method, Engine::Compiled, w));
        assert_eq!(one.pixels, four.pixels);
        assert!(
            one.cycles > two.cycles && two.cycles >= four.cycles,
            "{method}"
        );
        assert!(one.clocks.loading > two.clocks.loading);
    }
    for method in [Method::Quadratic, Method::Duff, Method::SphericalCosN] {
        run(&plain, method, Engine::RustHdl, 4);
    }
}

#[test]
fn emitted_verilog_in_other_simulators() {
    let scene = load("sphere-168.toml");
    run(&scene, Method::Quadratic, Engine::Icarus, 4);
    run(&scene, Method::Slerp, Engine::Icarus, 2);
    run(&scene, Method::Duff, Engine::Icarus, 2);
    run(&scene, Method::Quadratic, Engine::Verilator, 4);
    run(&scene, Method::Gouraud, Engine::Cxxrtl, 2);
}
