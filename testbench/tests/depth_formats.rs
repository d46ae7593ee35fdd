//! Depth words linear in 1/z or in z: the core draws either, bit by bit; what is exact where.

mod support;

use shadegate_gen::scene::DepthFormat;
use shadegate_gen::stimulus::StimulusOptions;
use shadegate_reference::{Method, Scene};
use shadegate_testbench::cosim::{cosim, prelude, CosimOptions, CosimReport, Prelude};
use shadegate_testbench::engine::Engine;
use support::load;

const SIZE: Option<(u32, u32)> = Some((96, 72));

fn stimulus(depth: DepthFormat) -> StimulusOptions {
    StimulusOptions {
        depth,
        ..StimulusOptions::default()
    }
}

fn set_up(scene: &Scene, depth: DepthFormat) -> Prelude {
    prelude(scene, Method::Gouraud, SIZE, &stimulus(depth)).unwrap_or_else(|e| panic!("{e}"))
}

fn run(scene: &Scene, method: Method, depth: DepthFormat) -> CosimReport {
    let o = CosimOptions {
        method,
        engine: Engine::RustHdl,
        size: SIZE,
        wave: None,
        output: None,
        stimulus: stimulus(depth),
        command: "test".into(),
    };
    cosim(scene, &o).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn either_format_is_affine_in_its_measure_and_in_the_same_order() {
    for name in ["teapot.toml", "rings.toml", "two-lights.toml"] {
        let scene = load(name);
        let [reciprocal, linear] = DepthFormat::ALL.map(|f| set_up(&scene, f));
        let mut corners: Vec<[f64; 3]> = vec![];
        for (i, t) in linear.prepared.triangles.iter().enumerate() {
            for c in 0..3 {
                let other = reciprocal.triangles[i].depth[c];
                corners.push([1.0 / t.inv_w[c], linear.triangles[i].depth[c], other]);
            }
        }
        corners.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let ends = [corners[0], corners[corners.len() - 1]];
        assert!(ends[1][0] > 1.05 * ends[0][0], "{name} has perspective");
        for [w, depth, other] in &corners {
            let part = |f: &dyn Fn(f64) -> f64| {
                let [near, far] = ends.map(|e| f(e[0]));
                1.0 + 65_534.0 * (f(*w) - far) / (near - far)
            };
            assert!((depth - part(&|w| w)).abs() < 1e-6, "{name}: z at {w}");
            assert!(
                (other - part(&|w| 1.0 / w)).abs() < 1e-6,
                "{name}: 1/z at {w}"
            );
        }
        let falls = |which: usize| {
            corners
                .windows(2)
                .all(|c| c[1][which] <= c[0][which] + 1e-6)
        };
        assert!(falls(1) && falls(2), "{name}: farther is smaller in both");
    }
}

#[test]
fn without_perspective_they_are_the_same() {
    let scene = load("sphere-168.toml");
    let [a, b] = DepthFormat::ALL.map(|f| set_up(&scene, f));
    assert_eq!(a.triangles, b.triangles);
    assert_eq!(a.trace.clocks, b.trace.clocks);
}

#[test]
fn a_core_draws_either() {
    for (name, method) in [
        ("rings.toml", Method::Quadratic),
        ("two-lights.toml", Method::Gouraud),
    ] {
        let scene = load(name);
        for format in DepthFormat::ALL {
            let r = run(&scene, method, format);
            assert!(r.holds(), "{name} {format}: {:?}", r.first_mismatch);
            assert_eq!(r.depth, Some(format.name()));
        }
    }
}
