//! The depth word: reversed depth (1 = nearest, 0 = farthest of the frame) in 16 bits, w = floor(1 + 65534·d + ½).
//! Word 0 is what the buffer is cleared to, so anything drawn is nearer than nothing. A pixel is written when its word
//! is strictly greater than the stored one: of equals the first drawn stays.

/// Bits of a depth word.
pub const DEPTH_BITS: u32 = 16;

/// The real value whose rounding is the word: 1 for `d` = 0, 65535 for `d` = 1. Affine, so it may be interpolated.
#[must_use]
pub fn scaled(d: f64) -> f64 {
    1.0 + d * 65534.0
}

/// The depth word of a reversed depth; values outside 0..=1 saturate to the drawn words 1 and 65535.
#[must_use]
pub fn word(d: f64) -> u16 {
    round(scaled(d))
}

/// Rounds a scaled depth to its word, saturating.
pub(crate) fn round(scaled: f64) -> u16 {
    // The conversion truncates and saturates above.
    ((scaled + 0.5) as u16).max(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_and_the_middle() {
        assert_eq!(word(0.0), 1);
        assert_eq!(word(1.0), 65535);
        assert_eq!(word(0.5), 32768);
        assert_eq!((word(-3.0), word(7.0)), (1, 65535));
    }

    #[test]
    fn nearer_is_never_a_smaller_word() {
        let mut last = 0;
        for i in 0..=100_000 {
            let w = word(f64::from(i) / 100_000.0);
            assert!(w >= last && w > 0);
            last = w;
        }
    }
}
