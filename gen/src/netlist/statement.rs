//! Typed statements: what a module does, in the order and shape of its description.
//!
//! A read is always of the settled value of a clock, never of an earlier statement's; a later assignment to the same
//! bits wins. Wires are assigned on every path (a latch is refused when the netlist is made); a register that no path
//! assigns keeps its value at the clock edge.

use super::{Expression, Name};

/// What an assignment drives.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Target {
    /// A wire or output of the module, or an input of an instance: [`Name::Signal`] or [`Name::Port`].
    Wire(Name),
    /// The next value of a register.
    Register(String),
}

/// Some bits of a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bits {
    /// Position of the lowest.
    pub at: usize,
    /// How many.
    pub width: usize,
}

/// A statement.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Statement {
    /// Drives a target, or some bits of it, with a value of exactly that width.
    Assign {
        /// What is driven.
        target: Target,
        /// Which bits; all of them when `None`.
        bits: Option<Bits>,
        /// With what.
        value: Expression,
    },
    /// A choice by one bit.
    If {
        /// The bit.
        condition: Expression,
        /// When it is set.
        then: Vec<Statement>,
        /// Otherwise.
        otherwise: Vec<Statement>,
    },
    /// A choice by a word.
    Case {
        /// The word.
        subject: Expression,
        /// Choices; their labels differ.
        arms: Vec<Arm>,
        /// What no label names.
        otherwise: Vec<Statement>,
    },
}

/// One choice of a [`Statement::Case`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Arm {
    /// The code that selects it.
    pub label: u128,
    /// What the description calls that code; empty for a number.
    pub name: String,
    /// What happens.
    pub body: Vec<Statement>,
}
