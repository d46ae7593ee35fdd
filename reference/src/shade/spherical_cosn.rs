//! Spherical interpolation with the material's own cosⁿ in the ROM: ours. The datapath is that of fig. 6.6 of Abbas 2003
//! (see [`super::spherical_cos2`]); only what the ROM holds is another, and it is loaded again for each material. 256
//! words of 8 bits over |ψ| < arccos(512^(−1/n)), where cosⁿ still shows, err by at most 1.5 LSB of full scale in the
//! place of cos²'s 18.

use super::case::Case;
use super::circular::{per_material, Circular, Response};
use super::curve::rom::Sample;
use super::curve::{power, Rom};
use super::ends::{self, Slerped};
use super::spherical::curved;
use super::spherical_cos2::{Curved, Scaled};
use super::sweep::Sweep;
use crate::geometry::Prepared;
use std::f64::consts::FRAC_PI_2;

/// Address and data bits.
const BITS: u32 = 8;
/// cosⁿ is cut where it falls to this, a quarter of an LSB below the rounding of 8 bits.
const CUT: f64 = 1.0 / 512.0;

/// The method.
pub type SphericalCosN = Circular<Slerped, Roms>;

/// A table of cos, and one of cosⁿ for each material.
pub struct Roms {
    cosine: Rom,
    powers: Vec<Rom>,
}

/// The method for a scene.
#[must_use]
pub fn new(p: &Prepared) -> SphericalCosN {
    Circular {
        ends: Slerped,
        response: Roms {
            cosine: cosine(),
            powers: per_material(p, rom),
        },
    }
}

fn cosine() -> Rom {
    Rom::new(BITS, BITS, FRAC_PI_2, Sample::Centre, f64::cos)
}

/// cosⁿ over the angles where it shows.
fn rom(n: f64) -> Rom {
    let range = if n > 0.0 {
        CUT.powf(1.0 / n).acos()
    } else {
        FRAC_PI_2
    };
    Rom::new(BITS, BITS, range, Sample::Centre, |x| power(x, n))
}

impl Response for Roms {
    type Diffuse<'a> = Curved<Scaled<'a>>;
    type Specular<'a> = Curved<Scaled<'a>>;

    fn diffuse<'a>(&'a self, s: &Sweep) -> Curved<Scaled<'a>> {
        let rom = &self.cosine;
        Curved::new(s, 1.0, Scaled { rom, a: 1.0 })
    }

    fn specular<'a>(&'a self, s: &Sweep, material: usize, n: f64) -> Curved<Scaled<'a>> {
        let rom = &self.powers[material];
        Curved::new(s, n, Scaled { rom, a: 1.0 })
    }
}

/// Bound on |method − truth|, LSB. Proved, up to a spread of 90°: the tables are compared with what they hold at both
/// ends of every word.
#[must_use]
pub fn bound(case: &Case) -> f64 {
    let n = case.shininess;
    let e = [
        cosine().distance(f64::cos),
        rom(n).distance(|x| power(x, n)),
    ];
    curved(case, ends::triangle_lag, e)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_within_its_error_for_every_exponent() {
        for n in [1.0, 2.0, 5.0, 20.0, 100.0, 500.0, 10_000.0] {
            let e = 255.0 * rom(n).distance(|x| power(x, n));
            println!("n={n}: {e:.2} LSB");
            assert!(e < 2.1, "{n}: {e}");
        }
        assert!(255.0 * cosine().distance(f64::cos) < 1.4);
    }
}
