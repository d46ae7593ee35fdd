//! What several tests need.

use shadegate_reference::{render, scene, Frame, Method, Prepared, RenderOptions, Scene, Skips};
use std::path::PathBuf;

/// The scenes that come with Shadegate.
#[allow(dead_code, reason = "not every test binary draws them all")]
pub const SCENES: [&str; 10] = [
    "sphere-168",
    "sphere-374",
    "sphere-690",
    "torus-288",
    "teapot",
    "two-lights",
    "gem",
    "rings",
    "spot",
    "materials",
];

/// A file in `scenes/`.
pub fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("../scenes/{name}.toml"))
}

/// Loads one of them.
#[allow(dead_code, reason = "not every test binary loads scenes")]
pub fn load(name: &str) -> Scene {
    scene::load(&path(name)).unwrap_or_else(|e| panic!("{e}"))
}

/// Prepares a scene, everything skipped.
#[allow(dead_code, reason = "not every test binary draws")]
pub fn prepare(name: &str, size: Option<(u32, u32)>) -> Prepared {
    Prepared::new(&load(name), size, &Skips::all()).unwrap_or_else(|e| panic!("{e}"))
}

/// Draws with the usual options.
#[allow(dead_code, reason = "not every test binary draws")]
pub fn draw(p: &Prepared, method: Method) -> Frame {
    render(p, method, &RenderOptions::default()).0
}

/// Largest and root-mean-square difference in LSB.
#[allow(dead_code, reason = "not every test binary compares")]
pub fn difference(a: &Frame, b: &Frame) -> (u8, f64) {
    assert_eq!((a.width, a.height), (b.width, b.height));
    let (mut max, mut sum) = (0, 0.0);
    for (p, q) in a.pixels.iter().flatten().zip(b.pixels.iter().flatten()) {
        max = max.max(p.abs_diff(*q));
        sum += f64::from(p.abs_diff(*q)).powi(2);
    }
    (max, (sum / (3 * a.pixels.len()) as f64).sqrt())
}
