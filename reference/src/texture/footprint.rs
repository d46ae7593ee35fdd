//! How much of the texture a pixel covers: the exact derivatives of the address on the screen, and what the filters for
//! minification make of them.
//!
//! With U = u·w, V = v·w and w = 1/depth affine on the screen (Zed3D 1996, 1/z texture), u = U/w has the derivatives
//! ∂u/∂x = (∂U/∂x − u·∂w/∂x)/w and likewise in y. The level of a mip-map is log₂ of the longer of the two vectors
//! (∂u/∂x, ∂v/∂x) and (∂u/∂y, ∂v/∂y) in texels; the papers leave the choice open.

use glam::DVec2;

/// How the address changes from pixel to pixel, texels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Footprint {
    /// Derivative to the right.
    pub right: DVec2,
    /// Derivative downwards.
    pub down: DVec2,
}

impl Footprint {
    /// The level of a mip-map: 0 for one texel per pixel or less, one more for every doubling.
    #[must_use]
    pub fn level(&self) -> f64 {
        self.right.length().max(self.down.length()).log2().max(0.0)
    }

    /// Sides of the box, along the axes of the texture, around the parallelogram that a pixel covers; texels, at least 1.
    #[must_use]
    pub fn sides(&self) -> DVec2 {
        (self.right.abs() + self.down.abs()).max(DVec2::ONE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_texels_per_pixel_are_level_one_and_sixteen_level_two() {
        for (scale, level) in [(0.3, 0.0), (1.0, 0.0), (2.0, 1.0), (4.0, 2.0)] {
            for angle in [0.0, 0.3, 1.2] {
                let right = DVec2::from_angle(angle) * scale;
                let f = Footprint {
                    right,
                    down: right.perp(),
                };
                assert!((f.level() - level).abs() < 1e-12);
            }
        }
        assert_eq!(Footprint::default().level(), 0.0);
        let f = Footprint {
            right: DVec2::new(3.0, -4.0),
            down: DVec2::new(0.5, 0.25),
        };
        assert_eq!(f.sides(), DVec2::new(3.5, 4.25));
        assert!((f.level() - 5f64.log2()).abs() < 1e-15);
    }
}
