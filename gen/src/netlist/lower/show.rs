//! Expressions and statements as a reader would write them, for error messages.

use rust_hdl_core::ast::{
    VerilogExpression as E, VerilogOp as Op, VerilogOpUnary as Unary, VerilogStatement as S,
};

fn symbol(op: &Op) -> &'static str {
    match op {
        Op::Add => "+",
        Op::Sub => "-",
        Op::Mul => "*",
        Op::LogicalAnd => "&&",
        Op::LogicalOr => "||",
        Op::BitXor => "^",
        Op::BitAnd => "&",
        Op::BitOr => "|",
        Op::Shl => "<<",
        Op::Shr => ">>",
        Op::Eq => "==",
        Op::Ne => "!=",
        Op::Lt => "<",
        Op::Le => "<=",
        Op::Gt => ">",
        Op::Ge => ">=",
    }
}

fn whole(e: &E) -> String {
    match e {
        E::Signal(name) => name.replace('$', "."),
        E::Literal(l) => {
            let text = format!("{l:x}");
            let digits = text.split_once("'h").map_or(text.as_str(), |(_, d)| d);
            u128::from_str_radix(digits, 16).map_or_else(|_| text.clone(), |v| v.to_string())
        }
        E::Cast(a, width) => format!("bit_cast::<{width}>({})", whole(a)),
        E::Signed(a) => format!("signed_cast({})", whole(a)),
        E::Unsigned(a) => format!("unsigned_cast({})", whole(a)),
        E::Paren(a) => format!("({})", whole(a)),
        E::Binary(a, op, b) => format!("{} {} {}", whole(a), symbol(op), whole(b)),
        E::Unary(Unary::Not, a) => format!("!{}", whole(a)),
        E::Unary(Unary::Neg, a) => format!("-{}", whole(a)),
        E::Unary(Unary::All, a) => format!("{}.all()", whole(a)),
        E::Unary(Unary::Any, a) => format!("{}.any()", whole(a)),
        E::Unary(Unary::Xor, a) => format!("{}.xor()", whole(a)),
        E::Index(a, at) => format!("{}.get_bit({})", whole(a), whole(at)),
        E::Slice(a, width, at) => format!("{}.get_bits::<{width}>({})", whole(a), whole(at)),
        E::IndexReplace(a, at, v) => {
            format!("{}.replace_bit({}, {})", whole(a), whole(at), whole(v))
        }
    }
}

fn short(text: String) -> String {
    if text.chars().count() <= 120 {
        return text;
    }
    text.chars().take(117).chain("...".chars()).collect()
}

/// An expression, at most 120 characters.
pub fn expression(e: &E) -> String {
    short(whole(e))
}

/// The head of a statement, at most 120 characters.
pub fn statement(s: &S) -> String {
    short(match s {
        S::Assignment(to, value) => format!("{} = {}", whole(to), whole(value)),
        S::SliceAssignment {
            base,
            width,
            offset,
            replacement,
        } => {
            format!(
                "{}[{}+:{width}] = {}",
                whole(base),
                whole(offset),
                whole(replacement)
            )
        }
        S::If(c) => format!("if {}", whole(&c.test)),
        S::Match(m) => format!("match {}", whole(&m.test)),
        S::Loop(l) => format!("for {}", l.index),
        S::Comment(t) => format!("// {t}"),
        S::Link(_) => "join or link".into(),
        S::Macro(_) => "macro".into(),
    })
}
