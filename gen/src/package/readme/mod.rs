//! The package's `README.md`, printed from the manifest so that the two cannot differ.

mod tables;

use super::build::nextpnr_options;
use super::line;
use super::{Manifest, Target};
use shadegate_constraints::Format;
use shadegate_hdl::bump::Bend;
use shadegate_hdl::depth::pages::{pages, renewals, PAGE};
use shadegate_hdl::light::Glint;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::texture::Mapping;

/// Text of `README.md`. `example` is the text of the example's file.
pub fn readme(m: &Manifest, core: &Core, target: Option<Target>, example: &str) -> String {
    let top = &m.top;
    let (columns, rows) = m.frame;
    let colour = match core.order {
        Order::Linear => "a plane through three vertex colours",
        Order::Quadratic => "a quadric through six colours, at vertices and mid-edges",
        Order::QuadraticEngine => {
            "a quadric through six colours, at vertices and mid-edges, which it sets up itself"
        }
        Order::Duff => {
            "planes of N·L and N·H, a root for the length of the normal, and the light that the material reflects per pixel"
        }
        Order::QuadraticDots => {
            "quadrics of N·L and N·H through six knots, and the light that the material reflects per pixel"
        }
        Order::Textured(t) => match t.mapping {
            Mapping::Affine => {
                "a quadric through six colours times a texture whose addresses are linear on the screen"
            }
            Mapping::Quadratic => {
                "a quadric through six colours times a texture whose addresses are quadratic on the screen"
            }
            Mapping::Perspective => {
                "a quadric through six colours times a texture in true perspective"
            }
        },
        Order::Bump(Bend::Newton) => {
            "normals that a map of gradients bends and a Newton step brings near unit length, quadrics of light and half-way vector, and the light that the material reflects per pixel"
        }
        Order::Bump(Bend::Reflection) => {
            "normals that a map of gradients bends and a reflection keeps at unit length, quadrics of light and half-way vector, and the light that the material reflects per pixel"
        }
        Order::Glint(Glint::Kappa) => {
            "quadrics of N·L and N·H through six knots, and the light that the material reflects per pixel, its highlight κ(N·H − γ)^d"
        }
        Order::Glint(Glint::Spot) => {
            "quadrics of N·L, N·H and the cosine from the axis of a spot through six knots, and the light that the material reflects per pixel, its highlight κ(N·H − γ)^d"
        }
        Order::Line(_) => "lines",
        Order::Span(kind) => super::span_registers::about(kind),
    };
    let (what, walks) = match core.order {
        Order::Span(_) => ("span", "walks the span"),
        _ => ("triangle", "walks the triangle row by row"),
    };
    let place = match (&m.target, &m.board) {
        (Some(part), Some(board)) => {
            format!(" Its constraints and scripts are for {part} on the board {board}.")
        }
        (Some(part), None) => format!(" Its constraints and scripts are for {part}."),
        _ => String::new(),
    };
    let about = match core.order {
        Order::Line(filter) => line::about(filter, m.frame),
        _ => format!(
            "A {what} shading core in Verilog, for frames of {columns}x{rows} pixels. A host writes the words of a \
             {what} into registers and says `start`; the core {walks}, one pixel per clock, \
             with {colour}, tests each pixel against its depth memory and hands over those that are visible."
        ),
    };
    let noun = line::noun(core);
    let sections = [
        format!(
            "# {top}\n\n\
             {about}{place}\n\n\
             {}, configuration {}. Everything here is made by the generator; change it there.\n",
            m.generator, m.configuration
        ),
        tables::contents(m),
        tables::ports(m),
        match core.order {
            Order::Line(_) => tables::line_registers(m),
            Order::QuadraticEngine => tables::engine_registers(m),
            _ => tables::registers(m),
        },
        tables::wrappers(m),
        timing(m, noun),
        formats(m),
        simulation(m),
        synthesis(m, target),
        tables::resources(m),
        format!(
            "## Example\n\n`example/{top}_example.v` draws one {noun} into the write port of a frame buffer:\n\n\
             ```verilog\n{example}```\n"
        ),
        "## Licence\n\nMIT or Apache 2.0, at your choice: SPDX-License-Identifier: MIT OR Apache-2.0.\n".to_owned(),
    ];
    let filled: Vec<String> = sections.into_iter().filter(|s| !s.is_empty()).collect();
    filled.join("\n")
}

fn timing(m: &Manifest, noun: &str) -> String {
    let gap = match noun {
        "line" => "without a gap between columns, or between lines whose words came in time; a line that begins on one of the last two pixels of the one before waits for it",
        _ => "without a gap between spans, or between triangles whose words came in time",
    };
    let pixels = u64::from(m.frame.0) * u64::from(m.frame.1);
    let resets = m.ports.iter().any(|p| p.name == crate::netlist::RESET);
    let clear = match (noun, m.block_ram.needed_kbit > 0.0) {
        ("line", false) => "`clear` is answered at once: there is no memory.".to_owned(),
        ("line", true) => format!("`clear` takes {pixels} clocks, one per pixel of the frame."),
        _ => format!(
            "`clear` takes no time: triangles may follow at once. The first one after power-up{} takes {} clocks, one for \
             every {PAGE} pixels of the frame; later ones wait only if the core had fewer than {} clocks without a pixel since the one before.",
            if resets { " or reset" } else { "" },
            pages(pixels as usize),
            renewals(pixels as usize),
        ),
    };
    format!(
        "## Timing\n\n\
         ![The end of a {noun}'s words, its pixels, a consumer that pauses, done](doc/timing.svg)\n\n\
         Every column is the clock before a rising edge: inputs as that edge sees them, outputs as they stand before \
         it. The levels were recorded from the integer model of this core drawing a small {noun}; \
         `doc/timing.json` holds the same for WaveDrom.\n\n\
         - Latency: {} clocks from the edge that takes `start` to the edge that can take the first pixel, in an idle core.\n\
         - Throughput: one pixel per clock, {gap}.\n\
         - {clear}\n",
        m.latency
    )
}

fn formats(m: &Manifest) -> String {
    let rows: String = m
        .formats
        .iter()
        .map(|(name, f)| {
            format!(
                "| {} | Q{}.{} | {} |\n",
                name.replace('_', " "),
                f.int,
                f.frac,
                f.width
            )
        })
        .collect();
    format!(
        "## Formats and error\n\n\
         | signal | format | bits |\n|---|---|---:|\n{rows}\n\
         Q*m*.*n* is a signed word: a sign, *m* integer bits and *n* fraction bits. Words are stored modulo their \
         width. For the longest walk that this frame can cause a colour is off by at most {:.4} LSB before the final \
         rounding, when words are rounded to nearest; one LSB is one step of an 8-bit colour.\n",
        m.error_bound_lsb
    )
}

fn simulation(m: &Manifest) -> String {
    let top = &m.top;
    let benches: String = m
        .wrappers
        .iter()
        .flat_map(|w| &w.names)
        .map(|w| format!("make {w:<14} # the wrapper's test bench, in Icarus Verilog\n"))
        .collect();
    format!(
        "## Simulate and lint\n\n\
         ```sh\n\
         make icarus         # Icarus Verilog: every output in every clock against sim/vectors.txt\n\
         make verilator      # Verilator: the same\n\
         {benches}\
         make lint           # Verilator, all warnings\n\
         make clean          # removes out/, below which everything is made\n\
         ```\n\n\
         A bench prints `PASS` and what it saw, or `MISMATCH` with clock and signal, and then `FAIL`. The vectors hold \
         {} clocks and {} pixels.\n\n\
         With FuseSoC, from a folder that holds this one:\n\n\
         ```sh\n\
         fusesoc --cores-root . run --target sim shadegate::{top}\n\
         fusesoc --cores-root . run --target lint shadegate::{top}\n\
         ```\n",
        m.vectors.get("clocks").copied().unwrap_or_default(),
        m.vectors.get("pixels").copied().unwrap_or_default()
    )
}

fn synthesis(m: &Manifest, target: Option<Target>) -> String {
    let top = &m.top;
    let (command, remark) = match target.map(|t| (t, t.device.constraints)) {
        Some((_, Format::Xdc)) => (
            "make vivado         # build/vivado.tcl: synthesis out of context, reports in out/vivado\n".to_owned(),
            "`build/vivado.tcl` was checked as Tcl, but not run by us, for want of the tool: expect to have to look at it.",
        ),
        Some((t, Format::Ucf)) => {
            let project = if m.files.iter().any(|f| f.ends_with(".xise")) {
                format!(" `build/{top}.xise` is the same as a project.")
            } else {
                String::new()
            };
            (
                format!(
                    "make ise            # build/ise.tcl, for {}: synthesis, in out/ise\n",
                    t.device.vendor_tool
                ),
                if project.is_empty() {
                    "`build/ise.tcl` was checked as Tcl, but not run by us, for want of the tool: expect to have to look at it."
                } else {
                    "`build/ise.tcl` was checked as Tcl, but not run by us, for want of the tool: expect to have to look at it. The project file beside it, which was not opened by us either, names the same files."
                },
            )
        }
        Some((t, format)) => {
            let tool = &t.device.vendor_tool;
            let constraints = m.files.iter().find(|f| f.starts_with("constraints/"));
            (
                format!(
                    "{tool} {} --json out/{top}.json --{} {}\n",
                    nextpnr_options(t).join(" "),
                    format.extension(),
                    constraints.map_or("", String::as_str)
                ),
                "nextpnr places a design with no more ports than the package has pins: put the core into a top level of your own first.",
            )
        }
        None => (String::new(), ""),
    };
    let remark = if remark.is_empty() {
        String::new()
    } else {
        format!("\n{remark}\n")
    };
    format!(
        "## Synthesise\n\n\
         ```sh\n\
         make yosys          # build/yosys.ys: netlist and cell counts in out/\n\
         {command}\
         ```\n{remark}"
    )
}
