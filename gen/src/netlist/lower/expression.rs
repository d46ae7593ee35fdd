//! rust-hdl's untyped expressions with their types restored, as Rust's own inference did.
//!
//! The tree keeps operators, names and casts but no types: a literal has 32 bits whatever it meant, `signed_cast` does
//! not say to what, and `.into()` is gone. [`Lowering::own_format`] finds the format that an expression has by itself
//! (that of its signals); [`Lowering::expression`] then builds it, handing the format down to where it is missing:
//! from the other operand, or from the target of the assignment. What stays without a format is refused.

use super::own_format::product_format;
use super::scope::{Meaning, Scope};
use crate::netlist::read::literal_code;
use crate::netlist::{
    ones, Comparison, Expression, Format, NetlistError, Node, Operator, Reduction, MAX_WIDTH,
};
use rust_hdl_core::ast::{
    VerilogExpression as E, VerilogLiteral, VerilogOp as Op, VerilogOpUnary as Unary,
};

/// Width that Rust gives a number whose type nothing else decides, as in `1 << n`.
pub const LITERAL_WIDTH: usize = 64;

/// Types expressions of one module.
pub struct Lowering<'a> {
    /// What names mean.
    pub scope: Scope<'a>,
    /// Variants of enumerations that are used: spelling, code, width.
    pub variants: std::cell::RefCell<std::collections::BTreeMap<String, (u128, usize)>>,
}

/// An expression, or why there is none.
pub type Typed = Result<Expression, NetlistError>;

/// Without parentheses.
pub fn peel(e: &E) -> &E {
    match e {
        E::Paren(inner) => peel(inner),
        other => other,
    }
}

/// Number and width of a literal; a boolean has one bit.
pub fn literal(l: &VerilogLiteral) -> Option<(u128, usize)> {
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

    pub(super) fn error(&self, what: impl Into<String>, e: &E) -> NetlistError {
        self.scope
            .error(format!("{}: {}", what.into(), super::show::expression(e)))
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
    pub(super) fn convert(&self, made: Expression, to: Format, e: &E) -> Typed {
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

    pub(super) fn number(&self, value: u128, want: Option<Format>, e: &E) -> Typed {
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
    pub(super) fn word(&self, e: &E, want: Option<Format>, whole: &E) -> Typed {
        let format = self.own_format(e)?.or(want);
        let format = format.ok_or_else(|| self.error("an operand has no format", whole))?;
        self.of_format(e, format)
    }

    pub(super) fn unary(&self, op: &Unary, inner: &E, want: Option<Format>, e: &E) -> Typed {
        let reduction = match op {
            Unary::Not | Unary::Neg => {
                let made = self.word(inner, want, e)?;
                let format = made.format;
                if let (Unary::Neg, Node::Literal(code)) = (op, &made.node) {
                    let code = code.wrapping_neg() & ones(format.width());
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

    pub(super) fn binary(&self, a: &E, op: &Op, b: &E, want: Option<Format>, e: &E) -> Typed {
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

    pub(super) fn product(&self, a: &E, b: &E, e: &E) -> Typed {
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

    pub(super) fn shift(&self, a: &E, op: &Op, b: &E, want: Option<Format>, e: &E) -> Typed {
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
}
