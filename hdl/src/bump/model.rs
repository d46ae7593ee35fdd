//! Integer models of the bump units: what each makes of its inputs, latency apart.

use super::reciprocal_table::reciprocal_word;
use super::MAP_SIZE;
use crate::format::{mask, wrap};

/// Factor of Newton's step in 2^−16, from F_u and F_v in 2^−16.
#[must_use]
pub fn newton(slope_u: i64, slope_v: i64) -> i64 {
    let sum = square(slope_u) + square(slope_v);
    if sum >> 23 != 0 {
        return 0;
    }
    (1 << 16) - (sum >> 7)
}

/// A squared gradient in 2^−22.
fn square(slope: i64) -> i64 {
    (slope * slope) >> 10
}

/// Factors across and along of the reflection in 2^−16, from F_u and F_v in 2^−16.
#[must_use]
pub fn reflection(slope_u: i64, slope_v: i64) -> (i64, i64) {
    let sum = square(slope_u) + square(slope_v);
    let place = (sum >> 8).min((1 << 16) - 1) as u64;
    let word = reciprocal_word((place >> 8) as usize);
    let fallen = ((word & mask(10)) * (place & mask(8))) >> 8;
    let factor = ((word >> 10) - fallen) as i64;
    (factor >> 2, (factor >> 1) - (1 << 16))
}

/// What a bump's cosine is made of: gradient, factors and light in 2^−16.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bump {
    /// F_u and F_v.
    pub slope: [i64; 2],
    /// Factor across the surface.
    pub across: i64,
    /// Part along its normal.
    pub along: i64,
    /// The light in the frame of the surface.
    pub light: [i64; 3],
}

/// The cosine in 2^−16.
#[must_use]
pub fn dot(b: &Bump) -> i64 {
    let keep = |code: i64| wrap(code, 22);
    let slant = |i: usize| keep((b.slope[i] * b.light[i]) >> 14);
    let slants = keep(slant(0) + slant(1));
    let straight = keep((b.along * b.light[2]) >> 14);
    let cosine = keep(straight - keep((slants * b.across) >> 16));
    wrap(cosine >> 2, 19)
}

/// A map of gradients, row by row: F_u in bits 35 to 18, F_v in bits 17 to 0.
#[derive(Clone, Debug)]
pub struct MapModel(Vec<u64>);

impl Default for MapModel {
    fn default() -> Self {
        Self(vec![0; MAP_SIZE * MAP_SIZE])
    }
}

impl MapModel {
    /// Writes a sample: row in bits 11 to 6, column in bits 5 to 0.
    pub fn write(&mut self, address: u64, data: u64) {
        self.0[(address & mask(12)) as usize] = data & mask(36);
    }

    /// Samples around a place (column and row, 12 fraction bits): upper left and right, lower left and right.
    #[must_use]
    pub fn samples(&self, u: u64, v: u64) -> [u64; 4] {
        let last = MAP_SIZE as u64 - 1;
        let (x, y) = ((u >> 12) & last, (v >> 12) & last);
        [(0, 0), (0, 1), (1, 0), (1, 1)]
            .map(|(down, right)| self.0[(((y + down) & last) << 6 | ((x + right) & last)) as usize])
    }
}

/// The gradient between four samples, in 2^−16.
#[must_use]
pub fn blend(samples: [u64; 4], u: u64, v: u64) -> [i64; 2] {
    let (part_u, part_v) = ((u & mask(12)) as i64, (v & mask(12)) as i64);
    let between = |a: i64, b: i64, part: i64| a + (((b - a) * part) >> 12);
    [18, 0].map(|low| {
        let [a, b, c, d] = samples.map(|s| wrap((s >> low) as i64, 18));
        between(between(a, b, part_u), between(c, d, part_u), part_v)
    })
}
