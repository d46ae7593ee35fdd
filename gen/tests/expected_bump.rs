//! The emitted Verilog of the bump units is that under `tests/expected/`, byte for byte, and lint finds nothing in it.
//! After a deliberate change: `SHADEGATE_BLESS=1 cargo test --release -p shadegate-gen --test expected_bump`.

mod common;

use rust_hdl_core::prelude::Block;
use shadegate_gen::netlist::{collect, elaborate, undocumented};
use shadegate_gen::package::GENERATOR;
use shadegate_gen::verilog::check::check;
use shadegate_gen::verilog::{emit, VerilogFile};
use shadegate_hdl::bump::dot::BumpDot;
use shadegate_hdl::bump::fetch::BumpFetch;
use shadegate_hdl::bump::newton::BumpNewton;
use shadegate_hdl::bump::reflection::BumpReflection;
use shadegate_hdl::simulate::Simulator;
use std::path::Path;

fn unit(name: &str, design: &dyn Block) {
    let top = collect(design).expect("translates");
    assert!(undocumented(&top).is_none(), "{:?}", undocumented(&top));
    elaborate(&top).expect("elaborates");
    let files = emit(&top, GENERATOR).expect("emits");
    let directory = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/expected")
        .join(name);
    if std::env::var_os("SHADEGATE_BLESS").is_some() {
        let _ = std::fs::remove_dir_all(&directory);
        std::fs::create_dir_all(&directory).expect("writable");
        for f in &files {
            std::fs::write(directory.join(f.file_name()), &f.text).expect("writable");
        }
    }
    for f in &files {
        check(&f.file_name(), &f.text).expect("is in the safe subset");
        let path = directory.join(f.file_name());
        let want =
            std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        assert_eq!(want, f.text, "{}", path.display());
    }
    let there = std::fs::read_dir(&directory).expect("exists").count();
    assert_eq!(there, files.len(), "stray files in {directory:?}");
    common::need("verilator");
    let names: Vec<String> = files.iter().map(VerilogFile::file_name).collect();
    let top = names
        .last()
        .and_then(|n| n.strip_suffix(".v"))
        .expect("a file");
    let mut arguments = vec!["--lint-only", "-Wall", "--top-module", top];
    arguments.extend(names.iter().map(String::as_str));
    common::silent(&directory, "verilator", &arguments);
}

#[test]
fn gradients_from_four_banks() {
    let fetch = Simulator::new(BumpFetch::default()).expect("connects");
    unit("bump_fetch", fetch.design.as_ref());
}

#[test]
fn normals_by_newton() {
    let newton = Simulator::new(BumpNewton::default()).expect("connects");
    unit("bump_newton", newton.design.as_ref());
}

#[test]
fn normals_by_reflection() {
    let reflection = Simulator::new(BumpReflection::default()).expect("connects");
    unit("bump_reflection", reflection.design.as_ref());
}

#[test]
fn cosines() {
    let dot = Simulator::new(BumpDot::default()).expect("connects");
    unit("bump_dot", dot.design.as_ref());
}
