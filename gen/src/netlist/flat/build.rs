//! Walks the hierarchy: signals, scopes, processes, memories.

use super::report::{error, join};
use super::{assigned, check, clock, memory, order};
use super::{Driver, Flat, FlatSignal, Process, SignalId};
use crate::netlist::{
    Body, Expression, Format, Module, Name, NetlistError, Node, SignalKind, Statement, Target,
};
use std::collections::{HashMap, HashSet};

/// Deepest hierarchy that is taken.
const MAX_DEPTH: usize = 64;

/// One design under construction.
pub(super) struct Builder<'a> {
    pub(super) flat: Flat<'a>,
    /// Clock of every register and memory port: what it belongs to and the clock signal, in order of appearance.
    pub(super) clocked: Vec<(String, SignalId)>,
    names: HashSet<String>,
}

/// Flattens a hierarchy and checks it.
///
/// # Errors
/// Unknown names, widths that disagree, wires without a driver or not assigned on every path, more than one clock, a
/// combinational loop.
pub fn elaborate(top: &Module) -> Result<Flat<'_>, NetlistError> {
    let mut b = flatten(top)?;
    clock::resolve(&mut b)?;
    order::levelise(&mut b.flat)?;
    Ok(b.flat)
}

/// Checks a hierarchy as [`elaborate`] does, but takes any number of clocks.
///
/// # Errors
/// As those of [`elaborate`], but for clocks.
pub fn check_hierarchy(top: &Module) -> Result<(), NetlistError> {
    order::levelise(&mut flatten(top)?.flat)
}

fn flatten(top: &Module) -> Result<Builder<'_>, NetlistError> {
    let mut b = Builder {
        flat: Flat {
            name: top.name.clone(),
            signals: vec![],
            memories: vec![],
            processes: vec![],
            order: vec![],
            clock: None,
        },
        clocked: vec![],
        names: HashSet::new(),
    };
    let mut ports = HashMap::new();
    for s in top.signals.iter().filter(|s| s.is_port()) {
        let driver = match (s.kind, s.format) {
            (SignalKind::Input, Format::Clock) => Driver::Clock,
            (SignalKind::Input, _) => Driver::Input,
            _ => Driver::Process(usize::MAX),
        };
        let id = b.signal(top, "", &s.name, s.format, driver)?;
        b.flat.signals[id.index()].output = s.kind == SignalKind::Output;
        ports.insert(s.name.clone(), id);
    }
    b.module(top, "", ports, 0)?;
    Ok(b)
}

impl<'a> Builder<'a> {
    fn signal(
        &mut self,
        m: &Module,
        path: &str,
        name: &str,
        format: Format,
        driver: Driver,
    ) -> Result<SignalId, NetlistError> {
        let full = join(path, name);
        if !(1..=crate::netlist::MAX_WIDTH).contains(&format.width()) {
            let what = format!("{name} has {} bits; expected 1 to 128", format.width());
            return Err(error(&m.name, path, what));
        }
        if name.is_empty() || !self.names.insert(full.clone()) {
            return Err(error(&m.name, path, format!("{name} names two things")));
        }
        let id = SignalId(self.flat.signals.len() as u32);
        self.flat.signals.push(FlatSignal {
            name: full,
            format,
            driver,
            output: false,
        });
        Ok(id)
    }

    fn module(
        &mut self,
        m: &'a Module,
        path: &str,
        ports: HashMap<String, SignalId>,
        depth: usize,
    ) -> Result<(), NetlistError> {
        let fail = |what: String| Err(error(&m.name, path, what));
        if depth > MAX_DEPTH {
            return fail(format!("instances nest deeper than {MAX_DEPTH}"));
        }
        let mut scope: HashMap<Name, SignalId> = HashMap::new();
        for (name, id) in &ports {
            scope.insert(Name::Signal(name.clone()), *id);
        }
        for s in m.signals.iter().filter(|s| !s.is_port()) {
            let driver = match s.kind {
                SignalKind::Constant(code) => Driver::Constant(code),
                _ => Driver::Process(usize::MAX),
            };
            if let Driver::Constant(code) = driver {
                check::code(m, path, &s.name, code, s.format.width())?;
            }
            let id = self.signal(m, path, &s.name, s.format, driver)?;
            scope.insert(Name::Signal(s.name.clone()), id);
        }
        for r in &m.registers {
            check::code(m, path, &r.name, r.initial, r.format.width())?;
            let driver = Driver::Register(r.initial);
            let id = self.signal(m, path, &r.name, r.format, driver)?;
            scope.insert(Name::Register(r.name.clone()), id);
            let clock = match m.signal(&r.clock) {
                Some(s) if s.kind == SignalKind::Input && s.format == Format::Clock => &s.name,
                _ => {
                    let what = format!("register {}: {} is not a clock input", r.name, r.clock);
                    return fail(what);
                }
            };
            let name = self.flat.signals[id.index()].name.clone();
            self.clocked.push((name, ports[clock]));
        }
        let mut children = vec![];
        for c in &m.children {
            let child_path = join(path, &c.name);
            let mut child_ports = HashMap::new();
            for s in c.module.signals.iter().filter(|s| s.is_port()) {
                let driver = Driver::Process(usize::MAX);
                let id = self.signal(&c.module, &child_path, &s.name, s.format, driver)?;
                child_ports.insert(s.name.clone(), id);
                let (child, port) = (c.name.clone(), s.name.clone());
                scope.insert(Name::Port { child, port }, id);
            }
            children.push((&c.module, child_path, child_ports));
        }
        match &m.body {
            Body::Statements(statements) => self.statements(m, path, statements, scope)?,
            Body::Memory(memory) => {
                if !m.children.is_empty() || !m.registers.is_empty() {
                    return fail("is a memory and has registers or instances".into());
                }
                memory::add(self, m, path, memory, &ports)?;
            }
        }
        for (module, child_path, child_ports) in children {
            self.module(module, &child_path, child_ports, depth + 1)?;
        }
        Ok(())
    }

    fn statements(
        &mut self,
        m: &'a Module,
        path: &str,
        statements: &'a [Statement],
        scope: HashMap<Name, SignalId>,
    ) -> Result<(), NetlistError> {
        check::statements(m, path, statements)?;
        let driven = assigned::driven(m, path, statements)?;
        let index = self.flat.processes.len();
        for target in &driven {
            if let (Target::Wire(name), Some(id)) = (target, scope_of(&scope, target)) {
                let driver = match alias(statements, target) {
                    Some(of) if scope[of] != id => Driver::Alias(scope[of]),
                    _ => Driver::Process(index),
                };
                let s = &mut self.flat.signals[id.index()];
                if s.format == Format::Clock && !matches!(driver, Driver::Alias(_)) {
                    let name = super::report::spell(name);
                    let what = format!("clock {name} is not a plain name of another clock");
                    return Err(error(&m.name, path, what));
                }
                s.driver = driver;
            }
        }
        self.flat.processes.push(Process {
            path: path.to_string(),
            statements,
            scope,
        });
        Ok(())
    }
}

fn scope_of(scope: &HashMap<Name, SignalId>, target: &Target) -> Option<SignalId> {
    match target {
        Target::Wire(name) => scope.get(name).copied(),
        Target::Register(_) => None,
    }
}

/// The name that a target is a copy of: its only assignment, at the top level, of the whole word.
fn alias<'s>(statements: &'s [Statement], target: &Target) -> Option<&'s Name> {
    let mut found = None;
    for s in statements {
        match s {
            Statement::Assign {
                target: t,
                bits,
                value,
            } if t == target => {
                if found.is_some() || bits.is_some() {
                    return None;
                }
                found = Some(plain(value)?);
            }
            Statement::Assign { .. } => {}
            _ if s.drives(target) => return None,
            _ => {}
        }
    }
    found
}

fn plain(value: &Expression) -> Option<&Name> {
    match &value.node {
        Node::Read(name) => Some(name),
        Node::Reformat(inner) => plain(inner),
        _ => None,
    }
}
