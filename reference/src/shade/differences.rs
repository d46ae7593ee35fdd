//! Colours along a span by forward differences: r += dr; dr += d2r.
//!
//! With u = λ₁, v = λ₂ the six knots give I = a·u² + b·v² + c·u·v + d·u + e·v + f, a = 2(I₀ + I₁ − 2I₀₁),
//! b = 2(I₀ + I₂ − 2I₀₂), c = 4(I₀ + I₁₂ − I₀₁ − I₀₂), d = 4I₀₁ − 3I₀ − I₁, e = 4I₀₂ − 3I₀ − I₂, f = I₀, and the
//! differences follow from a…f without a polynomial in x and y (Hast 2004, eqs 3.213–3.233; the form below is for any
//! order of the vertices). Every span starts at the exact weights of its first pixel centre.
//!
//! No sliver needs another way: the centres of a span lie in the triangle, so over its n steps u and v change by at most
//! 1, n·|∂u/∂x| ≤ 1 and n·|∂v/∂x| ≤ 1. With knots up to K the second difference is thus at most 32K/n², and rounding
//! (ε = 2⁻⁵³) adds up to no more than about (130 + 26n)·K·ε < 1e-7 LSB for n = 16384 and K = 1530, however thin the
//! triangle.

use crate::raster::Point;
use crate::shade::barycentric::{steps, weights};
use crate::shade::quadric::Quadric;
use crate::shade::shader::Run;

/// What a triangle's linear or quadratic colour needs per span.
#[derive(Clone, Copy, Debug)]
pub struct Interpolant {
    position: [Point; 3],
    step: [f64; 3],
    coefficients: [Quadric; 3],
}

/// The state of one span, three channels.
#[derive(Clone, Copy, Debug, Default)]
pub struct Differences {
    /// Value at the current pixel.
    pub r: [f64; 3],
    /// Change to the next one.
    pub dr: [f64; 3],
    /// Change of the change.
    pub d2r: [f64; 3],
}

impl Run for Differences {
    fn colour(&self) -> [f64; 3] {
        self.r
    }

    fn step(&mut self) {
        for c in 0..3 {
            self.r[c] += self.dr[c];
            self.dr[c] += self.d2r[c];
        }
    }
}

impl Interpolant {
    /// Linear, from three knots.
    #[must_use]
    pub fn linear(position: [Point; 3], knots: &[[f64; 3]; 3]) -> Self {
        Self::of(position, |c| Quadric::linear(knots.map(|k| k[c])))
    }

    /// Quadratic, from six knots (vertices 0, 1, 2, mid-edges 01, 02, 12).
    #[must_use]
    pub fn quadratic(position: [Point; 3], knots: &[[f64; 3]; 6]) -> Self {
        Self::of(position, |c| Quadric::quadratic(knots.map(|k| k[c])))
    }

    fn of(position: [Point; 3], channel: impl FnMut(usize) -> Quadric) -> Self {
        Self {
            position,
            step: steps(&position),
            coefficients: [0, 1, 2].map(channel),
        }
    }

    /// Differences at the centre of pixel (`x`, `y`).
    #[must_use]
    pub fn start(&self, x: i32, y: i32) -> Differences {
        let w = weights(&self.position, x, y);
        let mut out = Differences::default();
        for (i, k) in self.coefficients.iter().enumerate() {
            let f = k.start((w[1], w[2]), (self.step[1], self.step[2]));
            (out.r[i], out.dr[i], out.d2r[i]) = (f.r, f.dr, f.d2r);
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::{Viewport, Walk};
    use crate::shade::{gouraud, quadratic, KNOT_MAX};
    use proptest::prelude::*;

    const VIEWPORT: Viewport = Viewport {
        width: 2048,
        height: 512,
    };

    /// The largest difference between forward differences and the definition over all spans.
    fn worst(p: [Point; 3], knots: &[[f64; 3]; 6]) -> f64 {
        let three = [knots[0], knots[1], knots[2]];
        let (linear, square) = (
            Interpolant::linear(p, &three),
            Interpolant::quadratic(p, knots),
        );
        let mut worst = 0.0f64;
        for s in Walk::new(p, VIEWPORT)
            .iter()
            .flat_map(|w| w.spans(VIEWPORT.width).collect::<Vec<_>>())
        {
            let (mut l, mut q) = (linear.start(s.start, s.y), square.start(s.start, s.y));
            for x in s.start..s.end {
                let (tl, tq) = (
                    gouraud::value(&p, &three, x, s.y),
                    quadratic::value(&p, knots, x, s.y),
                );
                for c in 0..3 {
                    worst = worst
                        .max((l.r[c] - tl[c]).abs())
                        .max((q.r[c] - tq[c]).abs());
                }
                l.step();
                q.step();
            }
        }
        worst
    }

    fn knots() -> impl Strategy<Value = [[f64; 3]; 6]> {
        prop::array::uniform6(prop::array::uniform3(0.0..KNOT_MAX))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(400))]
        #[test]
        fn forward_differences_are_the_definition(
            p in prop::array::uniform3((-90_000..600_000i32, -90_000..150_000i32)), k in knots(),
        ) {
            let d = worst(p.map(|(x, y)| Point { x, y }), &k);
            prop_assert!(d < 1e-6, "{d}");
        }

        #[test]
        fn even_on_slivers(
            a in (0..500_000i32, 0..120_000i32), b in (0..500_000i32, 0..120_000i32), t in 0.0..1.0f64, off in -3..=3i32,
            k in knots(),
        ) {
            let mix = |p: i32, q: i32| p + (f64::from(q - p) * t) as i32;
            let c = (mix(a.0, b.0) + off, mix(a.1, b.1));
            let d = worst([a, b, c].map(|(x, y)| Point { x, y }), &k);
            prop_assert!(d < 1e-6, "{d}");
        }
    }
}
