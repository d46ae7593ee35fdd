//! The bump units: factors at every place and cosines against f64, descriptions against their models, and the units in
//! a row against the software's bent normal.

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_hdl::bump::dot::{self, BumpDot};
use shadegate_hdl::bump::fetch::{self, BumpFetch};
use shadegate_hdl::bump::model::{blend, dot, newton, reflection, Bump, MapModel};
use shadegate_hdl::bump::newton::{self, BumpNewton};
use shadegate_hdl::bump::reflection::{self, BumpReflection};
use shadegate_hdl::bump::{DOT_ERROR, NEWTON_ERROR, REFLECTION_ERROR};
use shadegate_hdl::format::{Q, U};
use shadegate_hdl::simulate::Simulator;
use shadegate_reference::bump::normalise;

const CLOCKS: usize = if cfg!(debug_assertions) {
    10_000
} else {
    300_000
};

fn value(code: i64, bits: u32) -> f64 {
    code as f64 / f64::from(1 << bits)
}

/// Both factors against their formulas, for F_u over its whole range and F_v in steps.
#[test]
fn factors_of_every_gradient() {
    let mut worst = [0.0f64; 3];
    for v in (-131_072..131_072i64).step_by(32_768).chain([1, 131_071]) {
        for u in -131_072..131_072i64 {
            let g2 = value(u, 16).powi(2) + value(v, 16).powi(2);
            let step = 1.0 - g2.min(2.0) / 2.0;
            worst[0] = worst[0].max((value(newton(u, v), 16) - step).abs());
            // In the surface from g = 2 on.
            let t = 4.0 / (g2.min(4.0) + 4.0);
            let (across, along) = reflection(u, v);
            worst[1] = worst[1].max((value(across, 16) - t).abs());
            worst[2] = worst[2].max((value(along, 16) - (2.0 * t - 1.0)).abs());
        }
    }
    println!("{worst:?}");
    let bounds = [NEWTON_ERROR, REFLECTION_ERROR, 2.0 * REFLECTION_ERROR];
    for (worst, bound) in worst.into_iter().zip(bounds) {
        assert!(
            worst <= bound && worst > 0.6 * bound,
            "{worst:e} of {bound:e}"
        );
    }
}

/// A unit vector, in codes and not rounded.
fn unit(r: &mut StdRng) -> [f64; 3] {
    loop {
        let v = [0; 3].map(|_| r.random_range(-1.0..1.0f64));
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        if (0.1..1.0).contains(&length) {
            return v.map(|x| x / length);
        }
    }
}

fn code(x: f64, bits: u32) -> i64 {
    (x * f64::from(1 << bits)).round() as i64
}

#[test]
fn cosines_of_random_bumps() {
    let mut r = StdRng::seed_from_u64(81);
    let mut worst = 0.0f64;
    for _ in 0..CLOCKS {
        let light = unit(&mut r).map(|x| code(x, 16));
        let slope = [0; 2].map(|_| r.random_range(-131_072..131_072i64));
        let (across, along) = if r.random() {
            let k = newton(slope[0], slope[1]);
            (k, k)
        } else {
            reflection(slope[0], slope[1])
        };
        let b = Bump {
            slope,
            across,
            along,
            light,
        };
        let slant: f64 = (0..2)
            .map(|i| value(slope[i], 16) * value(light[i], 16))
            .sum();
        let want = value(along, 16) * value(light[2], 16) - value(across, 16) * slant;
        worst = worst.max((value(dot(&b), 16) - want).abs());
    }
    assert!(worst <= DOT_ERROR && worst > 0.5 * DOT_ERROR, "{worst:e}");
}

/// Gradient, factors and cosine in a row against the bent normal of the software, for gradients that it and the units
/// take alike.
#[test]
fn units_in_a_row_against_the_software() {
    let mut r = StdRng::seed_from_u64(82);
    let mut worst = [0.0f64; 2];
    for _ in 0..CLOCKS {
        let light = unit(&mut r);
        let (g, turn) = (r.random_range(0.0..1.3f64), r.random_range(0.0..6.3f64));
        let slope = [g * turn.cos(), g * turn.sin()];
        let codes = slope.map(|s| code(s, 16));
        let k = newton(codes[0], codes[1]);
        let ways = [(k, k), reflection(codes[0], codes[1])];
        let normals = [
            normalise::newton(slope[0], slope[1]),
            normalise::reflection(slope[0], slope[1]),
        ];
        for (i, ((across, along), normal)) in ways.into_iter().zip(normals).enumerate() {
            let b = Bump {
                slope: codes,
                across,
                along,
                light: light.map(|x| code(x, 16)),
            };
            let want: f64 = (0..3).map(|j| normal[j] * light[j]).sum();
            worst[i] = worst[i].max((value(dot(&b), 16) - want).abs());
        }
    }
    println!("{worst:?}");
    // A quarter of 1/1024: a sixteenth of an LSB.
    assert!(worst.iter().all(|w| *w < 1.0 / 4096.0), "{worst:?}");
}

/// A step that is off by one unit in its last place but four is seen.
#[test]
fn the_blend_is_bilinear() {
    let mut r = StdRng::seed_from_u64(83);
    let mut worst = 0.0f64;
    for _ in 0..CLOCKS {
        let samples = [0; 4].map(|_| r.random_range(0..1u64 << 36));
        let (u, v) = (r.random_range(0..1u64 << 18), r.random_range(0..1u64 << 18));
        let got = blend(samples, u, v);
        let (fu, fv) = ((u & 4095) as f64 / 4096.0, (v & 4095) as f64 / 4096.0);
        for (part, got) in [18, 0].into_iter().zip(got) {
            let [a, b, c, d] = samples.map(|s| ((s >> part << 46) as i64 >> 46) as f64);
            let want = (1.0 - fv) * ((1.0 - fu) * a + fu * b) + fv * ((1.0 - fu) * c + fu * d);
            worst = worst.max((got as f64 - want).abs());
        }
    }
    assert!(worst <= 2.0 && worst > 1.5, "{worst}");
}

/// A pipeline of values that moves with `go`.
struct Line<T>(Vec<Option<T>>);

impl<T: Clone> Line<T> {
    fn new(stages: usize) -> Self {
        Self(vec![None; stages])
    }

    fn shift(&mut self, value: T) {
        self.0.rotate_right(1);
        self.0[0] = Some(value);
    }

    fn last(&self) -> Option<&T> {
        self.0.last().and_then(Option::as_ref)
    }
}

fn slope(r: &mut StdRng) -> i64 {
    match r.random_range(0..6) {
        0 => [-131_072, -1, 0, 1, 131_071, 92_682][r.random_range(0..6)],
        _ => r.random_range(-131_072..131_072),
    }
}

#[test]
fn factors_clock_by_clock() {
    let mut r = StdRng::seed_from_u64(84);
    let mut n = Simulator::new(BumpNewton::default()).unwrap();
    let mut m = Simulator::new(BumpReflection::default()).unwrap();
    let (mut ns, mut ms) = (Line::new(newton::STAGES), Line::new(reflection::STAGES));
    for clock in 0..CLOCKS {
        let (go, u, v) = (r.random_ratio(3, 4), slope(&mut r), slope(&mut r));
        n.design.go.next = go;
        n.design.slope_u.next = Q::from_code(u);
        n.design.slope_v.next = Q::from_code(v);
        n.clock();
        m.design.go.next = go;
        m.design.slope_u.next = Q::from_code(u);
        m.design.slope_v.next = Q::from_code(v);
        m.clock();
        if go {
            ns.shift((newton(u, v), u, v));
            ms.shift((reflection(u, v), u, v));
        }
        let d = &n.design;
        let late = (d.late_u.val().code(), d.late_v.val().code());
        if let Some((factor, u, v)) = ns.last() {
            assert_eq!(
                (d.factor.val().code(), late),
                (*factor, (*u, *v)),
                "{clock}"
            );
        }
        let d = &m.design;
        let late = (d.late_u.val().code(), d.late_v.val().code());
        if let Some((factors, u, v)) = ms.last() {
            let got = (d.across.val().code(), d.along.val().code());
            assert_eq!((got, late), (*factors, (*u, *v)), "{clock}");
        }
    }
}

#[test]
fn cosines_clock_by_clock() {
    let mut r = StdRng::seed_from_u64(85);
    let mut s = Simulator::new(BumpDot::default()).unwrap();
    let mut line = Line::new(dot::STAGES);
    for clock in 0..CLOCKS {
        let mut part = || r.random_range(-(1 << 16)..=1i64 << 16);
        let (light, across, along) = ([part(), part(), part()], part(), part());
        let b = Bump {
            slope: [slope(&mut r), slope(&mut r)],
            across,
            along,
            light,
        };
        let go = r.random_ratio(3, 4);
        s.design.go.next = go;
        s.design.slope_u.next = Q::from_code(b.slope[0]);
        s.design.slope_v.next = Q::from_code(b.slope[1]);
        s.design.across.next = Q::from_code(b.across);
        s.design.along.next = Q::from_code(b.along);
        s.design.light_u.next = Q::from_code(b.light[0]);
        s.design.light_v.next = Q::from_code(b.light[1]);
        s.design.light_n.next = Q::from_code(b.light[2]);
        s.clock();
        if go {
            line.shift(dot(&b));
        }
        if let Some(want) = line.last() {
            assert_eq!(s.design.cosine.val().code(), *want, "clock {clock}");
        }
    }
}

/// Samples are written between reads, so reads that meet a write and maps that change are seen too.
#[test]
fn gradients_clock_by_clock() {
    let mut r = StdRng::seed_from_u64(86);
    let mut s = Simulator::new(BumpFetch::default()).unwrap();
    let mut map = MapModel::default();
    // Where a place is after one clock, and what lies there after two.
    let mut first = None;
    let mut rest = Line::new(fetch::STAGES - 1);
    for clock in 0..CLOCKS {
        let (go, write) = (r.random_ratio(3, 4), r.random_ratio(1, 4));
        let (u, v) = (r.random_range(0..1u64 << 18), r.random_range(0..1u64 << 18));
        let (address, data) = (r.random_range(0..1u64 << 12), r.random_range(0..1u64 << 36));
        s.design.go.next = go;
        s.design.u.next = U::new(u);
        s.design.v.next = U::new(v);
        s.design.write.next = write;
        s.design.write_address.next = U::new(address);
        s.design.write_data.next = U::new(data);
        s.clock();
        if go {
            if let Some((u, v)) = first {
                rest.shift(blend(map.samples(u, v), u, v));
            }
            first = Some((u, v));
        }
        if write {
            map.write(address, data);
        }
        if let Some(want) = rest.last() {
            let d = &s.design;
            let got = [d.slope_u.val().code(), d.slope_v.val().code()];
            assert_eq!(got, *want, "clock {clock}");
        }
    }
}
