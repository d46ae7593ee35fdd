//! Textures: where a pixel lies in a picture, the texels there, and the product of texel and shaded colour.
//!
//! The picture multiplies the whole shaded colour, highlight included, channel by channel, as the software renderer has
//! it: I = c·T/255. The host scales its colour words by 256/255, so the core divides by 256, which takes no gates.
//!
//! # Address
//! u and v are texels, texel i covers i..i + 1. Pictures repeat and their sides are powers of two up to 1024, so only u
//! and v modulo 1024 matter: ten integer bits and twelve fraction bits leave every [`Mapping`]:
//!
//! | mapping | interpolants | format, narrow and wide | address off by at most, texels |
//! |---|---|---|---|
//! | affine | u, v linear | Q9.22, Q9.26 | 2⁻¹³ |
//! | quadratic | u, v quadratic, six knots | Q9.30, Q9.34 | 2⁻¹² |
//! | perspective | u·w, v·w linear, w = 1/z linear | Q10.37, w Q1.46 | 2⁻¹¹ + 2⁻²⁰·abs(u) |
//!
//! and 2⁻¹² more where it is cut to twelve fraction bits. The first two may wrap: residues modulo 1024 texels add
//! exactly. The third divides, so there abs(u) stays below 1024, which the host sees to by taking off whole pictures.
//! Before bilinear interpolation the host takes half a texel off u and v, and adds half a unit against the cut.
//!
//! # Texels
//! Four banks of block RAM by the parities of column and row, one read port each: the four neighbours of any place lie
//! in different banks, so a bilinear pixel takes one clock. (Two dual-port memories would do as well, but then the host
//! would have no port to write through.) Texels are RGB888. The weights have twelve fraction bits, rows are interpolated
//! first and cut to nine, so the texel is within 2·2⁻⁹ LSB of the exact mean at its address; an address that is off by δ
//! moves it by at most 510·δ LSB.
//!
//! Sources: Zed3D 1996, "Texture mapping using 1/z" (u/z, v/z and 1/z linear on the screen; one reciprocal, two
//! products) and "Bilinear"; Abbas 2003, chapter 8 (quadratic addresses); the reciprocal by table and one Newton step.

pub mod blend;
pub mod colour_delay;
pub mod division;
pub mod model;
pub mod modulate;
pub mod place;
pub mod reciprocal;
pub mod reciprocal_table;
pub mod shift;
pub mod unit;

/// How the address is interpolated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Mapping {
    /// u and v linear on the screen.
    Affine,
    /// u and v quadratic on the screen.
    Quadratic,
    /// u·w, v·w and w linear on the screen.
    Perspective,
}

/// What a textured core has beside its colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Texturing {
    /// Address generator.
    pub mapping: Mapping,
    /// The texture memory holds 2 to this many texels, 3 to 16.
    pub texels_log2: u8,
}

/// Texels of a memory of the usual size: one picture of 64 × 64.
pub const USUAL_TEXELS_LOG2: u8 = 12;
/// Texels of the largest memory.
pub const MAX_TEXELS_LOG2: u8 = 16;
/// Address bits of a bank.
pub const BANK_BITS: usize = 14;
/// Longest side of a picture, texels.
pub const MAX_SIDE: u32 = 1024;
/// Fraction bits of an address where texels are looked up.
pub const ADDRESS_FRACTION_BITS: usize = 12;
/// Fraction bits of a colour before it is multiplied by a texel.
pub const COLOUR_FRACTION_BITS: usize = 6;
/// Clocks from the address to the modulated colour.
pub const STAGES: usize = 6;
/// Clocks of the perspective division.
pub const DIVISION_STAGES: usize = 6;
/// Fraction bits of u·w and v·w.
pub const PRODUCT_FRACTION_BITS: usize = 37;
/// Fraction bits of w.
pub const W_FRACTION_BITS: usize = 46;
/// Width of a word of either.
pub const PERSPECTIVE_BITS: usize = 48;
/// Smallest w that is divided by: the normalisation shifts by at most 15 places.
pub const LEAST_W: f64 = 1.0 / (1u64 << 15) as f64;

/// Masks of the register words, bits 7 to 4 of `select`: bit 7 chooses between colours and the rest.
pub mod select {
    /// Depth.
    pub const DEPTH: u8 = 0x80;
    /// u, or u·w.
    pub const U: u8 = 0x90;
    /// v, or v·w.
    pub const V: u8 = 0xa0;
    /// w in words 0 to 3; the words of the texture follow.
    pub const W: u8 = 0xc0;
    /// Where the picture begins, and whether the nearest texel is taken.
    pub const PLACE: u8 = 0xc4;
    /// Sides of the picture.
    pub const SIZE: u8 = 0xc5;
    /// Where the texture memory is written.
    pub const WRITE_PLACE: u8 = 0xc6;
    /// The texel there; the next one is meant afterwards.
    pub const TEXEL: u8 = 0xc7;
}

impl Mapping {
    /// Integer and fraction bits of the interpolants of u and v.
    #[must_use]
    pub fn format(self, wide: bool) -> (usize, usize) {
        match (self, wide) {
            (Self::Affine, false) => (9, 22),
            (Self::Affine, true) => (9, 26),
            (Self::Quadratic, false) => (9, 30),
            (Self::Quadratic, true) => (9, 34),
            (Self::Perspective, _) => (10, PRODUCT_FRACTION_BITS),
        }
    }

    /// Clocks from the interpolants to the address.
    #[must_use]
    pub fn stages(self) -> usize {
        match self {
            Self::Affine | Self::Quadratic => 0,
            Self::Perspective => DIVISION_STAGES,
        }
    }

    /// What an address is off by at most, in texels, after a run of `run` additions; with perspective for abs(u) up to
    /// `reach` and w at least 1/32 of its greatest value.
    #[must_use]
    pub fn error(self, wide: bool, run: u32, reach: f64) -> f64 {
        let n = f64::from(run);
        let unit = 2f64.powi(-(self.format(wide).1 as i32 + 1));
        let cut = 2f64.powi(-(ADDRESS_FRACTION_BITS as i32 + 1));
        cut + match self {
            Self::Affine => (1.0 + n) * unit,
            Self::Quadratic => (1.0 + n * (n + 1.0) / 2.0) * unit,
            Self::Perspective => {
                let w = (1.0 + n) * 2f64.powi(-(W_FRACTION_BITS as i32 + 1));
                // Words; cut before the product; the reciprocal.
                32.0 * ((1.0 + n) * unit + reach * w) + cut * 2.0 + reach * 2f64.powi(-20)
            }
        }
    }
}

impl Texturing {
    /// Name of the core in the catalogue.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self.mapping {
            Mapping::Affine => "textured-affine",
            Mapping::Quadratic => "textured-quadratic",
            Mapping::Perspective => "textured-perspective",
        }
    }

    /// Texels of the memory.
    #[must_use]
    pub fn texels(self) -> usize {
        1 << self.texels_log2.clamp(3, MAX_TEXELS_LOG2)
    }

    /// Bits of the memory.
    #[must_use]
    pub fn memory_bits(self) -> u64 {
        self.texels() as u64 * 24
    }

    /// Largest error of a modulated colour before the final rounding, LSB, where the colour, of at most 255, is off by
    /// `colour`: bilinear interpolation between any texels, abs(u) and abs(v) up to 512.
    #[must_use]
    pub fn error_bound(self, wide: bool, run: u32, colour: f64) -> f64 {
        let address = self.mapping.error(wide, run, 512.0);
        let texel = 510.0 * address + 2.0 * 2f64.powi(-9);
        colour + texel + 2.0 * 2f64.powi(-(COLOUR_FRACTION_BITS as i32))
    }
}
