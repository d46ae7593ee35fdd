//! A module as a Verilog file: header, ports, declarations with their comments, instances, behaviour.

use super::body::print_body;
use super::expression::Printer;
use super::memory::memory_body;
use super::shared::Shared;
use super::wiring::{declared, line, Wiring};
use crate::netlist::{check_hierarchy, Body, Format, Module, Name, NetlistError, SignalKind};
use sha2::{Digest, Sha256};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// One emitted file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VerilogFile {
    /// Module name; the file is `<name>.v`.
    pub name: String,
    /// Text.
    pub text: String,
}

impl VerilogFile {
    /// File name.
    #[must_use]
    pub fn file_name(&self) -> String {
        format!("{}.v", self.name)
    }
}

/// Module name with the format of its data, so that equal names are equal modules.
#[must_use]
pub fn module_name(m: &Module) -> String {
    let formats = m
        .signals
        .iter()
        .map(|s| s.format)
        .chain(m.registers.iter().map(|r| r.format));
    let fixed = formats.into_iter().find_map(|f| match f {
        Format::Fixed(a, b) if b > 0 => Some((a, b)),
        _ => None,
    });
    match fixed {
        Some((a, b)) => format!("{}_q{a}_{b}", m.name),
        None => m.name.clone(),
    }
}

/// The part of the header that the module's own text decides; the stamp comes after it.
fn header(m: &Module, name: &str) -> String {
    let remark = |key: &str| {
        m.remarks
            .iter()
            .find(|(k, _)| k == key)
            .map(|(_, v)| v.as_str())
    };
    let mut out = match remark("title") {
        Some(title) => format!("// {name}: {title}\n//\n"),
        None => format!("// {name}\n"),
    };
    for (label, key) in [
        ("Equation", "equation"),
        ("Source", "source"),
        ("Latency", "latency"),
    ] {
        if let Some(text) = remark(key) {
            let _ = writeln!(out, "// {label:<9} {text}");
        }
    }
    let mut formats: Vec<String> = vec![];
    for f in m
        .signals
        .iter()
        .map(|s| s.format)
        .chain(m.registers.iter().map(|r| r.format))
    {
        if let Format::Fixed(a, b) = f {
            let text = format!("{f} ({} bits: sign, {a} integer, {b} fraction)", f.width());
            if !formats.contains(&text) {
                formats.push(text);
            }
        }
    }
    if !formats.is_empty() {
        let _ = writeln!(out, "// {:<9} {}", "Formats", formats.join("; "));
    }
    out
}

/// Declares ports; `reg_outputs` are driven from blocks.
fn ports(m: &Module, name: &str, reg_outputs: &BTreeSet<String>) -> String {
    let list: Vec<_> = m.signals.iter().filter(|s| s.is_port()).collect();
    let mut out = format!("module {name} (\n");
    for (i, s) in list.iter().enumerate() {
        let direction = match s.kind {
            SignalKind::Input => "input  wire",
            _ if reg_outputs.contains(&s.name) => "output reg ",
            _ => "output wire",
        };
        let comma = if i + 1 < list.len() { "," } else { "" };
        let declaration = format!("  {direction} {}{}{comma}", s.format.range(), s.name);
        line(&mut out, &declaration, &s.doc);
    }
    out.push_str(");\n");
    out
}

fn statements(
    m: &Module,
    name: &str,
    names: &BTreeMap<String, String>,
) -> Result<String, NetlistError> {
    let taken = declared(m)?;
    let (text, reg_outputs) = match &m.body {
        Body::Memory(memory) => {
            let comb_array = memory.read.clock.is_none() && memory.write.is_some();
            let outputs = if comb_array {
                BTreeSet::new()
            } else {
                BTreeSet::from([memory.read.data.clone()])
            };
            (format!("\n{}", memory_body(m, memory)), outputs)
        }
        Body::Statements(block) => {
            let mut printer = Printer::new(m, taken);
            let body = print_body(m, block, &mut printer);
            let by_block: BTreeSet<&String> =
                body.combinational.iter().flat_map(|(w, _)| w).collect();
            let wiring = Wiring {
                m,
                body: &body,
                by_block: by_block.clone(),
                reads: &printer.reads,
                taken: &printer.taken,
            };
            let p = wiring.pieces(&printer.parts, names);
            let mut text = String::new();
            for part in [p.declarations, p.instances.trim_end().to_string() + "\n"] {
                if !part.trim().is_empty() {
                    text.push('\n');
                    text += &part;
                }
            }
            let own: Vec<_> = body
                .assigns
                .iter()
                .filter(|(n, _, _)| matches!(n, Name::Signal(_)))
                .collect();
            if !own.is_empty() {
                text.push('\n');
            }
            for (wire, _, value) in own {
                let _ = writeln!(text, "  assign {} = {value};", wire.verilog());
            }
            for (_, lines) in &body.combinational {
                let _ = write!(text, "\n  always @* begin\n{}\n  end\n", indent(lines));
            }
            for block in &body.clocked {
                let _ = write!(
                    text,
                    "\n  always @(posedge {}) begin\n{}\n  end\n",
                    block.clock,
                    indent(&block.lines)
                );
            }
            (text, by_block.into_iter().cloned().collect())
        }
    };
    Ok(ports(m, name, &reg_outputs) + &text)
}

fn indent(lines: &[String]) -> String {
    lines
        .iter()
        .map(|l| format!("  {l}"))
        .collect::<Vec<_>>()
        .join("\n")
}

/// Twelve hexadecimal digits that name a text.
#[must_use]
pub fn hash(texts: &[&str]) -> String {
    let mut hash = Sha256::new();
    for text in texts {
        hash.update(text.as_bytes());
    }
    hash.finalize()
        .iter()
        .take(6)
        .map(|b| format!("{b:02x}"))
        .collect()
}

/// The head and the text of a module whose instances' modules have these names.
fn text(
    m: &Module,
    name: &str,
    names: &BTreeMap<String, String>,
) -> Result<(String, String), NetlistError> {
    Ok((header(m, name), statements(m, name, names)?))
}

/// Prints a design, the top module last; `generator` says what made the files.
///
/// # Errors
/// A combinational loop anywhere, with its path; names that Verilog does not take, or that stand for two things.
pub fn emit(top: &Module, generator: &str) -> Result<Vec<VerilogFile>, NetlistError> {
    check_hierarchy(top)?;
    let mut shared = Shared::default();
    let last = shared.add(top, &text)?;
    let names = shared.names();
    let mut out = vec![];
    for (i, unit) in shared.units.iter().enumerate() {
        let of = |(child, unit): (&String, &usize)| (child.clone(), names[*unit].clone());
        let children = unit.children.iter().map(of).collect();
        let (head, body) = text(unit.module, &names[i], &children)?;
        // The hash is of this module alone, so that a file changes only when its own text does.
        let stamp = hash(&[&head, &body]);
        let text = format!(
            "{head}//\n// Generated by {generator}, configuration {stamp}.\n\n`default_nettype none\n\n{body}\nendmodule\n\n`default_nettype wire\n"
        );
        out.push((
            i == last,
            VerilogFile {
                name: names[i].clone(),
                text,
            },
        ));
    }
    out.sort_by_key(|(is_top, f)| (*is_top, f.name.clone()));
    Ok(out.into_iter().map(|(_, f)| f).collect())
}
