//! Declarations and instances: what a module's text says between its ports and its behaviour.

use super::body::PrintedBody;
use super::expression::literal;
use super::part::{name_unused, Part};
use super::reserved::is_reserved;
use crate::netlist::{Child, Module, Name, NetlistError, Node, Signal, SignalKind};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// A declaration with its comment in one column.
pub fn line(out: &mut String, declaration: &str, comment: &str) {
    if comment.is_empty() {
        let _ = writeln!(out, "{declaration}");
    } else {
        let _ = writeln!(out, "{declaration:<48} // {comment}");
    }
}

/// A note on a port of an instance.
fn port_note(c: &Child, s: &Signal) -> String {
    if s.doc.is_empty() {
        String::new()
    } else {
        format!("{}: {}", c.name, s.doc)
    }
}

/// Declarations and instances.
pub struct Pieces {
    /// Declarations.
    pub declarations: String,
    /// Instances.
    pub instances: String,
}

/// What connects the parts of a module.
pub struct Wiring<'a> {
    pub(super) m: &'a Module,
    pub(super) body: &'a PrintedBody,
    pub(super) by_block: BTreeSet<&'a String>,
    /// Bits that something reads, by name.
    pub(super) reads: &'a BTreeMap<String, u128>,
    pub(super) taken: &'a BTreeSet<String>,
}

impl Wiring<'_> {
    /// Wires that carry instances' outputs. A lint tool takes a name that says so as the author's word that nobody
    /// reads it.
    fn output(&self, c: &Child, s: &Signal) -> String {
        let wire = format!("{}_{}", c.name, s.name);
        if self.reads.contains_key(&wire) {
            wire
        } else {
            format!("unused_{wire}")
        }
    }

    /// What an instance's input is connected to, and the wire that must be declared for it.
    fn input(&self, c: &Child, s: &Signal) -> (String, Option<String>) {
        let name = Name::Port {
            child: c.name.clone(),
            port: s.name.clone(),
        };
        let wire = name.verilog();
        if self.by_block.contains(&wire) {
            return (
                wire.clone(),
                Some(format!("  reg {}{wire};", s.format.range())),
            );
        }
        match self.body.assigns.iter().find(|(n, _, _)| *n == name) {
            // A plain name needs no wire of its own.
            Some((_, value, text)) if matches!(value.node, Node::Read(_)) => (text.clone(), None),
            Some((_, _, text)) => {
                let declaration = format!("  wire {}{wire} = {text};", s.format.range());
                (wire, Some(declaration))
            }
            None => (wire, None),
        }
    }

    fn own(&self, d: &mut String) {
        for s in &self.m.signals {
            if let SignalKind::Constant(code) = s.kind {
                let value = literal(code, s.format);
                line(
                    d,
                    &format!("  localparam {}{} = {value};", s.format.range(), s.name),
                    &s.doc,
                );
            }
        }
        for r in &self.m.registers {
            let initial = literal(r.initial, r.format);
            line(
                d,
                &format!("  reg {}{} = {initial};", r.format.range(), r.name),
                &r.doc,
            );
        }
        for s in self
            .m
            .signals
            .iter()
            .filter(|s| s.kind == SignalKind::Local)
        {
            let kind = if self.by_block.contains(&s.name) {
                "reg"
            } else {
                "wire"
            };
            line(
                d,
                &format!("  {kind} {}{};", s.format.range(), s.name),
                &s.doc,
            );
        }
    }

    /// Bits that nothing reads of words of which something is read.
    fn left_over(&self, d: &mut String) {
        let own = self
            .m
            .signals
            .iter()
            .filter(|s| matches!(s.kind, SignalKind::Input | SignalKind::Local));
        let own = own.map(|s| (s.name.clone(), s.format));
        let registers = self.m.registers.iter().map(|r| (r.name.clone(), r.format));
        let outputs = self.m.children.iter().flat_map(|c| {
            let ports = c.module.signals.iter();
            let ports = ports.filter(|s| s.kind == SignalKind::Output);
            ports.map(|s| (format!("{}_{}", c.name, s.name), s.format))
        });
        for (name, format) in own.chain(registers).chain(outputs) {
            if let Some(used) = self.reads.get(&name) {
                name_unused(d, &name, format.width(), *used, self.taken);
            }
        }
    }

    /// Everything between ports and behaviour.
    pub fn pieces(&self, parts: &[Part], names: &BTreeMap<String, String>) -> Pieces {
        let mut d = String::new();
        self.own(&mut d);
        for c in &self.m.children {
            for s in c
                .module
                .signals
                .iter()
                .filter(|s| s.kind == SignalKind::Output)
            {
                let wire = self.output(c, s);
                line(
                    &mut d,
                    &format!("  wire {}{wire};", s.format.range()),
                    &port_note(c, s),
                );
            }
        }
        for p in parts {
            let note = format!("Part of {}.", p.stem);
            line(
                &mut d,
                &format!("  wire {}{} = {};", p.format.range(), p.name, p.value),
                &note,
            );
            name_unused(&mut d, &p.name, p.format.width(), p.used, self.taken);
        }
        self.left_over(&mut d);
        let mut i = String::new();
        for c in &self.m.children {
            let mut connections = vec![];
            for s in c.module.signals.iter().filter(|s| s.is_port()) {
                let connected = if s.kind == SignalKind::Output {
                    self.output(c, s)
                } else {
                    let (wire, declaration) = self.input(c, s);
                    if let Some(declaration) = declaration {
                        line(&mut d, &declaration, &port_note(c, s));
                    }
                    wire
                };
                connections.push(format!("    .{}({connected})", s.name));
            }
            let kind = &names[&c.name];
            if !c.doc.is_empty() {
                let _ = writeln!(i, "  // {}", c.doc);
            }
            let _ = writeln!(
                i,
                "  {kind} {} (\n{}\n  );\n",
                c.name,
                connections.join(",\n")
            );
        }
        Pieces {
            declarations: d,
            instances: i,
        }
    }
}

/// Every name that the module's text declares, checked to be a legal and unique one.
pub fn declared(m: &Module) -> Result<BTreeSet<String>, NetlistError> {
    let mut seen = BTreeSet::new();
    let own = m
        .signals
        .iter()
        .map(|s| s.name.clone())
        .chain(m.registers.iter().map(|r| r.name.clone()));
    let wires = m.children.iter().flat_map(|c| {
        let ports = c.module.signals.iter().filter(|s| s.is_port());
        ports
            .map(|s| format!("{}_{}", c.name, s.name))
            .chain([c.name.clone()])
            .collect::<Vec<_>>()
    });
    for name in own.chain(wires) {
        let legal = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
            && !name.starts_with(|c: char| c.is_ascii_digit());
        if is_reserved(&name) || !legal {
            return Err(NetlistError::new(
                &m.name,
                format!(
                    "{name} is {}",
                    if legal {
                        "a Verilog word"
                    } else {
                        "not a Verilog name"
                    }
                ),
            ));
        }
        if !seen.insert(name.clone()) {
            return Err(NetlistError::new(
                &m.name,
                format!("{name} names two things"),
            ));
        }
    }
    Ok(seen)
}
