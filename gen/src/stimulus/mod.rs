//! Stimulus: the register writes that draw a scene, and the host that feeds them to a core.

mod build;
mod host;

pub use build::{build, Stimulus, StimulusError, StimulusOptions, Triangle};
pub use host::{Host, Step};
