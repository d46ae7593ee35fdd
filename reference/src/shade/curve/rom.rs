//! A table over an angle as hardware keeps it: 2^k words, addressed by the leading bits of |x|, each rounded to some
//! data bits (Abbas 2003, fig. 6.5). Words hold the value at the centre of their bin, which halves the error of the
//! figure's (the value where the bin begins). Beyond the table the value is 0: an address register as narrow as the
//! printed one would wrap and repeat the highlight.

/// Where in its bin a word samples the function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sample {
    /// In the middle.
    Centre,
    /// Where it begins.
    Start,
}

/// The table.
#[derive(Clone, Debug, PartialEq)]
pub struct Rom {
    words: Vec<u16>,
    /// Words per rad.
    density: f64,
    /// 1 / the largest word.
    unit: f64,
}

impl Rom {
    /// `address` bits over angles 0..`range`, `data` bits (at most 16 of each) for values 0..=1.
    #[must_use]
    pub fn new(
        address: u32,
        data: u32,
        range: f64,
        sample: Sample,
        f: impl Fn(f64) -> f64,
    ) -> Self {
        let count = 1u32 << address.min(16);
        let full = f64::from((1u32 << data.min(16)) - 1);
        let bin = range / f64::from(count);
        let offset = match sample {
            Sample::Centre => 0.5,
            Sample::Start => 0.0,
        };
        Self {
            words: (0..count)
                .map(|i| (f((f64::from(i) + offset) * bin).clamp(0.0, 1.0) * full).round() as u16)
                .collect(),
            density: 1.0 / bin,
            unit: 1.0 / full,
        }
    }

    /// The word for an angle, as a fraction of full scale.
    #[must_use]
    pub fn value(&self, x: f64) -> f64 {
        // The conversion truncates and saturates.
        let address = (x.abs() * self.density) as usize;
        self.words
            .get(address)
            .map_or(0.0, |w| f64::from(*w) * self.unit)
    }

    /// Largest distance from an even function that falls as the angle grows and whose range ends at 0: in each bin the
    /// word is compared with the function at both ends, so nothing in between is missed.
    #[must_use]
    pub fn distance(&self, f: impl Fn(f64) -> f64) -> f64 {
        let bin = 1.0 / self.density;
        let mut worst = f(self.words.len() as f64 * bin).abs();
        for (i, w) in self.words.iter().enumerate() {
            let value = f64::from(*w) * self.unit;
            for end in [i, i + 1] {
                worst = worst.max((value - f(end as f64 * bin)).abs());
            }
        }
        worst
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    /// The rows of the notes for cos² with k address and k data bits: bits, LSB at bin centres, LSB at bin starts.
    #[test]
    fn quantisation_is_as_measured() {
        let rows = [
            (4, 17.6, 33.4),
            (5, 9.1, 16.6),
            (6, 4.7, 8.3),
            (7, 2.6, 4.1),
            (8, 1.2, 2.1),
            (10, 0.3, 0.5),
        ];
        let f = |x: f64| x.cos().powi(2);
        for (k, centre, start) in rows {
            let error = |s| 255.0 * Rom::new(k, k, FRAC_PI_2, s, f).distance(f);
            let (c, s) = (error(Sample::Centre), error(Sample::Start));
            println!("{k} bits: centre {c:.2} LSB, start {s:.2} LSB");
            assert!(
                (c - centre).abs() < 0.16 && (s - start).abs() < 0.16,
                "{k}: {c} {s}"
            );
            assert!(c < s);
        }
    }

    #[test]
    fn nothing_wraps_and_nothing_is_missed() {
        let f = |x: f64| x.cos().max(0.0);
        let rom = Rom::new(6, 6, FRAC_PI_2, Sample::Centre, f);
        for x in [FRAC_PI_2 + 1e-9, 2.0, 6.3, 1e9, f64::INFINITY] {
            assert_eq!(rom.value(x), 0.0);
            assert_eq!(rom.value(-x), 0.0);
        }
        let worst = (0..200_000)
            .map(|i| f64::from(i) * 1e-5)
            .map(|x| (rom.value(x) - f(x)).abs())
            .fold(0.0, f64::max);
        let bound = rom.distance(f);
        assert!(worst <= bound && worst > 0.99 * bound, "{worst} {bound}");
    }
}
