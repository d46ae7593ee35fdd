//! Weighted writing: old·(1 − w) + new·w. Abbas (2003) adds the weighted colour to what is there, which is right on an
//! empty background without crossings only, and overflows elsewhere; this form never leaves the range of its inputs.

/// `old` moved towards `new` by `level` of `full`, rounded to nearest; levels above full count as full.
#[must_use]
pub fn blend(old: [u8; 3], new: [u8; 3], level: u16, full: u16) -> [u8; 3] {
    let full = u32::from(full.max(1));
    let level = u32::from(level).min(full);
    [0, 1, 2].map(|c| {
        let sum = u32::from(old[c]) * (full - level) + u32::from(new[c]) * level;
        ((sum + full / 2) / full) as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_are_exact_and_between_is_nearest() {
        for full in [1u16, 7, 15, 255] {
            for old in (0..=255u8).step_by(5) {
                for new in (0..=255u8).step_by(3) {
                    assert_eq!(blend([old; 3], [new; 3], 0, full), [old; 3]);
                    assert_eq!(blend([old; 3], [new; 3], full, full), [new; 3]);
                    for level in 0..=full {
                        let w = f64::from(level) / f64::from(full);
                        let want = f64::from(old) * (1.0 - w) + f64::from(new) * w;
                        let got = f64::from(blend([old; 3], [new; 3], level, full)[1]);
                        assert!((got - want).abs() <= 0.5 + 1e-9);
                    }
                }
            }
        }
        assert_eq!(blend([10; 3], [200; 3], 9, 7), [200; 3]);
    }

    #[test]
    fn crossings_do_not_overflow() {
        let mut c = [0; 3];
        for _ in 0..1000 {
            c = blend(c, [250, 3, 100], 200, 255);
        }
        assert_eq!(c, [250, 3, 100]);
    }
}
