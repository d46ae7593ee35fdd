//! The order of a region's steps, so that registers can be stored in place: whoever reads an old value goes before
//! whoever stores the new one. Where two steps each read what the other stores, the old values are loaded first.
//!
//! Reads of a step: loads (and memory words) in the values it needs from its region or above that are not computed
//! yet, and everything computed in the regions below it. Steps that store to one cell keep their order.

use super::graph::Cell;
use std::collections::{BTreeMap, BTreeSet};

/// What a step reads and stores.
#[derive(Debug, Default)]
pub(super) struct Effect {
    pub(super) reads: BTreeSet<Cell>,
    pub(super) writes: BTreeSet<Cell>,
}

/// A step in its turn, and the cells whose old values must be taken before it for steps behind it.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Turn {
    pub(super) step: usize,
    pub(super) save: Vec<Cell>,
}

/// The order of steps with these effects.
pub(super) fn schedule(mut effects: Vec<Effect>) -> Vec<Turn> {
    let n = effects.len();
    let mut readers: BTreeMap<Cell, BTreeSet<usize>> = BTreeMap::new();
    let mut writers: BTreeMap<Cell, Vec<usize>> = BTreeMap::new();
    for (i, e) in effects.iter().enumerate() {
        for c in &e.writes {
            writers.entry(*c).or_default().push(i);
        }
    }
    if writers.is_empty() {
        return (0..n).map(|step| Turn { step, save: vec![] }).collect();
    }
    for (i, e) in effects.iter_mut().enumerate() {
        // What nobody stores is no hazard.
        e.reads.retain(|c| writers.contains_key(c));
        for c in &e.reads {
            readers.entry(*c).or_default().insert(i);
        }
    }
    let conflicts = |j: usize, e: &Effect, readers: &BTreeMap<Cell, BTreeSet<usize>>| {
        let of = |c: &Cell| {
            readers
                .get(c)
                .map_or(0, |r| r.len() - usize::from(r.contains(&j)))
        };
        e.writes.iter().map(of).sum::<usize>()
    };
    let mut count: Vec<usize> = (0..n)
        .map(|j| conflicts(j, &effects[j], &readers))
        .collect();
    let mut done = vec![false; n];
    let mut out = Vec::with_capacity(n);
    for _ in 0..n {
        let free = |j: &usize| {
            !done[*j]
                && effects[*j]
                    .writes
                    .iter()
                    .all(|c| writers[c].iter().find(|w| !done[**w]) == Some(j))
        };
        let Some(step) = (0..n).filter(free).min_by_key(|j| count[*j]) else {
            break;
        };
        done[step] = true;
        let mut save = vec![];
        for c in &effects[step].writes {
            let Some(r) = readers.get_mut(c) else {
                continue;
            };
            let others = r.iter().any(|i| *i != step);
            if others {
                save.push(*c);
            }
            // Saved or read by this step alone: nobody reads the cell from memory any more.
            r.clear();
        }
        for c in &effects[step].reads {
            if let Some(r) = readers.get_mut(c) {
                r.remove(&step);
            }
        }
        for c in effects[step].reads.iter().chain(&effects[step].writes) {
            for j in writers.get(c).into_iter().flatten() {
                count[*j] = conflicts(*j, &effects[*j], &readers);
            }
        }
        out.push(Turn { step, save });
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::netlist::SignalId;

    fn effect(reads: &[u32], writes: &[u32]) -> Effect {
        let cells = |list: &[u32]| list.iter().map(|i| Cell::Signal(SignalId(*i))).collect();
        Effect {
            reads: cells(reads),
            writes: cells(writes),
        }
    }

    fn order(effects: Vec<Effect>) -> (Vec<usize>, usize) {
        let turns = schedule(effects);
        let saved = turns.iter().map(|t| t.save.len()).sum();
        (turns.iter().map(|t| t.step).collect(), saved)
    }

    #[test]
    fn a_shift_register_runs_from_its_end() {
        let stages = vec![effect(&[0], &[1]), effect(&[1], &[2]), effect(&[2], &[3])];
        assert_eq!(order(stages), (vec![2, 1, 0], 0));
    }

    #[test]
    fn an_exchange_saves_one_value() {
        let turns = schedule(vec![effect(&[0], &[1]), effect(&[1], &[0])]);
        assert_eq!(turns[0].save, vec![Cell::Signal(SignalId(1))]);
        assert!(turns[1].save.is_empty());
    }

    #[test]
    fn stores_to_one_register_keep_their_order() {
        let stores = vec![effect(&[7], &[1]), effect(&[1], &[2]), effect(&[], &[1])];
        assert_eq!(order(stores), (vec![1, 0, 2], 0));
        // The first store precedes the reader for its sake: the old value is saved.
        let stores = vec![effect(&[2], &[1]), effect(&[1], &[2]), effect(&[], &[1])];
        assert_eq!(order(stores).1, 1);
    }
}
