//! Conversions between formats: `bit_cast`, `signed_cast`, `unsigned_cast` and their kin.
//!
//! The tree has one node for each family and no type parameters. What a call meant follows from the format it is
//! applied to, and, where it could give several, from the format that is needed.

use super::expression::{Lowering, Typed};
use crate::netlist::{Expression, Format, Node, MAX_WIDTH};
use rust_hdl_core::ast::VerilogExpression as E;

impl Lowering<'_> {
    pub(super) fn cast(&self, inner: &E, width: usize, e: &E) -> Typed {
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

    pub(super) fn signed(&self, inner: &E, want: Option<Format>, e: &E) -> Typed {
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

    pub(super) fn unsigned(&self, inner: &E, want: Option<Format>, e: &E) -> Typed {
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
}
