//! Mirrored triangles draw what their twins draw, and spans that leave the frame are cut at its borders.

mod support;

use rand::rngs::StdRng;
use rand::SeedableRng;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::{area2, Point, Viewport};
use support::{random_triangles, taken, Machine, Pixel, Polynomial, Triangle};

const SIZE: Viewport = Viewport {
    width: 64,
    height: 48,
};

/// No pixel centre lies on an edge, so the fill rule has nothing to decide.
fn no_ties(t: &Triangle) -> bool {
    let [a, b, c] = t.corners;
    (0..48).all(|y| {
        (-70..140).all(|x| {
            let p = Point {
                x: x * 256 + 128,
                y: y * 256 + 128,
            };
            [[a, b, p], [b, c, p], [c, a, p]]
                .iter()
                .all(|t| area2(*t) != 0)
        })
    })
}

/// f(width − 1 − x, y).
fn reflect(p: &Polynomial) -> Polynomial {
    let w = i64::from(SIZE.width) - 1;
    let [c, a, b, d, e, f] = p.0;
    Polynomial([c + a * w + d * w * w, -a - 2 * d * w, b + e * w, d, -e, f])
}

fn twin(t: &Triangle) -> Triangle {
    Triangle {
        corners: t.corners.map(|p| Point {
            x: SIZE.width as i32 * 256 - p.x,
            y: p.y,
        }),
        colour: t.colour.map(|c| reflect(&c)),
        depth: reflect(&t.depth),
    }
}

fn twins(order: Order, seed: u64) {
    let mut r = StdRng::seed_from_u64(seed);
    let mut m = Machine::new(order, SIZE.width, SIZE.height);
    let mut n = Machine::new(order, SIZE.width, SIZE.height);
    let triangles = random_triangles(&mut r, m.kind, SIZE, -20..84, -10..58, 200, |t| {
        no_ties(t) && !t.pixels(SIZE).is_empty()
    });
    let mut mirrored = 0;
    for t in &triangles {
        let other = twin(t);
        assert_ne!(t.raw_spans(SIZE).0, other.raw_spans(SIZE).0);
        mirrored += usize::from(t.raw_spans(SIZE).0);
        let one = taken(&m.draw(&[*t], |_| true), |_| true);
        let two = taken(&n.draw(&[other], |_| true), |_| true);
        let back: Vec<Pixel> = two
            .iter()
            .map(|p| Pixel {
                x: SIZE.width as u16 - 1 - p.x,
                ..*p
            })
            .collect();
        assert_eq!(one, back, "{order:?} {:?}", t.corners);
    }
    assert!((50..150).contains(&mirrored));
}

#[test]
fn a_mirrored_triangle_draws_what_its_twin_draws() {
    twins(Order::Quadratic, 21);
    twins(Order::Linear, 22);
}

/// Which borders spans of this stimulus cross: left, right, both; wholly to the left, wholly to the right.
fn crossings(triangles: &[Triangle], mirrored: bool) -> [usize; 5] {
    let width = SIZE.width as i32;
    let mut n = [0; 5];
    for t in triangles {
        let (m, spans) = t.raw_spans(SIZE);
        if m != mirrored {
            continue;
        }
        for (from, to) in spans.into_iter().filter(|s| s.0 < s.1) {
            let (from, to) = if m { (-to, -from) } else { (from, to) };
            let inside = from < width && to > 0;
            let cases = [
                inside && from < 0 && to <= width,
                inside && from >= 0 && to > width,
                inside && from < 0 && to > width,
                to <= 0,
                from >= width,
            ];
            for (count, case) in n.iter_mut().zip(cases) {
                *count += usize::from(case);
            }
        }
    }
    n
}

fn scissors(order: Order, seed: u64) {
    let mut r = StdRng::seed_from_u64(seed);
    let mut m = Machine::new(order, SIZE.width, SIZE.height);
    let triangles = random_triangles(&mut r, m.kind, SIZE, -150..214, -40..88, 300, |t| {
        t.raw_spans(SIZE)
            .1
            .iter()
            .all(|s| s.0.abs() < 2000 && s.1.abs() < 2000)
    });
    for mirrored in [false, true] {
        let n = crossings(&triangles, mirrored);
        assert!(n.iter().all(|c| *c > 100), "{n:?}");
    }
    let trace = m.draw(&triangles, |_| true);
    let want: Vec<_> = triangles
        .iter()
        .flat_map(|t| t.drawn(m.kind, SIZE))
        .collect();
    assert_eq!(taken(&trace, |_| true), want);
}

#[test]
fn spans_are_cut_at_the_borders() {
    scissors(Order::Quadratic, 31);
    scissors(Order::Linear, 32);
}

#[test]
fn spans_that_end_or_begin_exactly_at_a_border() {
    let mut m = Machine::new(Order::Linear, SIZE.width, SIZE.height);
    // Edges of squares cut in two, one column around each border.
    let mut depth = 1000;
    for left in [
        -65.0, -64.0, -63.0, -2.0, -1.0, 0.0, 1.0, 62.0, 63.0, 64.0, 65.0,
    ] {
        for right in [-1.0, 0.0, 1.0, 2.0, 63.0, 64.0, 65.0, 127.0, 128.0, 129.0] {
            if left < right {
                let corners = [(left, 10.0), (right, 10.0), (left, 20.0), (right, 20.0)];
                for three in [[0, 1, 2], [1, 2, 3], [0, 1, 3], [0, 2, 3]] {
                    depth += 50;
                    let t = Triangle::flat(three.map(|i: usize| corners[i]), depth);
                    let got = taken(&m.draw(&[t], |_| true), |_| true);
                    assert_eq!(got, t.drawn(m.kind, SIZE), "{left} {right} {three:?}");
                }
            }
        }
    }
}
