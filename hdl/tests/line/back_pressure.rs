//! Whoever takes the pixels may take them when he likes; lines that begin on each other's last pixels wait for them; and
//! otherwise every clock has its pixel.

use super::host::{core, draw, frame_words, random_path, taken, words, Drawn, SIZE};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_hdl::line::Filter;
use shadegate_hdl::shade::device::CoreSimulator;
use shadegate_hdl::shade::model::CoreOutputs;
use shadegate_reference::line::{Path, Pixel};

fn trace(
    filter: Filter,
    writes: &[Vec<(u8, u64)>],
    ready: impl Fn(usize) -> bool,
) -> Vec<CoreOutputs> {
    let mut s = CoreSimulator::new(core(filter, SIZE)).unwrap();
    let now = s.outputs();
    draw(writes, &frame_words(SIZE, [30, 60, 90]), now, ready, |i| {
        s.clock(i);
        s.outputs()
    })
}

#[test]
fn any_pattern_gives_the_same_pixels() {
    let mut r = StdRng::seed_from_u64(3);
    let mut random = |n: u32| (0..997).map(|_| r.random_ratio(n, 10)).collect::<Vec<_>>();
    let patterns: Vec<Vec<bool>> = vec![
        random(1),
        random(5),
        random(9),
        vec![true, false],
        (0..7).map(|i| i == 3).collect(),
        (0..200).map(|i| i % 50 < 20).collect(),
        (0..4000).map(|i| i > 3000).collect(),
    ];
    for filter in Filter::ALL {
        let mut r = StdRng::seed_from_u64(5);
        let writes: Vec<_> = (0..60)
            .map(|_| words(filter, &random_path(&mut r, SIZE, 9), SIZE.0, r.random()))
            .collect();
        let want = taken(&trace(filter, &writes, |_| true), |_| true);
        assert!(want.len() > 1000);
        for pattern in &patterns {
            let ready = |t: usize| pattern[t % pattern.len()];
            let trace = trace(filter, &writes, ready);
            assert_eq!(taken(&trace, ready), want, "{filter:?}");
            for (t, pair) in trace.windows(2).enumerate() {
                if pair[0].valid && !ready(t) {
                    assert!(pair[1].valid, "clock {t}");
                    assert_eq!(Drawn::of(&pair[0]), Drawn::of(&pair[1]), "clock {t}");
                }
            }
        }
    }
}

fn path(a: (i32, i32), b: (i32, i32)) -> Path {
    let p = |(x, y)| Pixel { x, y };
    Path::new(p(a), p(b)).unwrap()
}

/// The same point again and again, each time over what the last one left: 1 − (1 − V)ⁿ of the line.
#[test]
fn a_pixel_drawn_twice_running_sees_the_first() {
    let point = path((5, 5), (5, 5));
    // The core loads every 16 words; the points of one line's end and the next one's beginning follow at once.
    let mut old = [30u8, 60, 90].map(f64::from);
    let lines: Vec<_> = (0..20)
        .map(|_| words(Filter::Cone, &point, SIZE.0, [250; 3]))
        .collect();
    for p in taken(&trace(Filter::Cone, &lines, |_| true), |_| true) {
        assert_eq!(p.level, 199);
        for (c, o) in p.rgb.into_iter().zip(&mut old) {
            let want = (*o * 56.0 + 250.0 * 199.0) / 255.0;
            assert!((f64::from(c) - want).abs() <= 0.5);
            *o = f64::from(c);
        }
    }
}

/// Clocks in which no pixel is offered between the first and the last one.
fn bubbles(trace: &[CoreOutputs]) -> usize {
    let first = trace.iter().position(|o| o.valid).unwrap();
    let last = trace.iter().rposition(|o| o.valid).unwrap();
    trace[first..=last].iter().filter(|o| !o.valid).count()
}

#[test]
fn one_pixel_per_clock() {
    for (filter, most) in [(Filter::Bresenham, 1), (Filter::Box, 2), (Filter::Cone, 4)] {
        // Long enough for the words of the next line; in the frame with all their lanes; no end on another's beginning;
        // slopes at which every pixel has a weight.
        let mut lines = vec![];
        for k in 0..20 {
            lines.push(path((3 + k, 4), (80 + k % 7, 9 + k)));
            lines.push(path((5 + 4 * k, 3), (6 + 4 * k, 55)));
        }
        let columns: usize = lines.iter().map(|l| l.major as usize + 1).sum();
        let writes: Vec<_> = lines
            .iter()
            .map(|l| words(filter, l, SIZE.0, [200, 100, 50]))
            .collect();
        let trace = trace(filter, &writes, |_| true);
        let pixels = taken(&trace, |_| true).len();
        let lost = bubbles(&trace);
        println!("{filter:?}: {pixels} pixels of {columns} columns, {lost} clocks without one");
        match filter {
            Filter::Bresenham => assert_eq!((pixels, lost), (columns, 0)),
            // Pixels of weight 0 are not offered, the last one of all among them: as many lanes as clocks.
            Filter::Box => assert_eq!(pixels + lost, 2 * columns - 1),
            Filter::Cone => {
                let lanes: usize = lines
                    .iter()
                    .map(|l| (l.major as usize + 1) * if 2 * l.minor > l.major { 4 } else { 3 })
                    .sum();
                assert!(pixels + lost <= lanes && pixels * most >= lanes, "{lanes}");
            }
        }
    }
}
