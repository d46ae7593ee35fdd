//! The textured cores on scenes: every engine gives the integer model's frame, every pixel is within one LSB of the method
//! in f64 (nearest texels: or of the texel across a border that the address is at), and what no core draws is refused.

mod support;

use shadegate_gen::scene::texturing;
use shadegate_gen::stimulus::{build, Covering, Picture, StimulusOptions, Triangle};
use shadegate_gen::vectors::Trace;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::texture::{Mapping, Texturing};
use shadegate_reference::raster::{Point, Viewport};
use shadegate_reference::texture::{Filter, Texture, Wrap};
use shadegate_reference::{scene, to_byte, Method, Scene};
use shadegate_testbench::cosim::texture_oracle::colour;
use shadegate_testbench::cosim::{cosim, CosimReport};
use shadegate_testbench::engine::Engine;
use std::sync::Arc;
use support::{load, options};

fn run(scene: &Scene, method: Method, engine: Engine, size: Option<(u32, u32)>) -> CosimReport {
    let r = cosim(scene, &options(method, engine, size))
        .unwrap_or_else(|e| panic!("{} {method} {engine}: {e}", scene.name));
    assert_eq!(r.mismatches, 0, "{method} {engine}: {:?}", r.first_mismatch);
    assert!(r.holds(), "{method} {engine}: {:?}", r.arithmetic);
    assert!(
        r.arithmetic["border_pixels"] <= 0.002 * r.pixels as f64,
        "{method} {engine}: {:?} of {}",
        r.arithmetic,
        r.pixels
    );
    r
}

/// The scene with another mapping and filter of all its textures; the picture stays.
fn with(mut scene: Scene, mapping: &str, filter: Option<&str>) -> Scene {
    let text = std::fs::read_to_string(&scene.file).unwrap();
    let mut out = String::new();
    for line in text.lines() {
        let filter = filter.filter(|_| line.starts_with("filter"));
        match filter {
            Some(filter) => out += &format!("filter = \"{filter}\"\n"),
            None => out += &format!("{line}\n"),
        }
        if line.starts_with("texture") {
            out += &format!("mapping = \"{mapping}\"\n");
        }
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("textures.toml");
    std::fs::write(&path, out).unwrap();
    scene = scene::load(&path).unwrap_or_else(|e| panic!("{e}"));
    scene
}

/// One engine, all three cores; one of them with several pictures.
fn engine(engine: Engine) {
    let scene = load("textures.toml");
    let r = run(&scene, Method::Quadratic, engine, Some((48, 36)));
    assert_eq!(r.core, "textured-perspective");
    assert!(r.pixels > 1_000, "{}", r.pixels);
    for mapping in ["affine", "quadratic"] {
        let scene = with(load("textures.toml"), mapping, None);
        let r = run(&scene, Method::Gouraud, engine, Some((32, 24)));
        assert_eq!(r.core, format!("textured-{mapping}"));
    }
}

#[test]
fn rust_hdl_draws_textures() {
    engine(Engine::RustHdl);
}

#[test]
fn compiled_cores_draw_textures() {
    engine(Engine::Compiled);
}

#[test]
fn icarus_draws_textures() {
    engine(Engine::Icarus);
}

#[test]
fn verilator_draws_textures() {
    engine(Engine::Verilator);
}

/// The frame of the renderer itself, whose texels are not rounded to bytes.
#[test]
fn frames_are_those_of_the_renderer() {
    for (mapping, size) in [
        ("affine", None),
        ("quadratic", None),
        ("perspective", None),
        ("perspective", Some((640, 480))),
    ] {
        let scene = with(load("textures.toml"), mapping, Some("bilinear"));
        for method in [Method::Quadratic, Method::Gouraud] {
            let r = run(&scene, method, Engine::Compiled, size);
            // In a larger frame depths of 16 bits decide otherwise where floor and wall meet.
            if size.is_none() {
                assert!(
                    r.method_f64.max_lsb <= 1,
                    "{mapping} {method}: {:?}",
                    r.method_f64
                );
            }
            assert!(r.error_bound_lsb < 1.0, "{}", r.error_bound_lsb);
        }
    }
}

#[test]
fn what_no_core_draws_is_refused() {
    let refused = |scene: &Scene, method: Method| {
        let message = cosim(scene, &options(method, Engine::Compiled, None))
            .unwrap_err()
            .to_string();
        message.split_once(": ").unwrap().1.to_owned()
    };
    assert_eq!(
        refused(&load("tiles.toml"), Method::Quadratic),
        "material 'tiles' has a texture with a filter of several levels, which the textured core does not draw; \
         expected filter = 'nearest' or 'bilinear', or the command render"
    );
    assert_eq!(
        refused(&load("textures.toml"), Method::QuadraticDots),
        "material 'floor' has a texture, which the quadratic-dots core does not draw; expected method gouraud or \
         quadratic, or the command render"
    );
    let changed = |change: &dyn Fn(&mut shadegate_reference::texture::Layout),
                   size: (usize, usize)| {
        let mut scene = load("textures.toml");
        let m = &mut scene.materials[0];
        let mut layout = *m.texture.as_ref().unwrap().layout();
        change(&mut layout);
        let picture =
            shadegate_reference::texture::Texels::from_fn(size.0, size.1, |_, _| [0.5; 3]);
        m.texture = Some(Arc::new(Texture::new(picture, layout)));
        refused(&scene, Method::Quadratic)
    };
    assert!(changed(&|l| l.wrap = Wrap::Clamp, (64, 64)).contains("does not repeat"));
    assert!(changed(&|_| {}, (60, 64)).contains("has a texture of 60x64 texels"));
    assert!(changed(&|_| {}, (2048, 2)).contains("has a texture of 2048x2 texels"));
    assert!(changed(&|_| {}, (1024, 128)).contains("its textures have 135172 texels together"));
    assert!(changed(
        &|l| l.mapping = shadegate_reference::texture::Mapping::Quadratic,
        (8, 8)
    )
    .contains("materials 'floor' and 'wall' have textures of different mappings"));
    assert!(changed(&|l| l.filter = Filter::SummedArea, (8, 8)).contains("several levels"));
}

#[test]
fn the_memory_grows_with_the_pictures() {
    let mut scene = load("textures.toml");
    assert_eq!(texturing(&scene).unwrap().texels_log2, 14);
    scene.objects.truncate(1);
    assert_eq!(texturing(&scene).unwrap().texels_log2, 12);
}

/// A small generator of its own.
struct Draw(u64);

impl Draw {
    fn below(&mut self, limit: u64) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % limit
    }

    fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.below(1 << 24) as f64 / (1 << 24) as f64
    }
}

/// Squares of one texel, black and white: nothing changes more from texel to texel.
fn harsh() -> Arc<Picture> {
    let texel = |i: usize| [255 * ((i % 8 + i / 8) % 2) as u8, (i * 37 % 256) as u8, 255];
    Arc::new(Picture {
        width: 8,
        height: 4,
        texels: (0..32).map(texel).collect(),
    })
}

/// A triangle over a whole frame, its far corner anywhere; addresses as far apart as the core takes them.
fn adversary(d: &mut Draw, mapping: Mapping, view: Viewport, i: u64) -> Triangle {
    let (w, h) = (view.width as f64, view.height as f64);
    let corner = |x: f64, y: f64| Point {
        x: (x * 256.0) as i32,
        y: (y * 256.0) as i32,
    };
    let mut position = [
        corner(d.between(-0.2, 0.1) * w, d.between(-0.2, 1.2) * h),
        corner(d.between(0.9, 1.2) * w, d.between(-0.2, 0.4) * h),
        corner(d.between(0.5, 1.2) * w, d.between(0.5, 1.2) * h),
    ];
    position.rotate_left((i % 3) as usize);
    let extent = [3.0, 100.0, 900.0][d.below(3) as usize];
    let knots = if mapping == Mapping::Quadratic { 6 } else { 3 };
    let depth = [1.0, 1.5, 8.0, 32.0][d.below(4) as usize];
    let mut address: Vec<[f64; 3]> = (0..knots)
        .map(|k| {
            let w = if k == 1 {
                1.0
            } else {
                d.between(1.0 / depth, 1.0)
            };
            [d.between(0.0, extent) - 300.0, d.between(0.0, extent), w]
        })
        .collect();
    if i.is_multiple_of(5) {
        // On texel centres and borders.
        address
            .iter_mut()
            .for_each(|a| (a[0], a[1]) = (a[0].round(), a[1].round() + 0.5));
    }
    Triangle {
        position,
        depth: [(i + 1) as f64 * 100.0; 3],
        knots: (0..6)
            .map(|_| [255.0, d.between(0.0, 255.0), d.between(0.0, 300.0)])
            .collect(),
        material: None,
        covering: Some(Covering {
            picture: harsh(),
            nearest: i % 4 == 3,
            address,
        }),
        relief: None,
        label: format!("adversary {i}"),
    }
}

#[test]
fn spans_of_a_thousand_pixels_are_within_one_lsb() {
    for (mapping, seed) in [
        (Mapping::Affine, 1),
        (Mapping::Quadratic, 2),
        (Mapping::Perspective, 3),
    ] {
        for (width, height) in [(640, 30), (1024, 96)] {
            let view = Viewport { width, height };
            let texturing = Texturing {
                mapping,
                texels_log2: 12,
            };
            let core = Core::for_frame(Order::Textured(texturing), width, height).unwrap();
            assert_eq!(core.wide, width == 1024);
            let mut d = Draw(seed);
            let triangles: Vec<_> = (0..24)
                .map(|i| adversary(&mut d, mapping, view, i))
                .collect();
            let stimulus = build(&core, &triangles, view, &StimulusOptions::default()).unwrap();
            let trace = Trace::record(core, &stimulus, |_| true);
            let (mut worst, mut borders, mut off) = (0u8, 0, 0);
            for pixel in &trace.pixels {
                let judged = colour(&triangles[pixel.triangle], texturing, core.wide, pixel);
                borders += usize::from(judged.border);
                for (want, got) in judged.colour.into_iter().zip(pixel.rgb) {
                    let apart = to_byte(want).abs_diff(got);
                    worst = worst.max(apart);
                    off += usize::from(apart > 0);
                }
            }
            let n = trace.pixels.len();
            println!("{mapping:?} {width}x{height}: {n} pixels, {worst} LSB, {off} off, {borders} at borders");
            assert!(
                n > 100_000 && worst == 1,
                "{mapping:?}: {n} pixels, {worst} LSB"
            );
            assert!(borders < n / 200, "{mapping:?}: {borders} of {n}");
        }
    }
}
