//! The reflection model: I = ambient + Σ colour · (diffuse · max(0, N·L) + specular · max(0, N·H)ⁿ), H = (L + V)/|L + V|
//! (Blinn 1977, eq. for the half-way vector), per channel, times 255. The highlight is not switched off where N·L is
//! negative. Where L = −V there is no half-way vector and no highlight. Point lights do not fall off.

use crate::scene::{Brdf, Camera, Light, LightKind, Material, Projection, Scene};
use glam::DVec3;

/// Lights, materials and viewer: all that shading needs besides a position and a normal.
#[derive(Clone, Debug)]
pub struct Surroundings {
    lights: Vec<Light>,
    materials: Vec<Material>,
    viewer: Viewer,
}

/// Light that arrives at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Incident {
    /// Unit vector from the point towards the light; zero where the light lies in the point.
    pub direction: DVec3,
    /// RGB times intensity at the point, fractions of full scale.
    pub colour: DVec3,
}

#[derive(Clone, Copy, Debug)]
enum Viewer {
    /// Unit vector towards the viewer.
    Direction(DVec3),
    /// The eye.
    Position(DVec3),
}

impl Surroundings {
    /// Takes what is needed from a scene. The viewer of an orthographic camera is infinitely far.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        Self::of(scene.lights.clone(), scene.materials.clone(), &scene.camera)
    }

    /// Surroundings without a scene.
    #[must_use]
    pub fn of(lights: Vec<Light>, materials: Vec<Material>, camera: &Camera) -> Self {
        Self {
            lights,
            materials,
            viewer: match camera.projection {
                Projection::Orthographic { .. } => {
                    Viewer::Direction((camera.eye - camera.target).normalize())
                }
                Projection::Perspective { .. } => Viewer::Position(camera.eye),
            },
        }
    }

    /// A material by its index.
    #[must_use]
    pub fn material(&self, index: usize) -> &Material {
        &self.materials[index]
    }

    /// Where the eye is; `None` when the viewer is infinitely far.
    #[must_use]
    pub fn eye(&self) -> Option<DVec3> {
        match self.viewer {
            Viewer::Direction(_) => None,
            Viewer::Position(eye) => Some(eye),
        }
    }

    /// All lights.
    #[must_use]
    pub fn all_lights(&self) -> &[Light] {
        &self.lights
    }

    /// Whether any material has a texture.
    pub(crate) fn has_textures(&self) -> bool {
        self.materials.iter().any(|m| m.texture.is_some())
    }

    /// How many lights there are.
    #[must_use]
    pub fn lights(&self) -> usize {
        self.lights.len()
    }

    /// The unit vector from a point towards the viewer; zero in the eye itself.
    #[must_use]
    pub fn view(&self, position: DVec3) -> DVec3 {
        match self.viewer {
            Viewer::Direction(v) => v,
            Viewer::Position(eye) => (eye - position).normalize_or_zero(),
        }
    }

    /// What light `k` sends to a point.
    #[must_use]
    pub fn incident(&self, k: usize, position: DVec3) -> Incident {
        let light = &self.lights[k];
        Incident {
            direction: match light.kind {
                LightKind::Directional { direction } => -direction,
                LightKind::Point { position: p } => (p - position).normalize_or_zero(),
            },
            colour: light.colour,
        }
    }

    /// Whether light `k` and the viewer are infinitely far, so that L, V and H are the same everywhere.
    #[must_use]
    pub fn is_constant(&self, k: usize) -> bool {
        matches!(self.lights[k].kind, LightKind::Directional { .. })
            && matches!(self.viewer, Viewer::Direction(_))
    }

    /// The colour in LSB of a point with a unit normal.
    #[must_use]
    pub fn shade(&self, material: usize, position: DVec3, normal: DVec3) -> DVec3 {
        let m = &self.materials[material];
        let view = self.view(position);
        let shiny = m.brdf == Brdf::Blinn && m.specular != DVec3::ZERO;
        let mut sum = m.ambient;
        for k in 0..self.lights.len() {
            let light = self.incident(k, position);
            let l = light.direction;
            let mut reflected = m.diffuse * normal.dot(l).max(0.0);
            let half = l + view;
            if shiny && half.length_squared() > 1e-24 {
                let cosine = normal.dot(half.normalize()).max(0.0);
                if cosine > 0.0 {
                    reflected += m.specular * cosine.powf(m.shininess);
                }
            }
            sum += light.colour * reflected;
        }
        sum * 255.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn surroundings(kind: LightKind, shininess: f64) -> Surroundings {
        Surroundings {
            lights: vec![Light {
                kind,
                colour: DVec3::new(1.0, 0.5, 0.0),
            }],
            materials: vec![Material {
                name: "m".into(),
                brdf: Brdf::Blinn,
                ambient: DVec3::splat(0.1),
                diffuse: DVec3::splat(0.4),
                specular: DVec3::splat(0.5),
                shininess,
                texture: None,
                bump: None,
            }],
            viewer: Viewer::Direction(DVec3::Z),
        }
    }

    #[test]
    fn straight_on_everything_counts() {
        let s = surroundings(
            LightKind::Directional {
                direction: DVec3::NEG_Z,
            },
            20.0,
        );
        let c = s.shade(0, DVec3::ZERO, DVec3::Z);
        assert!(c.distance(DVec3::new(1.0, 0.55, 0.1) * 255.0) < 1e-9);
    }

    #[test]
    fn thirty_degrees_by_hand() {
        let s = surroundings(
            LightKind::Point {
                position: DVec3::Z * 7.0,
            },
            3.0,
        );
        let n = DVec3::new(0.5, 0.0, 0.75f64.sqrt());
        let c = s.shade(0, DVec3::ZERO, n);
        let cos = 0.75f64.sqrt();
        assert!((c.x - 255.0 * (0.1 + 0.4 * cos + 0.5 * cos.powi(3))).abs() < 1e-9);
    }

    #[test]
    fn light_from_behind_has_no_half_way_vector() {
        let s = surroundings(
            LightKind::Directional {
                direction: DVec3::Z,
            },
            1.0,
        );
        let c = s.shade(0, DVec3::ZERO, DVec3::Z);
        assert!(c.distance(DVec3::splat(25.5)) < 1e-9);
    }

    #[test]
    fn a_light_in_the_surface_gives_no_nan() {
        let s = surroundings(
            LightKind::Point {
                position: DVec3::ZERO,
            },
            5.0,
        );
        assert!(s.shade(0, DVec3::ZERO, DVec3::Z).is_finite());
    }
}
