//! Every method at every pixel against its definition, evaluated there from scratch: no differences, no recurrences, no
//! forms, other ways to the same numbers. Spans are up to 2047 pixels long, so drift would show.

use crate::draw::{colours, methods};
use crate::setting::{Place, Setting};
use crate::sweep::{combinations, near, setting};
use crate::vector::{add, angle, blend, cross, dot, rotate, scale, sub, unit, Vector};
use rand::rngs::StdRng;
use rand::SeedableRng;
use rayon::prelude::*;
use shadegate_reference::Method;

/// A place on the triangle: weights there, and where its row enters and leaves the triangle.
struct Spot {
    weights: [f64; 3],
    ends: [[f64; 3]; 2],
    /// 0 at the one, 1 at the other.
    t: f64,
}

fn spot(s: &Setting, x: i32, y: i32) -> Spot {
    let p = s.position.map(|p| <[f64; 2]>::from(p.pixels()));
    let at = |x: f64, y: f64| {
        let area = |a: [f64; 2], b: [f64; 2]| (a[0] - x) * (b[1] - y) - (a[1] - y) * (b[0] - x);
        let w = [area(p[1], p[2]), area(p[2], p[0]), area(p[0], p[1])];
        let sum = w[0] + w[1] + w[2];
        w.map(|v| v / sum)
    };
    let (x, y) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
    // The row cuts two of the edges.
    let mut cuts: Vec<f64> = Vec::new();
    for (i, j) in [(0, 1), (1, 2), (2, 0)] {
        let (a, b) = (p[i], p[j]);
        if (a[1] - y) * (b[1] - y) <= 0.0 && a[1] != b[1] {
            cuts.push(a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
        }
    }
    let left = cuts.iter().copied().fold(f64::INFINITY, f64::min);
    let right = cuts.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Spot {
        weights: at(x, y),
        ends: [at(left, y), at(right, y)],
        t: (x - left) / (right - left),
    }
}

fn slerp(a: Vector, b: Vector, t: f64) -> Vector {
    let axis = cross(a, b);
    if dot(axis, axis) < 1e-30 {
        return a;
    }
    rotate(a, unit(axis), t * angle(a, b))
}

/// The vector at weights on an edge, turned at a constant rate along it.
fn slerp_edge(v: [Vector; 3], w: [f64; 3]) -> Vector {
    let off = (0..3).min_by(|a, b| w[*a].abs().total_cmp(&w[*b].abs()));
    let (i, j) = [(1, 2), (0, 2), (0, 1)][off.unwrap_or(0)];
    slerp(v[i], v[j], w[j] / (w[i] + w[j]))
}

fn slerp_row(v: [Vector; 3], s: &Spot) -> Vector {
    slerp(slerp_edge(v, s.ends[0]), slerp_edge(v, s.ends[1]), s.t)
}

/// Six knots in Lagrange's form.
fn six(w: [f64; 3], corner: [f64; 3], middle: impl Fn(usize, usize) -> f64) -> f64 {
    let mut sum = 0.0;
    for i in 0..3 {
        sum += w[i] * (2.0 * w[i] - 1.0) * corner[i];
        for j in i + 1..3 {
            sum += 4.0 * w[i] * w[j] * middle(i, j);
        }
    }
    sum
}

/// The Taylor polynomial of N·V/|N| with a constant V, as printed in 5.12 with the corrected T₄, about `from`.
fn taylor(n: [Vector; 3], v: Vector, from: [f64; 3], w: [f64; 3]) -> f64 {
    let (x, y) = (w[1] - from[1], w[2] - from[2]);
    let (va, vb, vc) = (sub(n[1], n[0]), sub(n[2], n[0]), blend(from, n));
    let (a, b, c) = (dot(va, v), dot(vb, v), dot(vc, v));
    let (d, e, f) = (dot(va, va), 2.0 * dot(va, vb), dot(vb, vb));
    let (g, h, i) = (2.0 * dot(va, vc), 2.0 * dot(vb, vc), dot(vc, vc));
    let r = i.sqrt();
    let t0 = c / r;
    let t1 = (2.0 * b * i - c * h) / (2.0 * i * r);
    let t2 = (2.0 * a * i - c * g) / (2.0 * i * r);
    let t3 = (3.0 * c * h * h - 4.0 * c * f * i - 4.0 * b * h * i) / (8.0 * i * i * r);
    let t4 =
        (3.0 * c * g * h - 2.0 * c * e * i - 2.0 * b * g * i - 2.0 * a * h * i) / (4.0 * i * i * r);
    let t5 = (3.0 * c * g * g - 4.0 * c * d * i - 4.0 * a * g * i) / (8.0 * i * i * r);
    t0 + t1 * y + t2 * x + t3 * y * y + t4 * x * y + t5 * x * x
}

/// The cosine between N and V at a place; `None` where this file has no other way to it.
fn cosine(m: Method, s: &Setting, at: &Spot, v: [Vector; 3], diffuse: bool) -> Option<f64> {
    let (w, n) = (at.weights, s.normal);
    let (bn, bv) = (blend(w, n), blend(w, v));
    let dots = [0, 1, 2].map(|i| dot(n[i], v[i]));
    let linear = w[0] * dots[0] + w[1] * dots[1] + w[2] * dots[2];
    let far = matches!(s.place, Place::Far { .. });
    let direction = unit([0, 1, 2].map(|k| n[0][k] + n[1][k] + n[2][k]));
    let newton = |a: Vector, b: Vector| scale(add(a, b), (5.0 - dot(a, b)) / 8.0);
    Some(match m {
        Method::Normals => dot(bn, bv),
        Method::DotProduct => linear,
        Method::PolarAngle => {
            let angles = [0, 1, 2].map(|i| angle(n[i], v[i]));
            (w[0] * angles[0] + w[1] * angles[1] + w[2] * angles[2]).cos()
        }
        Method::Angular => dot(slerp_row(n, at), slerp_row(v, at)),
        Method::AngularSingle => {
            let q = [0, 1, 2].map(|i| {
                let axis = cross(n[i], direction);
                if dot(axis, axis) < 1e-30 {
                    v[i]
                } else {
                    rotate(v[i], unit(axis), angle(n[i], direction))
                }
            });
            dot(slerp_row(q, at), direction)
        }
        Method::Duff => dot(unit(bn), unit(bv)),
        Method::Hybrid if diffuse => linear,
        Method::Hybrid => dot(unit(bn), unit(bv)),
        Method::Reflection => {
            let between = add(direction, bn);
            let k = 2.0 * dot(between, direction) / dot(between, between);
            dot(sub(scale(between, k), direction), bv)
        }
        Method::Newton => dot(scale(bn, (3.0 - dot(bn, bn)) / 2.0), bv),
        Method::XShading => six(w, dots, |i, j| dot(newton(n[i], n[j]), newton(v[i], v[j]))),
        Method::XShadingCached => six(w, dots, |i, j| {
            dot(unit(add(n[i], n[j])), unit(add(v[i], v[j])))
        }),
        Method::Taylor if far => taylor(n, v[0], [1.0 / 3.0; 3], w),
        Method::TaylorVertex if far => taylor(n, v[0], [1.0, 0.0, 0.0], w),
        Method::Euler => {
            let ends = |v: [Vector; 3]| at.ends.map(|e| unit(blend(e, v)));
            let ([a, b], [p, q]) = (ends(n), ends(v));
            // The parabola through both ends and the middle.
            let (from, to, middle) = (dot(a, p), dot(b, q), dot(newton(a, b), newton(p, q)));
            let t = at.t;
            from * (1.0 - t) * (1.0 - 2.0 * t)
                + 4.0 * middle * t * (1.0 - t)
                + to * t * (2.0 * t - 1.0)
        }
        _ => return None,
    })
}

fn colour(s: &Setting, nl: f64, nh: f64) -> f64 {
    let highlight = if nh > 0.0 {
        nh.min(1.0).powf(s.shininess)
    } else {
        0.0
    };
    255.0 * (s.ambient + s.diffuse * nl.clamp(0.0, 1.0) + s.specular * highlight)
}

/// The full model at weights, with L and H from the position.
fn shaded(s: &Setting, w: [f64; 3]) -> f64 {
    let n = unit(blend(w, s.normal));
    let (l, h) = match s.place {
        Place::Far { light, half } => (light, half),
        Place::Near { light, eye } => {
            let x = blend(w, s.world);
            let l = unit(sub(light, x));
            (l, unit(add(l, unit(sub(eye, x)))))
        }
    };
    colour(s, dot(n, l), dot(n, h))
}

/// Division into four, by descent from the corners of the part that holds the place.
fn pseudo_phong(s: &Setting, w: [f64; 3]) -> f64 {
    let v = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let m = |i: usize, j: usize| scale(add(v[i], v[j]), 0.5);
    let (a, b, c) = (m(0, 1), m(1, 2), m(2, 0));
    let parts = [[v[0], a, c], [v[1], b, a], [v[2], c, b], [a, b, c]];
    // Weights within a part by Cramer's rule on barycentric triples; the best part is the one that holds it.
    let det = |p: Vector, q: Vector, r: Vector| dot(p, cross(q, r));
    let within = |[p, q, r]: [Vector; 3]| {
        let all = det(p, q, r);
        [det(w, q, r) / all, det(p, w, r) / all, det(p, q, w) / all]
    };
    let least = |u: [f64; 3]| u[0].min(u[1]).min(u[2]);
    let best = parts
        .into_iter()
        .max_by(|a, b| least(within(*a)).total_cmp(&least(within(*b))));
    best.map_or(f64::NAN, |part| {
        let u = within(part);
        (0..3).map(|i| u[i] * shaded(s, part[i])).sum()
    })
}

/// The colour of a method at a pixel by its definition.
fn definition(m: Method, s: &Setting, x: i32, y: i32) -> Option<f64> {
    let at = spot(s, x, y);
    match m {
        Method::PseudoPhong => return Some(pseudo_phong(s, at.weights)),
        Method::Phong => return Some(shaded(s, at.weights)),
        _ => {}
    }
    let vertex = [0, 1, 2].map(|i| s.incidence(i));
    let nl = cosine(m, s, &at, vertex.map(|v| v.0), true)?;
    let nh = cosine(m, s, &at, vertex.map(|v| v.1), false)?;
    Some(colour(s, nl, nh))
}

#[test]
fn every_pixel_is_what_the_definition_says() {
    let mut rng = StdRng::seed_from_u64(77);
    let mut settings = Vec::new();
    for c in combinations().into_iter().step_by(7) {
        settings.push(setting(&mut rng, c));
        settings.push(near(&mut rng, c));
    }
    let checked: Vec<usize> = settings
        .par_iter()
        .map(|s| {
            let p = s.prepare();
            let mut checked = 0;
            for m in methods() {
                // Rounding of a cosine counts n times in a power; of single precision, much more.
                let allowed = match m {
                    Method::Phong => 1e-3 + 1e-3 * s.shininess,
                    _ => 1e-8 * (1.0 + s.shininess),
                };
                for (x, y, got) in colours(&p, m).into_iter().step_by(3) {
                    let Some(want) = definition(m, s, x, y) else {
                        break;
                    };
                    assert!(
                        (got - want).abs() < allowed,
                        "{m} ({x}, {y}): {got} instead of {want}: {s:?}"
                    );
                    checked += 1;
                }
            }
            checked
        })
        .collect();
    let checked: usize = checked.iter().sum();
    println!("{checked} pixels");
    assert!(checked > 100_000);
}

/// Methods that are one and the same function are the same to rounding.
#[test]
fn normals_and_dot_products_are_one_under_a_far_light() {
    let mut rng = StdRng::seed_from_u64(78);
    for c in combinations().into_iter().step_by(11) {
        let p = setting(&mut rng, c).prepare();
        let pairs = colours(&p, Method::Normals)
            .into_iter()
            .zip(colours(&p, Method::DotProduct));
        for (a, b) in pairs {
            assert!((a.2 - b.2).abs() < 1e-9, "{a:?} {b:?}");
        }
    }
}
