//! Statements as continuous assignments, combinational blocks and clocked blocks.
//!
//! Registers: the description's "keep the value unless assigned" becomes a clocked block without the default.
//! Wires: assigned once, at the top level → `assign`; otherwise → an `always @*` block, which must assign the wire on
//! every path (a latch is refused). Statements that share an `if` stay together, so the text follows the description.

use super::expression::{bare, Printer};
use crate::netlist::{Format, NetlistError};
use rust_hdl_core::ast::{
    VerilogBlock, VerilogBlockOrConditional as Else, VerilogConditional, VerilogExpression as E,
    VerilogStatement as S,
};
use std::collections::{BTreeMap, BTreeSet};

/// Where an assignment goes.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Target {
    /// A wire, output or instance input, by its Verilog name.
    Wire(String),
    /// A register.
    Register(String),
    /// The clock of a register, which must be the module's clock.
    RegisterClock(String),
}

/// What a module knows of assignment targets.
pub trait Targets {
    /// The target of an assignment and its format.
    fn target(&self, name: &str) -> Option<(Target, Format)>;
}

/// The printed body of a module.
#[derive(Debug, Default)]
pub struct PrintedBody {
    /// `assign` right sides by wire, in order of appearance.
    pub assigns: Vec<(String, String)>,
    /// Combinational blocks: the wires each drives, and its lines.
    pub combinational: Vec<(BTreeSet<String>, Vec<String>)>,
    /// Clocked blocks: lines.
    pub clocked: Vec<Vec<String>>,
    /// Registers that are assigned.
    pub registers: BTreeSet<String>,
    /// Registers whose clock was connected.
    pub clocked_registers: BTreeSet<String>,
    /// Verilog names that are read somewhere.
    pub reads: BTreeSet<String>,
}

struct Splitter<'a> {
    printer: Printer<'a>,
    targets: &'a dyn Targets,
    module: &'a str,
}

fn flatten<'s>(block: &'s VerilogBlock, out: &mut Vec<&'s S>) {
    for s in block {
        match s {
            S::Macro(inner) => flatten(inner, out),
            S::Comment(_) => {}
            other => out.push(other),
        }
    }
}

impl Splitter<'_> {
    fn error(&self, what: impl Into<String>) -> NetlistError {
        NetlistError::new(self.module, what)
    }

    fn target(&self, e: &E) -> Result<(Target, Format), NetlistError> {
        let E::Signal(name) = e else {
            return Err(self.error(format!("cannot assign to {e:?}")));
        };
        let name = name.strip_suffix("$next").unwrap_or(name);
        self.targets
            .target(name)
            .ok_or_else(|| self.error(format!("cannot assign to {name}")))
    }

    fn targets_of(&self, s: &S, out: &mut BTreeSet<Target>) -> Result<(), NetlistError> {
        match s {
            S::Assignment(to, _) => {
                out.insert(self.target(to)?.0);
            }
            S::If(c) => {
                self.targets_of_block(&c.then, out)?;
                match &c.otherwise {
                    Else::Block(b) => self.targets_of_block(b, out)?,
                    Else::Conditional(s) => self.targets_of(s, out)?,
                    Else::None => {}
                }
            }
            other => {
                let shown: String = format!("{other:?}").chars().take(120).collect();
                return Err(self.error(format!("statement is not supported: {shown}")));
            }
        }
        Ok(())
    }

    fn targets_of_block(
        &self,
        b: &VerilogBlock,
        out: &mut BTreeSet<Target>,
    ) -> Result<(), NetlistError> {
        let mut flat = vec![];
        flatten(b, &mut flat);
        flat.into_iter().try_for_each(|s| self.targets_of(s, out))
    }

    /// Lines of a statement, reduced to the assignments of `wanted`.
    fn lines(
        &self,
        s: &S,
        wanted: &BTreeSet<Target>,
        clocked: bool,
        indent: usize,
        out: &mut Vec<String>,
    ) -> Result<(), NetlistError> {
        let pad = "  ".repeat(indent);
        match s {
            S::Assignment(to, value) => {
                let (target, format) = self.target(to)?;
                if !wanted.contains(&target) {
                    return Ok(());
                }
                let (Target::Wire(name) | Target::Register(name) | Target::RegisterClock(name)) =
                    &target;
                let value = bare(&self.printer.assigned(value, format)?);
                let operator = if clocked { "<=" } else { "=" };
                out.push(format!("{pad}{name} {operator} {value};"));
            }
            S::If(c) => self.conditional(c, wanted, clocked, indent, &pad, out)?,
            _ => unreachable!("refused while targets were collected"),
        }
        Ok(())
    }

    fn conditional(
        &self,
        c: &VerilogConditional,
        wanted: &BTreeSet<Target>,
        clocked: bool,
        indent: usize,
        lead: &str,
        out: &mut Vec<String>,
    ) -> Result<(), NetlistError> {
        let pad = "  ".repeat(indent);
        let mut then = vec![];
        let mut flat = vec![];
        flatten(&c.then, &mut flat);
        for s in flat {
            self.lines(s, wanted, clocked, indent + 1, &mut then)?;
        }
        let mut otherwise = vec![];
        let mut chain = None;
        match &c.otherwise {
            Else::Block(b) => {
                let mut flat = vec![];
                flatten(b, &mut flat);
                for s in flat {
                    self.lines(s, wanted, clocked, indent + 1, &mut otherwise)?;
                }
            }
            Else::Conditional(s) => {
                let mut targets = BTreeSet::new();
                self.targets_of(s, &mut targets)?;
                if !targets.is_disjoint(wanted) {
                    chain = Some(s.as_ref());
                }
            }
            Else::None => {}
        }
        if then.is_empty() && otherwise.is_empty() && chain.is_none() {
            return Ok(());
        }
        out.push(format!(
            "{lead}if ({}) begin",
            self.printer.condition(&c.test)?
        ));
        out.append(&mut then);
        if let Some(S::If(next)) = chain {
            return self.conditional(
                next,
                wanted,
                clocked,
                indent,
                &format!("{pad}end else "),
                out,
            );
        }
        if !otherwise.is_empty() {
            out.push(format!("{pad}end else begin"));
            out.append(&mut otherwise);
        }
        out.push(format!("{pad}end"));
        Ok(())
    }

    /// Whether the statements assign `target` on every path.
    fn always_assigns(&self, block: &[&S], target: &Target) -> Result<bool, NetlistError> {
        for s in block {
            let sure = match s {
                S::Assignment(to, _) => self.target(to)?.0 == *target,
                S::If(c) => {
                    let mut then = vec![];
                    flatten(&c.then, &mut then);
                    let otherwise = match &c.otherwise {
                        Else::Block(b) => {
                            let mut flat = vec![];
                            flatten(b, &mut flat);
                            self.always_assigns(&flat, target)?
                        }
                        Else::Conditional(s) => self.always_assigns(&[s.as_ref()], target)?,
                        Else::None => false,
                    };
                    otherwise && self.always_assigns(&then, target)?
                }
                _ => false,
            };
            if sure {
                return Ok(true);
            }
        }
        Ok(false)
    }
}

/// Is this the "keep the value" default that every register gets first?
fn is_hold(to: &Target, value: &E) -> bool {
    matches!((to, value), (Target::Register(name), E::Signal(read)) if read.strip_suffix("$q") == Some(name))
}

/// Groups of statement indices that drive a common target, in order of first appearance.
fn groups(owners: &BTreeMap<Target, Vec<usize>>) -> Vec<BTreeSet<Target>> {
    let mut groups: Vec<(BTreeSet<Target>, BTreeSet<usize>)> = vec![];
    let mut by_order: Vec<_> = owners.iter().collect();
    by_order.sort_by_key(|(_, at)| at[0]);
    for (target, at) in by_order {
        let mut merged = (
            BTreeSet::from([target.clone()]),
            at.iter().copied().collect::<BTreeSet<_>>(),
        );
        let mut place = groups.len();
        let mut i = 0;
        while i < groups.len() {
            if groups[i].1.is_disjoint(&merged.1) {
                i += 1;
                continue;
            }
            let (targets, at) = groups.remove(i);
            merged.0.extend(targets);
            merged.1.extend(at);
            place = place.min(i);
        }
        groups.insert(place.min(groups.len()), merged);
    }
    groups.into_iter().map(|g| g.0).collect()
}

/// Prints the statements of a module.
///
/// # Errors
/// Unsupported statements, latches, registers without a hold default, formats that do not agree.
pub fn print_body(
    module: &str,
    block: &VerilogBlock,
    printer: Printer,
    targets: &dyn Targets,
    clock: &str,
) -> Result<PrintedBody, NetlistError> {
    let s = Splitter {
        printer,
        targets,
        module,
    };
    let mut statements = vec![];
    flatten(block, &mut statements);
    let mut body = PrintedBody::default();
    let mut held = BTreeSet::new();
    let mut wires: BTreeMap<Target, Vec<usize>> = BTreeMap::new();
    let mut registers: BTreeMap<Target, Vec<usize>> = BTreeMap::new();
    for (i, statement) in statements.iter().enumerate() {
        if let S::Assignment(to, value) = statement {
            let (target, _) = s.target(to)?;
            if let Target::RegisterClock(name) = &target {
                if !matches!(value, E::Signal(c) if c == clock) {
                    return Err(s.error(format!("register {name} is not clocked by {clock}")));
                }
                body.clocked_registers.insert(name.clone());
                continue;
            }
            if is_hold(&target, value) {
                held.insert(target);
                continue;
            }
        }
        let mut targets = BTreeSet::new();
        s.targets_of(statement, &mut targets)?;
        for t in targets {
            match &t {
                Target::Wire(_) => wires.entry(t).or_default().push(i),
                Target::Register(_) => registers.entry(t).or_default().push(i),
                Target::RegisterClock(name) => {
                    return Err(s.error(format!(
                        "the clock of register {name} is assigned conditionally"
                    )))
                }
            }
        }
    }
    // Wires assigned once at the top level.
    let simple = |at: &Vec<usize>| at.len() == 1 && matches!(statements[at[0]], S::Assignment(..));
    let mut complex = BTreeMap::new();
    let mut ordered: Vec<_> = wires.into_iter().collect();
    ordered.sort_by_key(|(_, at)| at[0]);
    for (target, at) in ordered {
        if simple(&at) {
            if let (Target::Wire(name), S::Assignment(to, value)) = (&target, statements[at[0]]) {
                let (_, format) = s.target(to)?;
                body.assigns
                    .push((name.clone(), bare(&s.printer.assigned(value, format)?)));
            }
        } else {
            if !s.always_assigns(&statements, &target)? {
                return Err(s.error(format!(
                    "{target:?} is not assigned on every path: that would be a latch"
                )));
            }
            complex.insert(target, at);
        }
    }
    for group in groups(&complex) {
        let mut lines = vec![];
        for statement in &statements {
            s.lines(statement, &group, false, 1, &mut lines)?;
        }
        let names = group
            .iter()
            .map(|t| {
                if let Target::Wire(n) = t {
                    n.clone()
                } else {
                    String::new()
                }
            })
            .collect();
        body.combinational.push((names, lines));
    }
    for target in registers.keys() {
        if !held.contains(target) && !s.always_assigns(&statements, target)? {
            return Err(s.error(format!(
                "{target:?} has no value on some path and no hold default"
            )));
        }
        if let Target::Register(name) = target {
            body.registers.insert(name.clone());
        }
    }
    for group in groups(&registers) {
        let mut lines = vec![];
        for statement in &statements {
            if matches!(statement, S::Assignment(to, value) if is_hold(&s.target(to)?.0, value)) {
                continue;
            }
            s.lines(statement, &group, true, 1, &mut lines)?;
        }
        body.clocked.push(lines);
    }
    body.reads = s.printer.reads.into_inner();
    Ok(body)
}
