//! Names and widths: what the doc comments of the netlist promise, checked once so that later stages may rely on it.

use super::report::{error, spell, spell_target};
use crate::netlist::{
    Expression, Format, Module, Name, NetlistError, Node, SignalKind, Statement, Target,
};
use std::collections::HashSet;

/// Whether a code fits its width.
pub(super) fn code(
    m: &Module,
    path: &str,
    name: &str,
    code: u128,
    width: usize,
) -> Result<(), NetlistError> {
    if width < 128 && code >> width != 0 {
        let what = format!("{name}: code {code} does not fit {width} bits");
        return Err(error(&m.name, path, what));
    }
    Ok(())
}

struct Check<'a> {
    m: &'a Module,
    path: &'a str,
}

/// Checks statements against the module's declarations.
pub(super) fn statements(
    m: &Module,
    path: &str,
    statements: &[Statement],
) -> Result<(), NetlistError> {
    Check { m, path }.list(statements)
}

impl Check<'_> {
    fn fail<T>(&self, what: impl Into<String>) -> Result<T, NetlistError> {
        Err(error(&self.m.name, self.path, what))
    }

    fn format(&self, name: &Name) -> Result<Format, NetlistError> {
        match self.m.format_of(name) {
            Some(format) => Ok(format),
            None => self.fail(format!("{} is not declared", spell(name))),
        }
    }

    fn list(&self, list: &[Statement]) -> Result<(), NetlistError> {
        list.iter().try_for_each(|s| self.statement(s))
    }

    fn statement(&self, s: &Statement) -> Result<(), NetlistError> {
        match s {
            Statement::Assign {
                target,
                bits,
                value,
            } => {
                let whole = self.target(target)?;
                let name = spell_target(target);
                let width = match bits {
                    None => whole.width(),
                    Some(b) => {
                        let inside =
                            b.width >= 1 && b.at < whole.width() && b.width <= whole.width() - b.at;
                        if !inside {
                            let (at, n) = (b.at, b.width);
                            return self.fail(format!("{name}: no {n} bits at {at}"));
                        }
                        b.width
                    }
                };
                if value.width() != width {
                    let got = value.width();
                    return self.fail(format!("{name}: {got} bits assigned to {width}"));
                }
                if whole == Format::Clock {
                    return self.clock_value(&name, value);
                }
                self.expression(value)
            }
            Statement::If {
                condition,
                then,
                otherwise,
            } => {
                if condition.width() != 1 {
                    let width = condition.width();
                    return self.fail(format!("a condition has {width} bits; expected one"));
                }
                self.expression(condition)?;
                self.list(then)?;
                self.list(otherwise)
            }
            Statement::Case {
                subject,
                arms,
                otherwise,
            } => {
                self.expression(subject)?;
                let mut seen = HashSet::new();
                for a in arms {
                    code(self.m, self.path, "a label", a.label, subject.width())?;
                    if !seen.insert(a.label) {
                        return self.fail(format!("two choices have the label {}", a.label));
                    }
                    self.list(&a.body)?;
                }
                self.list(otherwise)
            }
        }
    }

    fn clock_value(&self, name: &str, value: &Expression) -> Result<(), NetlistError> {
        match &value.node {
            Node::Read(from) if self.format(from)? == Format::Clock => Ok(()),
            _ => self.fail(format!("clock {name} is not a plain name of another clock")),
        }
    }

    fn target(&self, target: &Target) -> Result<Format, NetlistError> {
        let name = match target {
            Target::Register(name) => Name::Register(name.clone()),
            Target::Wire(name) => name.clone(),
        };
        let kind = match &name {
            Name::Signal(s) => self.m.signal(s).map(|s| s.kind),
            Name::Port { child, port } => {
                let port = self.m.child(child).and_then(|c| c.module.signal(port));
                // From outside, an instance's input is what can be driven.
                port.map(|p| match p.kind {
                    SignalKind::Input => SignalKind::Output,
                    _ => SignalKind::Input,
                })
            }
            Name::Register(_) => Some(SignalKind::Local),
        };
        let register_as_wire =
            matches!(name, Name::Register(_)) && matches!(target, Target::Wire(_));
        match kind {
            Some(SignalKind::Local | SignalKind::Output) if !register_as_wire => self.format(&name),
            None => self.fail(format!("{} is not declared", spell(&name))),
            _ => self.fail(format!("{} cannot be assigned", spell(&name))),
        }
    }

    fn expression(&self, e: &Expression) -> Result<(), NetlistError> {
        for operand in e.operands() {
            self.expression(operand)?;
        }
        let width = e.width();
        let of = |i: usize| e.operands()[i].width();
        let signs = || e.operands()[0].format.signed() == e.operands()[1].format.signed();
        let right = match &e.node {
            Node::Literal(value) => return code(self.m, self.path, "a literal", *value, width),
            Node::Read(name) => {
                let format = self.format(name)?;
                if format == Format::Clock {
                    return self.fail(format!("clock {} is read as a value", spell(name)));
                }
                format.width() == width
            }
            Node::Not(_) | Node::Negate(_) | Node::Reformat(_) => of(0) == width,
            Node::Reduce(..) => width == 1,
            Node::Binary(..) => of(0) == width && of(1) == width,
            Node::Compare(..) => width == 1 && of(0) == of(1) && signs(),
            Node::Product(..) => width == of(0) + of(1) && signs(),
            Node::ShiftLeft(..) | Node::ShiftRight(..) => of(0) == width,
            Node::Slice(_, at) => *at < of(0) && width <= of(0) - *at,
            Node::Select(..) => width <= of(0),
            Node::Resize(_) => true,
            Node::Append(_, n) => of(0).checked_add(*n) == Some(width),
            Node::ReplaceBit(..) => of(0) == width && of(2) == 1,
        };
        if !right || !(1..=crate::netlist::MAX_WIDTH).contains(&width) {
            let text = format!("{:?}", e.node);
            let kind = text.split(['(', ' ']).next().unwrap_or_default();
            let widths: Vec<String> = e.operands().iter().map(|o| o.format.to_string()).collect();
            let from = widths.join(", ");
            return self.fail(format!("{kind} of {from} cannot be a {}", e.format));
        }
        Ok(())
    }
}
