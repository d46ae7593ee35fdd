//! Ripmaps, mip-maps for each axis by itself (Zed3D 1996, "Nonuniform mipmaps"): the picture with i halvings of its
//! columns and j of its rows, for all i and j. A pixel that covers much in one direction and little in the other is
//! filtered in one only. Between levels, four neighbours weigh with the products of the fractions: at (3.7, 5.2) these
//! are .24 for (3, 5), .56 for (4, 5), .06 for (3, 6) and .14 for (4, 6), where the text has (4, 7); and it counts
//! 64 × 32 of 64 × 64 the other way round than its other examples. All levels take 4 times the memory of the picture.

use super::{point, pyramid, Footprint, Texels, Wrap};
use glam::DVec2;

/// A picture in all combinations of halved sides.
#[derive(Clone, Debug, PartialEq)]
pub struct Ripmap {
    /// `levels[j][i]`: i halvings of the columns, j of the rows.
    levels: Vec<Vec<Texels>>,
}

/// The level below, the level above (not beyond `last`) and the share of the latter.
fn split(level: f64, last: usize) -> ([usize; 2], f64) {
    let level = level.clamp(0.0, last as f64);
    let lower = (level as usize).min(last);
    ([lower, (lower + 1).min(last)], level - lower as f64)
}

/// The shares of (lower, lower), (upper, lower), (lower, upper), (upper, upper): column level first.
#[must_use]
pub fn shares(columns: f64, rows: f64) -> [f64; 4] {
    [
        (1.0 - columns) * (1.0 - rows),
        columns * (1.0 - rows),
        (1.0 - columns) * rows,
        columns * rows,
    ]
}

impl Ripmap {
    /// Makes all levels.
    #[must_use]
    pub fn new(picture: Texels) -> Self {
        let columns = pyramid::levels(picture.width());
        let rows = pyramid::levels(picture.height());
        Self {
            levels: pyramid::chain(picture, rows, pyramid::halve_height)
                .into_iter()
                .map(|row| pyramid::chain(row, columns, pyramid::halve_width))
                .collect(),
        }
    }

    /// Filtered at a place given in texels of the picture.
    #[must_use]
    pub fn sample(&self, wrap: Wrap, at: DVec2, footprint: &Footprint) -> [f64; 3] {
        let base = &self.levels[0][0];
        let sides = footprint.sides();
        let (i, f) = split(sides.x.log2(), self.levels[0].len() - 1);
        let (j, g) = split(sides.y.log2(), self.levels.len() - 1);
        let four = [(i[0], j[0]), (i[1], j[0]), (i[0], j[1]), (i[1], j[1])];
        let mut sum = [0.0; 3];
        for ((i, j), share) in four.into_iter().zip(shares(f, g)) {
            if share == 0.0 {
                continue;
            }
            let t = &self.levels[j][i];
            let ratio = DVec2::new(
                t.width() as f64 / base.width() as f64,
                t.height() as f64 / base.height() as f64,
            );
            let value = point::bilinear(t, wrap, at * ratio);
            for c in 0..3 {
                sum[c] += share * value[c];
            }
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shares_of_the_example() {
        let ([i, k], f) = split(3.7, 9);
        let ([j, l], g) = split(5.2, 9);
        assert_eq!([i, k, j, l], [3, 4, 5, 6]);
        let want = [0.24, 0.56, 0.06, 0.14];
        for (got, want) in shares(f, g).into_iter().zip(want) {
            assert!((got - want).abs() < 1e-12);
        }
        assert_eq!(split(99.0, 4), ([4, 4], 0.0));
    }

    #[test]
    fn only_the_crowded_axis_is_filtered() {
        // Stripes along the rows: squeezing the columns must not touch them.
        let stripes = Texels::from_fn(64, 64, |_, y| [(y % 2) as f32; 3]);
        let r = Ripmap::new(stripes);
        assert_eq!((r.levels.len(), r.levels[0].len()), (7, 7));
        let texels: usize = r
            .levels
            .iter()
            .flatten()
            .map(|t| t.width() * t.height())
            .sum();
        assert_eq!(texels, 127 * 127);
        let at = DVec2::new(20.0, 5.5);
        let squeezed = |x: f64, y: f64| {
            let f = Footprint {
                right: DVec2::X * x,
                down: DVec2::Y * y,
            };
            r.sample(Wrap::Repeat, at, &f)[0]
        };
        assert_eq!(squeezed(16.0, 1.0), 1.0);
        assert!((squeezed(1.0, 16.0) - 0.5).abs() < 1e-9);
        // Half-way between the levels 0 and 1 of the rows.
        assert!((squeezed(5.0, 0.5f64.exp2()) - 0.75).abs() < 1e-9);
    }
}
