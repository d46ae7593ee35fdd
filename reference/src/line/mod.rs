//! Lines on the pixel grid: which pixels, with which weight. A line joins two pixel centres.
//!
//! | file | what |
//! |---|---|
//! | `path` | octants, directions, the common error term |
//! | `bresenham` | one pixel per column |
//! | `dda` | the real-valued walk that drifts; kept to show why it is not used |
//! | `box_filter` | two pixels per column, area without regard to the slope |
//! | `coverage` | V(D), the strip convolved with a cone, and its tables |
//! | `cone` | three or four pixels per column, V of the true distance |
//! | `set_up` | the words that a hardware line core starts from |
//! | `fixed` | the cone-filtered walk in integers, with drifting and drift-free D |
//! | `cue` | depth cueing |
//! | `blend` | weighted writing |
//! | `hidden` | the parts of an edge that faces hide |
//! | `wireframe` | meshes drawn by their edges |
//!
//! **The tie rule.** Every line is walked with its major coordinate rising (from left to right; from top to bottom when it
//! is steeper than the diagonal), whatever end it was given first, so both directions give the same pixels. Where the
//! line passes exactly half-way between two pixels, the walk stays on the row (column) it comes from. Mirrored lines
//! therefore give mirrored pixels, except under the mirroring that swaps the ends.

pub mod blend;
pub mod bresenham;
pub mod cone;
pub mod coverage;
pub mod cue;
pub mod dda;
pub mod fixed;
pub mod hidden;
pub mod path;
pub mod set_up;
pub mod wireframe;

pub mod box_filter;

pub use path::{Path, Pixel};

use std::fmt;

/// How lines are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum LineFilter {
    /// One pixel per column: jagged.
    Bresenham,
    /// Two pixels per column.
    Box,
    /// Three pixels per column, four near the diagonal.
    #[default]
    Cone,
}

impl LineFilter {
    /// All, in the order of the catalogue.
    pub const ALL: [Self; 3] = [Self::Bresenham, Self::Box, Self::Cone];

    /// The name in scene files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Bresenham => "bresenham",
            Self::Box => "box",
            Self::Cone => "cone",
        }
    }
}

impl fmt::Display for LineFilter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}
