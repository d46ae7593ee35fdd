//! Verilog-2001 from a netlist: one module per file, meant to be read.
//!
//! rust-hdl's own printer writes no parentheses and no widths, so its text can mean something else than the simulation
//! did. This back end types every expression instead: operands of an operator have the same format, a literal takes
//! its width from the other side, and a change of format stands alone on the right of an assignment. [`check`] then
//! reads the printed text again, without the netlist, and refuses every shape whose meaning depends on context.

mod body;
pub mod check;
mod expression;
mod module;

pub use module::{emit, VerilogFile};
