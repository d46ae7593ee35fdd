//! Set-up for the span cores: a host that walks the edges itself and writes one span at a time.
//!
//! ```text
//!  Triangle.knots ─► Surface ─► for each span: Sweeps ─► words of the terms ─┐
//!  (vectors, colours)          (the method's own span stage, in f64)         ├─► one primitive per span
//!                              place, depth ─► words of shell and depth ─────┘
//!  colours, exponents of the materials ─► palette and tables, before the first span
//! ```
//!
//! The real numbers come from the software method's own stage per span; here they are only rounded, once, to nearest.

mod blake;
mod build;
mod curves;
mod refuse;
mod slerp;
mod spherical;
mod surface;
mod tables;
mod trapezium;
mod words;

pub use build::build;
pub use curves::{Curves, Shape};
pub use refuse::{drawable, Refused};
pub use surface::{sample, triangles, Surface, KNOTS};
pub use words::Terms;
