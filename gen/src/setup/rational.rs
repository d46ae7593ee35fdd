//! Exact rounding.

/// Fraction bits of a knot before set-up: 2^−21 LSB of rounding, far below any output.
pub const KNOT_FRACTION_BITS: u32 = 20;

/// A knot as an integer in units of 2^−20; `None` when it is not finite or beyond ±2^17.
#[must_use]
pub fn fixed_knot(value: f64) -> Option<i128> {
    shadegate_hdl::format::quantise(value, 17, KNOT_FRACTION_BITS).map(i128::from)
}

/// `numerator / denominator` rounded to nearest, halves upwards. The denominator must not be zero.
pub fn round_divide(numerator: i128, denominator: i128) -> i128 {
    let (n, d) = if denominator < 0 {
        (-numerator, -denominator)
    } else {
        (numerator, denominator)
    };
    (2 * n + d).div_euclid(2 * d)
}

/// The code in a format with `fraction_bits` of `numerator / denominator`, where the numerator has
/// [`KNOT_FRACTION_BITS`] fraction bits: rounded once, and reduced modulo 2^100, more than any register, so that sums
/// of words never overflow. `numerator` may have 126 bits, `denominator` 84, and 20 fraction bits may be appended.
pub fn word(numerator: i128, denominator: i128, fraction_bits: u32) -> i128 {
    let up = fraction_bits.saturating_sub(KNOT_FRACTION_BITS);
    let down = KNOT_FRACTION_BITS.saturating_sub(fraction_bits);
    let (n, d) = if denominator < 0 {
        (-numerator, -(denominator << down))
    } else {
        (numerator, denominator << down)
    };
    let (whole, rest) = (n.div_euclid(d), n.rem_euclid(d));
    let reduced = (whole << (28 + up)) >> 28;
    reduced + round_divide(rest << up, d)
}

/// The residue of a code in `width` bits, as the bus carries it.
pub fn residue(code: i128, width: u32) -> u64 {
    (code & ((1i128 << width) - 1)) as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_is_to_nearest_for_both_signs() {
        for n in -50i128..50 {
            for d in [-7i128, -3, -2, -1, 1, 2, 3, 7] {
                let exact = n as f64 / d as f64;
                assert_eq!(round_divide(n, d), (exact + 0.5).floor() as i128, "{n}/{d}");
            }
        }
    }

    #[test]
    fn a_word_is_the_rounded_quotient() {
        for n in [-987_654_321i128, -12, -1, 0, 5, 123_456_789_123] {
            for d in [-1_000_003i128, -7, 1, 3, 1 << 40] {
                for bits in [12, 20, 34, 38] {
                    let scale = 2f64.powi(bits as i32 - KNOT_FRACTION_BITS as i32);
                    let exact = n as f64 / d as f64 * scale;
                    let got = word(n, d, bits);
                    assert!(
                        (got as f64 - exact).abs() <= 0.5 + exact.abs() * 1e-15,
                        "{n}/{d}"
                    );
                }
            }
        }
        // What does not fit is its residue.
        let large = (1i128 << 120) + 12345;
        assert_eq!(residue(word(large, 1, 38), 60), residue(large << 18, 60));
    }

    #[test]
    fn residues_keep_the_low_bits() {
        assert_eq!(residue(-1, 32), 0xffff_ffff);
        assert_eq!(residue((1 << 40) + 5, 32), 5);
    }
}
