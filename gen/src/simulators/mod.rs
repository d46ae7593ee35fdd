//! Test benches that replay a vector file: one in Verilog for any simulator, one in C++ for Verilator.
//!
//! Both print the same lines, which is what `shadegate_testbench` reads:
//! `MISMATCH clock=… signal=… expected=… got=… x=… y=…` for the first difference,
//! then `PASS clocks=… pixels=…` or `FAIL clocks=… mismatches=…`.

mod cpp;
mod verilog;

pub use cpp::main_cpp;
pub use verilog::test_bench;
