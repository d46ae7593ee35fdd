//! Drawing into a band of rows: walk, depth test, colour. Bands share nothing, so they may be drawn at the same time,
//! and every span starts from exact values, so the frame does not depend on how rows are divided.

use super::span::{Differences, Interpolant};
use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::{Span, Walk};
use crate::shade::barycentric::{steps, weights};
use crate::shade::{exact, to_byte};
use crate::{depth, skips};

/// How the pixels of a triangle get their colour.
#[derive(Clone, Copy, Debug)]
pub(super) enum Colour {
    Constant([u8; 3]),
    Differences(Interpolant),
    Exact,
}

/// A triangle set up for drawing.
pub(super) struct Ready<'a> {
    pub triangle: &'a ScreenTriangle,
    pub walk: Walk,
    pub colour: Colour,
}

/// What a band counted.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tally {
    pub tested: u64,
    pub shaded: u64,
    pub written: u64,
    pub hidden: u64,
}

impl std::ops::Add for Tally {
    type Output = Self;

    fn add(self, o: Self) -> Self {
        Self {
            tested: self.tested + o.tested,
            shaded: self.shaded + o.shaded,
            written: self.written + o.written,
            hidden: self.hidden + o.hidden,
        }
    }
}

/// A kind of depth buffer.
pub(super) trait DepthCell: Copy + PartialOrd + Send {
    /// Farther than anything drawn.
    const CLEARED: Self;
    /// The cell of a scaled depth.
    fn of(scaled: f64) -> Self;
}

impl DepthCell for u16 {
    const CLEARED: Self = 0;

    fn of(scaled: f64) -> Self {
        depth::round(scaled)
    }
}

impl DepthCell for f64 {
    const CLEARED: Self = Self::NEG_INFINITY;

    fn of(scaled: f64) -> Self {
        scaled
    }
}

/// Rows `first_row..` of the frame.
pub(super) struct Band<'a> {
    pub prepared: &'a Prepared,
    pub first_row: i32,
    pub pixels: &'a mut [[u8; 3]],
    /// Pixels that fail the depth test are not shaded.
    pub skip_hidden: bool,
}

impl Band<'_> {
    /// Draws triangles in order.
    pub(super) fn draw<Z: DepthCell>(
        &mut self,
        triangles: impl Iterator<Item = usize>,
        ready: &[Ready<'_>],
    ) -> Tally {
        let width = self.prepared.width as usize;
        let rows = (self.pixels.len() / width) as i32;
        let mut buffer = vec![Z::CLEARED; self.pixels.len()];
        let mut tally = Tally::default();
        for r in triangles.map(|i| &ready[i]) {
            let t = r.triangle;
            let z = t.depth.map(depth::scaled);
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
                    span,
                    pixels: &mut self.pixels[from..to],
                    depths: &mut buffer[from..to],
                    z0,
                    dz,
                    skip_hidden: self.skip_hidden,
                };
                tally = tally
                    + match r.colour {
                        Colour::Constant(c) => line.run(|_, _| c),
                        Colour::Differences(i) => {
                            let mut d: Differences = i.start(span.start, span.y);
                            line.run(|_, wanted| {
                                let c = if wanted { d.r.map(to_byte) } else { [0; 3] };
                                d.step();
                                c
                            })
                        }
                        Colour::Exact => line.run(|x, wanted| {
                            if wanted {
                                exact::value(self.prepared, t, x, span.y).map(to_byte)
                            } else {
                                [0; 3]
                            }
                        }),
                    };
            }
        }
        tally
    }
}

/// One span in the frame.
struct Line<'a, Z> {
    span: Span,
    pixels: &'a mut [[u8; 3]],
    depths: &'a mut [Z],
    z0: f64,
    dz: f64,
    skip_hidden: bool,
}

impl<Z: DepthCell> Line<'_, Z> {
    /// `colour` is asked for every pixel in turn and told whether its answer is wanted.
    fn run(self, mut colour: impl FnMut(i32, bool) -> [u8; 3]) -> Tally {
        let mut written = 0;
        for (k, (pixel, stored)) in self.pixels.iter_mut().zip(self.depths).enumerate() {
            let z = Z::of(self.z0 + k as f64 * self.dz);
            let visible = z > *stored;
            let c = colour(self.span.start + k as i32, visible || !self.skip_hidden);
            if visible {
                *stored = z;
                *pixel = c;
                written += 1;
            }
        }
        let tested = (self.span.end - self.span.start) as u64;
        let hidden = if self.skip_hidden {
            tested - written
        } else {
            0
        };
        Tally {
            tested,
            shaded: tested - hidden,
            written,
            hidden,
        }
    }
}

/// The name under which [`Tally::hidden`] is reported.
pub(super) const HIDDEN: &str = skips::HIDDEN;
