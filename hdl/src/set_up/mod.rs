//! The set-up engine.

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
    program::program().len() as u32 + 2
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
