//! A description as data: modules, their signals with formats, their statements with every expression typed.
//!
//! [`collect`] reads a connected rust-hdl description through its public probe. Whatever the Verilog back end, the
//! compiled simulation and the manifest say about a design, they say of this one netlist. Nothing is guessed: a
//! construct that cannot be typed is refused with module, statement and reason.

mod docs;
mod drivers;
mod expression;
mod flat;
mod fold;
mod format;
mod groups;
mod lower;
mod memory;
mod module;
mod order;
mod read;
mod reset;
mod statement;

pub use docs::undocumented;
pub use drivers::always_assigned;
pub use expression::{Comparison, Expression, Name, Node, Operator, Reduction};
pub use flat::{
    check_hierarchy, elaborate, Driver, Flat, FlatMemory, FlatSignal, MemoryId, Process, SignalId,
};
pub use fold::evaluate;
pub(crate) use format::ones;
pub use format::{Format, MAX_WIDTH};
pub use groups::groups;
pub use lower::collect;
pub use memory::{Memory, ReadPort, WritePort};
pub use module::{Body, Child, Module, Register, Signal, SignalKind};
pub use reset::{with_reset, RESET};
pub use statement::{Arm, Bits, Statement, Target};

/// Why a description cannot become a netlist, Verilog or a simulation.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("module {module}: {what}")]
pub struct NetlistError {
    /// Module (the description's name remark, or its instance path).
    pub module: String,
    /// What is wrong, and with which statement or signal.
    pub what: String,
}

impl NetlistError {
    /// An error in `module`.
    pub fn new(module: &str, what: impl Into<String>) -> Self {
        Self {
            module: module.to_string(),
            what: what.into(),
        }
    }
}
