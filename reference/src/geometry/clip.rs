//! Polygon clipping in homogeneous clip space (Sutherland–Hodgman 1974) against near, far and the guard band, the
//! planes x = ±2w and y = ±2w: half a frame of margin on every side, less where a wide frame would leave the columns
//! that 12 signed bits hold. Nothing is divided before it is in front of the eye. A crossing is always computed from the inner to the outer vertex, so two triangles that share an edge cut it at
//! the same point to the last bit.

use super::camera::{Clip, View};
use glam::{DVec2, DVec3};

/// The guard band reaches this far, in half frames from the middle: columns −w/2 to 3w/2.
pub const GUARD: f64 = 2.0;

/// Rightmost column of the guard band, for frames that end before it: a walk column then fits 12 signed bits, which is
/// what hardware wants. Wider frames are for software alone and keep the full band.
pub const GUARD_COLUMN: f64 = 2045.0;

/// Reach of the guard band to the sides, in half frames.
fn guard_columns(width: f64) -> f64 {
    let margin = GUARD_COLUMN - width;
    if margin >= 1.0 {
        GUARD.min(1.0 + 2.0 * margin / width)
    } else {
        GUARD
    }
}

/// A vertex with what is interpolated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// Clip-space position.
    pub clip: Clip,
    /// World position.
    pub world: DVec3,
    /// World normal, not renormalised.
    pub normal: DVec3,
    /// Texture coordinates.
    pub uv: DVec2,
}

/// The planes of the drawn volume; a vertex is inside where its distance is not negative.
#[derive(Clone, Copy, Debug)]
pub struct Planes {
    near: f64,
    far: f64,
    /// Half-width in units of w: at most [`GUARD`] for clipping, 1 for culling.
    band_x: f64,
    /// Half-height in units of w: [`GUARD`] for clipping, 1 for culling.
    band_y: f64,
}

impl Planes {
    /// How many planes there are.
    pub const COUNT: usize = 6;

    /// The planes that triangles are cut at.
    #[must_use]
    pub fn guard(view: &View) -> Self {
        Self {
            near: view.near,
            far: view.far,
            band_x: guard_columns(view.width()),
            band_y: GUARD,
        }
    }

    /// The planes of what is visible.
    #[must_use]
    pub fn frustum(view: &View) -> Self {
        Self {
            band_x: 1.0,
            band_y: 1.0,
            ..Self::guard(view)
        }
    }

    /// Linear distance of a vertex from plane `i` (0 near, 1 far, 2–5 left, right, bottom, top), in clip units.
    #[must_use]
    pub fn distance(&self, i: usize, c: Clip) -> f64 {
        match i {
            0 => c.depth - self.near,
            1 => self.far - c.depth,
            2 => self.band_x * c.w + c.x,
            3 => self.band_x * c.w - c.x,
            4 => self.band_y * c.w + c.y,
            _ => self.band_y * c.w - c.y,
        }
    }
}

fn between(a: Vertex, b: Vertex, t: f64) -> Vertex {
    let mix = |p: f64, q: f64| p + (q - p) * t;
    Vertex {
        clip: Clip {
            x: mix(a.clip.x, b.clip.x),
            y: mix(a.clip.y, b.clip.y),
            depth: mix(a.clip.depth, b.clip.depth),
            w: mix(a.clip.w, b.clip.w),
        },
        world: a.world + (b.world - a.world) * t,
        normal: a.normal + (b.normal - a.normal) * t,
        uv: a.uv + (b.uv - a.uv) * t,
    }
}

/// Clips a triangle; `polygon` receives the convex rest in order (empty when nothing is left). True when it was cut.
pub fn clip(planes: &Planes, triangle: [Vertex; 3], polygon: &mut Vec<Vertex>) -> bool {
    polygon.clear();
    polygon.extend(triangle);
    let mut cut = false;
    let mut next = Vec::new();
    for i in 0..Planes::COUNT {
        if polygon.iter().all(|v| planes.distance(i, v.clip) >= 0.0) {
            continue;
        }
        cut = true;
        next.clear();
        for (k, &a) in polygon.iter().enumerate() {
            let b = polygon[(k + 1) % polygon.len()];
            let (da, db) = (planes.distance(i, a.clip), planes.distance(i, b.clip));
            if da >= 0.0 {
                next.push(a);
            }
            if da >= 0.0 && db < 0.0 {
                next.push(between(a, b, da / (da - db)));
            } else if da < 0.0 && db >= 0.0 {
                next.push(between(b, a, db / (db - da)));
            }
        }
        std::mem::swap(polygon, &mut next);
        if polygon.is_empty() {
            break;
        }
    }
    cut
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Camera, Projection};
    use proptest::prelude::*;

    fn view(perspective: bool) -> View {
        let projection = if perspective {
            Projection::Perspective { fov: 70.0 }
        } else {
            Projection::Orthographic { height: 3.0 }
        };
        let camera = Camera {
            eye: DVec3::ZERO,
            target: DVec3::NEG_Z,
            up: DVec3::Y,
            projection,
            near: 0.5,
            far: 20.0,
        };
        View::new(&camera, 40, 30)
    }

    fn vertex(view: &View, world: DVec3, normal: DVec3) -> Vertex {
        Vertex {
            clip: view.clip(world),
            world,
            normal,
            uv: world.truncate(),
        }
    }

    /// Where the ray through a pixel meets the plane of a triangle: barycentric weights, if it does.
    fn hit(t: [DVec3; 3], origin: DVec3, direction: DVec3) -> Option<[f64; 3]> {
        let (e1, e2, s) = (t[1] - t[0], t[2] - t[0], origin - t[0]);
        let p = direction.cross(e2);
        let det = e1.dot(p);
        let q = s.cross(e1);
        let (u, v) = (s.dot(p) / det, direction.dot(q) / det);
        (det.abs() > 1e-9).then_some([1.0 - u - v, u, v])
    }

    fn any_point() -> impl Strategy<Value = DVec3> {
        (-9.0..9.0, -9.0..9.0, -25.0..6.0).prop_map(|(x, y, z)| DVec3::new(x, y, z))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(3000))]
        /// An independent ray–triangle test decides what is visible: the pieces together must show it, and nothing else,
        /// with the same attributes.
        #[test]
        fn pieces_show_what_the_triangle_shows(
            a in any_point(), b in any_point(), c in any_point(), perspective: bool,
            x in 0.0..40.0f64, y in 0.0..30.0f64,
        ) {
            let view = view(perspective);
            let planes = Planes::guard(&view);
            let normals = [DVec3::X, DVec3::Y, DVec3::Z];
            let world = [a, b, c];
            let mut polygon = Vec::new();
            clip(&planes, [0, 1, 2].map(|i| vertex(&view, world[i], normals[i])), &mut polygon);
            for v in &polygon {
                for i in 0..Planes::COUNT {
                    prop_assert!(planes.distance(i, v.clip) >= -1e-9);
                }
                // Attributes stay affine in the world: the normals here are barycentric weights.
                let p = a * v.normal.x + b * v.normal.y + c * v.normal.z;
                prop_assert!(p.distance(v.world) < 1e-9);
                prop_assert!(v.uv.distance(v.world.truncate()) < 1e-9);
                let again = view.clip(v.world);
                prop_assert!((again.x - v.clip.x).abs() < 1e-9 && (again.w - v.clip.w).abs() < 1e-9);
            }
            let ndc = DVec3::new(x / 20.0 - 1.0, 1.0 - y / 15.0, 0.0);
            let half = if perspective { (35.0f64).to_radians().tan() } else { 1.5 };
            let offset = DVec3::new(ndc.x * half * 40.0 / 30.0, ndc.y * half, 0.0);
            let (origin, direction) = if perspective { (DVec3::ZERO, offset - DVec3::Z) } else { (offset, DVec3::NEG_Z) };
            let seen = |t: [DVec3; 3]| {
                let weights = hit(t, origin, direction)?;
                let p = t[0] * weights[0] + t[1] * weights[1] + t[2] * weights[2];
                let margin = weights.iter().copied().fold(f64::INFINITY, f64::min)
                    .min(-p.z - 0.5).min(20.0 + p.z);
                Some(margin)
            };
            let whole = seen(world).unwrap_or(-1.0);
            let parts: Vec<f64> = (2..polygon.len())
                .filter_map(|k| seen([polygon[0].world, polygon[k - 1].world, polygon[k].world]))
                .collect();
            let best = parts.iter().copied().fold(-1.0, f64::max);
            if whole > 1e-6 {
                prop_assert!(best >= -1e-6, "hole: {whole} {best}");
            } else if whole < -1e-6 {
                prop_assert!(best <= 1e-6, "too much: {whole} {best}");
            }
        }

        #[test]
        fn a_shared_edge_is_cut_at_one_place(a in any_point(), b in any_point(), c in any_point(), d in any_point()) {
            let view = view(true);
            let planes = Planes::guard(&view);
            let v = |p| vertex(&view, p, p);
            let (mut one, mut two) = (Vec::new(), Vec::new());
            clip(&planes, [v(a), v(b), v(c)], &mut one);
            clip(&planes, [v(b), v(a), v(d)], &mut two);
            // Points of a polygon on the line a–b.
            let on_edge = |polygon: &[Vertex]| {
                let e = (b - a).normalize();
                let mut points: Vec<[u64; 3]> = polygon
                    .iter()
                    .filter(|p| (p.world - a).cross(e).length() < 1e-10)
                    .map(|p| p.world.to_array().map(f64::to_bits))
                    .collect();
                points.sort_unstable();
                points.dedup();
                points
            };
            let (p, q) = (on_edge(&one), on_edge(&two));
            prop_assume!(p.len() == 2 && q.len() == 2);
            prop_assert_eq!(p, q);
        }
    }
}
