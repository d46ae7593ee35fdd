//! Scenes: what there is to draw, read from TOML (design.md section 6) and checked so that nothing later has to.

mod build;
mod error;
mod object;
mod read;
mod surface;

pub use build::load;
pub use error::SceneError;

use crate::bump::BumpMap;
use crate::mesh::Mesh;
use crate::method::Method;
use crate::texture::Texture;
use glam::{DMat4, DVec3};
use std::path::PathBuf;
use std::sync::Arc;

/// Largest width and height of an image, in pixels.
pub const IMAGE_LIMIT: u32 = 16384;

/// A scene with its meshes loaded.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Stem of the file name.
    pub name: String,
    /// The file it was read from.
    pub file: PathBuf,
    /// Size and background of the frame.
    pub image: Image,
    /// Where it is seen from.
    pub camera: Camera,
    /// What shines.
    pub lights: Vec<Light>,
    /// How surfaces reflect; never empty.
    pub materials: Vec<Material>,
    /// What is drawn, in order.
    pub objects: Vec<Object>,
    /// What the scene asks to be drawn with.
    pub render: Render,
}

/// Size and background of the frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Image {
    /// Pixels in a row, 1 to [`IMAGE_LIMIT`].
    pub width: u32,
    /// Rows, 1 to [`IMAGE_LIMIT`].
    pub height: u32,
    /// Colour where nothing is drawn, RGB.
    pub background: [u8; 3],
}

/// A camera at `eye`, looking at `target`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Position.
    pub eye: DVec3,
    /// The point in the middle of the frame.
    pub target: DVec3,
    /// A direction that appears upwards; not parallel to the view.
    pub up: DVec3,
    /// How depth affects size.
    pub projection: Projection,
    /// Nearest depth drawn, > 0.
    pub near: f64,
    /// Farthest depth drawn, > `near`.
    pub far: f64,
}

/// How depth affects size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// Vertical angle of view in degrees, between 0 and 180.
    Perspective {
        /// The angle, degrees.
        fov: f64,
    },
    /// No perspective: what is this high fills the frame.
    Orthographic {
        /// World units from the lower to the upper edge of the frame.
        height: f64,
    },
}

/// A light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Where the light comes from.
    pub kind: LightKind,
    /// RGB times intensity, each at least 0.
    pub colour: DVec3,
}

/// Where a light comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// From infinitely far.
    Directional {
        /// Unit vector in the direction the light travels.
        direction: DVec3,
    },
    /// From a point, without fall-off.
    Point {
        /// World position.
        position: DVec3,
    },
}

/// The reflection models known to this crate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Brdf {
    /// Diffuse only.
    Lambert,
    /// Diffuse and a highlight of the half-way vector (Blinn 1977).
    Blinn,
}

/// How a surface reflects. All colours are fractions of full scale, RGB, at least 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The name objects use.
    pub name: String,
    /// The model.
    pub brdf: Brdf,
    /// Added everywhere.
    pub ambient: DVec3,
    /// Factor of N·L.
    pub diffuse: DVec3,
    /// Factor of (N·H)ⁿ; zero for [`Brdf::Lambert`].
    pub specular: DVec3,
    /// The exponent n, 0 to 10 000.
    pub shininess: f64,
    /// A picture that multiplies the colour.
    pub texture: Option<Arc<Texture>>,
    /// A height map that bends the normals.
    pub bump: Option<Arc<BumpMap>>,
}

/// A mesh somewhere in the world.
#[derive(Clone, Debug)]
pub struct Object {
    /// Shape or mesh file, for messages.
    pub source: String,
    /// The triangles in their own coordinates.
    pub mesh: Mesh,
    /// Takes mesh coordinates to the world; invertible.
    pub transform: DMat4,
    /// Index into [`Scene::materials`].
    pub material: usize,
}

/// What the scene asks to be drawn with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Render {
    /// The method; `quadratic` unless said otherwise.
    pub method: Method,
}
