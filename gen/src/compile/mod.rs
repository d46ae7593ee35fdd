//! The compiled simulation: a netlist as native code in this process, one call per clock.
//!
//! The path of a design: [`elaborate`](crate::netlist::elaborate) makes it flat; `lower` turns wires into a graph of
//! values, `item` what the edge does into stores under branches; `merge` puts together what hangs on one condition;
//! `plan` says where each value is computed, `schedule` in which order registers are stored in place, `emit` writes
//! the code and `native` owns it. Two-valued, one clock domain, exact to the clock.
//!
//! The compiled clock evaluates what registers and memories take, stores it, then evaluates the outputs: nothing else.
//! Wires in between have no place in the state until someone peeks at one or records a waveform; then a function that
//! keeps every wire is compiled.

mod core;
mod emit;
mod fold;
mod graph;
mod handle;
mod item;
mod layout;
mod lower;
mod merge;
mod names;
mod native;
mod plan;
mod schedule;
mod simulator;

pub use core::CompiledCore;
pub use handle::{Input, Memory, Output, Signal};
pub use names::UnknownSignal;
pub use simulator::Simulator;
