//! φ = A·x² + B·y² + C·xy + D·x + E·y + F and its forward differences down an edge and along lines (Hast 2004, eqs
//! 3.191–3.212): with k the slope of the edge and s = A·k² + C·k + B,
//! p = φ, dp = s + D'·k + E', d²p = 2s, q = D' + A, dq = 2A·k + C, d²r = 2A; D' and E' are the slopes of φ where the edge
//! begins.

use super::{Knots, Part, Walk};

/// The coefficients, about an origin.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Polynomial {
    /// Where x = y = 0.
    pub origin: (f64, f64),
    /// Of x².
    pub a: f64,
    /// Of y².
    pub b: f64,
    /// Of xy.
    pub c: f64,
    /// Of x.
    pub d: f64,
    /// Of y.
    pub e: f64,
    /// At the origin.
    pub f: f64,
}

impl Polynomial {
    /// The value at a place on the screen.
    #[must_use]
    pub fn value(&self, x: f64, y: f64) -> f64 {
        let (x, y) = (x - self.origin.0, y - self.origin.1);
        (self.a * x + self.c * y + self.d) * x + (self.b * y + self.e) * y + self.f
    }

    /// The walk of the triangle of `knots`.
    #[must_use]
    pub fn walk(&self, knots: &Knots) -> Walk {
        Walk {
            parts: knots.sorted().left_edges().map(|p| p.map(|p| self.part(p))),
        }
    }

    fn part(&self, edge: Part) -> Part {
        let (x, y) = (edge.start.0 - self.origin.0, edge.start.1 - self.origin.1);
        let k = edge.slope;
        let (dx, dy) = (
            2.0 * self.a * x + self.c * y + self.d,
            2.0 * self.b * y + self.c * x + self.e,
        );
        let s = (self.a * k + self.c) * k + self.b;
        Part {
            p: self.value(edge.start.0, edge.start.1),
            dp: s + dx * k + dy,
            d2p: 2.0 * s,
            q: dx + self.a,
            dq: 2.0 * self.a * k + self.c,
            d2r: 2.0 * self.a,
            ..edge
        }
    }
}
