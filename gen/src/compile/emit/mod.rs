//! Native code from a plan: regions become blocks, values are computed when the first step of their region asks.

mod access;
mod operation;

use super::graph::{Cell, Graph, Op, ValueId};
use super::layout::Layout;
use super::plan::{Plan, Region, Step};
use super::schedule::{schedule, Effect};
use cranelift_codegen::ir::{Block, InstBuilder, Value};
use cranelift_frontend::{FunctionBuilder, Switch};
use std::collections::BTreeSet;

/// Code under construction for one plan.
pub(super) struct Emitter<'a, 'f> {
    code: &'a mut FunctionBuilder<'f>,
    graph: &'a Graph,
    plan: &'a Plan,
    layout: &'a Layout,
    /// Address of the state.
    state: Value,
    /// Values computed on the way to here, and in which order.
    values: Vec<Option<Value>>,
    computed: Vec<ValueId>,
    /// Cells that may have been stored on the way to here.
    written: BTreeSet<Cell>,
    /// A value was computed behind a store to what it reads: the schedule is wrong.
    stale: Option<Cell>,
}

/// Appends the code of a plan to the current block. `Err` names a hazard that the schedule left, which none should.
pub(super) fn emit(
    code: &mut FunctionBuilder<'_>,
    state: Value,
    graph: &Graph,
    plan: &Plan,
    layout: &Layout,
) -> Result<(), String> {
    let mut e = Emitter {
        code,
        graph,
        plan,
        layout,
        state,
        values: vec![None; graph.len()],
        computed: vec![],
        written: BTreeSet::new(),
        stale: None,
    };
    e.region(0);
    match e.stale {
        None => Ok(()),
        Some(cell) => Err(format!("{cell:?} is read behind its store")),
    }
}

impl Emitter<'_, '_> {
    fn region(&mut self, region: Region) {
        let (plan, mark) = (self.plan, self.computed.len());
        let steps = &plan.regions[region].steps;
        let effects = steps.iter().map(|s| self.effect(s)).collect();
        for turn in schedule(effects) {
            for cell in turn.save {
                let inside = plan.readers(cell, region);
                self.compute(&inside);
            }
            let step = &steps[turn.step];
            self.compute(&self.wanted(step));
            self.step(step);
        }
        for v in self.computed.drain(mark..) {
            self.values[v.index()] = None;
        }
    }

    /// Values that a step wants from its region.
    fn wanted(&self, step: &Step) -> Vec<ValueId> {
        let plan = self.plan;
        let below = step.below();
        let below = below.iter().flat_map(|r| &plan.regions[*r].needs);
        step.uses().chain(below.copied()).collect()
    }

    /// These values and all that they rest on, as far as they are not computed, operands first.
    fn missing(&self, wanted: &[ValueId]) -> BTreeSet<ValueId> {
        let mut out = BTreeSet::new();
        let mut open = wanted.to_vec();
        while let Some(v) = open.pop() {
            let known = self.values[v.index()].is_some() || self.graph.code(v).is_some();
            if !known && out.insert(v) {
                open.extend(self.graph.op(v).operands());
            }
        }
        out
    }

    fn effect(&self, step: &Step) -> Effect {
        let mut e = Effect::default();
        for v in self.missing(&self.wanted(step)) {
            e.reads.extend(self.graph.op(v).cell());
        }
        for region in step.below() {
            e.reads.extend(&self.plan.regions[region].reads);
            e.writes.extend(&self.plan.regions[region].writes);
        }
        match step {
            Step::Store { target, .. } => {
                e.writes.insert(Cell::Signal(*target));
            }
            Step::Write { memory, .. } => {
                e.writes.insert(Cell::Memory(*memory));
            }
            _ => {}
        }
        e
    }

    fn compute(&mut self, wanted: &[ValueId]) {
        for v in self.missing(wanted) {
            if let Some(cell) = self.graph.op(v).cell() {
                if self.written.contains(&cell) {
                    self.stale = Some(cell);
                }
            }
            let value = self.operation(v);
            self.values[v.index()] = Some(value);
            self.computed.push(v);
        }
    }

    /// A computed value; constants are made where they are used.
    fn value(&mut self, v: ValueId) -> Value {
        match (self.graph.op(v), self.values[v.index()]) {
            (_, Some(value)) => value,
            (Op::Constant(code), None) => self.constant(code, self.graph.width(v)),
            // Operands are computed first, so this is not reached; the code would still be right.
            (_, None) => self.operation(v),
        }
    }

    fn step(&mut self, step: &Step) {
        match step {
            Step::Store { target, at, value } => {
                if let Some(slot) = self.layout.signal(*target) {
                    let bits = self.value(*value);
                    let word = match at {
                        None => bits,
                        Some(at) => {
                            let pending = self.load(slot);
                            let width = self.graph.width(*value);
                            self.insert((pending, slot.width), *at, (bits, width))
                        }
                    };
                    self.store(slot, word);
                }
                self.written.insert(Cell::Signal(*target));
            }
            Step::Keep(v) => {
                if let Some(slot) = self.layout.value(self.graph, *v) {
                    if !matches!(self.graph.op(*v), Op::Load(_)) {
                        let value = self.value(*v);
                        self.store(slot, value);
                    }
                }
            }
            Step::Write {
                memory,
                address,
                value,
            } => {
                let words = self.layout.memory(*memory);
                let (a, v) = (self.value(*address), self.value(*value));
                self.write(words, (a, self.graph.width(*address)), v);
                self.written.insert(Cell::Memory(*memory));
            }
            Step::Branch {
                condition,
                then,
                otherwise,
            } => {
                let condition = self.value(*condition);
                let end = self.code.create_block();
                let (t, o) = (self.entry(*then, end), self.entry(*otherwise, end));
                self.code.ins().brif(condition, t, &[], o, &[]);
                self.branches([(t, *then), (o, *otherwise)].into_iter(), end);
            }
            Step::Switch {
                subject,
                arms,
                otherwise,
            } => {
                let subject = self.value(*subject);
                let end = self.code.create_block();
                let mut switch = Switch::new();
                let mut blocks = vec![];
                for (label, region) in arms {
                    let block = self.entry(*region, end);
                    switch.set_entry(*label, block);
                    blocks.push((block, *region));
                }
                let rest = self.entry(*otherwise, end);
                blocks.push((rest, *otherwise));
                switch.emit(self.code, subject, rest);
                self.branches(blocks.into_iter(), end);
            }
        }
    }

    /// The block that a region begins with; an empty region has none of its own.
    fn entry(&mut self, region: Region, end: Block) -> Block {
        if self.plan.regions[region].steps.is_empty() {
            end
        } else {
            self.code.create_block()
        }
    }

    fn branches(&mut self, blocks: impl Iterator<Item = (Block, Region)>, end: Block) {
        let before = self.written.clone();
        let mut after = before.clone();
        for (block, region) in blocks.filter(|b| b.0 != end) {
            self.code.switch_to_block(block);
            self.region(region);
            self.code.ins().jump(end, &[]);
            after.extend(std::mem::replace(&mut self.written, before.clone()));
        }
        self.written = after;
        self.code.switch_to_block(end);
    }
}
