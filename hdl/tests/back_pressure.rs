//! Whoever takes the pixels may take them when he likes: the sequence stays the same and a pixel waits unchanged.

mod support;

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_hdl::light::Glint;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::Viewport;
use support::{check_done, random_triangles, taken, Machine, Pixel, BUMPS, TEXTURED};

const SIZE: Viewport = Viewport {
    width: 64,
    height: 48,
};

fn patterns() -> Vec<(&'static str, Vec<bool>)> {
    let mut r = StdRng::seed_from_u64(7);
    let mut random = |n: u32| (0..997).map(|_| r.random_ratio(n, 10)).collect::<Vec<_>>();
    vec![
        ("rarely", random(1)),
        ("half", random(5)),
        ("mostly", random(9)),
        ("alternating", vec![true, false]),
        ("one in seven", (0..7).map(|i| i == 3).collect()),
        ("bursts", (0..200).map(|i| i % 50 < 20).collect()),
        ("late", (0..4000).map(|i| i > 3000).collect()),
    ]
}

fn any_pattern(order: Order, seed: u64) {
    let mut r = StdRng::seed_from_u64(seed);
    let core = || Machine::new(order, SIZE.width, SIZE.height);
    // Overlapping triangles, some hidden: the depth test is stalled too.
    let mut triangles = random_triangles(&mut r, core().kind, SIZE, -10..74, -10..58, 25, |t| {
        !t.pixels(SIZE).is_empty()
    });
    for i in (0..triangles.len()).step_by(2) {
        triangles.swap(i, (i * 7) % 25);
    }
    let free = core().draw(&triangles, |_| true);
    let want = taken(&free, |_| true);
    let all: usize = triangles.iter().map(|t| t.pixels(SIZE).len()).sum();
    assert!(
        !want.is_empty() && want.len() < all,
        "some pixels are hidden"
    );
    for (name, pattern) in patterns() {
        let ready = |t: usize| pattern[t % pattern.len()];
        let trace = core().draw(&triangles, ready);
        assert_eq!(taken(&trace, ready), want, "{order:?}, {name}");
        for (t, pair) in trace.windows(2).enumerate() {
            if pair[0].valid && !ready(t) {
                assert!(pair[1].valid, "{name}, clock {t}");
                assert_eq!(Pixel::offered(&pair[0]), Pixel::offered(&pair[1]), "{name}");
            }
        }
        check_done(&trace);
    }
}

#[test]
fn quadratic_core_under_any_pattern() {
    any_pattern(Order::Quadratic, 11);
}

#[test]
fn quadratic_dots_core_under_any_pattern() {
    any_pattern(Order::QuadraticDots, 13);
}

#[test]
fn duff_core_under_any_pattern() {
    any_pattern(Order::Duff, 14);
}

#[test]
fn textured_cores_under_any_pattern() {
    for (order, seed) in TEXTURED.into_iter().zip(15..) {
        any_pattern(order, seed);
    }
}

#[test]
fn cores_without_tables_under_any_pattern() {
    for (order, seed) in BUMPS.into_iter().zip(20..) {
        any_pattern(order, seed);
    }
    any_pattern(Order::Glint(Glint::Kappa), 18);
    any_pattern(Order::Glint(Glint::Spot), 19);
}

#[test]
fn gouraud_core_under_any_pattern() {
    any_pattern(Order::Linear, 12);
}
