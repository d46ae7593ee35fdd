//! Masks of half planes by angle and offset, as hardware keeps them in a read-only memory (the A-buffer's edge masks).
//!
//! The angle is that of the inward normal, the offset the distance of the pixel's centre from the edge, positive inside.
//! Both are cut into equal bins, and an entry is the mask of the half plane at the middle of its bin. Angles from π up are
//! those of the opposite half plane, whose mask is complemented; so the two sides of an edge share every sample out,
//! however coarse the table.
//!
//! An entry is the true mask of an edge that is turned by at most half an angle bin and moved by at most half an offset
//! bin. Within a pixel, no farther than √½ from its centre, that moves the edge by δ ≤ Δoffset/2 + √½·Δangle/2, and the
//! area by no more than √2·δ, as no chord of the pixel is longer than √2: the bound of [`MaskTable::extra_error`].

use super::mask::{Grid, HalfPlane};
use crate::raster::SUBPIXELS;
use std::f64::consts::{FRAC_1_SQRT_2, PI};

/// Masks of half planes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MaskTable {
    grid: Grid,
    angles: u32,
    offsets: u32,
    masks: Vec<u64>,
}

impl MaskTable {
    /// A table of 2^`angle_bits` bins over half a turn and 2^`offset_bits` over the offsets ±√½; 1 to 10 bits each.
    #[must_use]
    pub fn new(grid: Grid, angle_bits: u32, offset_bits: u32) -> Self {
        let (angles, offsets) = (1 << angle_bits.clamp(1, 10), 1 << offset_bits.clamp(1, 10));
        let mut masks = Vec::with_capacity(angles as usize * offsets as usize);
        for a in 0..angles {
            let (sin, cos) = ((f64::from(a) + 0.5) / f64::from(angles) * PI).sin_cos();
            for o in 0..offsets {
                let offset =
                    ((f64::from(o) + 0.5) / f64::from(offsets) * 2.0 - 1.0) * FRAC_1_SQRT_2;
                let inside = |bit: u32| {
                    let [x, y] = grid
                        .place(bit)
                        .map(|v| v as f64 / f64::from(SUBPIXELS) - 0.5);
                    cos * x + sin * y + offset >= 0.0
                };
                masks.push((0..grid.samples()).fold(0, |m, bit| m | u64::from(inside(bit)) << bit));
            }
        }
        Self {
            grid,
            angles,
            offsets,
            masks,
        }
    }

    /// The samples that the masks are made of.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.grid
    }

    /// Size of the memory, bits.
    #[must_use]
    pub fn bits(&self) -> usize {
        self.masks.len() * self.grid.samples() as usize
    }

    /// How much more than the exact mask a table mask may err, as a share of the pixel.
    #[must_use]
    pub fn extra_error(&self) -> f64 {
        let offset = 2.0 * FRAC_1_SQRT_2 / f64::from(self.offsets) / 2.0;
        let angle = PI / f64::from(self.angles) / 2.0;
        2.0f64.sqrt() * (offset + FRAC_1_SQRT_2 * angle)
    }

    /// The mask of a half plane in pixel (`x`, `y`). An edge without length has no inside.
    #[must_use]
    pub fn mask(&self, h: &HalfPlane, x: i32, y: i32) -> u64 {
        let [dx, dy] = h.direction();
        if dx == 0 && dy == 0 {
            return 0;
        }
        let centre = |v: i32| i64::from(v) * i64::from(SUBPIXELS) + i64::from(SUBPIXELS / 2);
        let side = h.side(centre(x), centre(y));
        // The inward normal is (−dy, dx); the half turn from 0 to π has dx > 0, or dx = 0 and dy < 0.
        let opposite = dx < 0 || (dx == 0 && dy > 0);
        let sign = if opposite { -1.0 } else { 1.0 };
        let (nx, ny) = (-(dy as f64) * sign, dx as f64 * sign);
        let offset = side as f64 * sign / (nx.hypot(ny) * f64::from(SUBPIXELS));
        let mask = if offset >= FRAC_1_SQRT_2 {
            self.grid.full()
        } else if offset <= -FRAC_1_SQRT_2 {
            0
        } else {
            // The conversions truncate; what rounds up to the end belongs to the last bin.
            let bin = |share: f64, count: u32| ((share * f64::from(count)) as u32).min(count - 1);
            let a = bin(ny.atan2(nx) / PI, self.angles);
            let o = bin((offset / FRAC_1_SQRT_2 + 1.0) / 2.0, self.offsets);
            self.masks[(a * self.offsets + o) as usize]
        };
        if opposite {
            self.grid.full() & !mask
        } else {
            mask
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::area::coverage;
    use super::*;
    use crate::raster::Point;
    use proptest::prelude::*;
    use std::sync::OnceLock;

    fn tables() -> &'static [MaskTable] {
        static TABLES: OnceLock<Vec<MaskTable>> = OnceLock::new();
        TABLES.get_or_init(|| {
            let mut all = Vec::new();
            for grid in [
                Grid::FOUR_BY_FOUR,
                Grid::FOUR_BY_EIGHT,
                Grid::EIGHT_BY_EIGHT,
            ] {
                for bits in [3, 5, 7] {
                    all.push(MaskTable::new(grid, bits, bits));
                }
            }
            all
        })
    }

    #[test]
    fn upright_and_level_edges() {
        let t = MaskTable::new(Grid::EIGHT_BY_EIGHT, 7, 7);
        let at = |x: i32, y: i32| Point { x, y };
        // Downwards: the inside is on the left of the screen.
        let half = HalfPlane::new(at(128, -900), at(128, 900));
        let left = (0..64).filter(|b| b % 8 < 4).fold(0u64, |m, b| m | 1 << b);
        let got = t.mask(&half, 0, 0);
        assert!((got ^ left).count_ones() <= 8, "{got:x}");
        assert_eq!(t.mask(&half, -1, 0), t.grid().full());
        assert_eq!(t.mask(&half, 2, 0), 0);
        assert_eq!(t.mask(&HalfPlane::new(at(5, 5), at(5, 5)), 0, 0), 0);
        assert_eq!(t.bits(), 128 * 128 * 64);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn table_masks_keep_their_bound_and_share_samples_out(
            a in (-2000..2000i32, -2000..2000i32), b in (-2000..2000i32, -2000..2000i32),
        ) {
            let (a, b) = (Point { x: a.0, y: a.1 }, Point { x: b.0, y: b.1 });
            prop_assume!(a != b);
            for t in tables() {
                let there = t.mask(&HalfPlane::new(a, b), 0, 0);
                prop_assert_eq!(there ^ t.mask(&HalfPlane::new(b, a), 0, 0), t.grid().full());
                // The half plane as a large triangle: ends far along the edge, apex far inside.
                let (dx, dy) = (f64::from(b.x - a.x), f64::from(b.y - a.y));
                let k = 30_000.0 / dx.hypot(dy);
                let far = |u: f64, v: f64| Point {
                    x: (f64::from(a.x) + (u * dx - v * dy) * k).round() as i32,
                    y: (f64::from(a.y) + (u * dy + v * dx) * k).round() as i32,
                };
                let exact = coverage([far(-1.0, 0.0), far(1.0, 0.0), far(0.0, 1.0)], 0, 0);
                let share = f64::from(there.count_ones()) / f64::from(t.grid().samples());
                // Half a row of samples is what a mask may err at most.
                let own = match t.grid() {
                    Grid::EIGHT_BY_EIGHT => 0.0625,
                    _ => 0.125,
                };
                let bound = own + t.extra_error() + 1e-3;
                prop_assert!((share - exact).abs() <= bound, "{share} {exact} {bound}");
            }
        }
    }
}
