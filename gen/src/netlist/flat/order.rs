//! Order of evaluation: every wire behind what it depends on, by name.
//!
//! A wire depends on every name that an assignment to it, or a condition around one, reads; which bits they are does
//! not matter. So a wire that feeds one of its own bits from another is refused too, as are two instances that would
//! close a loop only through bits that do not meet. Registers and clocked read data depend on nothing.

use super::report::error;
use super::{Driver, Flat, SignalId};
use crate::netlist::{Name, NetlistError, Statement, Target};
use std::collections::{BTreeSet, HashMap};

/// Names that each wire of a module depends on.
type Reads<'a> = HashMap<&'a Name, BTreeSet<&'a Name>>;

fn gather<'a>(list: &'a [Statement], around: &BTreeSet<&'a Name>, out: &mut Reads<'a>) {
    for s in list {
        match s {
            Statement::Assign { target, value, .. } => {
                if let Target::Wire(name) = target {
                    let entry = out.entry(name).or_default();
                    entry.extend(around);
                    reads(value, entry);
                }
            }
            Statement::If {
                condition,
                then,
                otherwise,
            } => {
                let mut around = around.clone();
                reads(condition, &mut around);
                gather(then, &around, out);
                gather(otherwise, &around, out);
            }
            Statement::Case {
                subject,
                arms,
                otherwise,
            } => {
                let mut around = around.clone();
                reads(subject, &mut around);
                for a in arms {
                    gather(&a.body, &around, out);
                }
                gather(otherwise, &around, out);
            }
        }
    }
}

fn reads<'a>(e: &'a crate::netlist::Expression, out: &mut BTreeSet<&'a Name>) {
    if let crate::netlist::Node::Read(name) = &e.node {
        out.insert(name);
    }
    for operand in e.operands() {
        reads(operand, out);
    }
}

/// What each signal depends on within the clock.
fn dependences(flat: &Flat<'_>) -> Vec<Vec<SignalId>> {
    let mut out = vec![vec![]; flat.signals.len()];
    for p in &flat.processes {
        let mut by_name = Reads::new();
        gather(p.statements, &BTreeSet::new(), &mut by_name);
        for (name, names) in by_name {
            if let Some(id) = p.scope.get(name) {
                let ids = names.into_iter().filter_map(|n| p.scope.get(n).copied());
                out[id.index()].extend(ids);
            }
        }
    }
    for m in flat
        .memories
        .iter()
        .filter(|m| m.memory.read.clock.is_none())
    {
        out[m.read_data.index()].push(m.read_address);
    }
    for list in &mut out {
        list.sort_unstable();
    }
    out
}

/// Fills in the order of a design, or names a loop.
pub(super) fn levelise(flat: &mut Flat<'_>) -> Result<(), NetlistError> {
    #[derive(Clone, Copy, PartialEq)]
    enum Mark {
        New,
        Open,
        Done,
    }
    let dependences = dependences(flat);
    let mut marks = vec![Mark::New; flat.signals.len()];
    // A signal and how many of its dependences have been looked at.
    let mut path: Vec<(SignalId, usize)> = vec![];
    for root in (0..flat.signals.len() as u32).map(SignalId) {
        if marks[root.index()] == Mark::New {
            marks[root.index()] = Mark::Open;
            path.push((root, 0));
        }
        while let Some((id, next)) = path.last_mut() {
            if let Some(d) = dependences[id.index()].get(*next).copied() {
                *next += 1;
                match marks[d.index()] {
                    Mark::New => {
                        marks[d.index()] = Mark::Open;
                        path.push((d, 0));
                    }
                    Mark::Open => return Err(loop_error(flat, &path, d)),
                    Mark::Done => {}
                }
            } else {
                marks[id.index()] = Mark::Done;
                let s = &flat.signals[id.index()];
                let evaluated = match s.driver {
                    Driver::Process(_) => true,
                    Driver::Memory(m) => flat.memories[m.index()].memory.read.clock.is_none(),
                    _ => false,
                };
                if evaluated {
                    flat.order.push(*id);
                }
                path.pop();
            }
        }
    }
    Ok(())
}

/// The loop that `path` closes at `back`, in the direction of the signal flow, from its least name.
fn loop_error(flat: &Flat<'_>, path: &[(SignalId, usize)], back: SignalId) -> NetlistError {
    let begin = path.iter().position(|p| p.0 == back).unwrap_or(0);
    let mut names: Vec<&str> = path[begin..]
        .iter()
        .map(|p| flat.signals[p.0.index()].name.as_str())
        .collect();
    names.reverse();
    let least = (0..names.len()).min_by_key(|i| names[*i]).unwrap_or(0);
    names.rotate_left(least);
    names.push(names[0]);
    error(
        &flat.name,
        "",
        format!("combinational loop: {}", names.join(" -> ")),
    )
}
