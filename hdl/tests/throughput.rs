//! One pixel per clock: no bubble inside a triangle, none between triangles whose words come in time, at most one clock
//! for a row without pixels. Colours and depths are checked on the way.

mod support;

use rand::rngs::StdRng;
use rand::SeedableRng;
use shadegate_hdl::light::Glint;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::lanes::Lane;
use shadegate_hdl::shade::model::{CoreInputs, CoreOutputs, Order};
use shadegate_hdl::shade::span_core::SpanKind;
use shadegate_reference::raster::Viewport;
use support::{check_done, random_triangles, taken, Machine, Triangle, BUMPS, TEXTURED};

const SIZE: Viewport = Viewport {
    width: 64,
    height: 48,
};

fn valid_range(trace: &[CoreOutputs]) -> std::ops::RangeInclusive<usize> {
    let first = trace.iter().position(|o| o.valid).unwrap();
    let last = trace.iter().rposition(|o| o.valid).unwrap();
    first..=last
}

fn row_lengths(t: &Triangle) -> Vec<i32> {
    t.raw_spans(SIZE).1.iter().map(|s| s.1 - s.0).collect()
}

fn no_bubbles(order: Order, seed: u64) {
    let mut r = StdRng::seed_from_u64(seed);
    let mut m = Machine::new(order, SIZE.width, SIZE.height);
    // The words of the next triangle take as long as this one's pixels, and three clocks pass until it is loaded.
    let words = Triangle::flat([(0.0, 0.0), (9.0, 0.0), (0.0, 9.0)], 1)
        .writes(order, SIZE)
        .len();
    let triangles = random_triangles(&mut r, m.kind, SIZE, 0..64, 0..48, 200, |t| {
        t.pixels(SIZE).len() >= words + 4 && row_lengths(t).iter().all(|n| *n > 0)
    });
    let lengths: Vec<i32> = triangles.iter().flat_map(row_lengths).collect();
    assert!(lengths.iter().filter(|n| **n == 1).count() > 50);
    let trace = m.draw(&triangles, |_| true);
    let bubbles = trace[valid_range(&trace)]
        .iter()
        .filter(|o| !o.valid)
        .count();
    assert_eq!(bubbles, 0, "{order:?}");
    let want: Vec<_> = triangles
        .iter()
        .flat_map(|t| t.drawn(m.kind, SIZE))
        .collect();
    assert_eq!(taken(&trace, |_| true), want);
    assert_eq!(check_done(&trace), 1);
}

#[test]
fn no_bubbles_in_or_between_triangles() {
    no_bubbles(Order::Quadratic, 1);
    no_bubbles(Order::Linear, 2);
    no_bubbles(Order::QuadraticDots, 5);
    no_bubbles(Order::Duff, 6);
    for (mapping, seed) in TEXTURED.into_iter().zip(7..) {
        no_bubbles(mapping, seed);
    }
    for (order, seed) in BUMPS.into_iter().zip(12..) {
        no_bubbles(order, seed);
    }
    no_bubbles(Order::Glint(Glint::Kappa), 10);
    no_bubbles(Order::Glint(Glint::Spot), 11);
}

#[test]
fn spans_of_one_pixel_on_a_carrying_edge() {
    // One pixel wide, leaning by a third of a pixel per row: every row is one pixel, every third row carries.
    let mut m = Machine::new(Order::Linear, SIZE.width, SIZE.height);
    let strip = [(2.0, -60.0), (3.0, -60.0), (40.0, 51.0)];
    for (flip, sign) in [(false, 1.0), (true, -1.0)] {
        let shift = if flip { 64.0 } else { 0.0 };
        let t = Triangle::flat(
            strip.map(|(x, y)| (shift + sign * x, y)),
            9000 + u16::from(flip),
        );
        let (mirrored, spans) = t.raw_spans(SIZE);
        let moves: Vec<i32> = spans.windows(2).map(|w| w[1].0 - w[0].0).collect();
        assert!(moves.iter().any(|d| *d == moves[0]) && moves.iter().any(|d| *d != moves[0]));
        let trace = m.draw(&[t], |_| true);
        let got = taken(&trace, |_| true);
        assert_eq!(got, t.drawn(m.kind, SIZE), "mirrored {mirrored}");
        let empty = spans.iter().filter(|s| s.0 >= s.1).count();
        assert!(valid_range(&trace).count() <= got.len() + empty);
    }
}

/// Clocks that the walk may spend on a row: its pixels up to the frame's border, or one.
fn row_cost(mirrored: bool, (from, to): (i32, i32)) -> usize {
    let width = SIZE.width as i32;
    let (near, far) = if mirrored { (-width, 0) } else { (0, width) };
    if from < to && from < far && near < to {
        (to.min(far) - from) as usize
    } else {
        1
    }
}

fn empty_rows(order: Order, seed: u64) {
    let mut r = StdRng::seed_from_u64(seed);
    let mut m = Machine::new(order, SIZE.width, SIZE.height);
    // Slivers, and triangles that lie beside the frame for some rows.
    let triangles = random_triangles(&mut r, m.kind, SIZE, -40..104, -20..68, 300, |t| {
        let empty = t.raw_spans(SIZE).1.iter().filter(|s| s.0 >= s.1).count();
        !t.pixels(SIZE).is_empty() && empty > 0
    });
    for t in &triangles {
        let words = t.writes(order, SIZE).len();
        let trace = m.draw(&[*t], |_| true);
        assert_eq!(taken(&trace, |_| true), t.drawn(m.kind, SIZE));
        let (mirrored, spans) = t.raw_spans(SIZE);
        let cost: usize = spans.iter().map(|s| row_cost(mirrored, *s)).sum();
        let last = *valid_range(&trace).end();
        let latency = m.kind.latency() as usize;
        assert!(
            last < words - 1 + latency + cost,
            "{last} {words} {cost} {spans:?}"
        );
        check_done(&trace);
    }
}

#[test]
fn an_empty_row_costs_at_most_one_clock() {
    empty_rows(Order::Quadratic, 3);
    empty_rows(Order::Linear, 4);
}

#[test]
fn the_first_pixel_comes_with_the_stated_latency() {
    for order in [
        Order::Quadratic,
        Order::Linear,
        Order::QuadraticDots,
        Order::Duff,
        TEXTURED[0],
        TEXTURED[1],
        TEXTURED[2],
        BUMPS[0],
        BUMPS[1],
        Order::Glint(Glint::Kappa),
        Order::Glint(Glint::Spot),
    ] {
        let mut m = Machine::new(order, SIZE.width, SIZE.height);
        let t = Triangle::flat([(0.0, 0.0), (9.0, 0.0), (0.0, 9.0)], 1);
        let words = t.writes(order, SIZE).len();
        let trace = m.draw(&[t], |_| true);
        // The last word and start are presented in clock words − 1.
        assert_eq!(
            *valid_range(&trace).start(),
            words - 1 + m.kind.latency() as usize
        );
    }
}

/// Clocks without a pixel between the first and the last, for spans of `pixels` pixels one below the other whose nine
/// words come `lanes` per clock: of the shell one, of depth two, of both terms three.
fn bubbles_of_spans(lanes: usize, pixels: u64) -> usize {
    const SPANS: u64 = 40;
    let core = Core::for_frame(Order::Span(SpanKind::Slerp), SIZE.width, SIZE.height).unwrap();
    let mut m = core.with_load_words(lanes).unwrap().model();
    let mut offered = vec![];
    for word in [(6, u64::from(SIZE.width)), (1, 0)] {
        m.clock(&CoreInputs {
            write: true,
            select: word.0,
            data: word.1,
            ..CoreInputs::default()
        });
    }
    for _ in 0..SPANS {
        let words = |select: u8, count: u8| (0..count).map(move |w| (select | w, 0));
        let place = [(0, pixels << 21 | 1), (0x80, 1 << 16), (0x81, 0)];
        let mut left: Vec<(u8, u64)> = place.to_vec();
        left.extend(words(0x10, 3).chain(words(0x20, 3)));
        while !left.is_empty() {
            let mut i = CoreInputs {
                ready: true,
                ..CoreInputs::default()
            };
            if m.outputs().load_ready {
                // The first word left of every target, targets with three words before those with two.
                left.sort_by_key(|(select, _)| (select & 15, *select == 0 || select >> 7 == 1));
                let mut lane = 0;
                let mut taken = std::collections::HashSet::new();
                left.retain(|(select, data)| {
                    if lane == lanes || !taken.insert(select >> 4) {
                        return true;
                    }
                    let sent = Lane {
                        write: true,
                        select: *select,
                        data: *data,
                    };
                    if lane == 0 {
                        (i.write, i.select, i.data) = (true, sent.select, sent.data);
                    } else {
                        i.more[lane - 1] = sent;
                    }
                    lane += 1;
                    false
                });
                i.start = left.is_empty();
            }
            m.clock(&i);
            offered.push(m.outputs().valid);
        }
    }
    while m.outputs().busy {
        m.clock(&CoreInputs {
            ready: true,
            ..CoreInputs::default()
        });
        offered.push(m.outputs().valid);
    }
    let first = offered.iter().position(|v| *v).unwrap();
    let last = offered.iter().rposition(|v| *v).unwrap();
    let drawn = offered.iter().filter(|v| **v).count();
    assert_eq!(drawn as u64, SPANS * pixels, "{lanes} lanes");
    last + 1 - first - drawn
}

/// A span hides the words of the next one if it has a pixel more than they take clocks: nine, five or three. Of shorter
/// spans the words come in every clock.
#[test]
fn no_bubbles_between_spans_that_hide_their_words() {
    for (lanes, clocks) in [(1, 9), (2, 5), (4, 3)] {
        assert_eq!(bubbles_of_spans(lanes, clocks + 1), 0, "{lanes} lanes");
        for pixels in 1..clocks {
            // Of the last span the pixels follow each other; behind all others the words are waited for.
            let waited = 39 * (clocks - pixels) as usize;
            assert_eq!(bubbles_of_spans(lanes, pixels), waited, "{lanes} lanes");
        }
    }
}
