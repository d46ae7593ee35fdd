//! Slerp of the normal along a span, for N·L and N·H at once (Hast, Barrera and Bengtsson 2003; Hast 2004, section 3.2):
//! I(t) = I_a·cos(tθ) + I_t·sin(tθ), I_a = N_a·L, I_t = (N_b·L − (N_a·N_b)(N_a·L))/sin θ (eqs 3.28–3.31), the highlight
//! its power. For near lights the ends are those of a [`Sweep`], which makes N·L of two turning vectors an oscillation.
//!
//! | method | recurrence | per pixel and term | ends of spans |
//! |---|---|---|---|
//! | `slerp` | differences | 1 mul 2 add | blended, at pixel centres |
//! | `slerp-chebyshev` | Chebyshev, 3.38–3.45 | 1 mul 1 add 2 moves | the same |
//! | `slerp-de-moivre` | powers of a complex number, 3.32–3.37 | 6 mul 3 add | slerped along the edges |
//! | `slerp-trig-free` | differences, set up without a root, sine or arc cosine (3.85–3.88) | 1 mul 2 add | blended, at pixel centres |
//!
//! Per span: 4 dots, 1 angle, 2 sines and cosines (trig-free: 1 division). Per triangle: nothing but arcs for slerped
//! edges. A highlight takes one power per pixel more. A span of one pixel needs none of it: the first value is exact.
//!
//! The trig-free set-up misses the last pixel's cosine by 0.01, 0.15, 0.76, 3.6 and 10 LSB for θ of 10, 20, 30, 45 and
//! 60°: a seam above 30°.

use super::case::Case;
use super::circular::{Circular, Factor, Response};
use super::ends::{self, Blended, Slerped};
use super::recurrence::{Chebyshev, DeMoivre, Difference, Recurrence};
use super::sweep::Sweep;

/// `slerp`: differences.
pub type Slerp = Circular<Blended, Differences>;
/// `slerp-chebyshev`.
pub type SlerpChebyshev = Circular<Blended, Chebyshevs>;
/// `slerp-de-moivre`.
pub type SlerpDeMoivre = Circular<Slerped, DeMoivres>;
/// `slerp-trig-free`.
pub type SlerpTrigFree = Circular<Blended, TrigFree>;

/// Recurrence on differences.
pub struct Differences;
/// Chebyshev's recurrence.
pub struct Chebyshevs;
/// De Moivre's recurrence.
pub struct DeMoivres;
/// Recurrence on differences with the set-up of section 3.2.7.
pub struct TrigFree;

/// `slerp` for any scene.
pub const SLERP: Slerp = Circular {
    ends: Blended,
    response: Differences,
};
/// `slerp-chebyshev` for any scene.
pub const CHEBYSHEV: SlerpChebyshev = Circular {
    ends: Blended,
    response: Chebyshevs,
};
/// `slerp-de-moivre` for any scene.
pub const DE_MOIVRE: SlerpDeMoivre = Circular {
    ends: Slerped,
    response: DeMoivres,
};
/// `slerp-trig-free` for any scene.
pub const TRIG_FREE: SlerpTrigFree = Circular {
    ends: Blended,
    response: TrigFree,
};

/// max(0, I).
#[derive(Clone, Copy, Debug)]
pub struct Cosine<R>(R);

impl<R: Recurrence<Value = f64>> Factor for Cosine<R> {
    fn value(&self) -> f64 {
        self.0.value().clamp(0.0, 1.0)
    }

    fn step(&mut self) {
        self.0.step();
    }
}

/// max(0, I)ⁿ.
#[derive(Clone, Copy, Debug)]
pub struct Power<R> {
    cosine: R,
    n: f64,
}

impl<R: Recurrence<Value = f64>> Factor for Power<R> {
    fn value(&self) -> f64 {
        let cos = self.cosine.value();
        if cos > 0.0 {
            cos.min(1.0).powf(self.n)
        } else {
            0.0
        }
    }

    fn step(&mut self) {
        self.cosine.step();
    }
}

/// How a recurrence is set up.
pub trait Start {
    /// Which recurrence.
    type Recurrence: Recurrence<Value = f64>;

    /// At the first pixel of a span.
    fn start(s: &Sweep) -> Self::Recurrence;
}

impl Start for Differences {
    type Recurrence = Difference<f64>;

    fn start(s: &Sweep) -> Difference<f64> {
        let (g, y) = (s.angle(), s.quadrature());
        let value = |t: f64| {
            let (sin, cos) = (t * g).sin_cos();
            s.from * cos + y * sin
        };
        // I(t) − I(t − K) = 2·sin(K/2)·I'(t − K/2) without the cancellation.
        let half = (0.5 * s.step * g).sin();
        let (sin, cos) = ((s.first - 0.5 * s.step) * g).sin_cos();
        Difference {
            value: value(s.first),
            change: 2.0 * half * (y * cos - s.from * sin),
            kappa: 4.0 * half * half,
        }
    }
}

impl Start for Chebyshevs {
    type Recurrence = Chebyshev<f64>;

    fn start(s: &Sweep) -> Chebyshev<f64> {
        let (g, y) = (s.angle(), s.quadrature());
        let value = |t: f64| {
            let (sin, cos) = (t * g).sin_cos();
            s.from * cos + y * sin
        };
        Chebyshev {
            current: value(s.first),
            previous: value(s.first - s.step),
            twice: 2.0 * (s.step * g).cos(),
        }
    }
}

impl Start for DeMoivres {
    type Recurrence = DeMoivre<f64>;

    fn start(s: &Sweep) -> DeMoivre<f64> {
        let g = s.angle();
        let turned = |t: f64| {
            let (sin, cos) = (t * g).sin_cos();
            (cos, sin)
        };
        DeMoivre {
            along: (s.from, s.quadrature()),
            z: turned(s.first),
            unit: turned(s.step),
        }
    }
}

impl Start for TrigFree {
    type Recurrence = Difference<f64>;

    /// With 1/k the step: κ = 2(1 − c)/k², I₋₁ = I_a(1 + (c − 1)/k²) − (I_b − c·I_a)(3k² − 1 + c)/(k³(2 + c)). The first
    /// pixel is at the left end, as [`Blended`] has it. No c makes it singular.
    fn start(s: &Sweep) -> Difference<f64> {
        let (c, h) = (s.cos, s.step);
        let less = (1.0 - c) * h * h;
        let ratio = h * (3.0 - less) / (2.0 + c);
        Difference {
            value: s.from,
            change: s.from * less + (s.to - c * s.from) * ratio,
            kappa: 2.0 * less,
        }
    }
}

impl<T: Start + Sync> Response for T {
    type Diffuse<'a>
        = Cosine<T::Recurrence>
    where
        T: 'a;
    type Specular<'a>
        = Power<T::Recurrence>
    where
        T: 'a;

    fn diffuse<'a>(&'a self, s: &Sweep) -> Self::Diffuse<'a> {
        Cosine(T::start(s))
    }

    fn specular<'a>(&'a self, s: &Sweep, _: usize, n: f64) -> Self::Specular<'a> {
        Power {
            cosine: T::start(s),
            n,
        }
    }
}

/// Bound on |method − truth|, LSB, of `slerp`. Proved, up to a spread of 90°: [`ends::span_lag`].
#[must_use]
pub fn bound(case: &Case) -> f64 {
    let [d, s] = ends::strays(case, ends::span_lag, true);
    case.terms(d, s)
}

/// What Chebyshev's recurrence drifts by in f64 over k = 16 384 pixels, the widest picture: every step and the rounding
/// of 2·cos K add at most two units of 2⁻⁵³ to the second difference, in all k²/2 of them.
const DRIFT: f64 = 16_384.0 * 16_384.0 * f64::EPSILON;

/// The same for `slerp-chebyshev`, whose drift comes on top.
#[must_use]
pub fn bound_chebyshev(case: &Case) -> f64 {
    bound(case) + case.cosine(DRIFT)
}

/// The same for `slerp-de-moivre`, with slerped edges: [`ends::triangle_lag`].
#[must_use]
pub fn bound_de_moivre(case: &Case) -> f64 {
    super::spherical::bound(case)
}

/// The same for `slerp-trig-free`; what its set-up misses, [`trig_free_miss`], comes on top. With xⁿ convex, an error e of
/// the cosine is one of at most 1 − (1 − e)ⁿ of its power.
#[must_use]
pub fn bound_trig_free(case: &Case) -> f64 {
    let turn = case.spread + case.turn;
    if turn > std::f64::consts::FRAC_PI_2 || case.shininess < 1.0 {
        return case.whole();
    }
    let miss = trig_free_miss(turn).min(1.0);
    let [d, s] = ends::strays(case, ends::span_lag, true);
    let power = 1.0 - (1.0 - miss).powf(case.shininess);
    case.terms((d + miss).min(1.0), (s + power).min(1.0))
}

/// Longest span for which the miss is worked out; it hardly depends on the length.
const LONGEST: u32 = 64;

/// What the trig-free set-up adds to the error of N·L for a turn of `g` rad. I is linear in I_a and I_b, both at most 1
/// in size, so it is the sum of both coefficients' errors; the largest over spans of 1, 2, 4 … [`LONGEST`] steps
/// (tested on all lengths up to 512).
#[must_use]
pub fn trig_free_miss(g: f64) -> f64 {
    (0..=LONGEST.ilog2())
        .map(|i| miss(g, 1 << i))
        .fold(0.0, f64::max)
        * 1.001
}

/// The same for one length.
fn miss(g: f64, k: u32) -> f64 {
    let (sin, cos) = g.sin_cos();
    let sweep = |from: f64, to: f64| Sweep {
        from,
        to,
        cos,
        sin,
        first: 0.0,
        step: 1.0 / f64::from(k),
    };
    let [a, b] = [(1.0, 0.0), (0.0, 1.0)].map(|(f, t)| sweep(f, t));
    let pairs = [
        (TrigFree::start(&a), Differences::start(&a)),
        (TrigFree::start(&b), Differences::start(&b)),
    ];
    let mut pairs = pairs;
    let mut worst = 0.0f64;
    for _ in 0..=k {
        let sum: f64 = pairs
            .iter()
            .map(|(t, d)| (t.value() - d.value()).abs())
            .sum();
        worst = worst.max(sum);
        for (t, d) in &mut pairs {
            t.step();
            d.step();
        }
    }
    worst
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shade::turn::Arc;
    use glam::DVec3;
    use proptest::prelude::*;

    fn unit() -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-1.0..1.0f64)
            .prop_map(DVec3::from)
            .prop_filter_map("no direction", DVec3::try_normalize)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(300))]
        #[test]
        fn recurrences_are_the_slerp_at_every_pixel(a in unit(), b in unit(), v in unit(), k in 1u32..2048) {
            prop_assume!(a.dot(b) > -0.9);
            let s = Sweep::new([a, b], [v; 2], 0.0, 1.0 / f64::from(k));
            let (mut d, mut c, mut m) = (Differences::start(&s), Chebyshevs::start(&s), DeMoivres::start(&s));
            let arc = Arc::new(a, b);
            // End points exact: the first as a number, the last to the drift of f64.
            prop_assert_eq!(d.value(), a.dot(v));
            prop_assert_eq!(c.value(), a.dot(v));
            prop_assert_eq!(m.value(), a.dot(v));
            for i in 0..=k {
                let want = arc.at(f64::from(i) / f64::from(k)).dot(v);
                prop_assert!((d.value() - want).abs() < 1e-11, "difference {i}");
                prop_assert!((c.value() - want).abs() < 1e-8, "Chebyshev {i}");
                prop_assert!((m.value() - want).abs() < 1e-11, "De Moivre {i}");
                d.step();
                c.step();
                m.step();
            }
        }
    }

    /// The row of the notes on the last pixel: degrees, LSB of a full-scale diffuse term at its worst.
    #[test]
    fn the_trig_free_set_up_misses_the_end_as_measured() {
        for (degrees, want) in [
            (10.0, 0.01),
            (20.0, 0.15),
            (30.0, 0.76),
            (45.0, 3.6),
            (60.0, 10.3),
            (90.0, 39.8),
        ] {
            let g = f64::to_radians(degrees);
            let mut worst = 0.0f64;
            for k in [1u32, 2, 3, 8, 64, 1000] {
                for i in 0..360 {
                    let at = f64::from(i).to_radians();
                    let v = DVec3::new(at.cos(), at.sin(), 0.0);
                    let (a, b) = (DVec3::X, DVec3::new(g.cos(), g.sin(), 0.0));
                    // Where both ends are lit.
                    if a.dot(v) < 0.0 || b.dot(v) < 0.0 {
                        continue;
                    }
                    let s = Sweep::new([a, b], [v; 2], 0.0, 1.0 / f64::from(k));
                    let mut t = TrigFree::start(&s);
                    (0..k).for_each(|_| t.step());
                    worst = worst.max(255.0 * (t.value() - b.dot(v)).abs());
                }
            }
            println!(
                "{degrees} deg: {worst:.2} LSB, bound {:.2}",
                255.0 * trig_free_miss(g)
            );
            assert!(worst <= 255.0 * trig_free_miss(g));
            assert!(
                (worst - want).abs() <= 0.01 + 0.15 * want,
                "{degrees}: {worst}"
            );
        }
    }

    #[test]
    fn the_miss_is_bounded_for_every_length_and_grows_with_the_turn() {
        let mut last = 0.0;
        for degrees in [1.0, 5.0, 15.0, 30.0, 60.0, 90.0] {
            let g = f64::to_radians(degrees);
            let bound = trig_free_miss(g);
            for k in 1..=512 {
                assert!(miss(g, k) <= bound, "{degrees} {k}: {} {bound}", miss(g, k));
            }
            assert!(bound > last);
            last = bound;
        }
    }

    #[test]
    fn ends_that_do_not_differ_and_spans_of_one_pixel_give_no_nan() {
        for (a, b) in [
            (DVec3::X, DVec3::X),
            (DVec3::X, DVec3::NEG_X),
            (DVec3::X, DVec3::Y),
        ] {
            for step in [0.0, 0.25, 1.0] {
                let s = Sweep::new([a, b], [DVec3::X; 2], 0.0, step);
                let mut all: [Box<dyn Recurrence<Value = f64>>; 4] = [
                    Box::new(Differences::start(&s)),
                    Box::new(Chebyshevs::start(&s)),
                    Box::new(DeMoivres::start(&s)),
                    Box::new(TrigFree::start(&s)),
                ];
                for r in &mut all {
                    assert_eq!(r.value(), 1.0);
                    for _ in 0..4 {
                        r.step();
                        assert!(r.value().is_finite());
                    }
                }
            }
        }
    }
}
