//! Every unit equals its integer model, every output, every clock, on random words and controls with many corner words.

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_hdl::depth::frame_memory::{ColourMemory, ColourMemoryModel};
use shadegate_hdl::format::{wrap, Q, U};
use shadegate_hdl::line::blend::{blend_model, Blend};
use shadegate_hdl::line::box_weight::{BoxModel, BoxWeight};
use shadegate_hdl::line::cone_stages::{ConeStages, ConeStagesModel};
use shadegate_hdl::line::coverage::table;
use shadegate_hdl::line::cue::{Cue, CueModel};
use shadegate_hdl::line::place::{place_model, LanePlace, Placed};
use shadegate_hdl::line::walk::LineWalk;
use shadegate_hdl::line::walk_model::{WalkControls, WalkInputs, WalkModel, WalkPosition};
use shadegate_hdl::line::weight_rom::{WeightModel, WeightRom};
use shadegate_hdl::simulate::Simulator;

const CLOCKS: usize = if cfg!(debug_assertions) {
    20_000
} else {
    400_000
};

/// A register word: ends of the range, zero, ±1, or anything.
fn word(r: &mut StdRng) -> u64 {
    let corners = [0, 1, 0xffff_ffff, 0x8000_0000, 0x7fff_ffff, 0x2000, 0x1fff];
    if r.random_ratio(1, 4) {
        corners[r.random_range(0..corners.len())]
    } else {
        u64::from(r.random::<u32>())
    }
}

fn walk_word(r: &mut StdRng, index: usize) -> u64 {
    if r.random_ratio(1, 50) {
        return word(r);
    }
    let small = |r: &mut StdRng| r.random_range(-60..60i64) as u64;
    match index {
        0 => r.random_range(0..16u64) << 11 | r.random_range(0..9),
        3..=5 => small(r),
        11 => r.random_range(1..64u64) << 12 | r.random_range(1..64),
        _ => (small(r) & 0xfff) << 12 | small(r) & 0xfff,
    }
}

#[test]
fn walk() {
    let mut r = StdRng::seed_from_u64(1);
    let mut s = Simulator::new(LineWalk::<17>::default()).unwrap();
    let mut m = WalkModel::new(17);
    let mut pixels = 0u64;
    for clock in 0..CLOCKS {
        let index = r.random_range(0..13usize);
        let i = WalkInputs {
            write: r
                .random_ratio(3, 4)
                .then(|| (index, walk_word(&mut r, index))),
            start: r.random_ratio(1, 6),
            hold: r.random_ratio(1, 50),
            go: r.random_ratio(7, 8),
            whole: r.random_ratio(1, 8),
        };
        let d = &mut s.design;
        d.write.next = i.write.is_some();
        d.word.next = U::new(index as u64);
        d.data.next = U::new(i.write.map_or(77, |w| w.1));
        d.start.next = i.start;
        d.hold.next = i.hold;
        d.go.next = i.go;
        d.whole.next = i.whole;
        s.settle();
        let d = &s.design;
        let c = WalkControls {
            load: d.load.val(),
            run: d.run.val(),
            turn: d.turn.val(),
            rises: d.rises.val(),
        };
        assert_eq!(c, m.controls(&i), "controls, clock {clock}");
        assert_eq!(d.load_ready.val(), !m.pending, "load_ready, clock {clock}");
        assert_eq!(d.active.val(), m.active, "active, clock {clock}");
        assert_eq!(d.busy.val(), m.active || m.pending, "busy, clock {clock}");
        let at = &m.at;
        let got = (
            d.lane.val().get(),
            d.last_lane.val().get(),
            d.address.val().get(),
        );
        assert_eq!(got, (at.lane, at.last_lane, at.address), "clock {clock}");
        let got = (d.major.val().code(), d.minor.val().code());
        assert_eq!(got, (at.major, at.minor), "clock {clock}");
        assert_eq!((d.steep.val(), d.falling.val()), (at.steep, at.falling));
        let frame = [d.frame_width.val().code(), d.frame_height.val().code()];
        assert_eq!(frame, m.frame, "frame, clock {clock}");
        pixels += u64::from(m.active);
        s.clock();
        m.clock(&i);
    }
    assert!(
        pixels > CLOCKS as u64 / 4,
        "the stimulus must walk: {pixels}"
    );
}

#[test]
fn place() {
    use rust_hdl_core::prelude::*;
    let mut r = StdRng::seed_from_u64(2);
    let mut d = LanePlace::<17>::default();
    d.connect_all();
    check_all(&d).unwrap();
    for _ in 0..20_000 {
        let coordinate = |r: &mut StdRng| {
            let any = r.random_range(-2048..2048);
            [-2, -1, 0, 1, 62, 63, 64, -2048, 2047, any][r.random_range(0..10)]
        };
        let at = WalkPosition {
            steep: r.random(),
            falling: r.random(),
            major: coordinate(&mut r),
            minor: coordinate(&mut r),
            address: r.random_range(0..1 << 17),
            ..WalkPosition::default()
        };
        let (lane, below) = (r.random_range(0..4), r.random());
        let frame = [r.random_range(0..70), 64];
        d.lane.next = U::new(lane);
        d.below.next = below;
        d.major.next = Q::from_code(at.major);
        d.minor.next = Q::from_code(at.minor);
        d.address.next = U::new(at.address);
        d.steep.next = at.steep;
        d.falling.next = at.falling;
        d.frame_width.next = Q::from_code(frame[0]);
        d.frame_height.next = Q::from_code(frame[1]);
        assert!(simulate(&mut d, 20));
        let got = Placed {
            x: d.x.val().get(),
            y: d.y.val().get(),
            address: d.place.val().get(),
            inside: d.in_frame.val(),
        };
        assert_eq!(
            got,
            place_model(&at, lane, below, frame, 17),
            "{at:?} {lane}"
        );
    }
}

#[test]
fn cue() {
    let mut r = StdRng::seed_from_u64(3);
    let mut s = Simulator::new(Cue::default()).unwrap();
    let mut m = CueModel::default();
    for clock in 0..CLOCKS {
        let write = r
            .random::<bool>()
            .then(|| (r.random_range(0..4usize), word(&mut r)));
        let (load, advance) = (r.random_ratio(1, 16), r.random_ratio(3, 4));
        s.design.write.next = write.is_some();
        s.design.word.next = U::new(write.map_or(0, |w| w.0 as u64));
        s.design.data.next = U::new(write.map_or(9, |w| w.1));
        s.design.load.next = load;
        s.design.advance.next = advance;
        s.clock();
        m.clock(write, load, advance);
        assert_eq!(
            s.design.level.val().get(),
            u64::from(m.level()),
            "clock {clock}"
        );
    }
}

#[test]
fn box_weight() {
    let mut r = StdRng::seed_from_u64(4);
    let mut s = Simulator::new(BoxWeight::default()).unwrap();
    let mut m = BoxModel::default();
    let mut ties = 0;
    for clock in 0..CLOCKS {
        let index = r.random_range(4..12usize);
        let data = if r.random() {
            word(&mut r)
        } else {
            r.random_range(-4..4i64) as u64 & 0x3fff
        };
        let write = r.random::<bool>().then_some((index, data));
        let (load, advance, rises) = (r.random_ratio(1, 16), r.random_ratio(3, 4), r.random());
        let upper = r.random();
        s.design.write.next = write.is_some();
        s.design.word.next = U::new(index as u64);
        s.design.data.next = U::new(data);
        s.design.load.next = load;
        s.design.advance.next = advance;
        s.design.rises.next = rises;
        s.design.upper.next = upper;
        s.clock();
        m.clock(write, load, advance, rises);
        assert_eq!(
            s.design.weight.val().get(),
            u64::from(m.weight(upper)),
            "clock {clock}"
        );
        ties += u32::from(m.weight(false) != !m.weight(true));
    }
    assert!(ties > 100);
}

#[test]
fn cone_stages() {
    let mut r = StdRng::seed_from_u64(5);
    let mut s = Simulator::new(ConeStages::default()).unwrap();
    let mut m = ConeStagesModel::default();
    for clock in 0..CLOCKS {
        let index = r.random_range(5..11usize);
        let write = r.random::<bool>().then(|| (index, word(&mut r)));
        let c = WalkControls {
            load: r.random_ratio(1, 32),
            run: r.random_ratio(7, 8),
            turn: r.random_ratio(1, 3),
            rises: r.random(),
        };
        let lane = r.random_range(0..4u64);
        let d = &mut s.design;
        d.write.next = write.is_some();
        d.word.next = U::new(index as u64);
        d.data.next = U::new(write.map_or(3, |w| w.1));
        d.load.next = c.load;
        d.run.next = c.run;
        d.turn.next = c.turn;
        d.rises.next = c.rises;
        d.lane.next = U::new(lane);
        s.clock();
        m.clock(write, c, lane);
        assert_eq!(
            s.design.index.val().get(),
            m.index() as u64,
            "clock {clock}"
        );
        assert_eq!(s.design.below.val(), m.below(), "clock {clock}");
    }
}

fn weight_rom<const I: usize>(seed: u64) {
    let mut r = StdRng::seed_from_u64(seed);
    let mut s = Simulator::new(WeightRom::<I>::default()).unwrap();
    let mut m = WeightModel::new(I as u32 - 1);
    for clock in 0..20_000 {
        let (read, index) = (r.random(), r.random_range(0..1usize << I));
        s.design.read.next = read;
        s.design.index.next = U::new(index as u64);
        s.clock();
        m.clock(read.then_some(index));
        assert_eq!(
            s.design.weight.val().get(),
            u64::from(m.weight),
            "clock {clock}"
        );
    }
}

#[test]
fn weights_of_every_size() {
    weight_rom::<4>(1);
    weight_rom::<5>(2);
    weight_rom::<7>(3);
    weight_rom::<9>(4);
    // The renderer's tables are computed on their own.
    for bits in 1..=12 {
        let theirs = shadegate_reference::line::coverage::Table::new(bits, 255);
        let ours: Vec<u16> = table(bits).into_iter().map(u16::from).collect();
        assert_eq!(ours, theirs.levels(), "{bits} fraction bits");
    }
}

#[test]
fn blend() {
    let mut r = StdRng::seed_from_u64(6);
    let mut s = Simulator::new(Blend::default()).unwrap();
    let mut want = None;
    for clock in 0..CLOCKS {
        let go = r.random_ratio(3, 4);
        let byte = |r: &mut StdRng| {
            let any = r.random();
            [0u8, 255, 1, 254, any, any, any][r.random_range(0..7)]
        };
        let [old, new, weight] = [byte(&mut r), byte(&mut r), byte(&mut r)];
        s.design.go.next = go;
        s.design.old.next = U::new(u64::from(old));
        s.design.target.next = U::new(u64::from(new));
        s.design.weight.next = U::new(u64::from(weight));
        s.clock();
        if go {
            want = Some(blend_model(old, new, weight));
        }
        if let Some(want) = want {
            assert_eq!(s.design.level.val().get(), u64::from(want), "clock {clock}");
        }
    }
}

#[test]
fn colour_memory() {
    let mut r = StdRng::seed_from_u64(7);
    let mut s = Simulator::new(ColourMemory::<6>::new(41)).unwrap();
    let mut m = ColourMemoryModel::new(41);
    for clock in 0..CLOCKS / 4 {
        let at = r.random_range(0..64u64);
        let read = r.random::<bool>().then_some(at);
        let to = if r.random_ratio(1, 4) {
            at
        } else {
            r.random_range(0..64)
        };
        let write = r.random::<bool>().then(|| (to, r.random::<u32>() >> 8));
        let d = &mut s.design;
        d.read.next = read.is_some();
        d.read_address.next = U::new(at);
        d.write.next = write.is_some();
        d.write_address.next = U::new(to);
        d.write_data.next = U::new(write.map_or(5, |w| u64::from(w.1)));
        s.clock();
        m.clock(read, write);
        assert_eq!(
            s.design.read_data.val().get(),
            u64::from(m.read_data),
            "clock {clock}"
        );
    }
}

/// The Q1.30 words wrap as an adder does; the model and the format agree on that.
#[test]
fn distances_are_residues() {
    for v in [-(1i64 << 31), (1 << 31) - 1, 1 << 31, 3 << 30] {
        assert_eq!(Q::<1, 30>::from_code(v).code(), wrap(v, 32));
    }
}
