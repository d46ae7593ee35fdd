//! What the span cores share behind their interpolants. A lit surface has two *factors* per pixel, D = max(0, N·L) and
//! S = max(0, N·H)ⁿ or what a method puts in their place, 0 to 65536 = 1.0; its colour is ambient + diffuse·D +
//! highlight·S per channel. The methods differ in how factors are found, three clocks behind the pixel registers:
//!
//! | module | factor |
//! |---|---|
//! | [`swing`] | a cosine by the difference recurrence of slerp |
//! | [`chebyshev`] | the same by Chebyshev's recurrence |
//! | [`clamp`] | a value cut to 0..=1, three stages long |
//! | [`power`] | xⁿ by a table of chords, three stages long |
//! | [`angle`] | a table word at an angle that grows evenly, times an amplitude, three stages long |
//!
//! [`stream`] takes the factors in the third stage, adds the colours in two more and hands the pixels over.

pub mod angle;
pub mod channel;
pub mod chebyshev;
pub mod chord;
pub mod clamp;
pub mod loader;
pub mod place;
pub mod power;
pub mod stream;
pub mod stream_model;
pub mod swing;
pub mod table_memory;

/// 1.0 as a factor.
pub const UNIT: u64 = 1 << 16;
/// Stages from the pixel registers to the factors.
pub const FACTOR_STAGES: usize = 3;
/// Stages from the pixel registers to the colour.
pub const COLOUR_STAGES: usize = FACTOR_STAGES + 2;
/// Materials that a frame may have.
pub const MATERIALS: usize = 4;
