//! The A-buffer (Carpenter 1984): per pixel the coverage masks B of the triangles in it, composited front to back.
//!
//! With M the samples still open, all at first: for each fragment from the front, seen = B & M, the sum grows by its
//! colour times the number of bits of `seen`, M becomes M & !B; at the end the background takes what is left of M. The
//! number of bits seen and left is always that of the grid, and nothing is to be done any more once M is 0 (skip
//! `masked`). Depth and colour of a fragment are those at the middle of its samples, which is a point of the triangle,
//! so nothing is extrapolated; there is one depth per triangle and pixel, so where faces pierce each other, the nearer
//! one at that point has all it covers.

use super::fragments::{bands, Fragment, Lists, Tally};
use super::mask::{Grid, HalfPlane};
use super::mask_table::MaskTable;
use super::paint::{depth, within, Painter};
use super::touched;
use crate::geometry::Prepared;
use crate::render::Frame;
use crate::shade::barycentric::weights_at;
use crate::shade::to_byte;
use crate::skips::{self, Skips};
use std::ops::Range;

/// Where masks come from.
#[derive(Clone, Copy, Debug)]
pub enum Masks<'a> {
    /// Worked out for each edge, exactly.
    Direct(Grid),
    /// Looked up.
    Table(&'a MaskTable),
}

impl Masks<'_> {
    fn grid(&self) -> Grid {
        match self {
            Self::Direct(grid) => *grid,
            Self::Table(t) => t.grid(),
        }
    }

    /// The mask of a polygon in a pixel: the AND of those of its edges.
    fn polygon(&self, edges: &[HalfPlane], x: i32, y: i32) -> u64 {
        edges.iter().fold(self.grid().full(), |m, h| match m {
            0 => 0,
            _ => {
                m & match self {
                    Self::Direct(grid) => h.mask(*grid, x, y),
                    Self::Table(t) => t.mask(h, x, y),
                }
            }
        })
    }
}

/// A pixel while its fragments are laid over each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compositor {
    grid: Grid,
    open: u64,
    sum: [f64; 3],
}

impl Compositor {
    /// A pixel that is open everywhere.
    #[must_use]
    pub fn new(grid: Grid) -> Self {
        Self {
            grid,
            open: grid.full(),
            sum: [0.0; 3],
        }
    }

    /// The samples that nothing covers yet.
    #[must_use]
    pub fn open(&self) -> u64 {
        self.open
    }

    /// Puts a fragment behind those before it; gives the samples in which it is seen. `colour` is not asked for if there
    /// are none.
    pub fn add(&mut self, mask: u64, colour: impl FnOnce() -> [f64; 3]) -> u64 {
        let seen = mask & self.open;
        if seen != 0 {
            let (colour, n) = (colour(), f64::from(seen.count_ones()));
            self.sum = [0, 1, 2].map(|c| self.sum[c] + colour[c] * n);
            self.open ^= seen;
        }
        seen
    }

    /// The colour of the pixel.
    #[must_use]
    pub fn finish(self, background: [f64; 3]) -> [f64; 3] {
        let n = f64::from(self.open.count_ones());
        [0, 1, 2].map(|c| (self.sum[c] + background[c] * n) / f64::from(self.grid.samples()))
    }
}

/// Draws the shaded triangles of a scene.
pub(super) fn draw(
    p: &Prepared,
    painter: &Painter,
    masks: &Masks<'_>,
    skips: Skips,
) -> (Frame, Tally) {
    bands(p, |rows, pixels, triangles| {
        band(p, painter, masks, skips, rows, pixels, triangles)
    })
}

fn band(
    p: &Prepared,
    painter: &Painter,
    masks: &Masks<'_>,
    skips: Skips,
    rows: Range<i32>,
    pixels: &mut [[u8; 3]],
    triangles: &[u32],
) -> Tally {
    let (skip_hidden, skip_masked) = (skips.is_on(skips::HIDDEN), skips.is_on(skips::MASKED));
    let grid = masks.grid();
    let mut tally = Tally::default();
    let mut lists: Lists<u64> = Lists::new(pixels.len());
    // Depth of the nearest fragment that covers its pixel wholly.
    let mut covered = vec![f64::NEG_INFINITY; pixels.len()];
    let middle = |mask: u64, x: i32, y: i32| {
        let (cx, cy) = grid.centre(mask);
        (f64::from(x) + cx, f64::from(y) + cy)
    };
    for &triangle in triangles {
        let t = &p.triangles[triangle as usize];
        let Some(edges) = HalfPlane::of_triangle(t.position) else {
            continue;
        };
        for y in touched::rows(t.position, rows.clone()) {
            for x in touched::columns(t.position, y, p.width as i32) {
                let mask = masks.polygon(&edges, x, y);
                if mask == 0 {
                    continue;
                }
                tally.touched += 1;
                let (mx, my) = middle(mask, x, y);
                // Masks of a table may hold samples beside the triangle.
                let depth = depth(t, within(weights_at(&t.position, mx, my)));
                let pixel = (y - rows.start) as usize * p.width as usize + x as usize;
                if skip_hidden && depth <= covered[pixel] {
                    tally.hidden += 1;
                    continue;
                }
                if mask == grid.full() {
                    covered[pixel] = covered[pixel].max(depth);
                }
                lists.push(
                    pixel,
                    Fragment {
                        depth,
                        triangle,
                        what: mask,
                    },
                );
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
        let x = (pixel % p.width as usize) as i32;
        let y = rows.start + (pixel / p.width as usize) as i32;
        let mut compositor = Compositor::new(grid);
        for (k, f) in sorted.iter().enumerate() {
            if skip_masked && compositor.open() == 0 {
                tally.masked += (sorted.len() - k) as u64;
                break;
            }
            let t = &p.triangles[f.triangle as usize];
            let colour = || {
                let (mx, my) = middle(f.what, x, y);
                painter.colour(
                    p,
                    f.triangle as usize,
                    within(weights_at(&t.position, mx, my)),
                )
            };
            tally.shaded += 1;
            let seen = if skip_masked {
                compositor.add(f.what, colour)
            } else {
                let colour = colour();
                compositor.add(f.what, || colour)
            };
            if seen != 0 {
                tally.composited += 1;
            } else if skip_masked {
                tally.shaded -= 1;
                tally.masked += 1;
            }
        }
        *out = compositor.finish(background).map(to_byte);
    }
    tally
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn invariants_of_compositing(masks in prop::collection::vec(any::<u64>(), 0..9), sparse: bool) {
            for grid in [Grid::FOUR_BY_FOUR, Grid::FOUR_BY_EIGHT, Grid::EIGHT_BY_EIGHT] {
                let mut c = Compositor::new(grid);
                let mut bits = 0;
                // Front to back by hand: each sample shows the first mask that has it.
                let mut owner = vec![None; grid.samples() as usize];
                for (k, m) in masks.iter().enumerate() {
                    let m = (if sparse { m & m.rotate_left(17) } else { *m }) & grid.full();
                    let before = c.open();
                    let seen = c.add(m, || [k as f64, 1.0, 0.0]);
                    prop_assert_eq!(seen, m & before);
                    prop_assert_eq!(c.open(), before & !m);
                    bits += seen.count_ones();
                    prop_assert_eq!(bits + c.open().count_ones(), grid.samples());
                    for (bit, o) in owner.iter_mut().enumerate() {
                        if m >> bit & 1 == 1 && o.is_none() {
                            *o = Some(k);
                        }
                    }
                }
                let want: f64 = owner.iter().map(|o| o.map_or(100.0, |k| k as f64)).sum();
                let got = c.finish([100.0, 0.0, 7.0]);
                prop_assert!((got[0] * f64::from(grid.samples()) - want).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn no_colour_is_asked_for_behind_a_full_mask() {
        let mut c = Compositor::new(Grid::FOUR_BY_EIGHT);
        c.add(Grid::FOUR_BY_EIGHT.full(), || [9.0; 3]);
        assert_eq!(c.open(), 0);
        assert_eq!(c.add(5, || panic!("asked")), 0);
        assert_eq!(c.finish([200.0; 3]), [9.0; 3]);
    }
}
