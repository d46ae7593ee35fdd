//! Back faces found in object space, before any vertex is transformed (Loisel 1996, section on back-face culling).
//!
//! The eye is taken into object space once, E. A face a, b, c with the outward normal A = (b − a) × (c − a) shows its
//! back when A·E ≤ A·a, that is s = A·(E − a) ≤ 0: one dot product and one comparison. Without perspective E − a is the
//! direction towards the viewer.
//!
//! What decides about drawing is the sign of the area *after* snapping to the sub-pixel grid, and that may differ where
//! a face is seen almost edge-on. So a face is culled here only when its area on the screen cannot change sign. With the
//! map from object to view space x ↦ N·x + n, focal length f in pixels and depths w₀, w₁, w₂ (1 without perspective),
//! twice the area on the screen is
//!
//!   f²·|det N|·|s| / (w₀·w₁·w₂)  ≥  f²·|det N|·|s| / w_max³.
//!
//! Each coordinate of a vertex moves by at most η pixels between that ideal and the snapped position: 1/512 by snapping
//! and, checked for every object, no more than 1/512 by rounding on the way. With the edges u, v in pixels twice the
//! area then changes by at most 2η(|u|₁ + |v|₁) + 8η². An edge of length ℓ in view space, nowhere nearer than w_min and
//! nowhere farther from the axis than τ·w, is at most f·(1 + τ)·ℓ / w_min pixels long in each coordinate, and ℓ is at
//! most ‖N‖ times its length in object space. That gives a bound on |s| of the form m₀ + m₁·(|u|₁ + |v|₁) with the edges
//! in object space; a third term, m₂·|u|₁·|v|₁, covers the rounding of E and of s itself.
//!
//! The bound holds for triangles that are not clipped, so objects that reach beyond the guard band, the near or the far
//! plane are left to the test on the screen.

use super::camera::{Clip, View};
use super::clip::Planes;
use glam::{DMat3, DMat4, DVec3};

/// Bound on the movement of a coordinate by snapping and rounding, pixels; half of it for each.
const SHIFT: f64 = 1.0 / 256.0;
/// Unit of the last place.
const EPS: f64 = f64::EPSILON;

/// The test for the faces of one object.
#[derive(Clone, Copy, Debug)]
pub struct Facing {
    /// The eye (or the direction towards the viewer) in object space.
    eye: DVec3,
    /// 1 for an eye, 0 for a direction: what is subtracted of a vertex.
    point: f64,
    margin: [f64; 3],
}

fn frobenius(m: DMat3) -> f64 {
    m.to_cols_array().iter().map(|v| v * v).sum::<f64>().sqrt()
}

fn norm1(v: DVec3) -> f64 {
    let v = v.abs();
    v.x + v.y + v.z
}

impl Facing {
    /// The test for an object with this transform inside the box with these corners (object space). None where the bound
    /// cannot be had: the object is not wholly inside `guard`, or its transform loses too many digits.
    #[must_use]
    pub fn new(
        view: &View,
        guard: &Planes,
        transform: DMat4,
        corners: &[DVec3; 8],
    ) -> Option<Self> {
        let to_view = view.to_view() * transform;
        let linear = DMat3::from_mat4(to_view);
        let origin = to_view.w_axis.truncate();
        let det = linear.determinant().abs();
        let inverse = linear.try_inverse()?;

        // Sizes that bound every rounding: of the box in the world and of the eye.
        let world = corners
            .iter()
            .map(|c| {
                let parts = [
                    transform.x_axis * c.x,
                    transform.y_axis * c.y,
                    transform.z_axis * c.z,
                ];
                norm1(transform.w_axis.truncate())
                    + parts.iter().map(|p| norm1(p.truncate())).sum::<f64>()
            })
            .fold(0.0, f64::max);
        let eye_size = norm1(view.to_view().w_axis.truncate());
        // Transforming to the world and to view space rounds some twenty times, each by EPS / 2 of these.
        let rounding = 32.0 * EPS * (world + eye_size);

        let (mut near, mut far, mut aside) = (f64::INFINITY, 0.0f64, 0.0f64);
        for corner in corners {
            let v = to_view.transform_point3(*corner);
            let c: Clip = view.clip(transform.transform_point3(*corner));
            let slack = 16.0 * rounding * (1.0 + view.focal());
            if !(0..Planes::COUNT).all(|i| guard.distance(i, c) > slack) {
                return None;
            }
            near = near.min(c.w - rounding);
            far = far.max(c.w + rounding);
            aside = aside.max(v.x.abs().max(v.y.abs()) + rounding);
        }
        let focal = view.focal();
        let (stretch, volume) = if view.is_perspective() {
            (focal * (1.0 + aside / near) / near, far * far * far)
        } else {
            (focal, 1.0)
        };
        let pixels = view.width().max(view.height());
        let moved = stretch * rounding + 64.0 * EPS * pixels;
        let inexact = frobenius(linear * inverse - DMat3::IDENTITY);
        // What is not a number is refused by the last check of all.
        if moved > SHIFT / 2.0 || inexact > 0.01 {
            return None;
        }

        // E with N·E + n = 0, or the direction with N·E = z; what is left over says how far off it is.
        let (eye, wanted, point) = if view.is_perspective() {
            (-(inverse * origin), -origin, 1.0)
        } else {
            (inverse * DVec3::Z, DVec3::Z, 0.0)
        };
        let size = frobenius(linear);
        let left_over =
            norm1(linear * eye - wanted) + 16.0 * EPS * (size * norm1(eye) + norm1(wanted));
        let eye_error = 2.0 * frobenius(inverse) * (left_over + rounding);
        let reach = corners
            .iter()
            .map(|c| norm1(eye - *c * point))
            .fold(0.0, f64::max);

        let per_area = volume / (focal * focal * det);
        let margin = [
            per_area * 8.0 * SHIFT * SHIFT,
            // |u|₁ on the screen is at most twice the bound on each coordinate.
            per_area * 2.0 * SHIFT * 2.0 * stretch * size,
            eye_error + 32.0 * EPS * reach,
        ];
        // The bounds themselves are rounded; a thousandth more than covers it.
        let margin = margin.map(|m| m * 1.001);
        let sound = (moved + inexact).is_finite() && margin.iter().all(|m| m.is_finite());
        sound.then_some(Self { eye, point, margin })
    }

    /// Whether the face a, b, c, counter-clockwise from outside, shows its back for certain, however it is snapped.
    #[must_use]
    #[inline]
    pub fn is_back(&self, [a, b, c]: [DVec3; 3]) -> bool {
        let (u, v) = (b - a, c - a);
        let s = u.cross(v).dot(self.eye - a * self.point);
        if s >= 0.0 {
            return false;
        }
        let (lu, lv) = (norm1(u), norm1(v));
        let [m0, m1, m2] = self.margin;
        s + m0 + m1 * (lu + lv) + m2 * lu * lv < 0.0
    }
}
