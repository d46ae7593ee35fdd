//! Highlights and spots without tables: every place against the definition in f64, descriptions against their models.

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_hdl::format::{Q, U};
use shadegate_hdl::interpolate::linear_2::Controls;
use shadegate_hdl::light::highlight::{self, Highlight};
use shadegate_hdl::light::kappa_colour::KappaColour;
use shadegate_hdl::light::model::{highlight, spot, LightInputs, LightModel, SkipModel};
use shadegate_hdl::light::skip::Skip;
use shadegate_hdl::light::spot::{self, Spot};
use shadegate_hdl::light::spot_colour::SpotColour;
use shadegate_hdl::light::{DEGREES, HIGHLIGHT_ERROR, SPOT_ERROR};
use shadegate_hdl::simulate::Simulator;

const CLOCKS: usize = if cfg!(debug_assertions) {
    10_000
} else {
    400_000
};

/// What the host makes of a place in units of 2^-17: cut to 2^-19 behind half a unit more or less.
fn sent(place: f64, half: f64) -> i64 {
    ((place + half) * 4.0).floor() as i64
}

/// Largest error over all places from a little before the peak to beyond the edge, in quarters of a unit of 2^-17; and
/// the first place that is skipped.
fn sweep(half: f64, got: impl Fn(i64) -> Option<u64>, want: impl Fn(f64) -> f64) -> (f64, f64) {
    let (mut worst, mut first) = (0.0f64, f64::INFINITY);
    for quarter in -40..(1i64 << 19) + 40 {
        let place = quarter as f64 / 4.0;
        let exact = want(place / f64::from(1 << 17));
        let value = got(sent(place, half));
        if value.is_none() {
            first = first.min(place);
        }
        let value = value.unwrap_or(0) as f64 / f64::from(1 << 17);
        worst = worst.max((value - exact).abs());
    }
    (worst, first)
}

#[test]
fn every_place_of_every_highlight() {
    let mut all = 0.0f64;
    for degree in DEGREES {
        let want = |t: f64| (1.0 - t.clamp(0.0, 1.0)).powi(i32::from(degree));
        let (worst, first) = sweep(-0.5, |p| highlight(degree, p), want);
        assert!(worst <= HIGHLIGHT_ERROR, "{degree}: {worst:e}");
        // Skipped from the edge on, to the rounding of the place.
        assert!(
            (first - f64::from(1 << 17)).abs() <= 0.75,
            "{degree}: {first}"
        );
        all = all.max(worst);
    }
    assert!(
        all > 0.6 * HIGHLIGHT_ERROR,
        "{all:e} of {HIGHLIGHT_ERROR:e}"
    );
}

#[test]
fn every_place_of_both_spots() {
    let mut all = 0.0f64;
    for hard in [false, true] {
        let half = if hard { 0.5 } else { -0.5 };
        let want = |v: f64| {
            let v = v.clamp(0.0, 1.0);
            if hard {
                1.0 - v * v
            } else {
                (1.0 - v) * (1.0 - v)
            }
        };
        let (worst, first) = sweep(half, |p| spot(hard, p), want);
        assert!(worst <= SPOT_ERROR, "{hard}: {worst:e}");
        assert!(
            (first - f64::from(1 << 17)).abs() <= 0.75,
            "{hard}: {first}"
        );
        all = all.max(worst);
    }
    assert!(all > 0.6 * SPOT_ERROR, "{all:e} of {SPOT_ERROR:e}");
}

/// Hast's remark that the function is negative below γ holds for odd degrees alone: far beyond the edge, where the bare
/// formula has grown beyond 1, there is nothing for any degree.
#[test]
fn nothing_comes_back_far_beyond_the_edge() {
    for place in [1 << 19, (1 << 19) + 1, 3 << 19, 100 << 19, (1 << 29) - 1] {
        for degree in DEGREES {
            assert_eq!(highlight(degree, place), None);
        }
        assert_eq!((spot(false, place), spot(true, place)), (None, None));
    }
    // And before the peak everything: cosines a little above 1.
    for place in [-1, -(1 << 19), -(1 << 29)] {
        assert_eq!(highlight(4, place), Some((1 << 17) - 4));
        assert_eq!(spot(true, place), Some((1 << 17) - 1));
    }
}

/// Places that random ones rarely hit.
fn place(r: &mut StdRng) -> i64 {
    match r.random_range(0..8) {
        0 => r.random_range(-(1 << 29)..1 << 29),
        1 => r.random_range(-4..4),
        2 => (1 << 19) + r.random_range(-4..4),
        3 => -(1 << 29),
        _ => r.random_range(0..1 << 19),
    }
}

#[test]
fn units_clock_by_clock() {
    let mut r = StdRng::seed_from_u64(61);
    let mut lobe = Simulator::new(Highlight::default()).unwrap();
    let mut cone = Simulator::new(Spot::default()).unwrap();
    let mut degree = 2;
    let mut hard = false;
    // What is on its way; as at power-up.
    let mut lobes = [Some(0); highlight::STAGES];
    let mut cones = [Some(0); spot::STAGES];
    let mut fresh = 0;
    for clock in 0..CLOCKS {
        // The curves stand still while anything is on its way.
        if clock % 64 == 0 {
            (degree, hard) = (r.random_range(2..=4), r.random());
            fresh = 0;
        }
        let (go, off, at) = (r.random_ratio(3, 4), r.random_ratio(1, 8), place(&mut r));
        lobe.design.go.next = go;
        lobe.design.degree.next = U::new(u64::from(degree));
        lobe.design.place.next = Q::from_code(at);
        lobe.design.off.next = off;
        lobe.clock();
        cone.design.go.next = go;
        cone.design.hard.next = hard;
        cone.design.place.next = Q::from_code(at);
        cone.design.off.next = off;
        cone.clock();
        if go {
            lobes.rotate_right(1);
            lobes[0] = highlight(degree, at).filter(|_| !off);
            cones.rotate_right(1);
            cones[0] = spot(hard, at).filter(|_| !off);
            fresh += 1;
        }
        if fresh >= highlight::STAGES {
            let (d, last) = (&lobe.design, lobes[highlight::STAGES - 1]);
            assert_eq!(
                d.highlight.val().code() as u64,
                last.unwrap_or(0),
                "{clock}"
            );
            assert_eq!(d.skip.val(), last.is_none(), "{clock}");
            let (d, last) = (&cone.design, cones[spot::STAGES - 1]);
            assert_eq!(d.light.val().get(), last.unwrap_or(0), "{clock}");
            assert_eq!(d.out.val(), last.is_none(), "{clock}");
        }
    }
}

#[test]
fn skips_clock_by_clock() {
    let mut r = StdRng::seed_from_u64(62);
    let mut s = Simulator::new(Skip::default()).unwrap();
    let mut m = SkipModel::default();
    for clock in 0..CLOCKS {
        let (write, data): (bool, u64) = (r.random_ratio(1, 4), r.random());
        let c = Controls {
            load: r.random_ratio(1, 4),
            take: r.random_ratio(1, 3),
            ..Controls::default()
        };
        s.design.write.next = write;
        s.design.data.next = U::new(data);
        s.design.load.next = c.load;
        s.design.take.next = c.take;
        s.clock();
        m.clock(write.then_some(data), c);
        let got = (s.design.no_highlight.val(), s.design.no_diffuse.val());
        assert_eq!(got, m.outputs(), "clock {clock}");
    }
}

macro_rules! colours {
    ($name:ident, $type:ident, $has_spot:literal, $seed:literal $(, $cone:ident)?) => {
        #[test]
        fn $name() {
            let mut r = StdRng::seed_from_u64($seed);
            let mut s = Simulator::new($type::default()).unwrap();
            let mut m = LightModel::new($has_spot);
            for clock in 0..CLOCKS / 2 {
                let i = LightInputs {
                    light: r.random_range(-(1 << 18)..1 << 18) >> r.random_range(0..3),
                    place: place(&mut r),
                    cone: place(&mut r),
                    no_highlight: r.random_ratio(1, 8),
                    no_diffuse: r.random_ratio(1, 8),
                };
                let go = r.random_ratio(3, 4);
                let write = r.random_ratio(1, 50).then(|| {
                    let word = r.random_range(0..12usize);
                    let narrow = r.random_ratio(1, 2);
                    (word, r.random::<u32>() as u64 & if narrow { 0x7fff } else { !0 })
                });
                s.design.go.next = go;
                s.design.write.next = write.is_some();
                let (word, data) = write.unwrap_or_default();
                s.design.word.next = U::new(word as u64);
                s.design.data.next = U::new(data);
                s.design.light.next = Q::from_code(i.light);
                s.design.place.next = Q::from_code(i.place);
                $(s.design.$cone.next = Q::from_code(i.cone);)?
                s.design.no_highlight.next = i.no_highlight;
                s.design.no_diffuse.next = i.no_diffuse;
                s.clock();
                m.clock(write, go, &i);
                let d = &s.design;
                let got = [d.red.val().code(), d.green.val().code(), d.blue.val().code()];
                assert_eq!(got, m.levels(), "clock {clock}");
            }
        }
    };
}
colours!(kappa_colours_clock_by_clock, KappaColour, false, 63);
colours!(spot_colours_clock_by_clock, SpotColour, true, 64, cone);
