//! From N × N samples per pixel to pixels: weighted sums whose weights add up to 1 (Loisel 1996, section on filtering; what
//! is printed there as a box filter is a tent).
//!
//! The box takes the N × N samples of its pixel alike. The tent reaches to the centres of the neighbouring pixels and
//! falls off linearly in x and in y: a sample t pixels from the centre, t = (2j + 1 − N)/(2N), weighs 1 − |t| in each
//! direction, in whole numbers 2N − |2j + 1 − N|. Beyond the border of the frame there are no
//! samples, and the weights of the others are scaled up.

use crate::method::UnknownName;
use crate::render::Frame;
use rayon::prelude::*;
use std::str::FromStr;

/// How the samples of a pixel are weighted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Filter {
    /// All samples of the pixel alike.
    #[default]
    Box,
    /// Less with distance, to the centres of the neighbouring pixels.
    Tent,
}

impl Filter {
    /// The names.
    pub const NAMES: [&'static str; 2] = ["box", "tent"];

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Box => "box",
            Self::Tent => "tent",
        }
    }
}

impl FromStr for Filter {
    type Err = UnknownName;

    fn from_str(s: &str) -> Result<Self, UnknownName> {
        match s {
            "box" => Ok(Self::Box),
            "tent" => Ok(Self::Tent),
            _ => Err(UnknownName::new("filter", s, &Self::NAMES)),
        }
    }
}

/// The weights of the samples around pixel `k` of `count` in one direction: the first sample and its successors'.
fn weights(k: u32, count: u32, n: u32, filter: Filter) -> (usize, Vec<u32>) {
    let (centre, n) = (i64::from(k * n), i64::from(n));
    let all = match filter {
        Filter::Box => centre..centre + n,
        Filter::Tent => centre - n..centre + 2 * n,
    };
    let weight = |at: i64| match filter {
        Filter::Box => 1,
        Filter::Tent => (2 * n - (2 * (at - centre) + 1 - n).abs()).max(0),
    };
    let inside = |at: &i64| (0..i64::from(count) * n).contains(at) && weight(*at) > 0;
    let used: Vec<i64> = all.filter(inside).collect();
    let first = used.first().map_or(0, |at| *at as usize);
    (first, used.iter().map(|at| weight(*at) as u32).collect())
}

/// The frame of which `large` holds `n` × `n` samples per pixel; `large` itself for `n` = 1.
///
/// # Panics
/// When the sides of `large` are not multiples of `n`.
#[must_use]
pub fn down(large: Frame, n: u32, filter: Filter) -> Frame {
    if n <= 1 {
        return large;
    }
    assert!(
        large.width.is_multiple_of(n) && large.height.is_multiple_of(n),
        "n samples per pixel"
    );
    let (width, height) = (large.width / n, large.height / n);
    let columns: Vec<_> = (0..width).map(|x| weights(x, width, n, filter)).collect();
    let mut small = Frame::new(width, height, [0; 3]);
    let stride = large.width as usize;
    small
        .pixels
        .par_chunks_mut(width as usize)
        .enumerate()
        .for_each(|(y, line)| {
            let (first, down) = weights(y as u32, height, n, filter);
            // Down first: sums of columns, then of those across.
            let mut sums = vec![[0u32; 3]; stride];
            for (row, weight) in large.pixels.chunks_exact(stride).skip(first).zip(&down) {
                for (sum, pixel) in sums.iter_mut().zip(row) {
                    for c in 0..3 {
                        sum[c] += weight * u32::from(pixel[c]);
                    }
                }
            }
            let down: u32 = down.iter().sum();
            for (pixel, (first, across)) in line.iter_mut().zip(&columns) {
                let total = down * across.iter().sum::<u32>();
                let mut sum = [total / 2; 3];
                for (s, weight) in sums[*first..].iter().zip(across) {
                    for c in 0..3 {
                        sum[c] += weight * s[c];
                    }
                }
                *pixel = sum.map(|s| (s / total) as u8);
            }
        });
    small
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::SAMPLE_LIMIT;
    use proptest::prelude::*;

    const BOTH: [Filter; 2] = [Filter::Box, Filter::Tent];

    #[test]
    fn weights_of_the_tent() {
        // The samples of 2 × 2 per pixel lie 1/4 and 3/4 pixel from the centre.
        assert_eq!(weights(3, 9, 2, Filter::Tent), (5, vec![1, 3, 3, 1]));
        assert_eq!(weights(0, 9, 2, Filter::Tent), (0, vec![3, 3, 1]));
        assert_eq!(weights(3, 9, 3, Filter::Tent), (8, vec![2, 4, 6, 4, 2]));
        assert_eq!(weights(3, 9, 3, Filter::Box), (9, vec![1, 1, 1]));
        for n in 1..=SAMPLE_LIMIT {
            // The largest sum: all white, squared weights.
            let (_, w) = weights(1, 3, n, Filter::Tent);
            let sum: u64 = w.iter().map(|w| u64::from(*w)).sum();
            assert!(sum * sum * 256 < u64::from(u32::MAX));
            assert_eq!(sum, 2 * u64::from(n) * u64::from(n));
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(60))]
        #[test]
        fn one_colour_stays_that_colour(n in 1..=SAMPLE_LIMIT, w in 1..7u32, h in 1..7u32, colour: [u8; 3]) {
            for filter in BOTH {
                let frame = down(Frame::new(w * n, h * n, colour), n, filter);
                prop_assert_eq!(frame, Frame::new(w, h, colour));
            }
        }

        /// What the filter does is a weighted sum: against the definition, in real numbers, for any picture.
        #[test]
        fn pixels_are_weighted_means(n in 1..6u32, bytes in prop::collection::vec(any::<u8>(), 5 * 5 * 4 * 3), x in 0..4u32, y in 0..3u32) {
            let large = Frame {
                width: 4 * n,
                height: 3 * n,
                pixels: (0..12 * n * n).map(|k| [bytes[k as usize % bytes.len()], bytes[(7 * k + 1) as usize % bytes.len()], k as u8]).collect(),
            };
            for filter in BOTH {
                let small = down(large.clone(), n, filter);
                let (mut sum, mut total) = ([0.0; 3], 0.0);
                for (k, p) in large.pixels.iter().enumerate() {
                    let at = |k: u32, pixel: u32| (f64::from(k) + 0.5) / f64::from(n) - (f64::from(pixel) + 0.5);
                    let (dx, dy) = (at(k as u32 % large.width, x), at(k as u32 / large.width, y));
                    let weight = match filter {
                        Filter::Box => f64::from(u8::from(dx.abs() < 0.5 && dy.abs() < 0.5)),
                        Filter::Tent => (1.0 - dx.abs()).max(0.0) * (1.0 - dy.abs()).max(0.0),
                    };
                    total += weight;
                    for c in 0..3 {
                        sum[c] += weight * f64::from(p[c]);
                    }
                }
                let got = small.pixels[(y * 4 + x) as usize];
                for c in 0..3 {
                    prop_assert!((f64::from(got[c]) - sum[c] / total).abs() <= 0.5 + 1e-9);
                }
            }
        }
    }

    /// Coverage of a pixel by a half plane, against its area: the finer, the nearer, as regular grids are known to be.
    #[test]
    fn edges_come_near_their_area() {
        use rand::rngs::StdRng;
        use rand::{Rng, SeedableRng};
        let mut rng = StdRng::seed_from_u64(2);
        for (n, max, rms) in [
            (1, 0.5, 0.292),
            (2, 0.25, 0.096),
            (4, 0.125, 0.0345),
            (8, 0.0625, 0.0119),
        ] {
            let (mut worst, mut sum) = (0.0f64, 0.0);
            let trials = 4000;
            for _ in 0..trials {
                let (s, c) = rng.random_range(0.0..std::f64::consts::TAU).sin_cos();
                // Through a point anywhere in the pixel.
                let mut somewhere = || rng.random_range(-0.5..0.5);
                let offset = c * somewhere() + s * somewhere();
                let inside = |x: f64, y: f64| c * (x - 0.5) + s * (y - 0.5) < offset;
                let pixels = (0..n * n).map(|k| {
                    let at = |k: u32| (f64::from(k) + 0.5) / f64::from(n);
                    [u8::from(inside(at(k % n), at(k / n))) * 255; 3]
                });
                let large = Frame {
                    width: n,
                    height: n,
                    pixels: pixels.collect(),
                };
                let got = f64::from(down(large, n, Filter::Box).pixels[0][0]) / 255.0;
                // The area of the unit square on that side, by a fine sum of exact chords.
                let strips = 400;
                let area: f64 = (0..strips)
                    .map(|k| {
                        let y = (f64::from(k) + 0.5) / f64::from(strips);
                        let rest = offset - s * (y - 0.5);
                        let cut = (rest / c + 0.5).clamp(0.0, 1.0);
                        if c > 0.0 {
                            cut
                        } else {
                            1.0 - cut
                        }
                    })
                    .sum::<f64>()
                    / f64::from(strips);
                let error = (got - area).abs();
                worst = worst.max(error);
                sum += error * error;
            }
            let got_rms = (sum / f64::from(trials)).sqrt();
            assert!(worst <= max + 0.01, "{n}: {worst}");
            assert!((got_rms / rms - 1.0).abs() < 0.1, "{n}: {got_rms}");
        }
    }

    #[test]
    fn names() {
        assert_eq!("tent".parse(), Ok(Filter::Tent));
        assert_eq!("box".parse(), Ok(Filter::Box));
        assert_eq!(
            "bo".parse::<Filter>().unwrap_err().to_string(),
            "unknown filter 'bo'; the nearest is 'box' of box, tent"
        );
    }
}
