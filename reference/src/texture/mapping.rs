//! From pixels to places in the texture, in texels, by forward differences along a span.
//!
//! *Perspective* (Zed3D 1996, "Texture mapping using 1/z"): u·w, v·w and w = 1/depth are affine on the screen, three
//! linear interpolants and one reciprocal per pixel. *Affine*: u and v themselves, two linear interpolants; exact
//! without perspective or on planes parallel to the screen, see [`super::affine`]. *Quadratic* (Abbas 2003 ch. 8): u and
//! v through the true values at the vertices and at the middles of the edges on the screen, two quadratic interpolants.
//!
//! Along a line of constant depth (Zed3D 1996, "Constant z") the steps of the perspective address are constant and one
//! reciprocal serves the whole line. Spans are seldom exactly such lines, but with u₀ and u' the address and its
//! derivative at the start, the address k pixels on is u₀ + k·u'·w₀/wₖ; constant steps u₀ + k·u' are therefore off by
//! k·|u'|·|wₖ − w₀|/wₖ, which grows with k. Spans on which this stays below [`CONSTANT_DEPTH_TOLERANCE`] at the last
//! pixel have one reciprocal.

use super::Footprint;
use crate::geometry::ScreenTriangle;
use crate::raster::SUBPIXELS;
use crate::shade::differences::{Differences, Interpolant};
use crate::shade::quadratic::{middle_weights, EDGES};
use glam::DVec2;

/// What a span with one reciprocal may be off by, in texels and in each direction: the rounding of the vertices to
/// 1/256 pixel moves the texture more.
pub const CONSTANT_DEPTH_TOLERANCE: f64 = 1.0 / 256.0;

/// How the address is interpolated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mapping {
    /// Linear on the screen.
    Affine,
    /// Quadratic on the screen.
    Quadratic,
    /// True.
    #[default]
    Perspective,
}

/// The address on a triangle.
#[derive(Clone, Copy, Debug)]
pub struct Address {
    mapping: Mapping,
    /// (u, v, –) or, with perspective, (u·w, v·w, w).
    interpolant: Interpolant,
    /// Derivative downwards of what a linear interpolant holds.
    down: [f64; 3],
}

/// Change of linear interpolants from row to row, measured at the triangle.
fn change_down(t: &ScreenTriangle, i: &Interpolant) -> [f64; 3] {
    let (x, y) = (t.position[0].x / SUBPIXELS, t.position[0].y / SUBPIXELS);
    let (here, below) = (i.start(x, y).r, i.start(x, y + 1).r);
    [0, 1, 2].map(|c| below[c] - here[c])
}

impl Address {
    /// The address on `t`, whose texture coordinates are `uv` in texels.
    #[must_use]
    pub fn new(t: &ScreenTriangle, uv: &[DVec2; 3], mapping: Mapping) -> Self {
        let plain = |v: DVec2| [v.x, v.y, 0.0];
        let interpolant = match mapping {
            Mapping::Affine => Interpolant::linear(t.position, &uv.map(plain)),
            Mapping::Perspective => {
                let knot = |i: usize| [uv[i].x * t.inv_w[i], uv[i].y * t.inv_w[i], t.inv_w[i]];
                Interpolant::linear(t.position, &[0, 1, 2].map(knot))
            }
            Mapping::Quadratic => {
                let [a, b, c] = uv.map(plain);
                let [d, e, f] = [0, 1, 2].map(|k| {
                    let ((i, j), (qi, qj)) = (EDGES[k], middle_weights(t, k));
                    plain(uv[i] * qi + uv[j] * qj)
                });
                Interpolant::quadratic(t.position, &[a, b, c, d, e, f])
            }
        };
        let down = match mapping {
            Mapping::Quadratic => [0.0; 3],
            _ => change_down(t, &interpolant),
        };
        Self {
            mapping,
            interpolant,
            down,
        }
    }

    /// The address along a span of `pixels` from (`x`, `y`). With `constant_depth`, one reciprocal is used where that
    /// is within [`CONSTANT_DEPTH_TOLERANCE`].
    #[must_use]
    pub fn start(&self, x: i32, y: i32, pixels: i32, constant_depth: bool) -> Track {
        let at = self.interpolant.start(x, y);
        let down = self.down;
        match self.mapping {
            Mapping::Affine => Track::Linear { at, down },
            Mapping::Perspective => {
                let line = Line::new(&at, down);
                if constant_depth && pixels > 1 && line.keeps_depth(&at, pixels - 1) {
                    Track::Line(line)
                } else {
                    Track::Perspective { at, down }
                }
            }
            Mapping::Quadratic => {
                // Half the difference between the rows around is the derivative of a quadratic, and it is linear.
                let (above, below) = (
                    self.interpolant.start(x, y - 1),
                    self.interpolant.start(x, y + 1),
                );
                let half = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|c| (b[c] - a[c]) / 2.0);
                Track::Quadratic {
                    at,
                    down: Differences {
                        r: half(above.r, below.r),
                        dr: half(above.dr, below.dr),
                        d2r: [0.0; 3],
                    },
                }
            }
        }
    }
}

/// A span on which depth hardly changes.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    at: DVec2,
    right: DVec2,
    /// 1/w, the one reciprocal.
    depth: f64,
    down: [f64; 3],
}

impl Line {
    fn new(at: &Differences, down: [f64; 3]) -> Self {
        let depth = 1.0 / at.r[2];
        let uv = DVec2::new(at.r[0], at.r[1]) * depth;
        Self {
            at: uv,
            right: (DVec2::new(at.dr[0], at.dr[1]) - uv * at.dr[2]) * depth,
            depth,
            down,
        }
    }

    /// Whether constant steps are within the tolerance after `steps`.
    fn keeps_depth(&self, at: &Differences, steps: i32) -> bool {
        let k = f64::from(steps);
        let (change, end) = (k * at.dr[2], at.r[2] + k * at.dr[2]);
        let moved = k * self.right.abs().max_element();
        end > 0.0 && moved * change.abs() < CONSTANT_DEPTH_TOLERANCE * end
    }
}

/// The address along a span.
#[derive(Clone, Copy, Debug)]
pub enum Track {
    /// u and v by constant steps.
    Linear {
        /// u, v and their steps.
        at: Differences,
        /// Derivative downwards.
        down: [f64; 3],
    },
    /// u and v by second differences.
    Quadratic {
        /// u, v and their differences.
        at: Differences,
        /// Derivative downwards, and its step.
        down: Differences,
    },
    /// A reciprocal for every pixel.
    Perspective {
        /// u·w, v·w, w and their steps.
        at: Differences,
        /// Derivative downwards of u·w, v·w and w.
        down: [f64; 3],
    },
    /// One reciprocal for all.
    Line(Line),
}

/// The derivative of (U/w, V/w) where (U, V, w) has the derivative `d`.
fn projected(uv: DVec2, d: [f64; 3], depth: f64) -> DVec2 {
    (DVec2::new(d[0], d[1]) - uv * d[2]) * depth
}

impl Track {
    /// The place in the texture under the current pixel centre, and how far it moves from pixel to pixel.
    #[must_use]
    pub fn place(&self) -> (DVec2, Footprint) {
        let plane = |v: [f64; 3]| DVec2::new(v[0], v[1]);
        match self {
            Self::Linear { at, down } => (
                plane(at.r),
                Footprint {
                    right: plane(at.dr),
                    down: plane(*down),
                },
            ),
            Self::Quadratic { at, down } => (
                plane(at.r),
                Footprint {
                    // The difference to the next pixel is the derivative half a pixel on.
                    right: plane(at.dr) - plane(at.d2r) / 2.0,
                    down: plane(down.r),
                },
            ),
            Self::Perspective { at, down } => {
                let depth = 1.0 / at.r[2];
                let uv = plane(at.r) * depth;
                let right = projected(uv, at.dr, depth);
                let down = projected(uv, *down, depth);
                (uv, Footprint { right, down })
            }
            Self::Line(l) => (
                l.at,
                Footprint {
                    right: l.right,
                    down: projected(l.at, l.down, l.depth),
                },
            ),
        }
    }

    /// Moves one pixel to the right.
    pub fn step(&mut self) {
        use crate::shade::shader::Run;
        match self {
            Self::Linear { at, .. } | Self::Perspective { at, .. } => at.step(),
            Self::Quadratic { at, down } => {
                at.step();
                down.step();
            }
            Self::Line(l) => l.at += l.right,
        }
    }
}

#[cfg(test)]
mod tests;
