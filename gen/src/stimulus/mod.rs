//! Stimulus: the register writes that draw a scene, and the host that feeds them to a core.

mod build;
mod bump;
mod duff;
mod glint;
mod host;
mod lanes;
mod lines;
mod material;
mod picture;
mod raw;
mod sample;
mod sample_lines;
mod texture;

pub use build::{build, Primitive, Stimulus, StimulusError, StimulusOptions, Triangle};
pub use bump::{GradientMap, Relief};
pub use glint::{Cone, Lobe};
pub use host::{Host, Step};
pub use lanes::clocks;
pub use lines::{build_lines, Line};
pub use material::{greatest_exponent, Material};
pub use picture::Picture;
pub use sample::{sample, sample_triangles};
pub use sample_lines::{sample_lines, single_line};
pub use texture::Covering;
