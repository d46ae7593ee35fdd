//! rust-hdl's simulation, the compiled netlist, and the emitted Verilog in Icarus and Verilator give the same bits: on a
//! corpus of small descriptions that covers every construct, and on random expression trees.

// The corpus writes what the lints would write in another way: that is what it is for.
#![allow(
    clippy::bool_comparison,
    clippy::eq_op,
    clippy::match_overlapping_arm,
    clippy::nonminimal_bool,
    clippy::precedence,
    clippy::vec_init_then_push
)]

mod compact;
mod corpus;
mod harness;
mod printer;
mod trees;
