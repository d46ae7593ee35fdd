//! What covers the pixels of a band of rows: a list for each pixel, taken from front to back.

use crate::geometry::Prepared;
use crate::parallel;
use crate::render::Frame;
use std::ops::Range;

/// Rows in a band.
const BAND: usize = 16;

/// What was counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Tally {
    /// Fragments: pixels touched, counted for each triangle that covers some of them.
    pub touched: u64,
    /// Of these, given a colour.
    pub shaded: u64,
    /// Of these, seen in the frame.
    pub composited: u64,
    /// Left out behind a fragment that covers its pixel wholly.
    pub hidden: u64,
    /// Left out since nothing of the pixel was open any more.
    pub masked: u64,
}

impl std::ops::Add for Tally {
    type Output = Self;

    fn add(self, o: Self) -> Self {
        Self {
            touched: self.touched + o.touched,
            shaded: self.shaded + o.shaded,
            composited: self.composited + o.composited,
            hidden: self.hidden + o.hidden,
            masked: self.masked + o.masked,
        }
    }
}

/// One triangle in one pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fragment<T> {
    /// Greater is nearer.
    pub depth: f64,
    /// Number of the triangle; of equal depths the first is in front.
    pub triangle: u32,
    /// What the pixel needs of it.
    pub what: T,
}

/// Lists of fragments by pixel.
pub(super) struct Lists<T> {
    heads: Vec<u32>,
    nodes: Vec<(Fragment<T>, u32)>,
}

const END: u32 = u32::MAX;

impl<T: Copy> Lists<T> {
    pub(super) fn new(pixels: usize) -> Self {
        Self {
            heads: vec![END; pixels],
            nodes: Vec::new(),
        }
    }

    pub(super) fn push(&mut self, pixel: usize, fragment: Fragment<T>) {
        let at = self.nodes.len() as u32;
        self.nodes.push((fragment, self.heads[pixel]));
        self.heads[pixel] = at;
    }

    /// The fragments of a pixel, front to back.
    pub(super) fn sorted(&self, pixel: usize, into: &mut Vec<Fragment<T>>) {
        into.clear();
        let mut at = self.heads[pixel];
        while let Some((fragment, next)) = self.nodes.get(at as usize) {
            into.push(*fragment);
            at = *next;
        }
        into.sort_by(|a, b| {
            b.depth
                .total_cmp(&a.depth)
                .then(a.triangle.cmp(&b.triangle))
        });
    }
}

/// Draws a frame band by band: `draw` gets the rows, their pixels and the triangles that may touch them, in order.
pub(super) fn bands(
    p: &Prepared,
    draw: impl Fn(Range<i32>, &mut [[u8; 3]], &[u32]) -> Tally + Sync + Send,
) -> (Frame, Tally) {
    let mut frame = Frame::new(p.width, p.height, p.background);
    let mut bins = vec![Vec::new(); (p.height as usize).div_ceil(BAND)];
    for (i, t) in (0u32..).zip(&p.triangles) {
        let rows = super::touched::rows(t.position, 0..p.height as i32);
        if !rows.is_empty() {
            let (first, last) = (rows.start as usize, rows.end as usize - 1);
            for bin in &mut bins[first / BAND..=last / BAND] {
                bin.push(i);
            }
        }
    }
    let width = p.width as usize;
    let tally = parallel::chunks(
        &mut frame.pixels,
        BAND * width,
        || (),
        |(), k, pixels| {
            let first = (k * BAND) as i32;
            draw(
                first..first + (pixels.len() / width) as i32,
                pixels,
                &bins[k],
            )
        },
    );
    (frame, tally)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_come_front_to_back_and_ties_in_order() {
        let mut lists = Lists::new(3);
        for (triangle, depth) in [(0, 0.5), (1, 0.9), (2, 0.5), (3, 0.1), (4, 0.9)] {
            lists.push(
                1,
                Fragment {
                    depth,
                    triangle,
                    what: (),
                },
            );
        }
        let mut out = Vec::new();
        lists.sorted(1, &mut out);
        assert_eq!(
            out.iter().map(|f| f.triangle).collect::<Vec<_>>(),
            [1, 4, 0, 2, 3]
        );
        lists.sorted(0, &mut out);
        assert!(out.is_empty());
    }
}
