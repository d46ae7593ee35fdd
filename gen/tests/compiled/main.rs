//! The compiled simulation against an independent interpreter of the netlist, and against rust-hdl on whole cores.

mod build;
mod cores;
mod edges;
mod interpreter;
mod maker;
mod operations;
mod random;
mod refusals;
