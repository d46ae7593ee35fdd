//! Every emitted file, of both cores in both formats, is taken without a remark by Verilator's and Icarus' strictest
//! settings, and by Yosys for the families of Spartan-3, -6, -7, iCE40 and ECP5.

mod common;

use common::{make, need, run, silent};
use shadegate_gen::wrapper::Wrapper;
use shadegate_hdl::shade::model::Order;

#[test]
fn lint() {
    need("verilator");
    need("iverilog");
    for order in [Order::Linear, Order::Quadratic] {
        for (width, height) in [(320, 240), (16, 12), (1024, 768)] {
            let made = make(order, width, height, None, &Wrapper::ALL);
            let directory = made.unpacked();
            let top = made.package.manifest.top.clone();
            let rtl = made.paths("rtl/", ".v");
            let wrappers = made.paths("wrappers/", ".v");
            let parts = [&wrappers[..2], &wrappers[2..3]].concat();
            assert!(parts
                .iter()
                .zip(["_host.v", "_frames.v", "_axi.v"])
                .all(|(p, e)| p.ends_with(e)));
            let wishbone = [&wrappers[..2], &wrappers[3..]].concat();
            let example = made.paths("example/", ".v");
            for (module, more) in [
                (top.clone(), vec![]),
                (format!("{top}_example"), example),
                (format!("{top}_axi"), parts),
                (format!("{top}_wishbone"), wishbone),
            ] {
                let files = [&rtl[..], &more].concat();
                let verilator = [
                    &["--lint-only", "-Wall", "--top-module", &module],
                    &files[..],
                ];
                silent(directory.path(), "verilator", &verilator.concat());
                let iverilog = [
                    &["-g2001", "-Wall", "-s", &module, "-o", "lint"],
                    &files[..],
                ];
                silent(directory.path(), "iverilog", &iverilog.concat());
            }
            // A bench comes last: its timescale is not the design's.
            for (bench, more) in [
                (format!("sim/tb_{top}.v"), vec![]),
                (format!("sim/tb_{top}_axi.v"), wrappers.clone()),
                (format!("sim/tb_{top}_wishbone.v"), wrappers.clone()),
            ] {
                let flags = ["-g2001", "-Wall", "-o", "lint"];
                let all = [&flags, &rtl[..], &more, &[bench.as_str()]].concat();
                silent(directory.path(), "iverilog", &all);
            }
        }
    }
}

#[test]
fn yosys_takes_every_file_for_every_family() {
    need("yosys");
    let spartan = ["xc3s200", "xc6slx9", "xc7s50"];
    let lattice = ["ice40up5k", "lfe5u-25f"];
    // Lattice's families are shown the smaller core alone: what differs is the memory, which both have.
    for (order, places) in [
        (Order::Quadratic, &spartan[..]),
        (Order::Linear, &[&spartan[..], &lattice[..]].concat()),
    ] {
        for place in places.iter().copied() {
            let made = make(order, 16, 12, Some(place), &[]);
            let directory = made.unpacked();
            let (done, said) = run(directory.path(), "make", &["yosys"]);
            assert!(done && !said.contains("ERROR"), "{place}: {said}");
            let cells = std::fs::read_to_string(directory.path().join("out/yosys.txt")).unwrap();
            let flip_flop = match place {
                "ice40up5k" => "SB_DFF",
                "lfe5u-25f" => "TRELLIS_FF",
                _ => "FD",
            };
            assert!(cells.contains(flip_flop), "{place}: {cells}");
            let netlist = format!("out/{}.json", made.package.manifest.top);
            assert!(directory.path().join(netlist).is_file(), "{place}");
        }
    }
}

/// What the package's own script counts is what its manifest says was measured.
#[test]
fn measured_resources_can_be_measured_again() {
    need("yosys");
    let made = make(Order::Linear, 320, 240, Some("xc7s50"), &[]);
    let directory = made.unpacked();
    let (done, said) = run(directory.path(), "make", &["yosys"]);
    assert!(done, "{said}");
    let cells = std::fs::read_to_string(directory.path().join("out/yosys.txt")).expect("counted");
    let sum = |kinds: &[&str]| -> u32 {
        let pairs = cells.lines().filter_map(|l| l.trim().split_once(' '));
        pairs
            .filter(|(name, _)| kinds.iter().any(|k| name.starts_with(k)))
            .filter_map(|(_, count)| count.trim().parse::<u32>().ok())
            .sum()
    };
    let measured = made
        .package
        .manifest
        .resources
        .measured
        .as_ref()
        .expect("measured");
    let [m] = &measured[..] else {
        panic!("{measured:?}")
    };
    assert_eq!(sum(&["LUT", "INV"]), m.lut, "{cells}");
    assert_eq!(sum(&["FD"]), m.ff, "{cells}");
    assert_eq!(sum(&["RAMB"]), m.bram, "{cells}");
    assert_eq!(sum(&["DSP", "MULT"]), m.dsp, "{cells}");
}
