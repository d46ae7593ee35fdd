//! One triangle with normals of its own, as a scene.

#![allow(dead_code, reason = "not every test binary needs all of it")]

use glam::DVec3;
use rand::rngs::StdRng;
use rand::Rng;
use shadegate_reference::raster::{area2, Point, Viewport, Walk};
use shadegate_reference::scene::{
    Attenuation, Brdf, Camera, Light, LightKind, Material, Projection,
};
use shadegate_reference::shade::dispatch::{dispatch, Visitor};
use shadegate_reference::shade::shader::{Run, Shader};
use shadegate_reference::shade::Surroundings;
use shadegate_reference::{Method, Prepared, ScreenTriangle};

/// A grey triangle.
#[derive(Clone, Debug)]
pub struct Single {
    pub position: [Point; 3],
    pub inv_w: [f64; 3],
    pub normal: [DVec3; 3],
    /// Towards the light.
    pub light: DVec3,
    /// Towards the viewer; +z if not given.
    pub view: Option<DVec3>,
    /// Light and eye near by, in the place of both.
    pub near: Option<(DVec3, DVec3)>,
    pub shininess: f64,
}

const AMBIENT: f64 = 0.1;
const DIFFUSE: f64 = 0.4;
const SPECULAR: f64 = 0.5;

impl Single {
    /// A triangle of up to `size` pixels; normals within `spread` rad of one that more or less faces the light.
    pub fn random(rng: &mut StdRng, size: i32, spread: f64) -> Self {
        let position = loop {
            let mut coordinate = || rng.random_range(0..size * 256);
            let p = [0; 3].map(|_| Point {
                x: coordinate(),
                y: coordinate(),
            });
            if area2(p) < -i64::from(size * size) * 6000 {
                break p;
            }
        };
        let mut any = |reach: f64| {
            DVec3::new(
                rng.random_range(-reach..reach),
                rng.random_range(-reach..reach),
                rng.random_range(-reach..reach),
            )
        };
        let mean = (DVec3::Z + any(0.5)).normalize();
        let normal = [0; 3].map(|_| (mean + any(0.5 * spread)).normalize());
        let light = (DVec3::Z * 0.8 + any(0.7)).normalize();
        Self {
            position,
            inv_w: [1.0; 3],
            normal,
            light,
            view: None,
            near: None,
            shininess: [1.0, 2.0, 7.5, 20.0, 100.0][rng.random_range(0..5)],
        }
    }

    /// Unit L and H of the far light.
    pub fn far(&self) -> (DVec3, DVec3) {
        let view = self.view.unwrap_or(DVec3::Z);
        (self.light, (self.light + view).normalize_or_zero())
    }

    /// The vertices in the world.
    pub fn world(&self) -> [DVec3; 3] {
        [DVec3::ZERO, DVec3::X, DVec3::Y]
    }

    /// The model for two cosines, LSB.
    pub fn colour(&self, diffuse: f64, specular: f64) -> f64 {
        255.0
            * (AMBIENT
                + DIFFUSE * diffuse.max(0.0)
                + SPECULAR * specular.max(0.0).powf(self.shininess))
    }

    /// As a scene.
    pub fn prepare(&self) -> Prepared {
        let (kind, projection, eye) = match self.near {
            Some((light, eye)) => (
                LightKind::Point {
                    position: light,
                    attenuation: Attenuation::NONE,
                },
                Projection::Perspective { fov: 40.0 },
                eye,
            ),
            None => (
                LightKind::Directional {
                    direction: -self.light,
                },
                Projection::Orthographic { height: 2.0 },
                self.view.unwrap_or(DVec3::Z),
            ),
        };
        let camera = Camera {
            eye,
            target: DVec3::ZERO,
            up: DVec3::Y,
            projection,
            near: 0.1,
            far: 10.0,
        };
        let material = Material {
            name: "m".to_owned(),
            brdf: Brdf::Blinn,
            ambient: DVec3::splat(AMBIENT),
            diffuse: DVec3::splat(DIFFUSE),
            specular: DVec3::splat(SPECULAR),
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
            world: self.world(),
            normal: self.normal,
            material: 0,
            object: 0,
            face: 0,
        };
        let surroundings = Surroundings::of(vec![light], vec![material], &camera);
        Prepared::from_triangles((128, 128), [0; 3], vec![triangle], surroundings)
    }
}

struct Pixels<'a>(&'a Prepared, usize);

impl Visitor for Pixels<'_> {
    type Out = Vec<(i32, i32, f64)>;

    fn visit<S: Shader>(self, shader: &S) -> Self::Out {
        let Self(p, index) = self;
        let setup = shader.triangle(p, index);
        let viewport = Viewport {
            width: p.width,
            height: p.height,
        };
        let mut out = Vec::new();
        for walk in Walk::new(p.triangles[index].position, viewport).iter() {
            for span in walk.spans(p.width) {
                let mut run = shader.start(p, &setup, span);
                for x in span.start..span.end {
                    out.push((x, span.y, run.colour()[0]));
                    run.step();
                }
            }
        }
        out
    }
}

/// A method's own colours (red, LSB, real numbers) at the pixels of a scene's first triangle.
pub fn pixels(p: &Prepared, m: Method) -> Vec<(i32, i32, f64)> {
    dispatch(p, m, Pixels(p, 0)).unwrap_or_default()
}
