//! Stimulus: the register writes that draw a scene, and the host that feeds them to a core.

mod build;
mod duff;
mod host;
mod material;
mod sample;

pub use build::{build, Primitive, Stimulus, StimulusError, StimulusOptions, Triangle};
pub use host::{Host, Step};
pub use material::{greatest_exponent, Material};
pub use sample::sample_triangles;
