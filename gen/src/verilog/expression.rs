//! Expressions as text that Verilog's width and sign rules cannot change.
//!
//! Every operator stands in parentheses and joins operands of one width and one sign, every literal is sized, and only
//! names are sliced. Where the netlist slices, extends or compares something that Verilog could only do to a name, the
//! value gets a wire of its own: `<target>_part`, `<target>_part2`, …, numbered within one target, so that an
//! unrelated line never renames it. A slice of the low bits of a sum or a bitwise operation is taken from the
//! operands instead, which needs no wire.

use super::part::Part;
use crate::netlist::{
    ones, Comparison, Expression, Format, Module, Name, Node, Operator, Reduction, SignalKind,
};
use std::collections::{BTreeMap, BTreeSet};

/// A sized literal: binary for a bit, decimal for words, hexadecimal for signed and for long ones.
pub fn literal(code: u128, format: Format) -> String {
    let width = format.width();
    match format {
        Format::Clock | Format::Bit => format!("1'b{code}"),
        Format::Signed(_) | Format::Fixed(..) => format!("{width}'sh{code:x}"),
        _ if width > 64 => format!("{width}'h{code:x}"),
        _ => format!("{width}'d{code}"),
    }
}

/// `width` bits from `at` of a name; the plain name when that is the whole word.
pub fn slice(name: &str, whole: usize, at: usize, width: usize) -> String {
    match (at, width) {
        (0, w) if w == whole => name.to_string(),
        (at, 1) => format!("{name}[{at}]"),
        (at, w) => format!("{name}[{}:{at}]", at + w - 1),
    }
}

/// Prints the expressions of one module.
pub struct Printer<'a> {
    module: &'a Module,
    /// Names that parts must not have.
    pub taken: BTreeSet<String>,
    /// Names that were read, as Verilog spells them, and which of their bits.
    pub reads: BTreeMap<String, u128>,
    /// Wires that were needed, each after those it reads.
    pub parts: Vec<Part>,
    /// What is being assigned, for the names of parts.
    pub stem: String,
}

impl<'a> Printer<'a> {
    /// For one module; `taken` are the names that parts must not have.
    pub fn new(module: &'a Module, taken: BTreeSet<String>) -> Self {
        Self {
            module,
            taken,
            reads: BTreeMap::new(),
            parts: vec![],
            stem: String::new(),
        }
    }

    /// For the right of an assignment: without outer parentheses.
    pub fn assigned(&mut self, e: &Expression) -> String {
        let text = self.text(e);
        let inner = text.strip_prefix('(').and_then(|t| t.strip_suffix(')'));
        inner
            .filter(|t| balanced(t))
            .map_or(text.clone(), str::to_string)
    }

    /// A condition that the statement puts in parentheses.
    pub fn condition(&mut self, e: &Expression) -> String {
        self.assigned(e)
    }

    /// The wire that a value is, or gets; its bits count as read when they are sliced.
    pub(super) fn named(&mut self, e: &Expression) -> String {
        if let Node::Read(name) = &e.node {
            let constant = matches!(name, Name::Signal(s)
                if self.module.signal(s).is_some_and(|s| matches!(s.kind, SignalKind::Constant(_))));
            if !constant {
                return self.read(name);
            }
        }
        let value = self.assigned(e);
        let same = |p: &Part| p.stem == self.stem && p.value == value && p.format == e.format;
        if let Some(p) = self.parts.iter().find(|p| same(p)) {
            return p.name.clone();
        }
        let numbered = |i: usize| match i {
            1 => format!("{}_part", self.stem),
            i => format!("{}_part{i}", self.stem),
        };
        let name = (1..)
            .map(numbered)
            .find(|n| !self.taken.contains(n))
            .unwrap_or_default();
        self.taken.insert(name.clone());
        self.parts.push(Part {
            name: name.clone(),
            format: e.format,
            value,
            stem: self.stem.clone(),
            used: 0,
        });
        name
    }

    pub(super) fn used(&mut self, name: &str, at: usize, width: usize) {
        let bits = ones(width) << at;
        if let Some(p) = self.parts.iter_mut().find(|p| p.name == name) {
            p.used |= bits;
        } else if let Some(read) = self.reads.get_mut(name) {
            *read |= bits;
        }
    }

    pub(super) fn read(&mut self, name: &Name) -> String {
        let text = name.verilog();
        self.reads.entry(text.clone()).or_default();
        text
    }

    /// Bits of a value, as text without a sign.
    pub(super) fn slice(&mut self, e: &Expression, at: usize, width: usize) -> String {
        if at == 0 && width == e.width() {
            let whole = Node::Reformat(Box::new(e.clone()));
            return self.operand(&Expression::new(Format::Unsigned(width), whole));
        }
        let cut = |x: &Expression| {
            Expression::new(
                Format::Unsigned(width),
                Node::Slice(Box::new(x.clone()), at),
            )
        };
        match &e.node {
            // What is below a bit decides it, so low bits of a sum are the sum of low bits; bitwise, any bits are.
            Node::Binary(op, a, b)
                if at == 0 || matches!(op, Operator::And | Operator::Or | Operator::Xor) =>
            {
                let pushed = Node::Binary(*op, Box::new(cut(a)), Box::new(cut(b)));
                return self.text(&Expression::new(Format::Unsigned(width), pushed));
            }
            Node::Not(a) => {
                return self.text(&Expression::new(
                    Format::Unsigned(width),
                    Node::Not(Box::new(cut(a))),
                ))
            }
            Node::Literal(code) => {
                return literal(code >> at & ones(width), Format::Unsigned(width))
            }
            Node::Slice(a, below) => return self.slice(a, below + at, width),
            Node::Reformat(a) => return self.slice(a, at, width),
            Node::Resize(a) if at + width <= a.width() => return self.slice(a, at, width),
            Node::Append(a, zeros) if at >= *zeros => return self.slice(a, at - zeros, width),
            _ => {}
        }
        let name = self.named(e);
        self.used(&name, at, width);
        slice(&name, e.width(), at, width)
    }

    /// Whether Verilog takes the text of an expression as signed.
    pub(super) fn text_signed(&self, e: &Expression) -> bool {
        match &e.node {
            Node::Read(_) | Node::Literal(_) => e.format.signed(),
            Node::Reformat(a) => self.text_signed(a),
            Node::Not(a) | Node::Negate(a) | Node::ShiftLeft(a, _) | Node::ShiftRight(a, _) => {
                self.text_signed(a)
            }
            // Its operands are printed with the sign of their format.
            Node::Binary(_, a, _) | Node::Product(a, _) => a.format.signed(),
            _ => false,
        }
    }

    /// An operand whose text has the sign of its format.
    pub(super) fn operand(&mut self, e: &Expression) -> String {
        if self.text_signed(e) == e.format.signed() {
            return self.text(e);
        }
        // A part-select has no sign, so a signed name becomes an unsigned operand without a wire of its own.
        if let (Node::Reformat(a), false) = (&e.node, e.format.signed()) {
            if matches!(a.node, Node::Read(_)) && e.width() > 1 {
                let name = self.named(a);
                self.used(&name, 0, e.width());
                return format!("{name}[{}:0]", e.width() - 1);
            }
        }
        let name = self.named(e);
        self.used(&name, 0, e.width());
        name
    }

    /// A factor as wide as the product.
    pub(super) fn factor(&mut self, e: &Expression, width: usize) -> String {
        let format = if e.format.signed() {
            Format::Signed(width)
        } else {
            Format::Unsigned(width)
        };
        let wide = Expression::new(format, Node::Resize(Box::new(e.clone())));
        self.operand(&wide)
    }

    /// A count of bits; a constant one is printed in its own width.
    pub(super) fn text(&mut self, e: &Expression) -> String {
        let width = e.width();
        match &e.node {
            Node::Literal(code) => literal(*code, e.format),
            Node::Read(name) => {
                let text = self.read(name);
                self.used(&text, 0, width);
                text
            }
            Node::Not(a) => {
                let operator = if e.format == Format::Bit { "!" } else { "~" };
                format!("({operator}{})", self.text(a))
            }
            Node::Negate(a) => format!("(-{})", self.text(a)),
            Node::Reduce(how, a) => {
                let operator = match how {
                    Reduction::All => "&",
                    Reduction::Any => "|",
                    Reduction::Parity => "^",
                };
                format!("({operator}{})", self.text(a))
            }
            Node::Binary(op, a, b) => {
                let bit = e.format == Format::Bit;
                let symbol = match op {
                    Operator::Add => "+",
                    Operator::Subtract => "-",
                    Operator::And if bit => "&&",
                    Operator::And => "&",
                    Operator::Or if bit => "||",
                    Operator::Or => "|",
                    Operator::Xor => "^",
                };
                format!("({} {symbol} {})", self.operand(a), self.operand(b))
            }
            Node::Compare(c, a, b) => {
                let symbol = match c {
                    Comparison::Equal => "==",
                    Comparison::NotEqual => "!=",
                    Comparison::Less => "<",
                    Comparison::LessEqual => "<=",
                    Comparison::Greater => ">",
                    Comparison::GreaterEqual => ">=",
                };
                format!("({} {symbol} {})", self.operand(a), self.operand(b))
            }
            Node::Product(a, b) => {
                format!("({} * {})", self.factor(a, width), self.factor(b, width))
            }
            Node::ShiftLeft(a, by) => format!("({} << {})", self.text(a), self.operand(by)),
            Node::ShiftRight(a, by) => format!("({} >> {})", self.text(a), self.operand(by)),
            Node::Slice(a, at) => self.slice(a, *at, width),
            Node::Select(a, at) => {
                if let Node::Literal(at) = at.node {
                    if at <= (a.width() - width) as u128 {
                        return self.slice(a, at as usize, width);
                    }
                }
                let shifted = Expression::new(
                    Format::Unsigned(a.width()),
                    Node::ShiftRight(
                        Box::new(Expression::new(
                            Format::Unsigned(a.width()),
                            Node::Reformat(a.clone()),
                        )),
                        at.clone(),
                    ),
                );
                // A position that names exactly the bits of the word selects one; for others a shift is clearer to
                // lint tools, and brings the zeros beyond the top.
                let exact = at.width() <= 7 && 1 << at.width() == a.width();
                if width == 1 && exact {
                    let name = self.named(a);
                    self.used(&name, 0, a.width());
                    let mut position = self.operand(at);
                    if !position.starts_with(|c: char| c.is_ascii_alphabetic()) {
                        position = self.named(at);
                        self.used(&position, 0, at.width());
                    }
                    return format!("{name}[{position}]");
                }
                self.slice(&shifted, 0, width)
            }
            Node::Resize(a) if width <= a.width() => self.slice(a, 0, width),
            Node::Reformat(a) => self.text(a),
            Node::Append(..) | Node::Resize(_) => {
                let pieces = self.pieces(e);
                format!("{{{}}}", pieces.join(", "))
            }
            Node::ReplaceBit(a, at, bit) => self.replaced(e, a, at, bit),
        }
    }
}

/// Whether parentheses never close below the start.
fn balanced(text: &str) -> bool {
    let mut depth = 0i32;
    for c in text.chars() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        if depth < 0 {
            return false;
        }
    }
    depth == 0
}
