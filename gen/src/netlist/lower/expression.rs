//! rust-hdl's untyped expressions with their types restored, as Rust's own inference did.
//!
//! The tree keeps operators, names and casts but no types: a literal has 32 bits whatever it meant, `signed_cast` does
//! not say to what, and `.into()` is gone. [`Lowering::own_format`] finds the format that an expression has by itself
//! (that of its signals); [`Lowering::expression`] then builds it, handing the format down to where it is missing:
//! from the other operand, or from the target of the assignment. What stays without a format is refused.

use super::scope::{Meaning, Scope};
use crate::netlist::read::literal_code;
use crate::netlist::{
    Comparison, Expression, Format, NetlistError, Node, Operator, Reduction, MAX_WIDTH,
};
use rust_hdl_core::ast::{
    VerilogExpression as E, VerilogLiteral, VerilogOp as Op, VerilogOpUnary as Unary,
};
use rust_hdl_core::type_descriptor::{TypeDescriptor, TypeKind};

/// Width that Rust gives a number whose type nothing else decides, as in `1 << n`.
const LITERAL_WIDTH: usize = 64;

/// Types expressions of one module.
pub struct Lowering<'a> {
    /// What names mean.
    pub scope: Scope<'a>,
    /// Variants of enumerations that are used: spelling, code, width.
    pub variants: std::cell::RefCell<std::collections::BTreeMap<String, (u128, usize)>>,
}

type Typed = Result<Expression, NetlistError>;

fn peel(e: &E) -> &E {
    match e {
        E::Paren(inner) => peel(inner),
        other => other,
    }
}

/// Number and width of a literal; a boolean has one bit.
fn literal(l: &VerilogLiteral) -> Option<(u128, usize)> {
    let text = format!("{l:x}");
    let width = text.split_once('\'')?.0.parse().ok()?;
    Some((literal_code(&text)?, width))
}

impl<'a> Lowering<'a> {
    /// For one module.
    pub fn new(scope: Scope<'a>) -> Self {
        Self {
            scope,
            variants: Default::default(),
        }
    }

    fn error(&self, what: impl Into<String>, e: &E) -> NetlistError {
        self.scope
            .error(format!("{}: {}", what.into(), super::show::expression(e)))
    }

    /// The type of a name that stands alone.
    fn descriptor(&self, e: &E) -> Result<Option<TypeDescriptor>, NetlistError> {
        let E::Signal(name) = peel(e) else {
            return Ok(None);
        };
        Ok(match self.scope.read(name)? {
            Meaning::Value(_, _, d) => Some(d),
            _ => None,
        })
    }

    /// The field of a structure at these bits.
    fn field(&self, base: &E, at: &E, width: usize) -> Result<Option<Format>, NetlistError> {
        let Some(TypeKind::Composite(fields)) = self.descriptor(base)?.map(|d| d.kind) else {
            return Ok(None);
        };
        let E::Literal(l) = peel(at) else {
            return Ok(None);
        };
        let mut offset = 0;
        for f in fields {
            let Some(format) = Format::from_descriptor(&f.kind) else {
                break;
            };
            if literal(l) == Some((offset as u128, LITERAL_WIDTH)) && format.width() == width {
                return Ok(Some(format));
            }
            offset += format.width();
        }
        Err(self.error("no field of the structure lies at these bits", base))
    }

    /// Whether the words of an expression are of the descriptions' own type `U`, whose casts name their target's type.
    fn own_words(&self, e: &E) -> Result<bool, NetlistError> {
        Ok(match peel(e) {
            E::Signal(_) => self
                .descriptor(e)?
                .is_some_and(|d| d.name.starts_with('U') && matches!(d.kind, TypeKind::Bits(_))),
            E::Cast(a, _) | E::Unary(_, a) | E::Slice(a, ..) | E::IndexReplace(a, ..) => {
                self.own_words(a)?
            }
            E::Unsigned(a) => matches!(self.own_format(a)?, Some(Format::Fixed(..))),
            E::Binary(a, _, b) => self.own_words(a)? || self.own_words(b)?,
            _ => false,
        })
    }

    /// The format that an expression has by itself; `None` when only its surroundings can tell.
    pub fn own_format(&self, e: &E) -> Result<Option<Format>, NetlistError> {
        Ok(match e {
            E::Paren(inner) => self.own_format(inner)?,
            E::Signal(name) => match self.scope.read(name)? {
                Meaning::Value(_, format, _) => Some(format),
                Meaning::Variant(_, width, _) => Some(Format::Enumeration(width)),
                Meaning::Index(_) => None,
            },
            E::Literal(l) => match literal(l) {
                Some((_, 1)) => Some(Format::Bit),
                _ => None,
            },
            E::Cast(_, width) => Some(Format::Unsigned(*width)),
            E::Signed(inner) => match self.own_format(inner)? {
                Some(Format::Unsigned(n)) if !self.own_words(inner)? => Some(Format::Signed(n)),
                _ => None,
            },
            E::Unsigned(inner) => match self.own_format(inner)? {
                Some(Format::Signed(n)) => Some(Format::Unsigned(n)),
                _ => None,
            },
            E::Unary(Unary::Not | Unary::Neg, inner) => self.own_format(inner)?,
            E::Unary(_, _) | E::Index(..) => Some(Format::Bit),
            E::IndexReplace(base, ..) => self.own_format(base)?,
            E::Slice(base, width, at) => match self.own_format(base)? {
                Some(Format::Signed(_)) => Some(Format::Signed(*width)),
                Some(Format::Structure(_)) => self.field(base, at, *width)?,
                _ => Some(Format::Unsigned(*width)),
            },
            E::Binary(a, op, b) => match op {
                Op::Eq
                | Op::Ne
                | Op::Lt
                | Op::Le
                | Op::Gt
                | Op::Ge
                | Op::LogicalAnd
                | Op::LogicalOr => Some(Format::Bit),
                Op::Shl | Op::Shr => match self.own_format(a)? {
                    None if matches!(peel(a), E::Literal(_)) => {
                        Some(Format::Unsigned(LITERAL_WIDTH))
                    }
                    other => other,
                },
                Op::Mul => match (self.own_format(a)?, self.own_format(b)?) {
                    (Some(a), Some(b)) => product_format(a, b),
                    _ => None,
                },
                _ => match (self.own_format(a)?, self.own_format(b)?) {
                    // A carry: rust-hdl adds a bool to a word.
                    (Some(word @ Format::Unsigned(_)), Some(Format::Bit)) => Some(word),
                    (Some(own), _) => Some(own),
                    (None, own) => own,
                },
            },
        })
    }

    /// An expression of exactly this format.
    pub fn of_format(&self, e: &E, format: Format) -> Typed {
        let made = self.expression(e, Some(format))?;
        self.convert(made, format, e)
    }

    /// A condition: one bit.
    pub fn condition(&self, e: &E) -> Typed {
        let made = self.expression(e, Some(Format::Bit))?;
        if made.format == Format::Bit {
            return Ok(made);
        }
        Err(self.error(format!("a condition is one bit, not a {}", made.format), e))
    }

    /// What `.into()` may do without a trace in the tree: the same bits under another type.
    fn convert(&self, made: Expression, to: Format, e: &E) -> Typed {
        let from = made.format;
        if from == to {
            return Ok(made);
        }
        let one_bit = |f| matches!(f, Format::Bit | Format::Unsigned(1));
        let packed = matches!(from, Format::Enumeration(_) | Format::Structure(_))
            && to == Format::Unsigned(from.width());
        if one_bit(from) && one_bit(to) || packed {
            return Ok(Expression::new(to, Node::Reformat(Box::new(made))));
        }
        Err(self.error(format!("a {from} stands where a {to} is needed"), e))
    }

    /// An expression; `want` is the format that its surroundings need, for parts that have none of their own.
    pub fn expression(&self, e: &E, want: Option<Format>) -> Typed {
        let of = |format, node| Ok(Expression::new(format, node));
        match e {
            E::Paren(inner) => self.expression(inner, want),
            E::Signal(name) => match self.scope.read(name)? {
                Meaning::Value(name, format, _) => of(format, Node::Read(name)),
                Meaning::Index(value) => self.number(value, want, e),
                Meaning::Variant(code, width, path) => {
                    let name = super::scope::plain(&path);
                    self.variants.borrow_mut().insert(path, (code, width));
                    of(
                        Format::Enumeration(width),
                        Node::Read(crate::netlist::Name::Signal(name)),
                    )
                }
            },
            E::Literal(l) => match literal(l) {
                Some((code, 1)) => Ok(Expression::literal(code, Format::Bit)),
                Some((code, _)) => self.number(code, want, e),
                None => Err(self.error("the literal cannot be read", e)),
            },
            E::Cast(inner, width) => self.cast(inner, *width, e),
            E::Signed(inner) => self.signed(inner, want, e),
            E::Unsigned(inner) => self.unsigned(inner, want, e),
            E::Unary(op, inner) => self.unary(op, inner, want, e),
            E::Binary(a, op, b) => self.binary(a, op, b, want, e),
            E::Index(base, at) => self.bits(base, 1, at, Format::Bit, e),
            E::Slice(base, width, at) => {
                let format = self.own_format(e)?.unwrap_or(Format::Unsigned(*width));
                self.bits(base, *width, at, format, e)
            }
            E::IndexReplace(base, at, value) => {
                let base = self.word(base, want, e)?;
                let at = self.position(at)?;
                let value = self.of_format(value, Format::Bit)?;
                of(
                    base.format,
                    Node::ReplaceBit(Box::new(base), Box::new(at), Box::new(value)),
                )
            }
        }
    }

    fn number(&self, value: u128, want: Option<Format>, e: &E) -> Typed {
        let format = want.ok_or_else(|| {
            self.error(
                "nothing says how wide this number is; give it a type with a Constant or bits::<N>",
                e,
            )
        })?;
        if matches!(
            format,
            Format::Clock | Format::Enumeration(_) | Format::Structure(_)
        ) {
            return Err(self.error(format!("a number stands where a {format} is needed"), e));
        }
        if format.width() < MAX_WIDTH && value >> format.width() != 0 {
            return Err(self.error(format!("literal {value} does not fit {format}"), e));
        }
        Ok(Expression::literal(value, format))
    }

    /// An operand that must have a format of its own, or gets the wanted one.
    fn word(&self, e: &E, want: Option<Format>, whole: &E) -> Typed {
        let format = self.own_format(e)?.or(want);
        let format = format.ok_or_else(|| self.error("an operand has no format", whole))?;
        self.of_format(e, format)
    }

    fn cast(&self, inner: &E, width: usize, e: &E) -> Typed {
        let to = Format::Unsigned(width);
        if !(1..=MAX_WIDTH).contains(&width) {
            return Err(self.error(
                format!("a word of {width} bits; 1 to {MAX_WIDTH} are possible"),
                e,
            ));
        }
        let Some(from) = self.own_format(inner)? else {
            return self.of_format(inner, to);
        };
        let made = self.of_format(inner, from)?;
        match from {
            Format::Unsigned(n) if n == width => Ok(made),
            Format::Unsigned(_) | Format::Bit => {
                Ok(Expression::new(to, Node::Resize(Box::new(made))))
            }
            // `bit_cast` of a structure or state converted by `.into()`.
            Format::Enumeration(n) | Format::Structure(n) => {
                let word = self.convert(made, Format::Unsigned(n), inner)?;
                Ok(Expression::new(to, Node::Resize(Box::new(word))))
            }
            other => Err(self.error(format!("bit_cast takes an unsigned word, not a {other}"), e)),
        }
    }

    fn signed(&self, inner: &E, want: Option<Format>, e: &E) -> Typed {
        let own = self.own_format(inner)?;
        let of = |format, node| Ok(Expression::new(format, node));
        match (own, want) {
            (Some(Format::Unsigned(n)), _) if !self.own_words(inner)? => {
                let made = self.of_format(inner, Format::Unsigned(n))?;
                of(Format::Signed(n), Node::Reformat(Box::new(made)))
            }
            (Some(Format::Unsigned(n)), Some(to @ Format::Fixed(..))) if to.width() <= n => {
                let made = self.of_format(inner, Format::Unsigned(n))?;
                if to.width() == n {
                    return of(to, Node::Reformat(Box::new(made)));
                }
                of(to, Node::Slice(Box::new(made), 0))
            }
            (Some(from @ Format::Signed(_)), Some(to @ Format::Signed(_))) => {
                let made = self.of_format(inner, from)?;
                if from == to {
                    return Ok(made);
                }
                of(to, Node::Resize(Box::new(made)))
            }
            (Some(from @ Format::Fixed(..)), Some(to @ Format::Fixed(..))) => {
                let made = self.of_format(inner, from)?;
                super::align::align(made, to)
                    .ok_or_else(|| self.error(format!("a {from} does not convert to {to}"), e))
            }
            (Some(from), Some(to)) => Err(self.error(format!("a {from} does not convert to {to}"), e)),
            (Some(from), None) => Err(self.error(
                format!("nothing says to what this {from} is converted; assign it to a signal of its own"),
                e,
            )),
            (None, _) => Err(self.error("a number without a type is converted", e)),
        }
    }

    fn unsigned(&self, inner: &E, want: Option<Format>, e: &E) -> Typed {
        let of = |format, node| Ok(Expression::new(format, node));
        match (self.own_format(inner)?, want) {
            (Some(from @ Format::Signed(n)), _) => {
                let made = self.of_format(inner, from)?;
                of(Format::Unsigned(n), Node::Reformat(Box::new(made)))
            }
            (Some(from @ Format::Fixed(..)), Some(to @ Format::Unsigned(width))) => {
                let made = self.of_format(inner, from)?;
                Ok(super::align::integer_part(made, width, to))
            }
            (Some(from), Some(to)) => Err(self.error(format!("a {from} has no integer part of format {to}"), e)),
            (Some(from), None) => Err(self.error(
                format!("nothing says how many bits of this {from} are taken; assign it to a signal of its own"),
                e,
            )),
            (None, _) => Err(self.error("a number without a type is converted", e)),
        }
    }

    fn unary(&self, op: &Unary, inner: &E, want: Option<Format>, e: &E) -> Typed {
        let reduction = match op {
            Unary::Not | Unary::Neg => {
                let made = self.word(inner, want, e)?;
                let format = made.format;
                if let (Unary::Neg, Node::Literal(code)) = (op, &made.node) {
                    let code = code.wrapping_neg() & mask(format.width());
                    return Ok(Expression::literal(code, format));
                }
                let node = match op {
                    Unary::Not => Node::Not(Box::new(made)),
                    _ if format.signed() => Node::Negate(Box::new(made)),
                    _ => return Err(self.error(format!("- does not apply to a {format}"), e)),
                };
                return Ok(Expression::new(format, node));
            }
            Unary::All => Reduction::All,
            Unary::Any => Reduction::Any,
            Unary::Xor => Reduction::Parity,
        };
        let made = self.word(inner, None, e)?;
        Ok(Expression::new(
            Format::Bit,
            Node::Reduce(reduction, Box::new(made)),
        ))
    }

    fn binary(&self, a: &E, op: &Op, b: &E, want: Option<Format>, e: &E) -> Typed {
        match op {
            Op::Mul => return self.product(a, b, e),
            Op::Shl | Op::Shr => return self.shift(a, op, b, want, e),
            _ => {}
        }
        let comparison = match op {
            Op::Eq => Some(Comparison::Equal),
            Op::Ne => Some(Comparison::NotEqual),
            Op::Lt => Some(Comparison::Less),
            Op::Le => Some(Comparison::LessEqual),
            Op::Gt => Some(Comparison::Greater),
            Op::Ge => Some(Comparison::GreaterEqual),
            _ => None,
        };
        let (own_a, own_b) = (self.own_format(a)?, self.own_format(b)?);
        if let (Op::Add, Some(word @ Format::Unsigned(n)), Some(Format::Bit)) = (op, own_a, own_b) {
            if n > 1 {
                let carry = Expression::new(
                    word,
                    Node::Resize(Box::new(self.of_format(b, Format::Bit)?)),
                );
                let sum = Node::Binary(
                    Operator::Add,
                    Box::new(self.of_format(a, word)?),
                    Box::new(carry),
                );
                return Ok(Expression::new(word, sum));
            }
        }
        let outer = if comparison.is_some() { None } else { want };
        let format = own_a
            .or(own_b)
            .or(outer)
            .ok_or_else(|| self.error("neither operand has a format", e))?;
        if let (Some(x), Some(y)) = (own_a, own_b) {
            if x != y && !(x.width() == 1 && y.width() == 1) {
                return Err(self.error(format!("operands have different formats, {x} and {y}"), e));
            }
        }
        let (a, b) = (
            Box::new(self.of_format(a, format)?),
            Box::new(self.of_format(b, format)?),
        );
        if let Some(comparison) = comparison {
            let ordered = !matches!(comparison, Comparison::Equal | Comparison::NotEqual);
            if ordered && matches!(format, Format::Structure(_) | Format::Enumeration(_)) {
                return Err(self.error(format!("a {format} has no order"), e));
            }
            return Ok(Expression::new(
                Format::Bit,
                Node::Compare(comparison, a, b),
            ));
        }
        let operator = match op {
            Op::Add => Operator::Add,
            Op::Sub => Operator::Subtract,
            Op::BitAnd | Op::LogicalAnd => Operator::And,
            Op::BitOr | Op::LogicalOr => Operator::Or,
            _ => Operator::Xor,
        };
        let logical = matches!(op, Op::LogicalAnd | Op::LogicalOr);
        let fits = match format {
            Format::Bit => !matches!(operator, Operator::Add | Operator::Subtract),
            Format::Unsigned(_) => !logical,
            Format::Signed(_) | Format::Fixed(..) => {
                matches!(operator, Operator::Add | Operator::Subtract)
            }
            _ => false,
        };
        if !fits {
            return Err(self.error(format!("the operator does not apply to a {format}"), e));
        }
        Ok(Expression::new(format, Node::Binary(operator, a, b)))
    }

    fn product(&self, a: &E, b: &E, e: &E) -> Typed {
        let (Some(fa), Some(fb)) = (self.own_format(a)?, self.own_format(b)?) else {
            return Err(self.error("a factor has no format", e));
        };
        let format = product_format(fa, fb)
            .ok_or_else(|| self.error(format!("a {fa} and a {fb} have no product"), e))?;
        let (a, b) = (self.of_format(a, fa)?, self.of_format(b, fb)?);
        Ok(Expression::new(
            format,
            Node::Product(Box::new(a), Box::new(b)),
        ))
    }

    fn shift(&self, a: &E, op: &Op, b: &E, want: Option<Format>, e: &E) -> Typed {
        let own = self.own_format(a)?;
        let number = matches!(peel(a), E::Literal(_)).then_some(Format::Unsigned(LITERAL_WIDTH));
        let format = own
            .or(number)
            .or(want)
            .ok_or_else(|| self.error("the shifted operand has no format", e))?;
        if !matches!(format, Format::Unsigned(_)) {
            return Err(self.error(
                format!("shifts apply to unsigned words, not to a {format}"),
                e,
            ));
        }
        let word = Box::new(self.of_format(a, format)?);
        let amount = Box::new(self.amount(b)?);
        let node = match op {
            Op::Shl => Node::ShiftLeft(word, amount),
            _ => Node::ShiftRight(word, amount),
        };
        Ok(Expression::new(format, node))
    }

    /// A count of bits: a number, or an unsigned word.
    fn amount(&self, e: &E) -> Typed {
        match self.own_format(e)? {
            None => {
                let number = Format::Unsigned(32);
                let made = self.of_format(e, number)?;
                match made.node {
                    Node::Literal(code) => Ok(count(code)),
                    _ => Ok(made),
                }
            }
            Some(format @ Format::Unsigned(_)) => self.of_format(e, format),
            Some(other) => Err(self.error(
                format!("a count of bits is an unsigned word, not a {other}"),
                e,
            )),
        }
    }

    /// A bit position. Rust computes with machine words here, of which the tree keeps no trace, so only plain
    /// signals and constants are taken.
    fn position(&self, e: &E) -> Typed {
        if let E::Binary(..) | E::Unary(..) = peel(e) {
            return self.constant_position(e).map(count).ok_or_else(|| {
                self.error(
                    "a computed bit position has Rust's machine width, which the tree does not keep; give it a wire",
                    e,
                )
            });
        }
        self.amount(e)
    }

    /// The value of a position built of constants and loop indices.
    fn constant_position(&self, e: &E) -> Option<u128> {
        match peel(e) {
            E::Literal(l) => literal(l).map(|(v, _)| v),
            E::Signal(name) => match self.scope.read(name).ok()? {
                Meaning::Index(v) => Some(v),
                _ => None,
            },
            E::Binary(a, op, b) => {
                let (a, b) = (self.constant_position(a)?, self.constant_position(b)?);
                match op {
                    Op::Add => a.checked_add(b),
                    Op::Sub => a.checked_sub(b),
                    Op::Mul => a.checked_mul(b),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// Bits of a word from a position; above its top there are zeros, or the sign of a fixed-point word.
    fn bits(&self, base: &E, width: usize, at: &E, format: Format, e: &E) -> Typed {
        let word = self.word(base, None, e)?;
        let have = word.width();
        if format.width() != width || width == 0 || width > MAX_WIDTH {
            return Err(self.error(format!("{width} bits are taken as a {format}"), e));
        }
        let unsigned = |w, node| Expression::new(Format::Unsigned(w), node);
        let fixed = matches!(word.format, Format::Fixed(..));
        let Some(at) = self.constant_position(at) else {
            let at = Box::new(self.position(at)?);
            let inside = at.width() < 16 && (1 << at.width()) - 1 + width <= have;
            if fixed && !inside {
                return Err(self.error(
                    "the position can reach beyond the top of a fixed-point word, where Rust repeats the sign",
                    e,
                ));
            }
            if width <= have {
                return Ok(Expression::new(format, Node::Select(Box::new(word), at)));
            }
            let all = unsigned(have, Node::Select(Box::new(word), at));
            return Ok(recast(unsigned(width, Node::Resize(Box::new(all))), format));
        };
        let one_bit = format == Format::Bit;
        if at >= have as u128 + u128::from(!one_bit) {
            return Err(self.error(
                format!("bits {at}+:{width} lie outside a word of {have} bits"),
                e,
            ));
        }
        let at = at as usize;
        if at + width <= have {
            return Ok(Expression::new(format, Node::Slice(Box::new(word), at)));
        }
        if fixed && at + width <= MAX_WIDTH {
            let long = Expression::new(Format::Signed(at + width), Node::Resize(Box::new(word)));
            return Ok(Expression::new(format, Node::Slice(Box::new(long), at)));
        }
        let inside = if at < have {
            unsigned(have - at, Node::Slice(Box::new(word), at))
        } else {
            Expression::literal(0, Format::Unsigned(1))
        };
        let wide = unsigned(width, Node::Resize(Box::new(inside)));
        Ok(recast(wide, format))
    }
}

fn recast(e: Expression, format: Format) -> Expression {
    if e.format == format {
        e
    } else {
        Expression::new(format, Node::Reformat(Box::new(e)))
    }
}

/// A constant count in as few bits as it needs.
fn count(code: u128) -> Expression {
    let width = (u128::BITS - code.leading_zeros()).max(1) as usize;
    Expression::literal(code, Format::Unsigned(width))
}

fn mask(width: usize) -> u128 {
    if width >= 128 {
        !0
    } else {
        (1 << width) - 1
    }
}

fn product_format(a: Format, b: Format) -> Option<Format> {
    let format = match (a, b) {
        (Format::Unsigned(a), Format::Unsigned(b)) => Format::Unsigned(a + b),
        (Format::Signed(a), Format::Signed(b)) => Format::Signed(a + b),
        (Format::Fixed(m1, n1), Format::Fixed(m2, n2)) => Format::Fixed(m1 + m2 + 1, n1 + n2),
        _ => return None,
    };
    (format.width() <= MAX_WIDTH).then_some(format)
}
