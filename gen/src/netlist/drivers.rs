//! Every wire is driven, once, on every path: undriven and doubly driven signals and latches are refused.

use super::{ones, Body, Module, Name, NetlistError, SignalKind, Statement, Target};
use std::collections::{BTreeMap, BTreeSet};

impl Statement {
    /// Whether some path of this statement assigns the target.
    #[must_use]
    pub fn drives(&self, to: &Target) -> bool {
        let any = |b: &[Statement]| b.iter().any(|s| s.drives(to));
        match self {
            Self::Assign { target, .. } => target == to,
            Self::If {
                then, otherwise, ..
            } => any(then) || any(otherwise),
            Self::Case {
                arms, otherwise, ..
            } => arms.iter().any(|a| any(&a.body)) || any(otherwise),
        }
    }

    /// Calls `f` with every target that some path assigns.
    pub fn each_target(&self, f: &mut impl FnMut(&Target)) {
        match self {
            Self::Assign { target, .. } => f(target),
            Self::If {
                then, otherwise, ..
            } => then.iter().chain(otherwise).for_each(|s| s.each_target(f)),
            Self::Case {
                arms, otherwise, ..
            } => {
                arms.iter()
                    .flat_map(|a| &a.body)
                    .chain(otherwise)
                    .for_each(|s| s.each_target(f));
            }
        }
    }

    /// Calls `f` with every name that this statement reads, conditions included.
    pub fn each_read(&self, f: &mut impl FnMut(&Name)) {
        match self {
            Self::Assign { value, .. } => value.each_read(f),
            Self::If {
                condition,
                then,
                otherwise,
            } => {
                condition.each_read(f);
                then.iter().chain(otherwise).for_each(|s| s.each_read(f));
            }
            Self::Case {
                subject,
                arms,
                otherwise,
            } => {
                subject.each_read(f);
                arms.iter()
                    .flat_map(|a| &a.body)
                    .chain(otherwise)
                    .for_each(|s| s.each_read(f));
            }
        }
    }
}

/// The bits of `to` that these statements assign on every path.
pub fn always_assigned(block: &[Statement], to: &Target, width: usize) -> u128 {
    let mut bits = 0;
    for s in block {
        bits |= match s {
            Statement::Assign { target, bits, .. } if target == to => {
                bits.map_or(ones(width), |b| ones(b.width) << b.at)
            }
            Statement::Assign { .. } => 0,
            Statement::If {
                then, otherwise, ..
            } => always_assigned(then, to, width) & always_assigned(otherwise, to, width),
            Statement::Case {
                arms, otherwise, ..
            } => arms
                .iter()
                .fold(always_assigned(otherwise, to, width), |b, a| {
                    b & always_assigned(&a.body, to, width)
                }),
        };
    }
    bits
}

fn spell(target: &Target) -> String {
    match target {
        Target::Wire(name) => name.verilog(),
        Target::Register(name) => format!("register {name}"),
    }
}

/// Checks the drivers of a module.
///
/// # Errors
/// The first wire or register that is not driven, or driven twice, or only sometimes.
pub fn check(
    m: &Module,
    held: &BTreeSet<String>,
    linked: &BTreeSet<Target>,
) -> Result<(), NetlistError> {
    let error = |what: String| Err(NetlistError::new(&m.name, what));
    let Body::Statements(statements) = &m.body else {
        return Ok(());
    };
    let mut times: BTreeMap<Target, usize> = BTreeMap::new();
    for s in statements {
        let mut own = BTreeSet::new();
        s.each_target(&mut |t| {
            own.insert(t.clone());
        });
        own.into_iter()
            .for_each(|t| *times.entry(t).or_default() += 1);
    }
    if let Some(twice) = linked
        .iter()
        .find(|t| times.get(t).copied().unwrap_or(0) > 1)
    {
        return error(format!(
            "{} is driven twice, by a join or link and by an assignment",
            spell(twice)
        ));
    }
    for r in &m.registers {
        let target = Target::Register(r.name.clone());
        let all = ones(r.format.width());
        if held.contains(&r.name) {
            continue;
        }
        if !times.contains_key(&target) {
            return error(format!(
                "register {} is never assigned or has no clock",
                r.name
            ));
        }
        if always_assigned(statements, &target, r.format.width()) != all {
            return error(format!(
                "register {} has no value on some path and no hold default; name it in dff_setup",
                r.name
            ));
        }
    }
    let own = m
        .signals
        .iter()
        .filter(|s| matches!(s.kind, SignalKind::Output | SignalKind::Local));
    let own = own.map(|s| (Name::Signal(s.name.clone()), s.format.width()));
    let inputs = m.children.iter().flat_map(|c| {
        let inputs = c
            .module
            .signals
            .iter()
            .filter(|s| s.kind == SignalKind::Input);
        inputs.map(|s| {
            (
                Name::Port {
                    child: c.name.clone(),
                    port: s.name.clone(),
                },
                s.format.width(),
            )
        })
    });
    for (name, width) in own.chain(inputs) {
        let what = match &name {
            Name::Port { child, port } => format!("input {port} of {child}"),
            Name::Signal(s) if m.signal(s).is_some_and(|s| s.kind == SignalKind::Output) => {
                format!("output {s}")
            }
            other => format!("wire {}", other.verilog()),
        };
        let target = Target::Wire(name);
        if !times.contains_key(&target) {
            return error(format!("{what} has no driver"));
        }
        if always_assigned(statements, &target, width) != ones(width) {
            return error(format!(
                "{what} is not assigned on every path: that would be a latch"
            ));
        }
    }
    Ok(())
}
