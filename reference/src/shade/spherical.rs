//! Simultaneous spherical interpolation (Abbas 2003, section 6.2): N and L turn at once, one of them held.
//!
//! cos θ = A·cos(tg − α) along a span (eqs 6.6–6.8, see [`super::sweep`]), the highlight (A·cos(tg − α))ⁿ. Here with a
//! true cosine and a true power per pixel: the method as such, before the ROMs of section 6.3. The vector that turns
//! less is held, since it is the one at rest that must be: with a far light and viewer there is then no error but that of
//! slerp against the blend, and no quaternion.
//!
//! | work for each light | |
//! |---|---|
//! | pixel | 2 additions, 2 cosines, 1 power, 2 mul and the colours' 6 mul 6 add |
//! | span | 2 slerps, 1 angle, and for each of 2 terms 2 dots, 1 sine, 1 atan2, 1 hypot, 1 division |
//! | triangle | 3 arcs |

use super::case::Case;
use super::circular::{Circular, Factor, Response};
use super::ends::{self, Slerped};
use super::sweep::{Phase, Sweep};

/// The method.
pub type Spherical = Circular<Slerped, Angles>;

/// The method for any scene.
pub const SPHERICAL: Spherical = Circular {
    ends: Slerped,
    response: Angles,
};

/// True cosines of interpolated angles.
pub struct Angles;

/// (A·cos ψ)ⁿ, ψ growing evenly.
#[derive(Clone, Copy, Debug)]
pub struct Power {
    phase: Phase,
    n: f64,
}

impl Factor for Power {
    fn value(&self) -> f64 {
        let cos = self.phase.amplitude * self.phase.phase.cos();
        if cos > 0.0 {
            cos.powf(self.n)
        } else {
            0.0
        }
    }

    fn step(&mut self) {
        self.phase.phase += self.phase.step;
    }
}

/// max(0, A·cos ψ), ψ growing evenly.
#[derive(Clone, Copy, Debug)]
pub struct Cosine(pub Phase);

impl Factor for Cosine {
    fn value(&self) -> f64 {
        (self.0.amplitude * self.0.phase.cos()).max(0.0)
    }

    fn step(&mut self) {
        self.0.phase += self.0.step;
    }
}

impl Response for Angles {
    type Diffuse<'a> = Cosine;
    type Specular<'a> = Power;

    fn diffuse(&self, s: &Sweep) -> Cosine {
        Cosine(s.phase())
    }

    fn specular(&self, s: &Sweep, _: usize, n: f64) -> Power {
        Power {
            phase: s.phase(),
            n,
        }
    }
}

/// Bound on |method − truth|, LSB. Proved, up to a spread of 90°: see [`ends::triangle_lag`] and [`ends::strays`].
#[must_use]
pub fn bound(case: &Case) -> f64 {
    curved(case, ends::triangle_lag, [0.0; 2])
}

/// The bound of a method whose curves differ from cos and cosⁿ by at most `e`, fractions of full scale: A and Aⁿ, at
/// most 1, scale both curve and truth. Proved.
#[must_use]
pub fn curved(case: &Case, lag: fn(f64) -> f64, e: [f64; 2]) -> f64 {
    let [d, s] = ends::strays(case, lag, true);
    case.terms((d + e[0]).min(1.0), (s + e[1]).min(1.0))
}
