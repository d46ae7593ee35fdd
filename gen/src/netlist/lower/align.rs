//! Fixed-point conversions as bits: moving the binary point, and taking the integer part.

use crate::netlist::{Expression, Format, Node};

/// Drops fraction bits (rounding towards minus infinity) or appends zeros, and extends by the sign or drops integer
/// bits; `None` when either is not fixed point.
pub fn align(e: Expression, to: Format) -> Option<Expression> {
    let (Format::Fixed(m, n), Format::Fixed(tm, tn)) = (e.format, to) else {
        return None;
    };
    let integer = m.min(tm);
    let drop = n.saturating_sub(tn);
    let fraction = n - drop;
    let kept = if (integer, fraction) == (m, n) {
        e
    } else {
        let format = Format::Fixed(integer, fraction);
        Expression::new(format, Node::Slice(Box::new(e), drop))
    };
    let append = tn.saturating_sub(n);
    let filled = if append > 0 {
        let format = Format::Fixed(integer, tn);
        Expression::new(format, Node::Append(Box::new(kept), append))
    } else {
        kept
    };
    Some(if tm > integer {
        Expression::new(to, Node::Resize(Box::new(filled)))
    } else {
        filled
    })
}

/// The low integer bits, rounding towards minus infinity; extended by the sign when more are asked for than there are.
pub fn integer_part(e: Expression, width: usize, to: Format) -> Expression {
    let Format::Fixed(m, n) = e.format else {
        return e;
    };
    if width <= m + 1 {
        if n == 0 && width == m + 1 {
            return Expression::new(to, Node::Reformat(Box::new(e)));
        }
        return Expression::new(to, Node::Slice(Box::new(e), n));
    }
    let whole = if n == 0 {
        e
    } else {
        Expression::new(Format::Fixed(m, 0), Node::Slice(Box::new(e), n))
    };
    let wide = Expression::new(Format::Signed(width), Node::Resize(Box::new(whole)));
    Expression::new(to, Node::Reformat(Box::new(wide)))
}
