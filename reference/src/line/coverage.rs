//! V(D): how much of a cone-shaped pixel a line covers whose centre passes at distance D.
//!
//! The line is a strip one pixel wide, the filter a cone of radius 1 and volume 1, height 3/π (Gupta, Sproull and
//! Sutherland 1981; Abbas 2003, section 3.3). Projected along the strip, the cone has the profile
//! p(s) = (3/π)·(h − s²·ln((1 + h)/|s|)), h = √(1 − s²), with the integral from 0 to s
//! Q(s) = (1/π)·(2·s·h + arcsin s − s³·ln((1 + h)/|s|)), Q(±1) = ±½; so V(D) = Q(D + ½) − Q(D − ½).
//! It falls from V(0) = 0.77986 over V(½) = ½ to V(1½) = 0, and V(d) + V(1 − d) + V(1 + d) = 1 for 0 ≤ d ≤ ½.
//!
//! The tables that Abbas prints are scaled by about 1.28, so that the middle of a line is (nearly) of full brightness;
//! with the cone of the text it is 0.78. [`Table`] holds the true values; scale by 1/V(0) where brightness is wanted.

use std::f64::consts::PI;

/// Distance from which a line does not touch the cone any more, pixels.
pub const REACH: f64 = 1.5;

/// Integral of the cone's profile from 0 to `s`.
fn profile_integral(s: f64) -> f64 {
    let a = s.abs().min(1.0);
    if a == 0.0 {
        return 0.0;
    }
    let h = (1.0 - a * a).max(0.0).sqrt();
    let q = (2.0 * a * h + a.asin() - a * a * a * ((1.0 + h) / a).ln()) / PI;
    q.copysign(s)
}

/// The weight, 0..=0.77986, of a pixel at `distance` (pixels, either sign) from the middle of a line; 0 for what is not
/// a number.
#[must_use]
pub fn weight(distance: f64) -> f64 {
    let d = distance.abs();
    if d < REACH {
        (profile_integral(d + 0.5) - profile_integral(d - 0.5)).max(0.0)
    } else {
        0.0
    }
}

/// V(D) by address: what a read-only memory in hardware holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    address_bits: u32,
    full: u16,
    levels: Vec<u16>,
}

impl Table {
    /// A table of bins 2^−`address_bits` pixels wide up to D = 1½, each holding round(`full`·V(middle of the bin)).
    /// `address_bits` count the fraction of D, 1 to 12; `full` is the level of weight 1, at least 1.
    #[must_use]
    pub fn new(address_bits: u32, full: u16) -> Self {
        let bits = address_bits.clamp(1, 12);
        let full = full.max(1);
        let bins = 3 << (bits - 1);
        let width = f64::from(1u32 << bits).recip();
        let level =
            |i: u32| (f64::from(full) * weight((f64::from(i) + 0.5) * width)).round() as u16;
        Self {
            address_bits: bits,
            full,
            levels: (0..bins).map(level).collect(),
        }
    }

    /// The level of weight 1.
    #[must_use]
    pub fn full(&self) -> u16 {
        self.full
    }

    /// The entries.
    #[must_use]
    pub fn levels(&self) -> &[u16] {
        &self.levels
    }

    /// The level, 0..=[`Table::full`], at a distance in pixels of either sign; 0 beyond the table.
    #[must_use]
    pub fn level(&self, distance: f64) -> u16 {
        // Truncates and saturates; what is not a number becomes the first bin only after the comparison failed.
        let bin = distance.abs() * f64::from(1u32 << self.address_bits);
        if bin < self.levels.len() as f64 {
            self.levels[bin as usize]
        } else {
            0
        }
    }

    /// Bound of |level/full − V(D)|: half a level, and half a bin times the greatest slope of V, at most p(0) = 3/π.
    #[must_use]
    pub fn error_bound(&self) -> f64 {
        0.5 / f64::from(self.full) + 3.0 / PI * 0.5 / f64::from(1u32 << self.address_bits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The convolution from its definition: volume of the cone above the strip, on a grid of `n` cells per unit.
    fn convolution(distance: f64, n: i32) -> f64 {
        let cell = f64::from(n).recip();
        let mut sum = 0.0;
        for i in 0..n {
            // Across the strip.
            let x = distance - 0.5 + (f64::from(i) + 0.5) * cell;
            for j in -n..n {
                let y = (f64::from(j) + 0.5) * cell;
                sum += (1.0 - x.hypot(y)).max(0.0);
            }
        }
        sum * cell * cell * 3.0 / PI
    }

    #[test]
    fn the_closed_form_is_the_convolution() {
        for k in 0..=36 {
            let d = f64::from(k) / 24.0 + 0.003;
            let (v, want) = (weight(d), convolution(d, 700));
            assert!((v - want).abs() < 2e-6, "{d}: {v} {want}");
        }
    }

    #[test]
    fn known_values() {
        let values = [
            (0.0, 0.77986),
            (0.25, 0.70322),
            (0.5, 0.5),
            (0.75, 0.27573),
            (1.0, 0.11007),
            (1.25, 0.02105),
            (1.5, 0.0),
        ];
        for (d, want) in values {
            assert!((weight(d) - want).abs() < 5e-6, "{d}: {}", weight(d));
            assert_eq!(weight(-d), weight(d));
        }
        assert_eq!(
            (weight(7.0), weight(f64::NAN), weight(f64::INFINITY)),
            (0.0, 0.0, 0.0)
        );
    }

    #[test]
    fn level_lines_lose_and_gain_nothing() {
        for k in 0..=100 {
            let d = f64::from(k) / 200.0;
            let sum = weight(d) + weight(1.0 - d) + weight(1.0 + d);
            assert!((sum - 1.0).abs() < 1e-12, "{d}: {sum}");
        }
    }

    #[test]
    fn the_correct_tables() {
        assert_eq!(
            Table::new(3, 7).levels(),
            [5, 5, 5, 4, 3, 2, 2, 1, 1, 0, 0, 0]
        );
        let four = [
            12, 12, 11, 11, 10, 10, 9, 8, 7, 6, 5, 5, 4, 3, 2, 2, 1, 1, 1, 0, 0, 0, 0, 0,
        ];
        assert_eq!(Table::new(4, 15).levels(), four);
        let fine = [
            199, 196, 191, 184, 174, 163, 150, 135, 120, 105, 90, 77, 64, 52, 42, 32, 24, 17, 12,
            7, 4, 2, 0, 0,
        ];
        assert_eq!(Table::new(4, 255).levels(), fine);
    }

    /// Largest error in LSB of 8-bit tables, by address bits, as in the study; and the bound.
    #[test]
    fn tables_keep_their_bound() {
        for (bits, want) in [(4, 7.6), (5, 4.0), (6, 2.3)] {
            let t = Table::new(bits, 255);
            let worst = worst(&t);
            println!("{bits} address bits: {worst:.2} LSB ({want})");
            assert!((worst - want).abs() < 0.1, "{bits}: {worst}");
        }
        for (bits, full) in [(3, 7), (4, 15), (8, 255), (12, 65535)] {
            let t = Table::new(bits, full);
            assert!(worst(&t) / 255.0 <= t.error_bound(), "{bits} {full}");
        }
    }

    fn worst(t: &Table) -> f64 {
        (0..=30_000)
            .map(|k| f64::from(k) / 20_000.0)
            .map(|d| (f64::from(t.level(d)) / f64::from(t.full()) - weight(d)).abs() * 255.0)
            .fold(0.0, f64::max)
    }

    /// The printed tables are these values with a gain: a peak of 7 of 8 (14 of 16) where the cone of volume 1 has 0.78.
    #[test]
    fn the_printed_tables_are_scaled() {
        let three = [7, 6, 6, 5, 4, 3, 2, 1, 1, 0, 0, 0];
        let four = [
            14, 14, 13, 13, 12, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 3, 2, 2, 1, 1, 0, 0, 0, 0,
        ];
        let at =
            |i: usize, bits: u32, shift: f64| weight((i as f64 + shift) / f64::from(1 << bits));
        for (i, p) in three.into_iter().enumerate() {
            assert_eq!((9.15 * at(i, 3, 0.0)).floor() as i32, p);
            assert_eq!((8.45 * at(i, 3, 0.5)).round() as i32, p);
        }
        let differ: Vec<usize> = (0..24)
            .filter(|i| (17.6 * at(*i, 4, 0.0)).round() as i32 != four[*i])
            .collect();
        assert_eq!(differ, [17], "one entry fits no gain");
        // What that does to a level line: the sum of a column is not 1.
        let sums = |t: &[i32], bits: u32| {
            let n = 1usize << bits;
            let get = |i: usize| t.get(i).copied().unwrap_or(0);
            let all: Vec<i32> = (0..n / 2)
                .map(|i| get(i) + get(n - 1 - i) + get(n + i))
                .collect();
            let scale = f64::from(n as u32);
            let bound = |v: Option<&i32>| f64::from(*v.unwrap()) / scale;
            (bound(all.iter().min()), bound(all.iter().max()))
        };
        let (lo, hi) = sums(&four, 4);
        println!(
            "column sums of the printed tables: {:?} and {lo} to {hi}",
            sums(&three, 3)
        );
        assert!(lo > 1.03 && hi > 1.12);
        let own = Table::new(4, 255);
        let own: Vec<i32> = own.levels().iter().map(|l| i32::from(*l)).collect();
        for i in 0..8 {
            let sum = own[i] + own[15 - i] + own[16 + i];
            assert!((sum - 255).abs() <= 2, "{sum}");
        }
    }
}
