//! The arbiter: a ray from the eye through each pixel centre, and the nearest triangle it hits in the world (Loisel 1996:
//! ray casting is the projection inverted). Knows no clip space, no snapping, no rasteriser and no depth buffer.

use super::{Visible, NONE};
use crate::geometry::{Prepared, ScreenTriangle};
use crate::scene::{Camera, Projection};
use glam::DVec3;

/// The rays of a camera.
#[derive(Clone, Copy, Debug)]
pub struct Rays {
    eye: DVec3,
    /// Unit vector along the view.
    view: DVec3,
    /// From the middle of the frame, per pixel to the right and down, at depth 1 or without perspective.
    right: DVec3,
    down: DVec3,
    size: [f64; 2],
    perspective: bool,
}

impl Rays {
    /// The rays of a camera whose frame has this size.
    #[must_use]
    pub fn new(camera: &Camera, width: u32, height: u32) -> Self {
        let view = (camera.target - camera.eye).normalize();
        let right = view.cross(camera.up).normalize();
        let (perspective, half) = match camera.projection {
            Projection::Perspective { fov } => (true, (fov.to_radians() / 2.0).tan()),
            Projection::Orthographic { height } => (false, height / 2.0),
        };
        let pixel = half / (f64::from(height) / 2.0);
        Self {
            eye: camera.eye,
            view,
            right: right * pixel,
            down: view.cross(right) * pixel,
            size: [f64::from(width), f64::from(height)],
            perspective,
        }
    }

    /// Origin and direction of the ray through a position in pixels; the direction is one unit long along the view, so
    /// that lengths on the ray are depths.
    #[must_use]
    pub fn at(&self, x: f64, y: f64) -> (DVec3, DVec3) {
        let aside = self.right * (x - self.size[0] / 2.0) + self.down * (y - self.size[1] / 2.0);
        if self.perspective {
            (self.eye, self.view + aside)
        } else {
            (self.eye + aside, self.view)
        }
    }
}

/// Depth at which a ray meets the triangle, and the least barycentric weight there; none for a ray in its plane.
#[must_use]
pub fn hit(t: &ScreenTriangle, (origin, direction): (DVec3, DVec3)) -> Option<(f64, f64)> {
    let [a, b, c] = t.world;
    let (e1, e2, s) = (b - a, c - a, origin - a);
    let p = direction.cross(e2);
    let det = e1.dot(p);
    if det == 0.0 {
        return None;
    }
    let q = s.cross(e1);
    let (u, v) = (s.dot(p) / det, direction.dot(q) / det);
    Some((e2.dot(q) / det, u.min(v).min(1.0 - u - v)))
}

/// The nearest triangle on the ray of each pixel centre; of equally near ones the first.
#[must_use]
pub fn draw(p: &Prepared, camera: &Camera) -> Visible {
    let rays = Rays::new(camera, p.width, p.height);
    let mut visible = Visible::new(p);
    for k in 0..visible.ids.len() {
        let (x, y) = (k % p.width as usize, k / p.width as usize);
        let ray = rays.at(x as f64 + 0.5, y as f64 + 0.5);
        let mut nearest = (f64::INFINITY, NONE);
        for (i, t) in p.triangles.iter().enumerate() {
            if let Some((depth, inside)) = hit(t, ray) {
                if inside >= 0.0 && depth > 0.0 && depth < nearest.0 {
                    nearest = (depth, i as u32);
                }
            }
        }
        if nearest.1 != NONE {
            visible.write(k, nearest.1 as usize);
        }
    }
    visible
}
