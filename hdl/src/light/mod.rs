//! Highlights and spots without tables: a shifted low power in the place of cosⁿ, and a quadratic fall-off in the place of
//! Warn's power, as pipelines of [`STAGES`] clocks from the cosines of a pixel to its colour.
//!
//! What goes in are places, as in [`crate::shade::phong`]: l = N·L, the *place in the lobe* t = (1 − N·H)/(1 − γ) and, for a
//! spot, the *place in the cone* v = (1 − e)/(1 − g), e being the cosine from the axis. The host folds γ and g into the
//! words of the interpolants, so κ(ε − γ)^d is (1 − t)^d with κ = 1/(1 − γ)^d and costs d/2 multipliers, rounded up, less
//! than one per degree; ε ≤ γ is t ≥ 1, which is a look at the high bits. The same holds for the fall-offs:
//!
//! | | function | skipped from | multipliers |
//! |---|---|---|---:|
//! | highlight, d = 2, 3, 4 | (1 − t)^d | t ≥ 1 | 2, for whatever degree the material has |
//! | soft spot | (1 − v)² | v ≥ 1 | 1, shared with the hard one |
//! | hard spot | 1 − v² | v ≥ 1 | |
//!
//! The test cannot be left out: for even d the bare formula rises again behind γ (Hast 2004, after 3.276, says that it is
//! negative, which holds for odd d alone).
//!
//! # Range and rounding
//! Places are accumulated as in [`crate::shade::quadratic_dots`], Q10.(19+N), scales 1/(1 − γ) and 1/(1 − g) being at most
//! [`MAX_SCALE`]. The units work with 17 fraction bits: the host adds half of 2^−17 where the unit takes the place as it is
//! (hard), and subtracts as much where it takes what is left to 1 (all others), since the complement of a cut word is
//! one unit short. So what the units begin with is off by at most half a unit, or one whole unit at 1, which they take for
//! 1 − 2^−17. In units of 2^−17:
//!
//! | | bound | why |
//! |---|---:|---|
//! | square | 3 | 2·1, and a cut |
//! | cube | 5 | 3 + 1, and a cut |
//! | fourth power | 7 | 2·3, and a cut |
//! | hard spot | 2 | 2·½, and the complement of a cut |
//! | light times spot | 3 + 2 | spot; a cut to 2^−16 |
//! | highlight times spot | 7 + 3 + 1 | both; a cut |
//!
//! Tests hold the units to [`HIGHLIGHT_ERROR`] and [`SPOT_ERROR`] at every place that there is. Nothing wraps: all of these
//! are within 0 and 1 − 2^−17.

pub mod highlight;
pub mod kappa_colour;
pub mod model;
pub mod skip;
pub mod spot;
pub mod spot_colour;

use crate::shade::phong::{AMBIENT_FRACTION_BITS, LIGHT_FRACTION_BITS, TINT_FRACTION_BITS};

/// Cores that are lit without tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Glint {
    /// Highlights κ(N·H − γ)^d under one light: the quadratic-dots-kappa core.
    Kappa,
    /// The same under one spot with a soft or hard fall-off: the quadratic-dots-spot core.
    Spot,
}

impl Glint {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Kappa, Self::Spot];

    /// Name of the core in the catalogue.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Kappa => "quadratic-dots-kappa",
            Self::Spot => "quadratic-dots-spot",
        }
    }
}

/// Clocks from the cosines of a pixel to its colour.
pub const STAGES: usize = 6;
/// Fraction bits of what the units work with.
pub const FRACTION_BITS: usize = 17;
/// Largest 1/(1 − γ) and 1/(1 − g): as for the table of a power, so that places fit the same words.
pub const MAX_SCALE: f64 = 128.0;
/// Degrees that the highlight unit has.
pub const DEGREES: std::ops::RangeInclusive<u8> = 2..=4;
/// Unit of the bounds.
const UNIT: f64 = 1.0 / (1u64 << FRACTION_BITS) as f64;
/// Largest error of a highlight, of the largest degree.
pub const HIGHLIGHT_ERROR: f64 = 7.0 * UNIT;
/// Largest error of a spot.
pub const SPOT_ERROR: f64 = 3.0 * UNIT;
/// Error of the colour words and of the cuts of their products, LSB.
const COLOUR_ERROR: f64 = 2.0 / (1u64 << (TINT_FRACTION_BITS + 1)) as f64
    + 1.0 / (1u64 << (AMBIENT_FRACTION_BITS + 1)) as f64
    + 2.0 / (1u64 << AMBIENT_FRACTION_BITS) as f64;
/// Largest error of the stages without a spot, LSB, for diffuse and specular colours of at most 255; it grows with them.
pub const KAPPA_ERROR_LSB: f64 =
    255.0 * (HIGHLIGHT_ERROR + 1.0 / (1u64 << (LIGHT_FRACTION_BITS + 1)) as f64) + COLOUR_ERROR;
/// The same with a spot.
pub const SPOT_ERROR_LSB: f64 = KAPPA_ERROR_LSB + 255.0 * (2.0 * SPOT_ERROR + 3.0 * UNIT);
/// Largest change of a highlight with its place: the largest degree.
pub const STEEPEST_HIGHLIGHT: f64 = 4.0;
/// Largest change of a spot with its place.
pub const STEEPEST_SPOT: f64 = 2.0;
/// Register word of the material: the degree of the highlight in bits 2 to 0, and bit 3 for a hard spot.
pub const CURVE_WORD: usize = 9;
/// First of the words of the place in the cone, behind those of the depth.
pub const CONE_WORD: usize = 4;
/// Register word behind those: what is skipped on the whole triangle.
pub const SKIP_WORD: usize = 15;
