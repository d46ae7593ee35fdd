//! From rust-hdl's modules and untyped trees to the typed netlist.
//!
//! What the trees do not hold, and what is done about it:
//!
//! * *Types of literals, casts and `.into()`* are restored from the signals around them; see [`expression`].
//! * *Run-time positions* (`get_bit(i.val().index() + 1)`) lose Rust's machine width: only signals and constants are taken.
//! * *Positions beyond a fixed-point word* show its sign, beyond other words zeros; a run-time position that can reach
//!   beyond a fixed-point word is refused.
//! * *Enumerations* are known by name alone; two different ones of one name in sight are refused.
//! * *Reads between two assignments* of one wire see the earlier value in rust-hdl; they are refused (`netlist::order`).
//! * *Guards* of `match` arms leave no trace at all, so they cannot be refused here. Co-simulation finds them.
//! * *Constants* of Rust appear as bare names and are refused; a `Constant` field is taken.
//! * *Bodies written as Verilog text* are taken when they are one of rust-hdl's own memories, word for word, or say
//!   what they are in remarks; see [`memory`]. Other text, black boxes and wrappers are refused.

mod align;
mod choice;
mod conversion;
mod expression;
mod link;
mod memory;
mod own_format;
mod position;
mod scope;
mod show;
mod statement;

use super::docs::{ascii, field_docs};
use super::drivers;
use super::fold::fold;
use super::order;
use super::read::RawNode;
use super::{Body, Child, Format, Module, NetlistError, Register, Signal, SignalKind};
use expression::Lowering;
use rust_hdl_core::ast::{Verilog, VerilogStatement};
use rust_hdl_core::prelude::{AtomKind, Block};
use scope::{constant_code, format_of, plain, Scope};
use shadegate_hdl::shade::lanes::LANE_PORTS;
use std::collections::HashMap;

/// The key and text of a remark. rust-hdl stores the invocation as `comment!("key text`, with or without the tail.
fn remark(text: &str) -> Option<(String, String)> {
    let text = text.split_once('"').map_or(text, |(_, t)| t);
    let text = text.strip_suffix("\")").unwrap_or(text);
    let (key, value) = text.split_once(' ')?;
    let value = value.split_whitespace().collect::<Vec<_>>().join(" ");
    Some((key.to_string(), ascii(&value)))
}

/// Remarks that head a module; other comments are not remarks.
const KEYS: &[&str] = &["name", "title", "equation", "source", "latency"];

/// Name and remarks of a description; without a name remark it is named after its place.
fn head_of(path: &str, hdl: &Verilog) -> (String, Vec<(String, String)>) {
    let mut remarks: Vec<(String, String)> = match hdl {
        Verilog::Combinatorial(block) => block
            .iter()
            .filter_map(|s| match s {
                VerilogStatement::Comment(t) => remark(t),
                _ => None,
            })
            .collect(),
        Verilog::Custom(text) => text
            .lines()
            .filter_map(|l| l.strip_prefix("//! "))
            .filter_map(remark)
            .collect(),
        _ => vec![],
    };
    remarks.retain(|(k, _)| KEYS.contains(&k.as_str()));
    let at = remarks.iter().position(|(k, _)| k == "name");
    let name = at.map_or_else(|| plain(&path.replace('.', "_")), |i| remarks.remove(i).1);
    (name, remarks)
}

/// Ports, wires and constants.
fn signals(
    name: &str,
    node: &RawNode,
    docs: &HashMap<String, String>,
) -> Result<Vec<Signal>, NetlistError> {
    let error = |what: String| NetlistError::new(name, what);
    let mut out = vec![];
    for atom in &node.atoms {
        let plain_name = plain(&atom.name);
        let kind = match atom.kind {
            AtomKind::InputParameter => SignalKind::Input,
            AtomKind::OutputParameter | AtomKind::OutputPassthrough => SignalKind::Output,
            AtomKind::LocalSignal => SignalKind::Local,
            AtomKind::Constant => {
                let code = constant_code(&atom.value);
                SignalKind::Constant(
                    code.ok_or_else(|| error(format!("constant {plain_name} has no value")))?,
                )
            }
            _ => {
                return Err(error(format!(
                    "signal {plain_name}: wires that are driven from both ends are not supported"
                )))
            }
        };
        let format = format_of(&atom.descriptor)
            .map_err(|why| error(format!("signal {plain_name}: {why}")))?;
        if let SignalKind::Constant(code) = kind {
            if format.width() < 128 && code >> format.width() != 0 {
                return Err(error(format!(
                    "constant {plain_name} is {code}, which is no {format}"
                )));
            }
        }
        let own = atom.name.split('$').next().unwrap_or_default();
        let doc = docs
            .get(&atom.name)
            .or_else(|| docs.get(own))
            .cloned()
            .unwrap_or_default();
        out.push(Signal {
            name: plain_name,
            kind,
            format,
            doc,
        });
    }
    Ok(out)
}

fn module(path: &str, node: RawNode) -> Result<Module, NetlistError> {
    let (name, remarks) = head_of(path, &node.hdl);
    let mut docs = field_docs(shadegate_hdl::sources::source(&name).unwrap_or_default());
    // The ports of further lanes belong to the load port, whatever core has them.
    for (port, doc) in field_docs(shadegate_hdl::sources::source("load_lanes").unwrap_or_default())
    {
        if LANE_PORTS.as_flattened().contains(&port.as_str()) {
            docs.entry(port).or_insert(doc);
        }
    }
    let mut signals = signals(&name, &node, &docs)?;
    let doc_of = |field: &str| {
        let own = field.split('$').next().unwrap_or_default();
        docs.get(field)
            .or_else(|| docs.get(own))
            .cloned()
            .unwrap_or_default()
    };
    if let Verilog::Custom(text) = &node.hdl {
        let memory = memory::read(&name, text, &signals)?;
        return Ok(Module {
            name,
            remarks,
            signals,
            registers: vec![],
            children: vec![],
            body: Body::Memory(Box::new(memory)),
        });
    }
    let Verilog::Combinatorial(block) = &node.hdl else {
        return Err(NetlistError::new(
            &name,
            "neither statements nor a memory: black boxes are not supported",
        ));
    };
    let mut lowering = Lowering::new(Scope::new(&name, &node));
    let lowered = lowering.body(block)?;
    for (spelling, (code, width)) in lowering.variants.into_inner() {
        signals.push(Signal {
            name: plain(&spelling),
            kind: SignalKind::Constant(code),
            format: Format::Enumeration(width),
            doc: format!("{}.", spelling.replace('$', "::")),
        });
    }
    let mut registers = vec![];
    let mut children = vec![];
    for child in &node.children {
        let Some(initial) = child.register() else {
            continue;
        };
        let own = plain(&child.name);
        let q = child.atom("q").map(|a| format_of(&a.descriptor));
        let format = q
            .unwrap_or_else(|| Err("has no q".into()))
            .map_err(|why| NetlistError::new(&name, format!("register {own}: {why}")))?;
        let clock = lowered.clocks.get(&own).cloned().ok_or_else(|| {
            NetlistError::new(
                &name,
                format!("register {own} is never assigned or has no clock"),
            )
        })?;
        registers.push(Register {
            name: own,
            format,
            doc: doc_of(&child.name),
            initial,
            clock,
        });
    }
    for child in node.children {
        if child.register().is_none() {
            let path = format!("{path}.{}", child.name);
            let doc = doc_of(&child.name);
            children.push(Child {
                name: plain(&child.name),
                doc,
                module: module(&path, child)?,
            });
        }
    }
    let mut made = Module {
        name,
        remarks,
        signals,
        registers,
        children,
        body: Body::Statements(lowered.statements),
    };
    drivers::check(&made, &lowered.held, &lowered.linked)?;
    order::check(&made)?;
    fold(&mut made);
    Ok(made)
}

/// Reads a connected description.
///
/// # Errors
/// Constructs that the netlist does not take or that cannot be typed; undriven and doubly driven signals; latches.
pub fn collect(design: &dyn Block) -> Result<Module, NetlistError> {
    let root = RawNode::of(design).ok_or_else(|| NetlistError::new("top", "is not a module"))?;
    if root.register().is_some() {
        return Err(NetlistError::new(
            "top",
            "is a single register; wrap it in a module",
        ));
    }
    module("top", root)
}
