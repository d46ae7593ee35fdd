//! Lee and Jen's set-up (as in Hast 2004, eqs 3.145–3.158): everything over K = x₁y₂ − x₂y₁, so only a triangle without area
//! is singular.

use super::polynomial::Polynomial;
use super::{Bends, Knots, Walk};

/// The coefficients; `None` without area.
#[must_use]
pub fn polynomial(knots: &Knots) -> Option<Polynomial> {
    let [x1, y1, x2, y2] = knots.sides();
    let (w1, w2) = (x1 * y2, x2 * y1);
    let w3 = w1 - w2;
    if w3 == 0.0 {
        return None;
    }
    let Bends { t, u, v, g, h } = Bends::of(knots);
    let inverse = 1.0 / w3;
    let square = inverse * inverse;
    Some(Polynomial {
        origin: knots.position[0],
        a: 2.0 * (t * y2 * y2 + u * y1 * y1 - 2.0 * v * y1 * y2) * square,
        b: 2.0 * (u * x1 * x1 + t * x2 * x2 - 2.0 * v * x1 * x2) * square,
        c: 4.0 * (v * (w1 + w2) - u * x1 * y1 - t * x2 * y2) * square,
        d: (g * y2 - h * y1) * inverse,
        e: (h * x1 - g * x2) * inverse,
        f: knots.value[0],
    })
}

/// The walk.
#[must_use]
pub fn walk(knots: &Knots) -> Option<Walk> {
    Some(polynomial(knots)?.walk(knots))
}
