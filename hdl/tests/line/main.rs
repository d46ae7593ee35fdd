//! Lines: every unit and core against its integer model in every clock, and the pixels against the software renderer's.

mod back_pressure;
mod columns;
mod cores;
mod host;
mod pixels;
mod units;
