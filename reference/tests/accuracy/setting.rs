//! A triangle on the screen with its normals, light, viewer and material, and how it becomes a scene of the crate.

use crate::vector::{add, angle, any, around, cross, dot, scale, sub, unit, Vector};
use glam::DVec3;
use rand::rngs::StdRng;
use rand::Rng;
use shadegate_reference::raster::{area2, Point};
use shadegate_reference::scene::{
    Attenuation, Brdf, Camera, Light, LightKind, Material, Projection,
};
use shadegate_reference::shade::{case::Case, Surroundings};
use shadegate_reference::{Prepared, ScreenTriangle};

/// Where light and viewer are.
#[derive(Clone, Copy, Debug)]
pub enum Place {
    /// Infinitely far: unit L and unit H, with L·H > 0.
    Far { light: Vector, half: Vector },
    /// Near: positions of light and eye.
    Near { light: Vector, eye: Vector },
}

/// Everything a colour depends on; grey.
#[derive(Clone, Debug)]
pub struct Setting {
    pub size: (u32, u32),
    pub position: [Point; 3],
    /// Perspective weights.
    pub inv_w: [f64; 3],
    pub world: [Vector; 3],
    pub normal: [Vector; 3],
    pub place: Place,
    pub ambient: f64,
    pub diffuse: f64,
    pub specular: f64,
    pub shininess: f64,
}

impl Setting {
    /// The class of triangles this one belongs to.
    pub fn case(&self) -> Case {
        let widest = |v: [Vector; 3]| {
            angle(v[0], v[1])
                .max(angle(v[1], v[2]))
                .max(angle(v[2], v[0]))
        };
        let turn = match self.place {
            Place::Far { .. } => 0.0,
            Place::Near { .. } => {
                let at = [0, 1, 2].map(|i| self.incidence(i));
                widest(at.map(|a| a.0)).max(widest(at.map(|a| a.1)))
            }
        };
        Case {
            spread: widest(self.normal),
            turn,
            shininess: self.shininess,
            diffuse: self.diffuse,
            specular: self.specular,
        }
    }

    /// Unit L and H at vertex `i`.
    pub fn incidence(&self, i: usize) -> (Vector, Vector) {
        match self.place {
            Place::Far { light, half } => (light, half),
            Place::Near { light, eye } => {
                let l = unit(sub(light, self.world[i]));
                let v = unit(sub(eye, self.world[i]));
                (l, unit(add(l, v)))
            }
        }
    }

    /// The scene of one triangle.
    pub fn prepare(&self) -> Prepared {
        let vector = DVec3::from_array;
        let (kind, projection, eye) = match self.place {
            Place::Far { light, half } => (
                LightKind::Directional {
                    direction: -vector(light),
                },
                Projection::Orthographic { height: 2.0 },
                // The reflection of L at H: half-way between the two is H.
                sub(scale(half, 2.0 * dot(light, half)), light),
            ),
            Place::Near { light, eye } => (
                LightKind::Point {
                    position: vector(light),
                    attenuation: Attenuation::NONE,
                },
                Projection::Perspective { fov: 40.0 },
                eye,
            ),
        };
        let camera = Camera {
            eye: vector(eye),
            target: DVec3::ZERO,
            up: DVec3::Y,
            projection,
            near: 0.1,
            far: 10.0,
        };
        let material = Material {
            name: "m".to_owned(),
            brdf: Brdf::Blinn,
            ambient: DVec3::splat(self.ambient),
            diffuse: DVec3::splat(self.diffuse),
            specular: DVec3::splat(self.specular),
            shininess: self.shininess,
            ..Material::default()
        };
        let light = Light {
            kind,
            colour: DVec3::ONE,
        };
        let triangle = ScreenTriangle {
            uv: [glam::DVec2::ZERO; 3],
            position: self.position,
            inv_w: self.inv_w,
            depth: [0.5; 3],
            world: self.world.map(vector),
            normal: self.normal.map(vector),
            material: 0,
            object: 0,
            face: 0,
        };
        let surroundings = Surroundings::of(vec![light], vec![material], &camera);
        Prepared::from_triangles(self.size, [0; 3], vec![triangle], surroundings)
    }
}

/// Corners in the world of a face with a given unit normal, turning counter-clockwise about it.
pub fn face(normal: Vector) -> [Vector; 3] {
    let axis = if normal[0].abs() < 0.6 {
        [1.0, 0.0, 0.0]
    } else {
        [0.0, 1.0, 0.0]
    };
    let e = unit(cross(normal, axis));
    [[0.0; 3], e, cross(normal, e)]
}

/// A random triangle of about `width` by `height` pixels, seen from its front.
pub fn shape(rng: &mut StdRng, width: f64, height: f64) -> ((u32, u32), [Point; 3]) {
    let size = (width.ceil() as u32 + 3, height.ceil() as u32 + 3);
    loop {
        // One vertex left, one right, one anywhere between; rows anywhere, two of them far apart.
        let (top, bottom) = (1.0, 1.0 + height);
        let mut rows = [top, bottom, rng.random_range(top..bottom)];
        let turn = rng.random_range(0..3);
        rows.rotate_left(turn);
        let columns = [1.0, 1.0 + width, rng.random_range(1.0..1.0 + width)];
        let p = [0, 1, 2].map(|i| {
            let jitter = rng.random_range(-0.5..0.5);
            Point::snap(columns[i] + jitter, rows[i]).unwrap_or_default()
        });
        // Not a sliver: at least an eighth of the box.
        if area2(p).abs() as f64 > width * height / 8.0 * 65536.0 {
            return (size, if area2(p) < 0 { p } else { [p[0], p[2], p[1]] });
        }
    }
}

/// Three unit vectors of which the two farthest apart are `spread` rad apart; all pairs equally far if `even`.
pub fn normals(rng: &mut StdRng, spread: f64, even: bool) -> [Vector; 3] {
    let axis = any(rng);
    let first = around(rng, axis, 1.0..1.1);
    let places: [(f64, f64); 3] = if even {
        [0.0, 1.0, 2.0].map(|k| (1.0, k * std::f64::consts::TAU / 3.0))
    } else {
        loop {
            let p = [0; 3].map(|_| {
                (
                    rng.random_range(0.2..1.0f64).sqrt(),
                    rng.random_range(0.0..std::f64::consts::TAU),
                )
            });
            let corner = p.map(|(r, a)| [r * a.cos(), r * a.sin()]);
            let (u, v) = (
                [corner[1][0] - corner[0][0], corner[1][1] - corner[0][1]],
                [corner[2][0] - corner[0][0], corner[2][1] - corner[0][1]],
            );
            if (u[0] * v[1] - u[1] * v[0]).abs() > 0.2 {
                break p;
            }
        }
    };
    // Directions across the axis.
    let e = unit(sub(first, scale(axis, dot(first, axis))));
    let f = cross(axis, e);
    let at = |reach: f64| {
        places.map(|(r, a)| {
            let across = add(scale(e, a.cos()), scale(f, a.sin()));
            add(
                scale(axis, (reach * r).cos()),
                scale(across, (reach * r).sin()),
            )
        })
    };
    let widest = |v: [Vector; 3]| {
        angle(v[0], v[1])
            .max(angle(v[1], v[2]))
            .max(angle(v[2], v[0]))
    };
    let (mut lo, mut hi) = (0.0, std::f64::consts::PI);
    for _ in 0..60 {
        let mid = f64::midpoint(lo, hi);
        if widest(at(mid)) < spread {
            lo = mid;
        } else {
            hi = mid;
        }
    }
    at(lo)
}
