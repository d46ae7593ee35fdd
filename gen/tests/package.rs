//! What a package says of itself: the same bytes each time, sums that are right, a register map that the host uses,
//! resources that are the README's, and an example that draws.

mod common;

use common::{make, need, run, silent, Made};
use sha2::{Digest, Sha256};
use shadegate_gen::package::{registers, resources, Register};
use shadegate_gen::scene::{BY_SCENE, TEXTURED};
use shadegate_gen::stimulus::{build, sample_triangles, StimulusOptions};
use shadegate_gen::wrapper::Wrapper;
use shadegate_hdl::light::Glint;
use shadegate_hdl::line::Filter;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::shade::span_core::SpanKind;
use shadegate_reference::raster::Viewport;
use std::collections::{BTreeMap, BTreeSet};

const PLACES: [Option<&str>; 5] = [
    None,
    Some("arty-s7-50"),
    Some("xc6slx9"),
    Some("icebreaker"),
    Some("lfe5u-25f"),
];

fn made(order: Order, place: Option<&str>) -> Made {
    make(order, 16, 12, place, &Wrapper::ALL)
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    for place in PLACES {
        let once = made(Order::Quadratic, place).package.files;
        assert_eq!(
            once,
            made(Order::Quadratic, place).package.files,
            "{place:?}"
        );
    }
}

#[test]
fn the_manifest_lists_every_other_file_with_its_sum() {
    for place in PLACES {
        let made = made(Order::Linear, place);
        let m: serde_json::Value = serde_json::from_str(made.text("manifest.json")).expect("JSON");
        let files: Vec<&str> = m["files"]
            .as_array()
            .unwrap()
            .iter()
            .filter_map(|f| f.as_str())
            .collect();
        let unique: BTreeSet<&str> = files.iter().copied().collect();
        assert_eq!(unique.len(), files.len());
        assert_eq!(files.len() + 1, made.package.files.len());
        assert_eq!(m["sha256"].as_object().unwrap().len(), files.len());
        for path in files {
            let hash = Sha256::digest(made.text(path).as_bytes());
            let digits: String = hash.iter().map(|b| format!("{b:02x}")).collect();
            assert_eq!(m["sha256"][path], digits, "{path}");
        }
        for key in ["registers", "resources", "wrappers", "ports", "formats"] {
            assert!(!m[key].is_null(), "{key}");
        }
    }
    let plain = make(Order::Linear, 16, 12, None, &[]);
    assert!(plain.package.manifest.wrappers.is_none());
    assert!(plain.paths("wrappers/", "").is_empty());
    assert_eq!(plain.paths("sim/tb_", ".v"), ["sim/tb_gouraud_core.v"]);
}

#[test]
fn constraints_and_scripts_are_those_of_the_device() {
    for (place, constraints, scripts) in [
        (None, None, vec!["build/yosys.ys"]),
        (
            Some("arty-s7-50"),
            Some("constraints/gouraud_core.xdc"),
            vec!["build/yosys.ys", "build/vivado.tcl"],
        ),
        (
            Some("xc6slx9"),
            Some("constraints/gouraud_core.ucf"),
            vec!["build/yosys.ys", "build/ise.tcl", "build/gouraud_core.xise"],
        ),
        (
            Some("icebreaker"),
            Some("constraints/gouraud_core.pcf"),
            vec!["build/yosys.ys"],
        ),
        (
            Some("lfe5u-25f"),
            Some("constraints/gouraud_core.lpf"),
            vec!["build/yosys.ys"],
        ),
    ] {
        let made = made(Order::Linear, place);
        assert_eq!(made.paths("constraints/", "").first().copied(), constraints);
        assert_eq!(made.paths("build/", ""), scripts, "{place:?}");
    }
}

#[test]
fn emitted_verilog_is_ascii_and_the_readme_holds_the_example() {
    for order in [Order::Linear, Order::Quadratic, Order::QuadraticDots] {
        let made = made(order, Some("arty-s7-50"));
        for f in made.package.files.iter().filter(|f| f.path.ends_with(".v")) {
            assert!(f.text.is_ascii(), "{}", f.path);
        }
        let readme = made.text("README.md");
        let example = made.text(made.paths("example/", ".v")[0]);
        assert!(readme.contains(&format!("```verilog\n{example}```\n")));
        for port in &made.package.manifest.ports {
            assert!(
                readme.contains(&format!("| `{}` | ", port.name)),
                "{}",
                port.name
            );
        }
        assert!(readme.contains("not run by us"), "what was not run is said");
        for path in ["doc/timing.svg", "doc/timing.json"] {
            assert!(readme.contains(path) && made.paths("doc/", "").contains(&path));
        }
    }
}

/// With nothing left out, a host writes every register of the map that is written once per triangle, and no other; and
/// every datum fits the bits that the map gives.
#[test]
fn the_register_map_is_what_a_host_writes() {
    for (order, width, height) in [
        (Order::Linear, 320, 240),
        (Order::Quadratic, 320, 240),
        (Order::Quadratic, 1024, 768),
        (Order::Linear, 1024, 768),
        (Order::QuadraticDots, 320, 240),
        (Order::Duff, 320, 240),
        (Order::Glint(Glint::Kappa), 320, 240),
        (Order::Glint(Glint::Spot), 320, 240),
        (Order::QuadraticEngine, 320, 240),
        (Order::QuadraticEngine, 1024, 768),
    ] {
        let core = Core::for_frame(order, width, height).expect("in range");
        let viewport = Viewport { width, height };
        let options = StimulusOptions {
            skip_unchanged: false,
            broadcast: false,
            ..StimulusOptions::default()
        };
        let triangles = sample_triangles(order, viewport, 200, 3);
        let stimulus = build(&core, &triangles, viewport, &options).expect("in range");
        let mut written: BTreeMap<(u8, &str), u64> = BTreeMap::new();
        for (select, data) in &stimulus.frame {
            *written.entry((*select, "frame")).or_default() |= data;
        }
        for (select, data) in stimulus.primitives.iter().flat_map(|p| &p.writes) {
            *written.entry((*select, "triangle")).or_default() |= data;
        }
        let map = registers(&core);
        // Materials come with the triangles that have them.
        let per = |r: &Register| match r.per {
            "material" => "triangle",
            per => per,
        };
        let known: BTreeSet<(u8, &str)> = map.iter().map(|r| (r.select, per(r))).collect();
        assert_eq!(known.len(), map.len(), "a register twice");
        assert_eq!(
            known,
            written.keys().copied().collect::<BTreeSet<_>>(),
            "{order:?} {width}"
        );
        for r in &map {
            let bits = written[&(r.select, per(r))];
            assert!(bits >> r.bits == 0, "{} {}: {bits:x}", r.target, r.name);
            assert!(r.bits <= core.bus_bits());
            let mut above = r.bits;
            for f in &r.fields {
                assert!(f.high < above && f.low <= f.high, "{}", r.name);
                above = f.low;
            }
        }
    }
}

/// The same for textured cores, whose pictures are sent before the first triangle or with one.
#[test]
fn the_register_map_of_textured_cores() {
    let viewport = Viewport {
        width: 320,
        height: 240,
    };
    let options = StimulusOptions {
        skip_unchanged: false,
        broadcast: false,
        ..Default::default()
    };
    let bumps = BY_SCENE.iter().filter(|c| matches!(c.1, Order::Bump(_)));
    let bumps = bumps.map(|c| (c.0, c.1));
    for (name, order) in TEXTURED.into_iter().chain(bumps) {
        let core = Core::for_frame(order, 320, 240).expect("in range");
        let triangles = sample_triangles(order, viewport, 40, 3);
        let stimulus = build(&core, &triangles, viewport, &options).expect("in range");
        let triangles = stimulus.primitives.iter().flat_map(|p| &p.writes);
        let mut written: BTreeMap<u8, u64> = BTreeMap::new();
        for (select, data) in stimulus.frame.iter().chain(triangles) {
            *written.entry(*select).or_default() |= data;
        }
        let map = registers(&core);
        let known: BTreeSet<u8> = map.iter().map(|r| r.select).collect();
        assert_eq!(known.len(), map.len(), "{name}: a register twice");
        assert_eq!(known, written.keys().copied().collect(), "{name}");
        for r in &map {
            let bits = written[&r.select];
            assert!(bits >> r.bits == 0, "{} {}: {bits:x}", r.target, r.name);
            assert!(r.bits <= core.bus_bits());
        }
    }
}

/// `resources` is data in one place; the README's table is the other place where these figures stand.
#[test]
fn resources_are_those_of_the_readme() {
    let readme = concat!(env!("CARGO_MANIFEST_DIR"), "/../README.md");
    let readme = std::fs::read_to_string(readme).expect("README.md");
    for (order, bits) in [
        (Order::Linear, 16),
        (Order::Quadratic, 16),
        (Order::QuadraticDots, 16),
        (Order::Duff, 16),
        (Order::Span(SpanKind::Slerp), 16),
        (Order::Span(SpanKind::Blake), 16),
        (Order::Line(Filter::Bresenham), 0),
        (Order::Line(Filter::Box), 24),
        (Order::Line(Filter::Cone), 24),
    ] {
        let core = Core::for_frame(order, 320, 240).expect("in range");
        let all = resources(&core, (320, 240), None);
        // Depths have flags and a generation for every eight pixels beside them.
        let pages = if bits == 16 { 320 * 240 / 8 * 18 } else { 0 };
        assert_eq!(all.depth_memory_bits, 320 * 240 * bits + pages);
        let measured = all.measured.expect("measured");
        for m in &measured {
            let family = m.family.replace("spartan", "Spartan");
            let start = format!("| {} core, 320x240 | {family} |", core.name());
            let line = readme
                .lines()
                .find(|l| l.starts_with(&start))
                .expect("a row");
            let cells: Vec<&str> = line.split('|').map(str::trim).collect();
            let number = |i: usize| {
                cells[i]
                    .split(' ')
                    .next()
                    .and_then(|n| n.parse::<u32>().ok())
            };
            assert_eq!(
                (number(3), number(4), number(6)),
                (Some(m.lut), Some(m.ff), Some(m.bram)),
                "{line}"
            );
        }
        let tool = all.tool.split(',').next().expect("a name");
        assert!(readme.contains(&format!("Cells by {tool}")), "{tool}");
        let device = |name| shadegate_constraints::device(name).expect("known");
        let one = resources(&core, (320, 240), Some(device("xc6slx16")))
            .measured
            .expect("measured");
        assert_eq!(
            one.iter().map(|m| m.family).collect::<Vec<_>>(),
            ["spartan-6"]
        );
        // Neither measured: another frame, another family.
        let small = Core::for_frame(order, 240, 320).expect("in range");
        assert_eq!(resources(&small, (240, 320), None).measured, None);
        assert_eq!(
            resources(&core, (320, 240), Some(device("ice40up5k"))).measured,
            None
        );
    }
}

/// The example's own test bench: draws twice, prints what is written to the frame buffer.
const BENCH: &str = "
module bench;
  reg clock = 1'b0;
  reg go = 1'b0;
  wire idle, done, write;
  wire [20:0] address;
  wire [23:0] colour;
  wire [15:0] depth;
  integer runs = 0;
  TOP_example example (.clock(clock), .go(go), .idle(idle), .done(done), .frame_write(write), .frame_address(address),
    .frame_colour(colour), .frame_depth(depth));
  always #5 clock = !clock;
  always @(posedge clock) begin
    if (write) $display(\"%0d %0d\", runs, address);
    if (done && runs == 1) $finish;
    if (done) runs = runs + 1;
    #1 go = idle;
  end
endmodule
";

#[test]
fn the_example_draws_its_triangle_each_time() {
    need("iverilog");
    for (order, width, height) in [
        (Order::Linear, 16, 12),
        (Order::Quadratic, 20, 600),
        (Order::Quadratic, 2, 1),
        (Order::QuadraticDots, 20, 15),
        (TEXTURED[2].1, 20, 15),
    ] {
        let made = make(order, width, height, None, &[]);
        let directory = made.unpacked();
        let bench = BENCH.replace("TOP", &made.package.manifest.top);
        std::fs::write(directory.path().join("bench.v"), bench).expect("writable");
        let files = [
            made.paths("rtl/", ".v"),
            made.paths("example/", ".v"),
            vec!["bench.v"],
        ]
        .concat();
        silent(
            directory.path(),
            "iverilog",
            &[&["-g2001", "-o", "bench"], &files[..]].concat(),
        );
        let (done, said) = run(directory.path(), "vvp", &["-N", "bench"]);
        assert!(done, "{said}");
        // Centres strictly inside the hypotenuse of the triangle over the upper left half.
        let (w, h) = (u64::from(width), u64::from(height));
        let mut want = vec![];
        for turn in [0, 1] {
            for y in 0..h {
                let row = (0..w).filter(|x| (2 * x + 1) * h + (2 * y + 1) * w < 2 * w * h);
                want.extend(row.map(|x| format!("{turn} {}", y * w + x)));
            }
        }
        let drawn: Vec<&str> = said.lines().filter(|l| l.starts_with(['0', '1'])).collect();
        assert_eq!(drawn, want, "{order:?} {width}x{height}");
    }
}
