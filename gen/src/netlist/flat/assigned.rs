//! Every wire that a module must drive is assigned in all its bits on every path; otherwise it would be a latch.

use super::report::{error, spell_target};
use crate::netlist::{always_assigned, Module, Name, NetlistError, SignalKind, Statement, Target};
use std::collections::BTreeSet;

/// The targets that statements drive, after a check that nothing is missing.
pub(super) fn driven(
    m: &Module,
    path: &str,
    statements: &[Statement],
) -> Result<BTreeSet<Target>, NetlistError> {
    let mut any = BTreeSet::new();
    for s in statements {
        s.each_target(&mut |t| {
            any.insert(t.clone());
        });
    }
    let own = m
        .signals
        .iter()
        .filter(|s| matches!(s.kind, SignalKind::Local | SignalKind::Output))
        .map(|s| (Name::Signal(s.name.clone()), s.format));
    let inputs = m.children.iter().flat_map(|c| {
        let inputs = c.module.signals.iter();
        let inputs = inputs.filter(|s| s.kind == SignalKind::Input);
        inputs.map(|s| {
            let (child, port) = (c.name.clone(), s.name.clone());
            (Name::Port { child, port }, s.format)
        })
    });
    for (name, format) in own.chain(inputs) {
        let target = Target::Wire(name);
        let all = u128::MAX >> (128 - format.width());
        let what = if !any.contains(&target) {
            "has no driver"
        } else if always_assigned(statements, &target, format.width()) != all {
            "is not assigned on every path"
        } else {
            continue;
        };
        let what = format!("{} {what}", spell_target(&target));
        return Err(error(&m.name, path, what));
    }
    Ok(any)
}
