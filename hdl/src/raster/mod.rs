//! The raster shell: a register file for one triangle ahead, the exact edge walk, and the controls that every
//! interpolant of a core obeys. See [`shell`] for the register map.

pub mod edge_walk;
mod model;
pub mod shell;
pub mod span_shell;
pub mod span_shell_model;

/// Bits of a column in walk space, signed: −2048 to 2047.
pub const COLUMN_BITS: usize = 12;
/// Bits of an edge's error term, signed; an edge may be up to 2^19 sub-pixels (2048 rows) high.
pub const ERROR_BITS: usize = 20;
/// Bits of a row number.
pub const ROW_BITS: usize = 11;
