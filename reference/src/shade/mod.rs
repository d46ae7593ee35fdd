//! What colour a surface has, and what each method makes of it between the places where that is worked out.
//! Colours are real numbers in units of one 255th of full scale (LSB), not limited above unless said so.

pub mod auto;
pub mod barycentric;
pub mod bound;
pub mod case;
pub mod corners;
pub mod differences;
pub mod dispatch;
pub mod exact;
pub mod flat;
pub mod gouraud;
pub mod light;
pub mod paint;
pub mod quadratic;
pub mod shader;
pub(crate) mod shared;

pub use light::Surroundings;

use crate::geometry::ScreenTriangle;
use glam::DVec3;

/// Knots saturate to 0..=`KNOT_MAX` LSB (six times full scale), which bounds every later range.
pub const KNOT_MAX: f64 = 1530.0;

/// The byte of a colour: rounded to nearest (halves upwards), limited to 0..=255; 0 for what is not a number.
#[must_use]
pub fn to_byte(v: f64) -> u8 {
    // The conversion truncates and saturates: below zero and NaN give 0.
    (v + 0.5) as u8
}

/// Saturates a colour to the range of knots.
fn knot(colour: DVec3) -> [f64; 3] {
    colour.to_array().map(|c| c.clamp(0.0, KNOT_MAX))
}

/// Blended normals with a squared length up to this have cancelled.
const CANCELLED: f64 = 1e-16;

/// The unit vector of a blended normal; the normal of the face when opposite normals cancelled.
pub(crate) fn unit_normal(t: &ScreenTriangle, n: DVec3) -> DVec3 {
    if n.length_squared() > CANCELLED {
        n.normalize()
    } else {
        t.face_normal()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes() {
        let cases = [
            (-3.0, 0),
            (0.49, 0),
            (0.5, 1),
            (254.49, 254),
            (254.5, 255),
            (900.0, 255),
            (f64::NAN, 0),
        ];
        for (v, b) in cases {
            assert_eq!(to_byte(v), b, "{v}");
        }
    }
}
