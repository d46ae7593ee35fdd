//! The register words are right: walked by plain integers they give, at every covered pixel of any triangle, the
//! method's value to within the stated bound, even where registers wrap.

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_gen::setup::{fixed_knot, plane_words, quadric_words, Frame};
use shadegate_hdl::format::wrap;
use shadegate_reference::raster::{Point, Viewport, Walk};
use shadegate_reference::shade;

const VIEW: Viewport = Viewport {
    width: 320,
    height: 240,
};

/// Visits every covered pixel of the frame: (x, y, lines walked, carries, pixels walked).
fn visit(walk: &Walk, mut f: impl FnMut(i32, i32, u32, u32, u32)) {
    let mut major = walk.major;
    let mut minor = walk.minor[usize::from(walk.upper_rows == 0)];
    let mut carries = 0;
    for k in 0..walk.rows {
        for column in major.column..minor.column {
            let x = if walk.mirrored { !column } else { column };
            if (0..VIEW.width as i32).contains(&x) {
                f(
                    x,
                    walk.first_row + k as i32,
                    k,
                    carries,
                    (column - major.column) as u32,
                );
            }
        }
        carries += u32::from(major.carries());
        major.step();
        if k + 1 == walk.upper_rows {
            minor = walk.minor[1];
        } else {
            minor.step();
        }
    }
}

/// A quadric walked by its ten words (or a plane by four, padded with zeros), in a register of `width` bits.
fn walk_words(words: &[u64; 10], width: usize, walk: &Walk, lines: u32, pixels: u32) -> i64 {
    let mut w = words.map(|x| wrap(x as i64, width));
    let add = |a: i64, b: i64| wrap(a.wrapping_add(b), width);
    let mut edge = walk.major;
    for _ in 0..lines {
        let s = if edge.carries() {
            [3, 6, 8, 9]
        } else {
            [2, 5, 7, 8]
        };
        let old = w;
        for i in 0..4 {
            w[i] = add(old[i], old[s[i]]);
        }
        edge.step();
    }
    for _ in 0..pixels {
        w[0] = add(w[0], w[1]);
        w[1] = add(w[1], w[4]);
    }
    w[0]
}

fn triangle(r: &mut StdRng, i: usize) -> [Point; 3] {
    let reach = [300, 2_000, 20_000, 80_000][r.random_range(0..4)];
    let (cx, cy) = (r.random_range(0..320 * 256), r.random_range(0..240 * 256));
    let mut p: [Point; 3] = std::array::from_fn(|_| Point {
        x: (cx + r.random_range(-reach..=reach)).clamp(-160 * 256, 480 * 256),
        y: (cy + r.random_range(-reach..=reach)).clamp(-120 * 256, 360 * 256),
    });
    if i.is_multiple_of(3) {
        // A sliver: the third corner a few sub-pixels beside the middle of an edge.
        let mid = |a: i32, b: i32| (a + b) / 2;
        p[2] = Point {
            x: mid(p[0].x, p[1].x) + r.random_range(-3..=3),
            y: mid(p[0].y, p[1].y) + r.random_range(-3..=3),
        };
    }
    p
}

fn bound(words: f64, fraction: u32) -> f64 {
    // Half an ulp per word error, plus the rounding of the knots (Lebesgue constant 5/3) and of the f64 oracle.
    words / 2f64.powi(fraction as i32 + 1) + 2e-6
}

#[test]
fn every_covered_pixel_is_within_the_bound_for_fat_and_thin_triangles() {
    let mut r = StdRng::seed_from_u64(41);
    let (mut worst, mut slivers, mut checked) = (0f64, 0, 0u64);
    for i in 0..if cfg!(debug_assertions) { 200 } else { 4_000 } {
        let p = triangle(&mut r, i);
        let Some(walk) = Walk::new(p, VIEW) else {
            continue;
        };
        let knots: [[f64; 3]; 6] = std::array::from_fn(|_| {
            [
                r.random_range(0.0..=255.0),
                if r.random() { 1530.0 } else { 0.0 },
                128.0,
            ]
        });
        let frame = Frame::new(p, &walk);
        slivers += u32::from(frame.area.abs() < 65_536);
        let fixed = |c: usize| knots.map(|k| fixed_knot(k[c]).expect("in range"));
        let words = [0, 1].map(|c| quadric_words(&frame, fixed(c), 20, 32, 0));
        let flat: [[f64; 3]; 3] = [knots[0], knots[1], knots[2]];
        let corner = |c: usize| flat.map(|k| fixed_knot(k[c]).expect("in range"));
        let planes = [0, 1].map(|c| {
            let four = plane_words(&frame, corner(c), 12, 24, 0);
            std::array::from_fn(|i| four.get(i).copied().unwrap_or(0))
        });
        visit(&walk, |x, y, lines, carries, pixels| {
            if (x + 3 * y) % 7 != 0 && walk.rows > 20 {
                return;
            }
            let n = f64::from(lines + carries + pixels);
            let want = shade::quadratic::value(&p, &knots, x, y);
            let plane = shade::gouraud::value(&p, &flat, x, y);
            for c in 0..2 {
                let got =
                    walk_words(&words[c], 32, &walk, lines, pixels) as f64 / f64::from(1 << 20);
                let error = (got - want[c]).abs();
                assert!(
                    error <= bound(1.0 + n * (n + 1.0) / 2.0, 20),
                    "quadric, pixel {x} {y} of {p:?}: {got} {}",
                    want[c]
                );
                worst = worst.max(error);
                let got =
                    walk_words(&planes[c], 24, &walk, lines, pixels) as f64 / f64::from(1 << 12);
                let error = (got - plane[c]).abs();
                assert!(
                    error <= bound(1.0 + n, 12),
                    "plane, pixel {x} {y} of {p:?}: {got} {}",
                    plane[c]
                );
            }
            checked += 1;
        });
    }
    assert!(
        slivers > 10 && checked > 1_000,
        "{slivers} slivers, {checked} pixels"
    );
    println!("worst quadric error {worst:.6} LSB over {checked} pixels");
}

/// Negative control: without the carry, as the papers walk, samples lie beside the centre and the bound breaks.
#[test]
fn without_the_carry_the_bound_is_broken() {
    let p = [
        Point { x: 1000, y: 200 },
        Point {
            x: 40_000,
            y: 30_000,
        },
        Point {
            x: 9_000,
            y: 50_000,
        },
    ];
    let walk = Walk::new(p, VIEW).expect("covers pixels");
    let knots: [[f64; 3]; 6] = std::array::from_fn(|i| [40.0 * i as f64; 3]);
    let frame = Frame::new(p, &walk);
    let mut words = quadric_words(
        &frame,
        knots.map(|k| fixed_knot(k[0]).expect("in range")),
        20,
        32,
        0,
    );
    // The carrying step as if nothing had carried.
    (words[3], words[6], words[8], words[9]) = (words[2], words[5], words[7], words[8]);
    let mut worst = 0f64;
    visit(&walk, |x, y, lines, _, pixels| {
        let got = walk_words(&words, 32, &walk, lines, pixels) as f64 / f64::from(1 << 20);
        worst = worst.max((got - shade::quadratic::value(&p, &knots, x, y)[0]).abs());
    });
    assert!(worst > 5.0, "{worst}");
}
