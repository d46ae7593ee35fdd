//! A band of rows as words: 32-bit depth and 32-bit colour, eight pixels at a time.
//!
//! The depth word is 2²⁹·d, d the nearness of [`crate::ScreenTriangle::depth`], rounded once per run of
//! [`RUN`] pixels and once per step, across or down: within 65 words, 1.3e-7 of the frame's depth range, of the exact
//! depth.

use super::coarse::Coarse;
use super::cover::{is_small, Cover};
use super::fixed::{lanes, word, RUN};
use super::kernel::Kernel;
use super::patch::Patch;
use crate::raster::{Viewport, Walk};
use crate::render::bands::Tally;
use crate::simd::three;
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
    coarse: Coarse,
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
    /// Triangles behind everything in their tiles are not drawn.
    pub skip_tiles: bool,
    pub tally: Tally,
}

/// What one triangle needs to write pixels.
struct Depth<S: Simd> {
    at: [f64; 3],
    ramp: i32x8<S>,
    block: i32x8<S>,
    down: i32x8<S>,
}

impl<S: Simd> Depth<S> {
    #[inline(always)]
    fn new(simd: S, t: &ScreenTriangle, patch: &Patch) -> Self {
        // Drawn depths are 0..=1; only what a switched-off skip lets through may lie outside.
        let z = three!(i => t.depth[i].clamp(-3.0, 3.0) * DEPTH);
        let at = [z[0], z[1] - z[0], z[2] - z[0]];
        let step = at[1] * patch.dx[0] + at[2] * patch.dx[1];
        let w = word(step);
        Self {
            at,
            ramp: lanes(simd) * w,
            block: i32x8::splat(simd, w.wrapping_mul(8)),
            down: i32x8::splat(simd, word(at[1] * patch.dy[0] + at[2] * patch.dy[1])),
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
        memory.colour.clear();
        memory.colour.resize(stride * rows, background);
        memory.depth.clear();
        memory.depth.resize(stride * rows, CLEARED);
        memory.coarse.clear(viewport.width as usize, rows, CLEARED);
        Self {
            memory,
            stride,
            viewport,
            first,
            rows: rows as i32,
            skip_hidden: true,
            skip_tiles: true,
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

    /// Whether a triangle is behind everything that its tiles hold; counted.
    #[inline(always)]
    pub(super) fn is_hidden(&mut self, t: &ScreenTriangle, patch: &Patch) -> bool {
        let d = t.depth;
        let nearest = d[0].max(d[1]).max(d[2]).clamp(-3.0, 3.0) * DEPTH;
        // Steps and starts are rounded: no word is more than 65 nearer than the corner.
        let nearest = nearest as i32 + 80;
        let hidden = self.skip_tiles && self.memory.coarse.hides(patch.x0, patch.x1, nearest);
        self.tally.tiles += u64::from(hidden);
        hidden
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
        let before = self.tally.written;
        if is_small(patch) {
            self.small(simd, t, patch, &depth, kernel);
        } else {
            self.large(simd, t, patch, &depth, kernel);
        }
        let written = (self.tally.written - before) as u32;
        let Memory { depth, coarse, .. } = &mut *self.memory;
        coarse.written(simd, depth, self.stride, patch.x0, patch.x1, written);
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
        let k = lanes(simd);
        let room = width - x0;
        let limits = [room, room - 8].map(|n| (1u64 << n.clamp(0, 8)) - 1);
        let wide = patch.x1 - x0 >= 8;
        let mut cover = Cover::new(simd, &t.position, x0, y0);
        let mut z_row = depth.start(simd, patch.at(x0, y0));
        let mut row = kernel.first_row(simd, patch, [x0, y0]);
        let mut at = (y0 - self.first) as usize * self.stride + x0 as usize;
        let (mut tested, mut written) = (0, 0);
        let mut y = y0;
        while y <= y1 {
            let (a, b) = (cover.first(simd), cover.second(simd));
            let first = a.to_bitmask() & limits[0];
            let second = if wide { b.to_bitmask() & limits[1] } else { 0 };
            if first | second != 0 {
                let depths = &mut self.memory.depth[at..at + 16];
                let colours = &mut self.memory.colour[at..at + 16];
                let (mut z, mut run) = (z_row, kernel.run(simd, patch, &row));
                if first != 0 {
                    let (d, c) = (&mut depths[..8], &mut colours[..8]);
                    let mask = if room < 8 {
                        a & k.simd_lt(i32x8::splat(simd, room))
                    } else {
                        a
                    };
                    written += block(simd, d, c, Some(mask), z, kernel, &run, self.skip_hidden);
                }
                if second != 0 {
                    z += depth.block;
                    kernel.advance(&mut run);
                    let (d, c) = (&mut depths[8..], &mut colours[8..]);
                    let mask = if room < 16 {
                        b & k.simd_lt(i32x8::splat(simd, room - 8))
                    } else {
                        b
                    };
                    written += block(simd, d, c, Some(mask), z, kernel, &run, self.skip_hidden);
                }
                tested += first.count_ones() + second.count_ones();
            }
            cover.down();
            y += 1;
            z_row += depth.down;
            kernel.next_row(&mut row);
            at += self.stride;
        }
        self.tally.tested += u64::from(tested);
        self.tally.written += u64::from(written);
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
        let (mut tested, mut written) = (0u64, 0u32);
        for span in walk.spans_within(self.viewport.width, self.first, self.first + self.rows) {
            let row = (span.y - self.first) as usize * self.stride;
            let mut x = span.start;
            while x < span.end {
                let end = span.end.min(x + RUN);
                let uv = patch.at(x, span.y);
                let mut z = depth.start(simd, uv);
                let mut run = kernel.start(simd, uv, [x, span.y]);
                let length = (end - x) as usize;
                let from = row + x as usize;
                let (full, rest) = (from + length / 8 * 8, length as i32 % 8);
                let mut depths = &mut self.memory.depth[from..full];
                let mut colours = &mut self.memory.colour[from..full];
                while let (Some((d, more_d)), Some((c, more_c))) = (
                    depths.split_first_chunk_mut::<8>(),
                    colours.split_first_chunk_mut::<8>(),
                ) {
                    written += block(simd, d, c, None, z, kernel, &run, self.skip_hidden);
                    z += depth.block;
                    kernel.advance(&mut run);
                    (depths, colours) = (more_d, more_c);
                }
                if rest > 0 {
                    let mask = k.simd_lt(i32x8::splat(simd, rest));
                    let d = &mut self.memory.depth[full..full + 8];
                    let c = &mut self.memory.colour[full..full + 8];
                    written += block(simd, d, c, Some(mask), z, kernel, &run, self.skip_hidden);
                }
                tested += length as u64;
                x = end;
            }
        }
        self.tally.tested += tested;
        self.tally.written += u64::from(written);
    }
}

/// Tests and writes eight pixels; returns how many were written.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "inlined into two loops")]
fn block<S: Simd, K: Kernel<S>>(
    simd: S,
    depths: &mut [i32],
    colours: &mut [u32],
    mask: Option<mask32x8<S>>,
    z: i32x8<S>,
    kernel: &K,
    run: &K::Run,
    skip_hidden: bool,
) -> u32 {
    let stored = i32x8::from_slice(simd, depths);
    let nearer = z.simd_gt(stored);
    let visible = match mask {
        Some(mask) => nearer & mask,
        None => nearer,
    };
    let bits = visible.to_bitmask();
    if bits != 0 || !skip_hidden {
        let pixels = kernel.pixels(simd, run);
        if bits == 0xff {
            z.store_slice(depths);
            pixels.store_slice(colours);
        } else {
            visible.select(z, stored).store_slice(depths);
            let old = u32x8::from_slice(simd, colours);
            visible.select(pixels, old).store_slice(colours);
        }
    }
    bits.count_ones()
}
