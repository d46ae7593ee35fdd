//! World to clip space. View space is right-handed, the camera looks along −z; clip x and y run from −w to w across the
//! frame. Depth along the view is kept as it is (not squeezed into −w..w), so that the near and far planes stay plain.
//! w is the depth for perspective and 1 for orthographic projection.

use crate::raster::Point;
use crate::scene::{Camera, Projection};
use glam::{DMat3, DMat4, DVec3};

/// A vertex in clip space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clip {
    /// −w..w from left to right.
    pub x: f64,
    /// −w..w from bottom to top.
    pub y: f64,
    /// Distance along the view direction, world units.
    pub depth: f64,
    /// Divides x and y.
    pub w: f64,
}

/// A camera with a frame.
#[derive(Clone, Copy, Debug)]
pub struct View {
    to_view: DMat4,
    /// Clip x of view x, clip y of view y.
    scale: [f64; 2],
    perspective: bool,
    size: [f64; 2],
    /// Nearest depth drawn.
    pub near: f64,
    /// Farthest depth drawn.
    pub far: f64,
}

impl View {
    /// Columns of the frame.
    #[must_use]
    pub fn width(&self) -> f64 {
        self.size[0]
    }

    /// Rows of the frame.
    #[must_use]
    pub fn height(&self) -> f64 {
        self.size[1]
    }

    /// Takes world positions to view space: the eye at the origin, x to the right, y up, looking along −z.
    #[must_use]
    pub fn to_view(&self) -> DMat4 {
        self.to_view
    }

    /// Pixels per unit of view space, where w = 1; the same in both directions, since pixels are square.
    #[must_use]
    pub fn focal(&self) -> f64 {
        self.scale[1] * self.size[1] / 2.0
    }

    /// Whether far things look smaller.
    #[must_use]
    pub fn is_perspective(&self) -> bool {
        self.perspective
    }

    /// The view of `camera` on a frame of `width` × `height` square pixels.
    #[must_use]
    pub fn new(camera: &Camera, width: u32, height: u32) -> Self {
        let size = [f64::from(width), f64::from(height)];
        let (vertical, perspective) = match camera.projection {
            Projection::Perspective { fov } => (1.0 / (fov.to_radians() / 2.0).tan(), true),
            Projection::Orthographic { height } => (2.0 / height, false),
        };
        Self {
            to_view: look_at(camera),
            scale: [vertical * size[1] / size[0], vertical],
            perspective,
            size,
            near: camera.near,
            far: camera.far,
        }
    }

    /// Takes a world position to clip space.
    #[must_use]
    pub fn clip(&self, world: DVec3) -> Clip {
        let v = self.to_view.transform_point3(world);
        Clip {
            x: v.x * self.scale[0],
            y: v.y * self.scale[1],
            depth: -v.z,
            w: if self.perspective { -v.z } else { 1.0 },
        }
    }

    /// Pixels, unrounded: x to the right, y down.
    #[must_use]
    pub fn pixels(&self, c: Clip) -> (f64, f64) {
        (
            (c.x / c.w * 0.5 + 0.5) * self.size[0],
            (0.5 - c.y / c.w * 0.5) * self.size[1],
        )
    }

    /// The snapped screen position.
    #[must_use]
    pub fn screen(&self, c: Clip) -> Option<Point> {
        let (x, y) = self.pixels(c);
        Point::snap(x, y)
    }

    /// A measure of nearness that is affine on the screen: 1/w with perspective, −depth without.
    #[must_use]
    pub fn nearness(&self, c: Clip) -> f64 {
        if self.perspective {
            1.0 / c.w
        } else {
            -c.depth
        }
    }
}

/// Columns right, up, back are transposed into rows: the rotation to view space, after moving the eye to the origin.
fn look_at(camera: &Camera) -> DMat4 {
    let back = (camera.eye - camera.target).normalize();
    let right = camera.up.normalize().cross(back).normalize();
    let up = back.cross(right);
    DMat4::from_mat3(DMat3::from_cols(right, up, back).transpose())
        * DMat4::from_translation(-camera.eye)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera(projection: Projection) -> Camera {
        Camera {
            eye: DVec3::new(0.0, 0.0, 5.0),
            target: DVec3::ZERO,
            up: DVec3::Y,
            projection,
            near: 0.1,
            far: 100.0,
        }
    }

    #[test]
    fn the_target_is_in_the_middle_and_the_field_of_view_fills_the_height() {
        for (projection, top) in [
            (Projection::Perspective { fov: 90.0 }, 5.0),
            (Projection::Orthographic { height: 8.0 }, 4.0),
        ] {
            let v = View::new(&camera(projection), 320, 240);
            assert_eq!(v.pixels(v.clip(DVec3::ZERO)), (160.0, 120.0));
            let (x, y) = v.pixels(v.clip(DVec3::Y * top));
            assert!((x - 160.0).abs() < 1e-9 && y.abs() < 1e-9);
            // Square pixels.
            let (x, _) = v.pixels(v.clip(DVec3::X * top));
            assert!((x - 280.0).abs() < 1e-9);
            assert!(v.nearness(v.clip(DVec3::Z)) > v.nearness(v.clip(DVec3::ZERO)));
        }
    }
}
