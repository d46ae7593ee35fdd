//! Summed-area tables (Crow 1984; Zed3D 1996, "Summed area tables"): S(x, y) is the sum of all texels left of and below
//! (x, y), and the mean over a box takes four of them, Q = S(r, s) − S(p, s) − S(r, q) + S(p, q), Q/((r − p)(s − q)),
//! over p < x ≤ r, q < y ≤ s (half open, where the text has it closed; its divisor is right).
//!
//! Between texel borders S is interpolated bilinearly, which makes it the exact integral of the picture with square
//! texels; a box of one texel is then bilinear interpolation. Sums are whole numbers of 2⁻²⁴ in 64 bits: 4096² texels
//! reach 2⁴⁸, two periods each way 2⁵⁰, which f64 holds exactly. Only boxes along the axes of the texture can be
//! averaged, and all parts of a box weigh the same.

use super::wrap::fold;
use super::{Footprint, Texels, Wrap};
use glam::DVec2;

/// Steps of one texel's full scale.
const UNIT: f64 = 16_777_216.0;

/// The sums of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct SummedArea {
    width: usize,
    height: usize,
    /// (width + 1)·(height + 1) sums, the first row and column zero.
    sums: Vec<[i64; 3]>,
}

impl SummedArea {
    /// Sums a picture up.
    #[must_use]
    pub fn new(picture: &Texels) -> Self {
        let (width, height) = (picture.width(), picture.height());
        let mut sums = vec![[0; 3]; (width + 1) * (height + 1)];
        for y in 0..height {
            let mut row = [0; 3];
            for x in 0..width {
                let below = sums[y * (width + 1) + x + 1];
                let texel = picture.at(x, y);
                for c in 0..3 {
                    row[c] += (texel[c] * UNIT).round() as i64;
                    sums[(y + 1) * (width + 1) + x + 1][c] = below[c] + row[c];
                }
            }
        }
        Self {
            width,
            height,
            sums,
        }
    }

    /// The sum left of column border `x` and below row border `y`, of the picture repeated; up to two periods.
    fn corner(&self, x: usize, y: usize) -> [i64; 3] {
        let at = |x: usize, y: usize| self.sums[y * (self.width + 1) + x];
        let (a, x) = (x / self.width, x % self.width);
        let (b, y) = (y / self.height, y % self.height);
        let (all, right) = (at(self.width, self.height), at(self.width, y));
        let (top, here) = (at(x, self.height), at(x, y));
        let (a, b) = (a as i64, b as i64);
        [0, 1, 2].map(|c| a * b * all[c] + a * right[c] + b * top[c] + here[c])
    }

    /// S between the borders; `x` and `y` at least 0 and at most two periods.
    fn integral(&self, x: f64, y: f64) -> [f64; 3] {
        let (i, j) = (x as usize, y as usize);
        let (f, g) = (x - i as f64, y - j as f64);
        let mut sum = [0.0; 3];
        for (corner, share) in [
            ((i, j), (1.0 - f) * (1.0 - g)),
            ((i + 1, j), f * (1.0 - g)),
            ((i, j + 1), (1.0 - f) * g),
            ((i + 1, j + 1), f * g),
        ] {
            // A border of the box that falls on a border of texels needs no neighbour.
            if share > 0.0 {
                let value = self.corner(corner.0, corner.1);
                for c in 0..3 {
                    sum[c] += share * value[c] as f64;
                }
            }
        }
        sum
    }

    /// The mean over a box around `centre` of `sides` texels; each side at least 1 and no more than the picture's.
    /// Where the picture does not repeat, the box is cut at its border.
    #[must_use]
    pub fn mean(&self, wrap: Wrap, centre: DVec2, sides: DVec2) -> [f64; 3] {
        let range = |centre: f64, side: f64, n: usize| {
            let n = n as f64;
            let side = side.clamp(1.0, n);
            match wrap {
                Wrap::Repeat => {
                    let from = fold(centre - side / 2.0, n);
                    (from, from + side)
                }
                Wrap::Clamp => {
                    let centre = centre.clamp(0.5, n - 0.5);
                    ((centre - side / 2.0).max(0.0), (centre + side / 2.0).min(n))
                }
            }
        };
        let (p, r) = range(centre.x, sides.x, self.width);
        let (q, s) = range(centre.y, sides.y, self.height);
        let (rs, ps) = (self.integral(r, s), self.integral(p, s));
        let (rq, pq) = (self.integral(r, q), self.integral(p, q));
        let area = (r - p) * (s - q) * UNIT;
        [0, 1, 2].map(|c| ((rs[c] - ps[c] - rq[c] + pq[c]) / area).clamp(0.0, 1.0))
    }

    /// The mean over the box around a pixel.
    #[must_use]
    pub fn sample(&self, wrap: Wrap, at: DVec2, footprint: &Footprint) -> [f64; 3] {
        self.mean(wrap, at, footprint.sides())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture::point;
    use proptest::prelude::*;

    fn picture(w: usize, h: usize) -> Texels {
        Texels::from_fn(w, h, |x, y| {
            let v = ((x * 37 + y * 101) % 97) as f32 / 97.0;
            [v, 1.0 - v, v * v]
        })
    }

    /// The mean from the definition: every texel of the repeated picture with the area it shares with the box.
    fn by_definition(t: &Texels, centre: DVec2, sides: DVec2) -> [f64; 3] {
        let (lo, hi) = (centre - sides / 2.0, centre + sides / 2.0);
        let share = |i: i64, lo: f64, hi: f64| (hi.min(i as f64 + 1.0) - lo.max(i as f64)).max(0.0);
        let mut sum = [0.0; 3];
        for y in lo.y.floor() as i64..=hi.y as i64 {
            for x in lo.x.floor() as i64..=hi.x as i64 {
                let area = share(x, lo.x, hi.x) * share(y, lo.y, hi.y);
                let texel = t.at(
                    x.rem_euclid(t.width() as i64) as usize,
                    y.rem_euclid(t.height() as i64) as usize,
                );
                for c in 0..3 {
                    sum[c] += area * texel[c];
                }
            }
        }
        sum.map(|v| v / (sides.x * sides.y))
    }

    /// A thousandth of an LSB; the sums are rounded to 2⁻²⁴.
    const BOUND: f64 = 1e-3 / 255.0;

    proptest! {
        #[test]
        fn the_mean_of_any_box(
            w in 3usize..40, h in 3usize..40, x in 0.0..1.0f64, y in 0.0..1.0f64, a in 0.0..1.0f64, b in 0.0..1.0f64,
        ) {
            let t = picture(w, h);
            let size = DVec2::new(w as f64, h as f64);
            let sides = DVec2::ONE + DVec2::new(a, b) * (size - DVec2::ONE);
            let centre = DVec2::new(x, y) * size;
            let got = SummedArea::new(&t).mean(Wrap::Repeat, centre, sides);
            let want = by_definition(&t, centre, sides);
            for c in 0..3 {
                prop_assert!((got[c] - want[c]).abs() < BOUND);
            }
        }

        #[test]
        fn a_box_of_one_texel_is_bilinear(x in -5.0..50.0f64, y in -5.0..50.0f64, clamp: bool) {
            let t = picture(23, 31);
            let wrap = if clamp { Wrap::Clamp } else { Wrap::Repeat };
            // Beside a clamped picture the box is cut, which is not bilinear.
            let at = if clamp { DVec2::new(x, y).clamp(DVec2::splat(0.5), DVec2::new(22.5, 30.5)) } else { DVec2::new(x, y) };
            let got = SummedArea::new(&t).mean(wrap, at, DVec2::ONE);
            let want = point::bilinear(&t, wrap, at);
            for c in 0..3 {
                prop_assert!((got[c] - want[c]).abs() < BOUND);
            }
        }
    }

    /// On texel borders the formula of the text: rows and columns after p and q up to r and s.
    #[test]
    fn whole_boxes_are_half_open() {
        let t = picture(9, 9);
        let table = SummedArea::new(&t);
        let (p, q, r, s) = (2, 1, 6, 8);
        let mut sum = 0.0;
        for y in q..s {
            for x in p..r {
                sum += t.at(x, y)[0];
            }
        }
        let lo = DVec2::new(p as f64, q as f64);
        let hi = DVec2::new(r as f64, s as f64);
        let got = table.mean(Wrap::Repeat, (lo + hi) / 2.0, hi - lo)[0];
        assert!((got - sum / 28.0).abs() < BOUND);
    }

    #[test]
    fn a_single_texel_and_boxes_beyond_the_picture() {
        let one = Texels::from_fn(1, 1, |_, _| [0.25, 0.5, 1.0]);
        let table = SummedArea::new(&one);
        for wrap in [Wrap::Repeat, Wrap::Clamp] {
            for (at, side) in [(0.5, 1.0), (-77.3, 9.0), (1e9, 0.0)] {
                let got = table.mean(wrap, DVec2::splat(at), DVec2::splat(side));
                for (g, w) in got.into_iter().zip([0.25, 0.5, 1.0]) {
                    assert!((g - w).abs() < BOUND, "{got:?}");
                }
            }
        }
    }
}
