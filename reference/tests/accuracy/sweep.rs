//! No method exceeds its bound: spread 0 to 90 degrees, spans of 1 to 2048 pixels, exponents 1 to 500, light straight,
//! oblique and behind, matt, shiny and mixed materials.

use crate::draw::{methods, Ready};
use crate::oracle::Truth;
use crate::setting::{normals, shape, Place, Setting};
use crate::vector::{around, blend, dot, unit, weights, Vector};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use rayon::prelude::*;
use shadegate_reference::Method;

const SPREADS: [f64; 10] = [0.0, 0.01, 2.0, 5.0, 10.0, 20.0, 30.0, 45.0, 60.0, 90.0];
const SPANS: [f64; 6] = [1.0, 3.0, 12.0, 48.0, 400.0, 2047.0];
const EXPONENTS: [f64; 8] = [1.0, 1.5, 2.0, 5.0, 20.0, 50.0, 100.0, 500.0];
const MATERIALS: [(f64, f64); 3] = [(0.4, 0.5), (0.9, 0.0), (0.0, 0.9)];

#[derive(Clone, Copy, Debug)]
enum Light {
    Straight,
    Oblique,
    Behind,
}

/// L and H for vertex normals, with L·H > 0 so that there is a viewer for them.
fn light(rng: &mut StdRng, kind: Light, normal: [Vector; 3]) -> (Vector, Vector) {
    let mean = unit(blend([1.0; 3], normal));
    loop {
        let inside = unit(blend(weights(rng), normal));
        let (l, h) = match kind {
            Light::Straight => (around(rng, inside, 0.0..0.5), inside),
            Light::Oblique => (around(rng, mean, 1.0..1.57), around(rng, mean, 0.0..1.2)),
            Light::Behind => (around(rng, mean, 1.57..3.1), around(rng, mean, 0.3..2.2)),
        };
        if dot(l, h) > 0.02 {
            return (l, h);
        }
    }
}

/// A random triangle of a combination of the sweep, far or near.
pub fn setting(rng: &mut StdRng, combination: [usize; 5]) -> Setting {
    let [spread, span, exponent, kind, material] = combination;
    let width = SPANS[span];
    let height = (1000.0 / width).clamp(2.0, 40.0);
    let (size, position) = shape(rng, width, height);
    let normal = normals(rng, SPREADS[spread].to_radians(), span.is_multiple_of(3));
    let kind = [Light::Straight, Light::Oblique, Light::Behind][kind];
    let (light, half) = light(rng, kind, normal);
    let (diffuse, specular) = MATERIALS[material];
    Setting {
        size,
        position,
        inv_w: [1.0; 3],
        world: [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        normal,
        place: Place::Far { light, half },
        ambient: 0.1,
        diffuse,
        specular,
        shininess: EXPONENTS[exponent],
    }
}

pub fn combinations() -> Vec<[usize; 5]> {
    let mut out = Vec::new();
    for spread in 0..SPREADS.len() {
        for span in 0..SPANS.len() {
            for exponent in 0..EXPONENTS.len() {
                for kind in 0..3 {
                    out.push([spread, span, exponent, kind, out.len() % 3]);
                }
            }
        }
    }
    out
}

/// How near a method came to its bound.
#[derive(Clone, Debug)]
struct Worst {
    ratio: f64,
    error: f64,
    bound: f64,
    setting: Option<Setting>,
}

fn rounds() -> u64 {
    std::env::var("SHADEGATE_ROUNDS")
        .ok()
        .and_then(|v| v.parse().ok())
        .unwrap_or(1)
}

/// The worst of every method over settings.
fn sweep(settings: &[Setting], methods: &[Method]) -> Vec<Worst> {
    let none = || {
        vec![
            Worst {
                ratio: 0.0,
                error: 0.0,
                bound: 0.0,
                setting: None
            };
            methods.len()
        ]
    };
    settings
        .par_iter()
        .fold(none, |mut worst, s| {
            let Some(ready) = Ready::new(s.clone()) else {
                return worst;
            };
            let case = s.case();
            for (w, m) in worst.iter_mut().zip(methods) {
                let Some(bound) = m.bound(&case) else {
                    continue;
                };
                let error = ready.errors(*m, truth(*m)).max;
                // Exact to the oracle's own rounding.
                let ratio = error / (bound + 1e-9);
                if ratio > w.ratio {
                    *w = Worst {
                        ratio,
                        error,
                        bound,
                        setting: Some(s.clone()),
                    };
                }
            }
            worst
        })
        .reduce(none, |a, b| {
            a.into_iter()
                .zip(b)
                .map(|(a, b)| if a.ratio >= b.ratio { a } else { b })
                .collect()
        })
}

/// What a method is held against where light or viewer are near.
fn truth(m: Method) -> Truth {
    match m {
        Method::Exact | Method::Phong | Method::QuadraticDots | Method::QuadraticAdaptive => {
            Truth::Positions
        }
        _ => Truth::Blended,
    }
}

fn check(what: &str, settings: &[Setting], methods: &[Method]) {
    let worst = sweep(settings, methods);
    let mut wrong = Vec::new();
    println!("{what}: {} triangles", settings.len());
    for (w, m) in worst.iter().zip(methods) {
        let at = w.setting.as_ref().map(|s| (s.case(), s.size));
        println!(
            "{:20} {:5.3} of its bound ({:.4} of {:.4} LSB) {at:?}",
            m.name(),
            w.ratio,
            w.error,
            w.bound
        );
        if w.ratio > 1.0 {
            wrong.push(format!("{m}: {} > {}: {:?}", w.error, w.bound, w.setting));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn far_light_and_viewer() {
    let mut settings = Vec::new();
    for seed in 0..rounds() {
        let mut rng = StdRng::seed_from_u64(seed);
        for c in combinations() {
            settings.push(setting(&mut rng, c));
        }
    }
    check("far", &settings, &methods());
}

/// A triangle of a combination with a light and an eye near it.
pub fn near(rng: &mut StdRng, c: [usize; 5]) -> Setting {
    let mut s = setting(rng, c);
    let mut place = || {
        let d = around(rng, [0.0, 0.0, 1.0], 0.0..1.4);
        let reach: f64 = rng.random_range(0.0..3.0);
        d.map(|v| v * 1.2 * reach.exp())
    };
    s.place = Place::Near {
        light: place(),
        eye: place(),
    };
    // Turned so that the mean normal faces both more or less.
    s.normal = loop {
        let n = normals(rng, SPREADS[c[0]].to_radians(), c[1].is_multiple_of(3));
        if blend([1.0; 3], n)[2] > 0.2 {
            break n;
        }
    };
    s
}

#[test]
fn near_light_and_viewer() {
    let mut settings = Vec::new();
    for seed in 0..rounds() {
        let mut rng = StdRng::seed_from_u64(1000 + seed);
        for c in combinations().into_iter().step_by(3) {
            settings.push(near(&mut rng, c));
        }
    }
    check("near", &settings, &methods());
}

/// Methods that blend weighted vectors are right in perspective, too.
#[test]
fn in_perspective() {
    let mut settings = Vec::new();
    for seed in 0..rounds() {
        let mut rng = StdRng::seed_from_u64(2000 + seed);
        for c in combinations().into_iter().step_by(5) {
            let mut s = setting(&mut rng, c);
            s.inv_w = [0; 3].map(|_| rng.random_range(0.02..2.0));
            settings.push(s);
        }
    }
    check(
        "perspective",
        &settings,
        &[Method::Exact, Method::Duff, Method::Phong],
    );
}
