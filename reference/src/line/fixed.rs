//! The cone-filtered line in integers, as hardware would draw it: [`SetUp`] rounded to words, D with b fraction bits.
//!
//! D by additions drifts: its two increments are rounded separately, so after N columns it may be off by N·2^−(b+1)
//! (0.10 pixels at b = 12 and N ≤ 1024, 0.025 at 14, 0.007 at 16; less than half an LSB of 255 levels takes b = 19).
//! Making one increment from the other does not help. D from the error term costs a multiplier and never drifts: its
//! error is |2·dY·x − 2·dX·y|·2^−(s+1) ≤ dX·2^−(s+1) for a scale of s fraction bits, 0.002 at s = 18 and dX ≤ 1024.

use super::coverage::Table;
use super::set_up::SetUp;
use super::{Path, Pixel};

/// How D is kept up to date.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// One addition per column.
    Increments,
    /// One multiplication of the error term by d/2 with so many fraction bits (at most 32).
    FromError {
        /// Fraction bits of the scale.
        scale_bits: u32,
    },
}

/// The rounded words of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Words {
    form: Form,
    fraction_bits: u32,
    cosine: i64,
    start: i64,
    stay: i64,
    step: i64,
    scale: i64,
    offset: i64,
    four: bool,
    point: bool,
}

impl Words {
    /// Rounds a set-up to `fraction_bits` (at most 32) below the point.
    #[must_use]
    pub fn new(s: &SetUp, fraction_bits: u32, form: Form) -> Self {
        let round = |v: f64, bits: u32| (v * (1i64 << bits.min(32)) as f64).round() as i64;
        let stay = round(s.distance_stay, fraction_bits);
        Self {
            form,
            fraction_bits: fraction_bits.min(32),
            cosine: round(s.cosine, fraction_bits),
            start: -stay,
            stay,
            step: round(s.distance_step, fraction_bits),
            scale: match form {
                Form::Increments => 0,
                Form::FromError { scale_bits } => round(s.distance_scale, scale_bits),
            },
            offset: s.error_offset,
            four: s.fourth,
            point: s.columns == 0,
        }
    }

    /// D of every column in units of 2^−b pixels.
    pub fn distances<'a>(&'a self, path: &Path) -> impl Iterator<Item = i64> + 'a {
        let mut d = self.start;
        path.columns().map(move |c| {
            d += if c.stepped { -self.step } else { self.stay };
            match self.form {
                Form::Increments => d,
                Form::FromError { scale_bits } => {
                    let product = i128::from(c.error + self.offset) * i128::from(self.scale);
                    rescale(product, scale_bits.min(32), self.fraction_bits)
                }
            }
        })
    }

    /// Pixels with their levels, those above 0, major coordinate rising.
    pub fn pixels<'a>(
        &'a self,
        path: &'a Path,
        table: &'a Table,
    ) -> impl Iterator<Item = (Pixel, u16)> + 'a {
        let count = match (self.point, self.four) {
            (true, _) => 1,
            (false, false) => 3,
            (false, true) => 4,
        };
        let unit = (1i64 << self.fraction_bits) as f64;
        path.columns()
            .zip(self.distances(path))
            .flat_map(move |(c, d)| {
                let side = if d < 0 { -1 } else { 1 };
                [
                    (c.y, d),
                    (c.y + 1, self.cosine - d),
                    (c.y - 1, self.cosine + d),
                    (c.y + 2 * side, 2 * self.cosine - d.abs()),
                ]
                .into_iter()
                .take(count)
                // The division by a power of two is exact: the table's address is the leading bits of |D|.
                .map(move |(y, d)| (path.place(c.x, y), table.level(d as f64 / unit)))
                .filter(|(_, level)| *level > 0)
            })
    }
}

/// A product with `from` fraction bits, rounded to `to` (halves upwards).
fn rescale(v: i128, from: u32, to: u32) -> i64 {
    let scaled = if from > to {
        (v + (1 << (from - to - 1))) >> (from - to)
    } else {
        v << (to - from)
    };
    scaled as i64
}

#[cfg(test)]
mod tests {
    use super::super::{cone, coverage};
    use super::*;
    use std::collections::HashMap;

    fn paths() -> impl Iterator<Item = Path> {
        (1..=1024)
            .step_by(11)
            .chain([1023, 1024])
            .flat_map(|dx: i32| {
                (0..=dx)
                    .step_by(dx as usize / 23 + 1)
                    .map(move |dy| Path::new(Pixel { x: 0, y: 0 }, Pixel { x: dx, y: dy }).unwrap())
            })
    }

    /// Largest error of D in pixels over lines of up to 1024 columns.
    fn worst(bits: u32, form: Form) -> f64 {
        let mut worst = 0.0f64;
        for path in paths() {
            let words = Words::new(&SetUp::new(&path), bits, form);
            for (c, d) in path.columns().zip(words.distances(&path)) {
                let d = d as f64 / f64::from(1u32 << bits);
                worst = worst.max((d - cone::distance(&path, c)).abs());
            }
        }
        worst
    }

    #[test]
    fn word_lengths_of_d() {
        for (bits, want) in [(12, 0.10), (14, 0.025), (16, 0.007)] {
            let got = worst(bits, Form::Increments);
            println!("b = {bits}: {got:.4} pixels ({want})");
            assert!((0.7..1.35).contains(&(got / want)), "{bits}: {got}");
            assert!(got <= 1025.0 * 0.5f64.powi(bits as i32 + 1));
        }
        // Half an LSB of 255 levels: 1/510 of V, whose slope is at most 3/π.
        let half = 1.0 / 510.0 / coverage::weight(0.0).max(0.955);
        assert!(worst(19, Form::Increments) < half);
        assert!(worst(17, Form::Increments) > half);
        let got = worst(19, Form::FromError { scale_bits: 18 });
        println!("from the error term, 18-bit scale: {got:.5} pixels (0.0018)");
        assert!((0.0009..=0.0020).contains(&got), "{got}");
    }

    #[test]
    fn integer_lines_are_within_one_level_of_the_real_ones() {
        for (address, full) in [(3, 7), (4, 15), (9, 255)] {
            let table = Table::new(address, full);
            for form in [Form::Increments, Form::FromError { scale_bits: 22 }] {
                for path in paths().step_by(7) {
                    let words = Words::new(&SetUp::new(&path), 22, form);
                    let got: HashMap<_, _> = words.pixels(&path, &table).collect();
                    let real: HashMap<_, _> = cone::pixels(&path, cone::Fourth::NearDiagonal)
                        .map(|(p, d)| (p, coverage::weight(d) * f64::from(full)))
                        .collect();
                    for p in got.keys().chain(real.keys()) {
                        let a = got.get(p).copied().map_or(0.0, f64::from);
                        let b = real.get(p).copied().unwrap_or(0.0);
                        assert!((a - b).abs() <= 1.0, "{path:?} {p:?}: {a} {b}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_point_needs_no_division() {
        let path = Path::new(Pixel { x: 7, y: 7 }, Pixel { x: 7, y: 7 }).unwrap();
        let words = Words::new(&SetUp::new(&path), 16, Form::FromError { scale_bits: 18 });
        let all: Vec<_> = words.pixels(&path, &Table::new(4, 255)).collect();
        assert_eq!(all, [(Pixel { x: 7, y: 7 }, 199)]);
    }
}
