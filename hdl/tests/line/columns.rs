//! The unit that delivers a column per clock: against its model in every clock, against the cone core's levels, and its
//! throughput.

use super::host::{core, draw, frame_words, random_path, taken, words, SIZE};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_hdl::format::U;
use shadegate_hdl::line::cone_column::{Column, ConeColumns, ConeColumnsModel};
use shadegate_hdl::line::walk_model::WalkPosition;
use shadegate_hdl::line::Filter;
use shadegate_hdl::simulate::Simulator;
use shadegate_reference::line::coverage::Table;
use shadegate_reference::line::fixed::{Form, Words};
use shadegate_reference::line::set_up::SetUp;
use shadegate_reference::line::Path;
use std::collections::BTreeMap;

/// Everything but what only the model knows.
fn shown(c: Column) -> (i64, i64, u64, bool, bool, bool, [u8; 4]) {
    let WalkPosition {
        major,
        minor,
        address,
        steep,
        falling,
        ..
    } = c.at;
    (major, minor, address, steep, falling, c.below, c.weights)
}

fn clock_by_clock<const I: usize, const N: usize>(seed: u64, clocks: usize) {
    let mut r = StdRng::seed_from_u64(seed);
    let mut s = Simulator::new(ConeColumns::<17, I, N>::default()).unwrap();
    let mut m = ConeColumnsModel::new(17, I as u32 - 1);
    let mut queue: Vec<(u8, u64)> = vec![];
    let mut columns = 0u64;
    for clock in 0..clocks {
        if queue.is_empty() {
            queue = words(Filter::Cone, &random_path(&mut r, SIZE, 20), SIZE.0, [0; 3]);
            queue.truncate(10);
            queue.reverse();
        }
        // Now and then a word that describes no line.
        let noise = r.random_ratio(1, 200);
        let next = if noise {
            Some((r.random_range(0..16u8), u64::from(r.random::<u32>())))
        } else {
            queue.last().copied()
        };
        let write = next.filter(|_| r.random_ratio(15, 16));
        let last = !noise && queue.len() == 1 && write.is_some();
        let (start, ready) = (last || r.random_ratio(1, 100), r.random_ratio(7, 8));
        if write.is_some() && !noise && m.load_ready() {
            queue.pop();
        }
        let d = &mut s.design;
        d.write.next = write.is_some();
        d.word.next = U::new(write.map_or(0, |w| u64::from(w.0)));
        d.data.next = U::new(write.map_or(0, |w| w.1));
        d.start.next = start;
        d.ready.next = ready;
        s.clock();
        m.clock(write.map(|(w, v)| (usize::from(w), v)), start, ready);
        let d = &s.design;
        let got = (
            d.major.val().code(),
            d.minor.val().code(),
            d.address.val().get(),
            d.steep.val(),
            d.falling.val(),
            d.below.val(),
            [&d.middle, &d.plus, &d.minus, &d.fourth].map(|w| w.val().get() as u8),
        );
        assert_eq!(got, shown(m.column()), "clock {clock}");
        let flags = (d.load_ready.val(), d.valid.val(), d.busy.val());
        assert_eq!(flags, (m.load_ready(), m.valid, m.busy()), "clock {clock}");
        columns += u64::from(m.valid);
    }
    assert!(columns > clocks as u64 / 2, "{columns}");
}

#[test]
fn the_unit_is_its_model() {
    let clocks = if cfg!(debug_assertions) {
        5_000
    } else {
        200_000
    };
    clock_by_clock::<9, 22>(1, clocks);
    clock_by_clock::<4, 27>(2, clocks / 4);
    clock_by_clock::<5, 26>(3, clocks / 4);
}

/// The columns of lines, and the clocks from the first to the last.
fn columns(lines: &[Path], fraction_bits: u32) -> (Vec<Column>, usize) {
    let mut m = ConeColumnsModel::new(17, fraction_bits);
    m.clock(Some((11, 64 << 12 | 96)), false, true);
    let mut out = vec![];
    let (mut clock, mut first, mut last) = (0, None, 0);
    let mut queue: Vec<(u8, u64, bool)> = vec![];
    for l in lines {
        let w = words(Filter::Cone, l, SIZE.0, [0; 3]);
        queue.extend(w[..10].iter().enumerate().map(|(i, w)| (w.0, w.1, i == 9)));
    }
    let mut queue = queue.into_iter();
    let mut rest = queue.len();
    while rest > 0 || m.busy() {
        let next = if m.load_ready() { queue.next() } else { None };
        rest = queue.len();
        if m.valid {
            out.push(m.column());
            first.get_or_insert(clock);
            last = clock;
        }
        let write = next.map(|(w, v, _)| (usize::from(w), v));
        m.clock(write, next.is_some_and(|n| n.2), true);
        clock += 1;
    }
    (out, last + 1 - first.unwrap_or(0))
}

#[test]
fn one_column_per_clock_without_a_gap_between_lines() {
    let mut r = StdRng::seed_from_u64(4);
    // A line must be long enough for the ten words of the next one, and the two clocks until they are loaded.
    let lines: Vec<Path> = std::iter::repeat_with(|| random_path(&mut r, SIZE, 10))
        .filter(|p| p.major >= 12)
        .take(300)
        .collect();
    let all: usize = lines.iter().map(|l| l.major as usize + 1).sum();
    let (columns, clocks) = columns(&lines, 8);
    assert_eq!((columns.len(), clocks), (all, all));
    let pixels: usize = columns
        .iter()
        .map(|c| c.weights.iter().filter(|w| **w > 0).count())
        .sum();
    println!(
        "{pixels} weighted pixels in {clocks} clocks: {:.2} per clock",
        pixels as f64 / clocks as f64
    );
    assert!(pixels > 2 * clocks);
}

/// The same weights at the same places as the core hands over one by one, and as the software's integer form has them
/// for tables of any size.
#[test]
fn the_weights_are_those_of_the_core_and_of_the_software() {
    let mut r = StdRng::seed_from_u64(6);
    let kind = core(Filter::Cone, SIZE);
    for _ in 0..200 {
        let path = random_path(&mut r, SIZE, 3);
        let screen = |c: &Column, offset: i64| {
            let minor = c.at.minor + if c.at.falling { -offset } else { offset };
            if c.at.steep {
                (minor, c.at.major)
            } else {
                (c.at.major, minor)
            }
        };
        let pixels = |bits: u32| {
            let mut all = BTreeMap::new();
            for c in columns(&[path], bits).0 {
                let far = if c.below { -2 } else { 2 };
                for (offset, weight) in [0, 1, -1, far].into_iter().zip(c.weights) {
                    if weight > 0 {
                        assert_eq!(all.insert(screen(&c, offset), u16::from(weight)), None);
                    }
                }
            }
            all
        };
        for bits in [3, 4, 6, 8, 12] {
            let words = Words::new(&SetUp::new(&path), 30, Form::Increments);
            let table = Table::new(bits, 255);
            let want: BTreeMap<_, _> = words
                .pixels(&path, &table)
                .map(|(p, level)| ((i64::from(p.x), i64::from(p.y)), level))
                .collect();
            assert_eq!(pixels(bits), want, "{path:?}, {bits} fraction bits");
        }
        let mut m = kind.model();
        let now = m.outputs();
        let line = [words(Filter::Cone, &path, SIZE.0, [255; 3])];
        let trace = draw(
            &line,
            &frame_words(SIZE, [0; 3]),
            now,
            |_| true,
            |i| {
                m.clock(i);
                m.outputs()
            },
        );
        let inside = |(x, y): &(i64, i64)| (0..96).contains(x) && (0..64).contains(y);
        let mut want = pixels(8);
        want.retain(|p, _| inside(p));
        let drawn = taken(&trace, |_| true);
        let got: BTreeMap<_, _> = drawn
            .iter()
            .map(|d| ((i64::from(d.x), i64::from(d.y)), d.level))
            .collect();
        assert_eq!(got, want);
    }
}
