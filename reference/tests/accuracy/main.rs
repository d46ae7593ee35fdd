//! How far every method of the catalogue is from the truth, on single random triangles drawn by its own shader through
//! all its stages, in real numbers (not in the bytes of a frame).
//!
//! The truth is worked out here from the definition, with nothing of the crate's shading code. `SHADEGATE_ROUNDS=k`
//! repeats the sweep with k different seeds.

mod definitions;
mod degenerate;
mod draw;
mod hast;
mod near;
mod oracle;
mod setting;
mod sweep;
mod table;
mod vector;
