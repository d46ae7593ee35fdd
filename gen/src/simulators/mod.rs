//! Test benches that replay a vector file: one in Verilog for any simulator, one in C++ for Verilator and for CXXRTL.
//!
//! All print the same lines, which is what `shadegate_testbench` reads:
//! `MISMATCH clock=… signal=… expected=… got=… x=… y=…` for the first difference,
//! then `PASS clocks=… pixels=…` or `FAIL clocks=… mismatches=…`. Those in C++ add `loop_ns=…`: nanoseconds of the
//! simulation loop alone, without reading vectors and writing pixels.

mod cxxrtl;
mod replay;
mod verilator;
mod verilog;

pub use cxxrtl::cxxrtl_main;
pub use verilator::main_cpp;
pub use verilog::test_bench;
