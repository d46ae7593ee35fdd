//! Scratch.
use shadegate_testbench::cosim::*;
use shadegate_testbench::engine::Engine;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let scene = shadegate_reference::scene::load(std::path::Path::new(&a[1])).unwrap_or_else(|e| panic!("{e}"));
    let o = CosimOptions { method: a[2].parse().unwrap(), engine: a[3].parse().unwrap(), size: None, wave: None, output: Some(format!("out/{}-{}-{}", scene.name, a[2], a[3]).into()), stimulus: Default::default(), command: "x".into() };
    match cosim(&scene, &o) {
        Ok(r) => println!("{}", serde_json::to_string_pretty(&r).unwrap()),
        Err(e) => println!("error: {e}"),
    }
}
