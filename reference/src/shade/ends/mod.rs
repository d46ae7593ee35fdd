//! The vectors at the ends of a span, found in the four ways of the papers, and how far each strays from the truth.

pub mod blended;
pub mod referred;
pub mod slerped;
pub mod trapezium;

pub use blended::Blended;
pub use referred::Referred;
pub use slerped::Slerped;
pub use trapezium::Trapezia;

use super::case::Case;
use std::f64::consts::FRAC_PI_2;

/// The largest angle between slerp and the normalised linear blend of two unit vectors `g` rad apart, rad.
///
/// The blend has gone the angle φ(t) = atan2(t·sin g, 1 − t + t·cos g); φ − tg is extreme where φ' = g, and there
/// (t − ½)² = (sin g/g − (1 + cos g)/2) / (2(1 − cos g)).
#[must_use]
pub fn lag(g: f64) -> f64 {
    if g < 1e-3 {
        // g³/(36√3), the leading term; 1 % is more than the next one adds.
        return 1.01 * g.powi(3) / (36.0 * 3f64.sqrt());
    }
    let (sin, cos) = g.sin_cos();
    let t = 0.5
        - ((sin / g - (1.0 + cos) / 2.0) / (2.0 * (1.0 - cos)))
            .max(0.0)
            .sqrt();
    ((t * sin).atan2(1.0 - t + t * cos) - t * g).abs()
}

/// What slerp between the ends of a span strays from the truth when the ends are right, rad; proved for a spread up to
/// 90°, infinite beyond.
///
/// The ends are at most `spread` apart, since the cosine to a fixed vector along an arc is concave where it is positive.
/// The truth blends the two end *blends*, whose lengths lie between cos(spread/2) (between two vertices) and 1, so its
/// place on the arc is shifted by at most (1 − √r)/(1 + √r), r = cos(spread/2), and it lags by [`lag`].
#[must_use]
pub fn span_lag(spread: f64) -> f64 {
    if spread > FRAC_PI_2 {
        return f64::INFINITY;
    }
    let r = (spread / 2.0).cos().sqrt();
    lag(spread) + spread * (1.0 - r) / (1.0 + r)
}

/// The same when the ends are slerped along the edges themselves: each end lags by up to [`lag`], and where both ends
/// of an arc of g move by e, no place on it moves by more than e/cos(g/2) (a Jacobi field on the sphere).
#[must_use]
pub fn triangle_lag(spread: f64) -> f64 {
    if spread > FRAC_PI_2 {
        return f64::INFINITY;
    }
    let edge = lag(spread);
    span_lag(spread) + edge / ((spread + 2.0 * edge) / 2.0).cos()
}

/// Errors of N·L and of (N·H)ⁿ, as fractions of kd and ks, when normals stray by `lag(spread)` and lights and half-way
/// vectors by `lag(turn)`, and both turn at once. Proved: a sweep meets N·L at both ends, and the second derivatives of
/// both along the span are at most the square of the sum of the turns, so they differ by at most 2·(sum)²/8 between.
#[must_use]
pub fn strays(case: &Case, lag: fn(f64) -> f64, simultaneous: bool) -> [f64; 2] {
    let mut angle = lag(case.spread);
    if case.turn > 0.0 {
        angle += lag(case.turn);
        if simultaneous {
            angle += (case.spread + case.turn).powi(2) / 4.0;
        }
    }
    if !angle.is_finite() {
        return [1.0; 2];
    }
    [angle.min(1.0), case.direction_of_highlight(angle)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shade::turn::Arc;
    use glam::DVec3;
    use rand::rngs::StdRng;
    use rand::{Rng, SeedableRng};

    /// The row of the notes on slerp against the normalised blend: degrees, rad.
    #[test]
    fn the_lag_is_the_measured_one() {
        let rows = [
            (10.0, 0.0001),
            (20.0, 0.0007),
            (30.0, 0.0023),
            (45.0, 0.0080),
            (60.0, 0.0195),
            (90.0, 0.071),
        ];
        for (degrees, want) in rows {
            let g = f64::to_radians(degrees);
            assert!(
                (lag(g) - want).abs() <= 0.51e-4_f64.max(0.007 * want),
                "{degrees}: {}",
                lag(g)
            );
            let arc = Arc::new(DVec3::X, DVec3::new(g.cos(), g.sin(), 0.0));
            let sampled = (0..=4000)
                .map(|i| f64::from(i) / 4000.0)
                .map(|t| {
                    let blend = DVec3::X * (1.0 - t) + arc.at(1.0) * t;
                    blend.normalize().angle_between(arc.at(t))
                })
                .fold(0.0, f64::max);
            assert!(
                (lag(g) - sampled).abs() < 1e-6,
                "{degrees}: {} {sampled}",
                lag(g)
            );
        }
        for g in [0.5e-3, 0.999e-3, 1.001e-3f64] {
            let exact = g.powi(3) / (36.0 * 3f64.sqrt());
            assert!(lag(g) >= 0.99 * exact && lag(g) < 1.02 * exact, "{g}");
        }
    }

    /// Random triangles of unit vectors, slerped along two edges and between: never beyond the bound, and up to a third
    /// of it.
    #[test]
    fn no_triangle_strays_farther_than_proved() {
        let mut rng = StdRng::seed_from_u64(11);
        for degrees in [5.0, 20.0, 45.0, 90.0] {
            let spread = f64::to_radians(degrees);
            let mut worst = [0.0f64; 2];
            let mut tried = 0;
            while tried < 3000 {
                let mut n = [0; 3].map(|_| {
                    let v = DVec3::new(
                        rng.random_range(-1.0..1.0),
                        rng.random_range(-1.0..1.0),
                        rng.random_range(-1.0..1.0),
                    );
                    DVec3::Z + v * 1.2 * spread
                });
                if rng.random_bool(0.5) {
                    n[2] = n[1];
                }
                let n = n.map(DVec3::normalize);
                let angle = |i: usize, j: usize| n[i].angle_between(n[j]);
                if angle(0, 1).max(angle(0, 2)).max(angle(1, 2)) > spread {
                    continue;
                }
                tried += 1;
                let (p, q) = (rng.random::<f64>(), rng.random::<f64>());
                let slerped = Arc::new(Arc::new(n[0], n[1]).at(p), Arc::new(n[0], n[2]).at(q));
                let (l, r) = (n[0] * (1.0 - p) + n[1] * p, n[0] * (1.0 - q) + n[2] * q);
                let blended = Arc::new(l.normalize(), r.normalize());
                for i in 0..=10 {
                    let t = f64::from(i) / 10.0;
                    let truth = (l * (1.0 - t) + r * t).normalize();
                    worst[0] = worst[0].max(blended.at(t).angle_between(truth));
                    worst[1] = worst[1].max(slerped.at(t).angle_between(truth));
                }
            }
            let bound = [span_lag(spread), triangle_lag(spread)];
            println!("{degrees} deg: {worst:?} of {bound:?}");
            for i in 0..2 {
                assert!(
                    worst[i] <= bound[i] && worst[i] > 0.2 * bound[i],
                    "{degrees} {i}"
                );
            }
        }
    }
}
