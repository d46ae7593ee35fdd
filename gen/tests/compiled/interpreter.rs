//! A netlist interpreted as its doc comments say: values in u128, wires by repeating all statements until nothing
//! changes. It shares nothing with the compiled simulation but the netlist's types.

use shadegate_gen::netlist::{
    Body, Comparison, Expression, Format, Memory, Module, Name, Node, Operator, Reduction,
    SignalKind, Statement, Target,
};
use std::collections::BTreeMap;

/// Values by dotted name.
type Values = BTreeMap<String, u128>;

/// A design and its state.
pub struct Interpreter<'a> {
    top: &'a Module,
    pub registers: Values,
    pub wires: Values,
    pub memories: BTreeMap<String, Vec<u128>>,
}

fn join(path: &str, name: &str) -> String {
    match path {
        "" => name.to_string(),
        _ => format!("{path}.{name}"),
    }
}

fn full(path: &str, name: &Name) -> String {
    match name {
        Name::Signal(s) | Name::Register(s) => join(path, s),
        Name::Port { child, port } => join(path, &format!("{child}.{port}")),
    }
}

fn ones(width: usize) -> u128 {
    if width == 128 {
        u128::MAX
    } else {
        (1 << width) - 1
    }
}

/// The number that a code stands for. Unsigned codes of 128 bits are never compared through this.
fn number(code: u128, format: Format) -> i128 {
    let width = format.width();
    let negative = format.signed() && code >> (width - 1) & 1 == 1;
    if negative {
        (code | !ones(width)) as i128
    } else {
        code as i128
    }
}

fn compare(c: Comparison, a: u128, b: u128, format: Format) -> bool {
    let order = if format.signed() {
        number(a, format).cmp(&number(b, format))
    } else {
        a.cmp(&b)
    };
    match c {
        Comparison::Equal => order.is_eq(),
        Comparison::NotEqual => order.is_ne(),
        Comparison::Less => order.is_lt(),
        Comparison::LessEqual => order.is_le(),
        Comparison::Greater => order.is_gt(),
        Comparison::GreaterEqual => order.is_ge(),
    }
}

fn evaluate(e: &Expression, value: &impl Fn(&Name) -> u128) -> u128 {
    let of = |e: &Expression| evaluate(e, value);
    let width = e.width();
    let bit = u128::from;
    let code = match &e.node {
        Node::Literal(code) => *code,
        Node::Read(name) => value(name),
        Node::Not(a) => !of(a),
        Node::Negate(a) => 0u128.wrapping_sub(of(a)),
        Node::Reduce(Reduction::All, a) => bit(of(a) == ones(a.width())),
        Node::Reduce(Reduction::Any, a) => bit(of(a) > 0),
        Node::Reduce(Reduction::Parity, a) => bit(of(a).count_ones() & 1 == 1),
        Node::Binary(Operator::Add, a, b) => of(a).wrapping_add(of(b)),
        Node::Binary(Operator::Subtract, a, b) => of(a).wrapping_sub(of(b)),
        Node::Binary(Operator::And, a, b) => of(a) & of(b),
        Node::Binary(Operator::Or, a, b) => of(a) | of(b),
        Node::Binary(Operator::Xor, a, b) => of(a) ^ of(b),
        Node::Compare(c, a, b) => bit(compare(*c, of(a), of(b), a.format)),
        Node::Product(a, b) => {
            number(of(a), a.format).wrapping_mul(number(of(b), b.format)) as u128
        }
        Node::ShiftLeft(a, n) => match of(n) {
            n if n >= width as u128 => 0,
            n => of(a) << n,
        },
        Node::ShiftRight(a, n) => match of(n) {
            n if n >= width as u128 => 0,
            n => of(a) >> n,
        },
        Node::Slice(a, at) => of(a) >> at,
        Node::Select(a, at) => match of(at) {
            at if at >= a.width() as u128 => 0,
            at => of(a) >> at,
        },
        Node::Resize(a) => number(of(a), a.format) as u128,
        Node::Reformat(a) => of(a),
        Node::Append(a, n) => of(a) << n,
        Node::ReplaceBit(a, at, b) => match of(at) {
            at if at >= width as u128 => of(a),
            at => of(a) & !(1 << at) | of(b) << at,
        },
    };
    code & ones(width)
}

impl<'a> Interpreter<'a> {
    /// At power-up, inputs zero, settled.
    pub fn new(top: &'a Module) -> Self {
        let mut i = Self {
            top,
            registers: Values::new(),
            wires: Values::new(),
            memories: BTreeMap::new(),
        };
        i.declare(top, "");
        i.settle();
        i
    }

    fn declare(&mut self, m: &Module, path: &str) {
        for s in &m.signals {
            let code = match s.kind {
                SignalKind::Constant(code) => code,
                _ => 0,
            };
            self.wires.insert(join(path, &s.name), code);
        }
        for r in &m.registers {
            self.registers.insert(join(path, &r.name), r.initial);
        }
        if let Body::Memory(memory) = &m.body {
            let mut words = memory.initial.clone();
            words.resize(memory.words, 0);
            self.memories.insert(path.to_string(), words);
        }
        for c in &m.children {
            self.declare(&c.module, &join(path, &c.name));
        }
    }

    fn value(&self, path: &str, name: &Name) -> u128 {
        let map = match name {
            Name::Register(_) => &self.registers,
            _ => &self.wires,
        };
        map[&full(path, name)]
    }

    /// Executes statements: reads settled values, puts what is assigned into `next`.
    fn execute(&self, path: &str, list: &[Statement], next: &mut Self) {
        let of = |e: &Expression| evaluate(e, &|name| self.value(path, name));
        for s in list {
            match s {
                Statement::Assign {
                    target,
                    bits,
                    value,
                } => {
                    let (map, name) = match target {
                        Target::Wire(name) => (&mut next.wires, full(path, name)),
                        Target::Register(name) => (&mut next.registers, join(path, name)),
                    };
                    let (at, width) = bits.map_or((0, 128), |b| (b.at, b.width));
                    let hole = ones(width) << at;
                    let word = map.entry(name).or_default();
                    *word = *word & !hole | of(value) << at;
                }
                Statement::If {
                    condition,
                    then,
                    otherwise,
                } => {
                    let taken = if of(condition) == 1 { then } else { otherwise };
                    self.execute(path, taken, next);
                }
                Statement::Case {
                    subject,
                    arms,
                    otherwise,
                } => {
                    let code = of(subject);
                    let arm = arms.iter().find(|a| a.label == code);
                    self.execute(path, arm.map_or(otherwise, |a| &a.body), next);
                }
            }
        }
    }

    fn copy(&self) -> Self {
        Self {
            top: self.top,
            registers: self.registers.clone(),
            wires: self.wires.clone(),
            memories: BTreeMap::new(),
        }
    }

    /// What all statements assign, as seen from here.
    fn step(&self) -> Self {
        let mut next = self.copy();
        self.visit(self.top, "", &mut |m, path| match &m.body {
            Body::Statements(list) => self.execute(path, list, &mut next),
            Body::Memory(memory) if memory.read.clock.is_none() => {
                let address = self.wires[&join(path, &memory.read.address)];
                let words = &self.memories[path];
                let word = usize::try_from(address).ok().and_then(|a| words.get(a));
                let name = join(path, &memory.read.data);
                next.wires.insert(name, word.copied().unwrap_or(0));
            }
            Body::Memory(_) => {}
        });
        next
    }

    fn visit(&self, m: &Module, path: &str, f: &mut impl FnMut(&Module, &str)) {
        f(m, path);
        for c in &m.children {
            self.visit(&c.module, &join(path, &c.name), f);
        }
    }

    /// Repeats until the wires stay.
    pub fn settle(&mut self) {
        loop {
            let next = self.step();
            if next.wires == self.wires {
                return;
            }
            self.wires = next.wires;
        }
    }

    /// One edge.
    pub fn clock(&mut self) {
        self.settle();
        let next = self.step();
        let mut edges: Vec<(String, Memory)> = vec![];
        self.visit(self.top, "", &mut |m, path| {
            if let Body::Memory(memory) = &m.body {
                edges.push((path.to_string(), (**memory).clone()));
            }
        });
        let before = self.wires.clone();
        for (path, memory) in edges {
            let input = |name: &str| before[&join(&path, name)];
            let at = |a: u128| usize::try_from(a).ok().filter(|a| *a < memory.words);
            let words = self.memories.get_mut(&path).expect("declared");
            let r = &memory.read;
            if r.clock.is_some() && r.enable.as_ref().is_none_or(|e| input(e) == 1) {
                let word = at(input(&r.address)).map(|a| words[a]);
                let zero = memory.outside_is_zero.then_some(0);
                if let Some(word) = word.or(zero) {
                    self.wires.insert(join(&path, &r.data), word);
                }
            }
            if let Some(w) = &memory.write {
                if let (1, Some(a)) = (input(&w.enable), at(input(&w.address))) {
                    words[a] = input(&w.data);
                }
            }
        }
        self.registers = next.registers;
        self.settle();
    }
}
