//! Which triangle is seen at each pixel centre, by five ways that share no decision with each other: the z-buffer, painter's
//! order, a BSP tree, scan-line visibility and casting rays. They exist to check the z-buffer, so each keeps to its own
//! principle and none is in a hurry.
//!
//! Coverage is not in question here: a pixel belongs to the triangles that [`crate::raster::covers`] gives it to, and
//! where two of those are equally near, the first of the list is seen. All but the rays therefore agree about every
//! pixel except where two depths tie; [`compare`] says how near a tie is a tie.

pub mod bsp;
pub mod compare;
pub mod painter;
mod piece;
pub mod raycast;
pub mod scanline;
pub mod zbuffer;

pub use compare::{compare, Comparison};

use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::{Span, Viewport, Walk};

/// The id of a pixel that no triangle covers.
pub const NONE: u32 = u32::MAX;

/// The triangle seen at each pixel centre.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Visible {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Index into `triangles` of the [`Prepared`], or [`NONE`]; row by row from the top.
    pub ids: Vec<u32>,
    /// How often a pixel was written.
    pub written: u64,
}

impl Visible {
    fn new(p: &Prepared) -> Self {
        Self {
            width: p.width,
            height: p.height,
            ids: vec![NONE; p.width as usize * p.height as usize],
            written: 0,
        }
    }

    /// Pixels at which something is seen.
    #[must_use]
    pub fn seen(&self) -> u64 {
        self.ids.iter().filter(|id| **id != NONE).count() as u64
    }

    /// Pixels written for each pixel seen: 1 at best; 1 as well where nothing is seen.
    #[must_use]
    pub fn overdraw(&self) -> f64 {
        match self.seen() {
            0 => 1.0,
            n => self.written as f64 / n as f64,
        }
    }

    fn write(&mut self, at: usize, id: usize) {
        self.ids[at] = id as u32;
        self.written += 1;
    }
}

/// The spans of a triangle in the frame.
fn each_span(p: &Prepared, t: &ScreenTriangle, f: impl FnMut(Span)) {
    let viewport = Viewport {
        width: p.width,
        height: p.height,
    };
    if let Some(walk) = Walk::new(t.position, viewport) {
        walk.spans(p.width).for_each(f);
    }
}

/// Index of a pixel in the frame.
fn pixel(p: &Prepared, x: i32, y: i32) -> usize {
    y as usize * p.width as usize + x as usize
}

/// Reversed depth as a plane over the screen, d = d₀ + a·(x − x₀) + b·(y − y₀), solved from the three vertices. The
/// z-buffer uses barycentric weights instead.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthPlane {
    origin: [f64; 2],
    depth: f64,
    /// Change of depth from a pixel to its right and to its lower neighbour.
    pub slope: [f64; 2],
}

impl DepthPlane {
    /// The plane of a triangle; level where it has no area.
    #[must_use]
    pub fn new(t: &ScreenTriangle) -> Self {
        let [(x0, y0), (x1, y1), (x2, y2)] = t.position.map(|q| q.pixels());
        let (u, v) = ((x1 - x0, y1 - y0), (x2 - x0, y2 - y0));
        let (du, dv) = (t.depth[1] - t.depth[0], t.depth[2] - t.depth[0]);
        let area = u.0 * v.1 - u.1 * v.0;
        let slope = if area == 0.0 {
            [0.0; 2]
        } else {
            [(du * v.1 - dv * u.1) / area, (dv * u.0 - du * v.0) / area]
        };
        Self {
            origin: [x0, y0],
            depth: t.depth[0],
            slope,
        }
    }

    /// The depth at a position in pixels.
    #[must_use]
    pub fn at(&self, x: f64, y: f64) -> f64 {
        self.depth + self.slope[0] * (x - self.origin[0]) + self.slope[1] * (y - self.origin[1])
    }

    /// Steepness: the sum of both slopes' sizes.
    #[must_use]
    pub fn steepness(&self) -> f64 {
        self.slope[0].abs() + self.slope[1].abs()
    }
}
