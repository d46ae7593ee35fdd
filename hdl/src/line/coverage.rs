//! V(D), the weight of a pixel whose centre lies at distance D from a line, computed from its definition: a strip one
//! pixel wide convolved with a cone of radius 1 and volume 1, height 3/π (Gupta, Sproull and Sutherland 1981; Abbas 2003,
//! section 3.3).
//!
//! Across the line the cone has the profile p(s) = (3/π)·(h − s²·arcosh(1/|s|)), h = √(1 − s²), whose integral from 0 to s is
//! Q(s) = (1/π)·(2·s·h + arcsin s − s³·arcosh(1/|s|)); V(D) = Q(D + ½) − Q(D − ½), from V(0) = 0.77986 to V(1½) = 0. The
//! tables that Abbas prints are these with a gain of about 1.28; here weights are true, so a level line keeps its light.

use std::f64::consts::PI;

/// The level of weight 1.
pub const FULL: u8 = 255;

fn integral(s: f64) -> f64 {
    let a = s.abs().min(1.0);
    if a == 0.0 {
        return 0.0;
    }
    let h = (1.0 - a * a).max(0.0).sqrt();
    let q = (2.0 * a * h + a.asin() - a.powi(3) * (1.0 / a).acosh()) / PI;
    q.copysign(s)
}

/// V at a distance of either sign, pixels.
#[must_use]
pub fn weight(distance: f64) -> f64 {
    let d = distance.abs();
    if d < 1.5 {
        (integral(d + 0.5) - integral(d - 0.5)).max(0.0)
    } else {
        0.0
    }
}

/// The table for distances with so many fraction bits (1 to 12): entry i is [`FULL`]·V in the middle of its bin,
/// (i + ½)·2^−bits, rounded to nearest; from D = 1½ on all would be 0 and none is kept.
///
/// A weight from the table differs from V by at most half a level and half a bin of the greatest slope, 3/π: by
/// 0.5 + 122·2^−bits levels; 15.8 for 3 bits, 8.1 for 4, 1.0 for 8.
#[must_use]
pub fn table(fraction_bits: u32) -> Vec<u8> {
    let bits = fraction_bits.clamp(1, 12);
    let bin = f64::from(1u32 << bits).recip();
    let level = |i: u32| (f64::from(FULL) * weight((f64::from(i) + 0.5) * bin)).round() as u8;
    (0..3u32 << (bits - 1)).map(level).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The convolution on a grid: volume of the cone above the strip.
    fn by_sums(distance: f64, n: i32) -> f64 {
        let cell = f64::from(n).recip();
        let mut sum = 0.0;
        for i in 0..n {
            let x = distance - 0.5 + (f64::from(i) + 0.5) * cell;
            for j in 0..n {
                sum += 2.0 * (1.0 - x.hypot((f64::from(j) + 0.5) * cell)).max(0.0);
            }
        }
        sum * cell * cell * 3.0 / PI
    }

    #[test]
    fn the_closed_form_is_the_convolution() {
        for k in 0..=30 {
            let d = f64::from(k) / 20.0 + 0.002;
            assert!((weight(d) - by_sums(d, 500)).abs() < 4e-6, "{d}");
        }
        assert!((weight(0.0) - 0.77986).abs() < 5e-6 && (weight(0.5) - 0.5).abs() < 1e-12);
        assert_eq!(
            (weight(1.5), weight(-9.0), weight(f64::NAN)),
            (0.0, 0.0, 0.0)
        );
    }

    #[test]
    fn tables_keep_their_bound_and_come_near_it() {
        for (bits, worst_seen) in [(3, 15.5), (4, 7.6), (5, 4.0), (6, 2.3), (8, 0.9)] {
            let t = table(bits);
            let mut worst = 0.0f64;
            for k in 0..30_000 {
                let d = f64::from(k) / 20_000.0;
                let level = t[(d * f64::from(1 << bits)) as usize];
                worst = worst.max((f64::from(level) - 255.0 * weight(d)).abs());
            }
            println!("{bits} fraction bits: {worst:.2} levels");
            assert!(worst <= 0.5 + 122.0 / f64::from(1 << bits));
            assert!((worst - worst_seen).abs() < 0.2, "{bits}: {worst}");
        }
    }

    #[test]
    fn level_lines_keep_their_light() {
        let t = table(4);
        for i in 0..8 {
            let sum: i32 = [i, 15 - i, 16 + i].iter().map(|k| i32::from(t[*k])).sum();
            assert!((sum - 255).abs() <= 2, "{sum}");
        }
    }
}
