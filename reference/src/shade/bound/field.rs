//! Unit vectors that turn over a triangle, and how fast: bounds of their first three derivatives.
//!
//! Every vector of the reflection model is a linear blend made unit: with the perspective weights wᵢ, the normal has the
//! direction of Σ λᵢwᵢnᵢ, the vector to a light at P that of Σ λᵢwᵢ(P − xᵢ), the vector to the eye likewise (λ the
//! weights on the screen; the common denominator Σ λw cancels). So let a = Σ λᵢaᵢ and N = a/|a|. Lengths in the plane
//! of λ are measured as if the triangle were equilateral with unit edges. Moving with unit speed, a' = u is constant, |u| ≤ U,
//! and with σ = N·u/|a| and m = |N'|²
//!
//! * N' = (u − N(N·u))/|a|, so |N'| ≤ κ = U/r where r ≤ |a| on the triangle;
//! * N'' = −2σN' − mN;
//! * N''' = (6σ² − 3m)N' + 6σmN.
//!
//! U² is the larger eigenvalue of the quadratic form |αA + βB|² over α² + αβ + β² (A, B two edges of the aᵢ); r is the least aᵢ·g with g the
//! unit mean, because a·g is linear; N·u is linear in a/|a| too: |N·u| ≤ (2/√3)·max |aₖ·edge|/r.

use glam::DVec3;

/// A unit vector over a triangle.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// A unit vector in the middle.
    pub middle: DVec3,
    /// Largest chord from `middle` to any vector of the field.
    pub spread: f64,
    /// κ, the bound of |N'|.
    pub turn: f64,
    /// The bound of |σ|, the logarithmic derivative of the length.
    pub stretch: f64,
    /// The vectors that are blended.
    corners: [DVec3; 3],
    /// r, the least length of the blend.
    least: f64,
}

impl Field {
    /// A vector that is the same everywhere.
    #[must_use]
    pub fn constant(v: DVec3) -> Self {
        Self {
            middle: v,
            spread: 0.0,
            turn: 0.0,
            stretch: 0.0,
            corners: [v; 3],
            least: v.length(),
        }
    }

    /// The field of a blend of three vectors; `None` when nothing can be promised: a vector is zero, or they are 60°
    /// or more from their mean.
    #[must_use]
    pub fn new(a: [DVec3; 3]) -> Option<Self> {
        let middle = (a[0] + a[1] + a[2]).try_normalize()?;
        let along = a.map(|v| v.dot(middle));
        let least = along[0].min(along[1]).min(along[2]);
        let mut spread = 0.0f64;
        for (v, d) in a.iter().zip(along) {
            let length = v.length();
            if !(d > 0.5 * length && length > 1e-150) {
                return None;
            }
            // |v/|v| − g|² = 2 − 2·v·g/|v|.
            spread = spread.max(2.0 - 2.0 * d / length);
        }
        let (p, q) = (a[1] - a[0], a[2] - a[0]);
        let (x, y, g) = (p.dot(p), q.dot(q), p.dot(q));
        let s = x + y - g;
        let square = (s + (s * s - 3.0 * (x * y - g * g)).max(0.0).sqrt()) / 1.5;
        let edges = [p, q, q - p];
        let mut radial = 0.0f64;
        for v in a {
            for e in edges {
                radial = radial.max(v.dot(e).abs());
            }
        }
        Some(Self {
            middle,
            // Rounding: the square root magnifies what is lost near zero.
            spread: (spread.max(0.0) + 1e-15).sqrt(),
            turn: square.sqrt() / least,
            stretch: 2.0 / 3.0f64.sqrt() * radial / (least * least),
            corners: a,
            least,
        })
    }

    /// How far the dot product with another field goes beyond zero on both sides: the lesser of its largest value and
    /// that of its negative, 0 where it keeps its sign. Its numerator Σ λᵢλⱼ aᵢ·bⱼ lies between the least and the largest
    /// of aᵢ·bᵢ and (aᵢ·bⱼ + aⱼ·bᵢ)/2, its denominator is r·r' at least.
    #[must_use]
    pub fn crossing(&self, other: &Self) -> f64 {
        let (a, b) = (&self.corners, &other.corners);
        let (mut lowest, mut highest) = (f64::INFINITY, f64::NEG_INFINITY);
        for i in 0..3 {
            for j in i..3 {
                let v = (a[i].dot(b[j]) + a[j].dot(b[i])) / 2.0;
                lowest = lowest.min(v);
                highest = highest.max(v);
            }
        }
        (highest.min(-lowest) / (self.least * other.least)).max(0.0)
    }

    /// Bounds of the lengths of the first three derivatives.
    #[must_use]
    pub fn derivatives(&self) -> [f64; 3] {
        let (k, s) = (self.turn, self.stretch);
        let (k2, s2) = (k * k, s * s);
        let third = (6.0 * s2).max(3.0 * k2);
        [
            k,
            k * (4.0 * s2 + k2).sqrt(),
            (k2 * third * third + 36.0 * s2 * k2 * k2).sqrt(),
        ]
    }
}

/// Bounds for the unit vector half-way between two unit vectors: middle, spread and derivatives. With F(s) = s/|s|,
/// |DF| ≤ 1/|s|, |D²F| ≤ 2/√3/|s|², |D³F| ≤ 3/|s|³ (the formulas above for their worst direction), and the chain rule.
#[must_use]
pub fn half_way(l: &Field, v: &Field) -> Option<(DVec3, f64, [f64; 3])> {
    let sum = l.middle + v.middle;
    let apart = l.spread + v.spread;
    let length = sum.length();
    let least = length - apart;
    if least < 0.1 {
        return None;
    }
    let (a, b) = (l.derivatives(), v.derivatives());
    let [d1, d2, d3] = [0, 1, 2].map(|i| (a[i] + b[i]) / least);
    let c = 2.0 / 3.0f64.sqrt();
    let bounds = [
        d1,
        c * d1 * d1 + d2,
        3.0 * d1 * d1 * d1 + 3.0 * c * d1 * d2 + d3,
    ];
    // |F(s) − F(t)| ≤ |s − t|/min(|s|, |t|) along the straight way, which stays at least `least` away from zero.
    Some((sum / length, apart / least, bounds))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn unit() -> impl Strategy<Value = DVec3> {
        (-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64)
            .prop_map(|(x, y, z)| DVec3::new(x, y, z))
            .prop_filter("no direction", |v| v.length() > 0.1)
            .prop_map(DVec3::normalize)
    }

    /// The field at α, β in the triangle with unit edges.
    fn at(a: &[DVec3; 3], s: f64, t: f64) -> DVec3 {
        (a[0] * (1.0 - s - t) + a[1] * s + a[2] * t).normalize()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(3000))]
        #[test]
        fn derivatives_are_bounded(
            n in unit(), d in prop::array::uniform3(unit()), size in 0.0..0.8f64, w in prop::array::uniform3(0.3..3.0f64),
            s in 0.05..0.9f64, t in 0.05..0.9f64, angle in 0.0..6.3f64,
        ) {
            let a = [0, 1, 2].map(|i| (n + d[i] * size).normalize() * w[i]);
            let (s, t) = (s * (1.0 - t), t);
            if let Some(f) = Field::new(a) {
                let here = at(&a, s, t);
                prop_assert!((here - f.middle).length() <= f.spread + 1e-12);
                // A unit step in the equilateral metric: α² + αβ + β² = 1.
                let (x, y) = (angle.cos(), angle.sin());
                let scale = (x * x + x * y + y * y).sqrt().recip();
                let (x, y) = (x * scale, y * scale);
                let h = 1e-3;
                let p = |k: f64| at(&a, s + k * h * x, t + k * h * y);
                let first = (p(1.0) - p(-1.0)) / (2.0 * h);
                let second = (p(1.0) - here * 2.0 + p(-1.0)) / (h * h);
                let third = (p(2.0) - p(1.0) * 2.0 + p(-1.0) * 2.0 - p(-2.0)) / (2.0 * h * h * h);
                let bounds = f.derivatives();
                for (got, bound) in [first, second, third].into_iter().zip(bounds) {
                    prop_assert!(got.length() <= bound * 1.001 + 1e-4, "{} {bound}", got.length());
                }
            }
        }

        #[test]
        fn half_way_vectors_are_bounded(
            l in unit(), v in unit(), d in prop::array::uniform3(unit()), e in prop::array::uniform3(unit()), size in 0.0..0.3f64,
            s in 0.05..0.9f64, t in 0.05..0.9f64, angle in 0.0..6.3f64,
        ) {
            let a = d.map(|d| l + d * size);
            let b = e.map(|e| v + e * size);
            let (s, t) = (s * (1.0 - t), t);
            let (Some(fa), Some(fb)) = (Field::new(a), Field::new(b)) else { return Ok(()) };
            if let Some((middle, spread, bounds)) = half_way(&fa, &fb) {
                let (x, y) = (angle.cos(), angle.sin());
                let scale = (x * x + x * y + y * y).sqrt().recip();
                let h = 1e-3;
                let p = |k: f64| {
                    let (s, t) = (s + k * h * x * scale, t + k * h * y * scale);
                    (at(&a, s, t) + at(&b, s, t)).normalize()
                };
                prop_assert!((p(0.0) - middle).length() <= spread + 1e-12);
                let first = (p(1.0) - p(-1.0)) / (2.0 * h);
                let second = (p(1.0) - p(0.0) * 2.0 + p(-1.0)) / (h * h);
                let third = (p(2.0) - p(1.0) * 2.0 + p(-1.0) * 2.0 - p(-2.0)) / (2.0 * h * h * h);
                for (got, bound) in [first, second, third].into_iter().zip(bounds) {
                    prop_assert!(got.length() <= bound * 1.001 + 1e-4, "{} {bound}", got.length());
                }
            }
        }
    }
}
