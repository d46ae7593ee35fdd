//! Bump mapping (Blinn 1978; Hast 2004 §2.3 and §3.4): a height map bends the normals of a surface without moving it.
//!
//! A point lifted by F along the unit normal n has the normal n − G, G being the gradient of F on the surface; that is
//! Blinn's n + (F_u·(n × P_v) − F_v·(n × P_u))/|P_u × P_v| (2.7). Within a triangle heights change along its edges
//! e₁ = P₁ − P₀ and e₂ by f₁ = F_u·Δu₁ + F_v·Δv₁ and f₂, so G = (f₁·e₂ − f₂·e₁) × n/|e₁ × e₂|. This is the same without
//! P_u and P_v: nothing is divided by the area of the triangle in the texture, and where that vanishes (at poles, or where
//! a mesh has no coordinates) or is mirrored no special case is left. Only a triangle without area in space has no bumps.
//!
//! Methods that shade pixel by pixel show bumps; those that shade at vertices do not.

pub mod gradient;
pub mod kernel;
pub mod normalise;
mod shader;
pub mod vector;

pub use gradient::{Gradient, Heights};
pub use normalise::Normalise;
pub use shader::Bumped;

use crate::geometry::ScreenTriangle;
use crate::texture::{Texels, Wrap};
use glam::{DVec2, DVec3};

/// How a height map is laid on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Relief {
    /// Height of white above black, world units; negative for dents.
    pub scale: f64,
    /// How gradients are found between the samples.
    pub gradient: Gradient,
    /// How the bent normal is brought to unit length, where not the truth is asked for.
    pub normalise: Normalise,
    /// What lies beside the map.
    pub wrap: Wrap,
    /// How often the map fits between texture coordinates 0 and 1, in u and v.
    pub repeat: DVec2,
}

/// A height map on a material.
#[derive(Clone, Debug, PartialEq)]
pub struct BumpMap {
    heights: Heights,
    relief: Relief,
}

impl BumpMap {
    /// Takes the heights from a picture, the mean of its channels.
    #[must_use]
    pub fn new(picture: &Texels, relief: Relief) -> Self {
        Self {
            heights: Heights::new(picture),
            relief,
        }
    }

    /// How it is laid on a surface.
    #[must_use]
    pub fn relief(&self) -> &Relief {
        &self.relief
    }

    /// Columns and rows of the map.
    #[must_use]
    pub fn size(&self) -> DVec2 {
        self.heights.size()
    }

    /// F_u and F_v at texture coordinates: world units per unit of u and v.
    #[must_use]
    pub fn slope(&self, uv: DVec2) -> DVec2 {
        let r = &self.relief;
        let scale = self.heights.size() * r.repeat;
        self.heights.gradient(r.gradient, r.wrap, uv * scale) * scale * r.scale
    }

    /// The unit normal `normal` of triangle `t` at the perspective weights `q`, bent and normalised as `way` says. As it
    /// was where the triangle has no area, or where numbers beyond all measure give none.
    #[must_use]
    pub fn bend(&self, t: &ScreenTriangle, q: [f64; 3], normal: DVec3, way: Normalise) -> DVec3 {
        let uv = t.uv[0] * q[0] + t.uv[1] * q[1] + t.uv[2] * q[2];
        let slope = self.slope(uv);
        let [e1, e2] = [1, 2].map(|i| t.world[i] - t.world[0]);
        let [f1, f2] = [1, 2].map(|i: usize| slope.dot(t.uv[i] - t.uv[0]));
        let gradient = (e2 * f1 - e1 * f2).cross(normal) / e1.cross(e2).length();
        let bent = way.bend(normal, gradient);
        if bent.is_finite() {
            bent
        } else {
            normal
        }
    }
}

#[cfg(test)]
mod tests;
