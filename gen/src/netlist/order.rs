//! A wire is not read between two of its assignments.
//!
//! In rust-hdl's simulation a wire or output that is read has the value of the last assignment before the read, or, if
//! there was none, its settled value. The netlist knows settled values only. Both are the same unless the wire is
//! assigned before the read and again behind it; that is refused.

use super::{Body, Expression, Module, Name, NetlistError, SignalKind, Statement, Target};
use std::collections::{BTreeMap, BTreeSet};

struct Order<'a> {
    module: &'a Module,
    /// Wires that may have been assigned on the way here.
    before: BTreeSet<Name>,
    /// How often a wire may still be assigned from here on.
    after: BTreeMap<Name, usize>,
}

fn wires(s: &Statement) -> Vec<Name> {
    let mut names = vec![];
    s.each_target(&mut |t| {
        if let Target::Wire(name @ Name::Signal(_)) = t {
            names.push(name.clone());
        }
    });
    names
}

impl Order<'_> {
    fn add(&mut self, block: &[Statement]) {
        for name in block.iter().flat_map(wires) {
            *self.after.entry(name).or_default() += 1;
        }
    }

    fn remove(&mut self, block: &[Statement]) {
        for name in block.iter().flat_map(wires) {
            if let Some(count) = self.after.get_mut(&name) {
                *count -= 1;
            }
        }
    }

    fn read(&self, e: &Expression) -> Result<(), NetlistError> {
        let mut found = None;
        e.each_read(&mut |name| {
            let again = self.after.get(name).is_some_and(|c| *c > 0);
            if again && self.before.contains(name) {
                found = Some(name.verilog());
            }
        });
        let Some(name) = found else { return Ok(()) };
        let kind = match self.module.signal(&name).map(|s| s.kind) {
            Some(SignalKind::Output) => "output",
            _ => "wire",
        };
        Err(NetlistError::new(
            &self.module.name,
            format!("{kind} {name} is read between two of its assignments; give the earlier value a wire of its own"),
        ))
    }

    /// One of several blocks that exclude each other.
    fn branch(
        &mut self,
        block: &[Statement],
        before: &BTreeSet<Name>,
    ) -> Result<BTreeSet<Name>, NetlistError> {
        self.before.clone_from(before);
        self.add(block);
        self.block(block)?;
        Ok(std::mem::take(&mut self.before))
    }

    fn block(&mut self, block: &[Statement]) -> Result<(), NetlistError> {
        block.iter().try_for_each(|s| self.statement(s))
    }

    fn statement(&mut self, s: &Statement) -> Result<(), NetlistError> {
        let (condition, branches): (_, Vec<&[Statement]>) = match s {
            Statement::Assign { value, .. } => {
                self.read(value)?;
                self.remove(std::slice::from_ref(s));
                self.before.extend(wires(s));
                return Ok(());
            }
            Statement::If {
                condition,
                then,
                otherwise,
            } => (condition, vec![then, otherwise]),
            Statement::Case {
                subject,
                arms,
                otherwise,
            } => {
                let mut all: Vec<&[Statement]> = arms.iter().map(|a| a.body.as_slice()).collect();
                all.push(otherwise);
                (subject, all)
            }
        };
        self.read(condition)?;
        self.remove(std::slice::from_ref(s));
        let before = std::mem::take(&mut self.before);
        let mut joined = before.clone();
        for b in branches {
            joined.extend(self.branch(b, &before)?);
        }
        self.before = joined;
        Ok(())
    }
}

/// Checks the reads of a module, whose statements are in the order of the description.
///
/// # Errors
/// The first wire that is read between two of its assignments.
pub fn check(module: &Module) -> Result<(), NetlistError> {
    let Body::Statements(statements) = &module.body else {
        return Ok(());
    };
    let mut order = Order {
        module,
        before: BTreeSet::new(),
        after: BTreeMap::new(),
    };
    order.add(statements);
    order.block(statements)
}
