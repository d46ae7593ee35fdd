//! What colour a surface has, and what each method makes of it between the places where that is worked out.
//! Colours are real numbers in units of one 255th of full scale (LSB), not limited above unless said so.

pub mod angular;
pub mod angular_single;
pub mod attenuation;
pub mod auto;
pub mod barycentric;
pub mod blake;
pub mod bound;
pub mod brdf;
pub mod case;
pub mod circular;
pub mod corners;
pub mod curve;
pub mod cut;
pub mod differences;
pub mod dispatch;
pub mod dot_product;
pub mod duff;
pub mod ends;
pub mod euler;
pub mod exact;
pub mod flat;
pub mod form;
pub mod gouraud;
pub mod hemisphere;
pub mod highlight;
pub mod hybrid;
pub mod light;
pub mod lit;
pub mod negligible;
pub mod newton;
pub mod normals;
pub mod object_space;
pub mod one_pixel;
pub mod paint;
mod painted;
pub mod phong;
pub mod polar_angle;
#[cfg(test)]
mod probe;
pub mod pseudo_phong;
pub mod quadratic;
pub mod quadratic_adaptive;
pub mod quadratic_adaptive_centre;
pub mod quadratic_dots;
pub mod quadric;
pub mod reach;
pub mod recurrence;
pub mod reflection;
pub mod series;
pub mod shader;
pub(crate) mod shared;
pub mod slerp;
pub mod spherical;
pub mod spherical_cos2;
pub mod spherical_cosn;
pub mod spherical_independent;
pub mod spot;
pub mod subdivision;
pub mod sweep;
pub mod taylor;
pub mod turn;
pub mod x_shading;

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
