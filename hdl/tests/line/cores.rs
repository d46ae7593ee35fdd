//! The line cores equal their integer model on every output in every clock, under random register writes, starts, clears
//! and back pressure, including words that describe no line at all.

use super::host::core;
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_hdl::line::Filter;
use shadegate_hdl::shade::device::{Core, CoreSimulator};
use shadegate_hdl::shade::model::{CoreInputs, Order};

const CLOCKS: usize = if cfg!(debug_assertions) {
    5_000
} else {
    500_000
};

fn random_word(r: &mut StdRng, select: u8) -> u64 {
    if r.random_ratio(1, 60) {
        return u64::from(r.random::<u32>());
    }
    let near = |r: &mut StdRng| r.random_range(-3..40i64) as u64 & 0xfff;
    let error =
        |r: &mut StdRng, low: i64, high: i64| r.random_range(low..high) as u64 & 0xffff_ffff;
    match (select >> 4, select & 15) {
        (0, 0) => r.random_range(0..16u64) << 11 | r.random_range(0..9),
        (0, 1) => near(r) << 12 | near(r),
        // Few places, so that lines meet.
        (0, 2) => r.random_range(0..12),
        (0, 3) => error(r, -20, 20),
        (0, 4) => error(r, 0, 20),
        (0, 5) => error(r, -20, 0),
        (0, 11) => 30 << 12 | 40,
        (0, 12) => r.random_range(0..1 << 24),
        _ => u64::from(r.random::<u32>()),
    }
}

fn run(core: Core, seed: u64, clocks: usize) {
    let mut r = StdRng::seed_from_u64(seed);
    let mut s = CoreSimulator::new(core).unwrap();
    let mut m = core.model();
    let mut pixels = 0u64;
    for clock in 0..clocks {
        let word = r.random_range(0..13);
        let channels = if r.random_ratio(1, 4) {
            r.random_range(0..16u8) << 4
        } else {
            0
        };
        let i = CoreInputs {
            write: r.random_ratio(15, 16),
            select: channels | word,
            data: random_word(&mut r, channels | word),
            start: r.random_ratio(1, 12),
            clear: r.random_ratio(1, 2000),
            ready: r.random_ratio(7, 8),
            ..CoreInputs::default()
        };
        s.clock(&i);
        m.clock(&i);
        let want = m.outputs();
        assert_eq!(s.outputs(), want, "{core:?}, clock {clock}");
        pixels += u64::from(want.valid);
    }
    assert!(
        pixels > clocks as u64 / 20,
        "the stimulus must draw: {pixels} pixels"
    );
}

fn small(filter: Filter, wide: bool) -> Core {
    Core {
        order: Order::Line(filter),
        wide,
        pixels: 1200,
        load_words: 1,
    }
}

#[test]
fn bresenham_core() {
    run(small(Filter::Bresenham, false), 31, CLOCKS);
}

#[test]
fn box_core() {
    run(small(Filter::Box, false), 32, CLOCKS);
}

#[test]
fn cone_core() {
    run(small(Filter::Cone, false), 33, CLOCKS);
}

#[test]
fn wide_cores() {
    for (seed, filter) in (34..).zip(Filter::ALL) {
        run(small(filter, true), seed, CLOCKS / 4);
    }
}

#[test]
fn the_first_pixel_comes_when_latency_says() {
    for filter in Filter::ALL {
        let core = core(filter, super::host::SIZE);
        let mut m = core.model();
        for (select, data) in super::host::frame_words(super::host::SIZE, [0; 3]) {
            m.clock(&CoreInputs {
                write: true,
                select,
                data,
                ..CoreInputs::default()
            });
        }
        // One pixel at (0, 0).
        let start = CoreInputs {
            write: true,
            select: 6,
            start: true,
            ready: true,
            ..CoreInputs::default()
        };
        m.clock(&start);
        let mut clocks = 1;
        while !m.outputs().valid {
            m.clock(&CoreInputs::default());
            clocks += 1;
        }
        assert_eq!(clocks, filter.latency(), "{filter:?}");
    }
}
