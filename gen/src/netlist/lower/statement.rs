//! Statements with their expressions typed; loops unrolled, `join` and `link` written as assignments.

use super::expression::{literal, Lowering};
use super::own_format::field_at;
use super::scope::{Driven, Meaning};
use super::show;
use crate::netlist::{Bits, Format, Name, NetlistError, Node, Statement, Target};
use rust_hdl_core::ast::{
    VerilogBlock, VerilogBlockOrConditional as Else, VerilogConditional, VerilogExpression as E,
    VerilogLiteral, VerilogLoop, VerilogStatement as S,
};
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

/// The number of a literal.
fn number(l: &VerilogLiteral) -> Option<u128> {
    literal(l).map(|(value, _)| value)
}

impl Lowering<'_> {
    pub(super) fn refuse(&self, what: impl Into<String>, s: &S) -> NetlistError {
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

    pub(super) fn block(
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

    pub(super) fn statement(
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

    pub(super) fn unroll(
        &mut self,
        l: &VerilogLoop,
        top: bool,
        s: &S,
        out: &mut Lowered,
        into: &mut Vec<Statement>,
    ) -> Result<(), NetlistError> {
        let (Some(from), Some(to)) = (number(&l.from), number(&l.to)) else {
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

    pub(super) fn assignment(
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

    pub(super) fn clock(
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

    pub(super) fn slice_assignment(
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
        let at = number(at)
            .and_then(|a| usize::try_from(a).ok())
            .unwrap_or(usize::MAX);
        if at.saturating_add(width) > format.width() {
            return Err(self.refuse(
                format!("bits {at}+:{width} lie outside {} bits", format.width()),
                s,
            ));
        }
        let value = self.of_format(
            value,
            field_at(&descriptor, at, width).unwrap_or(Format::Unsigned(width)),
        )?;
        Ok(Statement::Assign {
            target,
            bits: Some(Bits { at, width }),
            value,
        })
    }

    pub(super) fn conditional(
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
}
