//! The software renderer: set-up per triangle, then bands of rows in parallel. The frame is the same for any number of
//! threads.

mod band;
mod frame;
mod shared;
pub mod span;

pub use frame::{Frame, FrameError};

use crate::geometry::Prepared;
use crate::method::Method;
use crate::raster::{Viewport, Walk};
use crate::shade::{flat, to_byte};
use crate::skips::{self, Skips};
use band::{Band, Colour, Ready, Tally};
use rayon::prelude::*;
use span::Interpolant;
use std::collections::BTreeMap;
use std::time::Instant;

/// Rows in a band.
const BAND: usize = 16;

/// How to draw.
#[derive(Clone, Copy, Debug, Default)]
pub struct RenderOptions {
    /// Threads to use; as many as there are processors when not given (or zero).
    pub threads: Option<usize>,
    /// Skips per pixel (`hidden`). Those per triangle were decided when the scene was prepared.
    pub skips: Skips,
}

/// What drawing took.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RenderStats {
    /// Pixels covered, counted once for every triangle that covers them.
    pub pixels_tested: u64,
    /// Of these, given a colour.
    pub pixels_shaded: u64,
    /// Of these, written to the frame.
    pub pixels_written: u64,
    /// Triangles and pixels skipped, by reason.
    pub skipped: BTreeMap<&'static str, u64>,
    /// Time for the set-up of all triangles, ns.
    pub setup_ns: u64,
    /// Time for walking, testing and writing, ns.
    pub raster_ns: u64,
    /// Threads used.
    pub threads: usize,
}

/// Draws a prepared scene.
#[must_use]
pub fn render(p: &Prepared, method: Method, o: &RenderOptions) -> (Frame, RenderStats) {
    let own = o
        .threads
        .filter(|n| *n > 0)
        .and_then(|n| rayon::ThreadPoolBuilder::new().num_threads(n).build().ok());
    match own {
        Some(pool) => pool.install(|| draw(p, method, o)),
        None => draw(p, method, o),
    }
}

/// How the pixels of every triangle get their colour.
fn colours(p: &Prepared, method: Method) -> Vec<Colour> {
    let all = &p.triangles;
    match method {
        Method::Exact => vec![Colour::Exact; all.len()],
        Method::Flat => all
            .par_iter()
            .with_min_len(64)
            .map(|t| Colour::Constant(flat::knot(p, t).map(to_byte)))
            .collect(),
        Method::Gouraud => shared::linear(p)
            .iter()
            .zip(all)
            .map(|(k, t)| Colour::Differences(Interpolant::linear(t.position, k)))
            .collect(),
        Method::Quadratic => shared::square(p)
            .iter()
            .zip(all)
            .map(|(k, t)| Colour::Differences(Interpolant::quadratic(t.position, k)))
            .collect(),
    }
}

fn draw(p: &Prepared, method: Method, o: &RenderOptions) -> (Frame, RenderStats) {
    let start = Instant::now();
    let viewport = Viewport {
        width: p.width,
        height: p.height,
    };
    let ready: Vec<Ready<'_>> = p
        .triangles
        .iter()
        .zip(colours(p, method))
        .filter_map(|(t, colour)| {
            let walk = Walk::new(t.position, viewport)?;
            Some(Ready {
                triangle: t,
                walk,
                colour,
            })
        })
        .collect();
    // Which triangles touch which band, in drawing order.
    let mut bins: Vec<Vec<usize>> = vec![Vec::new(); (p.height as usize).div_ceil(BAND)];
    for (i, r) in ready.iter().enumerate() {
        let first = r.walk.first_row as usize;
        let last = first + r.walk.rows as usize - 1;
        for bin in &mut bins[first / BAND..=last / BAND] {
            bin.push(i);
        }
    }
    let setup_ns = nanoseconds(start);

    let start = Instant::now();
    let mut frame = Frame::new(p.width, p.height, p.background);
    let skip_hidden = o.skips.is_on(skips::HIDDEN);
    let tally = frame
        .pixels
        .par_chunks_mut(BAND * p.width as usize)
        .zip(&bins)
        .enumerate()
        .map(|(k, (pixels, bin))| {
            let mut band = Band {
                prepared: p,
                first_row: (k * BAND) as i32,
                pixels,
                skip_hidden,
            };
            let order = bin.iter().copied();
            if method == Method::Exact {
                band.draw::<f64>(order, &ready)
            } else {
                band.draw::<u16>(order, &ready)
            }
        })
        .reduce(Tally::default, |a, b| a + b);
    let mut skipped = p.skipped.clone();
    if tally.hidden > 0 {
        skipped.insert(band::HIDDEN, tally.hidden);
    }
    let stats = RenderStats {
        pixels_tested: tally.tested,
        pixels_shaded: tally.shaded,
        pixels_written: tally.written,
        skipped,
        setup_ns,
        raster_ns: nanoseconds(start),
        threads: rayon::current_num_threads(),
    };
    (frame, stats)
}

fn nanoseconds(since: Instant) -> u64 {
    u64::try_from(since.elapsed().as_nanos()).unwrap_or(u64::MAX)
}
