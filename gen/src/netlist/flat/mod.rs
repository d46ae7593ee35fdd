//! Elaboration: a hierarchy of modules as one design of signals with dotted names (`shell.walk.column`).
//!
//! The flat design borrows the modules: every instance with statements becomes a [`Process`], its statements as they
//! are and a scope that says which signal each of its names is. A port connected to a plain name is not a second
//! signal but another name of the first.
//!
//! Checked on the way, so that nobody behind has to: names exist and widths agree ([`check`]); every wire is assigned
//! on every path and driven by one module ([`assigned`]); all edges are of one clock ([`clock`]); no wire depends on
//! itself ([`order`]).

mod assigned;
mod build;
mod check;
mod clock;
mod memory;
mod order;
mod report;

pub use build::{check_hierarchy, elaborate};

use super::{Format, Memory, Name, Statement, Target};
use std::collections::HashMap;

/// A signal of the flat design.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SignalId(pub(crate) u32);

/// A memory of the flat design.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MemoryId(pub(crate) u32);

impl SignalId {
    /// Position among the signals.
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

impl MemoryId {
    /// Position among the memories.
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// What gives a signal its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Driver {
    /// The world outside: an input of the top module.
    Input,
    /// The clock of the design, or a name of it.
    Clock,
    /// A constant.
    Constant(u128),
    /// A register with this code at power-up.
    Register(u128),
    /// The statements of this process.
    Process(usize),
    /// Another signal of the same width: this is only a second name of it.
    Alias(SignalId),
    /// The read port of a memory.
    Memory(MemoryId),
}

/// A named signal: port, wire, constant or register.
#[derive(Clone, Debug)]
pub struct FlatSignal {
    /// Dotted name below the top module.
    pub name: String,
    /// Format.
    pub format: Format,
    /// What drives it.
    pub driver: Driver,
    /// It is an output of the top module.
    pub output: bool,
}

/// A memory with its ports resolved.
#[derive(Clone, Debug)]
pub struct FlatMemory<'a> {
    /// Dotted name of its instance; the top module's own is empty.
    pub name: String,
    /// Words, initial codes, rules.
    pub memory: &'a Memory,
    /// Address read.
    pub read_address: SignalId,
    /// The word read.
    pub read_data: SignalId,
    /// Whether the read happens; `None`: always.
    pub read_enable: Option<SignalId>,
    /// Address, word and enable of the write port.
    pub write: Option<[SignalId; 3]>,
}

/// The statements of one instance.
#[derive(Clone, Debug)]
pub struct Process<'a> {
    /// Dotted name of the instance; the top module's own is empty.
    pub path: String,
    /// Its statements.
    pub statements: &'a [Statement],
    /// What its names are.
    pub scope: HashMap<Name, SignalId>,
}

impl Process<'_> {
    /// The signal that a target is. Elaboration has checked that there is one.
    #[must_use]
    pub fn target(&self, target: &Target) -> Option<SignalId> {
        match target {
            Target::Wire(name) => self.scope.get(name).copied(),
            Target::Register(name) => self.scope.get(&Name::Register(name.clone())).copied(),
        }
    }
}

/// A design without hierarchy.
#[derive(Clone, Debug)]
pub struct Flat<'a> {
    /// Name of the top module.
    pub name: String,
    /// Every signal.
    pub signals: Vec<FlatSignal>,
    /// Every memory.
    pub memories: Vec<FlatMemory<'a>>,
    /// Every instance that has statements.
    pub processes: Vec<Process<'a>>,
    /// Driven wires and unclocked read data, each behind all that it depends on.
    pub order: Vec<SignalId>,
    /// The clock input of the top module that all registers and memories share.
    pub clock: Option<SignalId>,
}

impl Flat<'_> {
    /// The signal behind all aliases of this one.
    #[must_use]
    pub fn resolve(&self, mut id: SignalId) -> SignalId {
        while let Driver::Alias(of) = self.signals[id.index()].driver {
            id = of;
        }
        id
    }

    /// What drives the signal behind all aliases of this one.
    #[must_use]
    pub fn driver(&self, id: SignalId) -> Driver {
        self.signals[self.resolve(id).index()].driver
    }

    /// Bits of a signal.
    #[must_use]
    pub fn width(&self, id: SignalId) -> usize {
        self.signals[id.index()].format.width()
    }
}
