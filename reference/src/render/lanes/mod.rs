//! The fast way to draw: eight pixels at a time, for the methods whose colour is a polynomial on the screen. Arithmetic
//! is the same for every width of vector registers and every number of threads, so frames are the same bytes.

mod band;
mod coarse;
mod cover;
mod dots;
mod exact;
mod fixed;
mod kernel;
mod pack;
mod patch;
mod phong;

use super::bands::Tally;
use super::Frame;
use crate::geometry::Prepared;
use crate::parallel;
use crate::raster::{Viewport, SUBPIXELS};
use crate::shade::paint::{Direction, Dots, DotsTerm, Paint, Phong, LIGHTS};
use crate::shade::to_byte;
use crate::simd::{on_vectors, three};
use crate::skips::{Skips, HIDDEN, TILES};
use band::{Band, Memory};
use dots::DotsKernel;
use exact::ExactKernel;
use fearless_simd::{prelude::*, u32x8, Level, Simd};
use kernel::{Constant, Linear, Quadratic};
use patch::Patch;
use phong::PhongKernel;

/// Rows in a band: its words stay in the cache, and there are enough bands for every thread.
const BAND: usize = 32;

/// What triangle `i` is painted with. Called through a pointer, so that the kernels are compiled once for each kind of
/// registers and not once more for every method.
pub(super) type Painter<'a> = dyn Fn(usize) -> Paint + Sync + 'a;

/// Draws every triangle with the paint that `paint` gives it.
pub(super) fn draw(
    p: &Prepared,
    level: Level,
    skips: &Skips,
    paint: &Painter<'_>,
) -> (Frame, Tally) {
    let bins = Bins::new(p);
    // Every pixel will be written, the background too.
    let mut frame = Frame::new(p.width, p.height, [0; 3]);
    let viewport = Viewport {
        width: p.width,
        height: p.height,
    };
    let width = p.width as usize;
    let background = pack::word(p.background);
    let tally = parallel::chunks(
        &mut frame.pixels,
        BAND * width,
        Memory::default,
        |memory, k, pixels| {
            let rows = pixels.len() / width;
            let mut band = Band::new(memory, viewport, (k * BAND) as i32, rows, background);
            band.skip_hidden = skips.is_on(HIDDEN);
            band.skip_tiles = skips.is_on(TILES);
            let bin = bins.of(k);
            on_vectors!(level, simd => {
                triangles(simd, p, &mut band, bin, paint);
                for (row, out) in band.rows().zip(pixels.chunks_exact_mut(width)) {
                    pack::row(simd, row, out);
                }
            });
            band.tally
        },
    );
    (frame, tally)
}

#[inline(always)]
fn triangles<'a, S: Simd>(
    simd: S,
    p: &Prepared,
    band: &mut Band<'_>,
    bin: impl Iterator<Item = &'a u32>,
    paint: &Painter<'_>,
) {
    for i in bin {
        let i = *i as usize;
        let t = &p.triangles[i];
        let patch = Patch::new(t.position);
        if band.is_hidden(t, &patch) {
            continue;
        }
        match paint(i) {
            Paint::Constant(c) => {
                let c = u32x8::splat(simd, pack::word(three!(i => to_byte(c[i]))));
                band.triangle(simd, t, &patch, &Constant(c));
            }
            Paint::Linear(k) if k.iter().flatten().all(|k| *k <= 255.0) => {
                let kernel = Linear::<S, false>::new(simd, &patch, &k);
                band.triangle(simd, t, &patch, &kernel);
            }
            Paint::Linear(k) => {
                let kernel = Linear::<S, true>::new(simd, &patch, &k);
                band.triangle(simd, t, &patch, &kernel);
            }
            Paint::Quadratic(k) if stays_in_range(&k) => {
                let kernel = Quadratic::<S, false>::new(simd, &patch, &k);
                band.triangle(simd, t, &patch, &kernel);
            }
            Paint::Quadratic(k) => {
                let kernel = Quadratic::<S, true>::new(simd, &patch, &k);
                band.triangle(simd, t, &patch, &kernel);
            }
            Paint::Dots(d) if d.terms.len() < 2 => {
                let kernel = DotsKernel::<S, 1>::new(simd, &patch, &d);
                band.triangle(simd, t, &patch, &kernel);
            }
            Paint::Dots(d) => {
                let kernel = DotsKernel::<S, LIGHTS>::new(simd, &patch, &d);
                band.triangle(simd, t, &patch, &kernel);
            }
            Paint::Phong(d) if d.terms.len() < 2 => {
                let kernel = PhongKernel::<S, 1>::new(simd, &patch, &d);
                band.triangle(simd, t, &patch, &kernel);
            }
            Paint::Phong(d) => {
                let kernel = PhongKernel::<S, LIGHTS>::new(simd, &patch, &d);
                band.triangle(simd, t, &patch, &kernel);
            }
            Paint::Exact => {
                let kernel = ExactKernel {
                    prepared: p,
                    triangle: t,
                };
                band.triangle(simd, t, &patch, &kernel);
            }
        }
    }
}

/// Whether a quadratic stays within 0..=255 on its triangle: its Bernstein coefficients do, of which every value there is a
/// mean.
#[inline(always)]
fn stays_in_range(k: &[[f64; 3]; 6]) -> bool {
    (0..3).all(|c| {
        let ok = |v: f64| (0.0..=255.0).contains(&v);
        let control = |m: usize, i: usize, j: usize| 2.0 * k[m][c] - 0.5 * (k[i][c] + k[j][c]);
        ok(k[0][c])
            && ok(k[1][c])
            && ok(k[2][c])
            && ok(control(3, 0, 1))
            && ok(control(4, 0, 2))
            && ok(control(5, 1, 2))
    })
}

/// Which triangles touch which band, in drawing order, for parts of all triangles that follow each other.
struct Bins(Vec<Bin>);

/// One list of numbers, and where each band's begins.
struct Bin {
    start: Vec<u32>,
    triangles: Vec<u32>,
}

impl Bins {
    fn new(p: &Prepared) -> Self {
        let count = p.triangles.len();
        let size = parallel::share(count, 2048, 4);
        let bin = |spans: &mut Vec<[u16; 2]>, range| Bin::new(p, range, spans);
        Self(parallel::parts(count, size, Vec::new, bin))
    }

    fn of(&self, band: usize) -> impl Iterator<Item = &u32> {
        self.0.iter().flat_map(move |bin| {
            let [from, to] = [band, band + 1].map(|k| bin.start[k] as usize);
            &bin.triangles[from..to]
        })
    }
}

impl Bin {
    /// `spans` is memory for the first and last band of each triangle.
    fn new(p: &Prepared, range: std::ops::Range<usize>, spans: &mut Vec<[u16; 2]>) -> Self {
        let bands = (p.height as usize).div_ceil(BAND);
        let last_row = p.height as i32 - 1;
        let mut start = vec![0u32; bands + 1];
        spans.clear();
        spans.extend(p.triangles[range.clone()].iter().map(|t| {
            let y = t.position.map(|q| q.y);
            let (top, bottom) = (y[0].min(y[1]).min(y[2]), y[0].max(y[1]).max(y[2]));
            let first = ((top + SUBPIXELS / 2 - 1) >> crate::raster::SUBPIXEL_BITS).max(0);
            let last = ((bottom - SUBPIXELS / 2) >> crate::raster::SUBPIXEL_BITS).min(last_row);
            if first > last {
                return [1, 0];
            }
            let (a, b) = (first as usize / BAND, last as usize / BAND);
            start[a..=b].iter_mut().for_each(|n| *n += 1);
            [a as u16, b as u16]
        }));
        let mut sum = 0;
        for n in &mut start {
            sum += std::mem::replace(n, sum);
        }
        let mut triangles = vec![0; sum as usize];
        let mut next = start.clone();
        for (i, [a, b]) in range.zip(&*spans) {
            for k in *a..=*b {
                let n = &mut next[usize::from(k)];
                triangles[*n as usize] = i as u32;
                *n += 1;
            }
        }
        Self { start, triangles }
    }
}
