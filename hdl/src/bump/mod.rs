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
//! Gradients are [`GRADIENT_LIMIT`] at most in each part; Q1.14, so that a sample is a word of 32 bits. Newton's factor is
//! limited at g² = 2, where it would turn the normal around, and the reflection's at g² = 4, where the normal lies in the
//! surface: beyond, the software lets it go below.
//!
//! # Range and rounding
//! | | error at most | why |
//! |---|---:|---|
//! | gradient | 2^−9·d + 2^−13 | weights of 8 fraction bits, cut; two cuts of the blend. d: steepest change between samples |
//! | Newton's factor | 2^−16 + 2^−21 | squares and sum cut |
//! | factor t of the reflection | 1.5·2^−16 | x cut to 16 bits, t to 16, chords; twice that for 2t − 1 |
//! | cosine | 1.25·2^−16 | products cut to 2^−18, the difference to 2^−16 |
//!
//! Nothing wraps: squares are at most 4 each, and their sum is taken without a sign; factors are at most 1, cosines below 8.

pub mod banks;
pub mod blend;
pub mod dot;
pub mod fetch;
pub mod model;
pub mod newton;
pub mod reciprocal_table;
pub mod reflection;

/// Fraction bits of a gradient.
pub const GRADIENT_FRACTION_BITS: usize = 14;
/// Largest part of a gradient.
pub const GRADIENT_LIMIT: f64 = 2.0 - 1.0 / (1u64 << GRADIENT_FRACTION_BITS) as f64;
/// Fraction bits of a factor and of the parts of a unit vector.
pub const FACTOR_FRACTION_BITS: usize = 16;
/// Columns and rows of a map.
pub const MAP_SIZE: usize = 64;
/// Fraction bits of a place in the map.
pub const PLACE_FRACTION_BITS: usize = 8;
/// Largest error of Newton's factor.
pub const NEWTON_ERROR: f64 = 1.0 / 65_536.0 + 1.0 / 2_097_152.0;
/// Largest error of the factor of the reflection.
pub const REFLECTION_ERROR: f64 = 1.5 / 65_536.0;
/// Largest error of a cosine, from exact factors and gradients.
pub const DOT_ERROR: f64 = 1.25 / 65_536.0;
