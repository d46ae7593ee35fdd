//! The set-up engine.

mod channels;
pub mod divider;
pub mod instruction;
pub mod model;
pub mod multiplier;
pub mod program;
pub mod schedule;

pub use model::{EngineInputs, EngineModel, EngineOutputs};

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
