//! Scenes, geometry and exact shading: what a perfect renderer would draw, and what each shading method draws instead.
//! Knows no hardware.

pub mod animation;
pub mod antialias;
pub mod bump;
pub mod depth;
pub mod geometry;
pub mod line;
pub mod mesh;
pub mod method;
pub mod needs;
mod parallel;
pub mod raster;
pub mod render;
pub mod sample;
pub mod scene;
pub mod setup;
pub mod shade;
mod simd;
pub mod skips;
pub mod supported;
pub mod texture;
pub mod visibility;

pub use geometry::{Prepared, ScreenTriangle, TriangleCounts};
pub use method::Method;
pub use parallel::with as with_threads;
pub use render::{render, Frame, RenderOptions, RenderStats};
pub use scene::{Scene, SceneError};
pub use shade::{to_byte, KNOT_MAX};
pub use skips::Skips;
pub use supported::{supported, Unsupported};
