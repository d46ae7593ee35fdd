//! Where each value is computed: a tree of regions (branches) and, for every value, the regions that compute it.
//!
//! A value belongs to the innermost region that surrounds all its uses, so it is computed at most once and only when
//! some branch that uses it may be taken. Small values (a load, an addition of two loads) are computed in every region
//! that uses them instead: that is cheaper than to keep them.

use super::graph::{Cell, Graph, Op, ValueId};
use super::item::Item;
use crate::netlist::{MemoryId, SignalId};
use std::collections::{BTreeMap, BTreeSet};

/// Nodes in a value that is computed wherever it is used.
const SMALL: u32 = 4;
/// Most places in which a small value is computed.
const PLACES: usize = 16;

/// A region; 0 is the whole.
pub(super) type Region = usize;

/// An [`Item`] whose branches are regions.
#[derive(Clone, Debug)]
pub(super) enum Step {
    Store {
        target: SignalId,
        at: Option<u32>,
        value: ValueId,
    },
    /// Stores a value where the layout keeps it.
    Keep(ValueId),
    Write {
        memory: MemoryId,
        address: ValueId,
        value: ValueId,
    },
    Branch {
        condition: ValueId,
        then: Region,
        otherwise: Region,
    },
    Switch {
        subject: ValueId,
        arms: Vec<(u128, Region)>,
        otherwise: Region,
    },
}

impl Step {
    /// Values that the step itself uses.
    pub(super) fn uses(&self) -> impl Iterator<Item = ValueId> {
        let (a, b) = match *self {
            Self::Store { value, .. } | Self::Keep(value) => (value, None),
            Self::Write { address, value, .. } => (address, Some(value)),
            Self::Branch { condition, .. } => (condition, None),
            Self::Switch { subject, .. } => (subject, None),
        };
        [Some(a), b].into_iter().flatten()
    }

    /// Regions below the step.
    pub(super) fn below(&self) -> Vec<Region> {
        match self {
            Self::Branch {
                then, otherwise, ..
            } => vec![*then, *otherwise],
            Self::Switch {
                arms, otherwise, ..
            } => arms.iter().map(|a| a.1).chain([*otherwise]).collect(),
            _ => vec![],
        }
    }
}

/// A region.
#[derive(Debug, Default)]
pub(super) struct Node {
    parent: Region,
    depth: u32,
    /// What it does.
    pub(super) steps: Vec<Step>,
    /// Values used inside and computed outside.
    pub(super) needs: BTreeSet<ValueId>,
    /// Cells read by values computed in it or below.
    pub(super) reads: BTreeSet<Cell>,
    /// Cells stored in it or below.
    pub(super) writes: BTreeSet<Cell>,
}

/// Regions with their values.
#[derive(Debug, Default)]
pub(super) struct Plan {
    pub(super) regions: Vec<Node>,
    /// Values that read each cell, and the regions that compute them.
    readers: BTreeMap<Cell, Vec<(ValueId, Vec<Region>)>>,
}

impl Plan {
    /// A plan of what an edge does.
    pub(super) fn edge(g: &Graph, items: &[Item]) -> Self {
        let mut plan = Self::default();
        plan.regions.push(Node::default());
        plan.fill(0, items);
        plan.place(g);
        plan
    }

    /// A plan that computes values and keeps them.
    pub(super) fn keep(g: &Graph, values: &[ValueId]) -> Self {
        let mut plan = Self::default();
        plan.regions.push(Node::default());
        plan.regions[0].steps = values.iter().map(|v| Step::Keep(*v)).collect();
        plan.place(g);
        plan
    }

    fn region(&mut self, parent: Region, items: &[Item]) -> Region {
        let id = self.regions.len();
        self.regions.push(Node {
            parent,
            depth: self.regions[parent].depth + 1,
            ..Node::default()
        });
        self.fill(id, items);
        id
    }

    fn fill(&mut self, id: Region, items: &[Item]) {
        for item in items {
            let step = match item {
                Item::Store { target, at, value } => Step::Store {
                    target: *target,
                    at: *at,
                    value: *value,
                },
                Item::Write {
                    memory,
                    address,
                    value,
                } => Step::Write {
                    memory: *memory,
                    address: *address,
                    value: *value,
                },
                Item::Branch {
                    condition,
                    then,
                    otherwise,
                } => Step::Branch {
                    condition: *condition,
                    then: self.region(id, then),
                    otherwise: self.region(id, otherwise),
                },
                Item::Switch {
                    subject,
                    arms,
                    otherwise,
                } => Step::Switch {
                    subject: *subject,
                    arms: arms.iter().map(|(l, b)| (*l, self.region(id, b))).collect(),
                    otherwise: self.region(id, otherwise),
                },
            };
            let mut writes = BTreeSet::new();
            item.writes(&mut writes);
            self.regions[id].writes.extend(writes);
            self.regions[id].steps.push(step);
        }
    }

    /// The innermost region around both.
    fn around(&self, mut a: Region, mut b: Region) -> Region {
        while a != b {
            if self.regions[a].depth < self.regions[b].depth {
                std::mem::swap(&mut a, &mut b);
            }
            a = self.regions[a].parent;
        }
        a
    }

    fn inside(&self, mut inner: Region, outer: Region) -> bool {
        while self.regions[inner].depth > self.regions[outer].depth {
            inner = self.regions[inner].parent;
        }
        inner == outer
    }

    /// The regions that compute a value, from those that use it.
    fn places(&self, mut uses: Vec<Region>, small: bool) -> Vec<Region> {
        uses.sort_unstable();
        uses.dedup();
        if uses.len() > 1 && (!small || uses.len() > PLACES) {
            let first = uses[0];
            return vec![uses.iter().fold(first, |a, b| self.around(a, *b))];
        }
        let all = uses.clone();
        uses.retain(|u| !all.iter().any(|o| o != u && self.inside(*u, *o)));
        uses
    }

    fn place(&mut self, g: &Graph) {
        let mut size = vec![0_u32; g.len()];
        for v in (0..g.len() as u32).map(ValueId) {
            let own = match g.op(v) {
                Op::Constant(_) => 0,
                Op::Word(..) => SMALL + 1,
                _ => 1,
            };
            let of = g.op(v).operands();
            size[v.index()] = of.fold(own, |n, o| n.saturating_add(size[o.index()]));
        }
        let mut uses: Vec<Vec<Region>> = vec![vec![]; g.len()];
        for (id, region) in self.regions.iter().enumerate() {
            for v in region.steps.iter().flat_map(Step::uses) {
                uses[v.index()].push(id);
            }
        }
        for v in (0..g.len() as u32).rev().map(ValueId) {
            let used = std::mem::take(&mut uses[v.index()]);
            let op = g.op(v);
            if used.is_empty() || matches!(op, Op::Constant(_)) {
                continue;
            }
            let at = self.places(used.clone(), size[v.index()] <= SMALL);
            for user in used {
                self.need(v, user, &at);
            }
            for operand in op.operands() {
                uses[operand.index()].extend(&at);
            }
            if let Some(cell) = op.cell() {
                for region in &at {
                    self.read(cell, *region);
                }
                self.readers.entry(cell).or_default().push((v, at));
            }
        }
    }

    /// Values that read a cell and are computed in a region or below.
    pub(super) fn readers(&self, cell: Cell, region: Region) -> Vec<ValueId> {
        let all = self.readers.get(&cell).map_or(&[][..], Vec::as_slice);
        let inside = all
            .iter()
            .filter(|(_, at)| at.iter().any(|r| self.inside(*r, region)));
        inside.map(|(v, _)| *v).collect()
    }

    /// Notes that regions from `user` up to the one that computes `v` take it from outside.
    fn need(&mut self, v: ValueId, user: Region, places: &[Region]) {
        let mut at = user;
        while !places.contains(&at) {
            if !self.regions[at].needs.insert(v) {
                return;
            }
            at = self.regions[at].parent;
        }
    }

    /// Notes that a region and those around it read a cell.
    fn read(&mut self, cell: Cell, mut region: Region) {
        while self.regions[region].reads.insert(cell) && region != 0 {
            region = self.regions[region].parent;
        }
    }
}
