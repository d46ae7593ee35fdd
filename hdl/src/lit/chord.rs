//! Words of the power table: xⁿ by chords over w = 1 − x. See [`super::power`].

use crate::format::mask;

/// Chords of a table.
pub const CHORDS: usize = 256;
/// Largest stretch.
pub const LARGEST_SHIFT: u32 = 7;
/// 1.0 in a table word.
pub const WORD_UNIT: f64 = 131_072.0;

/// The stretch for an exponent.
#[must_use]
pub fn shift_of(n: f64) -> u32 {
    (0..=LARGEST_SHIFT)
        .rev()
        .find(|s| f64::from(1u32 << s) <= n / 8.5)
        .unwrap_or(0)
}

/// The table word of interval `index` for exponent `n`.
#[must_use]
pub fn chord(n: f64, index: usize) -> u64 {
    let step = 1.0 / (CHORDS as f64 * f64::from(1u32 << shift_of(n)));
    let curve = |i: f64| (1.0 - i * step).max(0.0).powf(n);
    let i = index as f64;
    let (begin, end) = (curve(i), curve(i + 1.0));
    // The chord lies above the curve, farthest about the middle; half of that is taken off.
    let above = ((begin + end) / 2.0 - curve(i + 0.5)) / 2.0;
    let word = |v: f64| ((v - above).max(0.0) * WORD_UNIT).round() as u64;
    let (from, to) = (word(begin), word(end));
    from << 14 | (from.saturating_sub(to) & mask(14))
}
