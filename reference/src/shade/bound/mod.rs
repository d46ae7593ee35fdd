//! How far a triangle's interpolated colour can be from the truth, proved, and the cheapest way to draw it within a given
//! error.
//!
//! Interpolating a function g over the triangle of λ (equilateral, unit edges, see [`field`]):
//!
//! * linear through three vertices: |error| ≤ ½ Σ λᵢ|xᵢ − p|²·sup|g''| ≤ sup|g''|/6;
//! * quadratic through vertices and mid-edges: |error| ≤ ⅙ Σ |φₖ(p)||xₖ − p|³·sup|g'''| ≤ [`QUADRATIC`]·sup|g'''|
//!   (Ciarlet and Raviart 1972, the multipoint Taylor formula; φₖ the six basis functions).
//!
//! g is a sum over lights of k_d·max(0, N·L) and k_s·max(0, N·H)ⁿ, with derivatives from [`field`] and [`power`]. The kink of
//! max(0, f) where f changes its sign: max(0, f) = f + max(0, −f) and max(0, −f) ≤ F, so its interpolant, within
//! 0..F (linear) or −F/3..4F/3 (quadratic), errs by F or 4F/3 at most, F the lesser of max f and max −f
//! ([`Field::crossing`]).
//!
//! Where the colour is evaluated at some points, less is left to these bounds: see [`sampled`].
//!
//! Interpolating N·L and N·H themselves and raising to the power per pixel has no kink: an error e of N·H becomes at
//! most n·(c + e)ⁿ⁻¹·e, c = max N·H.

pub mod field;
pub mod power;
pub mod sampled;

use super::paint::is_plain;
use crate::geometry::{Prepared, ScreenTriangle};
use crate::scene::LightKind;
use field::{half_way, Field};
use power::Power;

/// Largest sup of ½ Σ λᵢ|xᵢ − p|².
pub const LINEAR: f64 = 1.0 / 6.0;
/// Largest sup of ⅙ Σ |φₖ(p)||xₖ − p|³, rounded up (tested on a grid with its margin).
pub const QUADRATIC: f64 = 0.0256;

/// Bounds of the error of one triangle in LSB, all channels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Linear interpolation of vertex colours.
    pub linear: f64,
    /// Quadratic interpolation of six colours.
    pub quadratic: f64,
    /// Quadratic interpolation of N·L and N·H, the power per pixel.
    pub dots: f64,
    /// The largest that all highlights together can be.
    pub specular: f64,
    /// The largest that all diffuse reflection together can be.
    pub diffuse: f64,
    /// What stays of the linear error where the colour is known at fifteen points ([`sampled`]).
    pub linear_between: f64,
    /// What stays of the quadratic error there.
    pub quadratic_between: f64,
}

impl Bounds {
    /// Nothing is promised.
    pub const NONE: Self = Self {
        linear: f64::INFINITY,
        quadratic: f64::INFINITY,
        dots: f64::INFINITY,
        specular: f64::INFINITY,
        diffuse: f64::INFINITY,
        linear_between: f64::INFINITY,
        quadratic_between: f64::INFINITY,
    };
}

/// What bounds need that is the same for all triangles: the tables of each material's exponent.
#[derive(Clone, Debug)]
pub struct Tables {
    powers: Vec<Option<Power>>,
}

/// Two unit vectors whose dot product is interpolated.
struct Pair {
    /// Bounds of the chord between them.
    chord: [f64; 2],
    /// F₁ and bounds of the second and third derivative of the dot product.
    mixed: [f64; 3],
    /// κ and σ of N when the other vector is constant.
    constant: Option<(f64, f64)>,
}

impl Pair {
    fn new(n: &Field, middle: glam::DVec3, spread: f64, d: [f64; 3], constant: bool) -> Self {
        let apart = (n.middle - middle).length();
        let slack = n.spread + spread;
        let chord = [(apart - slack).max(0.0), apart + slack];
        let [n1, n2, _] = n.derivatives();
        let (k, s) = (n.turn, n.stretch);
        // |N'·H| ≤ κ·sin φ, and the higher derivatives of N lie along N' and N.
        let least = 1.0 - chord[1] * chord[1] / 2.0;
        let sine = if least > 0.0 {
            (1.0 - least * least).sqrt()
        } else {
            1.0
        };
        let own = [
            k * k + 2.0 * s * k * sine,
            (6.0 * s * s).max(3.0 * k * k) * k * sine + 6.0 * s * k * k,
        ];
        Self {
            chord,
            mixed: [
                n1 + d[0],
                own[0] + 2.0 * n1 * d[0] + d[1],
                own[1] + 3.0 * n2 * d[0] + 3.0 * n1 * d[1] + d[2],
            ],
            constant: constant.then_some((k, s)),
        }
    }

    /// Least and largest dot product.
    fn range(&self) -> [f64; 2] {
        let dot = |t: f64| (1.0 - t * t / 2.0).max(-1.0);
        [dot(self.chord[1]), dot(self.chord[0])]
    }

    /// Bounds of the second and third derivative of the dot product.
    fn dot(&self) -> [f64; 2] {
        [self.mixed[1], self.mixed[2]]
    }

    /// Bounds of the second and third derivative of its power, of its size and of the error of a power of the
    /// interpolated product.
    fn power(&self, power: &Power, n: f64) -> [f64; 4] {
        let f = power.from_chord(self.chord[0]);
        let [second, third] = match self.constant {
            Some((k, s)) => [
                f.second_constant[0] * k * k + f.second_constant[1] * 2.0 * s * k,
                f.third_constant[0] * k * k * k
                    + f.third_constant[1] * 6.0 * s * k * k
                    + f.third_constant[2] * 6.0 * s * s * k,
            ],
            None => {
                let [f1, f2, f3] = self.mixed;
                [
                    f.second[0] * f1 * f1 + f.second[1] * f2,
                    f.third[0] * f1 * f1 * f1 + f.third[1] * f1 * f2 + f.third[2] * f3,
                ]
            }
        };
        let e = QUADRATIC * self.dot()[1];
        // The slope at a cosine larger by e: the table at a chord shorter by √(2e), or more by what is left of it.
        let wider = (self.chord[0] * self.chord[0] - 2.0 * e).max(0.0).sqrt();
        let dots = if n * e > 40.0 {
            f64::INFINITY
        } else {
            power.from_chord(wider).slope * e
        };
        [second, third, f.value, dots]
    }
}

impl Tables {
    /// Tables for the materials of a scene.
    #[must_use]
    pub fn new(p: &Prepared) -> Self {
        let used = p.triangles.iter().map(|t| t.material).max();
        let power = |m: usize| Power::new(p.surroundings.material(m).shininess);
        Self {
            powers: (0..used.map_or(0, |m| m + 1)).map(power).collect(),
        }
    }

    /// The bounds of a triangle.
    #[must_use]
    pub fn bounds(&self, p: &Prepared, t: &ScreenTriangle) -> Bounds {
        if is_plain(p, t) {
            self.of_plain(p, t)
        } else {
            Bounds::NONE
        }
    }

    /// The bounds of a triangle that [`is_plain`].
    pub(crate) fn of_plain(&self, p: &Prepared, t: &ScreenTriangle) -> Bounds {
        self.promise(p, t).unwrap_or(Bounds::NONE)
    }

    fn promise(&self, p: &Prepared, t: &ScreenTriangle) -> Option<Bounds> {
        let s = &p.surroundings;
        let m = s.material(t.material);
        let w = t.inv_w;
        let normal = Field::new([t.normal[0] * w[0], t.normal[1] * w[1], t.normal[2] * w[2]])?;
        let towards = |x: glam::DVec3| {
            let at = |i: usize| (x - t.world[i]) * w[i];
            Field::new([at(0), at(1), at(2)])
        };
        let view = match s.eye() {
            Some(eye) => towards(eye)?,
            None => Field::constant(s.view(t.world[0])),
        };
        let shiny = m.specular.max_element() > 0.0;
        let mut sum = Bounds {
            linear: 0.0,
            quadratic: 0.0,
            dots: 0.0,
            specular: 0.0,
            diffuse: 0.0,
            linear_between: 0.0,
            quadratic_between: 0.0,
        };
        for light in s.reaching(&t.world).iter().map(|k| s.light(k).0) {
            let l = match light.kind {
                LightKind::Directional { direction } => Field::constant(-direction),
                LightKind::Point { position, .. } | LightKind::Spot { position, .. } => {
                    towards(position)?
                }
            };
            let still = l.turn == 0.0;
            let weight = (light.colour * m.diffuse).max_element() * 255.0;
            let pair = Pair::new(&normal, l.middle, l.spread, l.derivatives(), still);
            let [least, most] = pair.range();
            if most > 0.0 && weight > 0.0 {
                let [second, third] = pair.dot();
                let kink = if least < 0.0 {
                    normal.crossing(&l).min(most.min(-least))
                } else {
                    0.0
                };
                let (linear, quadratic) = (LINEAR * second, QUADRATIC * third);
                sum.linear += weight * (linear + kink);
                sum.quadratic += weight * (quadratic + 4.0 / 3.0 * kink);
                sum.linear_between += weight * (linear / 16.0 + kink);
                sum.quadratic_between += weight * (quadratic / 8.0 + 4.0 / 3.0 * kink);
                sum.dots += weight * quadratic;
                sum.diffuse += weight * most;
            }
            let weight = (light.colour * m.specular).max_element() * 255.0;
            if shiny && weight > 0.0 {
                let (middle, spread, d) = half_way(&l, &view)?;
                let still = still && view.turn == 0.0;
                let pair = Pair::new(&normal, middle, spread, d, still);
                let power = self.powers[t.material].as_ref()?;
                let [second, third, value, dots] = pair.power(power, m.shininess);
                // A highlight in 0..=v cannot be missed by more than v, or 4v/3 with overshoot.
                let (linear, quadratic) = (LINEAR * second, QUADRATIC * third);
                sum.linear += weight * linear.min(value);
                sum.quadratic += weight * quadratic.min(4.0 / 3.0 * value);
                sum.linear_between += weight * (linear / 16.0).min(value);
                sum.quadratic_between += weight * (quadratic / 8.0).min(4.0 / 3.0 * value);
                sum.dots += weight * dots.min(1.0);
                sum.specular += weight * value;
            }
        }
        Some(sum)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_constants_are_large_enough() {
        let x = [(0.0, 0.0), (1.0, 0.0), (0.5, 0.75f64.sqrt())];
        let mid = |i: usize, j: usize| ((x[i].0 + x[j].0) / 2.0, (x[i].1 + x[j].1) / 2.0);
        let knots = [x[0], x[1], x[2], mid(0, 1), mid(0, 2), mid(1, 2)];
        let (mut linear, mut quadratic) = (0.0f64, 0.0f64);
        let n = 400;
        for i in 0..=n {
            for j in 0..=n - i {
                let (a, b) = (f64::from(i) / f64::from(n), f64::from(j) / f64::from(n));
                let c = 1.0 - a - b;
                let p = (
                    a * x[0].0 + b * x[1].0 + c * x[2].0,
                    a * x[0].1 + b * x[1].1 + c * x[2].1,
                );
                let apart = |q: (f64, f64)| (p.0 - q.0).hypot(p.1 - q.1);
                let basis = [
                    a * (2.0 * a - 1.0),
                    b * (2.0 * b - 1.0),
                    c * (2.0 * c - 1.0),
                    4.0 * a * b,
                    4.0 * a * c,
                    4.0 * b * c,
                ];
                let two = [a, b, c]
                    .into_iter()
                    .zip(x)
                    .map(|(l, q)| l * apart(q).powi(2));
                linear = linear.max(two.sum::<f64>() / 2.0);
                let three = basis
                    .into_iter()
                    .zip(knots)
                    .map(|(f, q)| f.abs() * apart(q).powi(3));
                quadratic = quadratic.max(three.sum::<f64>() / 6.0);
            }
        }
        // Between grid points 1/400 apart the sums, whose slopes are below 1 and 1/2, grow by less than 0.0003.
        assert!(
            linear <= LINEAR + 1e-12 && linear > LINEAR - 0.001,
            "{linear}"
        );
        assert!(
            quadratic + 0.0003 <= QUADRATIC && quadratic > QUADRATIC - 0.001,
            "{quadratic}"
        );
    }
}
