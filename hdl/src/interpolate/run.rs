//! How long an accumulator may run: what the rounding of its words adds up to, and the longest run that keeps it small.
//!
//! Sums are exact; only the words are rounded, each by at most half an ulp. After k steps the differences of order i have
//! entered the value C(k, i) times, so a polynomial of degree g is off by at most Σ_{i ≤ g} C(k, i) half-ulps, and there
//! are words that reach it. (Abbas 2003, section 2.2 and equations 2.9 and 2.10, forgets the first word, sums one term
//! too few and has no cross term.) Over a triangle k counts lines, carries and pixels together. Integer bits play no
//! part: sums are residues, and only the value that is used must fit.
//!
//! Longest runs within a quarter of an LSB:
//!
//! | fraction bits | linear | quadratic | cubic |
//! |---:|---:|---:|---:|
//! | 12 | 2 047 | 63 | 23 |
//! | 20 | 524 287 | 1 023 | 146 |
//! | 24 | 8 388 607 | 4 095 | 369 |
//! | 36 | 3.4·10¹⁰ | 262 143 | 5 907 |
//! | 48 | 1.4·10¹⁴ | 16 777 215 | 94 519 |
//! | 52 | 2.2·10¹⁵ | 67 108 863 | 238 173 |
//!
//! Q11.52 is a word of 64 bits, the widest.

/// Half-ulps that a polynomial of this degree may be off by after so many steps: Σ C(steps, i) for i up to the degree.
/// Saturates.
#[must_use]
pub fn half_ulps(degree: u32, steps: u64) -> u128 {
    let steps = u128::from(steps);
    let mut term = 1u128;
    let mut sum = 1u128;
    for i in 0..u128::from(degree) {
        let Some(product) = term.checked_mul(steps.saturating_sub(i)) else {
            return u128::MAX;
        };
        // C(k, i + 1) = C(k, i)·(k − i)/(i + 1), without a remainder.
        term = product / (i + 1);
        sum = sum.saturating_add(term);
    }
    sum
}

/// The longest run after which a value with so many fraction bits (at most 63) is off by no more than 2^−`within` LSB;
/// none if the first word's own rounding is more. Constants run for ever.
#[must_use]
pub fn longest_run(degree: u32, fraction_bits: u32, within: u32) -> Option<u64> {
    let allowed = 1u128.checked_shl((fraction_bits + 1).checked_sub(within)?)?;
    let fits = |steps: u64| half_ulps(degree, steps) <= allowed;
    if fits(u64::MAX) {
        return Some(u64::MAX);
    }
    let (mut good, mut bad) = (0, u64::MAX);
    while bad - good > 1 {
        let middle = good + (bad - good) / 2;
        if fits(middle) {
            good = middle;
        } else {
            bad = middle;
        }
    }
    Some(good)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interpolate::cubic_1::Cubic1Model;

    /// Words that are all half an ulp too large, against the same with 20 fraction bits more.
    #[test]
    fn the_bound_is_reached_and_not_exceeded() {
        for (degree, steps) in [(0, 500u64), (1, 500), (2, 500), (3, 500), (3, 1), (3, 2)] {
            let word = |order: usize| i64::from(order <= degree as usize);
            // One half-ulp is the unit here.
            let mut m = Cubic1Model::default();
            m.clock(64, true, false, [word(0), word(1), word(2), word(3)]);
            for _ in 0..steps {
                m.clock(64, false, true, [0; 4]);
            }
            assert_eq!(
                m.value as u128,
                half_ulps(degree, steps),
                "{degree} {steps}"
            );
        }
    }

    #[test]
    fn the_table_of_runs() {
        let rows = [
            (12, [2047, 63, 23]),
            (20, [524_287, 1023, 146]),
            (24, [8_388_607, 4095, 369]),
            (36, [34_359_738_367, 262_143, 5907]),
            (48, [140_737_488_355_327, 16_777_215, 94_519]),
            (52, [2_251_799_813_685_247, 67_108_863, 238_173]),
        ];
        for (bits, want) in rows {
            let got = [1, 2, 3].map(|d| longest_run(d, bits, 2).unwrap());
            assert_eq!(got, want, "{bits} fraction bits");
        }
        assert_eq!(longest_run(0, 1, 2), Some(u64::MAX));
        assert_eq!(longest_run(3, 0, 2), None);
    }

    #[test]
    fn one_step_more_is_too_much() {
        for degree in 1..=3 {
            for bits in [8, 20, 40, 62] {
                let n = longest_run(degree, bits, 1).unwrap();
                assert!(half_ulps(degree, n) <= 1 << bits);
                assert!(half_ulps(degree, n + 1) > 1 << bits);
            }
        }
    }
}
