//! The normal of a polygon from all its vertices (Newell's formula, as in Loisel 1996, whose two printed area formulas
//! have opposite signs; here both count counter-clockwise as positive):
//!
//!   A = Σ over edges i → j of ((yᵢ − yⱼ)(zᵢ + zⱼ), (zᵢ − zⱼ)(xᵢ + xⱼ), (xᵢ − xⱼ)(yᵢ + yⱼ)).
//!
//! Its components are twice the areas of the projections onto the coordinate planes, its length is twice the area of a
//! plane polygon. Noise in the vertices averages out, where three vertices alone take it all.

use glam::DVec3;

/// Twice the area times the unit normal, towards the side from which the corners turn counter-clockwise; zero for fewer
/// than three corners.
#[must_use]
pub fn area_vector(corners: &[DVec3]) -> DVec3 {
    // Far from the origin the sums would cancel; the vector does not depend on where the polygon is.
    let Some(origin) = corners.first() else {
        return DVec3::ZERO;
    };
    let ends = corners.iter().cycle().skip(1);
    corners
        .iter()
        .zip(ends)
        .map(|(p, q)| {
            let (p, q) = (*p - origin, *q - origin);
            DVec3::new(
                (p.y - q.y) * (p.z + q.z),
                (p.z - q.z) * (p.x + q.x),
                (p.x - q.x) * (p.y + q.y),
            )
        })
        .sum()
}

/// The unit normal; none when the polygon has no area.
#[must_use]
pub fn normal(corners: &[DVec3]) -> Option<DVec3> {
    area_vector(corners).try_normalize()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DQuat;
    use proptest::prelude::*;
    use rand::rngs::StdRng;
    use rand::{Rng, SeedableRng};
    use std::f64::consts::TAU;

    fn regular(n: usize) -> impl Iterator<Item = DVec3> {
        (0..n).map(move |k| {
            let (s, c) = (TAU * k as f64 / n as f64).sin_cos();
            DVec3::new(c, s, 0.0)
        })
    }

    #[test]
    fn counter_clockwise_is_positive() {
        let square =
            [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
        assert_eq!(area_vector(&square), DVec3::Z * 2.0);
        // As printed, the general formula has the other sign.
        let printed: f64 = (0..4)
            .map(|i| {
                let (p, q) = (square[i], square[(i + 1) % 4]);
                0.5 * (p.y + q.y) * (q.x - p.x)
            })
            .sum();
        assert_eq!(printed, -1.0);
        assert_eq!(normal(&square[..2]), None);
        assert_eq!(normal(&[]), None);
    }

    /// The advantage over the first three vertices, with noise of 1/1000 in z: the angles in degrees are measurements.
    #[test]
    fn noise_averages_out() {
        let mut rng = StdRng::seed_from_u64(4);
        let mut gauss = || {
            let (u, v): (f64, f64) = (rng.random_range(1e-12..1.0), rng.random());
            (-2.0 * u.ln()).sqrt() * (TAU * v).cos() * 1e-3
        };
        for (n, all, three) in [
            (4, 0.057, 0.082),
            (6, 0.047, 0.148),
            (8, 0.041, 0.246),
            (16, 0.028, 0.93),
        ] {
            let trials = 20_000;
            let (mut newell, mut first) = (0.0, 0.0);
            for _ in 0..trials {
                let p: Vec<DVec3> = regular(n).map(|p| p + DVec3::Z * gauss()).collect();
                let off = |n: DVec3| n.cross(DVec3::Z).length().asin().to_degrees().powi(2);
                newell += off(normal(&p).unwrap());
                first += off((p[1] - p[0]).cross(p[2] - p[0]).normalize());
            }
            let rms = |sum: f64| (sum / f64::from(trials)).sqrt();
            let (newell, first) = (rms(newell), rms(first));
            assert!((newell / all - 1.0).abs() < 0.05, "{n}: {newell}");
            assert!((first / three - 1.0).abs() < 0.05, "{n}: {first}");
        }
    }

    proptest! {
        /// Length and direction of the definition: the sum of a fan's cross products; wherever the polygon is.
        #[test]
        fn the_vector_is_the_sum_of_a_fan(
            points in prop::collection::vec((-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64), 3..9),
            axis in (-3.0..3.0f64, -3.0..3.0f64, -3.0..3.0f64), far in 0.0..1e6f64,
        ) {
            let turn = DQuat::from_scaled_axis(DVec3::from(axis));
            let p: Vec<DVec3> = points.iter().map(|p| turn * DVec3::from(*p) + DVec3::splat(far)).collect();
            let fan: DVec3 = (2..p.len()).map(|k| (p[k - 1] - p[0]).cross(p[k] - p[0])).sum();
            prop_assert!(area_vector(&p).distance(fan) < 1e-12);
        }
    }
}
