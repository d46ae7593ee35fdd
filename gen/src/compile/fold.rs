//! Constant folding and the identities that descriptions bring up.

use super::graph::{Graph, Op, ValueId};
use crate::netlist::{ones, Operator, Reduction};

/// All bits of a width.
pub(super) fn mask(width: u32) -> u128 {
    ones(width as usize)
}

/// A code as a signed number.
fn signed(code: u128, width: u32) -> i128 {
    let shift = 128 - width;
    (code << shift) as i128 >> shift
}

/// The value of an operation on constants; `None` for what reads the state.
fn evaluate(g: &Graph, op: Op, width: u32) -> Option<u128> {
    let code = |v: ValueId| g.code(v);
    let of = |v: ValueId| Some((g.code(v)?, g.width(v)));
    let amount = |v: ValueId, width: u32| Some(code(v)?.min(u128::from(width)) as u32);
    let value = match op {
        Op::Constant(_) | Op::Load(_) | Op::Word(..) => return None,
        Op::Not(a) => !code(a)?,
        Op::Negate(a) => code(a)?.wrapping_neg(),
        Op::Binary(operator, a, b) => {
            let (a, b) = (code(a)?, code(b)?);
            match operator {
                Operator::Add => a.wrapping_add(b),
                Operator::Subtract => a.wrapping_sub(b),
                Operator::And => a & b,
                Operator::Or => a | b,
                Operator::Xor => a ^ b,
            }
        }
        Op::Product(sign, a, b) => {
            let ((a, wa), (b, wb)) = (of(a)?, of(b)?);
            if sign {
                signed(a, wa).wrapping_mul(signed(b, wb)) as u128
            } else {
                a.wrapping_mul(b)
            }
        }
        Op::Equal(a, b) => u128::from(code(a)? == code(b)?),
        Op::Less(sign, a, b) => {
            let ((a, wa), (b, wb)) = (of(a)?, of(b)?);
            u128::from(if sign {
                signed(a, wa) < signed(b, wb)
            } else {
                a < b
            })
        }
        Op::Reduce(r, a) => {
            let (a, w) = of(a)?;
            u128::from(match r {
                Reduction::All => a == mask(w),
                Reduction::Any => a != 0,
                Reduction::Parity => a.count_ones() % 2 == 1,
            })
        }
        Op::ShiftLeft(a, b) => code(a)?.checked_shl(amount(b, width)?).unwrap_or(0),
        Op::ShiftRight(a, b) => code(a)?.checked_shr(amount(b, width)?).unwrap_or(0),
        Op::Slice(a, at) => code(a)? >> at,
        Op::ZeroExtend(a) => code(a)?,
        Op::SignExtend(a) => {
            let (a, w) = of(a)?;
            signed(a, w) as u128
        }
        Op::ReplaceBit(a, position, bit) => {
            let (a, position, bit) = (code(a)?, code(position)?, code(bit)?);
            if position < u128::from(width) {
                a & !(1 << position) | bit << position
            } else {
                a
            }
        }
        Op::Insert(a, at, b) => {
            let (a, (b, w)) = (code(a)?, of(b)?);
            a & !(mask(w) << at) | b << at
        }
        Op::Choose(c, a, b) => {
            if code(c)? == 1 {
                code(a)?
            } else {
                code(b)?
            }
        }
    };
    Some(value & mask(width))
}

/// The node for an operation: a constant, an operand, a simpler operation, or the operation itself.
pub(super) fn simplest(g: &mut Graph, op: Op, width: u32) -> ValueId {
    if let Some(code) = evaluate(g, op, width) {
        return g.constant(code, width);
    }
    let zero = |g: &Graph, v: ValueId| g.code(v) == Some(0);
    let ones = |g: &Graph, v: ValueId| g.code(v) == Some(mask(g.width(v)));
    match op {
        Op::Not(a) => {
            if let Op::Not(inner) = g.op(a) {
                return inner;
            }
        }
        Op::Binary(operator, a, b) => match operator {
            Operator::Add | Operator::Or | Operator::Xor if zero(g, a) => return b,
            Operator::Add | Operator::Or | Operator::Xor | Operator::Subtract if zero(g, b) => {
                return a;
            }
            Operator::And if zero(g, a) || ones(g, b) => return a,
            Operator::And if zero(g, b) || ones(g, a) => return b,
            Operator::Or if ones(g, a) => return a,
            Operator::Or if ones(g, b) => return b,
            Operator::And | Operator::Or if a == b => return a,
            Operator::Xor | Operator::Subtract if a == b => return g.constant(0, width),
            Operator::Xor if ones(g, b) => return g.add(Op::Not(a), width),
            Operator::Xor if ones(g, a) => return g.add(Op::Not(b), width),
            _ => {}
        },
        Op::Equal(a, b) => {
            if a == b {
                return g.constant(1, 1);
            }
            if g.code(a).is_some() {
                return g.add(Op::Equal(b, a), 1);
            }
            if g.width(a) == 1 {
                match g.code(b) {
                    Some(1) => return a,
                    Some(_) => return g.not(a),
                    None => {}
                }
            }
        }
        Op::Less(_, a, b) if a == b => return g.constant(0, 1),
        Op::Reduce(_, a) if g.width(a) == 1 => return a,
        Op::ShiftLeft(a, b) | Op::ShiftRight(a, b) if zero(g, a) || zero(g, b) => return a,
        Op::Slice(a, at) => return slice(g, a, at, width),
        Op::ZeroExtend(a) | Op::SignExtend(a) if g.width(a) == width => return a,
        Op::ReplaceBit(a, position, bit) => {
            if let Some(position) = g.code(position) {
                if position < u128::from(width) {
                    return g.add(Op::Insert(a, position as u32, bit), width);
                }
                return a;
            }
        }
        Op::Insert(_, _, b) if g.width(b) == width => return b,
        Op::Choose(c, a, b) => return choose(g, c, a, b, width),
        _ => {}
    }
    g.node(op, width)
}

fn slice(g: &mut Graph, a: ValueId, at: u32, width: u32) -> ValueId {
    if g.width(a) == width {
        return a;
    }
    match g.op(a) {
        Op::Slice(inner, below) => g.add(Op::Slice(inner, below + at), width),
        Op::ZeroExtend(inner) if at + width <= g.width(inner) => g.add(Op::Slice(inner, at), width),
        Op::SignExtend(inner) if at + width <= g.width(inner) => g.add(Op::Slice(inner, at), width),
        _ => g.node(Op::Slice(a, at), width),
    }
}

fn choose(g: &mut Graph, c: ValueId, a: ValueId, b: ValueId, width: u32) -> ValueId {
    if a == b || g.code(c) == Some(1) {
        return a;
    }
    if g.code(c) == Some(0) {
        return b;
    }
    if let Op::Not(inner) = g.op(c) {
        return g.add(Op::Choose(inner, b, a), width);
    }
    if width == 1 {
        let not = |g: &mut Graph, v| g.not(v);
        match (g.code(a), g.code(b)) {
            (Some(1), Some(_)) => return c,
            (Some(_), Some(_)) => return not(g, c),
            (Some(1), None) => return g.add(Op::Binary(Operator::Or, c, b), 1),
            (Some(_), None) => {
                let c = not(g, c);
                return g.add(Op::Binary(Operator::And, c, b), 1);
            }
            (None, Some(0)) => return g.add(Op::Binary(Operator::And, c, a), 1),
            (None, Some(_)) => {
                let c = not(g, c);
                return g.add(Op::Binary(Operator::Or, c, a), 1);
            }
            (None, None) => {}
        }
    }
    g.node(Op::Choose(c, a, b), width)
}
