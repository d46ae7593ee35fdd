//! The reflection model per pixel: colour = ambient + diffuse·l + specular·hⁿ, as a pipeline of [`STAGES`] clocks.
//!
//! What goes in are two cosines of a pixel: l = max(0, N·L), and t = (1 − N·H)·2^s, the *place in the lobe*, which is
//! what the interpolant of N·H accumulates (see [`power`]). All stages move with the `go` of the pixel stream.
//!
//! # Range and rounding
//! The host refuses material words whose sum ambient + diffuse + specular exceeds 2047 LSB in a channel; with l ≤ 1 and
//! hⁿ < 1 the sum then fits Q11.12 and never wraps. In LSB, for diffuse and specular colours of at most 255, the stages
//! add up to [`ERROR_LSB`]:
//!
//! | from | bound | why |
//! |---|---:|---|
//! | colour words | 0.0158 | two of Q11.6 and one of Q11.12, to nearest |
//! | l | 0.0020 | 255·2^−17: 16 fraction bits, to nearest (the host adds half) |
//! | hⁿ | 0.0306 | 255·[`power::ERROR`] |
//! | products | 0.0005 | two, cut to 12 fraction bits |

pub mod colour;
pub mod cosine;
pub mod fragment_delay;
pub mod inverse_root;
pub mod lobe_place;
pub mod model;
pub mod power;
pub mod power_table;
pub mod reflect;
pub mod root_model;
pub mod root_table;
pub mod unit_cosines;

/// Clocks from the cosines of a pixel to its colour.
pub const STAGES: usize = 6;
/// Fraction bits of l.
pub const LIGHT_FRACTION_BITS: usize = 16;
/// Integer bits of the interpolant of N·L: six knots within ±2 stay within ±10/3.
pub const LIGHT_INTEGER_BITS: usize = 2;
/// Fraction bits of a diffuse or specular colour, which have 11 integer bits.
pub const TINT_FRACTION_BITS: usize = 6;
/// Fraction bits of the ambient colour, which has 11 integer bits.
pub const AMBIENT_FRACTION_BITS: usize = 12;
/// Largest error of the stages, LSB, for diffuse and specular colours of at most 255; it grows with them.
pub const ERROR_LSB: f64 = 255.0 * power::ERROR
    + 255.0 / (1u64 << (LIGHT_FRACTION_BITS + 1)) as f64
    + 2.0 / (1u64 << (TINT_FRACTION_BITS + 1)) as f64
    + 1.0 / (1u64 << (AMBIENT_FRACTION_BITS + 1)) as f64
    + 2.0 / (1u64 << AMBIENT_FRACTION_BITS) as f64;
/// Register words of the material: per channel, three; then where in the power table, and the word there.
pub const MATERIAL_WORDS: usize = 11;
/// Register word of the place in the power table.
pub const TABLE_PLACE_WORD: usize = 9;
/// Register word that goes to that place, which then moves on.
pub const TABLE_WORD: usize = 10;
/// Shell word that waits: nothing is accepted until all triangles before it have been coloured.
pub const FENCE_WORD: usize = 12;
