//! Spotlights: how much of its light a spot sends beside its axis, as a function D(e) of the cosine e from the axis.
//!
//! Warn (1983):              D = e^c for e > 0, else 0
//! soft (Hast 2004, 3.273):  D = (e − g)²/(1 − g)² for e > g, else 0
//! hard (Hast 2004, 3.274):  D = 1 − (e − 1)²/(g − 1)² for e > g, else 0
//!
//! g is the cosine of half the angle of the outer cone. The width is given as on the stage: the beam angle is the full
//! angle where D = 1/2, the field angle the one where D = 1/10, and each follows from the other. With C the cosine of
//! half the angle given and k = 1/2 or 1/10 there, c = ln k/ln C; soft 1 − g = (1 − C)/(1 − √k); hard
//! 1 − g = (1 − C)/√(1 − k). D never decreases with e, D(1) = 1, and D(g) = 0. Wide soft beams may have no edge: g < −1.

use crate::scene::{Falloff, SpotWidth};

/// D at the edge of the beam.
const BEAM: f64 = 0.5;
/// D at the edge of the field.
const FIELD: f64 = 0.1;

/// The distribution of a spot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    falloff: Falloff,
    /// The exponent c for Warn, else 1 − g.
    parameter: f64,
}

/// 1 − cos of half a full angle in degrees, without the cancellation at small angles.
fn versine(degrees: f64) -> f64 {
    2.0 * (degrees.to_radians() / 4.0).sin().powi(2)
}

impl Cone {
    /// The distribution with a fall-off and a width.
    #[must_use]
    pub fn new(falloff: Falloff, width: SpotWidth) -> Self {
        let (angle, level) = match width {
            SpotWidth::Beam(angle) => (angle, BEAM),
            SpotWidth::Field(angle) => (angle, FIELD),
        };
        let v = versine(angle);
        let parameter = match falloff {
            Falloff::Warn => level.ln() / (-v).ln_1p(),
            Falloff::Soft => v / (1.0 - level.sqrt()),
            Falloff::Hard => v / (1.0 - level).sqrt(),
        };
        Self { falloff, parameter }
    }

    /// D for the cosine `e` from the axis, 0..=1.
    #[must_use]
    pub fn factor(&self, e: f64) -> f64 {
        let e = e.min(1.0);
        if e <= self.cutoff() {
            return 0.0;
        }
        match self.falloff {
            Falloff::Warn => e.powf(self.parameter),
            Falloff::Soft => (1.0 - (1.0 - e) / self.parameter).powi(2),
            Falloff::Hard => 1.0 - ((1.0 - e) / self.parameter).powi(2),
        }
    }

    /// The cosine at and below which there is no light; below −1 when there is light all around.
    #[must_use]
    pub fn cutoff(&self) -> f64 {
        match self.falloff {
            Falloff::Warn => 0.0,
            Falloff::Soft | Falloff::Hard => 1.0 - self.parameter,
        }
    }

    /// The exponent c of Warn's distribution.
    #[must_use]
    pub fn exponent(&self) -> Option<f64> {
        (self.falloff == Falloff::Warn).then_some(self.parameter)
    }

    /// The full angle in degrees within which D is at least half; 360 when it is so all around.
    #[must_use]
    pub fn beam(&self) -> f64 {
        self.angle(BEAM)
    }

    /// The full angle in degrees within which D is at least a tenth; 360 when it is so all around.
    #[must_use]
    pub fn field(&self) -> f64 {
        self.angle(FIELD)
    }

    fn angle(&self, level: f64) -> f64 {
        let v = match self.falloff {
            Falloff::Warn => -(level.ln() / self.parameter).exp_m1(),
            Falloff::Soft => self.parameter * (1.0 - level.sqrt()),
            Falloff::Hard => self.parameter * (1.0 - level).sqrt(),
        };
        4.0 * (v / 2.0).sqrt().min(1.0).asin().to_degrees()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Falloff::{Hard, Soft, Warn};

    fn field(falloff: Falloff, degrees: f64) -> Cone {
        Cone::new(falloff, SpotWidth::Field(degrees))
    }

    fn at(c: &Cone, half_degrees: f64) -> f64 {
        c.factor(half_degrees.to_radians().cos())
    }

    #[test]
    fn beam_and_field_are_where_the_light_is_a_half_and_a_tenth() {
        for falloff in [Warn, Soft, Hard] {
            for degrees in [0.1, 1.0, 15.0, 30.0, 60.0, 120.0, 179.0] {
                let c = field(falloff, degrees);
                let b = Cone::new(falloff, SpotWidth::Beam(degrees));
                assert!(
                    (c.field() / degrees - 1.0).abs() < 1e-9,
                    "{falloff:?} {degrees}"
                );
                assert!(
                    (b.beam() / degrees - 1.0).abs() < 1e-9,
                    "{falloff:?} {degrees}"
                );
                // Cosines of small angles are near 1 and have lost digits.
                let near = 1e-6 + 1e-13 / degrees.powi(2);
                assert!(
                    (at(&c, degrees / 2.0) - 0.1).abs() < near,
                    "{falloff:?} {degrees}"
                );
                assert!(
                    (at(&b, degrees / 2.0) - 0.5).abs() < near,
                    "{falloff:?} {degrees}"
                );
                assert!(
                    (at(&c, c.beam() / 2.0) - 0.5).abs() < near,
                    "{falloff:?} {degrees}"
                );
                assert_eq!(c.factor(1.0), 1.0);
            }
        }
    }

    /// The conversions worked out in the literature study.
    #[test]
    fn conversions_of_15_and_30_degrees() {
        let outer = |c: &Cone| 2.0 * c.cutoff().acos().to_degrees();
        let near = |a: f64, b: f64, digit: f64| assert!((a - b).abs() <= digit / 2.0, "{a} {b}");
        let (soft, hard, warn) = (field(Soft, 15.0), field(Hard, 15.0), field(Warn, 15.0));
        near(soft.cutoff(), 0.987_488, 1e-6);
        near(outer(&soft), 18.15, 0.01);
        near(soft.beam(), 9.81, 0.01);
        near(hard.cutoff(), 0.990_982, 1e-6);
        near(outer(&hard), 15.40, 0.01);
        near(hard.beam(), 12.95, 0.01);
        near(warn.exponent().unwrap(), 268.0, 1.0);
        near(warn.beam(), 8.24, 0.01);
        near(field(Soft, 30.0).cutoff(), 0.950_167, 1e-6);
        near(field(Hard, 30.0).cutoff(), 0.964_083, 1e-6);
        near(field(Warn, 30.0).exponent().unwrap(), 66.4, 0.1);
    }

    /// Soft spots are much like Warn's, but not the same.
    #[test]
    fn soft_and_warn_differ_by_an_eighth() {
        for (degrees, want) in [(15.0, 0.131), (30.0, 0.128), (60.0, 0.115)] {
            let (s, w) = (field(Soft, degrees), field(Warn, degrees));
            let apart = (0..=20_000)
                .map(|i| f64::from(i) / 20_000.0 * degrees)
                .map(|half| (at(&s, half) - at(&w, half)).abs())
                .fold(0.0, f64::max);
            assert!((apart - want).abs() < 1e-3, "{degrees}: {apart}");
        }
    }

    #[test]
    fn light_never_grows_away_from_the_axis_and_ends_where_it_should() {
        for falloff in [Warn, Soft, Hard] {
            for width in [
                SpotWidth::Field(20.0),
                SpotWidth::Beam(150.0),
                SpotWidth::Beam(0.1),
            ] {
                let c = Cone::new(falloff, width);
                let mut last = c.factor(1.0 + 1e-15);
                assert_eq!(last, 1.0);
                for i in (-1000..1000).rev() {
                    let now = c.factor(f64::from(i) / 1000.0);
                    assert!((0.0..=last).contains(&now), "{falloff:?} {width:?} {i}");
                    last = now;
                }
                if c.cutoff() > -1.0 {
                    assert_eq!((c.factor(c.cutoff()), c.factor(-1.0)), (0.0, 0.0));
                    assert!(c.factor(c.cutoff() + (1.0 - c.cutoff()) * 1e-6) < 1e-3);
                }
            }
        }
    }
}
