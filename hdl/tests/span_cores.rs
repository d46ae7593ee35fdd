//! Rung 3 for the span cores: description and integer model agree on every output in every clock under random register
//! writes, tables, starts, clears and back pressure, including words that no host would write.

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_hdl::shade::device::{Core, CoreSimulator};
use shadegate_hdl::shade::lanes::{Lane, MAX_LANES};
use shadegate_hdl::shade::model::{CoreInputs, Order};
use shadegate_hdl::shade::span_core::SpanKind;

const CLOCKS: usize = if cfg!(debug_assertions) {
    5_000
} else {
    150_000
};

const COLUMNS: u64 = 40;

fn core(kind: SpanKind, wide: bool) -> Core {
    Core {
        order: Order::Span(kind),
        wide,
        pixels: 1200,
        load_words: 1,
    }
}

/// A word that often means something: short spans within the frame, steps small and large, colours of either sign.
fn word(r: &mut StdRng, select: u8) -> u64 {
    match (select >> 4, select & 15) {
        (0, 0) => {
            let column = r.random_range(0..COLUMNS);
            let pixels = r.random_range(0..=(COLUMNS - column).min(15));
            pixels << 21 | column << 10 | r.random_range(0..2)
        }
        (0, 1) => {
            let row = r.random_range(0..30u64);
            let address = row * COLUMNS;
            row << 21 | address
        }
        (0, 6) => COLUMNS,
        (0, 7) => r.random_range(0..32),
        (0, 2) => r.random_range(0..4096),
        (0, 4) => {
            let colour = r.random::<i32>() >> r.random_range(14..24);
            let cell = r.random_range(0..4u64) << 30 | r.random_range(0..9u64) << 26;
            cell | u64::from(colour as u32 & 0x3_ffff)
        }
        _ => {
            let places = r.random_range(0..32);
            (r.random::<i32>() >> places) as u32 as u64
        }
    }
}

/// Something on every lane that the core has behind its first; words of the shell stay on that.
fn further_lanes(core: Core, tables: bool, r: &mut StdRng) -> [Lane; MAX_LANES - 1] {
    std::array::from_fn(|k| {
        let select = r.random_range(1..16) << 4 | r.random_range(0..3);
        let data = word(r, select);
        Lane {
            write: k + 1 < core.load_words && !tables && r.random_ratio(3, 4),
            select,
            data,
        }
    })
}

fn run(core: Core, seed: u64, clocks: usize) {
    let mut r = StdRng::seed_from_u64(seed);
    let mut s = CoreSimulator::new(core).unwrap();
    let mut m = core.model();
    let (mut pixels, mut colours) = (0u64, std::collections::HashSet::new());
    for clock in 0..clocks {
        // Tables first, then mostly spans.
        let tables = clock < clocks / 8;
        let select = match r.random_range(0..10) {
            _ if clock % 1000 == 0 => 6,
            _ if tables => r.random_range(2..6),
            0..4 => [0, 0, 1, 7, 7][r.random_range(0..5)],
            4..6 => 0x80 | r.random_range(0..2),
            9 => r.random(),
            _ => r.random_range(1..4) << 4 | r.random_range(0..3),
        };
        let i = CoreInputs {
            write: r.random_ratio(15, 16),
            select,
            data: word(&mut r, select),
            start: r.random_ratio(1, 6),
            clear: r.random_ratio(1, 400),
            ready: r.random_ratio(7, 8),
            more: further_lanes(core, tables, &mut r),
        };
        s.clock(&i);
        m.clock(&i);
        let want = m.outputs();
        assert_eq!(s.outputs(), want, "{core:?}, clock {clock}");
        if want.valid {
            pixels += 1;
            colours.insert(want.rgb);
        }
    }
    assert!(
        pixels > clocks as u64 / 100 && colours.len() > 50,
        "the stimulus must draw: {pixels} pixels, {} colours",
        colours.len()
    );
}

#[test]
fn slerp_core() {
    run(core(SpanKind::Slerp, false), 1, CLOCKS);
    run(core(SpanKind::Slerp, true), 2, CLOCKS / 4);
}

#[test]
fn chebyshev_core() {
    run(core(SpanKind::Chebyshev, false), 3, CLOCKS);
}

#[test]
fn spherical_core_with_every_table() {
    for bits in 4..=10 {
        run(
            core(SpanKind::Spherical(bits), false),
            bits as u64,
            CLOCKS / 3,
        );
    }
    run(core(SpanKind::SphericalPower(8), true), 11, CLOCKS / 4);
}

#[test]
fn blake_core() {
    run(core(SpanKind::Blake, false), 12, CLOCKS);
}

#[test]
fn several_words_per_clock() {
    let kinds = [
        SpanKind::Slerp,
        SpanKind::Chebyshev,
        SpanKind::Spherical(6),
        SpanKind::Blake,
    ];
    for (kind, seed) in kinds.into_iter().zip(21..) {
        for words in [2, 4] {
            let core = core(kind, false).with_load_words(words).unwrap();
            run(core, seed, CLOCKS / 4);
        }
    }
}
