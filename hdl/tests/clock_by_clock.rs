//! Rung 3 of the verification ladder: every description equals its integer model, every output, every clock, on
//! directed corners and on at least a million random clocks per module (seeded, so a failure repeats).

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_hdl::depth::frame_memory::{FrameMemory, FrameMemoryModel};
use shadegate_hdl::depth::pages::Pages;
use shadegate_hdl::depth::pages_model::{PagesInputs, PagesModel};
use shadegate_hdl::depth::z_buffer::{ZBuffer, ZBufferInputs, ZBufferModel};
use shadegate_hdl::format::{wrap, Q, U};
use shadegate_hdl::interpolate::constant_1::{Constant1, Constant1Model};
use shadegate_hdl::interpolate::constant_2::{Constant2, Constant2Model};
use shadegate_hdl::interpolate::cubic_1::{Cubic1, Cubic1Model};
use shadegate_hdl::interpolate::linear_1::{Linear1, Linear1Model};
use shadegate_hdl::interpolate::linear_2::{Controls, Linear2, Linear2Model};
use shadegate_hdl::interpolate::quadratic_1::{Quadratic1, Quadratic1Model};
use shadegate_hdl::interpolate::quadratic_2::{Quadratic2, Quadratic2Model};
use shadegate_hdl::raster::edge_walk::{EdgeModel, EdgeWalk};
use shadegate_hdl::raster::shell::{Shell, ShellInputs, ShellModel};
use shadegate_hdl::simulate::Simulator;

/// Random clocks per module; debug builds are for finding, not for proving.
const CLOCKS: usize = if cfg!(debug_assertions) {
    20_000
} else {
    1_000_000
};

/// Corner words that random ones rarely hit: zero, ±1 ulp, both ends, alternating bits.
fn word(r: &mut StdRng, width: usize) -> i64 {
    let corners = [
        0,
        1,
        -1,
        i64::MAX,
        i64::MIN,
        i64::MAX >> (64 - width),
        1i64 << (width - 1),
        0x5555_5555_5555_5555,
    ];
    let v = if r.random_ratio(1, 4) {
        corners[r.random_range(0..corners.len())]
    } else {
        r.random()
    };
    wrap(v, width)
}

#[test]
fn constant_1() {
    let mut r = StdRng::seed_from_u64(1);
    let mut s = Simulator::new(Constant1::<11, 12>::default()).unwrap();
    let mut m = Constant1Model::default();
    for clock in 0..CLOCKS {
        let (load, start) = (r.random(), word(&mut r, 24));
        s.design.load.next = load;
        s.design.start.next = Q::from_code(start);
        s.clock();
        m.clock(load, start);
        assert_eq!(s.design.value.val().code(), m.value >> 12, "clock {clock}");
    }
}

#[test]
fn linear_1() {
    let mut r = StdRng::seed_from_u64(2);
    let mut s = Simulator::new(Linear1::<11, 12>::default()).unwrap();
    let mut m = Linear1Model::default();
    for clock in 0..CLOCKS {
        let (load, run) = (r.random_ratio(1, 16), r.random_ratio(3, 4));
        let (start, step) = (word(&mut r, 24), word(&mut r, 24));
        s.design.load.next = load;
        s.design.run.next = run;
        s.design.start.next = Q::from_code(start);
        s.design.step.next = Q::from_code(step);
        s.clock();
        m.clock(24, load, run, start, step);
        assert_eq!(s.design.value.val().code(), m.value >> 12, "clock {clock}");
    }
}

#[test]
fn quadratic_1() {
    let mut r = StdRng::seed_from_u64(3);
    let mut s = Simulator::new(Quadratic1::<11, 20>::default()).unwrap();
    let mut m = Quadratic1Model::default();
    for clock in 0..CLOCKS {
        let (load, run) = (r.random_ratio(1, 16), r.random_ratio(3, 4));
        let (start, step, bend) = (word(&mut r, 32), word(&mut r, 32), word(&mut r, 32));
        s.design.load.next = load;
        s.design.run.next = run;
        s.design.start.next = Q::from_code(start);
        s.design.step.next = Q::from_code(step);
        s.design.bend.next = Q::from_code(bend);
        s.clock();
        m.clock(32, load, run, start, step, bend);
        assert_eq!(s.design.value.val().code(), m.value >> 20, "clock {clock}");
    }
}

#[test]
fn cubic_1() {
    let mut r = StdRng::seed_from_u64(13);
    let mut s = Simulator::new(Cubic1::<11, 28>::default()).unwrap();
    let mut m = Cubic1Model::default();
    for clock in 0..CLOCKS {
        let (load, run) = (r.random_ratio(1, 16), r.random_ratio(3, 4));
        let words: [i64; 4] = std::array::from_fn(|_| word(&mut r, 40));
        s.design.load.next = load;
        s.design.run.next = run;
        s.design.start.next = Q::from_code(words[0]);
        s.design.step.next = Q::from_code(words[1]);
        s.design.bend.next = Q::from_code(words[2]);
        s.design.twist.next = Q::from_code(words[3]);
        s.clock();
        m.clock(40, load, run, words);
        assert_eq!(s.design.value.val().code(), m.value >> 28, "clock {clock}");
    }
}

#[test]
fn constant_2() {
    let mut r = StdRng::seed_from_u64(4);
    let mut s = Simulator::new(Constant2::<24, 11, 12>::default()).unwrap();
    let mut m = Constant2Model::default();
    for clock in 0..CLOCKS {
        let (write, load, take) = (r.random(), r.random_ratio(1, 4), r.random_ratio(1, 4));
        let data = word(&mut r, 24) as u64 & 0xff_ffff;
        s.design.write.next = write;
        s.design.data.next = U::new(data);
        s.design.load.next = load;
        s.design.take.next = take;
        s.clock();
        m.clock(24, write.then_some(data), load, take);
        assert_eq!(
            s.design.value.val().code(),
            m.value() >> 12,
            "clock {clock}"
        );
    }
}

fn controls(r: &mut StdRng) -> Controls {
    Controls {
        load: r.random_ratio(1, 32),
        step: r.random_ratio(1, 8),
        carry: r.random(),
        take: r.random_ratio(1, 8),
        run: r.random_ratio(3, 4),
    }
}

macro_rules! two_variate {
    ($test:ident, $seed:literal, $design:ty, $model:ty, $width:literal, $fraction:literal) => {
        #[test]
        fn $test() {
            let mut r = StdRng::seed_from_u64($seed);
            let mut s = Simulator::new(<$design>::default()).unwrap();
            let mut m = <$model>::default();
            for clock in 0..CLOCKS {
                let (write, index, c) = (
                    r.random_ratio(1, 2),
                    r.random_range(0..16u64),
                    controls(&mut r),
                );
                let data = word(&mut r, $width) as u64 & ((1u64 << $width) - 1);
                let d = &mut s.design;
                d.write.next = write;
                d.word.next = U::new(index);
                d.data.next = U::new(data);
                d.load.next = c.load;
                d.step.next = c.step;
                d.carry.next = c.carry;
                d.take.next = c.take;
                d.run.next = c.run;
                s.clock();
                m.clock($width, write.then_some((index as usize, data)), c);
                assert_eq!(
                    s.design.value.val().code(),
                    m.value() >> $fraction,
                    "clock {clock}"
                );
            }
        }
    };
}
two_variate!(linear_2, 5, Linear2<24, 11, 12>, Linear2Model, 24, 12);
two_variate!(linear_2_depth, 6, Linear2<32, 15, 16>, Linear2Model, 32, 16);
two_variate!(quadratic_2, 7, Quadratic2<32, 11, 20>, Quadratic2Model, 32, 20);
two_variate!(quadratic_2_wide, 8, Quadratic2<36, 11, 24>, Quadratic2Model, 36, 24);

#[test]
fn edge_walk() {
    let mut r = StdRng::seed_from_u64(9);
    let mut s = Simulator::new(EdgeWalk::default()).unwrap();
    let mut m = EdgeModel::default();
    for clock in 0..CLOCKS {
        let words = EdgeModel {
            column: word(&mut r, 12),
            error: word(&mut r, 20),
            whole: word(&mut r, 12),
            up: word(&mut r, 20),
            down: word(&mut r, 20),
        };
        let (load, step) = (r.random_ratio(1, 32), r.random_ratio(3, 4));
        let d = &mut s.design;
        d.load.next = load;
        d.step.next = step;
        d.first_column.next = Q::from_code(words.column);
        d.first_error.next = Q::from_code(words.error);
        d.whole.next = Q::from_code(words.whole);
        d.up.next = Q::from_code(words.up);
        d.down.next = Q::from_code(words.down);
        s.clock();
        m.clock(load.then_some(words), step);
        assert_eq!(s.design.column.val().code(), m.column, "clock {clock}");
        assert_eq!(s.design.carry.val(), m.carry(), "clock {clock}");
    }
}

#[test]
fn frame_memory() {
    let mut r = StdRng::seed_from_u64(10);
    // Not a power of two: the last addresses lie outside.
    let mut s = Simulator::new(FrameMemory::<6>::new(41)).unwrap();
    let mut m = FrameMemoryModel::new(41);
    for clock in 0..CLOCKS {
        let (read, ra) = (r.random(), r.random_range(0..64u64));
        let (write, wa, data) = (
            r.random(),
            if r.random_ratio(1, 4) {
                ra
            } else {
                r.random_range(0..64)
            },
            r.random(),
        );
        let d = &mut s.design;
        d.read.next = read;
        d.read_address.next = U::new(ra);
        d.write.next = write;
        d.write_address.next = U::new(wa);
        d.write_data.next = U::new(u64::from(data));
        s.clock();
        m.clock(read.then_some(ra), write.then_some((wa, data)));
        assert_eq!(
            s.design.read_data.val().get(),
            u64::from(m.read_data),
            "clock {clock}"
        );
    }
}

#[test]
fn pages() {
    let mut r = StdRng::seed_from_u64(13);
    let mut s = Simulator::new(Pages::<6>::new(41)).unwrap();
    let mut m = PagesModel::new(41);
    let mut address = 0;
    for clock in 0..CLOCKS {
        if r.random() {
            address = r.random_range(0..64);
        }
        let i = PagesInputs {
            go: r.random_ratio(7, 8),
            clear: r.random_ratio(1, 30),
            fragment: r.random_ratio(7, 8).then_some(address),
            // Also without a fragment, which no z-buffer does.
            touch: r.random_ratio(3, 4),
        };
        let d = &mut s.design;
        d.go.next = i.go;
        d.clear.next = i.clear;
        d.fragment.next = i.fragment.is_some();
        d.address.next = U::new(address);
        d.touch.next = i.touch;
        s.clock();
        m.clock(&i);
        let d = &s.design;
        let got = (d.held.val(), d.place.val().get(), d.present.val());
        assert_eq!(got, (m.held, m.place, m.present()), "clock {clock}");
        let got = (d.clearing.val(), d.cleared.val());
        assert_eq!(got, (m.clearing(), m.cleared), "clock {clock}");
    }
}

#[test]
fn z_buffer() {
    let mut r = StdRng::seed_from_u64(11);
    let mut s = Simulator::new(ZBuffer::<5>::new(24)).unwrap();
    let mut m = ZBufferModel::new(24);
    let mut address = 0;
    for clock in 0..CLOCKS {
        // Consecutive hits on one address are the hazard: make them common.
        if r.random() {
            address = r.random_range(0..24);
        }
        let i = ZBufferInputs {
            go: r.random_ratio(7, 8),
            clear: r.random_ratio(1, 300),
            fragment: r.random_ratio(3, 4),
            address,
            depth: if r.random() {
                r.random_range(0..8)
            } else {
                r.random()
            },
        };
        let d = &mut s.design;
        d.go.next = i.go;
        d.clear.next = i.clear;
        d.fragment.next = i.fragment;
        d.address.next = U::new(i.address);
        d.depth.next = U::new(u64::from(i.depth));
        s.clock();
        m.clock(&i);
        assert_eq!(s.design.pass.val(), m.pass(), "pass, clock {clock}");
        assert_eq!(
            s.design.waiting.val(),
            m.waiting(),
            "waiting, clock {clock}"
        );
        assert_eq!(
            s.design.cleared.val(),
            m.cleared(),
            "cleared, clock {clock}"
        );
        assert_eq!(
            s.design.tested_depth.val().get(),
            u64::from(m.depth),
            "depth, clock {clock}"
        );
        assert_eq!(
            s.design.clearing.val(),
            m.clearing(),
            "clearing, clock {clock}"
        );
    }
}

/// Register words of a triangle-like shape or of noise.
fn shell_word(r: &mut StdRng, index: usize) -> u64 {
    if r.random_ratio(1, 50) {
        return u64::from(r.random::<u32>());
    }
    let edge =
        |column: i64, error: i64| ((column as u64 & 0xfff) << 20) | (error as u64 & 0xf_ffff);
    match index {
        0 => {
            let rows = r.random_range(0..12u64);
            r.random_range(0..=1u64) << 22 | r.random_range(0..=rows) << 11 | rows
        }
        1 => r.random_range(0..1000u64) << 11 | r.random_range(0..40u64),
        2 | 5 | 8 => edge(r.random_range(-20..20), r.random_range(-500..500)),
        3 | 6 | 9 => edge(r.random_range(-4..4), r.random_range(0..500)),
        4 | 7 | 10 => edge(0, r.random_range(-500..0)),
        _ => r.random_range(1..16),
    }
}

#[test]
fn shell() {
    let mut r = StdRng::seed_from_u64(12);
    let mut s = Simulator::new(Shell::<17>::default()).unwrap();
    let mut m = ShellModel::new(17);
    let mut index = 11;
    let mut fragments = 0u64;
    for clock in 0..CLOCKS {
        let write = r.random_ratio(7, 8);
        if write {
            index = (index + 1) % 12;
        }
        let data = shell_word(&mut r, index);
        let i = ShellInputs {
            write: write.then_some((index, data)),
            start: r.random_ratio(1, 10),
            hold: r.random_ratio(1, 50),
            go: r.random_ratio(7, 8),
        };
        let d = &mut s.design;
        d.write.next = write;
        d.word.next = U::new(index as u64);
        d.data.next = U::new(data);
        d.start.next = i.start;
        d.hold.next = i.hold;
        d.go.next = i.go;
        s.settle();
        let o = m.outputs(&i);
        let d = &s.design;
        assert_eq!(
            d.load_ready.val(),
            o.load_ready,
            "load_ready, clock {clock}"
        );
        let c = Controls {
            load: d.load.val(),
            step: d.step.val(),
            carry: d.carry.val(),
            take: d.take.val(),
            run: d.run.val(),
        };
        assert_eq!(c, o.controls, "controls, clock {clock}");
        assert_eq!(d.fragment.val(), o.fragment, "fragment, clock {clock}");
        assert_eq!(d.x.val().get(), o.x, "x, clock {clock}");
        assert_eq!(d.y.val().get(), o.y, "y, clock {clock}");
        assert_eq!(d.address.val().get(), o.address, "address, clock {clock}");
        assert_eq!(d.busy.val(), o.busy, "busy, clock {clock}");
        fragments += u64::from(o.fragment);
        s.clock();
        m.clock(&i);
    }
    assert!(
        fragments > CLOCKS as u64 / 200,
        "the stimulus must draw: {fragments} fragments"
    );
}
