//! Interpolants with words of 64 bits, the widest: description and model agree in every clock, residues wrap at 64 bits,
//! and a long run stays within its bound.

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_hdl::format::{quantise, Q, U};
use shadegate_hdl::interpolate::constant_1::{Constant1, Constant1Model};
use shadegate_hdl::interpolate::constant_2::{Constant2, Constant2Model};
use shadegate_hdl::interpolate::cubic_1::{Cubic1, Cubic1Model};
use shadegate_hdl::interpolate::linear_1::{Linear1, Linear1Model};
use shadegate_hdl::interpolate::linear_2::{Controls, Linear2, Linear2Model};
use shadegate_hdl::interpolate::quadratic_1::{Quadratic1, Quadratic1Model};
use shadegate_hdl::interpolate::quadratic_2::{Quadratic2, Quadratic2Model};
use shadegate_hdl::interpolate::run::{half_ulps, longest_run};
use shadegate_hdl::simulate::Simulator;

const CLOCKS: usize = if cfg!(debug_assertions) {
    10_000
} else {
    200_000
};

/// Corners of a word of 64 bits, or anything.
fn word(r: &mut StdRng) -> i64 {
    let corners = [
        0,
        1,
        -1,
        i64::MAX,
        i64::MIN,
        i64::MIN + 1,
        0x5555_5555_5555_5555,
    ];
    if r.random_ratio(1, 4) {
        corners[r.random_range(0..corners.len())]
    } else {
        r.random()
    }
}

#[test]
fn one_variate() {
    let mut r = StdRng::seed_from_u64(1);
    let mut c = Simulator::new(Constant1::<11, 52>::default()).unwrap();
    let mut l = Simulator::new(Linear1::<11, 52>::default()).unwrap();
    let mut q = Simulator::new(Quadratic1::<11, 52>::default()).unwrap();
    let mut k = Simulator::new(Cubic1::<11, 52>::default()).unwrap();
    let (mut cm, mut lm) = (Constant1Model::default(), Linear1Model::default());
    let (mut qm, mut km) = (Quadratic1Model::default(), Cubic1Model::default());
    for clock in 0..CLOCKS {
        let (load, run) = (r.random_ratio(1, 16), r.random_ratio(3, 4));
        let w: [i64; 4] = std::array::from_fn(|_| word(&mut r));
        let code = |i: usize| Q::from_code(w[i]);
        c.design.load.next = load;
        c.design.start.next = code(0);
        l.design.load.next = load;
        l.design.run.next = run;
        (l.design.start.next, l.design.step.next) = (code(0), code(1));
        q.design.load.next = load;
        q.design.run.next = run;
        (q.design.start.next, q.design.step.next) = (code(0), code(1));
        q.design.bend.next = code(2);
        k.design.load.next = load;
        k.design.run.next = run;
        (k.design.start.next, k.design.step.next) = (code(0), code(1));
        (k.design.bend.next, k.design.twist.next) = (code(2), code(3));
        c.clock();
        l.clock();
        q.clock();
        k.clock();
        cm.clock(load, w[0]);
        lm.clock(64, load, run, w[0], w[1]);
        qm.clock(64, load, run, w[0], w[1], w[2]);
        km.clock(64, load, run, w);
        let got = [
            c.design.value.val(),
            l.design.value.val(),
            q.design.value.val(),
            k.design.value.val(),
        ];
        let want = [cm.value, lm.value, qm.value, km.value].map(|v| v >> 52);
        assert_eq!(got.map(Q::code), want, "clock {clock}");
    }
}

#[test]
fn two_variate() {
    let mut r = StdRng::seed_from_u64(2);
    let mut c = Simulator::new(Constant2::<64, 11, 52>::default()).unwrap();
    let mut l = Simulator::new(Linear2::<64, 11, 52>::default()).unwrap();
    let mut q = Simulator::new(Quadratic2::<64, 11, 52>::default()).unwrap();
    let (mut cm, mut lm) = (Constant2Model::default(), Linear2Model::default());
    let mut qm = Quadratic2Model::default();
    for clock in 0..CLOCKS {
        let (write, index) = (r.random::<bool>(), r.random_range(0..16usize));
        let data = word(&mut r) as u64;
        let x = Controls {
            load: r.random_ratio(1, 32),
            step: r.random_ratio(1, 8),
            carry: r.random(),
            take: r.random_ratio(1, 8),
            run: r.random_ratio(3, 4),
        };
        let d = &mut c.design;
        (d.write.next, d.data.next) = (write, U::new(data));
        (d.load.next, d.take.next) = (x.load, x.take);
        let d = &mut l.design;
        (d.write.next, d.data.next, d.word.next) = (write, U::new(data), U::new(index as u64));
        (d.load.next, d.step.next, d.carry.next) = (x.load, x.step, x.carry);
        (d.take.next, d.run.next) = (x.take, x.run);
        let d = &mut q.design;
        (d.write.next, d.data.next, d.word.next) = (write, U::new(data), U::new(index as u64));
        (d.load.next, d.step.next, d.carry.next) = (x.load, x.step, x.carry);
        (d.take.next, d.run.next) = (x.take, x.run);
        c.clock();
        l.clock();
        q.clock();
        cm.clock(64, write.then_some(data), x.load, x.take);
        let write = write.then_some((index, data));
        lm.clock(64, write, x);
        qm.clock(64, write, x);
        let got = [
            c.design.value.val(),
            l.design.value.val(),
            q.design.value.val(),
        ];
        let want = [cm.value(), lm.value(), qm.value()].map(|v| v >> 52);
        assert_eq!(got.map(Q::code), want, "clock {clock}");
    }
}

/// A cubic that stays in range for 100 000 pixels, against f64 arithmetic on the words and on the true coefficients.
#[test]
fn a_long_run_stays_within_its_bound() {
    const RUN: u64 = 100_000;
    let n = RUN as f64;
    // f(k) = 900 − 700·t + 4000·t² − 3500·t³ with t = k/n: within ±2048.
    let [c, b, a] = [-700.0 / n, 4000.0 / (n * n), -3500.0 / (n * n * n)];
    let words = [900.0, c + b + a, 2.0 * b + 6.0 * a, 6.0 * a];
    let codes = words.map(|w| quantise(w, 11, 52).unwrap());
    let mut m = Cubic1Model::default();
    m.clock(64, true, false, codes);
    let bound = half_ulps(3, RUN) as f64 * 2f64.powi(-53);
    assert!(bound < 0.25 && longest_run(3, 52, 2).unwrap() >= RUN);
    let mut worst = 0.0f64;
    for k in 0..=RUN {
        let t = k as f64 / n;
        let want = 900.0 + t * (-700.0 + t * (4000.0 - 3500.0 * t));
        worst = worst.max((m.value as f64 * 2f64.powi(-52) - want).abs());
        m.clock(64, false, true, [0; 4]);
    }
    println!("worst {worst:.4} LSB, bound {bound:.4}");
    assert!(worst <= bound + 1e-9 && worst > 0.0);
}

/// Any degree, many lengths: a run of half-ulp errors never leaves the bound, and 24 bits drift where 64 do not.
#[test]
fn short_words_drift_and_wide_ones_do_not() {
    let line = |m: u32, n: u32, steps: u64| {
        let slope = 1000.0 / steps as f64 / 3.0;
        let mut model = Linear1Model::default();
        let width = 1 + (m + n) as usize;
        let (start, step) = (quantise(5.0, m, n).unwrap(), quantise(slope, m, n).unwrap());
        model.clock(width, true, false, start, step);
        for _ in 0..steps {
            model.clock(width, false, true, 0, 0);
        }
        (model.value as f64 / 2f64.powi(n as i32) - (5.0 + slope * steps as f64)).abs()
    };
    assert!(line(11, 12, 1_000_000) > 20.0);
    assert!(line(11, 52, 1_000_000) < 1e-6);
}
