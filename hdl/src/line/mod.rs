//! Lines in hardware: three cores with the ports of the triangle cores, and a unit that delivers columns.
//!
//! | module | what |
//! |---|---|
//! | [`walk`] | register file and Bresenham's walk, all octants; its model in [`walk_model`] |
//! | [`place`] | lanes of a column on the screen and in the frame memory |
//! | [`cue`] | depth cueing, one accumulator per channel |
//! | [`box_weight`] | weights of the box filter, without drift |
//! | [`coverage`], [`weight_rom`] | V(D) from its convolution, and its table |
//! | [`cone_words`] | register words of the cone filter |
//! | [`cone_stages`] | distances, one pixel per clock by one shared adder: two overlapped stages |
//! | [`cone_column`] | distances and weights, one column of three (or four) pixels per clock |
//! | [`blend`], [`stream`] | old·(1 − w) + new·w, the pixel stream over the frame memory; its model in [`stream_model`] |
//! | [`bresenham`], [`box_filter`], [`cone`] | the cores |
//! | [`model`] | the cores' integer model |
//!
//! A line joins pixel centres and is walked with its major coordinate rising, so both directions give the same pixels.
//! Where it passes half-way between two pixels the walk stays on its row.

pub mod blend;
pub mod box_filter;
pub mod box_weight;
pub mod bresenham;
pub mod cone;
pub mod cone_column;
pub mod cone_stages;
pub mod cone_words;
pub mod coverage;
pub mod cue;
pub mod model;
pub mod place;
pub mod stream;
pub mod stream_model;
pub mod walk;
pub mod walk_model;
pub mod weight_rom;

use crate::shade::device::DesignVisitor;

/// Fraction bits of the cone core's table of weights.
pub const TABLE_BITS: u32 = 8;

/// Filter of a line core.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Filter {
    /// One pixel per column.
    Bresenham,
    /// Two pixels per column.
    Box,
    /// Three pixels per column, four near the diagonal.
    Cone,
}

impl Filter {
    /// All, in the order of the catalogue.
    pub const ALL: [Self; 3] = [Self::Bresenham, Self::Box, Self::Cone];

    /// Name of the core.
    #[must_use]
    pub fn core_name(self) -> &'static str {
        match self {
            Self::Bresenham => "bresenham",
            Self::Box => "box",
            Self::Cone => "cone",
        }
    }

    /// Largest arithmetic error of a pixel before its final rounding, in LSB, over what lay there before, for lines of up to
    /// `run` columns: the colour's words are rounded to nearest. A cone's distance may lie on the other side of a border of
    /// the table, which is one level of 255.
    #[must_use]
    pub fn error_bound(self, run: u32) -> f64 {
        let colour = (1.0 + f64::from(run)) / 2f64.powi(cue::FRACTION_BITS as i32 + 1);
        match self {
            Self::Bresenham | Self::Box => colour,
            Self::Cone => colour + 1.0,
        }
    }

    /// Clocks from the edge that takes `start` to the edge at which the first pixel can be taken, in an idle core.
    #[must_use]
    pub fn latency(self) -> u32 {
        match self {
            Self::Bresenham => 3,
            Self::Box | Self::Cone => 5,
        }
    }

    /// Bits of the frame memory per pixel.
    #[must_use]
    pub fn memory_bits(self) -> u64 {
        match self {
            Self::Bresenham => 0,
            Self::Box | Self::Cone => 24,
        }
    }

    /// Calls `f` with the core's description; `A` is the width of a frame address.
    pub(crate) fn with_design<const A: usize, R>(
        self,
        pixels: usize,
        f: impl DesignVisitor<R>,
    ) -> R {
        match self {
            Self::Bresenham => f.visit(bresenham::BresenhamCore::<A>::default()),
            Self::Box => f.visit(box_filter::BoxCore::<A>::new(pixels)),
            Self::Cone => f.visit(cone::ConeCore::<A>::new(pixels)),
        }
    }
}
