//! Small helpers that write modules down.

use shadegate_gen::netlist::{
    Bits, Body, Child, Expression, Format, Memory, Module, Name, Node, Register, Signal,
    SignalKind, Statement, Target,
};

/// A module without anything.
pub fn module(name: &str) -> Module {
    Module {
        name: name.into(),
        remarks: vec![],
        signals: vec![],
        registers: vec![],
        children: vec![],
        body: Body::Statements(vec![]),
    }
}

/// A module with a clock input called `clock`.
pub fn clocked(name: &str) -> Module {
    let mut m = module(name);
    signal(&mut m, "clock", SignalKind::Input, Format::Clock);
    m
}

pub fn signal(m: &mut Module, name: &str, kind: SignalKind, format: Format) {
    m.signals.push(Signal {
        name: name.into(),
        kind,
        format,
        doc: String::new(),
    });
}

pub fn register(m: &mut Module, name: &str, format: Format, initial: u128) {
    m.registers.push(Register {
        name: name.into(),
        format,
        doc: String::new(),
        initial,
        clock: "clock".into(),
    });
}

pub fn child(m: &mut Module, name: &str, module: Module) {
    m.children.push(Child {
        name: name.into(),
        doc: String::new(),
        module,
    });
}

pub fn push(m: &mut Module, s: Statement) {
    if let Body::Statements(list) = &mut m.body {
        list.push(s);
    }
}

pub fn wire(name: &str) -> Name {
    Name::Signal(name.into())
}

pub fn port(child: &str, port: &str) -> Name {
    Name::Port {
        child: child.into(),
        port: port.into(),
    }
}

pub fn held(name: &str) -> Name {
    Name::Register(name.into())
}

pub fn read(name: Name, format: Format) -> Expression {
    Expression::new(format, Node::Read(name))
}

pub fn assign(target: Name, value: Expression) -> Statement {
    part(target, None, value)
}

pub fn part(target: Name, bits: Option<Bits>, value: Expression) -> Statement {
    let target = match target {
        Name::Register(name) => Target::Register(name),
        name => Target::Wire(name),
    };
    Statement::Assign {
        target,
        bits,
        value,
    }
}

/// Connects the clock of an instance.
pub fn connect_clock(m: &mut Module, child: &str) {
    push(
        m,
        assign(port(child, "clock"), read(wire("clock"), Format::Clock)),
    );
}

/// A module around a memory: inputs `address`, and as the memory says `enable`, `clock`, `write_address`,
/// `write_data`, `write_enable`; output `data`.
pub fn memory(name: &str, address: Format, word: Format, memory: Memory) -> Module {
    let mut m = module(name);
    let input = SignalKind::Input;
    signal(&mut m, "address", input, address);
    signal(&mut m, "data", SignalKind::Output, word);
    if memory.read.enable.is_some() {
        signal(&mut m, "enable", input, Format::Bit);
    }
    if memory.read.clock.is_some() || memory.write.is_some() {
        signal(&mut m, "clock", input, Format::Clock);
    }
    if memory.write.is_some() {
        signal(&mut m, "write_address", input, address);
        signal(&mut m, "write_data", input, word);
        signal(&mut m, "write_enable", input, Format::Bit);
    }
    m.body = Body::Memory(Box::new(memory));
    m
}
