//! Statements with their expressions typed; loops unrolled, `join` and `link` written as assignments.

use super::expression::Lowering;
use super::scope::{Driven, Meaning};
use super::show;
use crate::netlist::{Arm, Bits, Expression, Format, Name, NetlistError, Node, Statement, Target};
use rust_hdl_core::ast::{
    VerilogBlock, VerilogBlockOrConditional as Else, VerilogConditional, VerilogExpression as E,
    VerilogLink, VerilogLinkDetails, VerilogLoop, VerilogMatch, VerilogStatement as S,
};
use rust_hdl_core::type_descriptor::{TypeDescriptor, TypeKind};
use std::collections::{BTreeMap, BTreeSet};

/// Most statements that a module's loops may unroll to; beyond it a loop bound is a mistake.
const MOST_STATEMENTS: usize = 100_000;

/// What the statements of a module say.
#[derive(Default)]
pub struct Lowered {
    /// Statements, without clock connections, holds and comments.
    pub statements: Vec<Statement>,
    /// The clock input that each register is connected to.
    pub clocks: BTreeMap<String, String>,
    /// Registers that keep their value unless assigned.
    pub held: BTreeSet<String>,
    /// Targets that a `join` or `link` drives.
    pub linked: BTreeSet<Target>,
    count: usize,
}

fn literal_usize(l: &rust_hdl_core::ast::VerilogLiteral) -> Option<u128> {
    crate::netlist::read::literal_code(&format!("{l:x}"))
}

/// The number that a pattern spells, such as `3`, `0x1f_usize` or `true`.
fn pattern_number(text: &str) -> Option<u128> {
    match text {
        "true" => return Some(1),
        "false" => return Some(0),
        _ => {}
    }
    let text = text.replace('_', "");
    let (radix, digits) = match text.get(..2) {
        Some("0x") => (16, &text[2..]),
        Some("0b") => (2, &text[2..]),
        Some("0o") => (8, &text[2..]),
        _ => (10, text.as_str()),
    };
    let end = digits
        .find(|c: char| !c.is_digit(radix))
        .unwrap_or(digits.len());
    let suffix = &digits[end..];
    let known = ["", "u8", "u16", "u32", "u64", "u128", "usize", "i32", "i64"];
    known
        .contains(&suffix)
        .then(|| u128::from_str_radix(&digits[..end], radix).ok())?
}

impl Lowering<'_> {
    fn refuse(&self, what: impl Into<String>, s: &S) -> NetlistError {
        self.scope
            .error(format!("{}: {}", what.into(), show::statement(s)))
    }

    /// The statements of a body.
    pub fn body(&mut self, block: &VerilogBlock) -> Result<Lowered, NetlistError> {
        let mut out = Lowered::default();
        let mut statements = vec![];
        self.block(block, true, &mut out, &mut statements)?;
        out.statements = statements;
        Ok(out)
    }

    fn block(
        &mut self,
        block: &VerilogBlock,
        top: bool,
        out: &mut Lowered,
        into: &mut Vec<Statement>,
    ) -> Result<(), NetlistError> {
        block
            .iter()
            .try_for_each(|s| self.statement(s, top, out, into))
    }

    fn statement(
        &mut self,
        s: &S,
        top: bool,
        out: &mut Lowered,
        into: &mut Vec<Statement>,
    ) -> Result<(), NetlistError> {
        out.count += 1;
        if out.count > MOST_STATEMENTS {
            return Err(self.scope.error(format!(
                "loops unroll to more than {MOST_STATEMENTS} statements"
            )));
        }
        match s {
            S::Comment(_) => Ok(()),
            S::Macro(inner) => self.block(inner, top, out, into),
            S::Assignment(to, value) => self.assignment(to, value, top, s, out, into),
            S::SliceAssignment {
                base,
                width,
                offset,
                replacement,
            } => {
                let statement = self.slice_assignment(base, *width, offset, replacement, s)?;
                into.push(statement);
                Ok(())
            }
            S::If(c) => {
                let statement = self.conditional(c, out)?;
                into.push(statement);
                Ok(())
            }
            S::Match(m) => {
                let statement = self.choice(m, s, out)?;
                into.push(statement);
                Ok(())
            }
            S::Loop(l) => self.unroll(l, top, s, out, into),
            S::Link(links) if top => links.iter().try_for_each(|l| self.link(l, s, out, into)),
            S::Link(_) => Err(self.refuse("a join or link stands inside a condition", s)),
        }
    }

    fn unroll(
        &mut self,
        l: &VerilogLoop,
        top: bool,
        s: &S,
        out: &mut Lowered,
        into: &mut Vec<Statement>,
    ) -> Result<(), NetlistError> {
        let (Some(from), Some(to)) = (literal_usize(&l.from), literal_usize(&l.to)) else {
            return Err(self.refuse("the bounds of a loop are constants", s));
        };
        for i in from..to {
            self.scope.enter(&l.index, i);
            let done = self.block(&l.block, top, out, into);
            self.scope.leave();
            done?;
        }
        Ok(())
    }

    fn assignment(
        &mut self,
        to: &E,
        value: &E,
        top: bool,
        s: &S,
        out: &mut Lowered,
        into: &mut Vec<Statement>,
    ) -> Result<(), NetlistError> {
        let E::Signal(name) = to else {
            return Err(self.refuse("only a name can be assigned to", s));
        };
        let (target, format) = match self.scope.driven(name)? {
            Driven::RegisterClock(register) => return self.clock(register, value, top, s, out),
            Driven::Target(target, format, _) => (target, format),
        };
        let value = self.of_format(value, format)?;
        if let (Target::Register(register), Node::Read(Name::Register(read)), true) =
            (&target, &value.node, top)
        {
            let first = !out.held.contains(register) && !into.iter().any(|s| s.drives(&target));
            if register == read && first {
                out.held.insert(register.clone());
                return Ok(());
            }
        }
        into.push(Statement::Assign {
            target,
            bits: None,
            value,
        });
        Ok(())
    }

    fn clock(
        &self,
        register: String,
        value: &E,
        top: bool,
        s: &S,
        out: &mut Lowered,
    ) -> Result<(), NetlistError> {
        if !top {
            return Err(self.refuse(
                format!("the clock of register {register} is assigned conditionally"),
                s,
            ));
        }
        let E::Signal(name) = value else {
            return Err(self.refuse(format!("register {register} is not clocked by an input"), s));
        };
        let clock = match self.scope.read(name)? {
            Meaning::Value(Name::Signal(clock), Format::Clock, _) => clock,
            _ => {
                return Err(
                    self.refuse(format!("register {register} is not clocked by an input"), s)
                )
            }
        };
        if let Some(other) = out.clocks.insert(register.clone(), clock.clone()) {
            if other != clock {
                return Err(self.refuse(
                    format!("register {register} has two clocks, {other} and {clock}"),
                    s,
                ));
            }
        }
        Ok(())
    }

    fn slice_assignment(
        &self,
        base: &E,
        width: usize,
        offset: &E,
        value: &E,
        s: &S,
    ) -> Result<Statement, NetlistError> {
        let (E::Signal(name), E::Literal(at)) = (base, offset) else {
            return Err(self.refuse("only a field of a named structure can be assigned to", s));
        };
        let Driven::Target(target, format, descriptor) = self.scope.driven(name)? else {
            return Err(self.refuse("a clock has no fields", s));
        };
        let at = literal_usize(at)
            .and_then(|a| usize::try_from(a).ok())
            .unwrap_or(usize::MAX);
        if at.saturating_add(width) > format.width() {
            return Err(self.refuse(
                format!("bits {at}+:{width} lie outside {} bits", format.width()),
                s,
            ));
        }
        let value = self.of_format(value, field_format(&descriptor, at, width))?;
        Ok(Statement::Assign {
            target,
            bits: Some(Bits { at, width }),
            value,
        })
    }

    fn conditional(
        &mut self,
        c: &VerilogConditional,
        out: &mut Lowered,
    ) -> Result<Statement, NetlistError> {
        let condition = self.condition(&c.test)?;
        let mut then = vec![];
        self.block(&c.then, false, out, &mut then)?;
        let mut otherwise = vec![];
        match &c.otherwise {
            Else::Block(b) => self.block(b, false, out, &mut otherwise)?,
            Else::Conditional(s) => self.statement(s, false, out, &mut otherwise)?,
            Else::None => {}
        }
        Ok(Statement::If {
            condition,
            then,
            otherwise,
        })
    }

    fn choice(
        &mut self,
        m: &VerilogMatch,
        s: &S,
        out: &mut Lowered,
    ) -> Result<Statement, NetlistError> {
        let format = self
            .own_format(&m.test)?
            .ok_or_else(|| self.refuse("the matched value has no format", s))?;
        let subject = self.of_format(&m.test, format)?;
        let mut arms: Vec<Arm> = vec![];
        let mut otherwise = None;
        let mut complete = false;
        for case in &m.cases {
            let mut body = vec![];
            self.block(&case.block, false, out, &mut body)?;
            if otherwise.is_some() {
                continue;
            }
            if case.condition == "default" {
                otherwise = Some(body);
                continue;
            }
            let (label, name, variants) = self.label(&case.condition, format, s)?;
            if arms.iter().any(|a| a.label == label) {
                continue;
            }
            arms.push(Arm { label, name, body });
            let all = variants.map_or_else(
                || 1u128.checked_shl(format.width() as u32),
                |v| Some(v as u128),
            );
            complete |= all == Some(arms.len() as u128);
        }
        // A match that names every value needs no default: its last arm serves, so that no latch is suspected.
        if otherwise.is_none() && complete {
            otherwise = arms.pop().map(|a| a.body);
        }
        Ok(Statement::Case {
            subject,
            arms,
            otherwise: otherwise.unwrap_or_default(),
        })
    }

    /// Code and name of a pattern, and how many variants its enumeration has.
    fn label(
        &self,
        pattern: &str,
        format: Format,
        s: &S,
    ) -> Result<(u128, String, Option<usize>), NetlistError> {
        if let Some((code, width, variants)) = self.scope.variant(pattern) {
            if format != Format::Enumeration(width) {
                return Err(self.refuse(format!("a {format} is matched with {pattern}"), s));
            }
            self.variants
                .borrow_mut()
                .insert(pattern.to_string(), (code, width));
            let name = super::scope::plain(pattern);
            return Ok((code, name, Some(variants)));
        }
        let code =
            pattern_number(pattern).filter(|_| matches!(format, Format::Bit | Format::Unsigned(_)));
        let code = code.ok_or_else(|| self.refuse(self.scope.not_a_variant(pattern), s))?;
        if format.width() < 128 && code >> format.width() != 0 {
            return Err(self.refuse(format!("pattern {code} does not fit {format}"), s));
        }
        Ok((code, String::new(), None))
    }

    fn link(
        &self,
        link: &VerilogLink,
        s: &S,
        out: &mut Lowered,
        into: &mut Vec<Statement>,
    ) -> Result<(), NetlistError> {
        let side = |base: &str, d: &VerilogLinkDetails| {
            let field = d.my_name.trim_start_matches('.');
            if field.is_empty() {
                base.to_string()
            } else {
                format!("{base}${field}")
            }
        };
        let (to, from) = match link {
            VerilogLink::Forward(d) => (side(&d.other_name, d), side(&d.owner_name, d)),
            VerilogLink::Backward(d) => (side(&d.owner_name, d), side(&d.other_name, d)),
            VerilogLink::Bidirectional(_) => {
                return Err(self.refuse("wires that are driven from both ends are not supported", s))
            }
        };
        let Driven::Target(target, format, _) = self.scope.driven(&to)? else {
            return Err(self.refuse("the clock of a register is set with dff_setup", s));
        };
        let Meaning::Value(name, own, _) = self.scope.read(&from)? else {
            return Err(self.refuse(format!("{from} is not a signal"), s));
        };
        if own != format {
            return Err(self.refuse(format!("a {own} is joined to a {format}"), s));
        }
        if !out.linked.insert(target.clone()) {
            return Err(self.refuse(format!("{} is joined twice", to.replace('$', ".")), s));
        }
        let value = Expression::new(own, Node::Read(name));
        into.push(Statement::Assign {
            target,
            bits: None,
            value,
        });
        Ok(())
    }
}

/// The format of the field of a structure at these bits; an unsigned word if it is no field.
fn field_format(d: &TypeDescriptor, at: usize, width: usize) -> Format {
    if let TypeKind::Composite(fields) = &d.kind {
        let mut offset = 0;
        for f in fields {
            let Some(format) = Format::from_descriptor(&f.kind) else {
                break;
            };
            if offset == at && format.width() == width {
                return format;
            }
            offset += format.width();
        }
    }
    Format::Unsigned(width)
}

#[cfg(test)]
mod tests {
    use super::pattern_number;

    #[test]
    fn patterns_are_numbers() {
        assert_eq!(pattern_number("12"), Some(12));
        assert_eq!(pattern_number("0x1f_usize"), Some(31));
        assert_eq!(pattern_number("0b1_01u8"), Some(5));
        assert_eq!(pattern_number("true"), Some(1));
        assert_eq!(pattern_number("x"), None);
        assert_eq!(pattern_number("3cats"), None);
    }
}
