//! Orientations: frames of three unit vectors, kept orthonormal, and unit quaternions between which one turns evenly.
//!
//! - Re-orthonormalisation by *modified* Gram–Schmidt: each vector loses its parts along the ones before one after the
//!   other, from what is already reduced. The classical form, as Loisel (1996) prints it, takes all parts from the original
//!   vector and fails where vectors are nearly dependent.
//! - The quaternion of a matrix after Shepperd (1978): of the four squares 4W² = 1 + m₁₁ + m₂₂ + m₃₃ and so on the greatest,
//!   at least 1, is divided by. Loisel divides by W, which is nothing at a turn of 180°.
//! - slerp: q(t) = (sin((1 − t)φ)·q₁ + sin(tφ)·q₂)/sin φ along the shorter arc (q and −q are one orientation), with
//!   φ = 2·atan2(|q₁ − q₂|, |q₁ + q₂|), which loses nothing at small angles as an arc cosine does. For φ → 0 it is
//!   the straight line, normalised.

use glam::{DMat3, DQuat, DVec3, DVec4};

/// The nearest-by orthonormal frame: the first column keeps its direction, the second its plane with the first. None for
/// columns without three independent directions.
#[must_use]
pub fn orthonormalise(m: DMat3) -> Option<DMat3> {
    let x = m.x_axis.try_normalize()?;
    let y = (m.y_axis - x * x.dot(m.y_axis)).try_normalize()?;
    let z = m.z_axis - x * x.dot(m.z_axis);
    let z = (z - y * y.dot(z)).try_normalize()?;
    Some(DMat3::from_cols(x, y, z))
}

/// The quaternion of a rotation matrix.
#[must_use]
pub fn quaternion(m: DMat3) -> DQuat {
    let [a, b, c] = [m.x_axis, m.y_axis, m.z_axis];
    // Four times the squares of x, y, z and w.
    let squares = [
        1.0 + a.x - b.y - c.z,
        1.0 - a.x + b.y - c.z,
        1.0 - a.x - b.y + c.z,
        1.0 + a.x + b.y + c.z,
    ];
    let greatest = (1..4).fold(0, |k, i| if squares[i] > squares[k] { i } else { k });
    // Four times the products of the greatest with each.
    let products = match greatest {
        0 => DVec4::new(squares[0], a.y + b.x, a.z + c.x, b.z - c.y),
        1 => DVec4::new(a.y + b.x, squares[1], b.z + c.y, c.x - a.z),
        2 => DVec4::new(a.z + c.x, b.z + c.y, squares[2], a.y - b.x),
        _ => DVec4::new(b.z - c.y, c.x - a.z, a.y - b.x, squares[3]),
    };
    DQuat::from_vec4(products.normalize())
}

/// Angles below which slerp is a line: it is then off by 0.016·φ³, far less than rounding.
const STRAIGHT: f64 = 1e-5;

/// The orientation at `t`, 0 to 1, on the shorter way from one to another; constant speed.
#[must_use]
pub fn slerp(from: DQuat, to: DQuat, t: f64) -> DQuat {
    let to = if from.dot(to) < 0.0 { -to } else { to };
    let angle = 2.0 * (from - to).length().atan2((from + to).length());
    let (a, b) = if angle < STRAIGHT {
        (1.0 - t, t)
    } else {
        (((1.0 - t) * angle).sin(), (t * angle).sin())
    };
    (from * a + to * b).normalize()
}

/// The frame that looks along `view` with `up` upwards: right, up and back as columns. None when they are parallel.
#[must_use]
pub fn looking(view: DVec3, up: DVec3) -> Option<DMat3> {
    let back = (-view).try_normalize()?;
    let right = up.cross(back).try_normalize()?;
    orthonormalise(DMat3::from_cols(right, back.cross(right), back))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{Mat3, Vec3};
    use proptest::prelude::*;
    use rand::rngs::StdRng;
    use rand::{Rng, SeedableRng};

    /// How far a matrix is from orthonormal: the greatest element of MᵀM − I.
    fn defect(m: DMat3) -> f64 {
        let d = m.transpose() * m - DMat3::IDENTITY;
        d.to_cols_array()
            .iter()
            .fold(0.0, |m: f64, v| m.max(v.abs()))
    }

    fn random_unit(rng: &mut StdRng) -> DVec3 {
        loop {
            let v = DVec3::new(
                rng.random_range(-1.0..1.0),
                rng.random_range(-1.0..1.0),
                rng.random_range(-1.0..1.0),
            );
            if (0.01..1.0).contains(&v.length()) {
                return v.normalize();
            }
        }
    }

    /// In single precision an orientation that is turned again and again drifts, about linearly with the number of turns;
    /// put right every thousand, it never has more than the drift of a thousand. The greatest change of a vector when it is put
    /// right ("similitude") measures the drift as well.
    #[test]
    fn drift_and_its_remedy() {
        let turn = DMat3::from_axis_angle(DVec3::new(1.0, 2.0, -0.7).normalize(), 0.0137).as_mat3();
        let (mut drifting, mut kept) = (Mat3::IDENTITY, Mat3::IDENTITY);
        let (mut after_1000, mut worst_kept, mut similitude) = (0.0, 0.0f64, 0.0f64);
        for k in 1..=100_000 {
            (drifting, kept) = (turn * drifting, turn * kept);
            if k % 1000 == 0 {
                let before = kept.as_dmat3();
                worst_kept = worst_kept.max(defect(before));
                let after = orthonormalise(before).unwrap();
                for i in 0..3 {
                    similitude = similitude.max(before.col(i).distance(after.col(i)));
                }
                kept = after.as_mat3();
            }
            if k == 1000 {
                after_1000 = defect(drifting.as_dmat3());
            }
        }
        let growth = defect(drifting.as_dmat3()) / after_1000;
        assert!((1e-6..5e-5).contains(&after_1000), "{after_1000}");
        assert!((30.0..300.0).contains(&growth), "{growth}");
        assert!(
            worst_kept < 3.0 * after_1000 && similitude < worst_kept,
            "{worst_kept} {similitude}"
        );
    }

    /// Three vectors within ε of each other, in single precision: the modified form keeps them perpendicular where the
    /// classical one gives up.
    #[test]
    fn the_modified_form_is_the_stable_one() {
        let mut rng = StdRng::seed_from_u64(9);
        let gram_schmidt = |m: [Vec3; 3], modified: bool| {
            let x = m[0].normalize();
            let y = (m[1] - x * x.dot(m[1])).normalize();
            let z = m[2] - x * x.dot(m[2]);
            let z = z - y * y.dot(if modified { z } else { m[2] });
            [x, y, z.normalize()]
        };
        let worst = |o: [Vec3; 3]| {
            o[0].dot(o[1])
                .abs()
                .max(o[0].dot(o[2]).abs())
                .max(o[1].dot(o[2]).abs())
        };
        for (eps, classical_at_least, modified_at_most) in [(1e-2, 1e-3, 1e-4), (1e-3, 5e-2, 1e-3)]
        {
            let (mut classical, mut modified) = (0.0f32, 0.0f32);
            for _ in 0..300 {
                let base = random_unit(&mut rng);
                let near = [0, 1, 2].map(|_| base + random_unit(&mut rng) * eps);
                // Dependent to the second order in ε, and no worse.
                if near[0].dot(near[1].cross(near[2])).abs() < 0.3 * eps * eps {
                    continue;
                }
                let near = near.map(|v| v.as_vec3());
                classical = classical.max(worst(gram_schmidt(near, false)));
                modified = modified.max(worst(gram_schmidt(near, true)));
            }
            assert!(
                classical > classical_at_least && modified < modified_at_most,
                "{eps}: {classical} {modified}"
            );
        }
    }

    #[test]
    fn what_spans_no_space_has_no_frame() {
        assert_eq!(orthonormalise(DMat3::ZERO), None);
        assert_eq!(
            orthonormalise(DMat3::from_cols(DVec3::X, DVec3::X, DVec3::Y)),
            None
        );
        assert_eq!(looking(DVec3::Y, DVec3::Y), None);
        assert_eq!(looking(DVec3::ZERO, DVec3::Y), None);
        assert_eq!(looking(DVec3::NEG_Z, DVec3::Y), Some(DMat3::IDENTITY));
    }

    #[test]
    fn turns_of_half_a_circle_have_a_quaternion() {
        let mut rng = StdRng::seed_from_u64(5);
        for degrees in [0.0, 1e-7, 90.0, 170.0, 179.9, 179.99, 180.0] {
            for _ in 0..500 {
                let axis = random_unit(&mut rng);
                let want = DQuat::from_axis_angle(axis, f64::to_radians(degrees));
                let got = quaternion(DMat3::from_quat(want));
                let apart = (got - want).length().min((got + want).length());
                assert!(apart < 1e-15 * 10.0, "{degrees}: {apart}");
            }
        }
    }

    fn orientation() -> impl Strategy<Value = DQuat> {
        (-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64, 0.0..3.1f64).prop_map(|(x, y, z, angle)| {
            DQuat::from_axis_angle(DVec3::new(x, y, z).normalize_or(DVec3::X), angle)
        })
    }

    proptest! {
        /// Constant speed on the shorter way, from very near to opposite: the angle from the start is t times the whole.
        #[test]
        fn slerp_turns_evenly(from in orientation(), axis in orientation(), power in 0..16i32, t in 0.0..1.0f64, flip: bool) {
            let angle = 3.1 * 10f64.powi(-power);
            let turn = DQuat::from_axis_angle(axis * DVec3::X, angle);
            let to = turn * from;
            let got = slerp(from, if flip { -to } else { to }, t);
            let want = DQuat::from_axis_angle(axis * DVec3::X, angle * t) * from;
            let apart = (got - want).length().min((got + want).length());
            prop_assert!(apart < 1e-14, "{}", apart);
            prop_assert!((got.length() - 1.0).abs() < 1e-15 * 4.0);
        }

        /// Exactly half a turn apart either way is right, but it must be one of them.
        #[test]
        fn half_a_turn_gives_some_way(from in orientation(), t in 0.0..1.0f64) {
            let to = DQuat::from_axis_angle(DVec3::Y, std::f64::consts::PI) * from;
            let got = slerp(from, to, t);
            prop_assert!(got.is_finite());
            let cosine = from.dot(got).abs();
            prop_assert!((cosine.min(1.0).acos() - t * std::f64::consts::FRAC_PI_2).abs() < 1e-7);
        }
    }
}
