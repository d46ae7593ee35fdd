//! The bounds that `auto` relies on, against the truth: random triangles under random lights, eyes and exponents, the
//! interpolated colours evaluated from their definitions in real numbers.

use fearless_simd::Level;
use glam::DVec3;
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_reference::raster::Point;
use shadegate_reference::scene::{
    Attenuation, Brdf, Camera, Light, LightKind, Material, Projection,
};
use shadegate_reference::shade::bound::sampled::{noise, sample};
use shadegate_reference::shade::bound::Tables;
use shadegate_reference::shade::paint::{Dots, Phong};
use shadegate_reference::shade::{gouraud, quadratic, Surroundings};
use shadegate_reference::{Prepared, ScreenTriangle};

fn direction(r: &mut StdRng) -> DVec3 {
    loop {
        let mut c = || r.random_range(-1.0..1.0);
        let v = DVec3::new(c(), c(), c());
        if (0.01..1.0).contains(&v.length_squared()) {
            return v.normalize();
        }
    }
}

/// A triangle with a frame of its own: normals within `spread` of a common direction.
fn random(r: &mut StdRng) -> Prepared {
    let near = r.random_bool(0.5);
    let light = |r: &mut StdRng| Light {
        kind: if near && r.random_bool(0.5) {
            LightKind::Point {
                position: direction(r) * r.random_range(1.5..8.0),
                attenuation: Attenuation::NONE,
            }
        } else {
            LightKind::Directional {
                direction: direction(r),
            }
        },
        colour: DVec3::splat(r.random_range(0.2..1.0)),
    };
    let count = r.random_range(1..3);
    let lights = (0..count).map(|_| light(r)).collect();
    let exponents = [3.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0];
    let material = Material {
        name: "m".into(),
        brdf: Brdf::Blinn,
        ambient: DVec3::splat(0.05),
        diffuse: DVec3::splat(r.random_range(0.0..0.6)),
        specular: DVec3::splat(r.random_range(0.0..0.6)),
        shininess: exponents[r.random_range(0..exponents.len())],
        ..Material::default()
    };
    let eye = DVec3::new(0.0, 0.0, r.random_range(3.0..12.0));
    let camera = Camera {
        eye,
        target: DVec3::ZERO,
        up: DVec3::Y,
        projection: if near {
            Projection::Perspective { fov: 40.0 }
        } else {
            Projection::Orthographic { height: 2.0 }
        },
        near: 0.1,
        far: 100.0,
    };
    let spread: f64 = 10f64.powf(r.random_range(-2.0..-0.1));
    let middle = direction(r);
    let size = 10f64.powf(r.random_range(-1.5..0.2));
    let world = [0; 3].map(|_| direction(r) * size);
    let triangle = ScreenTriangle {
        position: [(0, 0), (0, 64), (64, 0)].map(|(x, y)| Point {
            x: x * 256,
            y: y * 256,
        }),
        inv_w: if near {
            world.map(|w| 1.0 / (eye.z - w.z))
        } else {
            [1.0; 3]
        },
        depth: [0.5; 3],
        world,
        normal: [0; 3].map(|_| (middle + direction(r) * spread).normalize()),
        uv: [glam::DVec2::ZERO; 3],
        material: 0,
        object: 0,
        face: 0,
    };
    let surroundings = Surroundings::of(lights, vec![material], &camera);
    Prepared::from_triangles((64, 64), [0; 3], vec![triangle], surroundings)
}

fn truth(p: &Prepared, l: [f64; 3]) -> f64 {
    let t = &p.triangles[0];
    let q = [0, 1, 2].map(|i| l[i] * t.inv_w[i]);
    let sum: f64 = q.iter().sum();
    let blend = |v: &[DVec3; 3]| (v[0] * q[0] + v[1] * q[1] + v[2] * q[2]) / sum;
    let normal = blend(&t.normal).normalize();
    p.surroundings().shade(0, blend(&t.world), normal).x
}

fn basis([a, b, c]: [f64; 3]) -> [f64; 6] {
    [
        a * (2.0 * a - 1.0),
        b * (2.0 * b - 1.0),
        c * (2.0 * c - 1.0),
        4.0 * a * b,
        4.0 * a * c,
        4.0 * b * c,
    ]
}

/// Colours of the three ways to interpolate.
fn interpolated(
    p: &Prepared,
    d: &Dots,
    three: &[[f64; 3]; 3],
    six: &[[f64; 3]; 6],
    l: [f64; 3],
) -> [f64; 3] {
    let b = basis(l);
    let linear = (0..3).map(|i| l[i] * three[i][0]).sum();
    let quadratic = (0..6).map(|k| b[k] * six[k][0]).sum();
    let product = |k: &[f64; 6]| (0..6).map(|i| b[i] * k[i]).sum::<f64>().clamp(0.0, 1.0);
    let n = p.surroundings().material(0).shininess;
    let dots = d.terms.iter().fold(d.ambient.x, |sum, t| {
        sum + t.diffuse.x * product(&t.light) + t.specular.x * product(&t.half).powf(n)
    });
    [linear, quadratic, dots]
}

#[test]
fn no_error_exceeds_its_bound() {
    let count: usize = std::env::var("SHADEGATE_TRIANGLES")
        .ok()
        .and_then(|n| n.parse().ok())
        .unwrap_or(20_000);
    let mut r = StdRng::seed_from_u64(7);
    let mut promised = 0;
    const NAMES: [&str; 5] = [
        "linear",
        "quadratic",
        "products",
        "linear where known at points",
        "quadratic where known at points",
    ];
    let (mut closest, mut typical) = ([0.0f64; 5], [const { Vec::new() }; 5]);
    for k in 0..count {
        let p = random(&mut r);
        let bounds = Tables::new(&p).bounds(&p, &p.triangles[0]);
        if !bounds.linear.is_finite() {
            continue;
        }
        promised += 1;
        let t = &p.triangles[0];
        let (three, six) = (gouraud::knots(&p, t), quadratic::knots(&p, t));
        let dots = Dots::new(&p, &p.triangles[0], Dots::normals(&p.triangles[0])).unwrap();
        let mut worst = [0.0f64; 3];
        for i in 0..=14 {
            for j in 0..=14 - i {
                let l = [
                    f64::from(i) / 14.0,
                    f64::from(j) / 14.0,
                    f64::from(14 - i - j) / 14.0,
                ];
                let exact = truth(&p, l);
                let got = interpolated(&p, &dots, &three, &six, l);
                for m in 0..3 {
                    worst[m] = worst[m].max((got[m] - exact).abs());
                }
            }
        }
        let phong = Phong::new(&p, t).unwrap();
        let (known, noise) = (sample(Level::new(), &phong), noise(&phong));
        assert_eq!(
            known,
            sample(Level::baseline(), &phong),
            "the same bits for all registers"
        );
        let limits = [
            bounds.linear,
            bounds.quadratic,
            bounds.dots,
            known.linear + bounds.linear_between + noise,
            known.quadratic * 4.0 / 3.0 + bounds.quadratic_between + noise,
        ];
        for (m, name) in NAMES.iter().enumerate() {
            let (worst, limit) = (worst[m % 3], limits[m]);
            assert!(
                worst <= limit + 1e-6,
                "triangle {k}: {name} is off by {worst} LSB, bound {limit}: {t:?} {:?}",
                p.surroundings(),
            );
            if limit < 4.0 && worst > 0.01 {
                closest[m] = closest[m].max(worst / limit);
                typical[m].push(worst / limit);
            }
        }
    }
    println!("{promised} of {count} triangles have bounds");
    for (m, name) in NAMES.iter().enumerate() {
        typical[m].sort_by(f64::total_cmp);
        let median = typical[m][typical[m].len() / 2];
        println!(
            "{name}: error / bound at most {:.2}, median {median:.2} of {}",
            closest[m],
            typical[m].len()
        );
        // A bound that is never approached would promise too little.
        assert!(closest[m] > 0.1, "{name} {closest:?}");
    }
    assert!(promised * 2 > count);
}
