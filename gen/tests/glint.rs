//! The quadratic-dots cores without tables against an oracle of their own in f64: highlights κ(N·H − γ)^d and spots from six
//! knots, at pixel centres, by barycentric weights and the six basis functions. Frames of 1024x1024 pixels with triangles
//! as large as they come, random cosines and cosines chosen to be hard: crests, and edges of lobes and cones.

#[path = "common/hunt.rs"]
mod hunt;

use hunt::{hunt, Effort};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_gen::stimulus::{build, Cone, Lobe, Material, Stimulus, StimulusOptions, Triangle};
use shadegate_gen::vectors::Trace;
use shadegate_hdl::light::Glint;
use shadegate_hdl::shade::device::{longest_run, Core};
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::{Point, Viewport};

/// The colour of a pixel, not rounded.
fn oracle(glint: Glint, t: &Triangle, x: u16, y: u16) -> [f64; 3] {
    let p = t
        .position
        .map(|p| (f64::from(p.x) / 256.0, f64::from(p.y) / 256.0));
    let c = (f64::from(x) + 0.5, f64::from(y) + 0.5);
    let cross = |a: (f64, f64), b: (f64, f64), o: (f64, f64)| {
        (a.0 - o.0) * (b.1 - o.1) - (a.1 - o.1) * (b.0 - o.0)
    };
    let area = cross(p[1], p[2], p[0]);
    let w = [
        cross(p[1], p[2], c) / area,
        cross(p[2], p[0], c) / area,
        cross(p[0], p[1], c) / area,
    ];
    let basis = [
        w[0] * (2.0 * w[0] - 1.0),
        w[1] * (2.0 * w[1] - 1.0),
        w[2] * (2.0 * w[2] - 1.0),
        4.0 * w[0] * w[1],
        4.0 * w[0] * w[2],
        4.0 * w[1] * w[2],
    ];
    let cosine = |k: usize| -> f64 { (0..6).map(|i| basis[i] * t.knots[i][k]).sum() };
    let m = t.material.expect("has one");
    let light = cosine(0).clamp(0.0, 1.0);
    let Lobe::Kappa { degree, gamma } = m.lobe else {
        panic!("has none")
    };
    // Hast 2004, 3.276, with κ as printed.
    let e = cosine(1).min(1.0);
    let d = i32::from(degree);
    let kappa = 1.0 / (1.0 - gamma).powi(d);
    let highlight = if e > gamma {
        kappa * (e - gamma).powi(d)
    } else {
        0.0
    };
    let spot = match (glint, m.cone) {
        (Glint::Spot, Some(cone)) => {
            let (e, g) = (cosine(2).min(1.0), 1.0 - cone.width);
            match (e > g, cone.hard) {
                (false, _) => 0.0,
                // 3.273 and 3.274.
                (_, false) => (e - g) * (e - g) / ((1.0 - g) * (1.0 - g)),
                (_, true) => 1.0 - (e - 1.0) * (e - 1.0) / ((g - 1.0) * (g - 1.0)),
            }
        }
        _ => 1.0,
    };
    std::array::from_fn(|i| {
        let lit = m.diffuse[i] * light + m.specular[i] * highlight;
        (m.ambient[i] + spot * lit).clamp(0.0, 255.0)
    })
}

fn material(r: &mut StdRng) -> Material {
    let mut colour = |most: f64| std::array::from_fn(|_| r.random_range(0.0..=most));
    let [ambient, diffuse] = [colour(80.0), colour(255.0)];
    Material {
        ambient,
        diffuse,
        specular: [255.0, 128.0, 31.0],
        shininess: 20.0,
        lobe: Lobe::Kappa {
            degree: r.random_range(2..=4),
            gamma: [0.0, 0.5, 0.8125, 0.95, 127.0 / 128.0][r.random_range(0..5)],
        },
        cone: Some(Cone {
            hard: r.random(),
            width: [2.5, 1.0, 0.3, 0.05, 1.0 / 128.0][r.random_range(0..5)],
        }),
    }
}

const AT: [(f64, f64); 6] = [
    (0.0, 0.0),
    (1.0, 0.0),
    (0.0, 1.0),
    (0.5, 0.0),
    (0.0, 0.5),
    (0.5, 0.5),
];

/// Knots of N·L, N·H and the cosine from the axis. `kind` 0: anything, even beyond ±1; else crests within the triangle, about
/// as wide as their lobes and cones.
fn knots(r: &mut StdRng, kind: usize, m: &Material) -> Vec<[f64; 3]> {
    let mut crest = |width: f64| {
        let (cx, cy) = (r.random_range(-0.2..0.9), r.random_range(-0.2..0.9));
        let wide = width * r.random_range(0.5..4.0);
        AT.map(|(u, v)| {
            let far: f64 = (u - cx) * (u - cx) + (v - cy) * (v - cy);
            (1.0 - wide * far).max(-1.0)
        })
    };
    let Lobe::Kappa { gamma, .. } = m.lobe else {
        panic!("has none")
    };
    let (lobe, cone) = (crest(1.0 - gamma), crest(m.cone.expect("has one").width));
    (0..6)
        .map(|i| match kind {
            0 => [0; 3].map(|_| r.random_range(-1.5..1.5)),
            _ => [AT[i].0 - AT[i].1 + 0.1, lobe[i], cone[i]],
        })
        .collect()
}

fn triangle(r: &mut StdRng, size: (u32, u32), i: usize) -> Triangle {
    let mut corner = |low: i32, high: i32| Point {
        x: r.random_range(low..=high) * size.0 as i32 / 4,
        y: r.random_range(low..=high) * size.1 as i32 / 4,
    };
    // Corners in quarters of 1/256 of the frame, up to a quarter beside it.
    let position = match i % 3 {
        0 => [corner(-256, 0), corner(1024, 1280), corner(-256, 1280)],
        _ => [corner(0, 1024), corner(0, 1024), corner(0, 1024)],
    };
    let m = material(r);
    Triangle {
        position,
        depth: [(100 * i + 1) as f64; 3],
        knots: knots(r, i % 4, &m),
        material: Some(m),
        covering: None,
        relief: None,
        label: format!("case {i}"),
    }
}

fn core(glint: Glint, size: (u32, u32)) -> Core {
    Core::for_frame(Order::Glint(glint), size.0, size.1).expect("in range")
}

fn sent(glint: Glint, size: (u32, u32), triangles: &[Triangle], skip: bool) -> Stimulus {
    let options = StimulusOptions {
        skip_unchanged: skip,
        broadcast: true,
        ..Default::default()
    };
    let (width, height) = size;
    let view = Viewport { width, height };
    build(&core(glint, size), triangles, view, &options).expect("in range")
}

/// Largest errors beyond half an LSB of what the sent triangles give, against those that are meant, and the pixels.
fn errors(
    glint: Glint,
    size: (u32, u32),
    sent_ones: &[Triangle],
    meant: &[Triangle],
) -> (Vec<f64>, usize) {
    let stimulus = sent(glint, size, sent_ones, true);
    let trace = Trace::record(core(glint, size), &stimulus, |_| true);
    let worst = hunt::errors(meant.len(), &trace.pixels, |p| {
        oracle(glint, &meant[p.triangle], p.x, p.y)
    });
    (worst, trace.pixels.len())
}

/// The largest of all.
fn worst(
    glint: Glint,
    size: (u32, u32),
    sent_ones: &[Triangle],
    meant: &[Triangle],
) -> (f64, usize) {
    let (each, pixels) = errors(glint, size, sent_ones, meant);
    (each.into_iter().fold(0.0, f64::max), pixels)
}

fn bound(glint: Glint, size: (u32, u32)) -> f64 {
    core(glint, size).error_bound(longest_run(size.0, size.1).expect("in range"))
}

#[test]
fn every_pixel_is_within_the_bound_on_large_triangles() {
    for (seed, glint) in [(71, Glint::Kappa), (72, Glint::Spot)] {
        let mut r = StdRng::seed_from_u64(seed);
        let mut all = (0.0f64, 0);
        for (size, count) in [((1024, 1024), 5), ((256, 192), 50)] {
            let triangles: Vec<_> = (0..count).map(|i| triangle(&mut r, size, i)).collect();
            let (error, pixels) = worst(glint, size, &triangles, &triangles);
            let bound = bound(glint, size);
            assert!(error <= bound && bound < 0.25, "{glint:?}: {error} {bound}");
            all = (all.0.max(error), all.1 + pixels);
        }
        println!(
            "{glint:?}: {} LSB beyond the rounding, {} pixels",
            all.0, all.1
        );
        assert!(all.1 > 700_000, "{} pixels", all.1);
    }
}

/// A triangle by genes: corners, crests or ramps of the cosines, lobe, cone, colours.
fn grown(genes: &[f64], size: (u32, u32), i: usize) -> Triangle {
    let corner = |k: usize| hunt::corner(&genes[2 * k..], 0.2, size);
    let (degree, gamma) = (2 + (2.99 * genes[6]) as u8, 127.0 / 128.0 * genes[7]);
    let width = 1.0 / 128.0 + 2.4 * genes[8] * genes[8];
    let crest = |k: usize, width: f64, at: usize| {
        let (cx, cy, wide) = (genes[k], genes[k + 1], 8.0 * width * genes[k + 2]);
        let (u, v) = (AT[at].0 - cx, AT[at].1 - cy);
        (1.0 - wide * (u * u + v * v)).max(-1.0)
    };
    let knot = |at: usize| {
        let light = 1.5 * genes[15 + at] - 0.3;
        [light, crest(9, 1.0 - gamma, at), crest(12, width, at)]
    };
    Triangle {
        position: [0, 1, 2].map(corner),
        depth: [(100 * i + 1) as f64; 3],
        knots: (0..6).map(knot).collect(),
        material: Some(Material {
            ambient: [0.25, 0.5, 0.75],
            diffuse: [255.0, 128.0, 31.0].map(|c| c * genes[21]),
            specular: [31.0, 255.0, 128.0].map(|c| c * genes[22]),
            shininess: 20.0,
            lobe: Lobe::Kappa { degree, gamma },
            cone: Some(Cone {
                hard: genes[23] > 0.5,
                width,
            }),
        }),
        covering: None,
        relief: None,
        label: format!("grown {i}"),
    }
}

#[test]
fn an_adversary_finds_no_pixel_beyond_the_bound() {
    for glint in [Glint::Kappa, Glint::Spot] {
        for (size, generations, population) in [((1024, 1024), 3, 3), ((256, 192), 40, 12)] {
            let effort = Effort {
                genes: 24,
                generations,
                population,
            };
            let found = hunt(effort, 73, |crowd| {
                let crowd = crowd.iter().enumerate();
                let triangles: Vec<_> = crowd.map(|(i, g)| grown(g, size, i)).collect();
                errors(glint, size, &triangles, &triangles).0
            });
            let bound = bound(glint, size);
            println!(
                "{glint:?} {size:?}: {:.4}, random {:.4}, bound {bound:.4}",
                found.worst, found.random
            );
            assert!(found.worst <= bound, "{glint:?}: {found:?}");
        }
    }
}

/// A cosine that is off by 2^-11 of its width, or another degree, is found.
#[test]
fn the_oracle_notices_a_small_error() {
    let (size, glint) = ((256, 192), Glint::Spot);
    let mut r = StdRng::seed_from_u64(73);
    let mut t = triangle(&mut r, size, 1);
    t.position = [(0, 0), (250, 10), (20, 190)].map(|(x, y)| Point {
        x: x * 256,
        y: y * 256,
    });
    let m = Material {
        diffuse: [0.0; 3],
        specular: [255.0; 3],
        lobe: Lobe::Kappa {
            degree: 4,
            gamma: 0.9,
        },
        cone: Some(Cone {
            hard: false,
            width: 0.2,
        }),
        ..material(&mut r)
    };
    t.material = Some(m);
    t.knots = (0..6)
        .map(|i| [0.5, 1.0 - 0.05 * AT[i].0, 1.0 - 0.1 * AT[i].1])
        .collect();
    let error = |change: &dyn Fn(&mut Triangle)| {
        let mut sent = t.clone();
        change(&mut sent);
        worst(glint, size, &[sent], std::slice::from_ref(&t)).0
    };
    let bound = bound(glint, size);
    assert!(error(&|_| ()) <= bound);
    for which in [1, 2] {
        let off = error(&|t| t.knots.iter_mut().for_each(|k| k[which] += 1e-4));
        assert!(off > bound, "{which}: {off} {bound}");
    }
    let other = error(&|t| {
        t.material = Some(Material {
            lobe: Lobe::Kappa {
                degree: 3,
                gamma: 0.9,
            },
            ..m
        });
    });
    assert!(other > 10.0, "{other}");
}

/// What a triangle does without is left out, and nothing of it shows.
#[test]
fn words_of_dark_triangles_are_left_out_and_the_frame_stays() {
    let size = (256, 192);
    for glint in Glint::ALL {
        let mut r = StdRng::seed_from_u64(74);
        let mut triangles: Vec<_> = (0..40).map(|i| triangle(&mut r, size, i)).collect();
        // Some without a highlight, some turned away, some outside of the cone.
        for (i, t) in triangles.iter_mut().enumerate() {
            for k in &mut t.knots {
                match i % 4 {
                    0 => k[1] = -0.5 - 0.1 * k[1].abs().min(1.0),
                    1 => k[0] = -0.3 - 0.1 * k[0].abs().min(1.0),
                    2 => k[2] = -1.0 - 0.5 * k[2].abs().min(0.1),
                    _ => {}
                }
            }
            t.material.as_mut().expect("has one").cone = Some(Cone {
                hard: i % 8 < 4,
                width: 0.5,
            });
        }
        let [short, long] = [true, false].map(|skip| sent(glint, size, &triangles, skip));
        let frames = [&short, &long].map(|s| {
            let trace = Trace::record(core(glint, size), s, |_| true);
            let pixels = trace.pixels.iter().map(|p| (p.x, p.y, p.rgb, p.depth));
            pixels.collect::<Vec<_>>()
        });
        assert_eq!(frames[0], frames[1], "{glint:?}");
        assert!(frames[0].len() > 50_000, "{}", frames[0].len());
        let least = if glint == Glint::Spot { 350 } else { 150 };
        assert!(
            short.skipped_dark >= least,
            "{glint:?}: {}",
            short.skipped_dark
        );
        assert_eq!(long.skipped_dark, 0);
    }
}

#[test]
fn what_the_cores_cannot_draw_is_refused_by_number() {
    let size = (64, 64);
    let refused = |glint: Glint, change: &dyn Fn(&mut Triangle, &mut Material)| {
        let mut t = triangle(&mut StdRng::seed_from_u64(75), size, 0);
        let mut m = t.material.expect("has one");
        change(&mut t, &mut m);
        t.material = Some(m);
        t.label = "object 1, face 2".to_owned();
        let view = Viewport {
            width: 64,
            height: 64,
        };
        let error = build(&core(glint, size), &[t], view, &StimulusOptions::default());
        let text = error.expect_err("bad").to_string();
        text.strip_prefix("triangle 0 (object 1, face 2): ")
            .expect("which")
            .to_owned()
    };
    let lobe =
        |degree, gamma| refused(Glint::Kappa, &|_, m| m.lobe = Lobe::Kappa { degree, gamma });
    assert_eq!(lobe(5, 0.9), "degree 5 of a highlight is outside 2 to 4");
    assert_eq!(
        lobe(2, 0.999),
        "a highlight that ends at the cosine 0.999 is outside 0 to 127/128"
    );
    assert_eq!(
        lobe(2, f64::NAN),
        "a highlight that ends at the cosine NaN is outside 0 to 127/128"
    );
    assert_eq!(
        refused(Glint::Kappa, &|_, m| m.lobe = Lobe::Power),
        "a highlight that is no shifted low power"
    );
    assert_eq!(refused(Glint::Spot, &|_, m| m.cone = None), "no cone");
    let narrow = |_: &mut Triangle, m: &mut Material| {
        m.cone = Some(Cone {
            hard: true,
            width: 0.001,
        });
    };
    assert_eq!(
        refused(Glint::Spot, &narrow),
        "a cone with 1 - g = 0.001 is narrower than 1/128"
    );
    assert_eq!(
        refused(Glint::Spot, &|t, _| t.knots[3][2] = 2.5),
        "the cosine from the axis 2.5 at a knot is outside -2 to 2"
    );
    assert_eq!(
        refused(Glint::Kappa, &|t, _| t.knots.truncate(5)),
        "5 knots where the core takes 6"
    );
}
