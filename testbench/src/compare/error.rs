//! Why frames cannot be compared, read or written; every message is one line.

use std::path::PathBuf;
use thiserror::Error;

/// Why frames cannot be compared, read or written.
#[derive(Debug, Error)]
pub enum CompareError {
    /// A frame without pixels, or with too many.
    #[error("a frame cannot be {width}x{height} pixels")]
    BadSize {
        /// Pixels in a row.
        width: u32,
        /// Rows.
        height: u32,
    },
    /// A frame whose pixels do not fill it.
    #[error("a frame of {width}x{height} pixels cannot be made of {pixels}")]
    WrongLength {
        /// Pixels in a row.
        width: u32,
        /// Rows.
        height: u32,
        /// Pixels given.
        pixels: usize,
    },
    /// Two frames that cannot be laid over one another.
    #[error("the images differ in size: {}x{} and {}x{}", a.0, a.1, b.0, b.1)]
    SizesDiffer {
        /// Width and height of the first.
        a: (u32, u32),
        /// Width and height of the second.
        b: (u32, u32),
    },
    /// A file that cannot be opened or read.
    #[error("cannot read {path:?}: {source}")]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// A file of another kind.
    #[error("{path:?} is not a PNG image")]
    NotPng {
        /// The file.
        path: PathBuf,
    },
    /// A file that begins as a PNG and goes on as something else.
    #[error("{path:?} is not a whole PNG image: {why}")]
    BadPng {
        /// The file.
        path: PathBuf,
        /// What is wrong with it, in one line.
        why: String,
    },
    /// A file that cannot be written.
    #[error("cannot write {path:?}: {why}")]
    Write {
        /// The file.
        path: PathBuf,
        /// Why, in one line.
        why: String,
    },
}
