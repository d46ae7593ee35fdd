//! Scenes, geometry and exact shading: what a perfect renderer would draw, and what each shading method draws instead.
//! Knows no hardware.

pub mod raster;
