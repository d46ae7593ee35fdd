//! What rounding does to the pixels of the span cores, at worst, in LSB before the output is rounded.
//!
//! The figures are for colours of 255 LSB in both terms, exponents up to [`EXPONENT`], and normals that turn by up to
//! 90° along a span of M pixels.

use super::span_core::SpanKind;

/// Largest exponent that the bounds are stated for; below it they are smaller in proportion.
pub const EXPONENT: f64 = 128.0;
/// The longest span of any frame.
const LONGEST: u32 = 2040;
/// Full scale, LSB.
const FULL: f64 = 255.0;
/// Half a code of the three colours, factors cut to 2^−16 and products cut to 2^−16 LSB.
const COLOURS: f64 = 3.0 / 128.0 + 2.0 * FULL / 65_536.0 + 2.0 / 65_536.0;
/// Chords of the power table: h²n²/16 at 17/256, half a code of a word and of its fall, and the cut of the fall.
const CHORDS: f64 = 17.0 * 17.0 / 65_536.0 / 16.0 + 3.0 / 131_072.0;

fn power(exponent: i32) -> f64 {
    2f64.powi(exponent)
}

/// Error of a cosine by differences after `m` pixels, as a fraction of full scale.
///
/// Value and change are within half a code, which the recurrence passes on at most once and m times; every step is cut
/// by up to 2^−42, m²/2 in all; the operand is cut by up to 2^−23, which κ ≤ (g/m)² weighs down to g²/2; κ is within
/// 2^−17 of itself or 2^−47, and since the set-up makes the last pixel right whatever κ is, it bends the span by g²/8 of
/// that and does not tilt it.
#[must_use]
pub fn swing(m: f64) -> f64 {
    let g = std::f64::consts::FRAC_PI_2;
    power(-31) * (1.0 + m)
        + power(-42) * m * m / 2.0
        + power(-23) * g * g / 2.0
        + power(-17) * g * g / 8.0
        + power(-47) * m * m / 8.0
}

/// The same for Chebyshev's recurrence: U is within 2^−23, and the operand is cut by up to 2^−23 before it is doubled.
#[must_use]
pub fn chebyshev(m: f64) -> f64 {
    let step = power(-23) + 2.0 * power(-23) + power(-42);
    (step * m * m / 2.0 + power(-31) * 2.0 * (1.0 + m)).min(2.0)
}

/// Bound of a core on spans of up to `run` pixels.
#[must_use]
pub fn error_bound(kind: SpanKind, run: u32) -> f64 {
    let m = f64::from(run.min(LONGEST));
    let cosines = |e: f64| FULL * (e + (EXPONENT * e).min(1.0) + CHORDS);
    COLOURS
        + match kind {
            SpanKind::Slerp => cosines(swing(m)),
            SpanKind::Chebyshev => cosines(chebyshev(m)),
            // A function that falls by at most 2.2 table words per word of the angle (cos 1.6, cos² 1.6, cosⁿ 2.2): half
            // a bin, half a code, and what the phase misses a bin by.
            SpanKind::Spherical(bits) | SpanKind::SphericalPower(bits) => {
                let words = power(bits as i32);
                let word = 2.2 / words * (0.5 + (1.0 + m) * power(-15));
                2.0 * FULL * (word + 0.5 / (words - 1.0) + power(-16))
            }
            SpanKind::Blake | SpanKind::BlakeRefit | SpanKind::BlakeTrapezium => {
                2.0 * FULL * power(-31) * (1.0 + m + m * m / 2.0)
            }
        }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faithful_cores_are_within_a_quarter_and_chebyshev_s_is_not() {
        for m in [1, 64, 1024, 2040] {
            assert!(error_bound(SpanKind::Slerp, m) < 0.27, "{m}");
            assert!(error_bound(SpanKind::Blake, m) < 0.54, "{m}");
        }
        assert!(error_bound(SpanKind::Blake, 1024) < 0.2);
        assert!(error_bound(SpanKind::Chebyshev, 1024) > 40.0);
        assert!(error_bound(SpanKind::Chebyshev, 16) < 2.0);
    }
}
