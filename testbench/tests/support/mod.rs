//! What the tests on scenes have in common.

// Every test file takes what it needs.
#![allow(dead_code)]

use shadegate_reference::{scene, Method, Scene};
use shadegate_testbench::cosim::CosimOptions;
use shadegate_testbench::engine::Engine;
use std::path::Path;

/// A scene of the project, by its file's name.
pub fn load(name: &str) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../scenes")
        .join(name);
    scene::load(&path).unwrap_or_else(|e| panic!("{e}"))
}

/// A co-simulation that writes nothing.
pub fn options(method: Method, engine: Engine, size: Option<(u32, u32)>) -> CosimOptions {
    CosimOptions {
        method,
        engine,
        size,
        wave: None,
        output: None,
        stimulus: Default::default(),
        command: "test".into(),
    }
}
