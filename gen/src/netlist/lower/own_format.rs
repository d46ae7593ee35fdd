//! The format that an expression has by itself, before its surroundings say anything.

use super::expression::{literal, peel, Lowering, LITERAL_WIDTH};
use super::scope::Meaning;
use crate::netlist::{Format, NetlistError, MAX_WIDTH};
use rust_hdl_core::ast::{VerilogExpression as E, VerilogOp as Op, VerilogOpUnary as Unary};
use rust_hdl_core::type_descriptor::{TypeDescriptor, TypeKind};

impl Lowering<'_> {
    /// The type of a name that stands alone.
    pub(super) fn descriptor(&self, e: &E) -> Result<Option<TypeDescriptor>, NetlistError> {
        let E::Signal(name) = peel(e) else {
            return Ok(None);
        };
        Ok(match self.scope.read(name)? {
            Meaning::Value(_, _, d) => Some(d),
            _ => None,
        })
    }

    /// The field of a structure at these bits.
    pub(super) fn field(
        &self,
        base: &E,
        at: &E,
        width: usize,
    ) -> Result<Option<Format>, NetlistError> {
        let structure = self.descriptor(base)?;
        let structure = structure.filter(|d| matches!(d.kind, TypeKind::Composite(_)));
        let (Some(structure), E::Literal(l)) = (structure, peel(at)) else {
            return Ok(None);
        };
        // A field's place is a machine word; other positions are not meant as fields.
        if let Some((at, LITERAL_WIDTH)) = literal(l) {
            let field = usize::try_from(at)
                .ok()
                .and_then(|at| field_at(&structure, at, width));
            if field.is_some() {
                return Ok(field);
            }
        }
        Err(self.error("no field of the structure lies at these bits", base))
    }

    /// Whether the words of an expression are of the descriptions' own type `U`, whose casts name their target's type.
    pub(super) fn own_words(&self, e: &E) -> Result<bool, NetlistError> {
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
}

/// The format of a product: all of its bits; `None` for words of two kinds, or too many bits.
pub fn product_format(a: Format, b: Format) -> Option<Format> {
    let format = match (a, b) {
        (Format::Unsigned(a), Format::Unsigned(b)) => Format::Unsigned(a + b),
        (Format::Signed(a), Format::Signed(b)) => Format::Signed(a + b),
        (Format::Fixed(m1, n1), Format::Fixed(m2, n2)) => Format::Fixed(m1 + m2 + 1, n1 + n2),
        _ => return None,
    };
    (format.width() <= MAX_WIDTH).then_some(format)
}

/// The format of the field of a structure at these bits; `None` if it is no field.
pub fn field_at(d: &TypeDescriptor, at: usize, width: usize) -> Option<Format> {
    let TypeKind::Composite(fields) = &d.kind else {
        return None;
    };
    let mut offset = 0;
    for f in fields {
        let format = Format::from_descriptor(&f.kind)?;
        if offset == at && format.width() == width {
            return Some(format);
        }
        offset += format.width();
    }
    None
}
