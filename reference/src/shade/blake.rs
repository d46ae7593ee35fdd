//! Angular interpolation with quadratic pieces for cosⁿ (Blake, Disselkoen and Kuijk 1992): cos θ = cos γ·cos ψ with ψ
//! growing evenly along a span (eqs 5–8, see [`super::sweep`]), and
//!
//!   (N·L) ≈ cos γ·q(ψ, 1),  (N·H)ⁿ ≈ cosⁿγ·q(ψ, n)
//!
//! with q of eq. 4 ([`super::curve::blake`]), so that each term is a quadratic of the pixel's place, by forward
//! differences. Five additions and three registers per pixel: two for each term and one for the sum.
//!
//! | method | q | ends of spans |
//! |---|---|---|
//! | `blake` | as printed | slerp along the edges |
//! | `blake-refit` | refitted a(n), b(n) | the same |
//! | `blake-trapezium` | as printed | the printed algebra on trapezia, a triangle being two with a collapsed edge |
//!
//! What the printed appendix has wrong is put right here: pieces begin at pixels (rounded up, also for negative columns)
//! and are half-open; the extreme of a piece is a real number, not a pixel; the bend is passed per pixel, K² times that
//! of q. The set-up of a piece is evaluated at its first pixel, so K may be 0.
//!
//! | work for each light | |
//! |---|---|
//! | pixel | 5 add (4 here, the colours' products and sums apart) |
//! | span | about 282 operations (353 with L and H that change) |
//! | triangle | 434 for a trapezium, 198 for a triangle (1080, 578), as the paper counts them |

use super::case::Case;
use super::circular::{per_material, Circular, Factor, Response};
use super::curve::{distance, Pieces};
use super::ends::{self, Referred, Trapezia};
use super::spherical::curved;
use super::sweep::Sweep;
use crate::geometry::Prepared;

/// The method on triangles.
pub type Blake = Circular<Referred, Quadratics>;
/// The method on trapezia.
pub type BlakeTrapezium = Circular<Trapezia, Quadratics>;

/// The pieces for each material.
pub struct Quadratics {
    diffuse: Pieces,
    powers: Vec<Pieces>,
}

impl Quadratics {
    fn new(p: &Prepared, pieces: impl Fn(f64) -> Pieces) -> Self {
        Self {
            diffuse: pieces(1.0),
            powers: per_material(p, pieces),
        }
    }
}

/// With eq. 4 as printed.
#[must_use]
pub fn printed(p: &Prepared) -> Blake {
    Circular {
        ends: Referred::new(p),
        response: Quadratics::new(p, Pieces::printed),
    }
}

/// With the refitted pieces.
#[must_use]
pub fn refit(p: &Prepared) -> Blake {
    Circular {
        ends: Referred::new(p),
        response: Quadratics::new(p, Pieces::refit),
    }
}

/// By way of trapezia, with eq. 4 as printed.
#[must_use]
pub fn trapezium(p: &Prepared) -> BlakeTrapezium {
    Circular {
        ends: Trapezia(Referred::new(p)),
        response: Quadratics::new(p, Pieces::printed),
    }
}

/// scale·q(ψ) by forward differences, piece by piece.
#[derive(Clone, Copy, Debug)]
pub struct Walk {
    value: f64,
    change: f64,
    bend: f64,
    /// Pixels up to the next piece; at least one.
    left: u32,
    /// Pixels of the pieces up to that.
    done: u32,
    pieces: Pieces,
    scale: f64,
    phase: f64,
    step: f64,
}

impl Walk {
    /// From the phase at the first pixel and its step.
    #[must_use]
    pub fn new(pieces: Pieces, scale: f64, phase: f64, step: f64) -> Self {
        let mut walk = Self {
            value: 0.0,
            change: 0.0,
            bend: 0.0,
            left: 0,
            done: 0,
            pieces,
            scale,
            phase,
            step,
        };
        walk.enter();
        walk
    }

    /// Begins the piece of the current pixel, the one after `done` pixels.
    fn enter(&mut self) {
        let Pieces { a, b } = self.pieces;
        let x = self.phase + f64::from(self.done) * self.step;
        // The extreme of the piece, its value there, half its bend and where it ends.
        let (extreme, top, half, end) = if x < -b {
            (0.0, 0.0, 0.0, -b)
        } else if x < -a {
            (-b, 0.0, 1.0 / (b * (b - a)), -a)
        } else if x < a {
            (0.0, 1.0, -1.0 / (a * b), a)
        } else if x < b {
            (b, 0.0, 1.0 / (b * (b - a)), b)
        } else {
            (0.0, 0.0, 0.0, f64::INFINITY)
        };
        let (half, o) = (half * self.scale, x - extreme);
        self.value = top * self.scale + half * o * o;
        self.change = half * self.step * (2.0 * o + self.step);
        self.bend = 2.0 * half * self.step * self.step;
        // The conversion saturates: a piece without end, or a phase at rest.
        self.left = (((end - x) / self.step).ceil() as u32).max(1);
    }
}

impl Factor for Walk {
    fn value(&self) -> f64 {
        self.value
    }

    fn step(&mut self) {
        self.value += self.change;
        self.change += self.bend;
        self.done += 1;
        self.left -= 1;
        if self.left == 0 {
            self.enter();
        }
    }
}

impl Response for Quadratics {
    type Diffuse<'a> = Walk;
    type Specular<'a> = Walk;

    fn diffuse(&self, s: &Sweep) -> Walk {
        let p = s.phase();
        Walk::new(self.diffuse, p.amplitude, p.phase, p.step)
    }

    fn specular(&self, s: &Sweep, material: usize, n: f64) -> Walk {
        let p = s.phase();
        Walk::new(self.powers[material], p.amplitude.powf(n), p.phase, p.step)
    }
}

/// Samples of [`distance`] for a bound, and what lies between two of them at most.
const SAMPLES: u32 = 1024;
const BETWEEN: f64 = 1e-5;

/// Bound on |method − truth|, LSB, of `blake` and `blake-trapezium`. Proved for far lights, where q's own distance from
/// cosⁿ is sampled and the rest is [`ends::triangle_lag`]; for lights that turn see [`turned`].
#[must_use]
pub fn bound(case: &Case) -> f64 {
    turned(case, |n| {
        distance(n, SAMPLES, &Pieces::printed(n)) + BETWEEN
    })
}

/// The largest distance of the refit from cosⁿ for any n from 1 on, fraction of full scale.
const REFIT: f64 = 7.0 / 255.0;
/// From n = 4 on.
const REFIT_SHINY: f64 = 3.72 / 255.0;

/// The same for `blake-refit`.
#[must_use]
pub fn bound_refit(case: &Case) -> f64 {
    turned(case, |n| match n {
        n if n >= 4.0 => REFIT_SHINY,
        n if n >= 1.0 => REFIT,
        _ => 1.0,
    })
}

/// Normals turned to a reference no farther than `turn` are at most spread + 2·turn apart, so their own blend strays as
/// a triangle of that spread does. What the turned blend itself strays is bounded as a sweep is in [`ends::strays`],
/// with both second derivatives over two directions: (spread + 2·turn)²/2. Proved, but far from reached.
fn turned(case: &Case, distance: impl Fn(f64) -> f64) -> f64 {
    let e = [distance(1.0), distance(case.shininess)];
    if case.turn == 0.0 {
        return curved(case, ends::triangle_lag, e);
    }
    let spread = case.spread + 2.0 * case.turn;
    let angle = ends::triangle_lag(spread) + spread.powi(2) / 2.0;
    if !angle.is_finite() {
        return case.whole();
    }
    let highlight = case.direction_of_highlight(angle) + e[1];
    case.terms((angle + e[0]).min(1.0), highlight.min(1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shade::curve::Curve;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(400))]
        #[test]
        fn forward_differences_are_the_pieces(
            n in 1.0..500.0f64, phase in -3.0..3.0f64, exponent in -12.0..0.0f64, count in 1u32..2048,
        ) {
            // Steps from nothing to a whole turn of π over the span.
            let step = std::f64::consts::PI / f64::from(count) * 10f64.powf(exponent);
            for q in [Pieces::printed(n), Pieces::refit(n.max(4.0))] {
                let mut walk = Walk::new(q, 0.7, phase, step);
                for k in 0..count {
                    let want = 0.7 * q.at(phase + f64::from(k) * step);
                    prop_assert!((walk.value() - want).abs() < 1e-11, "{k}: {} {want}", walk.value());
                    walk.step();
                }
            }
        }
    }

    #[test]
    fn a_phase_at_rest_stays() {
        for phase in [0.0, 0.1, -0.2, 2.0] {
            let q = Pieces::printed(20.0);
            let mut walk = Walk::new(q, 1.0, phase, 0.0);
            for _ in 0..5000 {
                walk.step();
                assert!((walk.value() - q.at(phase)).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn bounds_of_the_refit_hold_for_every_exponent() {
        for i in 0..100 {
            let n = 1.08f64.powi(i);
            let e = distance(n, SAMPLES, &Pieces::refit(n));
            let bound = if n >= 4.0 { REFIT_SHINY } else { REFIT };
            assert!(e <= bound, "{n}: {}", e * 255.0);
        }
    }
}
