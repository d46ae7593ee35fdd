//! Verilog-2001 from a netlist: one module per file, meant to be read.
//!
//! rust-hdl's own printer writes no parentheses and no widths, so its text can mean something else than the simulation
//! did. This back end prints the typed netlist: operands of an operator have one width and one sign, every change of
//! format is spelt out. [`check`] then reads the printed text again, without the netlist, and refuses every shape whose
//! meaning depends on context.

mod body;
pub mod check;
mod concatenation;
mod expression;
mod memory;
mod module;
mod part;
mod reserved;
mod shared;
mod wiring;

pub use module::{emit, hash, module_name, VerilogFile};
