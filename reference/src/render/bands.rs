//! The frame in bands of rows. Bands share nothing, so they are drawn at the same time, and every span starts from exact
//! values, so the frame does not depend on how rows are divided.

use super::Frame;
use crate::geometry::Prepared;
use crate::parallel;
use crate::raster::{Viewport, Walk};

/// Rows in a band.
pub(super) const BAND: usize = 16;

/// A triangle set up for drawing.
pub(super) struct Ready<T> {
    /// Its number in the scene.
    pub index: usize,
    /// Its rows.
    pub walk: Walk,
    /// What the method worked out for it.
    pub setup: T,
}

/// What a band counted.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tally {
    /// Pixels covered.
    pub tested: u64,
    /// Pixels written.
    pub written: u64,
    /// Pixels not shaded because they are hidden.
    pub hidden: u64,
    /// Triangles left out of a band by its coarse depth.
    pub tiles: u64,
    /// Spans of one pixel that were not set up.
    pub one_pixel: u64,
}

impl std::ops::Add for Tally {
    type Output = Self;

    fn add(self, o: Self) -> Self {
        Self {
            tested: self.tested + o.tested,
            written: self.written + o.written,
            hidden: self.hidden + o.hidden,
            tiles: self.tiles + o.tiles,
            one_pixel: self.one_pixel + o.one_pixel,
        }
    }
}

/// The triangles that cross a row, set up.
pub(super) fn ready<T: Send>(
    p: &Prepared,
    setup: impl Fn(usize) -> T + Sync + Send,
) -> Vec<Ready<T>> {
    let viewport = Viewport {
        width: p.width,
        height: p.height,
    };
    let one = |index: usize| {
        Some(Ready {
            index,
            walk: Walk::new(p.triangles[index].position, viewport)?,
            setup: setup(index),
        })
    };
    let all = parallel::map(p.triangles.len(), one);
    all.into_iter().flatten().collect()
}

/// Which triangles touch which band, in drawing order.
pub(super) fn bin<T>(ready: &[Ready<T>], height: u32) -> Vec<Vec<u32>> {
    let mut bins = vec![Vec::new(); (height as usize).div_ceil(BAND)];
    for (i, r) in ready.iter().enumerate() {
        let first = r.walk.first_row as usize;
        let last = first + r.walk.rows as usize - 1;
        for bin in &mut bins[first / BAND..=last / BAND] {
            bin.push(i as u32);
        }
    }
    bins
}

/// Draws every band: `draw` gets its first row, its pixels and its triangles.
pub(super) fn each(
    frame: &mut Frame,
    bins: &[Vec<u32>],
    draw: impl Fn(i32, &mut [[u8; 3]], &[u32]) -> Tally + Sync + Send,
) -> Tally {
    let width = frame.width as usize;
    parallel::chunks(
        &mut frame.pixels,
        BAND * width,
        || (),
        |(), k, pixels| draw((k * BAND) as i32, pixels, &bins[k]),
    )
}
