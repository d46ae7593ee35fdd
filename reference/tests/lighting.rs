//! Lights and materials against the textbook: every reflection model, spot and fall-off worked out anew in plain numbers;
//! the hemisphere table against its bound; spots that are skipped.

mod common;

use common::{difference, draw, load, prepare};
use glam::DVec3;
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_reference::scene::{
    Attenuation, Brdf, Camera, Falloff, Highlight, Light, LightKind, Material, Projection,
    SpotWidth,
};
use shadegate_reference::shade::shader::{Run, Shader};
use shadegate_reference::shade::{exact, hemisphere, Surroundings};
use shadegate_reference::{render, Method, Prepared, RenderOptions, Skips};
use std::f64::consts::PI;

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn blend(a: Vector, p: f64, b: Vector, q: f64) -> Vector {
    [0, 1, 2].map(|i| p * a[i] + q * b[i])
}

fn unit(a: Vector) -> Vector {
    blend(a, 1.0 / dot(a, a).sqrt(), a, 0.0)
}

fn any(rng: &mut StdRng) -> Vector {
    loop {
        let v = std::array::from_fn(|_| rng.random_range(-1.0..1.0));
        if (0.01..1.0).contains(&dot(v, v)) {
            return unit(v);
        }
    }
}

/// The highlight functions as their authors write them, for cosines from 0 to 1; γ by a search of its own.
fn highlight(which: Highlight, n: f64, c: f64) -> f64 {
    let angle = c.acos();
    match which {
        Highlight::Pow => c.powf(n),
        Highlight::Schlick => c / (n - n * c + c),
        Highlight::Blake => {
            let (a, b) = (
                0.7531 / (n - 1.5 + 2.0 / n).sqrt(),
                2.9926 / (n + 0.94).sqrt(),
            );
            match angle {
                t if t <= a => 1.0 - t * t / (a * b),
                t if t < b => (t - b) * (t - b) / (b * (b - a)),
                _ => 0.0,
            }
        }
        Highlight::Cos2 | Highlight::Kappa { .. } => unreachable!("tested by their own files"),
    }
}

/// Cook and Torrance with every division as in the equation.
fn facets(f0: f64, m: f64, n: Vector, l: Vector, v: Vector, h: Vector) -> f64 {
    let (nl, nv, nh, vh) = (dot(n, l), dot(n, v), dot(n, h), dot(v, h));
    let tangent = nh.acos().tan();
    let d = (-(tangent / m).powi(2)).exp() / (PI * m * m * nh.powi(4));
    let g = f64::min(1.0, f64::min(2.0 * nh * nv / vh, 2.0 * nh * nl / vh));
    let f = f0 + (1.0 - f0) * (1.0 - vh).powi(5);
    PI * (d * f * g / (4.0 * nl * nv)) * nl
}

/// D from the angle beside the axis, the width by the definition of beam and field.
fn beside(falloff: Falloff, width: SpotWidth, angle: f64) -> f64 {
    let (full, level) = match width {
        SpotWidth::Beam(full) => (full, 0.5f64),
        SpotWidth::Field(full) => (full, 0.1f64),
    };
    let (c, e) = ((full / 2.0).to_radians().cos(), angle.cos());
    let g = match falloff {
        Falloff::Warn => return e.max(0.0).powf(level.ln() / c.ln()),
        Falloff::Soft => (c - level.sqrt()) / (1.0 - level.sqrt()),
        Falloff::Hard => 1.0 - (1.0 - c) / (1.0 - level).sqrt(),
    };
    match falloff {
        _ if e <= g => 0.0,
        Falloff::Soft => ((e - g) / (1.0 - g)).powi(2),
        _ => 1.0 - ((e - 1.0) / (g - 1.0)).powi(2),
    }
}

/// 60 000 random lights, viewers, materials and normals.
#[test]
fn shading_is_the_textbook_s() {
    let mut rng = StdRng::seed_from_u64(20);
    let mut lit = [0; 4];
    for _ in 0..60_000 {
        let position = blend(any(&mut rng), rng.random_range(0.1..5.0), [0.0; 3], 0.0);
        let eye = blend(any(&mut rng), rng.random_range(0.5..5.0), [0.0; 3], 0.0);
        let (point, normal) = (blend(any(&mut rng), 0.3, [0.0; 3], 0.0), any(&mut rng));
        let to = blend(position, 1.0, point, -1.0);
        let near = rng.random_bool(0.5);
        let axis = unit(blend(to, -1.0, any(&mut rng), rng.random_range(0.0..1.0)));
        let falloff = [Falloff::Warn, Falloff::Soft, Falloff::Hard][rng.random_range(0..3usize)];
        let angle = rng.random_range(5.0..170.0);
        let width = [SpotWidth::Beam(angle), SpotWidth::Field(angle)][rng.random_range(0..2usize)];
        let law: Vector = std::array::from_fn(|_| rng.random_range(0.0..0.8));
        let attenuation = Attenuation {
            constant: law[0],
            linear: law[1],
            quadratic: law[2],
        };
        let (kind, l, strength) = match rng.random_range(0..3) {
            0 => {
                let direction = DVec3::from_array(axis);
                let back = blend(axis, -1.0, axis, 0.0);
                (LightKind::Directional { direction }, back, 1.0)
            }
            k => {
                let distance = dot(to, to).sqrt();
                let factor = 1.0 / (law[0] + law[1] * distance + law[2] * distance * distance);
                let l = unit(to);
                let position = DVec3::from_array(position);
                if k == 1 {
                    let kind = LightKind::Point {
                        position,
                        attenuation,
                    };
                    (kind, l, factor.min(1.0))
                } else {
                    let kind = LightKind::Spot {
                        position,
                        direction: DVec3::from_array(axis),
                        falloff,
                        width,
                        attenuation,
                    };
                    let angle = (-dot(axis, l)).clamp(-1.0, 1.0).acos();
                    (kind, l, factor.min(1.0) * beside(falloff, width, angle))
                }
            }
        };
        let v = unit(if near {
            blend(eye, 1.0, point, -1.0)
        } else {
            eye
        });
        let camera = Camera {
            eye: DVec3::from_array(eye),
            target: DVec3::ZERO,
            up: DVec3::from_array(eye).any_orthonormal_vector(),
            projection: if near {
                Projection::Perspective { fov: 50.0 }
            } else {
                Projection::Orthographic { height: 2.0 }
            },
            near: 0.1,
            far: 10.0,
        };
        let model = rng.random_range(0..4usize);
        let roughness = rng.random_range(0.1..1.0);
        let material = Material {
            brdf: [
                Brdf::Lambert,
                Brdf::Phong,
                Brdf::Blinn,
                Brdf::CookTorrance { roughness },
            ][model],
            ambient: DVec3::splat(0.2),
            emission: DVec3::splat(0.05),
            shadow: rng.random_range(0.0..1.0),
            diffuse: DVec3::splat(0.6),
            specular: DVec3::splat(if model == 0 { 0.0 } else { 0.3 }),
            shininess: rng.random_range(3.0..200.0),
            highlight: [Highlight::Pow, Highlight::Blake, Highlight::Schlick]
                [rng.random_range(0..3usize)],
            ..Material::default()
        };
        let (facing, h) = (dot(normal, l), unit(blend(l, 1.0, v, 1.0)));
        let reflected = blend(normal, 2.0 * facing, l, -1.0);
        let shine = |c: f64| highlight(material.highlight, material.shininess, c.clamp(0.0, 1.0));
        let specular = match model {
            1 if facing > 0.0 => 0.3 * shine(dot(reflected, v)),
            2 => 0.3 * shine(dot(normal, h)),
            // Turned away from the viewer is no case of the equation.
            3 if dot(normal, v) <= 0.0 => continue,
            3 if facing > 0.0 => facets(0.3, roughness, normal, l, v, h),
            _ => 0.0,
        };
        let ambient = 0.05 + 0.2 * (1.0 + material.shadow * facing.min(0.0));
        let want = 255.0 * (ambient + 0.7 * strength * (0.6 * facing.max(0.0) + specular));
        let light = Light {
            kind,
            colour: DVec3::splat(0.7),
        };
        let s = Surroundings::of(vec![light], vec![material], &camera);
        let got = s.shade(0, DVec3::from_array(point), DVec3::from_array(normal));
        let near = (got - DVec3::splat(want)).abs().max_element();
        assert!(
            near < 1e-7 * want.max(1.0),
            "{got} instead of {want}: {s:?}"
        );
        lit[model] += usize::from(specular * strength > 0.01);
    }
    assert!(lit[1..].iter().all(|n| *n > 300), "{lit:?}");
}

/// Every pixel of triangles that face the viewer: the error is that of the direction, times the slope of the light, and
/// that of the table (a quarter of a step where the terminator passes).
#[test]
fn the_hemisphere_table_keeps_its_bound() {
    for name in ["sphere-168", "sphere-690"] {
        let mut scene = load(name);
        scene.materials[0].specular = DVec3::ZERO;
        let p = Prepared::new(&scene, None, &Skips::all()).unwrap();
        let view = p.surroundings().distant_view().unwrap();
        let shader = hemisphere::Hemisphere::new(&p);
        let slope = 255.0 * (scene.lights[0].colour * scene.materials[0].diffuse).max_element();
        let table = slope / hemisphere::SIZE as f64 / 2.0 + 0.02;
        let (mut pixels, mut worst) = (0, 0.0f64);
        for (i, t) in p.triangles.iter().enumerate() {
            let radius = t.normal.map(|n| {
                if n.dot(view) > 0.0 {
                    n.cross(view).length()
                } else {
                    2.0
                }
            });
            let radius = radius.into_iter().fold(0.0, f64::max);
            if radius > 0.87 {
                continue;
            }
            let [a, b, c] = t.normal;
            let spread = a.dot(b).min(b.dot(c)).min(c.dot(a)).min(1.0).acos();
            let bound = slope * hemisphere::direction_error(spread, radius) + table;
            let setup = shader.triangle(&p, i);
            let viewport = shadegate_reference::raster::Viewport {
                width: p.width,
                height: p.height,
            };
            let walk = shadegate_reference::raster::Walk::new(t.position, viewport);
            for span in walk.iter().flat_map(|w| w.spans(p.width)) {
                let mut run = shader.start(&p, &setup, span);
                for x in span.start..span.end {
                    let (got, want) = (run.colour(), exact::value(&p, t, x, span.y));
                    for c in 0..3 {
                        let error = (got[c] - want[c]).abs();
                        assert!(error <= bound, "{name} {i}: {error} above {bound}");
                        worst = worst.max(error / bound);
                    }
                    pixels += 1;
                    run.step();
                }
            }
        }
        println!("{name}: {pixels} pixels, {worst:.2} of the bound");
        assert!(pixels > 10_000 && worst > 0.3, "{name} {pixels} {worst}");
    }
}

/// Whole frames, silhouettes and all: what was measured and some room.
#[test]
fn hemisphere_frames_are_near_the_truth() {
    for (name, max, rms) in [("sphere-690", 24, 0.76), ("materials", 12, 0.55)] {
        let p = prepare(name, None);
        let got = difference(&draw(&p, Method::Hemisphere), &draw(&p, Method::Exact));
        println!("{name}: {got:?}");
        assert!(got.0 <= max && got.1 <= rms, "{name}: {got:?}");
    }
}

/// Spots that miss are counted, the count is what the bound says, and pixels do not know the difference (the frames of
/// all skips are compared in `frames.rs`).
#[test]
fn spots_that_miss_are_counted() {
    let scene = load("spot");
    let p = Prepared::new(&scene, None, &Skips::all()).unwrap();
    let all = 3 * p.triangles.len() as u64;
    let count = p.skipped["spot"];
    println!("{count} of {all} pairs of light and triangle skipped");
    assert!(count * 2 > all && count < all);
    let off = Skips::without("spot").unwrap();
    let q = Prepared::new(&scene, None, &off).unwrap();
    assert_eq!(q.skipped.get("spot"), None);
    let options = RenderOptions {
        skips: off,
        ..RenderOptions::default()
    };
    let (a, b) = (
        draw(&p, Method::Exact),
        render(&q, Method::Exact, &options).0,
    );
    assert!(a == b, "{:?}", difference(&a, &b));
    assert_eq!(prepare("teapot", None).skipped.get("spot"), None);
}

/// `auto` knows what its bounds are for: where other lights or materials are met it draws from the definition, and
/// where no cone reaches it need not.
#[test]
fn auto_keeps_its_error_under_any_light_and_material() {
    let mut soft_and_hard = load("spot");
    soft_and_hard.lights.remove(0);
    soft_and_hard.materials[1].shadow = 0.0;
    for (scene, plain) in [
        (load("spot"), false),
        (load("materials"), false),
        (soft_and_hard, true),
    ] {
        let p = Prepared::new(&scene, None, &Skips::all()).unwrap();
        let (frame, stats) = render(&p, Method::Auto, &RenderOptions::default());
        let (max, rms) = difference(&frame, &draw(&p, Method::Exact));
        let of = |n: &str| stats.skipped.get(n).copied().unwrap_or(0);
        let cheap = of("flat-enough") + of("linear-enough");
        println!("{}: {max} {rms:.3}, {cheap} triangles", scene.name);
        // An LSB of error may turn the rounding of both frames.
        assert!(max <= if plain { 2 } else { 0 }, "{}: {max}", scene.name);
        assert_eq!(cheap > 500, plain, "{}: {cheap}", scene.name);
    }
}
