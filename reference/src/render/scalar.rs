//! Drawing into a band of rows one pixel after the other: walk, depth test in real numbers, colour by any [`Shader`].

use super::bands::{Ready, Tally};
use crate::geometry::Prepared;
use crate::shade::barycentric::{steps, weights};
use crate::shade::shader::{Draw, Run, Shader};
use crate::shade::to_byte;

/// Rows `first_row..` of the frame.
pub(super) struct Band<'a, S> {
    pub prepared: &'a Prepared,
    pub shader: &'a S,
    pub first_row: i32,
    pub pixels: &'a mut [[u8; 3]],
    /// Pixels that fail the depth test are not shaded.
    pub skip_hidden: bool,
    /// Spans of one pixel are not set up.
    pub skip_one_pixel: bool,
}

impl<S: Shader> Band<'_, S> {
    /// Draws triangles in order.
    pub(super) fn draw(&mut self, triangles: &[u32], ready: &[Ready<S::Triangle>]) -> Tally {
        let width = self.prepared.width as usize;
        let rows = (self.pixels.len() / width) as i32;
        let mut buffer = vec![f64::NEG_INFINITY; self.pixels.len()];
        let mut tally = Tally::default();
        for r in triangles.iter().map(|i| &ready[*i as usize]) {
            let t = &self.prepared.triangles[r.index];
            let z = t.depth;
            let step = steps(&t.position);
            let dz = z[0] * step[0] + z[1] * step[1] + z[2] * step[2];
            for span in r.walk.spans(self.prepared.width) {
                let row = span.y - self.first_row;
                if row >= rows {
                    break;
                }
                if row < 0 {
                    continue;
                }
                let w = weights(&t.position, span.start, span.y);
                let z0 = z[0] * w[0] + z[1] * w[1] + z[2] * w[2];
                let from = row as usize * width + span.start as usize;
                let to = row as usize * width + span.end as usize;
                let line = Line {
                    pixels: &mut self.pixels[from..to],
                    depths: &mut buffer[from..to],
                    z0,
                    dz,
                    skip_hidden: self.skip_hidden,
                };
                let drawn = if S::ONE_PIXEL && self.skip_one_pixel && span.end - span.start == 1 {
                    tally.one_pixel += 1;
                    self.shader.one_pixel(self.prepared, &r.setup, span, line)
                } else {
                    line.draw(self.shader.start(self.prepared, &r.setup, span))
                };
                tally = tally + drawn;
            }
        }
        tally
    }
}

/// One span in the frame.
struct Line<'a> {
    pixels: &'a mut [[u8; 3]],
    depths: &'a mut [f64],
    z0: f64,
    dz: f64,
    skip_hidden: bool,
}

impl Draw for Line<'_> {
    type Out = Tally;

    fn draw(self, mut run: impl Run) -> Tally {
        let tested = self.pixels.len() as u64;
        let mut written = 0;
        for (k, (pixel, stored)) in self.pixels.iter_mut().zip(self.depths).enumerate() {
            let z = self.z0 + k as f64 * self.dz;
            let visible = z > *stored;
            if visible || !self.skip_hidden {
                let colour = run.colour().map(to_byte);
                if visible {
                    *stored = z;
                    *pixel = colour;
                    written += 1;
                }
            }
            run.step();
        }
        Tally {
            tested,
            written,
            hidden: if self.skip_hidden {
                tested - written
            } else {
                0
            },
            ..Tally::default()
        }
    }
}
