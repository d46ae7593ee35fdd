//! From a description and a scene's set-up to files: Verilog, constraints, vectors, test benches, a manifest.

pub mod netlist;
pub mod setup;
pub mod stimulus;
pub mod verilog;
pub mod vectors;
