//! The compact unit equals its integer model, every output, every clock, under random words, writes at any time and back
//! pressure.

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_hdl::compact::unit::{CompactUnit, CompactUnit29, CompactUnit32};
use shadegate_hdl::compact::{CompactInputs, CompactModel, CompactOutputs};
use shadegate_hdl::format::U;
use shadegate_hdl::simulate::Simulator;

const CLOCKS: usize = if cfg!(debug_assertions) {
    20_000
} else {
    300_000
};

/// Of every triangle, so that its rows are few; they wrap.
const FIRST_ROW: u32 = 0x7fd;

/// A word that keeps spans and triangles short, so that everything happens often.
fn word(r: &mut StdRng, select: u8) -> u32 {
    let edge = |columns: i32, error: i32| (columns as u32) << 20 | error as u32 & 0xf_ffff;
    if select >> 4 != 0 {
        return r.random();
    }
    match select {
        7 => edge(r.random_range(-6..20), r.random_range(-90..90)),
        6 | 15 => edge(r.random_range(-3..24), r.random_range(-90..90)),
        0 | 2 | 4 => edge(r.random_range(-2..2), r.random_range(0..60)),
        1 | 3 | 5 => edge(r.random_range(-1..3), r.random_range(-60..0)),
        8 => {
            let (upper, lower) = (r.random_range(1..5u32), r.random_range(0..4u32));
            let turn = FIRST_ROW + upper;
            let rows = ((turn + lower) & 0x7ff) << 11 | (turn & 0x7ff);
            u32::from(lower > 0) << 23 | r.random_range(0..2u32) << 22 | rows
        }
        9 => FIRST_ROW,
        11 => r.random_range(1..16),
        _ => r.random(),
    }
}

fn equals<const D: usize, const M: usize, const N: usize, const V: usize>(
    design: CompactUnit<D, M, N, V>,
    seed: u64,
) {
    let mut r = StdRng::seed_from_u64(seed);
    let mut s = Simulator::new(design).unwrap();
    let mut m = CompactModel::new(M, N, V);
    let (mut pixels, mut triangles) = (0, 0);
    let mut select: u8 = 0;
    for clock in 0..CLOCKS {
        // Bursts of writes in order of their numbers, so that triangles are whole.
        if clock < 100 || r.random_ratio(9, 10) {
            let targets = if clock < 100 || r.random() {
                0
            } else {
                r.random_range(0..8) << 4
            };
            select = ((select + 1) % 16) | targets;
        }
        let i = CompactInputs {
            write: r.random_ratio(1, 2),
            select,
            data: word(&mut r, select),
            // Not before all words of the walk were written once: rows from nowhere are two thousand.
            start: clock > 100 && r.random_ratio(1, 30),
            ready: r.random_ratio(3, 4),
        };
        s.design.write.next = i.write;
        s.design.select.next = U::new(u64::from(i.select));
        s.design.data.next = U::new(u64::from(i.data));
        s.design.start.next = i.start;
        s.design.ready.next = i.ready;
        let before = m.outputs();
        pixels += usize::from(before.valid && i.ready);
        triangles += usize::from(before.load_ready && i.start);
        s.clock();
        m.clock(&i);
        let d = &s.design;
        let byte = |v: U<8>| v.get() as u8;
        let got = CompactOutputs {
            load_ready: d.load_ready.val(),
            valid: d.valid.val(),
            x: d.x.val().get(),
            y: d.y.val().get(),
            rgb: [byte(d.red.val()), byte(d.green.val()), byte(d.blue.val())],
            busy: d.busy.val(),
        };
        assert_eq!(got, m.outputs(), "clock {clock}");
    }
    println!("{triangles} triangles, {pixels} pixels");
    assert!(triangles > CLOCKS / 400 && pixels > CLOCKS / 20);
}

#[test]
fn words_of_32_bits() {
    equals(CompactUnit32::default(), 1);
}

#[test]
fn words_of_29_bits_and_short_values() {
    equals(CompactUnit29::default(), 2);
}
