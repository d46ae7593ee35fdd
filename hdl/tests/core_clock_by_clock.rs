//! Rung 3 for whole cores: description and integer model agree on every output in every clock under random register
//! writes, starts, clears and back pressure, including words that describe no triangle at all.

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_hdl::bump::Bend;
use shadegate_hdl::light::Glint;
use shadegate_hdl::shade::device::{Core, CoreSimulator};
use shadegate_hdl::shade::lanes::{Lane, MAX_LANES};
use shadegate_hdl::shade::model::{CoreInputs, CoreModel, Order};
use shadegate_hdl::texture::{Mapping, Texturing};

const CLOCKS: usize = if cfg!(debug_assertions) {
    5_000
} else {
    1_000_000
};

fn random_word(r: &mut StdRng, select: u8) -> u64 {
    let edge =
        |column: i64, error: i64| ((column as u64 & 0xfff) << 20) | (error as u64 & 0xf_ffff);
    if select >> 4 != 0 {
        return match r.random_range(0..4) {
            0 => r.random(),
            1 => r.random_range(0..255u64) << 20,
            _ => r.random_range(0..1u64 << 28),
        };
    }
    match select & 15 {
        0 => {
            let rows = r.random_range(0..12u64);
            r.random_range(0..=1u64) << 22 | r.random_range(0..=rows) << 11 | rows
        }
        1 => {
            let row = r.random_range(0..30u64);
            (row * 40) << 11 | row
        }
        2 | 5 | 8 => edge(r.random_range(-20..60), r.random_range(-500..500)),
        3 | 6 | 9 => edge(r.random_range(-4..4), r.random_range(0..500)),
        4 | 7 | 10 => edge(0, r.random_range(-500..0)),
        _ => 40,
    }
}

fn run(core: Core, seed: u64, clocks: usize) {
    let mut r = StdRng::seed_from_u64(seed);
    let mut s = CoreSimulator::new(core).unwrap();
    let mut m: CoreModel = core.model();
    let mut pixels = 0u64;
    let mut next = 0u8;
    for clock in 0..clocks {
        let write = r.random_ratio(15, 16);
        if write {
            next = next.wrapping_add(1);
        }
        // Shell words and channel words in turn; sometimes several channels at once.
        let select = if next & 1 == 0 {
            (next >> 1) % 12
        } else {
            (r.random_range(1..16u8) << 4) | ((next >> 1) % 16)
        };
        // Now and then the fence of the cores that have one.
        let select = if r.random_ratio(1, 60) { 12 } else { select };
        let i = CoreInputs {
            write,
            select,
            data: random_word(&mut r, select),
            start: r.random_ratio(1, 12),
            clear: r.random_ratio(1, 400),
            ready: r.random_ratio(7, 8),
            more: further_lanes(core, || {
                let select = r.random_range(0..16u8) << 4 | r.random_range(0..12);
                Lane {
                    write: r.random_ratio(3, 4),
                    select,
                    data: random_word(&mut r, select),
                }
            }),
        };
        s.clock(&i);
        m.clock(&i);
        let want = m.outputs();
        assert_eq!(s.outputs(), want, "{core:?}, clock {clock}");
        pixels += u64::from(want.valid);
    }
    assert!(
        pixels > clocks as u64 / 100,
        "the stimulus must draw: {pixels} pixels"
    );
}

/// Something on every lane that the core has behind its first.
fn further_lanes(core: Core, mut lane: impl FnMut() -> Lane) -> [Lane; MAX_LANES - 1] {
    std::array::from_fn(|k| {
        if k + 1 < core.load_words {
            lane()
        } else {
            Lane::default()
        }
    })
}

fn core(order: Order, wide: bool) -> Core {
    Core {
        order,
        wide,
        pixels: 1200,
        load_words: 1,
    }
}

#[test]
fn quadratic_core() {
    run(core(Order::Quadratic, false), 21, CLOCKS);
}

#[test]
fn gouraud_core() {
    run(core(Order::Linear, false), 22, CLOCKS);
}

#[test]
fn quadratic_dots_core() {
    run(core(Order::QuadraticDots, false), 25, CLOCKS);
}

#[test]
fn duff_core() {
    run(core(Order::Duff, false), 27, CLOCKS);
}

/// Small texture memories, so that places beyond them are met too.
fn textured(mapping: Mapping, texels_log2: u8) -> Order {
    Order::Textured(Texturing {
        mapping,
        texels_log2,
    })
}

#[test]
fn textured_cores() {
    run(core(textured(Mapping::Affine, 12), false), 31, CLOCKS / 4);
    run(core(textured(Mapping::Quadratic, 3), false), 32, CLOCKS / 4);
    run(
        core(textured(Mapping::Perspective, 16), false),
        33,
        CLOCKS / 2,
    );
}

#[test]
fn wide_textured_cores() {
    run(core(textured(Mapping::Affine, 3), true), 34, CLOCKS / 8);
    run(core(textured(Mapping::Quadratic, 12), true), 35, CLOCKS / 8);
    run(
        core(textured(Mapping::Perspective, 5), true),
        36,
        CLOCKS / 4,
    );
}

#[test]
fn bump_cores() {
    run(core(Order::Bump(Bend::Newton), false), 51, CLOCKS / 32);
    run(core(Order::Bump(Bend::Reflection), false), 52, CLOCKS / 32);
    run(core(Order::Bump(Bend::Newton), true), 53, CLOCKS / 32);
    run(core(Order::Bump(Bend::Reflection), true), 54, CLOCKS / 32);
}

#[test]
fn cores_without_tables() {
    run(core(Order::Glint(Glint::Kappa), false), 41, CLOCKS / 2);
    run(core(Order::Glint(Glint::Spot), false), 42, CLOCKS / 2);
}

#[test]
fn wide_cores() {
    run(core(Order::Glint(Glint::Kappa), true), 43, CLOCKS / 8);
    run(core(Order::Glint(Glint::Spot), true), 44, CLOCKS / 8);
    run(core(Order::Quadratic, true), 23, CLOCKS / 4);
    run(core(Order::Linear, true), 24, CLOCKS / 4);
    run(core(Order::QuadraticDots, true), 26, CLOCKS / 4);
    run(core(Order::Duff, true), 28, CLOCKS / 4);
}

/// Any word on any lane, targets of several lanes at once included.
#[test]
fn several_words_per_clock() {
    let orders = [
        Order::Quadratic,
        Order::Linear,
        Order::QuadraticDots,
        Order::Duff,
    ];
    for (order, seed) in orders.into_iter().zip(31..) {
        for words in [2, 4] {
            let wide = words == 2 && order == Order::Duff;
            let core = core(order, wide).with_load_words(words).unwrap();
            run(core, seed, CLOCKS / 8);
        }
    }
}
