//! How many clocks a second both cores run in-process while they draw small triangles and take a word every clock.
//!
//! `cargo run --release -p shadegate-hdl --example simulation_speed`

#[path = "../tests/support/mod.rs"]
mod support;

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_hdl::shade::model::{CoreInputs, Order};
use shadegate_reference::raster::Point;
use std::time::Instant;
use support::{depth_code, Machine, Polynomial, Triangle};

const CLOCKS: u32 = 100_000;
const RUNS: usize = 5;

/// Triangles of about 50 pixels, each nearer than the ones before: about as many words are due as pixels.
fn triangles(count: u16) -> Vec<Triangle> {
    let mut r = StdRng::seed_from_u64(5);
    (0..count)
        .map(|i| {
            let (x, y) = (r.random_range(0..300 * 256), r.random_range(0..220 * 256));
            let mut corner = |dx: i32, dy: i32| Point {
                x: x + dx * 256 + r.random_range(0..512),
                y: y + dy * 256 + r.random_range(0..512),
            };
            let corners = [corner(0, 0), corner(11, 3), corner(4, 10)];
            let colour = || Polynomial([100 << 20, 1 << 17, -1 << 17, 1 << 10, 77, -1 << 9]);
            Triangle {
                corners,
                colour: [colour(), colour(), colour()],
                depth: Polynomial([depth_code(1000 + 16 * i), 3 << 12, 5 << 12, 0, 0, 0]),
            }
        })
        .collect()
}

fn run(order: Order) -> (f64, f64, f64) {
    let mut m = Machine::new(order, 320, 240);
    let words: Vec<(u8, u64, bool)> = triangles(3000)
        .iter()
        .flat_map(|t| {
            let w = t.writes(order, m.size);
            let last = w.len().wrapping_sub(1);
            w.into_iter()
                .enumerate()
                .map(move |(i, w)| (w.0, w.1, i == last))
        })
        .collect();
    let (mut next, mut accepted, mut pixels) = (0, 0u32, 0u32);
    let begin = Instant::now();
    for _ in 0..CLOCKS {
        let o = m.outputs();
        // While the core is not ready the word is offered and ignored.
        let (select, data, start) = words[next];
        if o.load_ready {
            next = (next + 1) % words.len();
            accepted += 1;
        }
        pixels += u32::from(o.valid);
        m.clock(&CoreInputs {
            write: true,
            select,
            data,
            start,
            clear: false,
            ready: true,
            ..CoreInputs::default()
        });
    }
    let speed = f64::from(CLOCKS) / begin.elapsed().as_secs_f64();
    let per_clock = |n: u32| f64::from(n) / f64::from(CLOCKS);
    (speed, per_clock(accepted), per_clock(pixels))
}

fn main() {
    for order in [Order::Quadratic, Order::Linear] {
        let mut runs: Vec<_> = (0..RUNS).map(|_| run(order)).collect();
        runs.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (speed, words, pixels) = runs[RUNS / 2];
        println!(
            "{order:?}: {speed:.0} clocks/s (median of {RUNS}, {:.0} to {:.0}), {words:.2} words and {pixels:.2} visible pixels per clock",
            runs[0].0,
            runs[RUNS - 1].0
        );
    }
}
