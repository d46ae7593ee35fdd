//! Coarse depth of a band: for every column of [`TILE`] pixels the farthest depth word in it. A triangle whose nearest
//! corner is not nearer than the farthest word of every tile it touches cannot be seen in the band (hierarchical z; the
//! depth of a triangle is largest at a corner), so nothing of it is set up or tested.
//!
//! A tile is looked through again only after half as many pixels as it has were written to it, so looking costs less
//! than a quarter of a load per written pixel.

use fearless_simd::{i32x8, prelude::*, Simd};

/// Columns of a tile.
const TILE: usize = 64;

/// The tiles of one band.
#[derive(Default)]
pub(super) struct Coarse {
    far: Vec<i32>,
    written: Vec<u32>,
    rows: usize,
}

impl Coarse {
    /// A cleared band of so many columns and rows.
    pub(super) fn clear(&mut self, width: usize, rows: usize, cleared: i32) {
        let tiles = width.div_ceil(TILE);
        self.far.clear();
        self.far.resize(tiles, cleared);
        self.written.clear();
        self.written.resize(tiles, 0);
        self.rows = rows;
    }

    fn tiles(&self, from: i32, to: i32) -> std::ops::RangeInclusive<usize> {
        let last = self.far.len() - 1;
        let tile = |x: i32| (x.max(0) as usize / TILE).min(last);
        tile(from)..=tile(to)
    }

    /// Whether depths up to `nearest` in columns `from..=to` are behind everything there.
    #[inline(always)]
    pub(super) fn hides(&self, from: i32, to: i32, nearest: i32) -> bool {
        self.far[self.tiles(from, to)]
            .iter()
            .all(|far| nearest <= *far)
    }

    /// Takes notice of pixels written in columns `from..=to`.
    #[inline(always)]
    pub(super) fn written<S: Simd>(
        &mut self,
        simd: S,
        depth: &[i32],
        stride: usize,
        from: i32,
        to: i32,
        count: u32,
    ) {
        if count == 0 {
            return;
        }
        let enough = (TILE * self.rows / 2) as u32;
        for tile in self.tiles(from, to) {
            self.written[tile] += count;
            if self.written[tile] >= enough {
                self.written[tile] = 0;
                self.far[tile] = self.farthest(simd, depth, stride, tile);
            }
        }
    }

    #[inline(always)]
    fn farthest<S: Simd>(&self, simd: S, depth: &[i32], stride: usize, tile: usize) -> i32 {
        let mut least = i32x8::splat(simd, i32::MAX);
        // The last tile may reach into the margin of the rows, which stays cleared: it then never hides.
        let from = tile * TILE;
        for row in depth.chunks_exact(stride).take(self.rows) {
            let row = &row[from..(from + TILE).min(stride)];
            let mut at = 0;
            while at + 8 <= row.len() {
                least = least.min(i32x8::from_slice(simd, &row[at..at + 8]));
                at += 8;
            }
        }
        least.reduce_min()
    }
}
