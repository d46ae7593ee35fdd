//! Puts together what hangs on one condition, across the whole hierarchy.
//!
//! A condition `a && b` without an alternative becomes `b` under `a`, and `x == constant` a choice by `x`, so that more
//! items share a test. An item moves up to an earlier one only over items that store to none of its registers.

use super::graph::{Cell, Graph, Op, ValueId};
use super::item::Item;
use crate::netlist::Operator;
use std::collections::BTreeSet;

/// The same effect with fewer tests.
pub(super) fn merge(g: &Graph, items: Vec<Item>) -> Vec<Item> {
    let mut out: Vec<(Item, BTreeSet<Cell>)> = vec![];
    for item in items.into_iter().flat_map(|i| split(g, i)) {
        let mut writes = BTreeSet::new();
        item.writes(&mut writes);
        if writes.is_empty() {
            continue;
        }
        let partner = (0..out.len())
            .rev()
            .find(|i| fit(&out[*i].0, &item))
            .filter(|i| out[i + 1..].iter().all(|o| o.1.is_disjoint(&writes)));
        match partner {
            Some(i) => {
                join(&mut out[i].0, item);
                out[i].1.extend(writes);
            }
            None => out.push((item, writes)),
        }
    }
    out.into_iter().map(|(item, _)| inner(g, item)).collect()
}

/// Merges inside an item; a switch with one label is a branch only in name and stays.
fn inner(g: &Graph, item: Item) -> Item {
    match item {
        Item::Branch {
            condition,
            then,
            otherwise,
        } => Item::Branch {
            condition,
            then: merge(g, then),
            otherwise: merge(g, otherwise),
        },
        Item::Switch {
            subject,
            arms,
            otherwise,
        } => Item::Switch {
            subject,
            arms: arms.into_iter().map(|(l, b)| (l, merge(g, b))).collect(),
            otherwise: merge(g, otherwise),
        },
        other => other,
    }
}

/// The item in its most mergeable shape.
fn split(g: &Graph, item: Item) -> Vec<Item> {
    match item {
        Item::Branch {
            condition,
            then,
            otherwise,
        } => branch(g, condition, then, otherwise),
        Item::Switch {
            subject,
            arms,
            otherwise,
        } => switch(g, subject, arms, otherwise),
        other => vec![other],
    }
}

fn branch(g: &Graph, condition: ValueId, then: Vec<Item>, otherwise: Vec<Item>) -> Vec<Item> {
    if let Some(code) = g.code(condition) {
        let taken = if code == 1 { then } else { otherwise };
        return taken.into_iter().flat_map(|i| split(g, i)).collect();
    }
    match g.op(condition) {
        Op::Not(inner) => branch(g, inner, otherwise, then),
        Op::Binary(Operator::And, a, b) if otherwise.is_empty() => {
            let inner = Item::Branch {
                condition: b,
                then,
                otherwise,
            };
            branch(g, a, vec![inner], vec![])
        }
        Op::Equal(subject, label) if g.code(label).is_some() => {
            let label = g.code(label).unwrap_or(0);
            switch(g, subject, vec![(label, then)], otherwise)
        }
        _ => vec![Item::Branch {
            condition,
            then,
            otherwise,
        }],
    }
}

fn switch(
    g: &Graph,
    subject: ValueId,
    mut arms: Vec<(u128, Vec<Item>)>,
    mut otherwise: Vec<Item>,
) -> Vec<Item> {
    if let Some(code) = g.code(subject) {
        let taken = arms.into_iter().find(|a| a.0 == code);
        let taken = taken.map_or(otherwise, |a| a.1);
        return taken.into_iter().flat_map(|i| split(g, i)).collect();
    }
    // `else if` chains over one word are one choice.
    while otherwise.len() == 1 {
        let rest = split(g, otherwise.remove(0));
        match <[Item; 1]>::try_from(rest) {
            Ok(
                [Item::Switch {
                    subject: s,
                    arms: more,
                    otherwise: rest,
                }],
            ) if s == subject => {
                for (label, body) in more {
                    if !arms.iter().any(|a| a.0 == label) {
                        arms.push((label, body));
                    }
                }
                otherwise = rest;
            }
            Ok([other]) => {
                otherwise = vec![other];
                break;
            }
            Err(several) => {
                otherwise = several;
                break;
            }
        }
    }
    vec![Item::Switch {
        subject,
        arms,
        otherwise,
    }]
}

/// Whether two items hang on the same choice.
fn fit(a: &Item, b: &Item) -> bool {
    match (a, b) {
        (Item::Branch { condition: a, .. }, Item::Branch { condition: b, .. }) => a == b,
        (
            Item::Switch {
                subject: a,
                otherwise: x,
                ..
            },
            Item::Switch {
                subject: b,
                otherwise: y,
                ..
            },
        ) => a == b && x.is_empty() && y.is_empty(),
        _ => false,
    }
}

/// Appends the second item, which fits, to the first.
fn join(into: &mut Item, item: Item) {
    match (into, item) {
        (
            Item::Branch {
                then, otherwise, ..
            },
            Item::Branch {
                then: t,
                otherwise: o,
                ..
            },
        ) => {
            then.extend(t);
            otherwise.extend(o);
        }
        (Item::Switch { arms, .. }, Item::Switch { arms: more, .. }) => {
            for (label, body) in more {
                match arms.iter_mut().find(|a| a.0 == label) {
                    Some(a) => a.1.extend(body),
                    None => arms.push((label, body)),
                }
            }
        }
        _ => {}
    }
}
