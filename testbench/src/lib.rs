//! Engines, co-simulation, comparison, synthesis, benchmarks: is every pixel the expected one, how far is it from the
//! truth, how many clocks did it take, and what does a method cost.

pub mod bench;
mod cache;
pub mod compare;
pub mod cosim;
pub mod engine;
mod process;
pub mod synthesis;
pub mod wave;
