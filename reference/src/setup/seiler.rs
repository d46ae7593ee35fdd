//! Seiler's set-up (as in Hast 2004, eqs 3.98–3.111): coefficients through the ratios i = x₂/x₁ and j = y₁/y₂. It divides
//! by x₁ and y₂, so the vertices are turned to make |x₁·y₂| largest; of the three turns at most one has x₁ = 0 and at most
//! one y₂ = 0, unless there is no area.

use super::polynomial::Polynomial;
use super::{Bends, Knots, Walk};

/// The coefficients; `None` without area.
#[must_use]
pub fn polynomial(knots: &Knots) -> Option<Polynomial> {
    if knots.area2() == 0.0 {
        return None;
    }
    let turned = knots.turned(|[x1, _, _, y2]| (x1 * y2).abs());
    let [x1, y1, x2, y2] = turned.sides();
    let Bends { t, u, v, g, h } = Bends::of(&turned);
    let (i, j) = (x2 / x1, y1 / y2);
    let k = 1.0 - i * j;
    let (kx, ky) = (k * x1, k * y2);
    Some(Polynomial {
        origin: turned.position[0],
        a: 2.0 * (t + u * j * j - 2.0 * v * j) / (kx * kx),
        b: 2.0 * (u + t * i * i - 2.0 * v * i) / (ky * ky),
        c: 4.0 * (2.0 * v - t * i - u * j - v * k) / (kx * ky),
        d: (g - h * j) / kx,
        e: (h - g * i) / ky,
        f: turned.value[0],
    })
}

/// The walk.
#[must_use]
pub fn walk(knots: &Knots) -> Option<Walk> {
    Some(polynomial(knots)?.walk(knots))
}
