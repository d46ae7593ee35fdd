//! The quadratic-dots cores without tables on scenes: every engine gives the integer model's frame, every pixel is within
//! one LSB of the same functions in f64, and scenes choose their core by their lights and materials.

mod support;

use shadegate_reference::scene::{Highlight, LightKind};
use shadegate_reference::{scene, Method, Scene};
use shadegate_testbench::cosim::{cosim, CosimOptions, CosimReport};
use shadegate_testbench::engine::Engine;
use support::{load, options};

fn run(scene: &Scene, engine: Engine, size: Option<(u32, u32)>) -> CosimReport {
    let r = cosim(scene, &options(Method::QuadraticDots, engine, size))
        .unwrap_or_else(|e| panic!("{engine}: {e}"));
    assert_eq!(r.mismatches, 0, "{engine}: {:?}", r.first_mismatch);
    assert!(r.holds() && r.method_f64.max_lsb <= 1, "{:?}", r.method_f64);
    assert!(r.error_bound_lsb < 0.25, "{}", r.error_bound_lsb);
    r
}

#[test]
fn highlights_without_a_table() {
    let scene = load("highlights.toml");
    for engine in Engine::ALL {
        let r = run(&scene, engine, Some((120, 90)));
        assert_eq!(r.core, "quadratic-dots-kappa");
        assert!(r.pixels > 2_000 && r.host.skipped["dark-words"] > 1_000);
    }
    let r = run(&scene, Engine::Compiled, None);
    // Near the truth, which has the same highlight on exact normals.
    assert!(r.error.max_lsb <= 4, "{:?}", r.error);
}

#[test]
fn a_spot() {
    let scene = load("one-spot.toml");
    for engine in Engine::ALL {
        let r = run(&scene, engine, Some((120, 90)));
        assert_eq!(r.core, "quadratic-dots-spot");
        assert!(r.pixels > 2_000 && r.host.skipped["dark-words"] > 10_000);
    }
    for falloff in [scene::Falloff::Soft, scene::Falloff::Hard] {
        let mut scene = load("one-spot.toml");
        if let LightKind::Spot { falloff: f, .. } = &mut scene.lights[0].kind {
            *f = falloff;
        }
        let r = run(&scene, Engine::Compiled, None);
        assert!(r.error.max_lsb <= 6, "{falloff:?}: {:?}", r.error);
    }
}

/// Taylor and x-shading differ in their words alone, here too.
#[test]
fn set_ups_of_taylor_and_x_shading() {
    let scene = load("highlights.toml");
    for method in [Method::Taylor, Method::XShading] {
        let o = CosimOptions {
            method,
            ..options(Method::QuadraticDots, Engine::Compiled, None)
        };
        let r = cosim(&scene, &o).expect("drawn");
        assert!(r.holds(), "{method}: {:?}", r.arithmetic);
        assert_eq!(r.core, "quadratic-dots-kappa");
    }
}

#[test]
fn scenes_that_they_do_not_draw_are_refused() {
    let refused = |scene: &Scene| {
        let error = cosim(
            scene,
            &options(Method::QuadraticDots, Engine::Compiled, None),
        )
        .expect_err("refused");
        let text = error.to_string();
        text.split_once(".toml: ")
            .expect("names the file")
            .1
            .to_owned()
    };
    let of = |core: &str, what: &str, expected: &str| {
        format!("{what}, which the {core} core does not draw; expected {expected}, or the command render")
    };
    let (kappa, spot) = ("quadratic-dots-kappa", "quadratic-dots-spot");
    assert_eq!(
        refused(&load("spot.toml")),
        of(spot, "the scene has 3 lights", "one light")
    );
    let mut three = load("spot.toml");
    three.lights.truncate(1);
    assert_eq!(
        refused(&three),
        of(
            spot,
            "the spot has the fall-off of Warn",
            "falloff = 'soft' or 'hard'"
        )
    );
    let mut three = load("spot.toml");
    three.lights.drain(..2);
    assert_eq!(
        refused(&three),
        of(spot, "the light has an attenuation", "a light without it")
    );
    let mut one = load("one-spot.toml");
    one.materials[1].highlight = Highlight::Pow;
    assert_eq!(
        refused(&one),
        of(
            spot,
            "material 'ring' has another highlight",
            "highlight = 'kappa'"
        )
    );
    let mut narrow = load("one-spot.toml");
    if let LightKind::Spot { width, .. } = &mut narrow.lights[0].kind {
        *width = scene::SpotWidth::Field(5.0);
    }
    let edge = "a cone whose edge has a cosine of at most 127/128";
    assert_eq!(refused(&narrow), of(spot, "the spot is too narrow", edge));
    let mut steep = load("highlights.toml");
    steep.materials[1].highlight = Highlight::Kappa { degree: 5 };
    assert_eq!(
        refused(&steep),
        of(
            kappa,
            "material 'glaze' has a highlight of another degree",
            "degree = 2, 3 or 4"
        )
    );
    let mut sharp = load("highlights.toml");
    sharp.materials[2].shininess = 700.0;
    assert_eq!(
        refused(&sharp),
        of(
            kappa,
            "material 'lacquer' has too narrow a highlight",
            "a shininess of at most about 340, 470 and 590 for degree 2, 3 and 4"
        )
    );
}
