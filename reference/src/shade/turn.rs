//! Great circles: the slerp of two unit vectors and the smallest rotation from one to another.
//!
//! slerp(t) = [sin((1 − t)g)·a + sin(t·g)·b] / sin g = a·cos(t·g) + c·sin(t·g) with g the angle between a and b and c the
//! unit vector across a towards b (Shoemake 1985; Abbas 2003, eqs 6.1–6.5, of which the printed third line of 6.5 must
//! end with the end vector; Hast 2004, eqs 3.21–3.25). g comes from atan2(|a × b|, a·b): an arc cosine loses half the
//! digits of a small angle.

use glam::DVec3;

/// The arc of a great circle from one unit vector to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    from: DVec3,
    across: DVec3,
    /// Angle between the ends, rad, 0..=π.
    pub angle: f64,
}

impl Arc {
    /// The shorter arc from `a` to `b`. Between opposite vectors every great circle is as short as any other: one of
    /// them is taken. A zero vector (a light in a vertex) has no direction and takes that of the other end.
    #[must_use]
    pub fn new(a: DVec3, b: DVec3) -> Self {
        let (a, b) = directions(a, b);
        let (sin, cos) = (a.cross(b).length(), a.dot(b));
        let across = (b - a * cos).normalize_or_zero();
        if across == DVec3::ZERO && cos < 0.0 {
            return Self {
                from: a,
                across: a.any_orthonormal_vector(),
                angle: std::f64::consts::PI,
            };
        }
        Self {
            from: a,
            across,
            angle: sin.atan2(cos),
        }
    }

    /// The unit vector at `t`, 0..=1.
    #[must_use]
    pub fn at(&self, t: f64) -> DVec3 {
        let (sin, cos) = (t * self.angle).sin_cos();
        self.from * cos + self.across * sin
    }

    /// The vector at the start, and the unit vector across it towards the end.
    #[must_use]
    pub fn frame(&self) -> (DVec3, DVec3) {
        (self.from, self.across)
    }
}

/// Gives a zero vector the direction of the other one.
#[must_use]
pub fn directions(a: DVec3, b: DVec3) -> (DVec3, DVec3) {
    match (a == DVec3::ZERO, b == DVec3::ZERO) {
        (true, false) => (b, b),
        (false, true) => (a, a),
        _ => (a, b),
    }
}

/// Opposite vectors have no smallest rotation; below this 1 + cos the rotation loses its digits.
const OPPOSITE: f64 = 1e-12;

/// `u` turned by the smallest rotation that takes the unit vector `from` to the unit vector `to`: with w = from × to,
/// u + w × u + w × (w × u)/(1 + from·to) (Abbas 2003, section 6.2, quaternion form; right as printed). `None` where the
/// two are opposite.
#[must_use]
pub fn carry(u: DVec3, from: DVec3, to: DVec3) -> Option<DVec3> {
    let scale = 1.0 + from.dot(to);
    if scale < OPPOSITE {
        return None;
    }
    let w = from.cross(to);
    let once = w.cross(u);
    Some(u + once + w.cross(once) / scale)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn unit() -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-1.0..1.0f64)
            .prop_map(DVec3::from)
            .prop_filter_map("no direction", DVec3::try_normalize)
    }

    proptest! {
        #[test]
        fn arcs_end_where_they_should_and_turn_evenly(a in unit(), b in unit(), t in 0.0..1.0f64) {
            prop_assume!(a.dot(b) > -0.9999);
            let arc = Arc::new(a, b);
            prop_assert!(arc.at(0.0) == a);
            prop_assert!(arc.at(1.0).distance(b) < 1e-14);
            prop_assert!((arc.at(t).length() - 1.0).abs() < 1e-14);
            // The definition by sines.
            let g = a.dot(b).clamp(-1.0, 1.0).acos();
            prop_assume!(g > 1e-3);
            let want = (a * ((1.0 - t) * g).sin() + b * (t * g).sin()) / g.sin();
            prop_assert!(arc.at(t).distance(want) < 1e-9 / g.sin());
        }

        #[test]
        fn a_rotation_takes_one_vector_to_the_other_and_keeps_angles(
            a in unit(), b in unit(), u in unit(), v in unit(),
        ) {
            prop_assume!(a.dot(b) > -0.999);
            let turn = |x| carry(x, a, b).unwrap();
            prop_assert!(turn(a).distance(b) < 1e-12);
            prop_assert!((turn(u).dot(turn(v)) - u.dot(v)).abs() < 1e-12);
            // The smallest one: its axis stays.
            let axis = a.cross(b);
            prop_assert!(turn(axis).distance(axis) < 1e-12);
        }

        #[test]
        fn tiny_arcs_are_as_exact_as_large_ones(a in unit(), b in unit(), e in 1e-15..1e-3f64) {
            let near = (a + b * e).normalize();
            prop_assert!(Arc::new(a, near).at(1.0).distance(near) < 1e-15);
        }
    }

    #[test]
    fn degenerate_arcs_stay_finite() {
        let arc = Arc::new(DVec3::Y, DVec3::Y);
        assert_eq!((arc.at(0.3), arc.angle), (DVec3::Y, 0.0));
        let arc = Arc::new(DVec3::Y, DVec3::NEG_Y);
        assert!(
            arc.at(1.0).distance(DVec3::NEG_Y) < 1e-15
                && (arc.at(0.4).length() - 1.0).abs() < 1e-15
        );
        assert_eq!(Arc::new(DVec3::ZERO, DVec3::X).at(0.2), DVec3::X);
        assert_eq!(Arc::new(DVec3::X, DVec3::ZERO).at(1.0), DVec3::X);
        assert_eq!(Arc::new(DVec3::ZERO, DVec3::ZERO).at(0.7), DVec3::ZERO);
        assert_eq!(carry(DVec3::X, DVec3::Y, DVec3::NEG_Y), None);
        assert_eq!(carry(DVec3::X, DVec3::Y, DVec3::Y), Some(DVec3::X));
    }
}
