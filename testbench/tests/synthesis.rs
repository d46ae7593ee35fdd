//! A core placed and routed by a real router. What netlists do is in `netlists.rs`.

use shadegate_gen::package::{package, rtl, PackageFile};
use shadegate_gen::stimulus::{build, sample_triangles, StimulusOptions};
use shadegate_gen::vectors::Trace;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::Viewport;
use shadegate_testbench::synthesis::{route, Design, Family, Options, Router};

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

#[test]
fn a_core_is_placed_and_routed() {
    let (_, _, design) = small(Order::Linear);
    let folder = tempfile::tempdir().expect("temporary directory");
    let options = Options {
        cache: true,
        output: Some(folder.path()),
        wide_muxes: true,
    };
    let (s, r) = route(&design, Router::Ice40, &options).unwrap_or_else(|e| panic!("{e}"));
    // One for the depths, two for the 18 bits of their pages.
    assert_eq!((s.family, s.resources.bram), (Family::Ice40, 3));
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
