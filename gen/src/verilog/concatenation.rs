//! Words put together of pieces: extended, filled with zeros, with a bit replaced.

use super::expression::{slice, Printer};
use crate::netlist::{Expression, Format, Node, Operator};

impl Printer<'_> {
    /// The pieces of a concatenation, highest first.
    pub(super) fn pieces(&mut self, e: &Expression) -> Vec<String> {
        match &e.node {
            Node::Append(a, zeros) => {
                let mut all = self.pieces(a);
                all.push(format!("{zeros}'d0"));
                all
            }
            Node::Resize(a) if e.width() > a.width() => {
                let more = e.width() - a.width();
                if !a.format.signed() {
                    let mut all = vec![format!("{more}'d0")];
                    all.extend(self.pieces(a));
                    return all;
                }
                let mut all = self.sign_and_pieces(a);
                let sign = all.remove(0);
                all.insert(
                    0,
                    if more == 1 {
                        sign
                    } else {
                        format!("{{{more}{{{sign}}}}}")
                    },
                );
                all
            }
            _ => vec![self.text(e)],
        }
    }

    /// The sign bit of a signed value, then its pieces.
    pub(super) fn sign_and_pieces(&mut self, e: &Expression) -> Vec<String> {
        let top = e.width() - 1;
        match &e.node {
            Node::Append(a, zeros) => {
                let mut all = self.sign_and_pieces(a);
                all.push(format!("{zeros}'d0"));
                all
            }
            Node::Slice(a, at) if matches!(a.node, Node::Read(_)) => {
                vec![self.slice(a, at + top, 1), self.slice(a, *at, e.width())]
            }
            _ => {
                let name = self.named(e);
                self.used(&name, 0, e.width());
                vec![slice(&name, e.width(), top, 1), name]
            }
        }
    }

    pub(super) fn replaced(
        &mut self,
        e: &Expression,
        a: &Expression,
        at: &Expression,
        bit: &Expression,
    ) -> String {
        let width = e.width();
        if let Node::Literal(position) = at.node {
            let position = usize::try_from(position).unwrap_or(usize::MAX);
            if position >= width {
                return self.text(a);
            }
            let mut pieces = vec![];
            if position + 1 < width {
                pieces.push(self.slice(a, position + 1, width - position - 1));
            }
            pieces.push(self.text(bit));
            if position > 0 {
                pieces.push(self.slice(a, 0, position));
            }
            return format!("{{{}}}", pieces.join(", "));
        }
        let format = Format::Unsigned(width);
        let of = |node| Expression::new(format, node);
        let one = of(Node::ShiftLeft(
            Box::new(Expression::literal(1, format)),
            Box::new(at.clone()),
        ));
        let word = of(Node::Reformat(Box::new(a.clone())));
        let kept = of(Node::Binary(
            Operator::And,
            Box::new(word),
            Box::new(of(Node::Not(Box::new(one)))),
        ));
        let set = of(Node::ShiftLeft(
            Box::new(if width > 1 {
                of(Node::Resize(Box::new(bit.clone())))
            } else {
                of(Node::Reformat(Box::new(bit.clone())))
            }),
            Box::new(at.clone()),
        ));
        self.text(&of(Node::Binary(
            Operator::Or,
            Box::new(kept),
            Box::new(set),
        )))
    }
}
