//! Walks a connected description and copies what the back end needs.

use super::docs::{ascii, field_docs};
use super::{Format, NetlistError};
use rust_hdl_core::ast::{Verilog, VerilogBlock, VerilogStatement};
use rust_hdl_core::prelude::{Atom, AtomKind, Block, Probe};

/// What a signal is in its module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SignalKind {
    /// Input port.
    Input,
    /// Output port.
    Output,
    /// Wire inside the module.
    Local,
    /// Named constant with its value as an unsigned code.
    Constant(u64),
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

/// A register (a D flip-flop of the description).
#[derive(Clone, Debug)]
pub struct Register {
    /// Name.
    pub name: String,
    /// Its format.
    pub format: Format,
    /// Doc comment.
    pub doc: String,
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

/// How a module is described.
#[derive(Clone, Debug)]
pub enum Body {
    /// Statements of `#[hdl_gen]`.
    Statements(VerilogBlock),
    /// Verilog text written by hand beside a native model; register outputs are declared `reg`.
    Custom {
        /// Text after the port list.
        text: String,
        /// Outputs that the text drives from an `always` block.
        reg_outputs: Vec<String>,
    },
}

/// A module: everything its Verilog says.
#[derive(Clone, Debug)]
pub struct Module {
    /// Name remark of the description, without format suffix.
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

struct Node {
    name: String,
    atoms: Vec<(String, AtomKind, String, u64)>,
    hdl: Verilog,
    children: Vec<Node>,
}

#[derive(Default)]
struct Walker {
    stack: Vec<Node>,
    root: Option<Node>,
    namespaces: usize,
    interfaces: Vec<String>,
}

/// The code of a constant. rust-hdl keeps literals private, but prints them as `width'hdigits` (or `'b`).
fn literal_code(text: &str) -> u64 {
    let (radix, digits) = match text.split_once('\'') {
        Some((_, d)) if d.starts_with('b') => (2, &d[1..]),
        Some((_, d)) => (16, &d[1..]),
        None => (10, text),
    };
    u64::from_str_radix(digits, radix).unwrap_or(0)
}

impl Probe for Walker {
    fn visit_start_scope(&mut self, name: &str, node: &dyn Block) {
        self.stack.push(Node {
            name: name.to_string(),
            atoms: vec![],
            hdl: node.hdl(),
            children: vec![],
        });
    }

    fn visit_start_namespace(&mut self, name: &str, _: &dyn Block) {
        self.namespaces += 1;
        self.interfaces.push(name.to_string());
    }

    fn visit_end_namespace(&mut self, _: &str, _: &dyn Block) {
        self.namespaces -= 1;
    }

    fn visit_atom(&mut self, name: &str, atom: &dyn Atom) {
        if let Some(node) = self.stack.last_mut() {
            let code = literal_code(&format!("{:x}", atom.verilog()));
            node.atoms
                .push((name.to_string(), atom.kind(), atom.descriptor().name, code));
        }
    }

    fn visit_end_scope(&mut self, _: &str, _: &dyn Block) {
        let node = self.stack.pop().expect("scopes nest");
        match self.stack.last_mut() {
            Some(parent) => parent.children.push(node),
            None => self.root = Some(node),
        }
    }
}

impl Node {
    /// A D flip-flop: exactly `d`, `q`, `clock`, and a body that copies d to q.
    fn is_register(&self) -> bool {
        let mut names: Vec<&str> = self.atoms.iter().map(|a| a.0.as_str()).collect();
        names.sort_unstable();
        names == ["clock", "d", "q"]
            && matches!(&self.hdl, Verilog::Custom(t) if t.contains("q <= d"))
    }
}

/// The key and text of a remark. rust-hdl stores the invocation as `comment!("key text`, with or without the tail.
fn remark(text: &str) -> Option<(String, String)> {
    let text = text.split_once('"').map_or(text, |(_, t)| t);
    let text = text.strip_suffix("\")").unwrap_or(text);
    let (key, value) = text.split_once(' ')?;
    let value = value.split_whitespace().collect::<Vec<_>>().join(" ");
    Some((key.to_string(), ascii(&value)))
}

/// What the remarks of a description say.
struct Head {
    name: String,
    remarks: Vec<(String, String)>,
    reg_outputs: Vec<String>,
}

fn head_of(path: &str, hdl: &Verilog) -> Result<Head, NetlistError> {
    let mut remarks: Vec<(String, String)> = match hdl {
        Verilog::Combinatorial(block) => block
            .iter()
            .filter_map(|s| {
                if let VerilogStatement::Comment(t) = s {
                    remark(t)
                } else {
                    None
                }
            })
            .collect(),
        Verilog::Custom(text) => text
            .lines()
            .filter_map(|l| l.strip_prefix("//! "))
            .filter_map(remark)
            .collect(),
        _ => {
            return Err(NetlistError::new(
                path,
                "neither statements nor Verilog text: black boxes are not supported",
            ))
        }
    };
    let reg_outputs = remarks
        .iter()
        .filter(|(k, _)| k == "reg")
        .map(|(_, v)| v.clone())
        .collect();
    remarks.retain(|(k, _)| k != "reg");
    let at = remarks.iter().position(|(k, _)| k == "name");
    let name = at
        .map(|i| remarks.remove(i).1)
        .ok_or_else(|| NetlistError::new(path, "has no name remark"))?;
    for key in ["title", "equation", "source", "latency"] {
        if !remarks.iter().any(|(k, _)| k == key) {
            return Err(NetlistError::new(&name, format!("has no {key} remark")));
        }
    }
    Ok(Head {
        name,
        remarks,
        reg_outputs,
    })
}

fn module(path: &str, node: Node) -> Result<Module, NetlistError> {
    let Head {
        name,
        remarks,
        reg_outputs,
    } = head_of(path, &node.hdl)?;
    let source = shadegate_hdl::sources::source(&name).unwrap_or_default();
    let docs = field_docs(source);
    let doc_of = |signal: &str| docs.get(signal).cloned().unwrap_or_default();
    let format_of = |signal: &str, descriptor: &str| {
        Format::from_descriptor(descriptor).ok_or_else(|| {
            NetlistError::new(
                &name,
                format!("signal {signal} has no number format: {descriptor}"),
            )
        })
    };
    let mut signals = vec![];
    for (signal, kind, descriptor, code) in &node.atoms {
        let kind = match kind {
            AtomKind::InputParameter => SignalKind::Input,
            AtomKind::OutputParameter | AtomKind::OutputPassthrough => SignalKind::Output,
            AtomKind::LocalSignal => SignalKind::Local,
            AtomKind::Constant => SignalKind::Constant(*code),
            _ => {
                return Err(NetlistError::new(
                    &name,
                    format!("signal {signal}: direction is not supported"),
                ))
            }
        };
        let doc = doc_of(signal);
        if doc.is_empty() {
            return Err(NetlistError::new(
                &name,
                format!("signal {signal} has no doc comment"),
            ));
        }
        signals.push(Signal {
            name: signal.clone(),
            kind,
            format: format_of(signal, descriptor)?,
            doc,
        });
    }
    let mut registers = vec![];
    let mut children = vec![];
    for child in node.children {
        let doc = doc_of(&child.name);
        if child.is_register() {
            if doc.is_empty() {
                return Err(NetlistError::new(
                    &name,
                    format!("register {} has no doc comment", child.name),
                ));
            }
            let descriptor = child
                .atoms
                .iter()
                .find(|a| a.0 == "q")
                .map(|a| a.2.clone())
                .unwrap_or_default();
            registers.push(Register {
                format: format_of(&child.name, &descriptor)?,
                name: child.name,
                doc,
            });
        } else {
            let path = format!("{path}.{}", child.name);
            children.push(Child {
                name: child.name.clone(),
                doc,
                module: module(&path, child)?,
            });
        }
    }
    let body = match node.hdl {
        Verilog::Combinatorial(block) => Body::Statements(block),
        Verilog::Custom(text) => {
            let text = text
                .lines()
                .filter(|l| !l.starts_with("//! "))
                .collect::<Vec<_>>()
                .join("\n");
            Body::Custom { text, reg_outputs }
        }
        _ => unreachable!("refused with the head"),
    };
    Ok(Module {
        name,
        remarks,
        signals,
        registers,
        children,
        body,
    })
}

/// Reads a connected description.
///
/// # Errors
/// Constructs that the back end does not take; see the module's head.
pub fn collect(design: &dyn Block) -> Result<Module, NetlistError> {
    let mut walker = Walker::default();
    design.accept("top", &mut walker);
    if let Some(name) = walker.interfaces.first() {
        return Err(NetlistError::new(
            "top",
            format!("interface {name}: interfaces are not supported"),
        ));
    }
    let root = walker
        .root
        .ok_or_else(|| NetlistError::new("top", "is empty"))?;
    module("top", root)
}
