//! Visibility: the depth memory and the read–compare–write unit in front of it.

pub mod frame_memory;
pub mod pages;
pub mod pages_model;
pub mod z_buffer;
pub mod z_buffer_model;

/// Bits of a stored depth; 0 is "nothing drawn yet", larger is nearer (reversed depth).
pub const DEPTH_BITS: usize = 16;
