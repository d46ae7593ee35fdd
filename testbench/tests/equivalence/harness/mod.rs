//! One harness for many small descriptions: rust-hdl's simulation says what is right, every engine must say the same.
//!
//! All units stand side by side in one generated top module, so that each external simulator is built and run once.
//! Words go in and come out as lines of hexadecimal text; the comparison is made here, output by output.

pub mod bench;
pub mod case;
pub mod code;
pub mod compare;
pub mod compiled;
pub mod icarus;
pub mod native;
pub mod process;
pub mod stimulus;
pub mod verilator;
