//! Inputs that have no direction, no area or no limit: every method gives a finite colour in the range of its light.

use crate::draw::{colours, methods};
use crate::setting::{Place, Setting};
use crate::vector::{scale, unit, Vector};
use shadegate_reference::raster::Point;
use shadegate_reference::shade::corners::Corners;
use shadegate_reference::Method;

const X: Vector = [1.0, 0.0, 0.0];
const Y: Vector = [0.0, 1.0, 0.0];
const Z: Vector = [0.0, 0.0, 1.0];

/// 40 by 40 pixels, facing +z.
fn plain(normal: [Vector; 3], place: Place) -> Setting {
    let at = |x: i32, y: i32| Point {
        x: x * 256,
        y: y * 256,
    };
    Setting {
        size: (44, 44),
        position: [at(1, 41), at(41, 33), at(9, 1)],
        inv_w: [1.0; 3],
        world: [[0.0; 3], X, Y],
        normal,
        place,
        ambient: 0.1,
        diffuse: 0.4,
        specular: 0.5,
        shininess: 20.0,
    }
}

fn far() -> Place {
    Place::Far {
        light: unit([0.3, 0.2, 0.9]),
        half: unit([0.1, 0.1, 1.0]),
    }
}

/// Every method is finite on a setting, at every pixel, and no brighter or darker than its light allows: six knots may
/// leave the range of the knots by a third.
fn survives(what: &str, s: &Setting) {
    let full = 255.0 * (s.diffuse + s.specular);
    let (least, most) = (
        255.0 * s.ambient - full / 3.0,
        255.0 * s.ambient + full * 4.0 / 3.0,
    );
    let p = s.prepare();
    for m in methods() {
        let all = colours(&p, m);
        assert!(!all.is_empty());
        for (x, y, c) in all {
            assert!(
                c >= least - 1e-6 && c <= most + 1e-6,
                "{what}: {m} ({x}, {y}): {c}"
            );
        }
    }
}

#[test]
fn normals_that_are_missing_equal_or_opposite() {
    let tilted = unit([0.6, 0.0, 0.8]);
    let cases: [(&str, [Vector; 3]); 8] = [
        ("no normal at a vertex", [[0.0; 3], Z, tilted]),
        ("no normals", [[0.0; 3]; 3]),
        ("one normal", [tilted; 3]),
        ("two equal", [Z, Z, tilted]),
        ("two opposite", [X, scale(X, -1.0), Z]),
        ("opposite to the sum of all", [Z, Z, scale(Z, -1.0)]),
        (
            "nothing at the centroid",
            [
                X,
                [-0.5, 0.75f64.sqrt(), 0.0],
                [-0.5, -(0.75f64.sqrt()), 0.0],
            ],
        ),
        ("on one great circle", [Z, tilted, unit([0.8, 0.0, 0.6])]),
    ];
    for (what, normal) in cases {
        survives(what, &plain(normal, far()));
        let near = Place::Near {
            light: [0.3, 0.3, 2.0],
            eye: [0.0, 0.0, 3.0],
        };
        survives(what, &plain(normal, near));
    }
}

#[test]
fn lights_in_a_vertex_against_the_eye_along_or_across_the_normals() {
    let n = [Z, unit([0.2, 0.0, 1.0]), unit([0.0, 0.3, 1.0])];
    let near = |light: Vector, eye: Vector| Place::Near { light, eye };
    survives(
        "light in a vertex",
        &plain(n, near([0.0; 3], [0.0, 0.0, 3.0])),
    );
    survives("eye in a vertex", &plain(n, near([0.0, 0.0, 3.0], X)));
    survives("both in a vertex", &plain(n, near(Y, Y)));
    survives(
        "light against the eye",
        &plain(n, near([0.0, 0.0, -2.0], [0.0, 0.0, 2.0])),
    );
    for (what, light, half) in [
        ("light along a normal", Z, Z),
        (
            "light across all",
            unit([0.0, 1.0, 1e-9]),
            unit([0.0, 1.0, 1.0]),
        ),
        (
            "light behind",
            unit([0.1, 0.2, -0.9]),
            unit([0.9, 0.0, -0.1]),
        ),
    ] {
        survives(what, &plain([Z; 3], Place::Far { light, half }));
        survives(what, &plain(n, Place::Far { light, half }));
    }
}

#[test]
fn exponents_without_limit() {
    let n = [Z, unit([0.2, 0.0, 1.0]), unit([0.0, 0.3, 1.0])];
    for shininess in [0.0, 1e-3, 0.5, 1.0, 10_000.0] {
        let s = Setting {
            shininess,
            ..plain(n, far())
        };
        survives("exponent", &s);
    }
}

#[test]
fn slivers_and_perspective_without_limit() {
    let n = [Z, unit([0.9, 0.0, 1.0]), unit([0.0, 0.9, 1.0])];
    let slivers = [
        [(0, 300), (10_000, 301), (5_000, 10)],
        [(129, 0), (127, 9_000), (128, 4_000)],
        [(0, 128), (10_900, 129), (5_000, 126)],
    ];
    for p in slivers {
        let mut s = plain(n, far());
        s.position = p.map(|(x, y)| Point { x, y });
        // Either way round; some cover nothing.
        if !colours(&s.prepare(), Method::Flat).is_empty() {
            survives("sliver", &s);
        }
    }
    let mut s = plain(n, far());
    s.inv_w = [1e-9, 1.0, 1e6];
    survives("perspective", &s);
}

/// Where L = −V there is no half-way vector, so no highlight, and methods get a zero vector to blend.
#[test]
fn opposite_light_and_eye_have_no_half_way_vector() {
    let s = plain(
        [Z; 3],
        Place::Near {
            light: [0.0, 0.0, -2.0],
            eye: [0.0, 0.0, 2.0],
        },
    );
    let p = s.prepare();
    let corners = Corners::new(&p, 0);
    let [at, beside, _] = corners.terms[0].half;
    assert_eq!(at, glam::DVec3::ZERO);
    assert!((beside.length() - 1.0).abs() < 1e-12);
    survives("no half-way vector", &s);
}
