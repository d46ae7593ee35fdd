//! The bump cores on scenes: every engine gives the integer model's frame, every pixel is within one LSB of the method in
//! f64 and of the renderer's frame, and what they do not draw is refused.

mod support;

use shadegate_gen::stimulus::{build, GradientMap, Lobe, Material, StimulusOptions};
use shadegate_gen::stimulus::{Relief, Triangle};
use shadegate_gen::vectors::Trace;
use shadegate_hdl::bump::Bend;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::{Point, Viewport};
use shadegate_reference::{scene, to_byte, Method, Scene};
use shadegate_testbench::cosim::bump_oracle::cosines;
use shadegate_testbench::cosim::cosim;
use shadegate_testbench::engine::Engine;
use std::f64::consts::TAU;
use std::path::Path;
use std::sync::Arc;
use support::options;

const FILE: &str = "bump-core.toml";

fn text() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    std::fs::read_to_string(path.join(FILE)).unwrap()
}

/// The scene with some of its text replaced.
fn changed(pairs: &[(&str, &str)]) -> Scene {
    let mut text = text();
    for (from, to) in pairs {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(FILE);
    std::fs::write(&path, text).unwrap();
    scene::load(&path).unwrap_or_else(|e| panic!("{e}"))
}

fn run(scene: &Scene, core: &str, engine: Engine, size: Option<(u32, u32)>) -> f64 {
    let r = cosim(scene, &options(Method::Phong, engine, size)).unwrap_or_else(|e| panic!("{e}"));
    println!("{core} {engine}: {} pixels, {:?}", r.pixels, r.arithmetic);
    assert_eq!(
        (r.core.as_str(), r.mismatches),
        (core, 0),
        "{:?}",
        r.first_mismatch
    );
    assert!(r.holds(), "{engine}: {:?}", r.arithmetic);
    // The software has the same normals, but for what is interpolated on its way to them.
    assert!(r.method_f64.max_lsb <= 1, "{engine}: {:?}", r.method_f64);
    assert!(
        r.pixels > 1_000 && r.error_bound_lsb < 1.1,
        "{}",
        r.error_bound_lsb
    );
    r.pixels_per_cycle
}

const REFLECTION: [(&str, &str); 1] = [("\"newton\"", "\"reflection\"")];

fn engine(engine: Engine) {
    run(&changed(&[]), "bump-newton", engine, Some((64, 48)));
    run(
        &changed(&REFLECTION),
        "bump-reflection",
        engine,
        Some((64, 48)),
    );
}

#[test]
fn rust_hdl_draws_bumps() {
    engine(Engine::RustHdl);
}

#[test]
fn compiled_cores_draw_bumps() {
    engine(Engine::Compiled);
    for (pairs, core) in [
        (&[][..], "bump-newton"),
        (&REFLECTION[..], "bump-reflection"),
    ] {
        run(&changed(pairs), core, Engine::Compiled, None);
        run(&changed(pairs), core, Engine::Compiled, Some((640, 480)));
    }
}

#[test]
fn icarus_draws_bumps() {
    engine(Engine::Icarus);
}

#[test]
fn verilator_draws_bumps() {
    engine(Engine::Verilator);
}

/// A light among the objects: vectors that differ from pixel to pixel.
#[test]
fn near_lights() {
    let point = "kind = \"point\"\nposition = [1.2, 3, 2.5]";
    let scene = changed(&[
        (
            "kind = \"directional\"\ndirection = [-0.9, -2, -1.4]",
            point,
        ),
        ("scale = 2", "scale = 2\nsubdivisions = 4"),
    ]);
    let o = options(Method::Phong, Engine::Compiled, None);
    let r = cosim(&scene, &o).unwrap();
    assert!(r.mismatches == 0 && r.holds(), "{:?}", r.arithmetic);
    // What quadrics through six knots are off.
    assert!(r.method_f64.rms_lsb < 1.0, "{:?}", r.method_f64);
}

#[test]
fn what_they_do_not_draw_is_refused() {
    let bend = "bump_normalise = \"newton\"";
    for (from, to, what) in [
        (
            "height = 4.4",
            "fov = 40",
            "the camera is near, which the bump-newton core",
        ),
        (
            "shininess = 30",
            "shininess = 300",
            "has a shininess of 300",
        ),
        (
            bend,
            "bump_normalise = \"exact\"",
            "by a square root, which the bump-reflection core",
        ),
        (
            "bump = \"bumps\"",
            "bump = \"bumps\"\nbump_gradient = \"b-spline\"",
            "bump_gradient = 'linear'",
        ),
        (
            "bump = \"bumps\"",
            "bump = \"bumps\"\nwrap = \"clamp\"",
            "does not repeat",
        ),
        (
            "bump = \"bumps\"",
            "bump = \"bumps\"\ntexture = \"tiles\"",
            "has a texture",
        ),
        (
            "bump_scale = 0.04",
            "bump_scale = 1",
            "a bump map steeper than 2",
        ),
        (
            "shape = \"box\"",
            "shape = \"sphere\"",
            "lies askew on an object",
        ),
    ] {
        let refused = cosim(
            &changed(&[(from, to)]),
            &options(Method::Phong, Engine::Compiled, None),
        );
        let message = refused.map(|_| ()).unwrap_err().to_string();
        assert!(message.contains(what), "{message}");
    }
    let mixed = text().replacen("\"newton\"", "\"reflection\"", 1);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(FILE);
    std::fs::write(&path, mixed).unwrap();
    let o = |m| options(m, Engine::Compiled, None);
    let refused = |scene: &Scene, m| cosim(scene, &o(m)).map(|_| ()).unwrap_err().to_string();
    let message = refused(&scene::load(&path).unwrap(), Method::Phong);
    assert!(message.contains("normalised otherwise"), "{message}");
    let message = refused(&changed(&[]), Method::QuadraticDots);
    assert!(
        message.contains("has a bump map, which no core of this method draws"),
        "{message}"
    );
}

/// A small generator of its own.
struct Draw(u64);

impl Draw {
    fn between(&mut self, from: f64, to: f64) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * (self.0 >> 40) as f64 / (1 << 24) as f64
    }
}

/// Waves of all directions, up to 1 steep.
fn waves() -> Arc<GradientMap> {
    Arc::new(GradientMap::new(|x, y| {
        let (x, y) = (x as f64 * TAU / 64.0, y as f64 * TAU / 64.0);
        [(3.0 * x + y).sin() * 0.7, (2.0 * y - x).cos() * 0.7]
    }))
}

/// Unit vectors near the normal, at the vertices and, of their sums, in the middles of the edges.
fn vectors(d: &mut Draw) -> Vec<[f64; 3]> {
    let unit = |v: [f64; 3]| {
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        v.map(|x| x / length)
    };
    let (a, b) = (d.between(-0.6, 0.6), d.between(-0.6, 0.6));
    let mut out: Vec<[f64; 3]> = (0..3)
        .map(|_| unit([a + d.between(-0.2, 0.2), b + d.between(-0.2, 0.2), 1.0]))
        .collect();
    for (i, j) in [(0, 1), (0, 2), (1, 2)] {
        out.push(unit(std::array::from_fn(|k| out[i][k] + out[j][k])));
    }
    out
}

/// A triangle over a whole frame, its far corner anywhere.
fn adversary(d: &mut Draw, view: Viewport, map: &Arc<GradientMap>, i: usize) -> Triangle {
    let (w, h) = (f64::from(view.width), f64::from(view.height));
    let mut corner = |x: [f64; 2], y: [f64; 2]| Point {
        x: (d.between(x[0], x[1]) * w * 256.0) as i32,
        y: (d.between(y[0], y[1]) * h * 256.0) as i32,
    };
    let mut position = [
        corner([-0.2, 0.1], [-0.2, 1.2]),
        corner([0.9, 1.2], [-0.2, 0.4]),
        corner([0.5, 1.2], [0.5, 1.2]),
    ];
    position.rotate_left(i % 3);
    let mut knots = vectors(d);
    knots.extend(vectors(d));
    let extent = [2.0, 40.0, 700.0][i % 3];
    let mut at = || [d.between(-extent, extent), d.between(0.0, extent)];
    let address = [at(), at(), at()];
    Triangle {
        position,
        depth: [(i + 1) as f64 * 100.0; 3],
        knots,
        material: Some(Material {
            ambient: [0.0, 10.0, 20.0],
            diffuse: [255.0, 120.0, 60.0],
            specular: [0.0, 100.0, 255.0],
            shininess: 24.0,
            lobe: Lobe::Power,
            cone: None,
        }),
        covering: None,
        relief: Some(Relief {
            map: map.clone(),
            address,
        }),
        label: format!("adversary {i}"),
    }
}

#[test]
fn spans_of_a_thousand_pixels_are_within_one_lsb() {
    let map = waves();
    for (bend, seed) in [(Bend::Newton, 1), (Bend::Reflection, 2)] {
        for (width, height) in [(640, 30), (1024, 96)] {
            let view = Viewport { width, height };
            let core = Core::for_frame(Order::Bump(bend), width, height).unwrap();
            assert_eq!(core.wide, width == 1024);
            let mut d = Draw(seed);
            let triangles: Vec<_> = (0..18).map(|i| adversary(&mut d, view, &map, i)).collect();
            let stimulus = build(&core, &triangles, view, &StimulusOptions::default()).unwrap();
            let trace = Trace::record(core, &stimulus, |_| true);
            let (mut worst, mut off) = (0.0f64, 0);
            for pixel in &trace.pixels {
                let t = &triangles[pixel.triangle];
                let (x, y) = (i32::from(pixel.x), i32::from(pixel.y));
                let [light, half] = cosines(t, bend, x, y);
                let (light, power) = (light.clamp(0.0, 1.0), half.clamp(0.0, 1.0).powf(24.0));
                let m = t.material.as_ref().unwrap();
                for c in 0..3 {
                    let want = m.ambient[c] + m.diffuse[c] * light + m.specular[c] * power;
                    let want = want.min(255.0);
                    // How far beyond the half LSB of its rounding.
                    let apart = (want - f64::from(pixel.rgb[c])).abs() - 0.5;
                    worst = worst.max(apart);
                    off += usize::from(to_byte(want) != pixel.rgb[c]);
                }
            }
            let n = trace.pixels.len();
            println!("{bend:?} {width}x{height}: {n} pixels, {worst:.3} LSB, {off} off");
            let bound = core.error_bound(if core.wide { 4095 } else { 1023 });
            assert!(
                n > 50_000 && worst < bound && bound < 1.1,
                "{worst} of {bound}"
            );
            // A unit of a factor that is lost is a tenth of this.
            assert!(worst > 0.02 && off < n / 2, "{worst} {off}");
        }
    }
}
