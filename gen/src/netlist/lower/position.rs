//! Bit positions and counts of bits, and the bits that are taken there.

use super::expression::{literal, peel, Lowering, Typed};
use super::scope::Meaning;
use crate::netlist::{Expression, Format, Node, MAX_WIDTH};
use rust_hdl_core::ast::{VerilogExpression as E, VerilogOp as Op};

impl Lowering<'_> {
    /// A count of bits: a number, or an unsigned word.
    pub(super) fn amount(&self, e: &E) -> Typed {
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
    pub(super) fn position(&self, e: &E) -> Typed {
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
    pub(super) fn constant_position(&self, e: &E) -> Option<u128> {
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
    pub(super) fn bits(&self, base: &E, width: usize, at: &E, format: Format, e: &E) -> Typed {
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
