//! Engines, co-simulation, comparison, synthesis: is every pixel the expected one, how far is it from the truth, and how many
//! clocks did it take.

mod cache;
pub mod compare;
pub mod cosim;
pub mod engine;
mod process;
pub mod synthesis;
pub mod wave;
