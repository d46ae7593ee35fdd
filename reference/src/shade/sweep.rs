//! A dot product of two unit vectors along a span, as simultaneous spherical interpolation sees it.
//!
//! While one vector stays and the other turns by g from the left end to the right one,
//!
//!   cos θ(t) = [sin((1 − t)g)·cos θ₁ + sin(t·g)·cos θ₂] / sin g = cos θ₁·cos(tg) + y·sin(tg) = A·cos(tg − α),
//!   y = (cos θ₂ − cos θ₁·cos g)/sin g,  A = √(cos²θ₁ + y²),  α = atan2(y, cos θ₁)
//!
//! (Abbas 2003, eqs 6.6–6.8; Blake, Disselkoen and Kuijk 1992, eqs 5–8 with A = cos γ; Hast 2004, eqs 3.28–3.31 with
//! y = N_t·L). The form with y needs no rule for the sign of α, unlike the printed ones. When both vectors turn, the end
//! pair is rotated so that the one that turns less comes to rest; the ends stay exact, the middle does not (up to 0.18
//! in the cosine when both turn by 45° and more).

use super::turn::{carry, directions};
use glam::DVec3;
use std::f64::consts::TAU;

/// Below this sine the turn is too small for its plane to matter: y only adds up to g·1.
const STILL: f64 = 1e-8;

/// A dot product between the ends of a span.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sweep {
    /// cos θ₁, at the left end.
    pub from: f64,
    /// cos θ₂, at the right end.
    pub to: f64,
    /// cos g.
    pub cos: f64,
    /// sin g, not negative.
    pub sin: f64,
    /// Where the first pixel centre lies: 0 at the left end, 1 at the right one.
    pub first: f64,
    /// From one pixel centre to the next.
    pub step: f64,
}

/// The same as an oscillation: A·cos of a phase that grows evenly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phase {
    /// A, 0..=1.
    pub amplitude: f64,
    /// tg − α at the first pixel, rad; turned so that the whole span lies within ±3π/2 and no second crest appears.
    pub phase: f64,
    /// From one pixel to the next, rad, not negative.
    pub step: f64,
}

impl Sweep {
    /// The dot product of normals `n` and vectors `v` at the two ends; `first` and `step` as in the fields.
    #[must_use]
    pub fn new(n: [DVec3; 2], v: [DVec3; 2], first: f64, step: f64) -> Self {
        let v: [DVec3; 2] = directions(v[0], v[1]).into();
        let (still, moving) = if v[0].dot(v[1]) >= n[0].dot(n[1]) {
            (v, n)
        } else {
            (n, v)
        };
        // Only when both ends of both are opposite is there nothing to rotate by.
        let end = carry(moving[1], still[1], still[0]).unwrap_or(moving[1]);
        Self {
            from: n[0].dot(v[0]),
            to: n[1].dot(v[1]),
            cos: moving[0].dot(end),
            sin: moving[0].cross(end).length(),
            first,
            step,
        }
    }

    /// g, rad, 0..=π.
    #[must_use]
    pub fn angle(&self) -> f64 {
        self.sin.atan2(self.cos)
    }

    /// y: the dot product a quarter of a turn after the left end.
    #[must_use]
    pub fn quadrature(&self) -> f64 {
        if self.sin > STILL {
            (self.to - self.from * self.cos) / self.sin
        } else {
            0.0
        }
    }

    /// Amplitude and phase.
    #[must_use]
    pub fn phase(&self) -> Phase {
        let (g, y) = (self.angle(), self.quadrature());
        let alpha = y.atan2(self.from);
        let turns = ((0.5 * g - alpha) / TAU).round();
        Phase {
            amplitude: self.from.hypot(y).min(1.0),
            phase: self.first * g - alpha - turns * TAU,
            step: self.step * g,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shade::turn::Arc;
    use proptest::prelude::*;

    fn unit() -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-1.0..1.0f64)
            .prop_map(DVec3::from)
            .prop_filter_map("no direction", DVec3::try_normalize)
    }

    proptest! {
        #[test]
        fn with_one_vector_at_rest_it_is_the_slerp(a in unit(), b in unit(), v in unit(), t in 0.0..1.0f64) {
            prop_assume!(a.dot(b) > -0.999);
            let arc = Arc::new(a, b);
            let p = Sweep::new([a, b], [v, v], t, 0.0).phase();
            prop_assert!((p.amplitude * p.phase.cos() - arc.at(t).dot(v)).abs() < 1e-10);
            let p = Sweep::new([v, v], [a, b], t, 0.0).phase();
            prop_assert!((p.amplitude * p.phase.cos() - arc.at(t).dot(v)).abs() < 1e-10);
            prop_assert!(p.phase.abs() <= 1.5 * std::f64::consts::PI + 1e-12);
        }

        #[test]
        fn the_ends_are_exact_whatever_turns(n in [unit(), unit()], v in [unit(), unit()]) {
            prop_assume!(v[0].dot(v[1]).max(n[0].dot(n[1])) > -0.99);
            let (l, r) = (Sweep::new(n, v, 0.0, 0.0).phase(), Sweep::new(n, v, 1.0, 0.0).phase());
            prop_assert!((l.amplitude * l.phase.cos() - n[0].dot(v[0])).abs() < 1e-7);
            prop_assert!((r.amplitude * r.phase.cos() - n[1].dot(v[1])).abs() < 1e-7);
        }
    }

    /// Which vector is held decides the error; the one at rest is, so the turn of a normal under a far light has none.
    /// Both turning by 30 degrees errs by 0.04, as measured in the notes on Abbas' section 6.2.
    #[test]
    fn both_turning_costs_what_it_is_known_to_cost() {
        let mut worst = 0.0f64;
        let turned = |axis: DVec3, angle: f64, v: DVec3| {
            v * angle.cos() + axis.cross(v) * angle.sin() + axis * axis.dot(v) * (1.0 - angle.cos())
        };
        let s = 30f64.to_radians();
        for i in 0..64 {
            for j in 0..64 {
                let (p, q) = (f64::from(i) * TAU / 64.0, f64::from(j) * TAU / 64.0);
                let n = DVec3::Z;
                let v = DVec3::new(0.6, 0.0, 0.8);
                let (u, w) = (DVec3::new(p.cos(), p.sin(), 0.0), v.any_orthonormal_pair());
                let n2 = turned(u, s, n);
                let v2 = turned(w.0 * q.cos() + w.1 * q.sin(), s, v);
                let (an, av) = (Arc::new(n, n2), Arc::new(v, v2));
                for k in 1..8 {
                    let t = f64::from(k) / 8.0;
                    let phase = Sweep::new([n, n2], [v, v2], t, 0.0).phase();
                    let error = phase.amplitude * phase.phase.cos() - an.at(t).dot(av.at(t));
                    worst = worst.max(error.abs());
                }
            }
        }
        assert!(worst > 0.02 && worst < 0.06, "{worst}");
    }

    #[test]
    fn a_vector_square_to_the_whole_arc_and_vectors_that_are_missing_give_nothing() {
        let p = Sweep::new([DVec3::X, DVec3::Y], [DVec3::Z; 2], 0.0, 0.1).phase();
        assert_eq!(p.amplitude, 0.0);
        assert!(p.phase.is_finite());
        let p = Sweep::new([DVec3::X, DVec3::Y], [DVec3::ZERO; 2], 0.5, 0.1).phase();
        assert_eq!(p.amplitude, 0.0);
        let p = Sweep::new([DVec3::X, DVec3::NEG_X], [DVec3::X, DVec3::NEG_X], 0.5, 0.1).phase();
        assert!(p.amplitude.is_finite() && p.phase.is_finite());
    }
}
