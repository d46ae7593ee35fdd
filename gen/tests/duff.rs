//! The Duff core against an oracle of its own in f64: normals are blended and normalised at pixel centres. Triangles as
//! large as a frame of 1024x1024, normals up to 80° apart, perspective weights, exponents up to the largest.

#[path = "common/hunt.rs"]
mod hunt;

use hunt::{hunt, Effort};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_gen::stimulus::{build, Lobe, Material, StimulusOptions, Triangle};
use shadegate_gen::vectors::Trace;
use shadegate_hdl::shade::device::{longest_run, Core};
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::{Point, Viewport};

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(v: Vector) -> Vector {
    let length = dot(v, v).sqrt();
    v.map(|c| c / length)
}

fn blend(w: [f64; 3], n: &[Vector; 3]) -> Vector {
    std::array::from_fn(|c| (0..3).map(|i| w[i] * n[i][c]).sum())
}

/// A triangle with weighted normals, a light and a half-way vector.
struct Case {
    triangle: Triangle,
    normals: [Vector; 3],
    light: Vector,
    half: Vector,
}

impl Case {
    fn new(r: &mut StdRng, size: (u32, u32), i: usize, greatest: f64) -> Self {
        let mut corner = |low: i32, high: i32| Point {
            x: r.random_range(low..=high) * size.0 as i32 / 4,
            y: r.random_range(low..=high) * size.1 as i32 / 4,
        };
        let position = match i % 2 {
            0 => [corner(-256, 0), corner(1024, 1280), corner(-256, 1280)],
            _ => [corner(0, 1024), corner(0, 1024), corner(0, 1024)],
        };
        let mut near = |spread: f64| {
            let mut part = || r.random_range(-spread..=spread);
            unit([part(), part(), 1.0])
        };
        // Up to 80° between two of them: |N|² of 0.5 and more.
        let spread = [0.05, 0.3, 0.6][i % 3];
        let normals = [near(spread), near(spread), near(spread)];
        let (light, half) = (near(0.8), near(0.3));
        let weight = [1.0, r.random_range(0.75..=1.0), r.random_range(0.75..=1.0)];
        let exponents = [1.0, 2.5, 20.0, 50.0, 100.0, 144.0, 300.0, 600.0];
        let fitting: Vec<f64> = exponents.into_iter().filter(|n| *n <= greatest).collect();
        let exponent = fitting[r.random_range(0..fitting.len())];
        Self::of(i, position, normals, weight, [light, half], exponent)
    }

    /// Unit normals with weights, of which the largest is 1.
    fn of(
        i: usize,
        position: [Point; 3],
        normals: [Vector; 3],
        weight: [f64; 3],
        [light, half]: [Vector; 2],
        shininess: f64,
    ) -> Self {
        let normals: [Vector; 3] = std::array::from_fn(|k| normals[k].map(|c| c * weight[k]));
        let h = 0.5;
        let at = [
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
            [h, h, 0.0],
            [h, 0.0, h],
            [0.0, h, h],
        ];
        let knots = at.map(|w| {
            let n = blend(w, &normals);
            [dot(n, light), dot(n, half), dot(n, n)]
        });
        let triangle = Triangle {
            position,
            depth: [(100 * i + 1) as f64; 3],
            knots: knots.to_vec(),
            material: Some(Material {
                ambient: [10.0, 20.5, 0.0],
                diffuse: [255.0, 200.0, 99.9],
                specular: [255.0, 128.0, 31.0],
                shininess,
                lobe: Lobe::Power,
                cone: None,
            }),
            covering: None,
            relief: None,
            label: format!("case {i}"),
        };
        Self {
            triangle,
            normals,
            light,
            half,
        }
    }

    /// The colour of a pixel, not rounded.
    fn oracle(&self, x: u16, y: u16) -> Vector {
        let p = self.triangle.position;
        let p = p.map(|p| (f64::from(p.x) / 256.0, f64::from(p.y) / 256.0));
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
        let n = unit(blend(w, &self.normals));
        let m = self.triangle.material.expect("has one");
        let light = dot(n, self.light).max(0.0);
        let power = dot(n, self.half).max(0.0).powf(m.shininess);
        std::array::from_fn(|i| {
            (m.ambient[i] + m.diffuse[i] * light + m.specular[i] * power).clamp(0.0, 255.0)
        })
    }
}

/// Each triangle's largest error beyond the rounding, the bound, and the number of pixels.
fn errors(size: (u32, u32), cases: &[Case], off: f64) -> (Vec<f64>, f64, usize) {
    let (width, height) = size;
    let core = Core::for_frame(Order::Duff, width, height).expect("in range");
    let view = Viewport { width, height };
    let mut triangles: Vec<Triangle> = cases.iter().map(|c| c.triangle.clone()).collect();
    for t in &mut triangles {
        t.knots.iter_mut().for_each(|k| k[2] -= off);
    }
    let stimulus = build(&core, &triangles, view, &StimulusOptions::default()).expect("in range");
    let trace = Trace::record(core, &stimulus, |_| true);
    let worst = hunt::errors(cases.len(), &trace.pixels, |p| {
        cases[p.triangle].oracle(p.x, p.y)
    });
    let bound = core.error_bound(longest_run(width, height).expect("in range"));
    (worst, bound, trace.pixels.len())
}

/// The largest error of all.
fn worst(size: (u32, u32), cases: &[Case], off: f64) -> (f64, f64, usize) {
    let (each, bound, pixels) = errors(size, cases, off);
    (each.into_iter().fold(0.0, f64::max), bound, pixels)
}

/// A triangle by genes: corners, normals, weights, light and half-way vector, exponent.
fn grown(genes: &[f64], size: (u32, u32), i: usize) -> Case {
    let corner = |k: usize| hunt::corner(&genes[2 * k..], 0.2, size);
    // A coordinate of a vector whose third is 1.
    let near = |k: usize, spread: f64| {
        let part = |g: f64| (2.0 * g - 1.0) * spread;
        unit([part(genes[k]), part(genes[k + 1]), 1.0])
    };
    let weight = |k: usize| 0.75 + 0.25 * genes[k];
    Case::of(
        i,
        [0, 1, 2].map(corner),
        [6, 8, 10].map(|k| near(k, 0.6)),
        [1.0, weight(12), weight(13)],
        [near(14, 0.8), near(16, 0.3)],
        1.0 + 143.0 * genes[18],
    )
}

#[test]
fn an_adversary_finds_no_pixel_beyond_the_bound() {
    for (size, generations, population) in [((1024, 1024), 4, 4), ((256, 192), 40, 12)] {
        let effort = Effort {
            genes: 19,
            generations,
            population,
        };
        let mut bound = 0.0;
        let found = hunt(effort, 65, |crowd| {
            let crowd = crowd.iter().enumerate();
            let cases: Vec<_> = crowd.map(|(i, g)| grown(g, size, i)).collect();
            let (each, of, _) = errors(size, &cases, 0.0);
            bound = of;
            each
        });
        println!(
            "{size:?}: {:.4}, random {:.4}, bound {bound:.4}",
            found.worst, found.random
        );
        assert!(found.worst <= bound, "{found:?}");
    }
}

#[test]
fn every_pixel_is_within_the_bound_on_large_triangles() {
    let mut r = StdRng::seed_from_u64(61);
    for (size, count) in [((1024, 1024), 4), ((256, 192), 60)] {
        let cases: Vec<_> = (0..count)
            .map(|i| Case::new(&mut r, size, i, 144.0))
            .collect();
        let (error, bound, pixels) = worst(size, &cases, 0.0);
        println!("{size:?}: {error} of {bound} beyond the rounding, {pixels} pixels");
        assert!(error <= bound && bound < 0.25, "{error} {bound}");
        assert!(pixels > 100_000, "{pixels}");
    }
}

#[test]
fn the_largest_exponent_stays_within_half_an_lsb() {
    let mut r = StdRng::seed_from_u64(62);
    let size = (256, 192);
    let mut cases: Vec<_> = (0..30).map(|i| Case::new(&mut r, size, i, 600.0)).collect();
    for c in &mut cases {
        if let Some(m) = &mut c.triangle.material {
            m.shininess = 600.0;
        }
    }
    let (error, ..) = worst(size, &cases, 0.0);
    assert!(error <= 0.5, "{error}");
}

/// A squared length off by 2^-10 is found.
#[test]
fn the_oracle_notices_a_small_error() {
    let mut r = StdRng::seed_from_u64(63);
    let size = (256, 192);
    let cases: Vec<_> = (0..4).map(|i| Case::new(&mut r, size, i, 144.0)).collect();
    let (error, bound, _) = worst(size, &cases, 1.0 / 1024.0);
    assert!(error > bound, "{error} {bound}");
}

#[test]
fn what_the_core_cannot_draw_is_refused_by_number() {
    let core = Core::for_frame(Order::Duff, 64, 64).expect("in range");
    let refused = |change: &dyn Fn(&mut Triangle)| {
        let mut t = Case::new(&mut StdRng::seed_from_u64(64), (64, 64), 0, 20.0).triangle;
        t.label = "object 1, face 2".to_owned();
        change(&mut t);
        let view = Viewport {
            width: 64,
            height: 64,
        };
        let error = build(&core, &[t], view, &StimulusOptions::default()).expect_err("bad");
        let text = error.to_string();
        let text = text.strip_prefix("triangle 0 (object 1, face 2): ");
        text.expect("which").to_owned()
    };
    assert_eq!(refused(&|t| t.material = None), "no material");
    assert_eq!(
        refused(&|t| t.knots[1][0] = 1.5),
        "N·L 1.5 at a knot is outside -1 to 1"
    );
    assert_eq!(
        refused(&|t| t.knots.iter_mut().for_each(|k| k[2] = 0.01)),
        "the squared length of the normal falls to 0.0100; the core takes 0.0156 at least"
    );
    assert_eq!(
        refused(&|t| {
            if let Some(m) = &mut t.material {
                m.shininess = 601.0;
            }
        }),
        "shininess 601 is outside 1 to 600"
    );
}
