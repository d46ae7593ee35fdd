//! Constants taken to their end: expressions of constants become literals, choices by constants are made.
//!
//! A named constant that stands alone keeps its name. Nothing else is rewritten: the netlist stays in the shape of its
//! description.

use super::{
    ones, Body, Comparison, Expression, Module, Name, Node, Operator, Reduction, SignalKind,
    Statement,
};

/// A code as a number of its sign.
fn number(code: u128, e: &Expression) -> i128 {
    let unused = 128 - e.width() as u32;
    ((code << unused) as i128) >> unused
}

fn shifted(code: u128, amount: u128, left: bool) -> u128 {
    let amount = u32::try_from(amount).unwrap_or(u32::MAX);
    let moved = if left {
        code.checked_shl(amount)
    } else {
        code.checked_shr(amount)
    };
    moved.unwrap_or(0)
}

fn compare(c: Comparison, a: (u128, &Expression), b: (u128, &Expression)) -> bool {
    let order = if a.1.format.signed() {
        number(a.0, a.1).cmp(&number(b.0, b.1))
    } else {
        a.0.cmp(&b.0)
    };
    match c {
        Comparison::Equal => order.is_eq(),
        Comparison::NotEqual => order.is_ne(),
        Comparison::Less => order.is_lt(),
        Comparison::LessEqual => order.is_le(),
        Comparison::Greater => order.is_gt(),
        Comparison::GreaterEqual => order.is_ge(),
    }
}

/// The code of an expression whose names all have a value; `None` when one has not.
pub fn evaluate(e: &Expression, value: &impl Fn(&Name) -> Option<u128>) -> Option<u128> {
    let of = |x: &Expression| evaluate(x, value);
    let code = match &e.node {
        Node::Literal(code) => *code,
        Node::Read(name) => value(name)?,
        Node::Not(a) => !of(a)?,
        Node::Negate(a) => of(a)?.wrapping_neg(),
        Node::Reduce(how, a) => {
            let code = of(a)?;
            u128::from(match how {
                Reduction::All => code == ones(a.width()),
                Reduction::Any => code != 0,
                Reduction::Parity => code.count_ones() % 2 == 1,
            })
        }
        Node::Binary(op, a, b) => {
            let (a, b) = (of(a)?, of(b)?);
            match op {
                Operator::Add => a.wrapping_add(b),
                Operator::Subtract => a.wrapping_sub(b),
                Operator::And => a & b,
                Operator::Or => a | b,
                Operator::Xor => a ^ b,
            }
        }
        Node::Compare(c, a, b) => u128::from(compare(*c, (of(a)?, a), (of(b)?, b))),
        Node::Product(a, b) => {
            let (x, y) = (of(a)?, of(b)?);
            if e.format.signed() {
                number(x, a).wrapping_mul(number(y, b)) as u128
            } else {
                x.wrapping_mul(y)
            }
        }
        Node::ShiftLeft(a, by) => shifted(of(a)?, of(by)?, true),
        Node::ShiftRight(a, by) | Node::Select(a, by) => shifted(of(a)?, of(by)?, false),
        Node::Slice(a, at) => shifted(of(a)?, *at as u128, false),
        Node::Resize(a) if a.format.signed() => number(of(a)?, a) as u128,
        Node::Resize(a) | Node::Reformat(a) => of(a)?,
        Node::Append(a, zeros) => shifted(of(a)?, *zeros as u128, true),
        Node::ReplaceBit(a, at, bit) => {
            let bit_mask = shifted(1, of(at)?, true);
            let set = if of(bit)? == 1 { bit_mask } else { 0 };
            of(a)? & !bit_mask | set
        }
    };
    Some(code & ones(e.width()))
}

struct Folding<'a> {
    constants: &'a dyn Fn(&Name) -> Option<u128>,
}

impl Folding<'_> {
    fn expression(&self, e: &mut Expression) {
        if matches!(e.node, Node::Literal(_) | Node::Read(_)) {
            return;
        }
        if let Some(code) = evaluate(e, &self.constants) {
            e.node = Node::Literal(code);
            return;
        }
        match &mut e.node {
            Node::Literal(_) | Node::Read(_) => {}
            Node::Not(a)
            | Node::Negate(a)
            | Node::Reduce(_, a)
            | Node::Slice(a, _)
            | Node::Resize(a)
            | Node::Reformat(a)
            | Node::Append(a, _) => self.expression(a),
            Node::Binary(_, a, b)
            | Node::Compare(_, a, b)
            | Node::Product(a, b)
            | Node::ShiftLeft(a, b)
            | Node::ShiftRight(a, b)
            | Node::Select(a, b) => {
                self.expression(a);
                self.expression(b);
            }
            Node::ReplaceBit(a, b, c) => {
                self.expression(a);
                self.expression(b);
                self.expression(c);
            }
        }
    }

    fn block(&self, block: Vec<Statement>) -> Vec<Statement> {
        block.into_iter().flat_map(|s| self.statement(s)).collect()
    }

    fn statement(&self, s: Statement) -> Vec<Statement> {
        match s {
            Statement::Assign {
                target,
                bits,
                mut value,
            } => {
                self.expression(&mut value);
                vec![Statement::Assign {
                    target,
                    bits,
                    value,
                }]
            }
            Statement::If {
                mut condition,
                then,
                otherwise,
            } => {
                self.expression(&mut condition);
                match evaluate(&condition, &self.constants) {
                    Some(0) => self.block(otherwise),
                    Some(_) => self.block(then),
                    None => vec![Statement::If {
                        condition,
                        then: self.block(then),
                        otherwise: self.block(otherwise),
                    }],
                }
            }
            Statement::Case {
                mut subject,
                mut arms,
                otherwise,
            } => {
                self.expression(&mut subject);
                if let Some(code) = evaluate(&subject, &self.constants) {
                    let at = arms.iter().position(|a| a.label == code);
                    return self.block(at.map_or(otherwise, |i| arms.swap_remove(i).body));
                }
                for arm in &mut arms {
                    arm.body = self.block(std::mem::take(&mut arm.body));
                }
                vec![Statement::Case {
                    subject,
                    arms,
                    otherwise: self.block(otherwise),
                }]
            }
        }
    }
}

/// Folds the constants of a module's statements.
pub fn fold(m: &mut Module) {
    let Body::Statements(statements) = std::mem::replace(&mut m.body, Body::Statements(vec![]))
    else {
        return;
    };
    let constants = |name: &Name| match name {
        Name::Signal(s) => m.signal(s).and_then(|s| match s.kind {
            SignalKind::Constant(code) => Some(code),
            _ => None,
        }),
        _ => None,
    };
    let folded = Folding {
        constants: &constants,
    }
    .block(statements);
    m.body = Body::Statements(folded);
}
