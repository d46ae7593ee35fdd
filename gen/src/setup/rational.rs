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
/// [`KNOT_FRACTION_BITS`] fraction bits, and its residue in a register of `width` bits.
pub fn word(numerator: i128, denominator: i128, fraction_bits: u32) -> i128 {
    let up = fraction_bits.saturating_sub(KNOT_FRACTION_BITS);
    let down = KNOT_FRACTION_BITS.saturating_sub(fraction_bits);
    round_divide(numerator << up, denominator << down)
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
    fn residues_keep_the_low_bits() {
        assert_eq!(residue(-1, 32), 0xffff_ffff);
        assert_eq!(residue((1 << 40) + 5, 32), 5);
    }
}
