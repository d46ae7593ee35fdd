//! Every emitted file, of both cores in both formats, is taken without a remark by Verilator's and Icarus' strictest
//! settings, and by Yosys for the families of Spartan-3, -6 and -7.

mod common;

use common::need;
use shadegate_gen::package::{package, rtl, PackageFile};
use shadegate_gen::stimulus::{build, sample_triangles, StimulusOptions};
use shadegate_gen::vectors::Trace;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::Viewport;
use std::path::Path;
use std::process::Command;

fn unpacked(order: Order, width: u32, height: u32) -> (Core, tempfile::TempDir, Vec<PackageFile>) {
    let core = Core::for_frame(order, width, height).expect("in range");
    let viewport = Viewport { width, height };
    let triangles = sample_triangles(order, viewport, 20, 1);
    let stimulus =
        build(&core, &triangles, viewport, &StimulusOptions::default()).expect("in range");
    let trace = Trace::record(core, &stimulus, |_| true);
    let files = package(&rtl(&core).expect("emits"), &trace, (width, height), None)
        .expect("packs")
        .files;
    let directory = tempfile::tempdir().expect("temporary directory");
    for f in &files {
        shadegate_gen::write::write_file(&directory.path().join(&f.path), f.text.as_bytes())
            .expect("writable");
    }
    (core, directory, files)
}

fn rtl_paths(files: &[PackageFile]) -> Vec<&str> {
    files
        .iter()
        .map(|f| f.path.as_str())
        .filter(|p| p.starts_with("rtl/") && p.ends_with(".v"))
        .collect()
}

/// Runs a tool; it must succeed and say nothing.
fn silent(directory: &Path, tool: &str, arguments: &[&str]) {
    let out = Command::new(tool)
        .current_dir(directory)
        .args(arguments)
        .output()
        .expect("tool runs");
    let said =
        String::from_utf8_lossy(&out.stdout).to_string() + &String::from_utf8_lossy(&out.stderr);
    assert!(
        out.status.success() && said.trim().is_empty(),
        "{tool} {arguments:?}: {said}"
    );
}

#[test]
fn lint() {
    need("verilator");
    need("iverilog");
    for order in [Order::Linear, Order::Quadratic] {
        for (width, height) in [(320, 240), (16, 12), (1024, 768)] {
            let (core, directory, files) = unpacked(order, width, height);
            let top = format!("{}_core", core.name());
            let rtl = rtl_paths(&files);
            let verilator = [&["--lint-only", "-Wall", "--top-module", &top], &rtl[..]].concat();
            silent(directory.path(), "verilator", &verilator);
            let iverilog = [&["-g2001", "-Wall", "-s", &top, "-o", "lint"], &rtl[..]].concat();
            silent(directory.path(), "iverilog", &iverilog);
            let bench = format!("sim/tb_{top}.v");
            // The bench comes last: its timescale is not the design's.
            let with_bench = [
                &["-g2001", "-Wall", "-o", "lint"],
                &rtl[..],
                &[bench.as_str()],
            ]
            .concat();
            silent(directory.path(), "iverilog", &with_bench);
        }
    }
}

#[test]
fn yosys_takes_every_file_for_three_families() {
    need("yosys");
    for order in [Order::Linear, Order::Quadratic] {
        let (core, directory, files) = unpacked(order, 64, 48);
        for family in ["xc3s", "xc6s", "xc7"] {
            let script = format!(
                "read_verilog {}; synth_xilinx -family {family} -top {}_core",
                rtl_paths(&files).join(" "),
                core.name()
            );
            let out = Command::new("yosys")
                .current_dir(directory.path())
                .args(["-q", "-p", &script])
                .output()
                .expect("yosys runs");
            let said = String::from_utf8_lossy(&out.stderr).to_string();
            assert!(
                out.status.success() && !said.contains("ERROR"),
                "{family}: {said}"
            );
        }
    }
}

#[test]
fn a_person_can_run_the_package_with_make() {
    need("iverilog");
    need("make");
    let (_, directory, _) = unpacked(Order::Linear, 64, 48);
    let out = Command::new("make")
        .current_dir(directory.path())
        .arg("icarus")
        .output()
        .expect("make runs");
    let said = String::from_utf8_lossy(&out.stdout).to_string();
    assert!(
        out.status.success() && said.contains("PASS clocks="),
        "{said}"
    );
}
