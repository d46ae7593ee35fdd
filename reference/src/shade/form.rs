//! A scalar that is linear or quadratic on a triangle, walked along spans by forward differences:
//!
//!   φ(λ) = Σ λᵢ·Iᵢ + Σ kᵢⱼ·λᵢλⱼ,  ij = 01, 02, 12.
//!
//! This form needs no order of the vertices (Hast 2004, section 3.3.4, has the same with two of the weights), and the
//! bows kᵢⱼ are 0 exactly where the scalar is linear. On the edge ij, φ departs from the line between its ends by
//! kᵢⱼ·t(1 − t), so φ(middle) = (Iᵢ + Iⱼ)/2 + kᵢⱼ/4. Per span 18 multiplications, per pixel r += dr; dr += d2r.

use super::barycentric::{steps, weights};
use super::quadratic::EDGES;
use crate::raster::{Point, Span};
use glam::DVec3;

/// What a span starts from.
#[derive(Clone, Copy, Debug)]
pub struct Start {
    /// The corners of the triangle on the screen.
    pub position: [Point; 3],
    /// The span.
    pub span: Span,
    /// Weights at the centre of its first pixel.
    pub weights: [f64; 3],
    /// Changes of the weights from pixel to pixel.
    pub steps: [f64; 3],
}

impl Start {
    /// The start of a span of a triangle.
    #[must_use]
    pub fn new(position: [Point; 3], span: Span) -> Self {
        Self {
            position,
            span,
            weights: weights(&position, span.start, span.y),
            steps: steps(&position),
        }
    }
}

/// Something that changes from pixel to pixel.
pub trait Step {
    /// Moves one pixel to the right.
    fn step(&mut self);
}

/// Something that is set up once per triangle and started once per span.
pub trait Quantity: Send + Sync {
    /// What it is along a span.
    type Walk: Step;

    /// At the first pixel of a span.
    fn start(&self, at: &Start) -> Self::Walk;
}

impl<W: Step, const N: usize> Step for [W; N] {
    fn step(&mut self) {
        self.iter_mut().for_each(Step::step);
    }
}

impl<Q: Quantity, const N: usize> Quantity for [Q; N] {
    type Walk = [Q::Walk; N];

    fn start(&self, at: &Start) -> Self::Walk {
        self.each_ref().map(|q| q.start(at))
    }
}

impl<W: Step> Step for Option<W> {
    fn step(&mut self) {
        self.iter_mut().for_each(Step::step);
    }
}

impl<Q: Quantity> Quantity for Option<Q> {
    type Walk = Option<Q::Walk>;

    fn start(&self, at: &Start) -> Self::Walk {
        self.as_ref().map(|q| q.start(at))
    }
}

impl<A: Step, B: Step> Step for (A, B) {
    fn step(&mut self) {
        self.0.step();
        self.1.step();
    }
}

impl<A: Quantity, B: Quantity> Quantity for (A, B) {
    type Walk = (A::Walk, B::Walk);

    fn start(&self, at: &Start) -> Self::Walk {
        (self.0.start(at), self.1.start(at))
    }
}

impl Step for () {
    fn step(&mut self) {}
}

impl Quantity for () {
    type Walk = ();

    fn start(&self, _: &Start) {}
}

/// A linear or quadratic scalar.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Form {
    /// Iᵢ, values at the vertices.
    pub corner: [f64; 3],
    /// kᵢⱼ, for the edges of [`EDGES`].
    pub bow: [f64; 3],
}

impl Form {
    /// Linear between values at the vertices.
    #[must_use]
    pub fn linear(corner: [f64; 3]) -> Self {
        Self {
            corner,
            bow: [0.0; 3],
        }
    }

    /// Quadratic, from values at the vertices and at the middles of the edges of [`EDGES`].
    #[must_use]
    pub fn knots(corner: [f64; 3], middle: [f64; 3]) -> Self {
        let bow = |k: usize| {
            let (i, j) = EDGES[k];
            4.0 * middle[k] - 2.0 * (corner[i] + corner[j])
        };
        Self {
            corner,
            bow: [0, 1, 2].map(bow),
        }
    }

    /// (Σ λᵢaᵢ)·(Σ λᵢbᵢ): since λᵢ² = λᵢ − Σ λᵢλⱼ over the others, kᵢⱼ = −(aᵢ − aⱼ)·(bᵢ − bⱼ).
    #[must_use]
    pub fn product(a: &[DVec3; 3], b: &[DVec3; 3]) -> Self {
        Self {
            corner: [0, 1, 2].map(|i| a[i].dot(b[i])),
            bow: EDGES.map(|(i, j)| -(a[i] - a[j]).dot(b[i] - b[j])),
        }
    }

    /// |Σ λᵢaᵢ|² of unit vectors from the cosines of the angles between them alone, in the order of [`EDGES`]:
    /// 1 − Σ 2(1 − cᵢⱼ)·λᵢλⱼ. These belong to edges of a mesh and do not change when it turns.
    #[must_use]
    pub fn squared_length(cosine: [f64; 3]) -> Self {
        Self {
            corner: [1.0; 3],
            bow: cosine.map(|c| -2.0 * (1.0 - c)),
        }
    }

    /// The value at barycentric weights.
    #[must_use]
    pub fn at(&self, w: [f64; 3]) -> f64 {
        let [a, b, c] = self.corner;
        let [k, l, m] = self.bow;
        w[0] * a + w[1] * b + w[2] * c + k * w[0] * w[1] + l * w[0] * w[2] + m * w[1] * w[2]
    }
}

/// A scalar along a span.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Slide {
    /// At the current pixel.
    pub r: f64,
    /// Change to the next one.
    pub dr: f64,
    /// Change of the change.
    pub d2r: f64,
}

impl Step for Slide {
    fn step(&mut self) {
        self.r += self.dr;
        self.dr += self.d2r;
    }
}

impl Quantity for Form {
    type Walk = Slide;

    fn start(&self, at: &Start) -> Slide {
        let (w, d) = (at.weights, at.steps);
        let mut slide = Slide {
            r: self.at(w),
            dr: (0..3).map(|i| self.corner[i] * d[i]).sum(),
            d2r: 0.0,
        };
        for (k, (i, j)) in self.bow.iter().zip(EDGES) {
            slide.dr += k * (w[i] * d[j] + w[j] * d[i] + d[i] * d[j]);
            slide.d2r += 2.0 * k * d[i] * d[j];
        }
        slide
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::{Viewport, Walk};
    use proptest::prelude::*;

    fn vectors() -> impl Strategy<Value = [DVec3; 3]> {
        prop::array::uniform3(prop::array::uniform3(-1.0..1.0f64)).prop_map(|v| v.map(DVec3::from))
    }

    fn blend(w: [f64; 3], v: &[DVec3; 3]) -> DVec3 {
        v[0] * w[0] + v[1] * w[1] + v[2] * w[2]
    }

    proptest! {
        #[test]
        fn products_are_the_products_of_blends(a in vectors(), b in vectors(), u in 0.0..1.0f64, v in 0.0..1.0f64) {
            let w = [1.0 - u - v, u, v];
            let want = blend(w, &a).dot(blend(w, &b));
            prop_assert!((Form::product(&a, &b).at(w) - want).abs() < 1e-13);
            let unit = a.map(|v| v.try_normalize().unwrap_or(DVec3::X));
            let q = Form::squared_length(EDGES.map(|(i, j)| unit[i].dot(unit[j])));
            prop_assert!((q.at(w) - blend(w, &unit).length_squared()).abs() < 1e-13);
        }

        #[test]
        fn forward_differences_are_the_values_over_the_longest_spans(
            p in prop::array::uniform3((-90_000..600_000i32, -90_000..150_000i32)),
            corner in prop::array::uniform3(-1.0..1.0f64), middle in prop::array::uniform3(-1.0..1.0f64),
        ) {
            let p = p.map(|(x, y)| Point { x, y });
            let form = Form::knots(corner, middle);
            for (k, (i, j)) in EDGES.into_iter().enumerate() {
                let mut w = [0.0; 3];
                (w[i], w[j]) = (0.5, 0.5);
                prop_assert!((form.at(w) - middle[k]).abs() < 1e-14);
            }
            let Some(walk) = Walk::new(p, Viewport { width: 2048, height: 512 }) else { return Ok(()) };
            for span in walk.spans(2048) {
                let mut s = form.start(&Start::new(p, span));
                for x in span.start..span.end {
                    let want = form.at(weights(&p, x, span.y));
                    prop_assert!((s.r - want).abs() < 1e-9, "{} {want}", s.r);
                    s.step();
                }
            }
        }
    }

    #[test]
    fn linear_forms_have_no_second_difference() {
        let a = [DVec3::X, DVec3::Y, DVec3::new(0.6, 0.0, 0.8)];
        let form = Form::product(&a, &[DVec3::new(0.3, 0.4, 0.5); 3]);
        assert_eq!(form.bow, [0.0; 3]);
    }
}
