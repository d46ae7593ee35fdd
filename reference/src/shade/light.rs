//! The reflection model: I = emission + ambient + Σ colour·D·f·reflection, per channel, times 255. Colour is that of the
//! light, D the fall-off beside the axis of a spot ([`super::spot`]), f that with distance ([`super::attenuation`]), and
//! the reflection that of the material ([`super::brdf`]). Nothing casts a shadow.
//!
//! Where a surface turns away from every light its ambient part fades (Hast 2004, 3.272): ambient·(1 + q·N·L) for
//! N·L < 0, q in 0..=1, with the largest N·L of all lights, whatever their strength there. It joins the lit side without
//! a step.

use super::attenuation;
use super::brdf::{half_way, Reflectance};
use super::spot::Cone;
use crate::scene::{Camera, Light, LightKind, Material, Projection, Scene};
use glam::DVec3;

/// Lights, materials and viewer: all that shading needs besides a position and a normal.
#[derive(Clone, Debug)]
pub struct Surroundings {
    lights: Vec<Light>,
    /// The distributions of those that are spots.
    cones: Vec<Option<Cone>>,
    /// Half-way vectors of light and viewer where both are infinitely far and not opposite.
    half: Vec<Option<DVec3>>,
    materials: Vec<Material>,
    reflectances: Vec<Reflectance>,
    viewer: Viewer,
    /// Whether lights whose cone misses a triangle are skipped.
    pub(super) skip_spots: bool,
}

/// Light that arrives at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Incident {
    /// Unit vector from the point towards the light; zero where the light lies in the point.
    pub direction: DVec3,
    /// RGB times intensity at the point, fallen off, fractions of full scale.
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
        let cone = |light: &Light| match light.kind {
            LightKind::Spot { falloff, width, .. } => Some(Cone::new(falloff, width)),
            LightKind::Directional { .. } | LightKind::Point { .. } => None,
        };
        let viewer = match camera.projection {
            Projection::Orthographic { .. } => {
                Viewer::Direction((camera.eye - camera.target).normalize())
            }
            Projection::Perspective { .. } => Viewer::Position(camera.eye),
        };
        let half = |light: &Light| match (light.kind, viewer) {
            (LightKind::Directional { direction }, Viewer::Direction(v)) => half_way(-direction, v),
            _ => None,
        };
        Self {
            cones: lights.iter().map(cone).collect(),
            half: lights.iter().map(half).collect(),
            lights,
            reflectances: materials.iter().map(Reflectance::new).collect(),
            materials,
            viewer,
            skip_spots: true,
        }
    }

    /// A material by its index.
    #[must_use]
    pub fn material(&self, index: usize) -> &Material {
        &self.materials[index]
    }

    /// Every material.
    #[must_use]
    pub fn materials(&self) -> &[Material] {
        &self.materials
    }

    /// How a material reflects.
    #[must_use]
    pub fn reflectance(&self, material: usize) -> &Reflectance {
        &self.reflectances[material]
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

    /// Light `k` and, of a spot, its distribution.
    #[must_use]
    pub fn light(&self, k: usize) -> (&Light, Option<&Cone>) {
        (&self.lights[k], self.cones[k].as_ref())
    }

    /// The unit vector from a point towards the viewer; zero in the eye itself.
    #[must_use]
    pub fn view(&self, position: DVec3) -> DVec3 {
        match self.viewer {
            Viewer::Direction(v) => v,
            Viewer::Position(eye) => (eye - position).normalize_or_zero(),
        }
    }

    /// The unit vector towards a viewer that is infinitely far.
    #[must_use]
    pub fn distant_view(&self) -> Option<DVec3> {
        match self.viewer {
            Viewer::Direction(v) => Some(v),
            Viewer::Position(_) => None,
        }
    }

    /// What light `k` sends to a point.
    #[must_use]
    pub fn incident(&self, k: usize, position: DVec3) -> Incident {
        let (light, cone) = self.light(k);
        let (from, fall_off) = match light.kind {
            LightKind::Directional { direction } => {
                return Incident {
                    direction: -direction,
                    colour: light.colour,
                }
            }
            LightKind::Point {
                position,
                attenuation,
            }
            | LightKind::Spot {
                position,
                attenuation,
                ..
            } => (position, attenuation),
        };
        let direction = (from - position).normalize_or_zero();
        let mut factor = attenuation::factor(&fall_off, (from - position).length());
        if let (
            LightKind::Spot {
                direction: axis, ..
            },
            Some(cone),
        ) = (light.kind, cone)
        {
            factor *= cone.factor(-axis.dot(direction));
        }
        Incident {
            direction,
            colour: light.colour * factor,
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
        self.shade_by(0..self.lights.len(), material, position, normal)
    }

    /// The same with some of the lights only. The ambient part is that of all lights.
    #[must_use]
    pub fn shade_by(
        &self,
        lights: impl Iterator<Item = usize>,
        material: usize,
        position: DVec3,
        normal: DVec3,
    ) -> DVec3 {
        let view = self.view(position);
        let facing = |k| normal.dot(self.incident(k, position).direction);
        let mut sum = self.materials[material].unlit((0..self.lights.len()).map(facing));
        for k in lights {
            let light = self.incident(k, position);
            if light.colour != DVec3::ZERO {
                let half = || self.half[k].or_else(|| half_way(light.direction, view));
                let reflectance = &self.reflectances[material];
                sum += light.colour * reflectance.reflect(normal, light.direction, view, half);
            }
        }
        sum * 255.0
    }
}

impl Material {
    /// Emission and ambient part, fractions of full scale, where N·L of the lights are `facing`.
    #[must_use]
    pub fn unlit(&self, facing: impl Iterator<Item = f64>) -> DVec3 {
        if self.shadow == 0.0 {
            return self.emission + self.ambient;
        }
        // Without any light there is no shadow side.
        let largest = facing.reduce(f64::max).unwrap_or(0.0);
        self.emission + self.ambient * (1.0 + self.shadow * largest.min(0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Attenuation, Falloff, SpotWidth};

    fn camera() -> Camera {
        Camera {
            eye: DVec3::Z * 10.0,
            target: DVec3::ZERO,
            up: DVec3::Y,
            projection: Projection::Orthographic { height: 2.0 },
            near: 1.0,
            far: 20.0,
        }
    }

    fn material(shininess: f64) -> Material {
        Material {
            ambient: DVec3::splat(0.1),
            diffuse: DVec3::splat(0.4),
            specular: DVec3::splat(0.5),
            shininess,
            ..Material::default()
        }
    }

    fn lit_by(kinds: &[LightKind], m: Material) -> Surroundings {
        let light = |kind: &LightKind| Light {
            kind: *kind,
            colour: DVec3::new(1.0, 0.5, 0.0),
        };
        Surroundings::of(kinds.iter().map(light).collect(), vec![m], &camera())
    }

    fn directional(direction: DVec3) -> LightKind {
        LightKind::Directional { direction }
    }

    fn point(position: DVec3) -> LightKind {
        LightKind::Point {
            position,
            attenuation: Attenuation::NONE,
        }
    }

    #[test]
    fn straight_on_everything_counts() {
        let s = lit_by(&[directional(DVec3::NEG_Z)], material(20.0));
        let c = s.shade(0, DVec3::ZERO, DVec3::Z);
        assert!(c.distance(DVec3::new(1.0, 0.55, 0.1) * 255.0) < 1e-9);
    }

    #[test]
    fn thirty_degrees_by_hand() {
        let s = lit_by(&[point(DVec3::Z * 7.0)], material(3.0));
        let n = DVec3::new(0.5, 0.0, 0.75f64.sqrt());
        let c = s.shade(0, DVec3::ZERO, n);
        let cos = 0.75f64.sqrt();
        assert!((c.x - 255.0 * (0.1 + 0.4 * cos + 0.5 * cos.powi(3))).abs() < 1e-9);
    }

    #[test]
    fn light_from_behind_has_no_half_way_vector() {
        let s = lit_by(&[directional(DVec3::Z)], material(1.0));
        let c = s.shade(0, DVec3::ZERO, DVec3::Z);
        assert!(c.distance(DVec3::splat(25.5)) < 1e-9);
    }

    #[test]
    fn a_light_in_the_surface_gives_no_nan() {
        for attenuation in [
            Attenuation::NONE,
            Attenuation {
                constant: 0.0,
                linear: 0.0,
                quadratic: 1.0,
            },
        ] {
            let position = DVec3::ZERO;
            let spot = LightKind::Spot {
                position,
                direction: DVec3::X,
                falloff: Falloff::Soft,
                width: SpotWidth::Field(179.0),
                attenuation,
            };
            for kind in [
                LightKind::Point {
                    position,
                    attenuation,
                },
                spot,
            ] {
                let s = lit_by(&[kind], material(5.0));
                assert!(s.shade(0, DVec3::ZERO, DVec3::Z).is_finite());
            }
        }
    }

    #[test]
    fn spots_fall_off_beside_their_axis_and_with_distance() {
        let spot = LightKind::Spot {
            position: DVec3::Z * 2.0,
            direction: DVec3::NEG_Z,
            falloff: Falloff::Hard,
            width: SpotWidth::Beam(90.0),
            attenuation: Attenuation {
                constant: 0.0,
                linear: 1.0,
                quadratic: 0.0,
            },
        };
        let s = lit_by(&[spot], material(5.0));
        let red = |x: f64| s.incident(0, DVec3::X * x).colour.x;
        assert_eq!(red(0.0), 0.5);
        assert!((red(2.0) - 0.5 / 8.0f64.sqrt()).abs() < 1e-15);
        assert_eq!(red(20.0), 0.0);
        assert_eq!(s.incident(0, DVec3::Z * 3.0).colour, DVec3::ZERO);
        assert!(!s.is_constant(0));
    }

    #[test]
    fn emission_is_added_as_it_is() {
        let m = Material {
            emission: DVec3::new(0.2, 0.0, 0.4),
            ..material(5.0)
        };
        let c = lit_by(&[], m).shade(0, DVec3::ZERO, DVec3::Z);
        assert!(c.distance(DVec3::new(0.3, 0.1, 0.5) * 255.0) < 1e-12);
    }

    fn tilted(degrees: f64) -> DVec3 {
        let a = degrees.to_radians();
        DVec3::new(a.sin(), 0.0, a.cos())
    }

    #[test]
    fn the_ambient_part_fades_on_the_shadow_side() {
        for q in [0.0, 0.5, 1.0] {
            let m = Material {
                shadow: q,
                diffuse: DVec3::splat(0.4),
                specular: DVec3::ZERO,
                ..material(5.0)
            };
            let s = lit_by(&[directional(DVec3::NEG_Z)], m);
            let at = |degrees: f64| s.shade(0, DVec3::ZERO, tilted(degrees)).z;
            assert!((at(30.0) - 25.5).abs() < 1e-9, "only red and green are lit");
            assert!((at(180.0) - 25.5 * (1.0 - q)).abs() < 1e-9);
            assert!((at(120.0) - 25.5 * (1.0 - q / 2.0)).abs() < 1e-9);
            // No step at the terminator.
            assert!((at(90.0 + 1e-6) - at(90.0 - 1e-6)).abs() < 1e-5);
        }
    }

    #[test]
    fn one_light_in_front_keeps_the_ambient_part() {
        let m = Material {
            shadow: 1.0,
            specular: DVec3::ZERO,
            ..material(5.0)
        };
        let s = lit_by(&[directional(DVec3::Z), directional(DVec3::NEG_Z)], m);
        assert!((s.shade(0, DVec3::ZERO, DVec3::Z).z - 25.5).abs() < 1e-9);
        // Sideways it is the nearer of the two that counts.
        assert!((s.shade(0, DVec3::ZERO, tilted(100.0)).z - 25.5).abs() < 1e-9);
    }
}
