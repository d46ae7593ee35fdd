//! Errors on one equilateral triangle of normals, as measured in the study of Hast's thesis: the greatest over lights,
//! diffuse alone and highlights of three exponents alone, at full scale.

use crate::draw::Ready;
use crate::oracle::Truth;
use crate::setting::{face, Place, Setting};
use crate::vector::{blend, unit, Vector};
use rayon::prelude::*;
use shadegate_reference::raster::Point;
use shadegate_reference::Method;

const EXPONENTS: [f64; 3] = [20.0, 75.0, 200.0];

/// Angle, then the errors as printed: diffuse, n = 20, 75, 200.
const X_SHADING: [(f64, [f64; 4]); 7] = [
    (5.0, [0.00, 0.02, 0.04, 0.06]),
    (10.0, [0.03, 0.20, 0.71, 1.8]),
    (20.0, [0.27, 2.9, 9.5, 21.0]),
    (30.0, [0.99, 15.0, 52.0, 115.0]),
    (41.4, [3.0, 50.0, 142.0, 221.0]),
    (45.0, [3.9, 67.0, 172.0, 239.0]),
    (60.0, [12.0, 156.0, 245.0, 250.0]),
];

const CACHED: [(f64, [f64; 4]); 7] = [
    (5.0, [0.00, 0.01, 0.03, 0.04]),
    (10.0, [0.03, 0.11, 0.21, 0.48]),
    (20.0, [0.25, 1.1, 2.8, 6.0]),
    (30.0, [0.81, 4.3, 15.0, 38.0]),
    (41.4, [2.3, 15.0, 52.0, 113.0]),
    (45.0, [2.9, 21.0, 70.0, 142.0]),
    (60.0, [7.0, 65.0, 168.0, 235.0]),
];

const REFLECTION: [(f64, [f64; 4]); 5] = [
    (10.0, [0.02, 0.07, 0.13, 0.22]),
    (20.0, [0.19, 0.56, 1.1, 1.7]),
    (30.0, [0.67, 1.9, 3.7, 6.0]),
    (45.0, [2.4, 6.8, 13.0, 21.0]),
    (60.0, [6.2, 17.0, 33.0, 53.0]),
];

const NEWTON: [(f64, [f64; 4]); 3] = [
    (10.0, [0.01, 0.19, 0.73, 1.9]),
    (20.0, [0.16, 3.1, 11.0, 28.0]),
    (45.0, [3.9, 66.0, 169.0, 238.0]),
];

/// Unit vectors pairwise `degrees` apart.
fn equilateral(degrees: f64) -> [Vector; 3] {
    // On a cone about z: 1 − cos = 3/2·sin² of its half angle.
    let sin = ((1.0 - degrees.to_radians().cos()) * 2.0 / 3.0).sqrt();
    [0.0, 1.0, 2.0].map(|k| {
        let (s, c) = (k * std::f64::consts::TAU / 3.0).sin_cos();
        [sin * c, sin * s, (1.0 - sin * sin).sqrt()]
    })
}

/// The greatest error over lights within and around the triangle.
fn worst(m: Method, degrees: f64, exponent: Option<f64>) -> f64 {
    let normal = equilateral(degrees);
    let at = |x: i32, y: i32| Point { x, y };
    let mut lights = Vec::new();
    if exponent.is_some() {
        // Highlights within the triangle and beside it.
        for i in -3..=9 {
            for j in -3..=9 {
                let (a, b) = (f64::from(i) / 6.0, f64::from(j) / 6.0);
                lights.push(unit(blend([1.0 - a - b, a, b], normal)));
            }
        }
    } else {
        for i in 0..=8 {
            for j in 0..36 {
                let (s, c) = (f64::from(i) * 10f64.to_radians()).sin_cos();
                let (sin, cos) = (f64::from(j) * 10f64.to_radians()).sin_cos();
                lights.push([s * cos, s * sin, c]);
            }
        }
    }
    lights
        .into_par_iter()
        .filter_map(|light| {
            Ready::new(Setting {
                size: (32, 32),
                position: [at(300, 7_500), at(7_600, 7_550), at(3_900, 1_200)],
                inv_w: [1.0; 3],
                world: face([0.0, 0.0, 1.0]),
                normal,
                place: Place::Far { light, half: light },
                ambient: 0.0,
                diffuse: f64::from(u8::from(exponent.is_none())),
                specular: f64::from(u8::from(exponent.is_some())),
                shininess: exponent.unwrap_or(1.0),
            })
        })
        .map(|r| r.errors(m, Truth::Blended).max)
        .reduce(|| 0.0, f64::max)
}

fn check(m: Method, rows: &[(f64, [f64; 4])]) {
    for (degrees, want) in rows {
        let got = [
            None,
            Some(EXPONENTS[0]),
            Some(EXPONENTS[1]),
            Some(EXPONENTS[2]),
        ]
        .map(|n| worst(m, *degrees, n));
        println!("{m} {degrees}: {got:.2?} printed {want:?}");
        // The study took fewer lights, so it missed peaks of narrow highlights: at 20° and n = 200 it has 21 for X-shading
        // where Newton's step, the same vector at the centroid, has 28. Ours may be that much greater.
        let narrow = *degrees == 20.0;
        for (g, w) in got.iter().zip(want) {
            assert!(*g >= 0.9 * w - 0.02, "{m} {degrees}: {g} {w}");
            let factor = if narrow { 1.45 } else { 1.1 };
            assert!(*g <= factor * w + 0.07, "{m} {degrees}: {g} {w}");
        }
    }
}

#[test]
fn x_shading() {
    check(Method::XShading, &X_SHADING);
}

#[test]
fn x_shading_with_cached_factors() {
    check(Method::XShadingCached, &CACHED);
}

#[test]
fn reflection() {
    check(Method::Reflection, &REFLECTION);
}

#[test]
fn newton() {
    check(Method::Newton, &NEWTON);
}
