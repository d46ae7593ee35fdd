//! An optional synchronous reset: every register takes its power-up value at a clock edge that sees it.
//!
//! FPGA registers have values at power-up, so the descriptions have no reset. Where one is wanted it is added to the
//! netlist, not to the descriptions: an input `reset`, active high, in every module that holds a register or an
//! instance that does, and behind the other statements of each group of registers a choice that wins over them.
//! Words of a memory keep their values, and so does the word that it read last.

use super::groups::groups;
use super::{
    Body, Child, Expression, Format, Module, Name, NetlistError, Node, Signal, SignalKind,
    Statement, Target,
};
use std::collections::BTreeMap;

/// Name of the input.
pub const RESET: &str = "reset";

fn read() -> Expression {
    Expression::new(Format::Bit, Node::Read(Name::Signal(RESET.into())))
}

fn has_registers(m: &Module) -> bool {
    !m.registers.is_empty() || m.children.iter().any(|c| has_registers(&c.module))
}

/// One choice per group of registers, so that groups stay apart in the Verilog.
fn resets(m: &Module, statements: &[Statement]) -> Vec<Statement> {
    let owners: BTreeMap<Target, Vec<usize>> = m
        .registers
        .iter()
        .map(|r| {
            let target = Target::Register(r.name.clone());
            let at = (0..statements.len()).filter(|i| statements[*i].drives(&target));
            let at = at.collect();
            (target, at)
        })
        .collect();
    let initial = |target: Target| {
        let Target::Register(name) = &target else {
            return None;
        };
        let r = m.register(name)?;
        let value = Expression::literal(r.initial, r.format);
        Some(Statement::Assign {
            target,
            bits: None,
            value,
        })
    };
    let choice = |group: std::collections::BTreeSet<Target>| Statement::If {
        condition: read(),
        then: group.into_iter().filter_map(initial).collect(),
        otherwise: vec![],
    };
    groups(&owners).into_iter().map(choice).collect()
}

/// The design with a synchronous reset.
///
/// # Errors
/// A module that already uses the name.
pub fn with_reset(m: &Module) -> Result<Module, NetlistError> {
    if !has_registers(m) {
        return Ok(m.clone());
    }
    let used =
        m.signals.iter().any(|s| s.name == RESET) || m.registers.iter().any(|r| r.name == RESET);
    if used || m.children.iter().any(|c| c.name == RESET) {
        return Err(NetlistError::new(
            &m.name,
            format!("{RESET} is already a name of this module"),
        ));
    }
    let mut out = m.clone();
    // Behind the clock, where a reader looks for it.
    let place = out
        .signals
        .iter()
        .position(|s| s.format == Format::Clock)
        .map_or(0, |i| i + 1);
    out.signals.insert(
        place,
        Signal {
            name: RESET.into(),
            kind: SignalKind::Input,
            format: Format::Bit,
            doc: "Synchronous reset, active high: registers take their power-up values.".into(),
        },
    );
    let Body::Statements(statements) = &mut out.body else {
        return Ok(m.clone());
    };
    let mut added = resets(m, statements);
    for c in m.children.iter().filter(|c| has_registers(&c.module)) {
        let name = Name::Port {
            child: c.name.clone(),
            port: RESET.into(),
        };
        added.push(Statement::Assign {
            target: Target::Wire(name),
            bits: None,
            value: read(),
        });
    }
    statements.append(&mut added);
    out.children = m
        .children
        .iter()
        .map(|c| {
            Ok(Child {
                module: with_reset(&c.module)?,
                ..c.clone()
            })
        })
        .collect::<Result<_, NetlistError>>()?;
    Ok(out)
}
