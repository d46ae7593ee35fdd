//! Blake's modulation (Blake, Disselkoen and Kuijk 1992, section 3.6): along a row, coverage is linear between the ends of
//! its ramps and colour quadratic, so their product is cubic and comes of three additions per pixel and channel,
//! r += dr; dr += d2r; d2r += d3r. Products of the facets in a pixel add up.
//!
//! The paper asks for visible facets only. Here facets are taken from the front until their coverages add up to 1, which
//! is right where facets abut, and where one overlaps the background or another surface at one edge.
//!
//! On the ramps, pixel centres lie beside the triangle and the colour is extrapolated by less than a pixel. Triangles
//! lower than 2 pixels, runs of fewer than four pixels, colours out of 0..=255 on the run and methods without a
//! polynomial are worked out pixel by pixel instead, with the colour of a point within the triangle: a constant factor
//! on single pixels, in the words of the paper.

use super::fragments::{bands, Fragment, Lists, Tally};
use super::paint::{depth, within, Painter};
use super::ramp::RowCoverage;
use super::touched;
use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::{area2, SUBPIXELS};
use crate::render::Frame;
use crate::shade::barycentric::weights;
use crate::shade::differences::{Differences, Interpolant};
use crate::shade::to_byte;
use crate::skips::{self, Skips};
use std::ops::Range;

/// Coverage still open below this is none: rounding of sums.
const CLOSED: f64 = 1e-9;
/// Triangles with a height below this, in pixels, are not extrapolated.
const LOW: f64 = 2.0;
/// Shortest run that differences are set up for.
const SHORT: usize = 4;

/// A cubic along a row, three channels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cubic {
    /// Value at the current pixel, and its first to third differences.
    differences: [[f64; 3]; 4],
}

impl Cubic {
    /// The product of a quadratic and of coverage that starts at `from` and changes by `step` per pixel. Its differences
    /// come from the product rule Δ(uv) = u·Δv + v·Δu + Δu·Δv and not from values, so nothing cancels.
    #[must_use]
    pub fn new(colour: &Differences, from: f64, step: f64) -> Self {
        let channel = |c: usize| {
            let (r, dr, d2r) = (colour.r[c], colour.dr[c], colour.d2r[c]);
            [
                from * r,
                from * dr + step * (r + dr),
                from * d2r + 2.0 * step * (dr + d2r),
                3.0 * step * d2r,
            ]
        };
        let [red, green, blue] = [channel(0), channel(1), channel(2)];
        Self {
            differences: [0, 1, 2, 3].map(|k| [red[k], green[k], blue[k]]),
        }
    }

    /// The value at the current pixel.
    #[must_use]
    pub fn value(&self) -> [f64; 3] {
        self.differences[0]
    }

    /// Moves one pixel to the right: three additions per channel.
    pub fn step(&mut self) {
        for k in 0..3 {
            for c in 0..3 {
                self.differences[k][c] += self.differences[k + 1][c];
            }
        }
    }
}

/// What a pixel needs of a facet: its coverage, and coverage times colour.
type Product = (f64, [f64; 3]);

/// Draws the shaded triangles of a scene.
pub(super) fn draw(p: &Prepared, painter: &Painter, skips: Skips) -> (Frame, Tally) {
    bands(p, |rows, pixels, triangles| {
        band(p, painter, skips, rows, pixels, triangles)
    })
}

/// Whether the colour may be extrapolated beyond the edges: the least height of the triangle, in pixels.
fn is_high(t: &ScreenTriangle) -> bool {
    let longest = (0..3)
        .map(|i| {
            let (a, b) = (t.position[i].pixels(), t.position[(i + 1) % 3].pixels());
            (b.0 - a.0).hypot(b.1 - a.1)
        })
        .fold(0.0, f64::max);
    let area = area2(t.position).abs() as f64 / f64::from(SUBPIXELS) / f64::from(SUBPIXELS);
    area >= LOW * longest
}

/// Whether a quadratic stays within 0..=255 over `n` pixels.
fn stays_in_range(d: &Differences, n: usize) -> bool {
    let last = (n - 1) as f64;
    (0..3).all(|c| {
        let at = |k: f64| d.r[c] + k * d.dr[c] + k * (k - 1.0) / 2.0 * d.d2r[c];
        let turn = 0.5 - d.dr[c] / d.d2r[c];
        let turn = if (0.0..last).contains(&turn) {
            turn
        } else {
            0.0
        };
        [0.0, turn, last]
            .into_iter()
            .all(|k| (0.0..=255.0).contains(&at(k)))
    })
}

fn band(
    p: &Prepared,
    painter: &Painter,
    skips: Skips,
    rows: Range<i32>,
    pixels: &mut [[u8; 3]],
    triangles: &[u32],
) -> Tally {
    let (skip_hidden, skip_masked) = (skips.is_on(skips::HIDDEN), skips.is_on(skips::MASKED));
    let width = p.width as usize;
    let mut tally = Tally::default();
    let mut lists: Lists<Product> = Lists::new(pixels.len());
    let mut covered = vec![f64::NEG_INFINITY; pixels.len()];
    for &triangle in triangles {
        let index = triangle as usize;
        let t = &p.triangles[index];
        let interpolant = if is_high(t) {
            painter.interpolant(p, index)
        } else {
            None
        };
        for y in touched::rows(t.position, rows.clone()) {
            let row = RowCoverage::new(t.position, y);
            let first = (y - rows.start) as usize * width;
            for run in runs(&row, touched::columns(t.position, y, p.width as i32)) {
                let mut cubic = interpolant
                    .as_ref()
                    .and_then(|i| modulated(i, &row, y, &run));
                for x in run {
                    let coverage = row.at(f64::from(x) + 0.5);
                    let product = cubic.as_mut().map(|c| {
                        let v = c.value();
                        c.step();
                        v
                    });
                    if coverage <= 0.0 {
                        continue;
                    }
                    tally.touched += 1;
                    let pixel = first + x as usize;
                    let w = within(weights(&t.position, x, y));
                    let depth = depth(t, w);
                    if skip_hidden && depth <= covered[pixel] {
                        tally.hidden += 1;
                        continue;
                    }
                    if coverage >= 1.0 - CLOSED {
                        covered[pixel] = covered[pixel].max(depth);
                    }
                    let product = product
                        .unwrap_or_else(|| painter.colour(p, index, w).map(|c| c * coverage));
                    tally.shaded += 1;
                    let what = (coverage, product);
                    lists.push(
                        pixel,
                        Fragment {
                            depth,
                            triangle,
                            what,
                        },
                    );
                }
            }
        }
    }
    let background = p.background.map(f64::from);
    let mut sorted = Vec::new();
    for (pixel, out) in pixels.iter_mut().enumerate() {
        lists.sorted(pixel, &mut sorted);
        if sorted.is_empty() {
            continue;
        }
        let (mut open, mut sum) = (1.0, [0.0; 3]);
        for (k, f) in sorted.iter().enumerate() {
            if skip_masked && open == 0.0 {
                tally.masked += (sorted.len() - k) as u64;
                break;
            }
            let (coverage, product) = f.what;
            let share = (open / coverage).min(1.0);
            sum = [0, 1, 2].map(|c| sum[c] + product[c] * share);
            tally.composited += u64::from(open > 0.0);
            open -= coverage;
            if open < CLOSED {
                open = 0.0;
            }
        }
        *out = [0, 1, 2].map(|c| to_byte(sum[c] + background[c] * open));
    }
    tally
}

/// Cuts columns where coverage bends: between the cuts it is linear at pixel centres.
fn runs(row: &RowCoverage, columns: Range<i32>) -> Vec<Range<i32>> {
    let mut cuts: Vec<i32> = row
        .breaks()
        .into_iter()
        .map(|x| ((x - 0.5).ceil() as i32).clamp(columns.start, columns.end))
        .collect();
    cuts.push(columns.end);
    let mut from = columns.start;
    let mut out = Vec::with_capacity(cuts.len());
    for to in cuts {
        if to > from {
            out.push(from..to);
            from = to;
        }
    }
    out
}

/// Coverage times colour over a run as a cubic; `None` where pixels are better done one by one.
fn modulated(i: &Interpolant, row: &RowCoverage, y: i32, run: &Range<i32>) -> Option<Cubic> {
    let n = run.len();
    if n < SHORT {
        return None;
    }
    let colour = i.start(run.start, y);
    if !stays_in_range(&colour, n) {
        return None;
    }
    let at = |x: i32| row.at(f64::from(x) + 0.5);
    let from = at(run.start);
    Some(Cubic::new(
        &colour,
        from,
        (at(run.end - 1) - from) / (n - 1) as f64,
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Point;
    use crate::shade::quadratic;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(600))]
        /// Third differences are coverage times colour by definition, for rows of 2048 pixels.
        #[test]
        fn differences_are_the_product(
            v in prop::array::uniform3((0..520_000i32, 0..30_000i32)), y in 0..110i32,
            knots in prop::array::uniform6(prop::array::uniform3(0.0..255.0f64)),
        ) {
            let t = v.map(|(x, y)| Point { x, y });
            prop_assume!(area2(t).abs() > 40_000_000);
            let i = Interpolant::quadratic(t, &knots);
            let row = RowCoverage::new(t, y);
            let columns = touched::columns(t, y, 2048);
            let mut next = columns.start;
            for run in runs(&row, columns.clone()) {
                prop_assert_eq!(run.start, next);
                next = run.end;
                let Some(mut cubic) = modulated(&i, &row, y, &run) else { continue };
                for x in run {
                    let coverage = row.at(f64::from(x) + 0.5);
                    let colour = quadratic::value(&t, &knots, x, y);
                    for (got, c) in cubic.value().into_iter().zip(colour) {
                        prop_assert!((got - coverage * c).abs() < 1e-7, "{x}: {got} {}", coverage * c);
                    }
                    cubic.step();
                }
            }
            prop_assert_eq!(next, columns.end);
        }
    }

    #[test]
    fn ranges_of_quadratics() {
        let d = |r: f64, dr: f64, d2r: f64| Differences {
            r: [r; 3],
            dr: [dr; 3],
            d2r: [d2r; 3],
        };
        assert!(stays_in_range(&d(10.0, 1.0, 0.0), 100));
        assert!(!stays_in_range(&d(200.0, 1.0, 0.0), 100));
        // Rises to about 260 in between and comes back.
        assert!(!stays_in_range(&d(10.0, 10.0, -0.2), 100));
        assert!(!stays_in_range(&d(f64::NAN, 0.0, 0.0), 8));
    }
}
