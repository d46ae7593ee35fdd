//! Rung 3 for the set-up engine, its units and its core: description and integer model agree in every clock, under
//! random triangles, words that describe none, starts, clears and back pressure.

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_hdl::format::U;
use shadegate_hdl::set_up::divider::{Divider, DividerModel};
use shadegate_hdl::set_up::instruction::{Division, Exponent};
use shadegate_hdl::set_up::multiplier::{Multiplier, MultiplierModel};
use shadegate_hdl::shade::device::{Core, CoreSimulator};
use shadegate_hdl::shade::model::{CoreInputs, CoreModel, Order};
use shadegate_hdl::simulate::Simulator;

const SCALE: usize = if cfg!(debug_assertions) { 1 } else { 20 };

/// Bits that are all alike, a few, or any.
fn word(r: &mut StdRng) -> i64 {
    let any = r.random::<i64>() >> r.random_range(0..64);
    match r.random_range(0..8) {
        0 => 0,
        1 => -1,
        2 => i64::MIN,
        3 => i64::MAX,
        _ => any,
    }
}

#[test]
fn multiplier() {
    let mut r = StdRng::seed_from_u64(31);
    let mut s = Simulator::new(Multiplier::default()).unwrap();
    let mut m = MultiplierModel::default();
    let mut busy = 0;
    for clock in 0..5_000 * SCALE {
        let go = r.random_ratio(7, 8);
        let start = busy == 0 && r.random_ratio(3, 4);
        let (x, y, exponent) = (word(&mut r), word(&mut r), r.random_range(0..42u8));
        let (limbs, places) = (r.random_range(1..=4u8), r.random_range(0..128u8));
        let kind = r.random_range(0..3usize);
        s.design.go.next = go;
        s.design.start.next = start;
        s.design.x.next = U::new(x as u64);
        s.design.y.next = U::new(y as u64);
        s.design.limbs.next = U::new(u64::from(limbs - 1));
        s.design.places.next = U::new(u64::from(places));
        s.design.kind.next = U::new(kind as u64);
        s.design.exponent.next = U::new(u64::from(exponent));
        s.clock();
        if go {
            let e = [Exponent::None, Exponent::Once, Exponent::Twice][kind];
            m.clock(start.then_some((x, y, limbs, places, e)), exponent);
            busy = if start {
                limbs - 1
            } else {
                busy.saturating_sub(1)
            };
        }
        assert_eq!(
            s.design.product.val().get() as i64,
            m.product,
            "clock {clock}"
        );
    }
}

/// The product is what the multiplier's remarks say, for every kind of operand.
#[test]
fn products_are_exact() {
    let mut r = StdRng::seed_from_u64(32);
    for _ in 0..5_000 * SCALE {
        let (x, y) = (word(&mut r), word(&mut r));
        let (limbs, places) = (r.random_range(1..=4u8), r.random_range(0..112u8));
        let mut m = MultiplierModel::default();
        m.clock(Some((x, y, limbs, places, Exponent::None)), 0);
        for _ in 0..4 + limbs {
            m.clock(None, 0);
        }
        let kept = 16 * u32::from(limbs);
        let (x, y) = (
            i128::from(x << 39 >> 39),
            i128::from(y << (64 - kept) >> (64 - kept)),
        );
        let up = 64 - 16 * (i32::from(limbs) - 1) - i32::from(places);
        // Below 2^89 each; what leaves the top is not asked for.
        let want = if up >= 0 {
            (x * y) << up.min(100)
        } else {
            (x * y) >> -up
        };
        assert_eq!(m.product, want as i64, "{x} {y} {limbs} {places}");
    }
}

#[test]
fn divider() {
    let mut r = StdRng::seed_from_u64(33);
    let mut s = Simulator::new(Divider::default()).unwrap();
    let mut m = DividerModel::default();
    for clock in 0..5_000 * SCALE {
        let (go, start) = (r.random_ratio(15, 16), r.random_ratio(1, 40));
        let (x, y) = (word(&mut r), word(&mut r));
        let kind = r.random_range(0..3usize);
        s.design.go.next = go;
        s.design.start.next = start;
        s.design.kind.next = U::new(kind as u64);
        s.design.x.next = U::new(x as u64);
        s.design.y.next = U::new(y as u64);
        s.clock();
        if go {
            let kind = [Division::Whole, Division::Fraction, Division::Reciprocal][kind];
            m.clock(start.then_some((x, y, kind)));
        }
        let got = (
            s.design.quotient.val().get(),
            s.design.remainder.val().get() as i64,
            s.design.exponent.val().get() as u8,
        );
        assert_eq!(
            got,
            (m.quotient, m.remainder(), m.exponent),
            "clock {clock}"
        );
    }
}

#[test]
fn quotients_are_right() {
    let mut r = StdRng::seed_from_u64(34);
    for _ in 0..2_000 * SCALE {
        let y = r.random_range(1..1i64 << 20);
        let x = r.random_range(-4096 * y..4096 * y);
        let divide = |x, y, kind, steps: usize| {
            let mut m = DividerModel::default();
            m.clock(Some((x, y, kind)));
            for _ in 0..steps {
                m.clock(None);
            }
            m
        };
        let m = divide(x, y, Division::Whole, 14);
        assert_eq!(m.quotient as i64 - 4096, x.div_euclid(y));
        assert_eq!(m.remainder(), x.rem_euclid(y));
        assert_eq!(
            divide(0, y, Division::Fraction, 44).quotient,
            (1 << 43) / y as u64
        );
        let area = r.random_range(1..=1i64 << 40) >> r.random_range(0..41);
        let area = area.max(1);
        let m = divide(0, area, Division::Reciprocal, 64);
        assert!((1 << 23..1 << 24).contains(&m.quotient));
        let unit = 23 + u32::from(m.exponent);
        assert_eq!(u128::from(m.quotient), (1u128 << unit) / area as u128);
    }
}

/// What a host writes for one triangle, in any order; sometimes words that make no sense.
fn triangle(r: &mut StdRng) -> Vec<(u8, u64)> {
    let mut all = vec![];
    let around = (r.random_range(0..40 * 256), r.random_range(0..30 * 256));
    let reach = [300, 2000, 12_000][r.random_range(0..3)];
    for i in 0..3u8 {
        let mut off = |at: i64| at + r.random_range(-reach..=reach);
        let (x, y) = (off(around.0), off(around.1));
        all.extend([(i, x as u64), (4 + i, y as u64)]);
        all.push((0x80 | i, r.random_range(0..65_536u64 * 64)));
        for c in [0x10, 0x20, 0x40u8] {
            let knot = match r.random_range(0..5) {
                0 => r.random::<u64>() & 0xff_ffff,
                _ => r.random_range(0..255u64 * 1024),
            };
            all.extend([(c | i, knot), (c | 4 | i, r.random_range(0..255u64 * 1024))]);
        }
    }
    if r.random_ratio(1, 8) {
        // Without area.
        all.retain(|(select, _)| select & 0xf0 != 0);
        all.extend([0, 1, 2].map(|i| (i, around.0 as u64)));
        all.extend([4, 5, 6].map(|i| (i, r.random_range(0..8_000u64))));
    }
    all
}

fn run(wide: bool, seed: u64, clocks: usize) {
    let core = Core {
        order: Order::QuadraticEngine,
        wide,
        pixels: 1200,
        load_words: 1,
    };
    let mut r = StdRng::seed_from_u64(seed);
    let mut s = CoreSimulator::new(core).unwrap();
    let mut m: CoreModel = core.model();
    let (mut pixels, mut waited) = (0u64, 0u64);
    let mut queue = vec![(11, 40), (12, 30)];
    let mut pause = 0;
    for clock in 0..clocks {
        // Long pauses of the consumer make the engine wait for the core.
        if r.random_ratio(1, 3000) {
            pause = r.random_range(0..2500);
        }
        pause -= i32::from(pause > 0);
        let mut i = CoreInputs {
            clear: r.random_ratio(1, 4000),
            ready: pause == 0 && r.random_ratio(7, 8),
            ..CoreInputs::default()
        };
        if m.outputs().load_ready && r.random_ratio(15, 16) || r.random_ratio(1, 50) {
            if queue.is_empty() {
                queue = triangle(&mut r);
            }
            let (select, data) = queue.remove(0);
            i = CoreInputs {
                write: true,
                select,
                data,
                start: queue.is_empty(),
                ..i
            };
        }
        s.clock(&i);
        m.clock(&i);
        let want = m.outputs();
        assert_eq!(s.outputs(), want, "wide {wide}, clock {clock}");
        pixels += u64::from(want.valid);
        waited += u64::from(!want.load_ready);
    }
    assert!(
        pixels > clocks as u64 / 100 && waited > clocks as u64 / 10,
        "the stimulus must draw and wait: {pixels} pixels, {waited} clocks"
    );
}

#[test]
fn core_of_both_formats() {
    run(false, 35, 10_000 * SCALE);
    run(true, 36, 5_000 * SCALE);
}
