//! Run time against error: every shading method, on spheres of several tessellations, at several exponents and sizes;
//! what each skip saves; and the comparisons that the papers printed, measured again.
//!
//! Everything is timed on one thread, side by side in one run: all methods take turns in rounds, and every figure is a
//! median over the rounds, so that a disturbance of the machine meets all of them.

pub mod clock;
pub mod front;
pub mod machine;
pub mod papers;
mod plot;
pub mod row;
pub mod scenes;
pub mod select;
pub mod skips;
pub mod sweep;
pub mod within;
pub mod write;

use crate::compare::CompareError;
use shadegate_reference::SceneError;

/// Why there are no figures.
#[derive(Debug, thiserror::Error)]
pub enum BenchError {
    /// A scene that cannot be read or prepared.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// Frames that cannot be compared.
    #[error(transparent)]
    Compare(#[from] CompareError),
    /// A folder of scenes that cannot be used.
    #[error("'{folder}' {why}")]
    Folder {
        /// As it was given.
        folder: String,
        /// What is wrong with it.
        why: String,
    },
    /// A plot that cannot be drawn.
    #[error("the plot cannot be drawn: {0}")]
    Plot(String),
}

/// Told before each step: how many are done, of how many, and what comes now.
pub type OnStep<'a> = dyn FnMut(usize, usize, &str) + 'a;
