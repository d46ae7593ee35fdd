//! A description as data: modules, their signals with formats, their statements, read through rust-hdl's public probe.
//!
//! Only the constructs that the project's descriptions use are accepted; everything else is refused with module and
//! statement. Nothing is guessed: a signal without a known format or a register without a doc comment is an error.

mod collect;
mod docs;
mod format;

pub use collect::{collect, Body, Child, Module, Register, Signal, SignalKind};
pub use format::Format;

/// Why a description cannot become Verilog.
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
