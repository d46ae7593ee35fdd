//! Shading interpolators as hardware: number formats, rust-hdl descriptions, and beside each description the integer
//! model that it must equal clock by clock. Knows no scenes.

/// A remark that the Verilog keeps and the simulation ignores.
///
/// `#[hdl_gen]` stores the text in the syntax tree. The first word decides what the back end does with it:
/// `name`, `title`, `equation`, `source`, `latency` head the module; `signal <name>: <text>` explains a register or wire.
#[macro_export]
macro_rules! comment {
    ($text:literal) => {};
}

pub mod bump;
pub mod compact;
pub mod depth;
pub mod format;
pub mod interpolate;
pub mod light;
pub mod line;
pub mod lit;
pub mod raster;
pub mod set_up;
pub mod shade;
pub mod simulate;
pub mod sources;
pub mod texture;
