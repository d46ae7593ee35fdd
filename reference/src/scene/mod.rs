//! Scenes: what there is to draw, read from TOML (design.md section 6) and checked so that nothing later has to.

mod animation;
mod build;
mod error;
mod light;
mod material;
mod object;
mod read;
mod surface;

pub use build::{load, parse};
pub use error::SceneError;
pub use light::{Attenuation, Falloff, Light, LightKind, SpotWidth};
pub use material::{Brdf, Highlight, Material};

use crate::animation::Animation;
use crate::antialias::Antialias;
use crate::line::cue::Cue;
use crate::line::LineFilter;
use crate::mesh::Mesh;
use crate::method::Method;
use crate::sample::Filter;
use glam::{DMat4, DVec3};
use std::path::PathBuf;

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
    /// How it moves.
    pub animation: Option<Animation>,
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
    /// Faces or edges.
    pub draw: Draw,
}

/// What of an object is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Draw {
    /// Its faces.
    #[default]
    Shaded,
    /// Its edges, with hidden lines removed.
    Wireframe,
}

/// What the scene asks to be drawn with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Render {
    /// The method; `quadratic` unless said otherwise.
    pub method: Method,
    /// Samples in each direction of a pixel; 1 unless said otherwise.
    pub samples: u32,
    /// How they are weighted.
    pub filter: Filter,
    /// How edges of wireframes are drawn.
    pub line: LineFilter,
    /// Depth cueing of wireframes.
    pub cue: Cue,
    /// Anti-aliasing of edges of polygons.
    pub antialias: Antialias,
}

impl Default for Render {
    fn default() -> Self {
        Self {
            method: Method::Quadratic,
            samples: 1,
            filter: Filter::default(),
            line: LineFilter::default(),
            cue: Cue::default(),
            antialias: Antialias::default(),
        }
    }
}
