//! Abbas' set-up (2003, ch. 7) as Hast simplified it (2004, eqs 3.112–3.144), with the denominator's sign of 3.117, 3.118
//! and 3.128 put right: E₃₂D₂₃ − E₂₃D₃₂ = −2K³. It divides by y₁, so the vertices are turned to make |y₁| largest.

use super::polynomial::Polynomial;
use super::{Bends, Knots, Walk};

/// The coefficients; `None` without area.
#[must_use]
pub fn polynomial(knots: &Knots) -> Option<Polynomial> {
    let turned = knots.turned(|[_, y1, _, _]| y1.abs());
    let [x1, y1, x2, y2] = turned.sides();
    let k = turned.area2();
    if k == 0.0 || knots.area2() == 0.0 {
        return None;
    }
    let Bends { t, u, v, g, h } = Bends::of(&turned);
    let (f1, f2) = (1.0 / k, -0.5 / (k * k * k));
    let (c1, c2) = (4.0 * (t * y2 - v * y1), 4.0 * (u * y1 - v * y2));
    let (d23, d32, e23, e32) = (2.0 * x1 * k, -2.0 * x2 * k, y1 * k, -y2 * k);
    let a = (c1 * e32 - c2 * e23) * f2;
    let c = (c2 * d23 - c1 * d32) * f2;
    Some(Polynomial {
        origin: turned.position[0],
        a,
        b: (2.0 * t - a * x1 * x1 - c * x1 * y1) / (y1 * y1),
        c,
        d: (g * y2 - h * y1) * f1,
        e: (h * x1 - g * x2) * f1,
        f: turned.value[0],
    })
}

/// The walk.
#[must_use]
pub fn walk(knots: &Knots) -> Option<Walk> {
    Some(polynomial(knots)?.walk(knots))
}
