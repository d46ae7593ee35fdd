//! The quadratic-dots core on scenes: every engine gives the integer model's frame, and every pixel is within one LSB of
//! the method in f64; taylor and x-shading are the same core with other words.

mod support;

use shadegate_reference::{Method, Scene};
use shadegate_testbench::cosim::{cosim, CosimOptions, CosimReport};
use shadegate_testbench::engine::Engine;
use support::load;

fn run(scene: &Scene, method: Method, engine: Engine, size: Option<(u32, u32)>) -> CosimReport {
    let options = support::options(method, engine, size);
    let r =
        cosim(scene, &options).unwrap_or_else(|e| panic!("{} {method} {engine}: {e}", scene.name));
    assert_eq!(
        r.mismatches, 0,
        "{} {method} {engine}: {:?}",
        scene.name, r.first_mismatch
    );
    assert!(
        r.arithmetic["max_lsb"] <= 1.0 && r.method_f64.max_lsb <= 1,
        "{} {method}: {:?}, frame {:?}",
        scene.name,
        r.arithmetic,
        r.method_f64
    );
    r
}

#[test]
fn every_engine_draws_the_same_sphere() {
    let (small, large) = (load("sphere-168.toml"), load("sphere-690.toml"));
    for engine in Engine::ALL {
        let r = run(&small, Method::QuadraticDots, engine, Some((120, 90)));
        assert!(r.pixels > 3_000);
    }
    for engine in [Engine::Compiled, Engine::RustHdl] {
        let r = run(&large, Method::QuadraticDots, engine, None);
        assert!(
            r.pixels > 20_000 && r.pixels_per_cycle >= 0.9,
            "{}",
            r.pixels_per_cycle
        );
        // What six-knot colours cannot do: the frame of Phong shading itself.
        assert!(
            r.error.max_lsb <= 2 && r.error_bound_lsb < 0.25,
            "{:?}",
            r.error
        );
    }
}

#[test]
fn set_ups_of_taylor_and_x_shading() {
    let scene = load("sphere-690.toml");
    for method in [
        Method::Taylor,
        Method::TaylorVertex,
        Method::XShading,
        Method::XShadingCached,
    ] {
        for engine in [Engine::Compiled, Engine::RustHdl] {
            let r = run(&scene, method, engine, None);
            assert_eq!(
                (r.core.as_str(), r.method.as_str()),
                ("quadratic-dots", method.name())
            );
        }
    }
}

#[test]
fn other_scenes_and_large_frames() {
    for name in ["sphere-168.toml", "sphere-374.toml", "teapot.toml"] {
        let mut scene = load(name);
        scene.lights.truncate(1);
        run(&scene, Method::QuadraticDots, Engine::Compiled, None);
    }
    let large = run(
        &load("sphere-168.toml"),
        Method::QuadraticDots,
        Engine::Compiled,
        Some((640, 480)),
    );
    assert_eq!(large.formats["lobe"].frac, 38);
}

/// The Duff core: Phong shading itself, within the rounding.
#[test]
fn duff_draws_phong_shading_on_every_engine() {
    let (small, large) = (load("sphere-168.toml"), load("sphere-690.toml"));
    for engine in Engine::ALL {
        let r = run(&small, Method::Duff, engine, Some((120, 90)));
        assert!(r.pixels > 3_000);
    }
    let r = run(&large, Method::Duff, Engine::Compiled, None);
    assert!(
        r.error.max_lsb <= 1 && r.error_bound_lsb < 0.25,
        "{:?} {}",
        r.error,
        r.error_bound_lsb
    );
    assert!(r.pixels_per_cycle >= 0.9, "{}", r.pixels_per_cycle);
}

/// Exponents from matt to mirror, on the same sphere: the table is chosen anew for each.
#[test]
fn every_exponent() {
    let mut scene = load("sphere-168.toml");
    for n in [1.0, 2.5, 10.0, 50.0, 100.0, 400.0, 2048.0] {
        for m in &mut scene.materials {
            m.shininess = n;
        }
        run(&scene, Method::QuadraticDots, Engine::Compiled, None);
    }
}

#[test]
fn scenes_that_it_does_not_draw_are_refused() {
    let refused = |scene: &Scene| {
        let options = CosimOptions {
            method: Method::QuadraticDots,
            engine: Engine::Compiled,
            size: None,
            wave: None,
            output: None,
            stimulus: Default::default(),
            command: "test".into(),
        };
        let error = cosim(scene, &options).expect_err("refused").to_string();
        error
            .split_once(".toml: ")
            .expect("names the file")
            .1
            .to_owned()
    };
    let tail = "which the quadratic-dots core does not draw; expected";
    assert_eq!(
        refused(&load("two-lights.toml")),
        format!("the scene has 2 lights, {tail} one light, or the command render")
    );
    let mut scene = load("sphere-168.toml");
    let name = scene.materials[0].name.clone();
    scene.materials[0].shininess = 0.5;
    assert_eq!(
        refused(&scene),
        format!(
            "material '{name}' has a shininess of 0.5, {tail} 1 to 2048, or the command render"
        )
    );
    scene.materials[0].shadow = 0.5;
    assert_eq!(
        refused(&scene),
        format!("material '{name}' has a shadow, {tail} shadow = 0, or the command render")
    );
    assert!(refused(&load("spot.toml")).contains("does not draw"));
}
