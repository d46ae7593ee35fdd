//! When affine addresses are good enough. With u at the vertices, weights λ on the screen and w = 1/depth, the affine
//! address is Σ λᵢuᵢ and the true one Σ λᵢwᵢuᵢ / Σ λᵢwᵢ.
//!
//! Their difference is cov(w, u)/mean(w) under the weights λ, and at most (√r − 1)/(√r + 1) of the extent of u, r being
//! the ratio of the largest to the smallest w (Zed3D 1996 says only that it grows with the tilt; law and proof are ours).
//! Proof: let λ' ∝ λw. For u in an interval of length E, |Σ (λ'ᵢ − λᵢ)uᵢ| ≤ E·max over sets A of λ'(A) − λ(A). Given
//! p = λ(A), λ'(A) is greatest when w is at its top in A and at its bottom elsewhere: λ'(A) = pr/(1 + p(r − 1)). The
//! difference p(1 − p)(r − 1)/(1 + p(r − 1)) is greatest at p = 1/(√r + 1), where it is (√r − 1)/(√r + 1). ∎ An edge
//! that carries the whole extent and the whole ratio reaches it, so the law is exact.

use glam::DVec2;

/// Affine addresses are used in place of perspective ones where they are proved to be off by less than this, in texels
/// and in each direction.
pub const TOLERANCE: f64 = 0.5;

/// (√r − 1)/(√r + 1): the largest error of affine addresses for a depth ratio r ≥ 1, as a part of the extent.
#[must_use]
pub fn worst_part(ratio: f64) -> f64 {
    let root = ratio.sqrt();
    (root - 1.0) / (root + 1.0)
}

/// What affine addresses on a triangle are off by at most, in the unit of `uv`; the greater of the two directions.
#[must_use]
pub fn bound(inv_w: &[f64; 3], uv: &[DVec2; 3]) -> f64 {
    let least = inv_w[0].min(inv_w[1]).min(inv_w[2]);
    let most = inv_w[0].max(inv_w[1]).max(inv_w[2]);
    let extent = uv[0].max(uv[1]).max(uv[2]) - uv[0].min(uv[1]).min(uv[2]);
    worst_part(most / least) * extent.max_element()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Both addresses from their definitions.
    fn error(l: [f64; 3], w: [f64; 3], u: [f64; 3]) -> f64 {
        let sum = |f: &dyn Fn(usize) -> f64| f(0) + f(1) + f(2);
        let truth = sum(&|i| l[i] * w[i] * u[i]) / sum(&|i| l[i] * w[i]);
        (sum(&|i| l[i] * u[i]) - truth).abs()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]
        #[test]
        fn no_triangle_exceeds_the_law(
            w in prop::array::uniform3(0.01..1.0f64), u in prop::array::uniform3(-500.0..500.0f64),
            a in 0.0..1.0f64, b in 0.0..1.0f64,
        ) {
            let (a, b) = if a + b > 1.0 { (1.0 - a, 1.0 - b) } else { (a, b) };
            let e = error([1.0 - a - b, a, b], w, u);
            prop_assert!(e <= bound(&w, &u.map(|u| DVec2::new(u, 0.0))) + 1e-9);
            prop_assert!(e <= bound(&w, &u.map(|u| DVec2::new(0.0, u))) + 1e-9);
        }
    }

    #[test]
    fn an_edge_reaches_it() {
        for r in [1.0, 1.05, 1.1, 1.5, 2.0, 4.0, 10.0, 1000.0] {
            let mut worst = 0.0f64;
            for k in 0..=100_000 {
                let t = f64::from(k) / 1e5;
                worst = worst.max(error([1.0 - t, t, 0.0], [1.0, r, 1.0], [0.0, 1.0, 0.0]));
            }
            let law = worst_part(r);
            assert!(
                worst <= law + 1e-12 && worst > law - 1e-6,
                "{r}: {worst} {law}"
            );
        }
        // The figures of the literature study.
        for (r, percent) in [
            (1.01, 0.25),
            (1.05, 1.2),
            (1.1, 2.4),
            (1.25, 5.6),
            (1.5, 10.1),
            (2.0, 17.2),
            (4.0, 33.3),
            (10.0, 52.0),
        ] {
            assert!((worst_part(r) * 100.0 - percent).abs() < 0.06, "{r}");
        }
    }
}
