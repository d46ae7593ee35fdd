//! Lighting in object space (Hast 2004, 2.18 and 2.31): N'·L = (M·N)·L = N·(M⁻¹·L) for a rotation M. In place of the
//! normals of an object its lights and its viewer are rotated, once: an object of m vertices saves m rotations.
//!
//! That holds for directions that are the same everywhere: directional lights and a distant viewer. The transform may
//! scale by the same factor in all directions and mirror as well; stretched objects would need each normal's length anew.
//! The colours are those of world space up to rounding: 1e-12 of full scale (tested).
//!
//! A prepared scene has world normals already, for all methods; this is for whoever shades the vertices of an object by
//! themselves. What it saves is measured in the test `vertices_of_an_object`.

use super::brdf::half_way;
use super::light::Surroundings;
use crate::scene::{LightKind, Object};
use glam::{DMat3, DVec3};

/// Lights and viewer as an object sees them.
#[derive(Clone, Debug)]
pub struct ObjectSpace<'a> {
    surroundings: &'a Surroundings,
    material: usize,
    view: DVec3,
    /// Directions to the lights, half-way vectors and colours.
    lights: Vec<(DVec3, Option<DVec3>, DVec3)>,
}

impl<'a> ObjectSpace<'a> {
    /// Takes lights and viewer into the space of an object; none where a light or the viewer is near or the object is
    /// stretched.
    #[must_use]
    pub fn new(s: &'a Surroundings, object: &Object) -> Option<Self> {
        let turn = rotation(DMat3::from_mat4(object.transform))?.transpose();
        let view = s.distant_view()?;
        let lights = (0..s.lights()).map(|k| match s.light(k).0.kind {
            LightKind::Directional { direction } => {
                let half = half_way(-direction, view).map(|h| turn * h);
                Some((turn * -direction, half, s.light(k).0.colour))
            }
            LightKind::Point { .. } | LightKind::Spot { .. } => None,
        });
        Some(Self {
            material: object.material,
            view: turn * view,
            lights: lights.collect::<Option<_>>()?,
            surroundings: s,
        })
    }

    /// The colour in LSB where the unit normal *of the object's own space* is `normal`.
    #[must_use]
    pub fn shade(&self, normal: DVec3) -> DVec3 {
        let reflectance = self.surroundings.reflectance(self.material);
        let facing = |l: &(DVec3, Option<DVec3>, DVec3)| normal.dot(l.0);
        let material = self.surroundings.material(self.material);
        let mut sum = material.unlit(self.lights.iter().map(facing));
        for (light, half, colour) in &self.lights {
            sum += *colour * reflectance.reflect(normal, *light, self.view, || *half);
        }
        sum * 255.0
    }
}

/// The rotation, or rotation and reflection, in a transform that stretches nothing more than the rest.
fn rotation(linear: DMat3) -> Option<DMat3> {
    let scale = linear.determinant().abs().cbrt();
    let turn = linear * scale.recip();
    let off = turn.transpose() * turn - DMat3::IDENTITY;
    let rest = off.to_cols_array().iter().fold(0.0, |m, v| v.abs().max(m));
    // Not a number is not a rotation either.
    (rest < 1e-14).then_some(turn)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::sphere;
    use crate::scene::{Attenuation, Brdf, Camera, Highlight, Light, Material, Projection};
    use glam::{DMat4, DQuat, EulerRot};
    use std::hint::black_box;
    use std::time::{Duration, Instant};

    fn surroundings() -> Surroundings {
        let camera = Camera {
            eye: DVec3::new(1.0, 2.0, 9.0),
            target: DVec3::ZERO,
            up: DVec3::Y,
            projection: Projection::Orthographic { height: 2.0 },
            near: 0.1,
            far: 100.0,
        };
        let light = |direction: DVec3| Light {
            kind: LightKind::Directional {
                direction: direction.normalize(),
            },
            colour: DVec3::new(1.0, 0.9, 0.7),
        };
        let shiny = |brdf, highlight| Material {
            brdf,
            ambient: DVec3::splat(0.1),
            shadow: 0.8,
            specular: DVec3::splat(0.5),
            highlight,
            ..Material::default()
        };
        let materials = vec![
            shiny(Brdf::Blinn, Highlight::Pow),
            shiny(Brdf::Phong, Highlight::Kappa { degree: 3 }),
            shiny(Brdf::CookTorrance { roughness: 0.3 }, Highlight::Pow),
        ];
        let lights = vec![
            light(DVec3::new(-1.0, -2.0, -1.5)),
            light(DVec3::new(0.4, 0.1, -1.0)),
        ];
        Surroundings::of(lights, materials, &camera)
    }

    fn object(scale: DVec3, material: usize) -> Object {
        let turn = DMat3::from_quat(DQuat::from_euler(EulerRot::ZYX, 0.3, -1.1, 2.0));
        let linear = turn * DMat3::from_diagonal(scale);
        Object {
            source: "sphere".to_owned(),
            mesh: sphere::sphere(64, 48, 1.0),
            transform: DMat4::from_translation(DVec3::ONE) * DMat4::from_mat3(linear),
            material,
            draw: crate::scene::Draw::default(),
        }
    }

    /// Largest difference of the colours of all vertices in world and in object space, LSB.
    fn difference(s: &Surroundings, object: &Object) -> f64 {
        let own = ObjectSpace::new(s, object).unwrap();
        let world = DMat3::from_mat4(object.transform).inverse().transpose();
        let apart = |n: &DVec3| {
            let truth = s.shade(object.material, DVec3::ZERO, (world * *n).normalize());
            (truth - own.shade(*n)).abs().max_element()
        };
        object.mesh.normals.iter().map(apart).fold(0.0, f64::max)
    }

    #[test]
    fn colours_are_those_of_world_space() {
        let s = surroundings();
        for material in 0..3 {
            for scale in [1.0, 1e-3, 250.0, -2.0] {
                let d = difference(&s, &object(DVec3::splat(scale), material));
                assert!(d < 255.0 * 1e-12, "{material} {scale}: {d}");
            }
            let mirrored = object(DVec3::new(-3.0, 3.0, 3.0), material);
            assert!(difference(&s, &mirrored) < 255.0 * 1e-12);
        }
    }

    #[test]
    fn stretched_objects_and_near_lights_are_left_to_world_space() {
        let s = surroundings();
        assert!(ObjectSpace::new(&s, &object(DVec3::new(1.0, 1.0, 1.001), 0)).is_none());
        let camera = Camera {
            eye: DVec3::Z * 9.0,
            target: DVec3::ZERO,
            up: DVec3::Y,
            projection: Projection::Perspective { fov: 40.0 },
            near: 0.1,
            far: 100.0,
        };
        let near = Surroundings::of(vec![], vec![Material::default()], &camera);
        assert!(ObjectSpace::new(&near, &object(DVec3::ONE, 0)).is_none());
        let lamp = Light {
            kind: LightKind::Point {
                position: DVec3::X,
                attenuation: Attenuation::NONE,
            },
            colour: DVec3::ONE,
        };
        let far = Camera {
            projection: Projection::Orthographic { height: 1.0 },
            ..camera
        };
        let lit = Surroundings::of(vec![lamp], vec![Material::default()], &far);
        assert!(ObjectSpace::new(&lit, &object(DVec3::ONE, 0)).is_none());
    }

    /// Prints what the rotations cost; `cargo test --release -- --ignored --nocapture vertices_of_an_object`.
    #[test]
    #[ignore = "a measurement"]
    fn vertices_of_an_object() {
        let (s, object) = (surroundings(), object(DVec3::ONE, 0));
        let normals = &object.mesh.normals;
        let world = || {
            let turn = DMat3::from_mat4(object.transform).inverse().transpose();
            let shade = |n: &DVec3| s.shade(0, DVec3::ZERO, (turn * *n).normalize_or_zero());
            normals.iter().map(shade).sum::<DVec3>()
        };
        let own = || {
            let space = ObjectSpace::new(&s, &object).unwrap();
            normals.iter().map(|n| space.shade(*n)).sum::<DVec3>()
        };
        let time = |f: &dyn Fn() -> DVec3| {
            let mut times: Vec<Duration> = (0..101)
                .map(|_| {
                    let begin = Instant::now();
                    black_box(f());
                    begin.elapsed()
                })
                .collect();
            times.sort();
            times[50].as_secs_f64() * 1e9 / normals.len() as f64
        };
        let (world, own) = (time(&world), time(&own));
        println!(
            "per vertex: world {world:.1} ns, object space {own:.1} ns, ratio {:.3}",
            own / world
        );
    }
}
