//! The FuseSoC core file (CAPI2).
//!
//! Every text in it is a plain scalar of letters, digits and `_ . - / : +`, so that no quoting is needed: names come
//! from the catalogue of cores and devices, paths from the package itself.

use super::build::{ise_family, nextpnr_options};
use super::{PackageFile, Target};
use shadegate_constraints::Format;
use std::fmt::Write;

/// Text of `<top>.core`; `files` are those of the package so far.
pub fn core_file(top: &str, files: &[PackageFile], target: Option<Target>) -> String {
    let paths: Vec<&str> = files.iter().map(|f| f.path.as_str()).collect();
    let below = |folder: &str, ending: &str| -> Vec<&str> {
        paths
            .iter()
            .copied()
            .filter(|p| p.starts_with(folder) && p.ends_with(ending))
            .collect()
    };
    let mut out = format!(
        "CAPI=2:\nname: shadegate::{top}:{}\ndescription: Triangle shading core by Shadegate\n\nfilesets:\n",
        env!("CARGO_PKG_VERSION")
    );
    set(&mut out, "rtl", &below("rtl/", ".v"), "verilogSource");
    let wrappers = below("wrappers/", ".v");
    if !wrappers.is_empty() {
        set(&mut out, "wrappers", &wrappers, "verilogSource");
    }
    set(
        &mut out,
        "tb",
        &[&format!("sim/tb_{top}.v")],
        "verilogSource",
    );
    set(&mut out, "verilator", &["sim/main.cpp"], "cppSource");
    // Writing to a string cannot fail.
    let _ = write!(
        out,
        "  vectors:\n    files:\n      - sim/vectors.txt: {{file_type: user, copyto: vectors.txt}}\n"
    );
    let constraints: Vec<&str> = paths
        .iter()
        .copied()
        .filter(|p| p.starts_with("constraints/"))
        .collect();
    let kind = target.map(|t| kind(t.device.constraints));
    if let Some(kind) = kind.filter(|_| !constraints.is_empty()) {
        set(&mut out, "constraints", &constraints, kind);
    }
    out.push_str(&targets(top, target));
    out
}

/// The file type that tools know a constraint file by.
fn kind(format: Format) -> &'static str {
    match format {
        Format::Ucf => "UCF",
        Format::Xdc => "xdc",
        Format::Pcf => "PCF",
        Format::Lpf => "LPF",
    }
}

fn set(out: &mut String, name: &str, files: &[&str], kind: &str) {
    let list: String = files.iter().map(|f| format!("      - {f}\n")).collect();
    let _ = write!(out, "  {name}:\n    files:\n{list}    file_type: {kind}\n");
}

fn targets(top: &str, target: Option<Target>) -> String {
    let synthesis = match target {
        None => "    default_tool: yosys\n    filesets: [rtl]\n    tools:\n      yosys:\n        arch: xilinx\n        output_format: json\n".to_owned(),
        Some(t) => tool(t),
    };
    format!(
        "\n\
         targets:\n\
         \x20 default:\n    filesets: [rtl]\n    toplevel: {top}\n\
         \x20 sim:\n    default_tool: icarus\n    filesets: [rtl, tb, vectors]\n    toplevel: tb_{top}\n    \
         tools:\n      icarus:\n        iverilog_options: [-g2001]\n\
         \x20 verilate:\n    default_tool: verilator\n    filesets: [rtl, verilator, vectors]\n    toplevel: {top}\n    \
         tools:\n      verilator:\n        mode: cc\n        run_options: [vectors.txt]\n\
         \x20 lint:\n    default_tool: verilator\n    filesets: [rtl]\n    toplevel: {top}\n    \
         tools:\n      verilator:\n        mode: lint-only\n        verilator_options: [-Wall]\n\
         \x20 synth:\n{synthesis}    toplevel: {top}\n"
    )
}

/// Options of Yosys and nextpnr for a device.
fn nextpnr(tool: &str, t: Target) -> String {
    let yosys = t.device.yosys_synthesis();
    let options: Vec<&str> = yosys.split(' ').skip(1).collect();
    format!(
        "      {tool}:\n        yosys_synth_options: [{}]\n        nextpnr_options: [{}]\n",
        options.join(", "),
        nextpnr_options(t).join(", ")
    )
}

/// The synthesis target of a device.
fn tool(t: Target) -> String {
    let device = t.device;
    let (package, speed) = t
        .board
        .map_or((&device.package, device.speed), |b| (&b.package, b.speed));
    let options = match device.constraints {
        Format::Xdc => format!("      vivado:\n        part: {}\n", t.part()),
        Format::Ucf => format!(
            "      ise:\n        family: {}\n        device: {}\n        package: {package}\n        speed: -{speed}\n",
            ise_family(&device.family),
            device.name
        ),
        Format::Pcf => nextpnr("icestorm", t),
        Format::Lpf => nextpnr("trellis", t),
    };
    let name = options.trim_start().split(':').next().unwrap_or_default();
    format!("    default_tool: {name}\n    filesets: [rtl, constraints]\n    tools:\n{options}")
}
