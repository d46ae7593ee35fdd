//! Makes random designs: hierarchy, registers, memories, `if`s, cases, partial assignments, every kind of expression.

use super::build::*;
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_gen::netlist::{
    Arm, Bits, Body, Comparison, Expression, Format, Memory, Module, Name, Node, Operator,
    ReadPort, Reduction, SignalKind, Statement, WritePort,
};

const WIDTHS: [usize; 14] = [1, 1, 2, 3, 8, 9, 16, 31, 32, 33, 63, 64, 65, 128];

fn ones(width: usize) -> u128 {
    u128::MAX >> (128 - width)
}

/// Names that an expression may read.
type Scope = Vec<(Name, Format)>;

/// A source of designs; equal seeds give equal designs.
pub struct Maker {
    r: StdRng,
}

impl Maker {
    pub fn new(seed: u64) -> Self {
        let r = StdRng::seed_from_u64(seed);
        Self { r }
    }

    fn one_in(&mut self, n: u32) -> bool {
        self.r.random_ratio(1, n)
    }

    fn format(&mut self) -> Format {
        let width = WIDTHS[self.r.random_range(0..WIDTHS.len())];
        match self.r.random_range(0..4) {
            0 if width > 2 => Format::Fixed(width - 2, 1),
            0 | 1 => Format::Signed(width),
            2 if width == 1 => Format::Bit,
            _ => Format::Unsigned(width),
        }
    }

    /// A code of a width, often an extreme one.
    pub fn code(&mut self, width: usize) -> u128 {
        match self.r.random_range(0..4) {
            0 => self.r.random_range(0..4) & ones(width),
            1 => ones(width),
            _ => self.r.random::<u128>() & ones(width),
        }
    }

    /// A leaf: a name of the format if there is one, or another resized, or a literal.
    fn leaf(&mut self, f: Format, scope: &Scope) -> Expression {
        let fitting: Vec<_> = scope.iter().filter(|s| s.1 == f).collect();
        if !fitting.is_empty() && !self.one_in(5) {
            let (name, f) = fitting[self.r.random_range(0..fitting.len())].clone();
            return read(name, f);
        }
        if scope.is_empty() || self.one_in(6) {
            return Expression::literal(self.code(f.width()), f);
        }
        let (name, from) = scope[self.r.random_range(0..scope.len())].clone();
        Expression::new(f, Node::Resize(Box::new(read(name, from))))
    }

    fn unsigned(&mut self) -> Format {
        Format::Unsigned(self.format().width())
    }

    fn expression(&mut self, f: Format, depth: u32, scope: &Scope) -> Expression {
        if depth == 0 {
            return self.leaf(f, scope);
        }
        let w = f.width();
        let of = |m: &mut Self, f: Format| Box::new(m.expression(f, depth - 1, scope));
        let node = match self.r.random_range(0..16) {
            0 => Node::Not(of(self, f)),
            1 => Node::Negate(of(self, f)),
            2 | 3 => {
                let op = [
                    Operator::Add,
                    Operator::Subtract,
                    Operator::And,
                    Operator::Or,
                ];
                let op = op[self.r.random_range(0..4)];
                Node::Binary(op, of(self, f), of(self, f))
            }
            4 => Node::Binary(Operator::Xor, of(self, f), of(self, f)),
            5 if w == 1 => {
                let how = [Reduction::All, Reduction::Any, Reduction::Parity];
                let from = self.format();
                Node::Reduce(how[self.r.random_range(0..3)], of(self, from))
            }
            6..=8 if w == 1 => {
                let how = [
                    Comparison::Equal,
                    Comparison::NotEqual,
                    Comparison::Less,
                    Comparison::LessEqual,
                    Comparison::Greater,
                    Comparison::GreaterEqual,
                ];
                let from = self.format();
                let how = how[self.r.random_range(0..6)];
                Node::Compare(how, of(self, from), of(self, from))
            }
            5 if w > 1 => {
                let a = self.r.random_range(1..w);
                let signed = self.r.random();
                let part = |w| match signed {
                    true => Format::Signed(w),
                    false => Format::Unsigned(w),
                };
                Node::Product(of(self, part(a)), of(self, part(w - a)))
            }
            6 if w > 1 => {
                let n = self.r.random_range(1..w);
                Node::Append(of(self, Format::Unsigned(w - n)), n)
            }
            9 => {
                let by = self.unsigned();
                Node::ShiftLeft(of(self, f), of(self, by))
            }
            10 => {
                let by = self.unsigned();
                Node::ShiftRight(of(self, f), of(self, by))
            }
            11 => {
                let whole = self.r.random_range(w..=128);
                let at = self.r.random_range(0..=whole - w);
                Node::Slice(of(self, Format::Signed(whole)), at)
            }
            12 => {
                let whole = self.r.random_range(w..=128);
                let at = self.unsigned();
                Node::Select(of(self, Format::Unsigned(whole)), of(self, at))
            }
            13 => {
                let at = self.unsigned();
                Node::ReplaceBit(of(self, f), of(self, at), of(self, Format::Bit))
            }
            14 => Node::Reformat(of(self, Format::Signed(w))),
            _ => {
                let from = self.format();
                Node::Resize(of(self, from))
            }
        };
        Expression::new(f, node)
    }

    fn value(&mut self, f: Format, scope: &Scope) -> Expression {
        let depth = self.r.random_range(0..4);
        self.expression(f, depth, scope)
    }

    /// Statements that assign targets; all of them on every path unless `sparse`.
    fn block(
        &mut self,
        targets: &Scope,
        depth: u32,
        sparse: bool,
        scope: &Scope,
    ) -> Vec<Statement> {
        let mut out = vec![];
        if depth > 0 && self.one_in(2) {
            if !sparse && self.one_in(2) {
                out.extend(self.block(targets, 0, false, scope));
            }
            let all_paths = !sparse && out.is_empty();
            let inner = !all_paths;
            if self.one_in(3) {
                let subject = self.format();
                let subject = self.value(subject, scope);
                let mut arms: Vec<Arm> = vec![];
                for _ in 0..self.r.random_range(1..4) {
                    let label = self.code(subject.width());
                    if arms.iter().all(|a| a.label != label) {
                        let body = self.block(targets, depth - 1, inner, scope);
                        let name = String::new();
                        arms.push(Arm { label, name, body });
                    }
                }
                let otherwise = self.block(targets, depth - 1, inner, scope);
                out.push(Statement::Case {
                    subject,
                    arms,
                    otherwise,
                });
            } else {
                let then = self.block(targets, depth - 1, inner, scope);
                let otherwise = if inner && self.one_in(2) {
                    vec![]
                } else {
                    self.block(targets, depth - 1, inner, scope)
                };
                out.push(Statement::If {
                    condition: self.value(Format::Bit, scope),
                    then,
                    otherwise,
                });
            }
            return out;
        }
        for (name, f) in targets {
            if sparse && self.one_in(3) {
                continue;
            }
            let w = f.width();
            if w > 1 && self.one_in(3) {
                let cut = self.r.random_range(1..w);
                for (at, width) in [(0, cut), (cut, w - cut)] {
                    if !(sparse && self.one_in(3)) {
                        let value = self.value(Format::Unsigned(width), scope);
                        out.push(part(name.clone(), Some(Bits { at, width }), value));
                    }
                }
            } else {
                out.push(assign(name.clone(), self.value(*f, scope)));
            }
        }
        out
    }

    fn memory(&mut self) -> Module {
        let words = self.r.random_range(1..20);
        let least = usize::BITS as usize - (words - 1_usize).leading_zeros() as usize;
        let bits = self.r.random_range(least.max(1)..least + 3);
        let address = match self.one_in(4) {
            true => Format::Unsigned([33, 65, 128][self.r.random_range(0..3)]),
            false => Format::Unsigned(bits),
        };
        let word = self.unsigned();
        let clocked = !self.one_in(3);
        let written = self.one_in(2);
        let clock = || "clock".to_string();
        let enable = (clocked && self.one_in(2)).then(|| "enable".to_string());
        let initial = self.r.random_range(0..=words);
        let m = Memory {
            words,
            width: word.width(),
            initial: (0..initial).map(|_| self.code(word.width())).collect(),
            outside_is_zero: !clocked || self.r.random(),
            read: ReadPort {
                address: "address".into(),
                data: "data".into(),
                enable,
                clock: clocked.then(clock),
            },
            write: written.then(|| WritePort {
                address: "write_address".into(),
                data: "write_data".into(),
                enable: "write_enable".into(),
                clock: clock(),
            }),
        };
        memory("memory", address, word, m)
    }

    /// A module whose instances nest up to this depth.
    pub fn module(&mut self, depth: u32) -> Module {
        let mut m = clocked("random");
        let mut scope: Scope = vec![];
        for i in 0..self.r.random_range(1..4) {
            let f = self.format();
            signal(&mut m, &format!("i{i}"), SignalKind::Input, f);
            scope.push((wire(&format!("i{i}")), f));
        }
        for i in 0..self.r.random_range(0..2) {
            let f = self.format();
            let kind = SignalKind::Constant(self.code(f.width()));
            signal(&mut m, &format!("k{i}"), kind, f);
            scope.push((wire(&format!("k{i}")), f));
        }
        let mut registers: Scope = vec![];
        for i in 0..self.r.random_range(0..6) {
            let f = self.format();
            let name = format!("r{i}");
            let initial = self.code(f.width());
            register(&mut m, &name, f, initial);
            registers.push((held(&name), f));
        }
        scope.extend(registers.iter().cloned());
        let mut statements = vec![];
        // Wires and instances in turn: each sees what was before it.
        for i in 0..self.r.random_range(1..7) {
            if self.one_in(3) && depth > 0 {
                let inner = match self.one_in(3) {
                    true => self.memory(),
                    false => self.module(depth - 1),
                };
                let name = format!("c{i}");
                let mut inputs: Scope = vec![];
                let mut outputs: Scope = vec![];
                for s in &inner.signals {
                    let there = (port(&name, &s.name), s.format);
                    match s.kind {
                        SignalKind::Input if s.format == Format::Clock => {
                            statements.push(assign(there.0, read(wire("clock"), Format::Clock)));
                        }
                        SignalKind::Input => inputs.push(there),
                        SignalKind::Output => outputs.push(there),
                        _ => {}
                    }
                }
                child(&mut m, &name, inner);
                statements.extend(self.block(&inputs, 2, false, &scope));
                scope.extend(outputs);
            } else {
                let mut group: Scope = vec![];
                for j in 0..self.r.random_range(1..4) {
                    let f = self.format();
                    let name = format!("w{i}_{j}");
                    let kind = match self.one_in(3) {
                        true => SignalKind::Output,
                        false => SignalKind::Local,
                    };
                    signal(&mut m, &name, kind, f);
                    group.push((wire(&name), f));
                }
                statements.extend(self.block(&group, 3, false, &scope));
                scope.extend(group);
            }
        }
        let f = self.format();
        signal(&mut m, "o", SignalKind::Output, f);
        statements.push(assign(wire("o"), self.value(f, &scope)));
        for _ in 0..self.r.random_range(0..4) {
            statements.extend(self.block(&registers, 3, true, &scope));
        }
        m.body = Body::Statements(statements);
        m
    }
}
