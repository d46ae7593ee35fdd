//! What an edge does: stores and writes under branches, kept in the shape of the description's `if`s, so that a group
//! of registers that does not move costs one test.
//!
//! All values are of the state before the edge; order among items matters only where two store to one register.

use super::graph::{Cell, Op, ValueId};
use super::lower::Values;
use crate::netlist::{Driver, MemoryId, SignalId, Statement, Target};
use std::collections::BTreeSet;

/// One thing to do.
#[derive(Clone, Debug)]
pub(super) enum Item {
    /// Stores a value, into these bits of the word or (`None`) as the word.
    Store {
        target: SignalId,
        at: Option<u32>,
        value: ValueId,
    },
    /// Writes a word, if the address is inside the memory.
    Write {
        memory: MemoryId,
        address: ValueId,
        value: ValueId,
    },
    /// By one bit.
    Branch {
        condition: ValueId,
        then: Vec<Item>,
        otherwise: Vec<Item>,
    },
    /// By a word; labels differ.
    Switch {
        subject: ValueId,
        arms: Vec<(u128, Vec<Item>)>,
        otherwise: Vec<Item>,
    },
}

impl Item {
    /// Adds the cells that the item stores to.
    pub(super) fn writes(&self, out: &mut BTreeSet<Cell>) {
        let mut all = |list: &[Item]| list.iter().for_each(|i| i.writes(out));
        match self {
            Self::Store { target, .. } => {
                out.insert(Cell::Signal(*target));
            }
            Self::Write { memory, .. } => {
                out.insert(Cell::Memory(*memory));
            }
            Self::Branch {
                then, otherwise, ..
            } => {
                all(then);
                all(otherwise);
            }
            Self::Switch {
                arms, otherwise, ..
            } => {
                arms.iter().for_each(|a| all(&a.1));
                all(otherwise);
            }
        }
    }
}

/// Everything that an edge of the design does.
pub(super) fn edge(v: &mut Values<'_, '_>) -> Vec<Item> {
    let mut items = vec![];
    for p in 0..v.flat.processes.len() {
        items.extend(list(v, p, v.flat.processes[p].statements));
    }
    for m in (0..v.flat.memories.len() as u32).map(MemoryId) {
        memory(v, m, &mut items);
    }
    items
}

fn list(v: &mut Values<'_, '_>, p: usize, statements: &[Statement]) -> Vec<Item> {
    statements
        .iter()
        .filter_map(|s| statement(v, p, s))
        .collect()
}

fn statement(v: &mut Values<'_, '_>, p: usize, s: &Statement) -> Option<Item> {
    match s {
        Statement::Assign {
            target: Target::Wire(_),
            ..
        } => None,
        Statement::Assign {
            target,
            bits,
            value,
        } => {
            let target = v.flat.processes[p].target(target)?;
            let value = v.expression(p, value);
            let whole = v.flat.width(target) as u32 == v.graph.width(value);
            let at = bits.filter(|_| !whole).map(|b| b.at as u32);
            Some(Item::Store { target, at, value })
        }
        Statement::If {
            condition,
            then,
            otherwise,
        } => {
            let (then, otherwise) = (list(v, p, then), list(v, p, otherwise));
            if then.is_empty() && otherwise.is_empty() {
                return None;
            }
            let condition = v.expression(p, condition);
            Some(Item::Branch {
                condition,
                then,
                otherwise,
            })
        }
        Statement::Case {
            subject,
            arms,
            otherwise,
        } => {
            let otherwise = list(v, p, otherwise);
            let arms: Vec<(u128, Vec<Item>)> = arms
                .iter()
                .map(|a| (a.label, list(v, p, &a.body)))
                .collect();
            if otherwise.is_empty() && arms.iter().all(|a| a.1.is_empty()) {
                return None;
            }
            let subject = v.expression(p, subject);
            Some(Item::Switch {
                subject,
                arms,
                otherwise,
            })
        }
    }
}

/// The items under a condition, `None`: always.
fn under(condition: Option<ValueId>, item: Item) -> Item {
    match condition {
        None => item,
        Some(condition) => Item::Branch {
            condition,
            then: vec![item],
            otherwise: vec![],
        },
    }
}

fn memory(v: &mut Values<'_, '_>, id: MemoryId, items: &mut Vec<Item>) {
    let m = &v.flat.memories[id.index()];
    let (words, width) = (m.memory.words, m.memory.width as u32);
    if let Driver::Memory(_) = v.flat.driver(m.read_data) {
        if m.memory.read.clock.is_some() {
            let address = v.signal(m.read_address);
            let value = v.graph.add(Op::Word(id, address), width);
            let target = m.read_data;
            let at = None;
            let mut item = Item::Store { target, at, value };
            if !m.memory.outside_is_zero {
                item = under(inside(v, address, words), item);
            }
            let enable = m.read_enable.map(|e| v.signal(e));
            items.push(under(enable, item));
        }
    }
    if let Some([address, value, enable]) = m.write.map(|w| w.map(|s| v.signal(s))) {
        let memory = id;
        let item = Item::Write {
            memory,
            address,
            value,
        };
        items.push(under(Some(enable), item));
    }
}

/// Whether an address is inside a memory; `None` when it cannot be outside.
fn inside(v: &mut Values<'_, '_>, address: ValueId, words: usize) -> Option<ValueId> {
    let width = v.graph.width(address);
    if width < usize::BITS && 1 << width <= words {
        return None;
    }
    let words = v.graph.constant(words as u128, width);
    Some(v.graph.add(Op::Less(false, address, words), 1))
}
