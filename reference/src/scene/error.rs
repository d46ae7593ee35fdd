//! The one kind of scene error: one line that says where, which field, what is wrong and what would be accepted.

use std::path::Path;

/// Why a scene cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{file}:{line}: {field}: {what}; {accepted}")]
pub struct SceneError {
    /// The scene file.
    pub file: String,
    /// Line in it, from 1.
    pub line: usize,
    /// Path of the field, such as `light[0].colour`.
    pub field: String,
    /// What is wrong.
    pub what: String,
    /// What would be accepted.
    pub accepted: String,
}

impl SceneError {
    /// Line breaks in foreign texts (operating system, parser) become blanks, so that the message stays one line.
    pub(crate) fn new(file: &Path, line: usize, field: &str, what: &str, accepted: &str) -> Self {
        let flat = |s: &str| s.split_whitespace().collect::<Vec<_>>().join(" ");
        Self {
            file: file.display().to_string(),
            line,
            field: flat(field),
            what: flat(what),
            accepted: flat(accepted),
        }
    }
}
