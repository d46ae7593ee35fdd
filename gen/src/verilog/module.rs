//! A module as a Verilog file: header, ports, declarations with their comments, instances, behaviour.

use super::body::{print_body, PrintedBody, Target, Targets};
use super::expression::{literal, Names, Printer};
use crate::netlist::{Body, Child, Format, Module, NetlistError, SignalKind};
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

/// Words that Verilog-2001 or SystemVerilog reserve and a description might use.
const RESERVED: &[&str] = &[
    "always",
    "and",
    "assign",
    "begin",
    "bit",
    "buf",
    "byte",
    "case",
    "cell",
    "config",
    "default",
    "design",
    "disable",
    "do",
    "edge",
    "else",
    "end",
    "endmodule",
    "enum",
    "event",
    "export",
    "final",
    "for",
    "force",
    "function",
    "generate",
    "if",
    "import",
    "initial",
    "inout",
    "input",
    "int",
    "integer",
    "interface",
    "join",
    "library",
    "local",
    "logic",
    "modport",
    "module",
    "nand",
    "negedge",
    "new",
    "nor",
    "not",
    "null",
    "or",
    "output",
    "package",
    "parameter",
    "posedge",
    "program",
    "property",
    "rand",
    "real",
    "ref",
    "reg",
    "release",
    "repeat",
    "return",
    "sequence",
    "signed",
    "static",
    "string",
    "struct",
    "super",
    "table",
    "task",
    "this",
    "time",
    "tri",
    "type",
    "union",
    "unsigned",
    "var",
    "vectored",
    "virtual",
    "void",
    "wait",
    "while",
    "wire",
    "with",
    "within",
    "xor",
];

/// Module name with the format of its data, so that equal names are equal modules.
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

struct Scope<'a> {
    module: &'a Module,
}

impl Scope<'_> {
    fn child_port(&self, name: &str) -> Option<(&Child, &crate::netlist::Signal)> {
        let (child, port) = name.split_once('$')?;
        let child = self.module.children.iter().find(|c| c.name == child)?;
        child
            .module
            .signals
            .iter()
            .find(|s| s.name == port)
            .map(|s| (child, s))
    }
}

impl Names for Scope<'_> {
    fn read(&self, name: &str) -> Option<(String, Format)> {
        if let Some(s) = self.module.signals.iter().find(|s| s.name == name) {
            return Some((s.name.clone(), s.format));
        }
        if let Some(q) = name.strip_suffix("$q") {
            if let Some(r) = self.module.registers.iter().find(|r| r.name == q) {
                return Some((r.name.clone(), r.format));
            }
        }
        let (child, port) = self.child_port(name)?;
        (port.kind == SignalKind::Output)
            .then(|| (format!("{}_{}", child.name, port.name), port.format))
    }

    fn module(&self) -> &str {
        &self.module.name
    }
}

impl Targets for Scope<'_> {
    fn target(&self, name: &str) -> Option<(Target, Format)> {
        if let Some(s) = self.module.signals.iter().find(|s| s.name == name) {
            let drivable = matches!(s.kind, SignalKind::Output | SignalKind::Local);
            return drivable.then(|| (Target::Wire(s.name.clone()), s.format));
        }
        for (suffix, clock) in [("$d", false), ("$clock", true)] {
            if let Some(r) = name
                .strip_suffix(suffix)
                .and_then(|n| self.module.registers.iter().find(|r| r.name == n))
            {
                let n = r.name.clone();
                return Some(if clock {
                    (Target::RegisterClock(n), Format::Bit)
                } else {
                    (Target::Register(n), r.format)
                });
            }
        }
        let (child, port) = self.child_port(name)?;
        let wire = Target::Wire(format!("{}_{}", child.name, port.name));
        (port.kind == SignalKind::Input).then_some((wire, port.format))
    }
}

fn header(m: &Module, name: &str, stamp: &str) -> String {
    let remark = |key: &str| {
        m.remarks
            .iter()
            .find(|(k, _)| k == key)
            .map(|(_, v)| v.as_str())
            .unwrap_or_default()
    };
    let mut out = format!("// {name}: {}\n//\n", remark("title"));
    for (label, key) in [
        ("Equation", "equation"),
        ("Source", "source"),
        ("Latency", "latency"),
    ] {
        let _ = writeln!(out, "// {label:<9} {}", remark(key));
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
    let _ = writeln!(out, "//\n// {stamp}\n\n`default_nettype none\n");
    out
}

/// Declares ports; `reg_outputs` are driven from blocks.
fn ports(m: &Module, name: &str, reg_outputs: &BTreeSet<String>) -> String {
    let list: Vec<_> = m
        .signals
        .iter()
        .filter(|s| matches!(s.kind, SignalKind::Input | SignalKind::Output))
        .collect();
    let mut out = format!("module {name} (\n");
    for (i, s) in list.iter().enumerate() {
        let direction = match s.kind {
            SignalKind::Input => "input  wire",
            _ if reg_outputs.contains(&s.name) => "output reg ",
            _ => "output wire",
        };
        let comma = if i + 1 < list.len() { "," } else { "" };
        let declaration = format!("  {direction} {}{}{comma}", s.format.range(), s.name);
        let _ = writeln!(out, "{declaration:<48} // {}", s.doc);
    }
    out.push_str(");\n");
    out
}

struct Pieces {
    declarations: String,
    instances: String,
}

fn pieces(
    m: &Module,
    scope: &Scope,
    body: &PrintedBody,
    names: &BTreeMap<String, String>,
) -> Result<Pieces, NetlistError> {
    let by_block: BTreeSet<&String> = body.combinational.iter().flat_map(|(w, _)| w).collect();
    let assigned: BTreeMap<&str, &str> = body
        .assigns
        .iter()
        .map(|(n, v)| (n.as_str(), v.as_str()))
        .collect();
    let mut d = String::new();
    for s in &m.signals {
        if let SignalKind::Constant(code) = s.kind {
            let value = literal(code, s.format).ok_or_else(|| {
                NetlistError::new(&m.name, format!("constant {} does not fit", s.name))
            })?;
            let line = format!("  localparam {}{} = {value};", s.format.range(), s.name);
            let _ = writeln!(d, "{line:<48} // {}", s.doc);
        }
    }
    for r in &m.registers {
        if !body.registers.contains(&r.name) || !body.clocked_registers.contains(&r.name) {
            return Err(NetlistError::new(
                &m.name,
                format!("register {} is never assigned or has no clock", r.name),
            ));
        }
        let initial = literal(0, r.format).unwrap_or_default();
        let line = format!("  reg {}{} = {initial};", r.format.range(), r.name);
        let _ = writeln!(d, "{line:<48} // {}", r.doc);
    }
    for s in m.signals.iter().filter(|s| s.kind == SignalKind::Local) {
        let kind = if by_block.contains(&s.name) {
            "reg"
        } else {
            "wire"
        };
        if kind == "wire" && !assigned.contains_key(s.name.as_str()) {
            return Err(NetlistError::new(
                &m.name,
                format!("wire {} has no driver", s.name),
            ));
        }
        let line = format!("  {kind} {}{};", s.format.range(), s.name);
        let _ = writeln!(d, "{line:<48} // {}", s.doc);
    }
    let mut i = String::new();
    for c in &m.children {
        let mut connections = vec![];
        for s in c
            .module
            .signals
            .iter()
            .filter(|s| matches!(s.kind, SignalKind::Input | SignalKind::Output))
        {
            let wire = format!("{}_{}", c.name, s.name);
            let connected = if s.kind == SignalKind::Output {
                // Lint tools take a name that says so as the author's word that nobody reads it.
                let wire = if body.reads.contains(&wire) {
                    wire
                } else {
                    format!("unused_{wire}")
                };
                let line = format!("  wire {}{wire};", s.format.range());
                let _ = writeln!(d, "{line:<48} // {}: {}", c.name, s.doc);
                wire
            } else if let Some(value) = assigned.get(wire.as_str()) {
                // A plain name needs no wire of its own.
                if scope.module.signals.iter().any(|x| x.name == *value)
                    || m.registers.iter().any(|x| x.name == *value)
                    || m.children
                        .iter()
                        .any(|x| value.starts_with(&format!("{}_", x.name)) && !value.contains(' '))
                {
                    (*value).to_string()
                } else {
                    let line = format!("  wire {}{wire} = {value};", s.format.range());
                    let _ = writeln!(d, "{line:<48} // {}: {}", c.name, s.doc);
                    wire
                }
            } else if by_block.contains(&wire) {
                let line = format!("  reg {}{wire};", s.format.range());
                let _ = writeln!(d, "{line:<48} // {}: {}", c.name, s.doc);
                wire
            } else {
                return Err(NetlistError::new(
                    &m.name,
                    format!("input {} of {} has no driver", s.name, c.name),
                ));
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
    Ok(Pieces {
        declarations: d,
        instances: i,
    })
}

fn check_names(m: &Module) -> Result<(), NetlistError> {
    let mut seen = BTreeSet::new();
    let own = m
        .signals
        .iter()
        .map(|s| s.name.clone())
        .chain(m.registers.iter().map(|r| r.name.clone()));
    let wires = m.children.iter().flat_map(|c| {
        let ports = c
            .module
            .signals
            .iter()
            .filter(|s| matches!(s.kind, SignalKind::Input | SignalKind::Output));
        ports
            .map(|s| format!("{}_{}", c.name, s.name))
            .chain([c.name.clone()])
            .collect::<Vec<_>>()
    });
    for name in own.chain(wires) {
        if RESERVED.contains(&name.as_str()) {
            return Err(NetlistError::new(
                &m.name,
                format!("{name} is a Verilog word"),
            ));
        }
        if !seen.insert(name.clone()) {
            return Err(NetlistError::new(
                &m.name,
                format!("{name} names two things"),
            ));
        }
    }
    Ok(())
}

fn print(
    m: &Module,
    stamp: &str,
    files: &mut BTreeMap<String, String>,
) -> Result<String, NetlistError> {
    check_names(m)?;
    let mut names = BTreeMap::new();
    for c in &m.children {
        names.insert(c.name.clone(), print(&c.module, stamp, files)?);
    }
    let name = module_name(m);
    let mut text = header(m, &name, stamp);
    match &m.body {
        Body::Custom {
            text: body,
            reg_outputs,
        } => {
            text += &ports(m, &name, &reg_outputs.iter().cloned().collect());
            text.push('\n');
            for line in body.trim().lines() {
                let _ = writeln!(text, "{}{line}", if line.is_empty() { "" } else { "  " });
            }
        }
        Body::Statements(block) => {
            let scope = Scope { module: m };
            let body = print_body(&m.name, block, Printer::new(&scope), &scope, "clock")?;
            let by_block: BTreeSet<String> = body
                .combinational
                .iter()
                .flat_map(|(w, _)| w.iter().cloned())
                .collect();
            let p = pieces(m, &scope, &body, &names)?;
            text += &ports(m, &name, &by_block);
            for part in [p.declarations, p.instances.trim_end().to_string() + "\n"] {
                if !part.trim().is_empty() {
                    text.push('\n');
                    text += &part;
                }
            }
            let own: Vec<_> = body
                .assigns
                .iter()
                .filter(|(w, _)| m.signals.iter().any(|s| s.name == *w))
                .collect();
            if !own.is_empty() {
                text.push('\n');
            }
            for (wire, value) in own {
                let _ = writeln!(text, "  assign {wire} = {value};");
            }
            for (_, lines) in &body.combinational {
                let _ = write!(text, "\n  always @* begin\n{}\n  end\n", indent(lines));
            }
            for lines in &body.clocked {
                let _ = write!(
                    text,
                    "\n  always @(posedge clock) begin\n{}\n  end\n",
                    indent(lines)
                );
            }
            for s in m.signals.iter().filter(|s| s.kind == SignalKind::Output) {
                if !by_block.contains(&s.name) && !body.assigns.iter().any(|(w, _)| *w == s.name) {
                    return Err(NetlistError::new(
                        &m.name,
                        format!("output {} has no driver", s.name),
                    ));
                }
            }
        }
    }
    text += "\nendmodule\n\n`default_nettype wire\n";
    match files.get(&name) {
        Some(other) if *other != text => Err(NetlistError::new(
            &name,
            "two different modules have this name".to_string(),
        )),
        _ => {
            files.insert(name.clone(), text);
            Ok(name)
        }
    }
}

fn indent(lines: &[String]) -> String {
    lines
        .iter()
        .map(|l| format!("  {l}"))
        .collect::<Vec<_>>()
        .join("\n")
}

/// Prints a design, the top module last; `stamp` is the line that says what made the files.
///
/// # Errors
/// What the netlist cannot mean in Verilog; see [`NetlistError`].
pub fn emit(top: &Module, stamp: &str) -> Result<Vec<VerilogFile>, NetlistError> {
    let mut files = BTreeMap::new();
    let top_name = print(top, stamp, &mut files)?;
    let mut out: Vec<VerilogFile> = files
        .into_iter()
        .map(|(name, text)| VerilogFile { name, text })
        .collect();
    out.sort_by_key(|f| (f.name == top_name, f.name.clone()));
    Ok(out)
}
