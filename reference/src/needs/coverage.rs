//! How long triangles are walked, and how many lie over one another.

use super::Needs;
use crate::geometry::Prepared;
use crate::raster::{Viewport, Walk};

impl Needs {
    /// Walks every triangle as a core does; which of them cover a pixel.
    pub(super) fn walk(&mut self, p: &Prepared) -> Vec<bool> {
        let viewport = Viewport {
            width: p.width,
            height: p.height,
        };
        let columns = p.width as usize;
        let mut over = vec![0u32; columns * p.height as usize];
        let mut covering = Vec::with_capacity(p.triangles.len());
        for t in &p.triangles {
            let Some(walk) = Walk::new(t.position, viewport) else {
                covering.push(false);
                continue;
            };
            let mut pixels = 0;
            for span in walk.spans(p.width) {
                let length = (span.end - span.start) as u32;
                self.longest_span = self.longest_span.max(length);
                pixels += u64::from(length);
                let row = span.y as usize * columns;
                for n in &mut over[row + span.start as usize..row + span.end as usize] {
                    *n += 1;
                }
            }
            self.pixels += pixels;
            covering.push(pixels > 0);
            if pixels > 0 {
                self.most_rows = self.most_rows.max(walk.rows);
                self.longest_run = self.longest_run.max(longest_run(&walk));
            }
        }
        self.deepest = over.into_iter().max().unwrap_or(0);
        self.empty = covering.iter().filter(|c| !**c).count() as u64;
        covering
    }
}

/// Most additions of a value on this walk: lines, a further one for each carry of the major edge, and pixels.
fn longest_run(walk: &Walk) -> u32 {
    let mut major = walk.major;
    let (mut lines, mut longest) = (0, 0);
    for (_, start, end) in walk.walk_spans() {
        if end > start {
            longest = longest.max(lines + (end - 1 - start) as u32);
        }
        lines += 1 + u32::from(major.carries());
        major.step();
    }
    longest
}
