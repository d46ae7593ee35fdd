//! Words of the power table (see `shadegate_hdl::shade::phong::power` for the bound).

use shadegate_hdl::shade::phong::power::{MAX_EXPONENT, MAX_SCALE, TABLE_FRACTION_BITS};
use shadegate_hdl::shade::phong::power_table::WORDS;

/// Powers below this one are not in the table.
const LEAST: f64 = 1.0 / (1u64 << 14) as f64;

/// The exponent s of the place t = (1 − h)·2^s in the lobe of hⁿ: the largest one with which the table reaches down to
/// powers of 2^−14. `None` for exponents that the core does not draw.
#[must_use]
pub fn lobe_scale(n: f64) -> Option<u32> {
    if !(1.0..=MAX_EXPONENT).contains(&n) {
        return None;
    }
    let reach = 1.0 - LEAST.powf(1.0 / n);
    (0..=MAX_SCALE)
        .rev()
        .find(|s| reach * f64::from(1u32 << s) <= 1.0)
}

/// The words of the table for an exponent n and its [`lobe_scale`] s, in order.
#[must_use]
pub fn power_words(n: f64, s: u32) -> Vec<u64> {
    let unit = (1u64 << TABLE_FRACTION_BITS) as f64;
    let power = |t: f64| (1.0 - t / f64::from(1u32 << s)).max(0.0).powf(n);
    let place = |i: usize| i as f64 / WORDS as f64;
    let word = |i: usize| {
        let (from, to) = (power(place(i)), power(place(i + 1)));
        let middle = power((place(i) + place(i + 1)) / 2.0);
        // The chord, moved by half of what it is off in the middle.
        let start = from + ((middle - (from + to) / 2.0) / 2.0);
        let start = (start * unit).round().clamp(0.0, unit - 1.0) as u64;
        let fall = ((from - to) * unit).round() as u64;
        start << 14 | fall.min(start)
    };
    (0..WORDS).map(word).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use shadegate_hdl::shade::phong::model::power;
    use shadegate_hdl::shade::phong::power::{ERROR, STEEPEST};

    const EXPONENTS: [f64; 21] = [
        1.0, 1.25, 1.5, 1.999, 2.0, 3.0, 5.0, 7.3, 10.0, 13.9, 14.0, 20.0, 32.0, 50.0, 90.5, 100.0,
        128.0, 255.0, 500.0, 1000.0, 2048.0,
    ];

    /// Every place of the table, and where it ends, against the power in f64: the bound holds and is not idle.
    #[test]
    fn the_bound_holds_at_every_place() {
        let mut worst = 0.0f64;
        for n in EXPONENTS {
            let s = lobe_scale(n).expect("drawn");
            let scale = f64::from(1u32 << s);
            assert!(n / scale <= STEEPEST, "{n}: {s}");
            let table: Vec<u32> = power_words(n, s).into_iter().map(|w| w as u32).collect();
            let mut of_n = 0.0f64;
            for place in -3..(1i64 << 19) + 3 {
                // A place stands for half a unit on either side.
                for off in [-0.5, 0.0, 0.5] {
                    let t = (place as f64 + off) / (1u64 << 19) as f64;
                    let h = (1.0 - t / scale).clamp(0.0, 1.0);
                    let got = power(&table, place) as f64 / (1u64 << 17) as f64;
                    of_n = of_n.max((got - h.powf(n)).abs());
                }
            }
            assert!(of_n <= ERROR, "{n}: {of_n:e} > {ERROR:e}");
            worst = worst.max(of_n);
        }
        assert!(worst > 0.6 * ERROR, "{worst:e} of {ERROR:e}");
    }

    #[test]
    fn beyond_the_table_the_power_is_invisible() {
        for n in EXPONENTS {
            let s = lobe_scale(n).expect("drawn");
            let h = 1.0 - 1.0 / f64::from(1u32 << s);
            assert!(h.powf(n) <= LEAST * (1.0 + 1e-9), "{n}");
        }
        assert_eq!(lobe_scale(0.99), None);
        assert_eq!(lobe_scale(2049.0), None);
        assert_eq!(lobe_scale(f64::NAN), None);
    }

    /// The words fit: the value never rises and its fall never exceeds 14 bits or what is there.
    #[test]
    fn words_fall() {
        for n in EXPONENTS {
            for w in power_words(n, lobe_scale(n).expect("drawn")) {
                assert!(w >> 32 == 0 && (w & 0x3fff) <= w >> 14, "{n}: {w:x}");
            }
        }
    }
}
