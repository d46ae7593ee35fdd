//! Statements as continuous assignments, combinational blocks and clocked blocks.
//!
//! Registers: "keep the value unless assigned" becomes a clocked block without the default.
//! Wires: assigned once, unconditionally → `assign`; otherwise → an `always @*` block, which assigns the wire on every
//! path (the netlist has no latches). Statements that share an `if` stay together, so the text follows the
//! description, unless a block would read what it drives: a read means the settled value, which a block would not see.

use super::expression::{literal, Printer};
use crate::netlist::{groups, Arm, Expression, Format, Module, Name, Statement, Target};
use std::collections::{BTreeMap, BTreeSet};

/// A printed clocked block.
#[derive(Debug)]
pub struct Clocked {
    /// Its clock.
    pub clock: String,
    /// Its lines.
    pub lines: Vec<String>,
}

/// The printed body of a module.
#[derive(Debug, Default)]
pub struct PrintedBody {
    /// `assign` right sides by wire, in order of appearance; the value too, for instance inputs that need no wire.
    pub assigns: Vec<(Name, Expression, String)>,
    /// Combinational blocks: the wires each drives, and its lines.
    pub combinational: Vec<(BTreeSet<String>, Vec<String>)>,
    /// Clocked blocks.
    pub clocked: Vec<Clocked>,
}

struct Body<'p, 'm> {
    printer: &'p mut Printer<'m>,
    module: &'m Module,
    /// The statement from which on a target's assignments count: the last unconditional one of the whole target.
    from: BTreeMap<Target, usize>,
}

/// The targets of one block.
struct Group<'a> {
    targets: &'a BTreeSet<Target>,
    clocked: bool,
}

fn spell(target: &Target) -> String {
    match target {
        Target::Wire(name) => name.verilog(),
        Target::Register(name) => name.clone(),
    }
}

impl Body<'_, '_> {
    fn lines(&mut self, s: &Statement, g: &Group, indent: usize, out: &mut Vec<String>) {
        let pad = "  ".repeat(indent);
        match s {
            Statement::Assign {
                target,
                bits,
                value,
            } => {
                if !g.targets.contains(target) {
                    return;
                }
                self.printer.stem = spell(target);
                let value = self.printer.assigned(value);
                let operator = if g.clocked { "<=" } else { "=" };
                let bits = bits.map_or(String::new(), |b| match b.width {
                    1 => format!("[{}]", b.at),
                    w => format!("[{}:{}]", b.at + w - 1, b.at),
                });
                out.push(format!("{pad}{}{bits} {operator} {value};", spell(target)));
            }
            Statement::If {
                condition,
                then,
                otherwise,
            } => {
                self.conditional(condition, then, otherwise, g, indent, &pad, out);
            }
            Statement::Case {
                subject,
                arms,
                otherwise,
            } => self.case(subject, arms, otherwise, g, indent, out),
        }
    }

    fn block(&mut self, block: &[Statement], g: &Group, indent: usize) -> Vec<String> {
        let mut out = vec![];
        block
            .iter()
            .for_each(|s| self.lines(s, g, indent, &mut out));
        out
    }

    /// Parts of a condition are named after the first thing that it decides.
    fn name_condition(&mut self, blocks: &[&[Statement]], g: &Group) {
        let mut first = None;
        for s in blocks.iter().copied().flatten() {
            s.each_target(&mut |t| {
                if first.is_none() && g.targets.contains(t) {
                    first = Some(format!("{}_when", spell(t)));
                }
            });
        }
        self.printer.stem = first.unwrap_or_default();
    }

    #[allow(clippy::too_many_arguments)]
    fn conditional(
        &mut self,
        condition: &Expression,
        then: &[Statement],
        otherwise: &[Statement],
        g: &Group,
        indent: usize,
        lead: &str,
        out: &mut Vec<String>,
    ) {
        let pad = "  ".repeat(indent);
        self.name_condition(&[then, otherwise], g);
        let test = self.printer.condition(condition);
        let mut lines = self.block(then, g, indent + 1);
        let rest = self.block(otherwise, g, indent + 1);
        if lines.is_empty() && rest.is_empty() {
            return;
        }
        out.push(format!("{lead}if ({test}) begin"));
        out.append(&mut lines);
        let chain = match otherwise {
            [Statement::If {
                condition,
                then,
                otherwise,
            }] if !rest.is_empty() => Some((condition, then, otherwise)),
            _ => None,
        };
        if let Some((condition, then, otherwise)) = chain {
            return self.conditional(
                condition,
                then,
                otherwise,
                g,
                indent,
                &format!("{pad}end else "),
                out,
            );
        }
        if !rest.is_empty() {
            out.push(format!("{pad}end else begin"));
            out.extend(rest);
        }
        out.push(format!("{pad}end"));
    }

    fn case(
        &mut self,
        subject: &Expression,
        arms: &[Arm],
        otherwise: &[Statement],
        g: &Group,
        indent: usize,
        out: &mut Vec<String>,
    ) {
        let pad = "  ".repeat(indent);
        let mut bodies: Vec<&[Statement]> = arms.iter().map(|a| a.body.as_slice()).collect();
        bodies.push(otherwise);
        self.name_condition(&bodies, g);
        let subject_text = self.printer.condition(subject);
        let mut arm_lines = vec![];
        for arm in arms {
            let label = if arm.name.is_empty() {
                literal(arm.label, Format::Unsigned(subject.width()))
            } else {
                arm.name.clone()
            };
            arm_lines.push((label, self.block(&arm.body, g, indent + 2)));
        }
        let rest = self.block(otherwise, g, indent + 2);
        if rest.is_empty() && arm_lines.iter().all(|(_, l)| l.is_empty()) {
            return;
        }
        out.push(format!("{pad}case ({subject_text})"));
        for (label, lines) in arm_lines.into_iter().chain([("default".to_string(), rest)]) {
            // An arm that does nothing here still keeps its label from falling to the default.
            out.push(format!("{pad}  {label}: begin"));
            out.extend(lines);
            out.push(format!("{pad}  end"));
        }
        out.push(format!("{pad}endcase"));
    }

    /// The statements that count for this target.
    fn owners(&mut self, statements: &[Statement], target: &Target) -> Vec<usize> {
        let whole = |s: &Statement| matches!(s, Statement::Assign { target: t, bits: None, .. } if t == target);
        let from = statements.iter().rposition(whole).unwrap_or(0);
        self.from.insert(target.clone(), from);
        (from..statements.len())
            .filter(|i| statements[*i].drives(target))
            .collect()
    }

    fn print(
        &mut self,
        statements: &[Statement],
        targets: &BTreeSet<Target>,
        clocked: bool,
    ) -> Vec<String> {
        let mut out = vec![];
        for (i, s) in statements.iter().enumerate() {
            let live: BTreeSet<Target> = targets
                .iter()
                .filter(|t| self.from.get(*t).copied().unwrap_or(0) <= i)
                .cloned()
                .collect();
            self.lines(
                s,
                &Group {
                    targets: &live,
                    clocked,
                },
                1,
                &mut out,
            );
        }
        out
    }

    /// Whether statements that drive these targets read one of them.
    fn reads_itself(&self, statements: &[Statement], targets: &BTreeSet<Target>) -> bool {
        let own: BTreeSet<&Name> = targets
            .iter()
            .filter_map(|t| match t {
                Target::Wire(name) => Some(name),
                Target::Register(_) => None,
            })
            .collect();
        let mut found = false;
        for s in statements
            .iter()
            .filter(|s| targets.iter().any(|t| s.drives(t)))
        {
            s.each_read(&mut |n| found |= own.contains(n));
        }
        found
    }
}

/// Prints the statements of a module.
pub fn print_body<'m>(
    module: &'m Module,
    statements: &[Statement],
    printer: &mut Printer<'m>,
) -> PrintedBody {
    let mut targets = BTreeSet::new();
    for s in statements {
        s.each_target(&mut |t| {
            targets.insert(t.clone());
        });
    }
    let mut b = Body {
        printer,
        module,
        from: BTreeMap::new(),
    };
    let mut wires: Vec<(Target, Vec<usize>)> = vec![];
    let mut registers: BTreeMap<String, BTreeMap<Target, Vec<usize>>> = BTreeMap::new();
    for target in targets {
        let at = b.owners(statements, &target);
        match &target {
            Target::Wire(_) => wires.push((target, at)),
            Target::Register(r) => {
                let clock = b
                    .module
                    .register(r)
                    .map(|r| r.clock.clone())
                    .unwrap_or_default();
                registers.entry(clock).or_default().insert(target, at);
            }
        }
    }
    wires.sort_by_key(|(_, at)| at[0]);
    let mut body = PrintedBody::default();
    let mut complex = BTreeMap::new();
    for (target, at) in wires {
        match (&target, at.as_slice()) {
            (Target::Wire(name), [only])
                if matches!(&statements[*only], Statement::Assign { bits: None, .. }) =>
            {
                let Statement::Assign { value, .. } = &statements[*only] else {
                    continue;
                };
                b.printer.stem = name.verilog();
                let text = b.printer.assigned(value);
                body.assigns.push((name.clone(), value.clone(), text));
            }
            _ => {
                complex.insert(target, at);
            }
        }
    }
    for group in groups(&complex) {
        let alone = b.reads_itself(statements, &group);
        let blocks: Vec<BTreeSet<Target>> = if alone {
            group.into_iter().map(|t| BTreeSet::from([t])).collect()
        } else {
            vec![group]
        };
        for targets in blocks {
            let lines = b.print(statements, &targets, false);
            body.combinational
                .push((targets.iter().map(spell).collect(), lines));
        }
    }
    for (clock, owners) in registers {
        for group in groups(&owners) {
            let lines = b.print(statements, &group, true);
            body.clocked.push(Clocked {
                clock: clock.clone(),
                lines,
            });
        }
    }
    body
}
