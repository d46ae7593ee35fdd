//! From a description and a scene's set-up to files: Verilog, constraints, vectors, test benches, a manifest.

pub mod compact;
pub mod compile;
pub mod netlist;
pub mod package;
pub mod scene;
pub mod setup;
pub mod simulators;
pub mod spans;
pub mod spent;
pub mod stimulus;
pub mod vectors;
pub mod verilog;
pub mod wrapper;
pub mod write;
