//! From the flat design to the value graph: one value per signal.

use super::graph::{Graph, Op, ValueId};
use crate::netlist::{
    Comparison, Driver, Expression, Flat, Name, Node, Process, SignalId, Statement,
};
use std::collections::HashMap;

/// The design as values.
pub(super) struct Values<'f, 'm> {
    pub(super) flat: &'f Flat<'m>,
    pub(super) graph: Graph,
    /// The value of every signal that has one (clocks have none).
    of: Vec<Option<ValueId>>,
}

impl<'f, 'm> Values<'f, 'm> {
    /// Values of all signals.
    pub(super) fn new(flat: &'f Flat<'m>) -> Self {
        let mut v = Self {
            flat,
            graph: Graph::default(),
            of: vec![None; flat.signals.len()],
        };
        for id in (0..flat.signals.len() as u32).map(SignalId) {
            let width = flat.width(id) as u32;
            let op = match flat.signals[id.index()].driver {
                Driver::Input | Driver::Register(_) => Op::Load(id),
                Driver::Constant(code) => Op::Constant(code),
                Driver::Memory(m) if flat.memories[m.index()].memory.read.clock.is_some() => {
                    Op::Load(id)
                }
                _ => continue,
            };
            v.of[id.index()] = Some(v.graph.node(op, width));
        }
        let drivers: Vec<_> = flat.processes.iter().map(by_target).collect();
        for id in &flat.order {
            let value = match flat.signals[id.index()].driver {
                Driver::Process(p) => {
                    let statements = drivers[p].get(id).map_or(&[][..], Vec::as_slice);
                    let mut value = None;
                    for s in statements {
                        value = v.after(p, s, *id, value);
                    }
                    value
                }
                Driver::Memory(m) => {
                    let address = v.signal(flat.memories[m.index()].read_address);
                    let width = flat.width(*id) as u32;
                    Some(v.graph.add(Op::Word(m, address), width))
                }
                _ => None,
            };
            v.of[id.index()] = value;
        }
        v
    }

    /// The value of a signal. Clocks, which no expression reads, count as zero.
    pub(super) fn signal(&mut self, id: SignalId) -> ValueId {
        let id = self.flat.resolve(id);
        match self.of[id.index()] {
            Some(v) => v,
            None => self.graph.constant(0, self.flat.width(id) as u32),
        }
    }

    fn name(&mut self, process: usize, name: &Name) -> ValueId {
        let id = self.flat.processes[process].scope[name];
        self.signal(id)
    }

    /// The value of `target` behind a statement, from that before it.
    fn after(
        &mut self,
        process: usize,
        s: &Statement,
        target: SignalId,
        before: Option<ValueId>,
    ) -> Option<ValueId> {
        match s {
            Statement::Assign {
                target: t,
                bits,
                value,
            } => {
                if self.flat.processes[process].target(t) != Some(target) {
                    return before;
                }
                let value = self.expression(process, value);
                let Some(bits) = bits else { return Some(value) };
                let width = self.flat.width(target) as u32;
                let word = before.unwrap_or_else(|| self.graph.constant(0, width));
                Some(
                    self.graph
                        .add(Op::Insert(word, bits.at as u32, value), width),
                )
            }
            Statement::If {
                condition,
                then,
                otherwise,
            } => {
                let a = self.list(process, then, target, before);
                let b = self.list(process, otherwise, target, before);
                if a == b {
                    return a;
                }
                let c = self.expression(process, condition);
                self.choice(c, a, b)
            }
            Statement::Case {
                subject,
                arms,
                otherwise,
            } => {
                let mut value = self.list(process, otherwise, target, before);
                for a in arms.iter().rev() {
                    let body = self.list(process, &a.body, target, before);
                    if body == value {
                        continue;
                    }
                    let c = self.label(process, subject, a.label);
                    value = self.choice(c, body, value);
                }
                value
            }
        }
    }

    /// Elaboration has seen to it that both paths end with a value; until then one may have none.
    fn choice(&mut self, c: ValueId, a: Option<ValueId>, b: Option<ValueId>) -> Option<ValueId> {
        let (Some(a), Some(b)) = (a, b) else {
            return a.or(b);
        };
        let width = self.graph.width(a);
        Some(self.graph.add(Op::Choose(c, a, b), width))
    }

    fn list(
        &mut self,
        process: usize,
        list: &[Statement],
        target: SignalId,
        before: Option<ValueId>,
    ) -> Option<ValueId> {
        list.iter()
            .fold(before, |value, s| self.after(process, s, target, value))
    }

    /// Whether a word has this code.
    fn label(&mut self, process: usize, subject: &Expression, label: u128) -> ValueId {
        let s = self.expression(process, subject);
        let width = self.graph.width(s);
        let label = self.graph.constant(label, width);
        self.graph.add(Op::Equal(s, label), 1)
    }

    /// The value of an expression.
    pub(super) fn expression(&mut self, process: usize, e: &Expression) -> ValueId {
        let width = e.width() as u32;
        let mut of = |e: &Expression| self.expression(process, e);
        let op = match &e.node {
            Node::Literal(code) => Op::Constant(*code),
            Node::Read(name) => return self.name(process, name),
            Node::Reformat(a) => return of(a),
            Node::Not(a) => Op::Not(of(a)),
            Node::Negate(a) => Op::Negate(of(a)),
            Node::Reduce(r, a) => Op::Reduce(*r, of(a)),
            Node::Binary(operator, a, b) => Op::Binary(*operator, of(a), of(b)),
            Node::Compare(c, a, b) => {
                let signed = a.format.signed();
                let (a, b) = (of(a), of(b));
                let (op, negated) = match c {
                    Comparison::Equal => (Op::Equal(a, b), false),
                    Comparison::NotEqual => (Op::Equal(a, b), true),
                    Comparison::Less => (Op::Less(signed, a, b), false),
                    Comparison::GreaterEqual => (Op::Less(signed, a, b), true),
                    Comparison::Greater => (Op::Less(signed, b, a), false),
                    Comparison::LessEqual => (Op::Less(signed, b, a), true),
                };
                let value = self.graph.add(op, 1);
                return if negated {
                    self.graph.not(value)
                } else {
                    value
                };
            }
            Node::Product(a, b) => Op::Product(a.format.signed(), of(a), of(b)),
            Node::ShiftLeft(a, b) => Op::ShiftLeft(of(a), of(b)),
            Node::ShiftRight(a, b) => Op::ShiftRight(of(a), of(b)),
            Node::Slice(a, at) => Op::Slice(of(a), *at as u32),
            Node::Select(a, position) => {
                let (a, position) = (of(a), of(position));
                let whole = self.graph.width(a);
                let moved = self.graph.add(Op::ShiftRight(a, position), whole);
                Op::Slice(moved, 0)
            }
            Node::Resize(a) => {
                let (value, signed) = (of(a), a.format.signed());
                return self.graph.resize(value, signed, width);
            }
            Node::Append(a, n) => {
                let a = of(a);
                let a = self.graph.resize(a, false, width);
                let n = self.graph.constant(*n as u128, 8);
                Op::ShiftLeft(a, n)
            }
            Node::ReplaceBit(a, position, bit) => Op::ReplaceBit(of(a), of(position), of(bit)),
        };
        self.graph.add(op, width)
    }
}

/// The statements of a process that assign each of its targets.
fn by_target<'m>(process: &Process<'m>) -> HashMap<SignalId, Vec<&'m Statement>> {
    let mut out: HashMap<SignalId, Vec<&Statement>> = HashMap::new();
    for s in process.statements {
        s.each_target(&mut |target| {
            if let Some(id) = process.target(target) {
                let list = out.entry(id).or_default();
                if !list.last().is_some_and(|l| std::ptr::eq(*l, s)) {
                    list.push(s);
                }
            }
        });
    }
    out
}
