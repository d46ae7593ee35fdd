//! Typed expressions: every node states its format, so nothing about widths or signs is left to a reader's rules.
//!
//! A value is a *code*, an unsigned integer below 2^width; a signed format reads the same code as two's complement.
//! Sums and differences wrap modulo 2^width, as Rust's number types of the descriptions do. No node widens or narrows
//! but [`Node::Resize`], [`Node::Slice`], [`Node::Select`], [`Node::Append`] and [`Node::Product`], which say so.

use super::Format;

/// What a description reads or drives by name.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Name {
    /// A port, wire or constant of the module.
    Signal(String),
    /// The value of a register.
    Register(String),
    /// A port of an instance.
    Port {
        /// Instance.
        child: String,
        /// Its port.
        port: String,
    },
}

impl Name {
    /// As the Verilog of the module spells it.
    #[must_use]
    pub fn verilog(&self) -> String {
        match self {
            Self::Signal(s) | Self::Register(s) => s.clone(),
            Self::Port { child, port } => format!("{child}_{port}"),
        }
    }
}

/// An expression with its format.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expression {
    /// Format of the value.
    pub format: Format,
    /// How it is formed.
    pub node: Node,
}

/// Operators on two words of one width that give a word of that width.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operator {
    /// Sum modulo 2^width.
    Add,
    /// Difference modulo 2^width.
    Subtract,
    /// Bitwise and.
    And,
    /// Bitwise or.
    Or,
    /// Bitwise exclusive or.
    Xor,
}

/// Comparisons of two words of one width and sign; they give one bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// Equal.
    Equal,
    /// Not equal.
    NotEqual,
    /// Less, as numbers of their sign.
    Less,
    /// Less or equal.
    LessEqual,
    /// Greater.
    Greater,
    /// Greater or equal.
    GreaterEqual,
}

/// Reductions of a word to one bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Reduction {
    /// Every bit is set.
    All,
    /// Some bit is set.
    Any,
    /// An odd number of bits is set.
    Parity,
}

/// How a value is formed. Widths: see each variant; `width` is that of the node itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Node {
    /// A code, below 2^width.
    Literal(u128),
    /// The value of a name of the same format.
    Read(Name),
    /// Complement of every bit; operand as wide as the node.
    Not(Box<Expression>),
    /// Two's complement; operand as wide as the node.
    Negate(Box<Expression>),
    /// One bit from any width.
    Reduce(Reduction, Box<Expression>),
    /// Both operands as wide as the node.
    Binary(Operator, Box<Expression>, Box<Expression>),
    /// One bit from two operands of equal width and sign.
    Compare(Comparison, Box<Expression>, Box<Expression>),
    /// The whole product: as wide as both operands together, which have one sign.
    Product(Box<Expression>, Box<Expression>),
    /// Left shift by an unsigned amount; bits that leave are lost; amounts of width or more give zero.
    ShiftLeft(Box<Expression>, Box<Expression>),
    /// Logical right shift by an unsigned amount; zeros enter; amounts of width or more give zero.
    ShiftRight(Box<Expression>, Box<Expression>),
    /// `width` bits of the operand from this constant position; they lie inside the operand.
    Slice(Box<Expression>, usize),
    /// `width` bits of the operand from a variable unsigned position; zeros beyond its top. Never wider than it.
    Select(Box<Expression>, Box<Expression>),
    /// The low bits when narrower; when wider, extended by the operand's sign (zeros if it has none).
    Resize(Box<Expression>),
    /// The same code in another format of the same width.
    Reformat(Box<Expression>),
    /// The operand with this many zeros appended below it.
    Append(Box<Expression>, usize),
    /// The first operand, as wide as the node, with the bit at the unsigned position of the second replaced by the
    /// third (one bit); unchanged when the position is beyond its top.
    ReplaceBit(Box<Expression>, Box<Expression>, Box<Expression>),
}

impl Expression {
    /// An expression of this format.
    #[must_use]
    pub fn new(format: Format, node: Node) -> Self {
        Self { format, node }
    }

    /// A literal.
    #[must_use]
    pub fn literal(code: u128, format: Format) -> Self {
        Self::new(format, Node::Literal(code))
    }

    /// Bits of the value.
    #[must_use]
    pub fn width(&self) -> usize {
        self.format.width()
    }

    /// Direct operands, in order.
    #[must_use]
    pub fn operands(&self) -> Vec<&Expression> {
        match &self.node {
            Node::Literal(_) | Node::Read(_) => vec![],
            Node::Not(a)
            | Node::Negate(a)
            | Node::Reduce(_, a)
            | Node::Slice(a, _)
            | Node::Resize(a)
            | Node::Reformat(a)
            | Node::Append(a, _) => vec![a],
            Node::Binary(_, a, b)
            | Node::Compare(_, a, b)
            | Node::Product(a, b)
            | Node::ShiftLeft(a, b)
            | Node::ShiftRight(a, b)
            | Node::Select(a, b) => vec![a, b],
            Node::ReplaceBit(a, b, c) => vec![a, b, c],
        }
    }

    /// Calls `f` with every name that is read.
    pub fn each_read(&self, f: &mut impl FnMut(&Name)) {
        if let Node::Read(name) = &self.node {
            f(name);
        }
        for operand in self.operands() {
            operand.each_read(f);
        }
    }
}
