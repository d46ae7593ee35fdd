//! Modules: ports, wires, constants, registers, instances and behaviour.

use super::{Format, Memory, Name, Statement};

/// What a signal is in its module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SignalKind {
    /// Input port.
    Input,
    /// Output port.
    Output,
    /// Wire inside the module.
    Local,
    /// Named constant with its code.
    Constant(u128),
}

/// A port, wire or constant.
#[derive(Clone, Debug)]
pub struct Signal {
    /// Name.
    pub name: String,
    /// What it is.
    pub kind: SignalKind,
    /// Its format.
    pub format: Format,
    /// Doc comment.
    pub doc: String,
}

impl Signal {
    /// Whether it is a port of its module.
    #[must_use]
    pub fn is_port(&self) -> bool {
        matches!(self.kind, SignalKind::Input | SignalKind::Output)
    }
}

/// A register (a D flip-flop of the description).
#[derive(Clone, Debug)]
pub struct Register {
    /// Name.
    pub name: String,
    /// Its format.
    pub format: Format,
    /// Doc comment.
    pub doc: String,
    /// Code at power-up.
    pub initial: u128,
    /// The clock input of the module whose rising edge loads it.
    pub clock: String,
}

/// An instance.
#[derive(Clone, Debug)]
pub struct Child {
    /// Instance name.
    pub name: String,
    /// Doc comment of the field, if any.
    pub doc: String,
    /// What is instantiated.
    pub module: Module,
}

/// What a module does.
#[derive(Clone, Debug)]
pub enum Body {
    /// Statements.
    Statements(Vec<Statement>),
    /// A memory, whose ports are those of the module.
    Memory(Box<Memory>),
}

/// A module: everything that its Verilog says and its simulation does.
#[derive(Clone, Debug)]
pub struct Module {
    /// Name of the description, without format suffix.
    pub name: String,
    /// Head remarks: title, equation, source, latency.
    pub remarks: Vec<(String, String)>,
    /// Ports, wires, constants in order of declaration.
    pub signals: Vec<Signal>,
    /// Registers in order of declaration.
    pub registers: Vec<Register>,
    /// Instances in order of declaration.
    pub children: Vec<Child>,
    /// Behaviour.
    pub body: Body,
}

impl Module {
    /// The signal of this name.
    #[must_use]
    pub fn signal(&self, name: &str) -> Option<&Signal> {
        self.signals.iter().find(|s| s.name == name)
    }

    /// The register of this name.
    #[must_use]
    pub fn register(&self, name: &str) -> Option<&Register> {
        self.registers.iter().find(|r| r.name == name)
    }

    /// The instance of this name.
    #[must_use]
    pub fn child(&self, name: &str) -> Option<&Child> {
        self.children.iter().find(|c| c.name == name)
    }

    /// The format of what a name stands for.
    #[must_use]
    pub fn format_of(&self, name: &Name) -> Option<Format> {
        match name {
            Name::Signal(s) => self.signal(s).map(|s| s.format),
            Name::Register(r) => self.register(r).map(|r| r.format),
            Name::Port { child, port } => {
                let port = self.child(child)?.module.signal(port)?;
                port.is_port().then_some(port.format)
            }
        }
    }
}
