//! Frames with textures and bumps: against rays that know nothing of triangles on screens, with every method, filter and
//! skip, and with any number of threads.

mod common;

use common::{difference, load};
use glam::{DMat4, DVec2, DVec3};
use shadegate_reference::bump::{BumpMap, Bumped, Gradient, Normalise, Relief};
use shadegate_reference::render::Vectors;
use shadegate_reference::scene::{Camera, Projection};
use shadegate_reference::shade::exact;
use shadegate_reference::shade::shader::{Run, Shader};
use shadegate_reference::texture::{pattern, Filter, Layout, Mapping, Texels, Texture, Wrap};
use shadegate_reference::{
    render, scene, to_byte, Frame, Method, Prepared, RenderOptions, RenderStats, Scene, Skips,
};
use std::sync::Arc;

const TEXTURED: [&str; 3] = ["perspective-floor", "tiles", "bump"];
const FILTERS: [Filter; 5] = [
    Filter::Nearest,
    Filter::Bilinear,
    Filter::MipMap,
    Filter::Ripmap,
    Filter::SummedArea,
];

fn draw(scene: &Scene, method: Method, skips: Skips) -> (Frame, RenderStats) {
    let size = Some((160, 120));
    let p = Prepared::new(scene, size, &Skips::all()).unwrap();
    let options = RenderOptions {
        skips,
        vectors: Vectors::None,
        ..RenderOptions::default()
    };
    render(&p, method, &options)
}

/// Gives every material with a texture another one.
fn retexture(scene: &mut Scene, texture: &Arc<Texture>) {
    for m in &mut scene.materials {
        m.texture = m.texture.is_some().then(|| texture.clone());
    }
}

fn texture(picture: Texels, mapping: Mapping, filter: Filter) -> Arc<Texture> {
    let layout = Layout {
        mapping,
        filter,
        wrap: Wrap::Clamp,
        ..Layout::default()
    };
    Arc::new(Texture::new(picture, layout))
}

/// A picture whose red is u and whose green is v, wherever it is interpolated.
fn chart() -> Texels {
    let at = |i: usize| (i as f32 + 0.5) / 256.0;
    Texels::from_fn(256, 256, |x, y| [at(x), at(y), 0.0])
}

/// The direction of the ray through a pixel centre.
fn ray(c: &Camera, size: DVec2, x: f64, y: f64) -> DVec3 {
    let Projection::Perspective { fov } = c.projection else {
        panic!("a perspective camera");
    };
    let forward = (c.target - c.eye).normalize();
    let right = forward.cross(c.up).normalize();
    let up = right.cross(forward);
    let half = (fov.to_radians() / 2.0).tan();
    let across = (2.0 * x / size.x - 1.0) * half * size.x / size.y;
    forward + right * across + up * ((1.0 - 2.0 * y / size.y) * half)
}

/// The floor of the scene, alone and lit evenly, and where its picture lies in the frame.
fn floor(texture: Arc<Texture>) -> (Scene, impl Fn(u32, u32) -> Option<DVec2>) {
    let mut scene = load("perspective-floor");
    scene.objects.truncate(1);
    let m = &mut scene.materials[0];
    (m.ambient, m.diffuse, m.specular) = (DVec3::ONE, DVec3::ZERO, DVec3::ZERO);
    m.texture = Some(texture);
    let camera = scene.camera;
    let place = move |x: u32, y: u32| {
        let centre = (f64::from(x) + 0.5, f64::from(y) + 0.5);
        let direction = ray(&camera, DVec2::new(160.0, 120.0), centre.0, centre.1);
        let hit = camera.eye + direction * (-camera.eye.y / direction.y);
        // The floor is 4 wide around x = 0 and runs from z = 2 to z = -14.
        let uv = DVec2::new((hit.x + 2.0) / 4.0, (2.0 - hit.z) / 16.0);
        let inside = |v: f64| (0.01..=0.99).contains(&v);
        (direction.y < 0.0 && inside(uv.x) && inside(uv.y)).then_some(uv)
    };
    (scene, place)
}

/// Largest distance of the drawn from the true texture coordinates, in 255ths of the picture.
fn off(frame: &Frame, place: impl Fn(u32, u32) -> Option<DVec2>) -> (f64, u32) {
    let (mut worst, mut seen) = (0.0f64, 0);
    for y in 0..120 {
        for x in 0..160 {
            if let Some(uv) = place(x, y) {
                let drawn = frame.pixels[(y * 160 + x) as usize];
                for (byte, truth) in drawn.into_iter().zip([uv.x, uv.y]) {
                    worst = worst.max((f64::from(byte) - 255.0 * truth).abs());
                }
                seen += 1;
            }
        }
    }
    (worst, seen)
}

/// The whole way from the scene file to the frame: with every method, a pixel shows the texture where its ray meets the
/// floor. Half an LSB is the rounding; the vertices are rounded to 1/256 pixel.
#[test]
fn the_picture_lies_where_rays_meet_it() {
    for filter in [Filter::Bilinear, Filter::Nearest] {
        let (scene, place) = floor(texture(chart(), Mapping::Perspective, filter));
        for method in Method::ALL.iter().copied() {
            let (frame, _) = draw(&scene, method, Skips::all());
            let (worst, seen) = off(&frame, &place);
            assert!(seen > 5000, "{seen}");
            // The nearest of 256 texels is half a texel off besides.
            let allowed = if filter == Filter::Nearest { 1.1 } else { 0.6 };
            assert!(worst < allowed, "{method} {filter:?}: {worst}");
        }
    }
}

/// A mirrored object carries its picture along, also where the near plane cuts it.
#[test]
fn mirrored_objects_carry_their_picture_along() {
    let (mut scene, place) = floor(texture(chart(), Mapping::Perspective, Filter::Bilinear));
    let o = &mut scene.objects[0];
    o.transform *= DMat4::from_scale(DVec3::new(-1.0, 1.0, 1.0));
    let (frame, _) = draw(&scene, Method::Gouraud, Skips::all());
    let (worst, seen) = off(&frame, |x, y| {
        place(x, y).map(|uv| DVec2::new(1.0 - uv.x, uv.y))
    });
    assert!(seen > 5000 && worst < 0.6, "{seen} {worst}");
}

/// The other mappings are wrong by what their laws say, and the truth is not drawn with them.
#[test]
fn other_mappings_miss_it() {
    let (mut got, mut exact) = (vec![], vec![]);
    for mapping in [Mapping::Perspective, Mapping::Quadratic, Mapping::Affine] {
        let (scene, place) = floor(texture(chart(), mapping, Filter::Bilinear));
        got.push(off(&draw(&scene, Method::Gouraud, Skips::all()).0, &place).0);
        exact.push(draw(&scene, Method::Exact, Skips::all()).0);
    }
    println!(
        "perspective {:.2}, quadratic {:.2}, affine {:.2}",
        got[0], got[1], got[2]
    );
    assert!(got[0] < 0.6 && got[1] > 100.0 && got[2] > 1.2 * got[1]);
    assert!(exact.iter().all(|f| *f == exact[0]));
}

#[test]
fn a_white_texture_is_none() {
    let white = || Texels::from_fn(5, 3, |_, _| [1.0; 3]);
    for name in TEXTURED {
        let mut plain = load(name);
        for m in &mut plain.materials {
            m.texture = None;
        }
        for method in Method::ALL.iter().copied() {
            let (want, _) = draw(&plain, method, Skips::all());
            for filter in FILTERS {
                let mut scene = load(name);
                retexture(&mut scene, &texture(white(), Mapping::Perspective, filter));
                let (got, _) = draw(&scene, method, Skips::all());
                let (max, rms) = difference(&want, &got);
                // Sums of products of the filters may turn a rounding; so may the fixed point that auto draws with when
                // there are no textures.
                let allowed = if method == Method::Auto { 0.15 } else { 0.02 };
                assert!(
                    max <= 1 && rms < allowed,
                    "{name} {method} {filter:?}: {max} {rms}"
                );
            }
        }
    }
}

#[test]
fn any_number_of_threads_draws_the_same_and_skips_the_same() {
    for name in TEXTURED {
        let p = Prepared::new(&load(name), Some((160, 120)), &Skips::all()).unwrap();
        for method in [Method::Exact, Method::Gouraud, Method::Quadratic] {
            let frames = [1, 2, 3].map(|threads| {
                let options = RenderOptions {
                    threads: Some(threads),
                    ..RenderOptions::default()
                };
                let (frame, stats) = render(&p, method, &options);
                (frame, stats.skipped)
            });
            assert!(
                frames[0] == frames[1] && frames[0] == frames[2],
                "{name} {method}"
            );
        }
    }
}

/// What texels differ by between neighbours, at most, in LSB: what half a texel can do to a bilinear texture.
fn steepest(t: &Texels) -> f64 {
    let mut worst = 0.0f64;
    for y in 0..t.height() {
        for x in 0..t.width() {
            let (a, b, c) = (t.at(x, y), t.at(x + 1, y), t.at(x, y + 1));
            for k in 0..3 {
                worst = worst.max((b[k] - a[k]).abs() + (c[k] - a[k]).abs());
            }
        }
    }
    255.0 * worst
}

/// Texels of hidden pixels are never missed; affine addresses and one reciprocal per span change a pixel by no more than
/// half and 1/256 of the step between texels, and the truth not at all.
#[test]
fn skips_keep_their_bounds() {
    let wave = |x: usize, k: usize| ((x * k) as f32 / 64.0 * std::f32::consts::TAU).sin() / 4.0;
    let picture = Texels::from_fn(64, 64, |x, y| {
        let v = 0.5 + wave(x, 1) + wave(y, 2);
        [v, 1.0 - v, 0.5 + wave(x, 2)]
    });
    let step = steepest(&picture);
    for name in TEXTURED {
        let mut scene = load(name);
        let smooth = texture(picture.clone(), Mapping::Perspective, Filter::Bilinear);
        retexture(&mut scene, &smooth);
        for method in [
            Method::Exact,
            Method::Flat,
            Method::Gouraud,
            Method::Quadratic,
        ] {
            let (all, with) = draw(&scene, method, Skips::all());
            for (skip, bound) in [
                ("texture", 0.0),
                ("affine", step / 2.0 + 1.0),
                ("constant-depth", step / 256.0 + 1.0),
                (
                    "texture,affine,constant-depth",
                    step / 2.0 + step / 256.0 + 1.0,
                ),
            ] {
                let (without, stats) = draw(&scene, method, Skips::without(skip).unwrap());
                let (max, _) = difference(&all, &without);
                let bound = if method == Method::Exact { 0.0 } else { bound };
                assert!(
                    f64::from(max) <= bound,
                    "{name} {method} {skip}: {max} of {bound}"
                );
                for one in skip.split(',') {
                    assert_eq!(stats.skipped.get(one), None, "counted although off");
                }
            }
            let approximates = method != Method::Exact;
            if name == "tiles" {
                assert_eq!(with.skipped.contains_key("affine"), approximates);
            }
            if name == "perspective-floor" {
                assert_eq!(with.skipped.contains_key("constant-depth"), approximates);
            }
        }
    }
}

/// Only textured pixels count: in this scene the ball has no texture and the floor lies partly behind it.
#[test]
fn texels_of_hidden_pixels_are_counted() {
    let mut scene = load("bump");
    let (_, ball_first) = draw(&scene, Method::Flat, Skips::all());
    let texels = ball_first.skipped["texture"];
    assert!(texels > 1000 && texels <= ball_first.skipped["hidden"]);
    // With the floor first, hardly a texel is hidden.
    scene.objects.reverse();
    let (frame, floor_first) = draw(&scene, Method::Flat, Skips::all());
    assert!(floor_first
        .skipped
        .get("texture")
        .is_none_or(|n| *n < texels / 10));
    assert_eq!(
        difference(&frame, &draw(&scene, Method::Flat, Skips::none()).0).0,
        0
    );
}

/// The errors of the cheap normalisations on the scene of bumps, against exact ones: what was measured, with some room.
#[test]
fn bumps_by_other_normalisations() {
    for (way, scale, max, rms) in [
        (Normalise::Exact, -0.06, 0.0, 0.0),
        (Normalise::Reflection, -0.06, 165.0, 8.5),
        (Normalise::Newton, -0.06, 240.0, 20.0),
        (Normalise::Reflection, -0.02, 55.0, 1.3),
        (Normalise::Newton, -0.02, 200.0, 5.0),
    ] {
        let mut scene = load("bump");
        let golf = &mut scene.materials[0];
        let old = *golf.bump.as_ref().unwrap().relief();
        let relief = Relief {
            normalise: way,
            scale,
            ..old
        };
        golf.bump = Some(Arc::new(BumpMap::new(
            &pattern::height("bumps").unwrap(),
            relief,
        )));
        let p = Prepared::new(&scene, Some((160, 120)), &Skips::all()).unwrap();
        let (mut worst, mut sum, mut count) = (0.0f64, 0.0, 0u32);
        for (index, t) in p
            .triangles
            .iter()
            .enumerate()
            .filter(|(_, t)| t.material == 0)
        {
            let set_up = Bumped.triangle(&p, index);
            let walk = shadegate_reference::raster::Walk::new(
                t.position,
                shadegate_reference::raster::Viewport {
                    width: 160,
                    height: 120,
                },
            );
            for s in walk.iter().flat_map(|w| w.spans(160).collect::<Vec<_>>()) {
                let mut run = Bumped.start(&p, &set_up, s);
                for x in s.start..s.end {
                    let (got, want) = (
                        run.colour().map(to_byte),
                        exact::value(&p, t, x, s.y).map(to_byte),
                    );
                    for c in 0..3 {
                        let d = f64::from(got[c].abs_diff(want[c]));
                        worst = worst.max(d);
                        sum += d * d;
                        count += 1;
                    }
                    run.step();
                }
            }
        }
        let root = (sum / f64::from(count)).sqrt();
        println!("{way:?}, height {scale}: at most {worst} LSB, RMS {root:.2}");
        assert!(
            count > 5000 && worst <= max && root <= rms,
            "{way:?} {worst} {root}"
        );
    }
}

/// A bump map changes what is drawn per pixel, keeps the silhouette, and leaves methods of vertices alone.
#[test]
fn bumps_are_drawn_per_pixel() {
    let bumpy = load("bump");
    let mut smooth = load("bump");
    for m in &mut smooth.materials {
        m.bump = None;
    }
    let compare = |m| {
        difference(
            &draw(&bumpy, m, Skips::all()).0,
            &draw(&smooth, m, Skips::all()).0,
        )
    };
    assert!(compare(Method::Exact).1 > 10.0);
    for m in [Method::Flat, Method::Gouraud, Method::Quadratic] {
        assert_eq!(compare(m), (0, 0.0));
    }
    // All ways of finding gradients draw the same ball, more or less.
    let frames = [
        Gradient::Nearest,
        Gradient::Linear,
        Gradient::CatmullRom,
        Gradient::BSpline,
    ]
    .map(|gradient| {
        let mut scene = load("bump");
        let golf = &mut scene.materials[0];
        let relief = Relief {
            gradient,
            ..*golf.bump.as_ref().unwrap().relief()
        };
        golf.bump = Some(Arc::new(BumpMap::new(
            &pattern::height("bumps").unwrap(),
            relief,
        )));
        draw(&scene, Method::Exact, Skips::all()).0
    });
    for f in &frames {
        let (max, rms) = difference(f, &frames[2]);
        println!("from Catmull-Rom: at most {max} LSB, RMS {rms:.2}");
        assert!(rms < 8.0);
    }
}

/// Files beside the scene: a mesh with coordinates and a picture in both uses.
#[test]
fn pictures_and_coordinates_from_files() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join(format!("files-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let mut picture = Frame::new(2, 2, [255, 255, 255]);
    picture.pixels = vec![[255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 255]];
    picture.save_png(&folder.join("four.png")).unwrap();
    std::fs::write(
        folder.join("square.obj"),
        "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n",
    )
    .unwrap();
    let text = "[image]\nwidth = 8\nheight = 8\n[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\nheight = 2\n\
                [[material]]\nname = \"m\"\nambient = 1\ndiffuse = 0\ntexture = \"four.png\"\nfilter = \"nearest\"\n\
                bump = \"four.png\"\nwrap = \"clamp\"\n[[object]]\nmesh = \"square.obj\"\n";
    let file = folder.join("s.toml");
    std::fs::write(&file, text).unwrap();
    let p = Prepared::new(&scene::load(&file).unwrap(), None, &Skips::all()).unwrap();
    let (frame, _) = render(&p, Method::Exact, &RenderOptions::default());
    for y in 0..8 {
        for x in 0..8 {
            assert_eq!(
                frame.pixels[y * 8 + x],
                picture.pixels[y / 4 * 2 + x / 4],
                "{x} {y}"
            );
        }
    }
    std::fs::remove_dir_all(&folder).unwrap();
}

/// `auto` keeps its promise with textures on: the error of the colour is multiplied by a texel, and addresses are true.
#[test]
fn auto_keeps_its_error() {
    for name in TEXTURED {
        let scene = load(name);
        let p = Prepared::new(&scene, Some((160, 120)), &Skips::all()).unwrap();
        let (truth, _) = render(&p, Method::Exact, &RenderOptions::default());
        for max_error in [0.5, 1.0, 4.0] {
            let options = RenderOptions {
                max_error,
                ..RenderOptions::default()
            };
            let (frame, stats) = render(&p, Method::Auto, &options);
            let (max, _) = difference(&truth, &frame);
            // Rounding turns an error of E into one of E + 1 at most.
            assert!(
                f64::from(max) <= max_error + 1.0,
                "{name} {max_error}: {max}"
            );
            assert!(!stats.skipped.contains_key("affine"));
        }
    }
}
