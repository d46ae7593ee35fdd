//! Rung 5: the netlist that Yosys makes for Spartan-7 does what the integer model does, in every output and every
//! clock; what is counted in it; and a core placed and routed by a real router.

use shadegate_gen::package::{package, rtl, PackageFile};
use shadegate_gen::stimulus::{build, sample_triangles, StimulusOptions};
use shadegate_gen::vectors::Trace;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::Viewport;
use shadegate_testbench::engine::{run, Engine};
use shadegate_testbench::synthesis::{route, synthesise, Design, Family, Options, Router};
use std::process::Command;

const SIZE: (u32, u32) = (16, 16);

/// A core for a tiny frame, with a run of it.
fn small(order: Order) -> (Trace, Vec<PackageFile>, Design) {
    let (width, height) = SIZE;
    let viewport = Viewport { width, height };
    let core = Core::for_frame(order, width, height).expect("in range");
    let triangles = sample_triangles(order, viewport, 40, 5);
    let stimulus =
        build(&core, &triangles, viewport, &StimulusOptions::default()).expect("in range");
    let trace = Trace::record(core, &stimulus, |clock| clock % 7 != 3);
    let files = package(&rtl(&core).expect("emits"), &trace, SIZE, None)
        .expect("packs")
        .files;
    let rtl = files.iter().filter(|f| f.path.starts_with("rtl/"));
    let design = Design {
        top: format!("{}_core", core.module()),
        files: rtl.cloned().collect(),
    };
    (trace, files, design)
}

/// Yosys' models of the cells.
fn cell_models() -> String {
    let said = Command::new("yosys-config").arg("--datdir").output();
    let said = said.expect("yosys-config, which comes with yosys-dev, runs");
    let data = String::from_utf8(said.stdout).expect("a path");
    std::fs::read_to_string(format!("{}/xilinx/cells_sim.v", data.trim())).expect("cell models")
}

/// The package with a netlist in place of its Verilog.
fn with_netlist(files: &[PackageFile], netlist: &str) -> Vec<PackageFile> {
    let rest = files
        .iter()
        .filter(|f| !f.path.ends_with(".v") || f.path.starts_with("sim/"));
    // Yosys has no behaviour for block RAMs, so that cell is ours.
    let netlist = netlist.replace("  RAMB18E1 #(", "  block_ram_18 #(");
    let memory = include_str!("cells/block_ram_18.v");
    let rtl = [
        ("netlist", netlist),
        ("memory", memory.into()),
        ("cells", cell_models()),
    ];
    let rtl = rtl.map(|(name, text)| PackageFile {
        path: format!("rtl/{name}.v"),
        text,
    });
    rest.cloned().chain(rtl).collect()
}

#[test]
fn netlists_for_spartan_7_are_the_cores() {
    for (order, bram, dsp) in [
        (Order::Linear, 1, 0),
        (Order::Quadratic, 1, 0),
        (Order::QuadraticDots, 2, 7),
    ] {
        let (trace, files, design) = small(order);
        assert!(trace.pixels.len() > 200, "{} pixels", trace.pixels.len());
        let folder = tempfile::tempdir().expect("temporary directory");
        let options = Options {
            cache: true,
            output: Some(folder.path()),
        };
        let s = synthesise(&design, Family::Xc7, &options).unwrap_or_else(|e| panic!("{e}"));
        let r = &s.resources;
        // Every register of the description that is not a constant or a copy is a flip-flop; no adder is lost.
        assert!(r.lut > 800 && r.ff > 1_500 && r.carry > 80, "{r:?}");
        let counted = (r.bram, r.bram_kbit, r.dsp, r.lut_memory);
        assert_eq!(counted, (bram, 18 * bram, dsp, 0));
        let unknown: Vec<_> = r.other.keys().filter(|c| !c.starts_with("MUXF")).collect();
        assert!(unknown.is_empty(), "{unknown:?}");
        let depth = s.depth.expect("a path");
        let arrival = s.arrival_ps.expect("a path");
        // A cell takes between 0.05 and 3 ns.
        assert!(
            arrival > depth * 50 && arrival < depth * 3_000,
            "{arrival} ps, {depth} cells"
        );

        let netlist = std::fs::read_to_string(folder.path().join("xc7/netlist.v")).expect("kept");
        assert!(!netlist.contains("always"), "cells only");
        let simulate = |netlist: &str| {
            let scratch = tempfile::tempdir().expect("temporary directory");
            let files = with_netlist(&files, netlist);
            run(Engine::Icarus, &trace, &files, scratch.path(), None)
                .unwrap_or_else(|e| panic!("{e}"))
        };
        let same = simulate(&netlist);
        assert_eq!(same.mismatches, 0, "{:?}", same.first);
        assert_eq!(same.cycles, trace.clocks.len() as u64);
        // A netlist that carries wrongly is found.
        let broken = netlist.replacen(".CYINIT(1'h0)", ".CYINIT(1'h1)", 20);
        assert_ne!(broken, netlist);
        assert!(simulate(&broken).mismatches > 0);
    }
}

#[test]
fn a_core_is_placed_and_routed() {
    let (_, _, design) = small(Order::Linear);
    let folder = tempfile::tempdir().expect("temporary directory");
    let options = Options {
        cache: true,
        output: Some(folder.path()),
    };
    let (s, r) = route(&design, Router::Ice40, &options).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((s.family, s.resources.bram), (Family::Ice40, 1));
    assert_eq!(s.arrival_ps, None, "Yosys knows no delays of this family");
    assert_eq!(r.part, "iCE40HX8K-CT256");
    // Every logic cell holds at most one look-up table and one flip-flop.
    let (cells, of) = r.used["ICESTORM_LC"];
    assert!(cells >= s.resources.lut.max(s.resources.ff) && cells <= of && of == 7_680);
    assert!(
        r.fmax_mhz > 1.0 && r.fmax_mhz < 1_000.0,
        "{} MHz",
        r.fmax_mhz
    );
    let path = r.path.expect("a path from register to register");
    let period = 1_000.0 / r.fmax_mhz;
    assert!(path.cells_ns > 0.0 && (path.cells_ns + path.wires_ns - period).abs() < 0.01 * period);
    assert!(folder.path().join("ice40/routed.json").is_file());
}
