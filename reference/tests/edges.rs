//! Shared edges: of a million pairs and fans of triangles, every pixel inside belongs to exactly one.

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_reference::raster::{area2, covers, Point, Viewport, Walk};

const VIEWPORT: Viewport = Viewport {
    width: 12,
    height: 10,
};

/// Adds how often each pixel is walked.
fn draw(t: [Point; 3], count: &mut [u8; 120]) {
    let spans = Walk::new(t, VIEWPORT);
    for s in spans.iter().flat_map(|w| w.spans(VIEWPORT.width)) {
        for x in s.start..s.end {
            count[(s.y * 12 + x) as usize] += 1;
        }
    }
}

/// Coordinates of many sizes: on the grid of centres, sub-pixel, about the viewport, far out, huge and negative.
fn coordinate(rng: &mut StdRng, kind: u32) -> i32 {
    match kind {
        0 => rng.random_range(-2..26) * 128,
        1 => rng.random_range(900..1400),
        2 => rng.random_range(-800..4000),
        3 => rng.random_range(-60_000..60_000),
        _ => rng.random_range(-(1 << 28)..=1 << 28),
    }
}

fn point(rng: &mut StdRng, kind: u32) -> Point {
    Point {
        x: coordinate(rng, kind),
        y: coordinate(rng, kind),
    }
}

#[test]
fn two_triangles_at_an_edge_never_share_or_leave_a_pixel() {
    let mut rng = StdRng::seed_from_u64(1);
    let mut tested = 0;
    while tested < 1_000_000 {
        let kind = rng.random_range(0..5);
        let [a, b] = [0; 2].map(|_| point(&mut rng, kind));
        let mut c = point(&mut rng, kind);
        let d = point(&mut rng, kind);
        if rng.random_range(0..4) == 0 {
            // A sliver: c almost on the edge.
            c.x = ((i64::from(a.x) + i64::from(b.x)) / 2) as i32 + rng.random_range(-1..=1);
            c.y = ((i64::from(a.y) + i64::from(b.y)) / 2) as i32;
        }
        let (one, two) = (area2([a, b, c]), area2([a, b, d]));
        if one == 0 || two == 0 || (one > 0) == (two > 0) {
            continue;
        }
        let mut count = [0; 120];
        let order = |t: [Point; 3], k: u32| match k % 3 {
            0 => t,
            1 => [t[2], t[1], t[0]],
            _ => [t[1], t[2], t[0]],
        };
        draw(order([a, b, c], rng.random()), &mut count);
        draw(order([b, a, d], rng.random()), &mut count);
        assert!(
            count.iter().all(|n| *n <= 1),
            "twice: {a:?} {b:?} {c:?} {d:?}"
        );
        // The union as two other triangles, when it is a convex quadrilateral, owns the same pixels.
        if (area2([c, d, a]) > 0) != (area2([c, d, b]) > 0)
            && area2([c, d, a]) != 0
            && area2([c, d, b]) != 0
        {
            let mut other = [0; 120];
            draw([c, d, a], &mut other);
            draw([c, d, b], &mut other);
            assert_eq!(count, other, "{a:?} {b:?} {c:?} {d:?}");
        }
        tested += 1;
    }
}

#[test]
fn a_fan_around_a_point_covers_its_hull_once() {
    let mut rng = StdRng::seed_from_u64(2);
    for _ in 0..60_000 {
        // A square around the viewport, its border cut at random places, fanned out from a point inside.
        let (lo, hi) = (
            -rng.random_range(100..100_000),
            rng.random_range(4000..100_000),
        );
        let mut ring: Vec<Point> = Vec::new();
        let corners = [(lo, lo), (hi, lo), (hi, hi), (lo, hi)].map(|(x, y)| Point { x, y });
        for k in 0..4 {
            let (p, q) = (corners[k], corners[(k + 1) % 4]);
            let mut cuts: Vec<f64> = (0..rng.random_range(0..4))
                .map(|_| rng.random::<f64>())
                .collect();
            cuts.sort_by(f64::total_cmp);
            ring.push(p);
            for t in cuts {
                let mix = |a: i32, b: i32| a + (f64::from(b - a) * t) as i32;
                ring.push(Point {
                    x: mix(p.x, q.x),
                    y: mix(p.y, q.y),
                });
            }
        }
        ring.dedup();
        let centre = Point {
            x: if rng.random() {
                rng.random_range(0..24) * 128
            } else {
                rng.random_range(0..3000)
            },
            y: if rng.random() {
                rng.random_range(0..20) * 128
            } else {
                rng.random_range(0..2500)
            },
        };
        let mut count = [0; 120];
        for k in 0..ring.len() {
            draw([centre, ring[k], ring[(k + 1) % ring.len()]], &mut count);
        }
        assert!(count.iter().all(|n| *n == 1), "{centre:?} {ring:?}");
    }
}

#[test]
fn the_walk_agrees_with_the_rule_far_out() {
    let mut rng = StdRng::seed_from_u64(3);
    for _ in 0..60_000 {
        let kind = rng.random_range(0..5);
        let t = [0; 3].map(|_| point(&mut rng, kind));
        let mut count = [0; 120];
        draw(t, &mut count);
        let (x, y) = (rng.random_range(0..12), rng.random_range(0..10));
        assert_eq!(
            count[(y * 12 + x) as usize] == 1,
            covers(t, x, y),
            "{t:?} at {x} {y}"
        );
    }
}
