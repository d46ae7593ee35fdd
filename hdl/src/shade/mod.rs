//! Cores: a datapath per shading method behind the shared raster shell, with depth test and pixel stream.

pub mod blake;
pub mod bump_newton;
pub mod bump_reflection;
pub mod chebyshev;
pub mod device;
pub mod duff;
pub mod gouraud;
pub mod kappa;
pub mod lanes;
pub mod load_lanes;
pub mod model;
pub mod pace;
pub mod phong;
pub mod pixel_stream;
pub mod quadratic;
pub mod quadratic_dots;
pub mod quadratic_engine;
pub mod saturate;
pub mod slerp;
pub mod span_bound;
pub mod span_core;
pub mod span_model;
pub mod spherical;
pub mod spot;
pub mod textured_affine;
pub mod textured_perspective;
pub mod textured_quadratic;

/// Integer bits of a colour word: ±2048 LSB holds a six-knot colour of knots in 0..=1530.
pub const COLOUR_INTEGER_BITS: usize = 11;
/// Integer bits of the depth interpolant, which walks the depth word less [`DEPTH_BIAS`].
pub const DEPTH_INTEGER_BITS: usize = 15;
/// Subtracted from a depth word, so that 0..=65535 fits a signed word.
pub const DEPTH_BIAS: i64 = 1 << 15;
/// Fraction bits of the depth interpolant.
pub const DEPTH_FRACTION_BITS: usize = 16;
