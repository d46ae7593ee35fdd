//! Typed expressions: every one has a format, and prints so that Verilog cannot widen or re-sign it.

use crate::netlist::{Format, NetlistError};
use rust_hdl_core::ast::{
    VerilogExpression as E, VerilogLiteral, VerilogOp as Op, VerilogOpUnary as Unary,
};
use std::cell::RefCell;
use std::collections::BTreeSet;

/// What a name in a description stands for.
pub trait Names {
    /// The Verilog name and format of a name that is read, such as `total$q` or `span$value`.
    fn read(&self, name: &str) -> Option<(String, Format)>;
    /// Name of the module, for errors.
    fn module(&self) -> &str;
}

/// A printed expression with its format; `None` is a literal that has not met its other side yet.
#[derive(Clone, Debug)]
pub struct Typed {
    /// Verilog text.
    pub text: String,
    /// Its format.
    pub format: Format,
}

fn literal_value(literal: &VerilogLiteral) -> Option<u64> {
    let text = format!("{literal:x}");
    u64::from_str_radix(text.split_once("'h")?.1, 16).ok()
}

/// A sized literal; decimal for words, binary for a bit.
pub fn literal(value: u64, format: Format) -> Option<String> {
    let width = format.width();
    if width < 64 && value >> width != 0 {
        return None;
    }
    Some(match format {
        Format::Bit => format!("1'b{value}"),
        Format::Unsigned(_) => format!("{width}'d{value}"),
        Format::Fixed(..) => format!("{width}'sh{value:x}"),
    })
}

fn peel(e: &E) -> &E {
    match e {
        E::Paren(inner) => peel(inner),
        other => other,
    }
}

fn strip(text: &str) -> &str {
    text.strip_prefix('(')
        .and_then(|t| t.strip_suffix(')'))
        .filter(|t| balanced(t))
        .unwrap_or(text)
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

/// Without the outermost parentheses: for the right of an assignment or a condition that adds its own.
pub fn bare(t: &Typed) -> String {
    strip(&t.text).to_string()
}

/// Prints expressions of one module.
pub struct Printer<'a> {
    /// What names mean.
    pub names: &'a dyn Names,
    /// Verilog names that were read.
    pub reads: RefCell<BTreeSet<String>>,
}

impl<'a> Printer<'a> {
    /// A printer for one module.
    pub fn new(names: &'a dyn Names) -> Self {
        Self {
            names,
            reads: RefCell::default(),
        }
    }
}

impl Printer<'_> {
    fn error(&self, what: impl Into<String>, e: &E) -> NetlistError {
        let shown: String = format!("{e:?}").chars().take(160).collect();
        NetlistError::new(self.names.module(), format!("{}: {shown}", what.into()))
    }

    /// An expression assigned to a signal of format `target`: here alone may formats change.
    pub fn assigned(&self, e: &E, target: Format) -> Result<Typed, NetlistError> {
        let converted = match peel(e) {
            E::Cast(inner, width) => Some(self.resize(inner, *width, e)?),
            E::Signed(inner) => Some(self.to_fixed(inner, target, e)?),
            E::Unsigned(inner) => Some(self.integer_part(inner, target, e)?),
            _ => None,
        };
        let typed = match converted {
            Some(t) => t,
            None => self.expect(e, target)?,
        };
        if typed.format != target {
            return Err(self.error(format!("a {} is assigned to a {target}", typed.format), e));
        }
        Ok(typed)
    }

    /// An expression whose format must be `target`; literals take it.
    fn expect(&self, e: &E, target: Format) -> Result<Typed, NetlistError> {
        match peel(e) {
            E::Literal(l) => {
                let value =
                    literal_value(l).ok_or_else(|| self.error("literal cannot be read", e))?;
                let text = literal(value, target).ok_or_else(|| {
                    self.error(format!("literal {value} does not fit {target}"), e)
                })?;
                Ok(Typed {
                    text,
                    format: target,
                })
            }
            _ => self.expression(e),
        }
    }

    /// Both sides in one format; a literal takes the format of the other side.
    fn pair(&self, a: &E, b: &E, e: &E) -> Result<(Typed, Typed), NetlistError> {
        let (a, b) = match (peel(a), peel(b)) {
            (E::Literal(_), E::Literal(_)) => {
                return Err(self.error("two literals have no format", e))
            }
            (E::Literal(_), _) => {
                let b = self.expression(b)?;
                (self.expect(a, b.format)?, b)
            }
            (_, E::Literal(_)) => {
                let a = self.expression(a)?;
                let b = self.expect(b, a.format)?;
                (a, b)
            }
            _ => (self.expression(a)?, self.expression(b)?),
        };
        if a.format != b.format {
            return Err(self.error(
                format!(
                    "operands have different formats, {} and {}",
                    a.format, b.format
                ),
                e,
            ));
        }
        Ok((a, b))
    }

    /// A condition: one bit, without outer parentheses.
    pub fn condition(&self, e: &E) -> Result<String, NetlistError> {
        let t = self.expression(e)?;
        if t.format != Format::Bit {
            return Err(self.error(format!("a condition is one bit, not a {}", t.format), e));
        }
        Ok(bare(&t))
    }

    fn expression(&self, e: &E) -> Result<Typed, NetlistError> {
        let made = |text: String, format| Ok(Typed { text, format });
        match e {
            E::Paren(inner) => self.expression(inner),
            E::Signal(name) => {
                let (text, format) = self
                    .names
                    .read(name)
                    .ok_or_else(|| self.error("name is not a signal of this module", e))?;
                self.reads.borrow_mut().insert(text.clone());
                made(text, format)
            }
            E::Literal(_) => Err(self.error("a literal alone has no format", e)),
            E::Index(base, at) => {
                let base = self.flat(base, e)?;
                let at = self.constant_index(at, base.format.width(), 1, e)?;
                let text = if base.format.width() == 1 {
                    base.text
                } else {
                    format!("{}[{at}]", base.text)
                };
                made(text, Format::Bit)
            }
            E::Slice(base, width, at) => {
                let base = self.flat(base, e)?;
                let at = self.constant_index(at, base.format.width(), *width, e)?;
                made(slice(&base, at, *width), Format::Unsigned(*width))
            }
            E::Unary(Unary::Not, inner) => {
                let t = self.expression(inner)?;
                let operator = if t.format == Format::Bit { "!" } else { "~" };
                made(format!("({operator}{})", t.text), t.format)
            }
            E::Unary(Unary::Any, inner) => {
                let t = self.flat(inner, e)?;
                made(format!("(|{})", t.text), Format::Bit)
            }
            E::Binary(a, op, b) => self.binary(a, op, b, e),
            _ => Err(self.error(
                "this expression may only stand alone on the right of an assignment",
                e,
            )),
        }
    }

    fn binary(&self, a: &E, op: &Op, b: &E, e: &E) -> Result<Typed, NetlistError> {
        let (a, b) = self.pair(a, b, e)?;
        let (symbol, compares) = match op {
            Op::Add => ("+", false),
            Op::Sub => ("-", false),
            Op::BitAnd => ("&", false),
            Op::BitOr => ("|", false),
            Op::BitXor => ("^", false),
            Op::LogicalAnd => ("&&", false),
            Op::LogicalOr => ("||", false),
            Op::Eq => ("==", true),
            Op::Ne => ("!=", true),
            Op::Lt => ("<", true),
            Op::Le => ("<=", true),
            Op::Gt => (">", true),
            Op::Ge => (">=", true),
            Op::Mul | Op::Shl | Op::Shr => {
                return Err(self.error("products and shifts are not supported", e))
            }
        };
        let logical = matches!(op, Op::LogicalAnd | Op::LogicalOr);
        if logical
            != (a.format == Format::Bit
                && !compares
                && !matches!(op, Op::BitAnd | Op::BitOr | Op::BitXor))
        {
            return Err(self.error(format!("{symbol} does not apply to a {}", a.format), e));
        }
        let format = if compares { Format::Bit } else { a.format };
        Ok(Typed {
            text: format!("({} {symbol} {})", a.text, b.text),
            format,
        })
    }

    /// A named signal: the only thing that may be sliced or converted.
    fn flat(&self, base: &E, e: &E) -> Result<Typed, NetlistError> {
        match peel(base) {
            E::Signal(_) => self.expression(base),
            _ => Err(self.error("only a named signal can be sliced or converted", e)),
        }
    }

    fn constant_index(
        &self,
        at: &E,
        width: usize,
        count: usize,
        e: &E,
    ) -> Result<usize, NetlistError> {
        let E::Literal(l) = peel(at) else {
            return Err(self.error("bit positions must be constants", e));
        };
        let at = literal_value(l).unwrap_or(u64::MAX) as usize;
        if at.saturating_add(count) > width {
            return Err(self.error(
                format!("bits {at}+:{count} lie outside a word of {width} bits"),
                e,
            ));
        }
        Ok(at)
    }

    /// Zero-extension or truncation of an unsigned word.
    fn resize(&self, inner: &E, width: usize, e: &E) -> Result<Typed, NetlistError> {
        let t = self.flat(inner, e)?;
        let Format::Unsigned(from) = t.format else {
            return Err(self.error(
                format!("bit_cast takes an unsigned word, not a {}", t.format),
                e,
            ));
        };
        let text = if width <= from {
            slice(&t, 0, width)
        } else {
            format!("{{{}'d0, {}}}", width - from, t.text)
        };
        Ok(Typed {
            text,
            format: Format::Unsigned(width),
        })
    }

    /// Low bits of a bus word, or a fixed-point word with the binary point moved.
    fn to_fixed(&self, inner: &E, target: Format, e: &E) -> Result<Typed, NetlistError> {
        let t = self.flat(inner, e)?;
        let Format::Fixed(tm, tn) = target else {
            return Err(self.error(
                format!("signed_cast gives a fixed-point word, not a {target}"),
                e,
            ));
        };
        match t.format {
            Format::Unsigned(from) if target.width() <= from => Ok(Typed {
                text: slice(&t, 0, target.width()),
                format: target,
            }),
            Format::Fixed(m, n) if tm >= m => {
                let drop = n.saturating_sub(tn);
                let kept = slice(&t, drop, t.format.width() - drop);
                let append = tn.saturating_sub(n);
                let extend = tm - m;
                let top = format!("{}[{}]", t.text, t.format.width() - 1);
                let mut parts = vec![];
                if extend > 0 {
                    parts.push(format!("{{{extend}{{{top}}}}}"));
                }
                parts.push(kept);
                if append > 0 {
                    parts.push(format!("{append}'d0"));
                }
                let text = if parts.len() == 1 {
                    parts.remove(0)
                } else {
                    format!("{{{}}}", parts.join(", "))
                };
                Ok(Typed {
                    text,
                    format: target,
                })
            }
            other => Err(self.error(format!("a {other} does not convert to {target}"), e)),
        }
    }

    /// The low integer bits of a fixed-point word, sign-extended when more are asked for than there are.
    fn integer_part(&self, inner: &E, target: Format, e: &E) -> Result<Typed, NetlistError> {
        let t = self.flat(inner, e)?;
        let (Format::Fixed(m, n), Format::Unsigned(width)) = (t.format, target) else {
            return Err(self.error(
                format!("a {} has no integer part of format {target}", t.format),
                e,
            ));
        };
        let have = m + 1;
        let text = if width <= have {
            slice(&t, n, width)
        } else {
            let top = format!("{}[{}]", t.text, t.format.width() - 1);
            format!("{{{{{}{{{top}}}}}, {}}}", width - have, slice(&t, n, have))
        };
        Ok(Typed {
            text,
            format: target,
        })
    }
}

/// `width` bits from `at`; the plain name when that is the whole word.
fn slice(t: &Typed, at: usize, width: usize) -> String {
    match (at, width, t.format.width()) {
        (0, w, full) if w == full => t.text.clone(),
        (at, 1, _) => format!("{}[{at}]", t.text),
        (at, w, _) => format!("{}[{}:{at}]", t.text, at + w - 1),
    }
}
