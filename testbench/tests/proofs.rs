//! Proofs: small instances of the units whose state fits a prover equal modules that were written by hand from what the
//! units promise (`golden/*.v`), for every input in every clock, for ever.
//!
//! Yosys proves it by induction over the clock: both modules side by side with the same inputs, all registers zero at
//! first; if outputs and the listed *invariants* hold in one clock, they hold in the next. An invariant says what a
//! register of the unit stands for in terms of the golden module (`total` is f(k)); it is proved along with the outputs, so
//! a wrong one can only make a proof fail. The golden interpolants do not accumulate: they count steps and evaluate
//! Newton's formula. A golden module with one mistake is refused, which is tested as well.
//!
//! The z-buffer's pages need too many invariants for that; it is proved for every input up to a number of clocks from
//! power-up, and from the clock in which its generations come round.

use rust_hdl_core::prelude::*;
use shadegate_gen::netlist::{collect, elaborate, SignalKind};
use shadegate_gen::verilog::emit;
use shadegate_hdl::depth::z_buffer::ZBuffer;
use shadegate_hdl::interpolate::constant_1::Constant1;
use shadegate_hdl::interpolate::constant_2::Constant2;
use shadegate_hdl::interpolate::cubic_1::Cubic1;
use shadegate_hdl::interpolate::linear_1::Linear1;
use shadegate_hdl::interpolate::linear_2::Linear2;
use shadegate_hdl::interpolate::quadratic_1::Quadratic1;
use shadegate_hdl::interpolate::quadratic_2::Quadratic2;
use shadegate_hdl::line::walk::LineWalk;
use shadegate_hdl::raster::edge_walk::EdgeWalk;
use std::path::Path;
use std::process::Command;

/// Words of three bits, one of them behind the point.
const ALONG: &str = include_str!("golden/along_a_span.v");
const OVER: &str = include_str!("golden/over_a_triangle.v");
const EDGE: &str = include_str!("golden/edge_walk.v");
const LINE: &str = include_str!("golden/line_walk.v");

const DEPTH: &str = include_str!("golden/z_buffer.v");

/// A unit beside its golden module.
struct Pair<'a> {
    /// Verilog of the golden module.
    golden: &'a str,
    /// Wires of the unit to compare with wires of the golden module, beside the outputs.
    invariants: &'a [(&'a str, &'a str)],
}

/// Whether Yosys proves the unit equal to the golden module; `Err` is what it said if not.
fn proved<B: Block>(mut design: B, pair: &Pair) -> Result<(), String> {
    design.connect_all();
    let netlist = collect(&design).map_err(|e| e.to_string())?;
    elaborate(&netlist).map_err(|e| e.to_string())?;
    let files = emit(&netlist, "a proof").map_err(|e| e.to_string())?;
    let folder = tempfile::tempdir().expect("temporary directory");
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text);
    for f in &files {
        write(&f.file_name(), &f.text).expect("writable");
    }
    let top = files.last().expect("a module").file_name();
    let top = top.trim_end_matches(".v");
    let name = top.split("_q").next().unwrap_or(top);

    // Both with the same inputs; outputs come out.
    let mut pins = String::new();
    let (mut ports, mut gate, mut gold, mut prove) = (vec![], vec![], vec![], String::new());
    for s in &netlist.signals {
        let width = s.format.width();
        let n = s.name.as_str();
        match s.kind {
            SignalKind::Input => {
                ports.push(format!("input wire [{}:0] {n}", width - 1));
                gate.push(format!(".{n}({n})"));
                gold.push(format!(".{n}({n})"));
            }
            SignalKind::Output => {
                for (side, list) in [("unit", &mut gate), ("golden", &mut gold)] {
                    pins += &format!("  wire [{}:0] {side}_{n};\n", width - 1);
                    list.push(format!(".{n}({side}_{n})"));
                }
                prove += &format!(" -prove unit_{n} golden_{n}");
            }
            _ => {}
        }
    }
    for (unit, golden) in pair.invariants {
        let of = |side: &str, wire: &str| match wire.starts_with(|c: char| c.is_ascii_digit()) {
            true => wire.to_string(),
            false => format!("{side}.{wire}"),
        };
        prove += &format!(" -prove {} {}", of("unit", unit), of("golden", golden));
    }
    let both = format!(
        "module pair ({});\n{pins}  {top} unit ({});\n  golden_{name} golden ({});\nendmodule\n",
        ports.join(", "),
        gate.join(", "),
        gold.join(", ")
    );
    write("golden.v", pair.golden).expect("writable");
    write("pair.v", &both).expect("writable");
    let mut script = String::new();
    for f in &files {
        script += &format!("read_verilog {}\n", f.file_name());
    }
    script += &format!(
        "read_verilog golden.v\nread_verilog pair.v\nhierarchy -check -top pair\nproc\nsetattr -set keep 1 w:*\nmemory -nordff\nflatten\n\
         sat -verify -tempinduct -maxsteps 3 -set-init-zero{prove} pair\n"
    );
    yosys(folder.path(), &script).map_err(|said| format!("{name}: {said}\n{both}{script}"))
}

/// Runs a script of Yosys on the files of a folder; `Err` is what it said if it failed.
fn yosys(folder: &Path, script: &str) -> Result<(), String> {
    std::fs::write(folder.join("prove.ys"), script).expect("writable");
    let run = Command::new("yosys")
        .current_dir(folder)
        .args(["-q", "prove.ys"])
        .output()
        .expect("yosys runs");
    match run.status.success() {
        true => Ok(()),
        false => Err(String::from_utf8_lossy(&run.stdout).into_owned()
            + &String::from_utf8_lossy(&run.stderr)),
    }
}

/// Proves a pair, and sees that it is refused when `right` in the golden module is replaced by `wrong`.
fn holds<B: Block>(design: impl Fn() -> B, pair: Pair, mistakes: &[(&str, &str)]) {
    if let Err(said) = proved(design(), &pair) {
        panic!("{said}");
    }
    for (right, wrong) in mistakes {
        let golden = pair.golden.replacen(right, wrong, 1);
        assert_ne!(golden, pair.golden, "{right}");
        let mistaken = Pair {
            golden: &golden,
            ..pair
        };
        let said = proved(design(), &mistaken).expect_err(wrong);
        assert!(said.contains("proof"), "{said}");
    }
}

/// A pair with invariants only.
fn pair<'a>(golden: &'a str, invariants: &'a [(&'a str, &'a str)]) -> Pair<'a> {
    Pair { golden, invariants }
}

#[test]
fn interpolants_along_a_span() {
    let none = "3'd0";
    let constant = [("held", "p.f"), ("held", "p.c0")];
    holds(Constant1::<1, 1>::default, pair(ALONG, &constant), &[]);
    let linear = [
        ("total", "p.f"),
        ("first", "p.df"),
        (none, "p.dd0"),
        (none, "p.ddd0"),
    ];
    holds(Linear1::<1, 1>::default, pair(ALONG, &linear), &[]);
    let quadratic = [
        ("total", "p.f"),
        ("first", "p.df"),
        ("second", "p.ddf"),
        (none, "p.ddd0"),
    ];
    let forgets = [("k * (k - ONE)", "k * (k + ONE)")];
    holds(
        Quadratic1::<1, 1>::default,
        pair(ALONG, &quadratic),
        &forgets,
    );
    let cubic = [
        ("total", "p.f"),
        ("first", "p.df"),
        ("second", "p.ddf"),
        ("third", "p.ddd0"),
    ];
    let forgets = [("* THIRD", "")];
    holds(Cubic1::<1, 1>::default, pair(ALONG, &cubic), &forgets);
}

/// Words of a plane that are zero.
const FLAT: [(&str, &str); 7] = [
    ("3'd0", "p.pp0"),
    ("3'd0", "p.pp"),
    ("3'd0", "p.ps"),
    ("3'd0", "p.pt"),
    ("3'd0", "p.ss"),
    ("3'd0", "p.st"),
    ("3'd0", "p.tt"),
];

/// Words that are never written.
const UNHEARD: [(&str, &str); 9] = [
    ("3'd0", "p.w9"),
    ("3'd0", "p.w8"),
    ("3'd0", "p.w7"),
    ("3'd0", "p.w6"),
    ("3'd0", "p.w5"),
    ("3'd0", "p.w4"),
    ("3'd0", "p.w3"),
    ("3'd0", "p.w2"),
    ("3'd0", "p.w1"),
];

#[test]
fn constants_and_planes_over_a_triangle() {
    let mut constant = vec![
        ("word_value", "p.w0"),
        ("line_value", "p.f"),
        ("span.held", "p.f0"),
        ("3'd0", "p.p"),
        ("3'd0", "p.p0"),
        ("3'd0", "p.s"),
        ("3'd0", "p.t"),
    ];
    constant.extend(FLAT);
    constant.extend(UNHEARD);
    holds(Constant2::<3, 1, 1>::default, pair(OVER, &constant), &[]);
    let mut plane = vec![
        ("word_value", "p.w0"),
        ("word_d_pixel", "p.w1"),
        ("word_d_line", "p.w2"),
        ("word_d_line_carry", "p.w3"),
        ("value_line", "p.at_line"),
        ("d_pixel", "p.p"),
        ("d_line", "p.s"),
        ("d_line_carry", "p.t"),
        ("span.total", "p.at_pixel"),
        ("span.first", "p.p0"),
    ];
    plane.extend(FLAT);
    plane.extend(&UNHEARD[..6]);
    let forgets = [("m <= m + (step && carry)", "m <= m + step")];
    holds(Linear2::<3, 1, 1>::default, pair(OVER, &plane), &forgets);
}

#[test]
fn quadrics_over_a_triangle() {
    let quadric = [
        ("word_value", "p.w0"),
        ("word_d_pixel", "p.w1"),
        ("word_d_line", "p.w2"),
        ("word_d_line_carry", "p.w3"),
        ("word_dd_pixel", "p.w4"),
        ("word_dd_pixel_line", "p.w5"),
        ("word_dd_pixel_carry", "p.w6"),
        ("word_dd_line", "p.w7"),
        ("word_dd_line_carry", "p.w8"),
        ("word_dd_carry", "p.w9"),
        ("value_line", "p.at_line"),
        ("d_pixel", "p.along_line"),
        ("d_line", "p.along_s"),
        ("d_line_carry", "p.along_t"),
        ("dd_pixel", "p.pp"),
        ("dd_pixel_line", "p.ps"),
        ("dd_pixel_carry", "p.pt"),
        ("dd_line", "p.ss"),
        ("dd_line_carry", "p.st"),
        ("dd_carry", "p.tt"),
        ("span.total", "p.at_pixel"),
        ("span.first", "p.along_pixel"),
        ("span.second", "p.pp0"),
    ];
    // The cross term that equation 2.10 of Abbas (2003) forgets.
    let forgets = [("n * m * st", "n * st")];
    // Words of two bits: the prover's work grows fast with the products of steps.
    let golden = OVER.replace("W = 3, parameter N = 1", "W = 2, parameter N = 0");
    assert_ne!(golden, OVER);
    let design = Quadratic2::<2, 1, 0>::default;
    holds(design, pair(&golden, &quadric), &forgets);
}

#[test]
fn walk_along_an_edge() {
    let invariants = [
        ("position", "at_12"),
        ("error", "e_20"),
        ("slope", "slope_12"),
        ("error_up", "more_20"),
        ("error_down", "less_20"),
    ];
    let forgets = [("$signed(e_20) >= 0", "$signed(e_20) > 0")];
    holds(EdgeWalk::default, pair(EDGE, &invariants), &forgets);
}

#[test]
fn walk_along_a_line() {
    let invariants = [
        ("word_columns", "w0[10:0]"),
        ("word_steep", "w0[11]"),
        ("word_falling", "w0[12]"),
        ("word_lanes", "w0[14:13]"),
        ("word_major", "w1[11:0]"),
        ("word_minor", "w1[23:12]"),
        ("word_address", "w2"),
        ("word_error", "w3"),
        ("word_stay", "w4"),
        ("word_step", "w5"),
        ("columns_left", "left"),
        ("error", "e"),
        ("error_stay", "stay"),
        ("error_step", "move"),
    ];
    let forgets = [("e > 0", "e >= 0")];
    holds(LineWalk::<3>::default, pair(LINE, &invariants), &forgets);
}

/// What is replaced in which file.
type Mistake = (&'static str, &'static str, &'static str);

/// Whether Yosys proves the z-buffer of 16 words equal to the golden one for all inputs in so many clocks, from registers
/// that are all zero but for these.
fn depth_test_holds(clocks: usize, first: &str, mistake: Option<Mistake>) -> Result<(), String> {
    let mut design = ZBuffer::<4>::new(16);
    design.connect_all();
    let netlist = collect(&design).map_err(|e| e.to_string())?;
    let files = emit(&netlist, "a proof").map_err(|e| e.to_string())?;
    let mut texts: Vec<(String, String)> = files
        .into_iter()
        .map(|f| (f.file_name(), f.text))
        .chain([("golden.v".to_owned(), DEPTH.to_owned())])
        .collect();
    if let Some((file, right, wrong)) = mistake {
        let text = texts.iter_mut().find(|t| t.0 == file).expect(file);
        let changed = text.1.replacen(right, wrong, 1);
        assert_ne!(changed, text.1, "{file}: {right}");
        text.1 = changed;
    }
    let folder = tempfile::tempdir().expect("temporary directory");
    let mut script = String::new();
    for (name, text) in &texts {
        std::fs::write(folder.path().join(name), text).expect("writable");
        script += &format!("read_verilog -DSYNTHESIS {name}\n");
    }
    script += &format!(
        "hierarchy -check -top pair\nproc\nsetattr -set keep 1 w:*\nmemory -nordff\nflatten\nopt -keepdc\n\
         sat -verify -tempinduct -tempinduct-baseonly -maxsteps {clocks} -set-init-zero {first} \
         -prove unit_pass golden_pass -prove unit_waiting golden_waiting -prove unit_depth golden_depth pair\n"
    );
    yosys(folder.path(), &script)
}

/// Twelve clocks hold two clears and drawing before, between and after them.
#[test]
fn depths_up_to_twelve_clocks() {
    if let Err(said) = depth_test_holds(12, "", None) {
        panic!("{said}");
    }
    // The generation is the last one, and comes round with the first clear.
    let last = "-set-init unit.pages.generation 10'd1023 -set-init unit.pages.known 1'b1";
    if let Err(said) = depth_test_holds(9, last, None) {
        panic!("{said}");
    }
}

/// Each part of the unit is needed within these clocks: without it a proof fails.
#[test]
fn a_depth_test_with_a_mistake_is_refused() {
    let mistakes: [Mistake; 6] = [
        ("golden.v", "mine2 > there", "mine2 >= there"),
        ("golden.v", "if (clear) {d0", "if (0) {d0"),
        ("z_buffer.v", "if (forward) begin", "if (1'b0) begin"),
        (
            "z_buffer.v",
            "if (same && visible) begin",
            "if (1'b0) begin",
        ),
        ("frame_pages.v", "if (forward) begin", "if (1'b0) begin"),
        (
            "frame_pages.v",
            "if (word_generation == generation) begin",
            "if (1'b1) begin",
        ),
    ];
    for mistake in mistakes {
        let said = depth_test_holds(12, "", Some(mistake)).expect_err(mistake.2);
        assert!(said.contains("proof"), "{said}");
    }
}
