//! A set-up engine: from a triangle's corners, depths and six knots per channel to the register words of the quadratic
//! core, in hardware, with one multiplier and one divider. Optional: the host's set-up is exact and stays the default.
//!
//! # What it computes
//! Corners are sorted from the top down: T, M, B (Abbas 2003, section 2.2). In a mirrored triangle columns are negated
//! first. Edge words follow `reference/src/raster/walk.rs`, exactly: two whole divisions per edge.
//!
//! A colour is written over the weight λ of M and the height τ = (y − yT)/H, H = yB − yT. With the coefficients of Hast's
//! ortho-normalised triangle (2004, section 3.3.3) over the weights of M and B,
//! a = 2(kT + kM − 2kTM), b = 2(kT + kB − 2kTB), c = 4(kT + kMB − kTM − kTB), d = kM − kT − a, e = kB − kT − b,
//! and ρ = (yM − yT)/H,
//!
//! ```text
//! f = kT + D·λ + e·τ + A·λ² + b·τ² + C·λτ,   A = a + ρ(ρb − c),   C = c − 2ρb,   D = d − ρe
//! ```
//!
//! λ is linear across a row and zero on the major edge, where spans begin: λ = n/area with an integer n, which a pixel
//! changes by 256·H, a line by −256·up (`up` is the edge's own error step), and which is `start` at the first pixel; τ
//! changes by σ = 256/H per row alone. So every word is a product of two or three integers and a rounded coefficient, for
//! instance dd(p, p) = 256·H·(2α·256·H) with α = A/area², and slopes along n are summed before they are multiplied by n.
//!
//! # Why thin triangles come out right
//! Differences of a sliver are far larger than its colours, and cancel only because all of them belong to one
//! polynomial. Here α, the slope and the twist per n are rounded *once*, relative to the range of their term; the
//! integers multiply these rounded numbers exactly, modulo what the registers hold. So the words are those of a polynomial
//! whose coefficients are off by a few parts in 2^23, at every covered pixel (0 ≤ λ, τ ≤ 1), however thin it is.
//!
//! # Formats
//! Knots U11.10 (depths U16.6, which count as sixteenths: U12.10); coefficients 10 fraction bits in 25 (|A| ≤ 10200,
//! |C| ≤ 12240, |D + Cτ| ≤ 7650, |e + 2bτ| ≤ 6120 for knots from 0 to 1530, as a colour stays between −510 and 2040 over
//! the triangle); ρ and τ 23 fraction bits, 1/H 43, σ² 47; 1/area a mantissa of 24 bits and an exponent of 0 to 40;
//! slopes per n 52 fraction bits modulo 2^12 (depths modulo 2^16), enough since every n is an integer; words 36.
//! All sums are of 64 bits and wrap.
//!
//! # Rounding
//! *Coefficients*: four roundings of 2^−10 to 2^−7, mantissas of 2^−23 times a derivative of at most 10200·λ, knots of
//! 2^−11: together below 1/20 LSB for knots up to 1530. *Slopes*: three units of 2^−52 at most, times 256·H: a second
//! difference is off by H·2^−36 (H in rows) times two for p p, three for p s, four for s s, so a pixel i steps and k lines
//! away by H·2^−36·(i² + 3ik + 2k²) ≤ H·2^−36·n(n + k), n = i + k: 0.02 LSB for 320×240, 0.62 at the limits of the wide
//! format. *Words*: cut after half a unit is added, as the host's, with the same bound. See [`error_bound`].
//!
//! Triangles without area, and those above or below the frame, are skipped and counted.

mod channels;
pub mod core_model;
pub mod divider;
pub mod engine;
pub mod instruction;
pub mod model;
pub mod multiplier;
pub mod program;
pub mod program_rom;
pub mod schedule;

pub use model::{EngineInputs, EngineModel, EngineOutputs};

/// Bits of a raw word in the engine's memory.
pub const RAW_BITS: u32 = 24;
/// Fraction bits of colour knots on the bus.
pub const KNOT_FRACTION_BITS: u32 = 10;
/// Fraction bits of depths on the bus.
pub const DEPTH_KNOT_FRACTION_BITS: u32 = 6;
/// Fraction bits of colour words before they are cut.
pub const WORD_FRACTION_BITS: u32 = 36;

/// The value of a constant (see [`instruction::Constant`]) where colours have `fraction_bits`.
#[must_use]
pub fn constant(index: u8, fraction_bits: u32, frame: [u64; 2]) -> i64 {
    let half = 1 << (WORD_FRACTION_BITS - fraction_bits - 1);
    match index {
        1 => 1,
        2 => 127,
        3 => 128,
        4 => 2048,
        5 => 1 << 24,
        6 => half,
        7 => 1 << 15,
        8 => (1 << (WORD_FRACTION_BITS - 1)) + half,
        9 => (1 << 31) - (1 << 47) + (1 << 15),
        10 => frame[0] as i64,
        11 => frame[1] as i64,
        _ => 0,
    }
}

/// Clocks from the edge that takes `start` to the one at which the core takes it from the engine, in an idle core.
#[must_use]
pub fn clocks() -> u32 {
    program::program().len() as u32 + 3
}

/// What the engine adds to the error of colours behind runs of up to `run` additions, LSB (see the module's remarks).
#[must_use]
pub fn error_bound(run: u32) -> f64 {
    let run = f64::from(run);
    let rows = (run / 2.0).min(1024.0);
    let height = 2.0 * rows;
    run * (run + rows) * height * SLOPE_ERROR + COEFFICIENT_ERROR
}

/// Error of a second difference per row of a triangle's height: 2^−52 · 256 · 256.
const SLOPE_ERROR: f64 = 1.0 / (1u64 << 36) as f64;
/// Error of coefficients, knots and reciprocals, for knots up to 1530, LSB.
const COEFFICIENT_ERROR: f64 = 0.05;
