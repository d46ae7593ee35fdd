//! A band of rows as words: 32-bit depth and 32-bit colour, eight pixels at a time.
//!
//! The depth word is 2²⁹·d, d the nearness of [`crate::ScreenTriangle::depth`], rounded once per run of
//! [`RUN`] pixels and once per step: within 34 words, 7e-8 of the frame's depth range, of the exact depth.

use super::cover::{is_small, Cover};
use super::fixed::{lanes, word, RUN};
use super::kernel::Kernel;
use super::patch::Patch;
use crate::raster::{Viewport, Walk};
use crate::render::bands::Tally;
use crate::ScreenTriangle;
use fearless_simd::{i32x8, mask32x8, prelude::*, u32x8, Simd};

/// Depth words from farthest to nearest of the frame.
const DEPTH: f64 = 536_870_912.0;
/// Farther than anything drawn.
const CLEARED: i32 = i32::MIN;

/// The memory of a band; kept from band to band by its worker.
#[derive(Default)]
pub(super) struct Memory {
    depth: Vec<i32>,
    colour: Vec<u32>,
}

/// Rows `first..first + rows` of the frame.
pub(super) struct Band<'a> {
    memory: &'a mut Memory,
    stride: usize,
    viewport: Viewport,
    first: i32,
    rows: i32,
    /// Blocks of which nothing is visible are not shaded.
    pub skip_hidden: bool,
    pub tally: Tally,
}

/// What one triangle needs to write pixels.
struct Depth<S: Simd> {
    at: [f64; 3],
    ramp: i32x8<S>,
    block: i32x8<S>,
}

impl<S: Simd> Depth<S> {
    #[inline(always)]
    fn new(simd: S, t: &ScreenTriangle, patch: &Patch) -> Self {
        // Drawn depths are 0..=1; only what a switched-off skip lets through may lie outside.
        let z = t.depth.map(|d| d.clamp(-3.0, 3.0) * DEPTH);
        let at = [z[0], z[1] - z[0], z[2] - z[0]];
        let step = at[1] * patch.dx[0] + at[2] * patch.dx[1];
        let w = word(step);
        Self {
            at,
            ramp: lanes(simd) * w,
            block: i32x8::splat(simd, w.wrapping_mul(8)),
        }
    }

    #[inline(always)]
    fn start(&self, simd: S, [u, v]: [f64; 2]) -> i32x8<S> {
        i32x8::splat(simd, word(self.at[0] + self.at[1] * u + self.at[2] * v)) + self.ramp
    }
}

impl<'a> Band<'a> {
    /// An empty band.
    pub(super) fn new(
        memory: &'a mut Memory,
        viewport: Viewport,
        first: i32,
        rows: usize,
        background: u32,
    ) -> Self {
        // Blocks of eight may begin in the last column, and small triangles look at sixteen.
        let stride = viewport.width as usize + 16;
        for (words, value) in [(&mut memory.colour, background)] {
            words.clear();
            words.resize(stride * rows, value);
        }
        memory.depth.clear();
        memory.depth.resize(stride * rows, CLEARED);
        Self {
            memory,
            stride,
            viewport,
            first,
            rows: rows as i32,
            skip_hidden: true,
            tally: Tally::default(),
        }
    }

    /// The finished rows.
    pub(super) fn rows(&self) -> impl Iterator<Item = &[u32]> {
        let width = self.viewport.width as usize;
        self.memory
            .colour
            .chunks_exact(self.stride)
            .map(move |r| &r[..width])
    }

    /// Draws what of a triangle lies in the band.
    #[inline(always)]
    pub(super) fn triangle<S: Simd>(
        &mut self,
        simd: S,
        t: &ScreenTriangle,
        patch: &Patch,
        kernel: &impl Kernel<S>,
    ) {
        let depth = Depth::new(simd, t, patch);
        if is_small(patch) {
            self.small(simd, t, patch, &depth, kernel);
        } else {
            self.large(simd, t, patch, &depth, kernel);
        }
    }

    #[inline(always)]
    fn small<S: Simd>(
        &mut self,
        simd: S,
        t: &ScreenTriangle,
        patch: &Patch,
        depth: &Depth<S>,
        kernel: &impl Kernel<S>,
    ) {
        let x0 = patch.x0.max(0);
        let y0 = patch.y0.max(self.first);
        let y1 = patch.y1.min(self.first + self.rows - 1);
        let width = self.viewport.width as i32;
        if x0 >= width {
            return;
        }
        let inside = i32x8::splat(simd, width - x0);
        let k = lanes(simd);
        let (near, far) = (k.simd_lt(inside), (k + 8).simd_lt(inside));
        let wide = patch.x1 - x0 >= 8;
        let mut cover = Cover::new(simd, &t.position, x0, y0);
        let mut y = y0;
        while y <= y1 {
            let a = cover.first(simd) & near;
            let b = cover.second(simd) & far;
            let (first, second) = (a.any_true(), wide && b.any_true());
            if first || second {
                let at = (y - self.first) as usize * self.stride + x0 as usize;
                let uv = patch.at(x0, y);
                let mut z = depth.start(simd, uv);
                let mut run = kernel.start(simd, uv);
                if first {
                    self.block(simd, at, a, z, kernel, &run);
                }
                if second {
                    z = z + depth.block;
                    kernel.advance(&mut run);
                    self.block(simd, at + 8, b, z, kernel, &run);
                }
            }
            cover.down();
            y += 1;
        }
    }

    #[inline(always)]
    fn large<S: Simd>(
        &mut self,
        simd: S,
        t: &ScreenTriangle,
        patch: &Patch,
        depth: &Depth<S>,
        kernel: &impl Kernel<S>,
    ) {
        let Some(walk) = Walk::new(t.position, self.viewport) else {
            return;
        };
        let k = lanes(simd);
        let all = k.simd_lt(i32x8::splat(simd, 8));
        for span in walk.spans_within(self.viewport.width, self.first, self.first + self.rows) {
            let row = (span.y - self.first) as usize * self.stride;
            let mut x = span.start;
            while x < span.end {
                let end = span.end.min(x + RUN);
                let uv = patch.at(x, span.y);
                let mut z = depth.start(simd, uv);
                let mut run = kernel.start(simd, uv);
                loop {
                    let left = end - x;
                    let at = row + x as usize;
                    if left >= 8 {
                        self.block(simd, at, all, z, kernel, &run);
                    } else {
                        let mask = k.simd_lt(i32x8::splat(simd, left));
                        self.block(simd, at, mask, z, kernel, &run);
                    }
                    x += 8;
                    if x >= end {
                        x = end;
                        break;
                    }
                    z = z + depth.block;
                    kernel.advance(&mut run);
                }
            }
        }
    }

    /// Tests and writes eight pixels.
    #[inline(always)]
    fn block<S: Simd, K: Kernel<S>>(
        &mut self,
        simd: S,
        at: usize,
        mask: mask32x8<S>,
        z: i32x8<S>,
        kernel: &K,
        run: &K::Run,
    ) {
        let depths = &mut self.memory.depth[at..at + 8];
        let stored = i32x8::from_slice(simd, depths);
        let visible = z.simd_gt(stored) & mask;
        self.tally.tested += u64::from(mask.to_bitmask().count_ones());
        let bits = visible.to_bitmask();
        if bits != 0 || !self.skip_hidden {
            visible.select(z, stored).store_slice(depths);
            let colours = &mut self.memory.colour[at..at + 8];
            let old = u32x8::from_slice(simd, colours);
            visible
                .select(kernel.pixels(simd, run), old)
                .store_slice(colours);
            self.tally.written += u64::from(bits.count_ones());
        }
    }
}
