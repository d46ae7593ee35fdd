//! The emitted Verilog of the line cores, of the unit that delivers columns and of the cubic interpolant is that under
//! `tests/expected/`, byte for byte, and lint finds nothing in it.
//! After a deliberate change: `SHADEGATE_BLESS=1 cargo test --release -p shadegate-gen --test expected_lines`.

mod common;

use rust_hdl_core::prelude::Block;
use shadegate_gen::netlist::{collect, elaborate, undocumented};
use shadegate_gen::package::{rtl, GENERATOR};
use shadegate_gen::verilog::check::check;
use shadegate_gen::verilog::{emit, VerilogFile};
use shadegate_hdl::interpolate::cubic_1::Cubic1;
use shadegate_hdl::line::cone_column::ConeColumns;
use shadegate_hdl::line::Filter;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::simulate::Simulator;
use std::path::Path;

/// The checked text of a connected description.
fn text(design: &dyn Block) -> Vec<VerilogFile> {
    let top = collect(design).expect("translates");
    assert!(undocumented(&top).is_none(), "{:?}", undocumented(&top));
    elaborate(&top).expect("elaborates");
    let files = emit(&top, GENERATOR).expect("emits");
    for f in &files {
        check(&f.file_name(), &f.text).expect("is in the safe subset");
    }
    files
}

fn compare(name: &str, files: &[VerilogFile]) {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/expected")
        .join(name);
    if std::env::var_os("SHADEGATE_BLESS").is_some() {
        let _ = std::fs::remove_dir_all(&directory);
        std::fs::create_dir_all(&directory).expect("writable");
        for f in files {
            std::fs::write(directory.join(f.file_name()), &f.text).expect("writable");
        }
    }
    for f in files {
        let path = directory.join(f.file_name());
        let want =
            std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        let line = want.lines().zip(f.text.lines()).position(|(a, b)| a != b);
        let line = line.map(|l| l + 1);
        assert_eq!(
            want,
            f.text,
            "{}: first difference at line {line:?}",
            path.display()
        );
    }
    let there = std::fs::read_dir(&directory).expect("exists").count();
    assert_eq!(there, files.len(), "stray files in {directory:?}");
    lint(&directory, files);
}

fn lint(directory: &Path, files: &[VerilogFile]) {
    common::need("verilator");
    let names: Vec<String> = files.iter().map(VerilogFile::file_name).collect();
    let top = names
        .last()
        .and_then(|n| n.strip_suffix(".v"))
        .expect("a file");
    let mut arguments = vec!["--lint-only", "-Wall", "--top-module", top];
    arguments.extend(names.iter().map(String::as_str));
    common::silent(directory, "verilator", &arguments);
}

#[test]
fn the_line_cores() {
    for filter in Filter::ALL {
        let core = Core::for_frame(Order::Line(filter), 320, 240).expect("in range");
        compare(core.name(), &rtl(&core).expect("emits").files);
    }
}

#[test]
fn columns_of_three_pixels_per_clock() {
    let unit = Simulator::new(ConeColumns::<17, 5, 26>::default()).expect("connects");
    compare("cone_columns", &text(unit.design.as_ref()));
}

#[test]
fn cubics_of_64_bits() {
    let unit = Simulator::new(Cubic1::<11, 52>::default()).expect("connects");
    compare("cubic_1", &text(unit.design.as_ref()));
}
