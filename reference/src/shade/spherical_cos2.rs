//! Spherical interpolation with cos²(ax) in the place of cosⁿ (Abbas 2003, section 6.3, fig. 6.6): a highlight is
//! C·cos²(ξ) with C = ks·Aⁿ constant along a span (eqs 6.9, 6.10) and ξ = a·(tg − α) growing evenly, zero for |ξ| ≥ π/2.
//!
//! In floats (`spherical-cos2`, `spherical-cos2-minimax`, see [`super::curve::cos2`] for both a(n)), and with one ROM for
//! cos² and one for the diffuse cosine, k address and k data bits (`-rom4`, `-rom6`, `-rom8`): 384 bits are Abbas' 6.
//! The phase is kept whole; the 12-bit register of fig. 6.6 would wrap and lose addresses (6 fraction bits below the
//! address are one whole address too few from 128 pixels on).
//!
//! | work for each light | |
//! |---|---|
//! | pixel | 2 additions, 2 ROMs, 4 mul (1 for a white highlight, 3 diffuse), 3 add |
//! | span | as `spherical`, and 1 power for Aⁿ |
//! | material | a(n) |

use super::case::Case;
use super::circular::{per_material, Circular, Factor, Response};
use super::curve::rom::Sample;
use super::curve::{Cos2, Curve, Rom};
use super::ends::{self, Slerped};
use super::spherical::{curved, Cosine};
use super::sweep::{Phase, Sweep};
use crate::geometry::Prepared;
use std::f64::consts::FRAC_PI_2;

/// The method in floats.
pub type SphericalCos2 = Circular<Slerped, Floats>;
/// The method with ROMs.
pub type SphericalCos2Rom = Circular<Slerped, Roms>;

/// cos² as a function.
pub struct Floats {
    curves: Vec<Cos2>,
}

/// cos² and cos from tables.
pub struct Roms {
    curves: Vec<Cos2>,
    square: Rom,
    cosine: Rom,
    /// For exponents below 2, the table holds cosⁿ itself.
    powers: Vec<Option<Rom>>,
}

/// With the a(n) of eq. 6.12.
#[must_use]
pub fn matched(p: &Prepared) -> SphericalCos2 {
    floats(p, Cos2::new)
}

/// With the a(n) of least maximal error.
#[must_use]
pub fn minimax(p: &Prepared) -> SphericalCos2 {
    floats(p, Cos2::minimax)
}

fn floats(p: &Prepared, curve: impl Fn(f64) -> Cos2) -> SphericalCos2 {
    Circular {
        ends: Slerped,
        response: Floats {
            curves: per_material(p, curve),
        },
    }
}

/// With ROMs of `bits` address and data bits and the a(n) of eq. 6.12.
#[must_use]
pub fn roms(p: &Prepared, bits: u32) -> SphericalCos2Rom {
    let curves = per_material(p, Cos2::new);
    let powers = curves
        .iter()
        .map(|c| c.a().is_none().then(|| rom(bits, |x| c.at(x))))
        .collect();
    Circular {
        ends: Slerped,
        response: Roms {
            curves,
            square: rom(bits, |x| x.cos().powi(2)),
            cosine: rom(bits, f64::cos),
            powers,
        },
    }
}

fn rom(bits: u32, f: impl Fn(f64) -> f64) -> Rom {
    Rom::new(bits, bits, FRAC_PI_2, Sample::Centre, f)
}

/// Aⁿ·f(ψ), ψ growing evenly.
#[derive(Clone, Copy, Debug)]
pub struct Curved<F> {
    /// Aⁿ.
    pub scale: f64,
    /// ψ; its amplitude is in `scale`.
    pub phase: Phase,
    /// f.
    pub curve: F,
}

/// A table addressed by a multiple of the angle.
#[derive(Clone, Copy, Debug)]
pub struct Scaled<'a> {
    /// The table.
    pub rom: &'a Rom,
    /// The multiple.
    pub a: f64,
}

impl Curve for Scaled<'_> {
    fn at(&self, x: f64) -> f64 {
        self.rom.value(self.a * x)
    }
}

impl<F: Curve> Factor for Curved<F> {
    fn value(&self) -> f64 {
        self.scale * self.curve.at(self.phase.phase)
    }

    fn step(&mut self) {
        self.phase.phase += self.phase.step;
    }
}

impl<F> Curved<F> {
    /// Along a sweep, with the scale Aⁿ.
    #[must_use]
    pub fn new(s: &Sweep, n: f64, curve: F) -> Self {
        let phase = s.phase();
        Self {
            scale: phase.amplitude.powf(n),
            phase,
            curve,
        }
    }
}

impl Response for Floats {
    type Diffuse<'a> = Cosine;
    type Specular<'a> = Curved<Cos2>;

    fn diffuse(&self, s: &Sweep) -> Cosine {
        Cosine(s.phase())
    }

    fn specular(&self, s: &Sweep, material: usize, n: f64) -> Curved<Cos2> {
        Curved::new(s, n, self.curves[material])
    }
}

impl Response for Roms {
    type Diffuse<'a> = Curved<Scaled<'a>>;
    type Specular<'a> = Curved<Scaled<'a>>;

    fn diffuse<'a>(&'a self, s: &Sweep) -> Curved<Scaled<'a>> {
        let rom = &self.cosine;
        Curved::new(s, 1.0, Scaled { rom, a: 1.0 })
    }

    fn specular<'a>(&'a self, s: &Sweep, material: usize, n: f64) -> Curved<Scaled<'a>> {
        let scaled = match &self.powers[material] {
            Some(rom) => Scaled { rom, a: 1.0 },
            None => Scaled {
                rom: &self.square,
                a: self.curves[material].a().unwrap_or(1.0),
            },
        };
        Curved::new(s, n, scaled)
    }
}

/// Largest distance of cos²(ax) from cosⁿ for any n, a of eq. 6.12 (tested; it is reached as n grows).
const MATCHED: f64 = 18.45 / 255.0;
/// The same with the a of least maximal error.
const MINIMAX: f64 = 13.5 / 255.0;

/// Bound on |method − truth|, LSB, of `spherical-cos2`. Proved but for the distance of the curves, which is the largest
/// one found (see [`super::curve::cos2`]).
#[must_use]
pub fn bound(case: &Case) -> f64 {
    curved(case, ends::triangle_lag, [0.0, MATCHED])
}

/// The same for `spherical-cos2-minimax`.
#[must_use]
pub fn bound_minimax(case: &Case) -> f64 {
    curved(case, ends::triangle_lag, [0.0, MINIMAX])
}

/// The same with ROMs of `bits` address and data bits; each adds its own largest error.
#[must_use]
pub fn bound_rom(case: &Case, bits: u32) -> f64 {
    let (cosine, square) = (|x: f64| x.cos(), |x: f64| x.cos().powi(2));
    let n = case.shininess;
    let curve = Cos2::new(n);
    let power = |x: f64| curve.at(x);
    let highlight = if n < super::curve::cos2::LEAST_EXPONENT {
        rom(bits, power).distance(power)
    } else {
        MATCHED + rom(bits, square).distance(square)
    };
    curved(
        case,
        ends::triangle_lag,
        [rom(bits, cosine).distance(cosine), highlight],
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shade::curve::distance;

    #[test]
    fn no_exponent_is_farther_than_the_constants_say() {
        for i in 0..60 {
            let n = 2.0 * 1.16f64.powi(i);
            assert!(distance(n, 1024, &Cos2::new(n)) <= MATCHED, "{n}");
            assert!(distance(n, 1024, &Cos2::minimax(n)) <= MINIMAX, "{n}");
        }
        assert!(distance(1e4, 1024, &Cos2::new(1e4)) > 0.99 * MATCHED);
    }
}
