//! Bumps: normals bent by the gradient of a height map, pixel by pixel, without a square root (Hast 2004, section 3.4).
//!
//! In the frame of the surface (two unit tangents and its normal) a bump has the normal (−F_u, −F_v, 1), F_u and F_v being
//! the gradient of the height, world units per world unit. The units in the order of a pixel:
//!
//! | unit | does | multipliers |
//! |---|---|---:|
//! | [`fetch`] | gradient at (u, v), bilinear between four samples from block RAM in four banks | 6 |
//! | [`newton`] | factors 1 − g²/2 of both parts: direction exact, length short by at most 3g⁴/8 | 2 |
//! | [`reflection`] | factors t = 4/(g² + 4) and 2t − 1: length exact, turned too far by at most g³/4 | 3 |
//! | [`dot`] | cosine with the light (or half-way vector) turned into the frame, from those factors | 4 |
//!
//! Gradients are [`GRADIENT_LIMIT`] at most in each part; Q1.16, so that a sample is a word of 36 bits, which block RAM
//! has, and a factor of a product of 18 bits. Newton's factor is limited at g² = 2, where it would turn the normal around,
//! and the reflection's at g² = 4, where the normal lies in the surface: beyond, the software lets it go below.
//!
//! In the cores (`bump-newton`, `bump-reflection`) the place comes from affine addresses, and light and half-way vector from
//! [`vectors`]; [`map`] has the host's words, [`cosines`] both dot products and the place in the lobe.
//!
//! # Range and rounding
//! | | error at most | why |
//! |---|---:|---|
//! | sample | 2^−17 | to nearest |
//! | gradient | 2^−12·d + 2^−15 | place of 12 fraction bits, cut; two cuts of the blend. d: steepest change between samples |
//! | Newton's factor | 2^−16 + 2^−21 | squares and sum cut |
//! | factor t of the reflection | 1.5·2^−16 | x cut to 16 bits, t to 16, chords; twice that for 2t − 1 |
//! | part of a vector | 2^−16 + the words' rounding | cut |
//! | cosine | 1.25·2^−16 | products cut to 2^−18, the difference to 2^−16 |
//!
//! The host adds half of what is cut from places and vectors, and one unit to the samples, which the blend's two cuts
//! take away again on average; so in a core the gradient is within 2^−13·d + 1.5·2^−16 and a part of a vector within 2^−17.
//! Nothing wraps: squares are at most 4 each, and their sum is taken without a sign; factors are at most 1, cosines below 8.
//! Places are residues: maps repeat after 64 samples.

pub mod banks;
pub mod blend;
pub mod core_model;
pub mod cosines;
pub mod dot;
pub mod fetch;
pub mod fragment_pair;
pub mod map;
pub mod model;
pub mod newton;
pub mod newton_light;
pub mod places;
pub mod reciprocal_table;
pub mod reflection;
pub mod reflection_light;
pub mod vector_delay;
pub mod vectors;

/// How the normal of a bump is brought to unit length.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Bend {
    /// By one Newton step.
    Newton,
    /// By reflection.
    Reflection,
}

impl Bend {
    /// Name of the core in the catalogue.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Newton => "bump-newton",
            Self::Reflection => "bump-reflection",
        }
    }

    /// Clocks from the interpolants to the arguments of the reflection model.
    #[must_use]
    pub fn stages(self) -> usize {
        match self {
            Self::Newton => newton_light::STAGES,
            Self::Reflection => reflection_light::STAGES,
        }
    }

    /// Largest error of N·L or N·H of a core whose words of a vector, of unit length, are off by `word` units of 2^−16,
    /// for gradients up to 1 that are exact at the place.
    #[must_use]
    pub fn cosine_error(self, word: f64) -> f64 {
        let unit = 1.0 / f64::from(1 << 16);
        let factors = match self {
            Self::Newton => 2f64.sqrt() * NEWTON_ERROR,
            Self::Reflection => 5f64.sqrt() * REFLECTION_ERROR,
        };
        // The gradient moves the normal by at most twice as much in either way; the blend's 1.5 units in both parts.
        let gradient = 2.0 * 1.5 * 2f64.sqrt() * unit;
        factors + gradient + DOT_ERROR + 3f64.sqrt() * (0.5 + word) * unit
    }
}

/// Register words of the map among those of the material: sample that is written next, gradients of a sample, whether
/// there are bumps.
pub const MAP_PLACE_WORD: usize = 12;
/// See [`MAP_PLACE_WORD`].
pub const MAP_WORD: usize = 13;
/// See [`MAP_PLACE_WORD`].
pub const BUMPY_WORD: usize = 14;
/// Integer bits of a part of a vector.
pub const VECTOR_INTEGER_BITS: usize = 1;
/// Fraction bits of a part of a vector as the cosines take it.
pub const VECTOR_FRACTION_BITS: usize = 16;
/// Integer bits of an address.
pub const ADDRESS_INTEGER_BITS: usize = 9;
/// Largest exponent that a core draws.
pub const MAX_EXPONENT: f64 = 144.0;
/// The exponent for which a core states its error.
pub const STATED_EXPONENT: f64 = 24.0;

/// The select codes of a core, each with a word number of 0.
pub mod select {
    /// Light along the first tangent, the second one and the normal.
    pub const LIGHT: [u8; 3] = [0x10, 0x20, 0x30];
    /// The material.
    pub const MATERIAL: u8 = 0x40;
    /// Half-way vector along the first tangent, the second one and the normal.
    pub const HALF: [u8; 3] = [0x50, 0x60, 0x70];
    /// Depth.
    pub const DEPTH: u8 = 0x80;
    /// Column of the map.
    pub const U: u8 = 0x90;
    /// Row of the map.
    pub const V: u8 = 0xa0;
}

/// Fraction bits of an address.
#[must_use]
pub fn address_fraction_bits(wide: bool) -> usize {
    if wide {
        26
    } else {
        22
    }
}

/// Fraction bits of a gradient.
pub const GRADIENT_FRACTION_BITS: usize = 16;
/// Largest part of a gradient.
pub const GRADIENT_LIMIT: f64 = 2.0 - 1.0 / (1u64 << GRADIENT_FRACTION_BITS) as f64;
/// Fraction bits of a factor and of the parts of a unit vector.
pub const FACTOR_FRACTION_BITS: usize = 16;
/// Columns and rows of a map.
pub const MAP_SIZE: usize = 64;
/// Fraction bits of a place in the map.
pub const PLACE_FRACTION_BITS: usize = 12;
/// Largest error of Newton's factor.
pub const NEWTON_ERROR: f64 = 1.0 / 65_536.0 + 1.0 / 2_097_152.0;
/// Largest error of the factor of the reflection.
pub const REFLECTION_ERROR: f64 = 1.5 / 65_536.0;
/// Largest error of a cosine, from exact factors and gradients.
pub const DOT_ERROR: f64 = 1.25 / 65_536.0;
