//! Expression trees: their inputs, their value in rust-hdl, their Rust text and the tree that `#[hdl_gen]` makes of it.

use super::value::{product, Comparison, Format, Int, Operator, Reduction, Value, Word, WIDTHS};
use rust_hdl_core::ast::{VerilogExpression as E, VerilogOp as Op, VerilogOpUnary as Unary};

/// What a node does with its parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Node {
    /// An input, by position in [`inputs`].
    Input(usize),
    /// A number without a type of its own.
    Number(i128),
    /// `bits::<N>(number)`
    Sized(u64),
    Not,
    Negate,
    Reduce(Reduction),
    Binary(Operator),
    Compare(Comparison),
    Product,
    /// A word and a bit are added.
    PlusBit,
    /// To the left or right by the second part.
    Shift(bool),
    /// `get_bit` at the second part.
    Bit,
    /// `get_bits` at the second part.
    Slice,
    /// `replace_bit` at the second part by the third.
    Replace,
    /// `bit_cast`
    Cast,
    /// `signed_cast`
    ToSigned,
    /// `unsigned_cast`
    ToUnsigned,
    /// `signed_bit_cast`
    Resize,
}

/// An expression with its format.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tree {
    pub format: Format,
    pub node: Node,
    pub parts: Vec<Tree>,
}

/// Inputs of each format.
const EACH: usize = 2;

/// Names and formats of the inputs that trees read.
pub fn inputs() -> Vec<(String, Format)> {
    let mut list: Vec<(String, Format)> = (0..3).map(|i| (format!("f{i}"), Format::Bit)).collect();
    for w in WIDTHS {
        for i in 0..EACH {
            list.push((format!("w{w}_{i}"), Format::Word(*w)));
            list.push((format!("s{w}_{i}"), Format::Int(*w)));
        }
    }
    list
}

impl Tree {
    pub fn new(format: Format, node: Node, parts: Vec<Tree>) -> Self {
        Self {
            format,
            node,
            parts,
        }
    }

    /// Nodes in the tree.
    pub fn size(&self) -> usize {
        1 + self.parts.iter().map(Tree::size).sum::<usize>()
    }

    /// Whether the tree that `#[hdl_gen]` makes shows the format; otherwise only the surroundings do.
    pub fn known(&self) -> bool {
        match self.node {
            Node::Number(_) | Node::Resize => false,
            Node::Negate => self.parts[0].known(),
            Node::Binary(_) => self.parts.iter().any(Tree::known),
            _ => true,
        }
    }

    /// Whether the description's subset has this tree: nothing whose format would be lost.
    pub fn allowed(&self) -> bool {
        let known = |i: usize| self.parts[i].known();
        let own = match self.node {
            Node::Compare(_) => known(0) || known(1),
            Node::Binary(_) => !self.parts.iter().all(|p| matches!(p.node, Node::Number(_))),
            Node::Not
            | Node::Reduce(_)
            | Node::PlusBit
            | Node::Bit
            | Node::Slice
            | Node::Replace => known(0),
            Node::Cast | Node::ToSigned | Node::ToUnsigned | Node::Resize => known(0),
            Node::Negate => !matches!(self.parts[0].node, Node::Number(_)),
            Node::Product => known(0) && known(1),
            _ => true,
        };
        own && self.parts.iter().all(Tree::allowed)
    }

    /// The value; `None` where rust-hdl panics or recurses for ever.
    pub fn value(&self, inputs: &[Value]) -> Option<Value> {
        let part = |i: usize| self.parts[i].value(inputs);
        let position = |width: usize| -> Option<usize> {
            let at = match self.parts[1].node {
                Node::Number(n) => n as usize,
                _ => part(1)?.word().index(),
            };
            (at <= width).then_some(at)
        };
        let width = |i: usize| match self.parts[i].format {
            Format::Bit => 1,
            Format::Word(n) | Format::Int(n) => n,
        };
        Some(match (self.node, self.format) {
            (Node::Input(i), _) => inputs[i],
            (Node::Number(n), Format::Bit) => Value::Bit(n == 1),
            (Node::Number(n), Format::Word(w)) => Value::Word(Word::number(w, n as u64)),
            (Node::Number(n), Format::Int(w)) => Value::Int(Int::number(w, n as i64)),
            (Node::Sized(n), Format::Word(w)) => Value::Word(Word::number(w, n)),
            (Node::Not, Format::Bit) => Value::Bit(!part(0)?.bit()),
            (Node::Not, _) => Value::Word(part(0)?.word().not()),
            (Node::Negate, _) => Value::Int(part(0)?.int().negate()),
            (Node::Reduce(how), _) => Value::Bit(part(0)?.word().reduce(how)),
            (Node::Binary(op), Format::Bit) => {
                let (a, b) = (part(0)?.bit(), part(1)?.bit());
                Value::Bit(match op {
                    Operator::And => a & b,
                    Operator::Or => a | b,
                    Operator::Xor => a ^ b,
                    Operator::Both => a && b,
                    Operator::Either => a || b,
                    _ => unreachable!("bits have no sums"),
                })
            }
            (Node::Binary(op), Format::Word(_)) => {
                Value::Word(Word::binary(op, part(0)?.word(), part(1)?.word()))
            }
            (Node::Binary(op), Format::Int(_)) => {
                Value::Int(Int::binary(op, part(0)?.int(), part(1)?.int()))
            }
            (Node::Compare(c), _) => Value::Bit(Value::compare(c, part(0)?, part(1)?)),
            (Node::Product, _) => product(part(0)?, part(1)?),
            (Node::PlusBit, _) => Value::Word(part(0)?.word().plus_bit(part(1)?.bit())),
            (Node::Shift(left), _) => Value::Word(match self.parts[1].node {
                Node::Number(n) => part(0)?.word().shift_by(left, n as u64),
                _ => part(0)?.word().shift(left, part(1)?.word()),
            }),
            (Node::Bit, _) => {
                let at = position(width(0) - 1)?;
                Value::Bit(match part(0)? {
                    Value::Int(x) => x.bit(at),
                    x => x.word().bit(at),
                })
            }
            (Node::Slice, Format::Int(w)) => {
                Value::Int(part(0)?.int().slice(w, position(width(0))?))
            }
            (Node::Slice, Format::Word(w)) => {
                Value::Word(part(0)?.word().slice(w, position(width(0))?))
            }
            (Node::Replace, _) => Value::Word(
                part(0)?
                    .word()
                    .replace(position(width(0) - 1)?, part(2)?.bit()),
            ),
            (Node::Cast, Format::Word(w)) => Value::Word(part(0)?.word().cast(w)),
            (Node::ToSigned, _) => Value::Int(part(0)?.word().signed()),
            (Node::ToUnsigned, _) => Value::Word(part(0)?.int().unsigned()),
            (Node::Resize, Format::Int(w)) => Value::Int(part(0)?.int().cast(w)?),
            _ => unreachable!("{self:?}"),
        })
    }
}

/// How strongly the outermost operator of a Rust expression binds.
type Strength = u8;
const ATOM: Strength = 20;
const PREFIX: Strength = 12;
const COMPARE: Strength = 5;

fn operator(op: Operator) -> (Op, &'static str, Strength) {
    match op {
        Operator::Add => (Op::Add, "+", 10),
        Operator::Subtract => (Op::Sub, "-", 10),
        Operator::And => (Op::BitAnd, "&", 8),
        Operator::Xor => (Op::BitXor, "^", 7),
        Operator::Or => (Op::BitOr, "|", 6),
        Operator::Both => (Op::LogicalAnd, "&&", 4),
        Operator::Either => (Op::LogicalOr, "||", 3),
    }
}

fn comparison(c: Comparison) -> (Op, &'static str) {
    match c {
        Comparison::Equal => (Op::Eq, "=="),
        Comparison::NotEqual => (Op::Ne, "!="),
        Comparison::Less => (Op::Lt, "<"),
        Comparison::LessEqual => (Op::Le, "<="),
        Comparison::Greater => (Op::Gt, ">"),
        Comparison::GreaterEqual => (Op::Ge, ">="),
    }
}

fn width_of(format: Format) -> usize {
    match format {
        Format::Bit => 1,
        Format::Word(n) | Format::Int(n) => n,
    }
}

/// Number, as `#[hdl_gen]` stores it and as Rust spells it. Without a suffix Rust takes a literal for an `i32`.
fn number(n: u64) -> (E, String) {
    if n < 1 << 31 {
        (E::Literal((n as u32).into()), n.to_string())
    } else {
        (E::Literal(n.into()), format!("{n}_u64"))
    }
}

struct Written {
    tree: E,
    text: String,
    strength: Strength,
}

impl Written {
    fn atom(tree: E, text: String) -> Self {
        Self {
            tree,
            text,
            strength: ATOM,
        }
    }

    /// In parentheses unless it binds at least this strongly.
    fn at_least(self, strength: Strength) -> Self {
        if self.strength >= strength {
            return self;
        }
        Self::atom(E::Paren(Box::new(self.tree)), format!("({})", self.text))
    }

    fn boxed(self) -> (Box<E>, String) {
        (Box::new(self.tree), self.text)
    }
}

fn binary(
    a: Written,
    op: Op,
    symbol: &str,
    b: Written,
    strength: Strength,
    chains: bool,
) -> Written {
    // Operators of one strength group to the left; comparisons do not chain.
    let (a, x) = a.at_least(strength + u8::from(!chains)).boxed();
    let (b, y) = b.at_least(strength + 1).boxed();
    Written {
        tree: E::Binary(a, op, b),
        text: format!("{x} {symbol} {y}"),
        strength,
    }
}

fn write(t: &Tree, names: &[(String, Format)]) -> Written {
    let part = |i: usize| write(&t.parts[i], names);
    // A receiver of a method.
    let receiver = || part(0).at_least(ATOM).boxed();
    let index = || match t.parts[1].node {
        Node::Number(_) => part(1).boxed(),
        _ => {
            let (e, text) = part(1).at_least(ATOM).boxed();
            (e, format!("{text}.index()"))
        }
    };
    let call = |name: String, make: fn(Box<E>) -> E| {
        let (e, text) = part(0).boxed();
        Written::atom(make(e), format!("{name}({text})"))
    };
    let prefix = |symbol: &str, op: Unary| {
        let (e, text) = part(0).at_least(PREFIX).boxed();
        Written {
            tree: E::Unary(op, e),
            text: format!("{symbol}{text}"),
            strength: PREFIX,
        }
    };
    let width = width_of(t.format);
    let from = t.parts.first().map_or(0, |p| width_of(p.format));
    match t.node {
        Node::Input(i) => Written::atom(E::Signal(names[i].0.clone()), names[i].0.clone()),
        Node::Number(n) => match t.format {
            Format::Bit => Written::atom(E::Literal((n == 1).into()), (n == 1).to_string()),
            Format::Word(_) => {
                let (e, text) = number(n as u64);
                Written::atom(e, text)
            }
            Format::Int(_) => {
                let (e, text) = number(n.unsigned_abs() as u64);
                if n >= 0 {
                    return Written::atom(e, format!("{text}.into()"));
                }
                let negative = E::Unary(Unary::Neg, Box::new(e));
                Written::atom(E::Paren(Box::new(negative)), format!("(-{text}).into()"))
            }
        },
        Node::Sized(n) => {
            let (e, text) = number(n);
            Written::atom(
                E::Cast(Box::new(e), width),
                format!("bits::<{width}>({text})"),
            )
        }
        Node::Not => prefix("!", Unary::Not),
        Node::Negate => prefix("-", Unary::Neg),
        Node::Reduce(how) => {
            let (e, text) = receiver();
            let (op, name) = match how {
                Reduction::All => (Unary::All, "all"),
                Reduction::Any => (Unary::Any, "any"),
                Reduction::Parity => (Unary::Xor, "xor"),
            };
            Written::atom(E::Unary(op, e), format!("{text}.{name}()"))
        }
        Node::Binary(op) => {
            let (op, symbol, strength) = operator(op);
            binary(part(0), op, symbol, part(1), strength, true)
        }
        Node::PlusBit => binary(part(0), Op::Add, "+", part(1), 10, true),
        Node::Compare(c) => {
            let (op, symbol) = comparison(c);
            binary(part(0), op, symbol, part(1), COMPARE, false)
        }
        Node::Product => binary(part(0), Op::Mul, "*", part(1), 11, true),
        Node::Shift(true) => binary(part(0), Op::Shl, "<<", part(1), 9, true),
        Node::Shift(false) => binary(part(0), Op::Shr, ">>", part(1), 9, true),
        Node::Bit => {
            let ((e, text), (at, place)) = (receiver(), index());
            Written::atom(E::Index(e, at), format!("{text}.get_bit({place})"))
        }
        Node::Slice => {
            let ((e, text), (at, place)) = (receiver(), index());
            Written::atom(
                E::Slice(e, width, at),
                format!("{text}.get_bits::<{width}>({place})"),
            )
        }
        Node::Replace => {
            let ((e, text), (at, place), (bit, value)) = (receiver(), index(), part(2).boxed());
            Written::atom(
                E::IndexReplace(e, at, bit),
                format!("{text}.replace_bit({place}, {value})"),
            )
        }
        Node::Cast => {
            let (e, text) = part(0).boxed();
            Written::atom(
                E::Cast(e, width),
                format!("bit_cast::<{width}, {from}>({text})"),
            )
        }
        Node::ToSigned => call(format!("signed_cast::<{width}>"), E::Signed),
        Node::ToUnsigned => call(format!("unsigned_cast::<{width}>"), E::Unsigned),
        Node::Resize => call(format!("signed_bit_cast::<{width}, {from}>"), E::Signed),
    }
}

impl Tree {
    /// The tree that `#[hdl_gen]` makes.
    pub fn expression(&self) -> E {
        write(self, &inputs()).tree
    }
}

impl std::fmt::Display for Tree {
    /// As Rust, but for `self.` and `.val()`.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&write(self, &inputs()).text)
    }
}
