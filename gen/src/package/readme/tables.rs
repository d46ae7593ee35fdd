//! The tables of the package's README.

use crate::package::engine_registers::ABOUT;
use crate::package::{Manifest, Register};
use std::fmt::Write;

/// The folders, as far as they are there.
pub fn contents(m: &Manifest) -> String {
    let rows = [
        (
            "rtl/",
            "the core, one module per file; `rtl/files.f` lists them, top last",
        ),
        ("sim/", "vectors and self-checking test benches"),
        ("constraints/", "clock and pins"),
        ("wrappers/", "bus wrappers"),
        ("build/", "scripts for synthesis"),
        ("example/", "the core in a design"),
        ("doc/", "the timing diagram"),
    ];
    let there = |folder: &str| m.files.iter().any(|f| f.starts_with(folder));
    let rows: String = rows
        .iter()
        .filter(|(folder, _)| there(folder))
        .map(|(folder, what)| format!("| `{folder}` | {what} |\n"))
        .collect();
    format!(
        "| path | holds |\n|---|---|\n{rows}\
         | `{}.core` | FuseSoC |\n\
         | `manifest.json` | all of this for programs, with the SHA-256 of every file |\n",
        m.top
    )
}

/// The ports of the top module.
pub fn ports(m: &Manifest) -> String {
    let rows: String = m
        .ports
        .iter()
        .map(|p| {
            format!(
                "| `{}` | {} | {} | {} |\n",
                p.name, p.direction, p.width, p.description
            )
        })
        .collect();
    let reset = if m.ports.iter().any(|p| p.name == crate::netlist::RESET) {
        "`reset`, active high and synchronous, gives every register its power-up value; the depth memory keeps its words, `clear` empties it."
    } else {
        "There is no reset: registers have initial values."
    };
    format!(
        "## Ports\n\n\
         All ports are synchronous to the rising edge of `clock`. {reset}\n\n\
         | port | direction | bits | meaning |\n|---|---|---:|---|\n{rows}"
    )
}

/// The register map: shell words by field, channel words once for all channels of a kind.
pub fn registers(m: &Manifest) -> String {
    let has = |target: &str| m.registers.iter().any(|r| r.target == target);
    let mask = match has("material") {
        false => "bit 4 red, bit 5 green, bit 6 blue, bit 7 depth",
        true if has("square") => "bit 4 light and half, bit 5 square, bit 6 material, bit 7 depth",
        true => "bit 4 light, bit 5 lobe, bit 6 material, bit 7 depth",
    };
    let mut out = format!(
        "## Registers\n\n\
         `select[7:4]` is a mask: {mask}; zero selects the shell, which holds \
         the edges. `select[3:0]` is the word. One write goes to every channel in the mask. A word is taken while \
         `load_ready` is high; words per triangle are double-buffered, and those that have not changed need not be \
         written again.\n\n\
         ### Shell\n\n",
    );
    out += &shell_rows(m);
    for (title, target, selects) in [
        ("Red, green, blue", "red", [1, 2, 4].as_slice()),
        ("Light: N·L", "light", &[1]),
        (
            "Lobe: (1 - N·H)·2^s in units of 2^-19, see the power table",
            "lobe",
            &[2],
        ),
        ("Half: N·H of the blended normal", "half", &[1]),
        (
            "Square: the squared length of the blended normal",
            "square",
            &[2],
        ),
        ("Material", "material", &[4]),
        ("Depth", "depth", &[8]),
    ] {
        if has(target) {
            out += &channel_rows(m, title, target, selects);
        }
    }
    if has("material") {
        out.push_str(
            "\nThe words of a material are not double-buffered: write the fence first, then what differs from the \
             material before. The power table holds hⁿ over t = (1 - h)·2^s from 0 to 1 in 512 intervals, s the largest \
             of 0 to 7 with (1 - 2^(-14/n))·2^s <= 1; it is written from interval 0 on. A material without a highlight \
             needs no table.\n",
        );
    }
    out.push_str(
        "\np is the step of one pixel along the span, s the step from one span start to the next, t = s + p that step \
         when the edge walk carries. d(u) is the first difference along u at the first span start, dd(u, v) the \
         second difference. Words that are sums of others are formed by adding the rounded words.\n",
    );
    out
}

/// The register map of a core with a set-up engine.
pub fn engine_registers(m: &Manifest) -> String {
    let mut out = String::from(ABOUT);
    out += &shell_rows(m);
    out += &channel_rows(m, "Red, green, blue", "red", &[1, 2, 4]);
    out += &channel_rows(m, "Depth", "depth", &[8]);
    out
}

/// The register map of a line core.
pub fn line_registers(m: &Manifest) -> String {
    let mut out = String::from(
        "## Registers\n\n\
         `select[7:4]` is a mask: bit 4 red, bit 5 green, bit 6 blue; zero selects the walk and its weights. \
         `select[3:0]` is the word. One write goes to every channel in the mask. A word is taken while `load_ready` is \
         high; words per line are double-buffered, and those that have not changed need not be written again.\n\n\
         A line is walked with its major coordinate rising: dX columns after the first along the major axis, dY <= dX \
         rows along the minor one. It may be begun at any column, with the words of that column.\n\n\
         ### Walk and weights\n\n",
    );
    out += &shell_rows(m);
    out += &channel_rows(m, "Red, green, blue", "red", &[1, 2, 4]);
    out
}

fn shell_rows(m: &Manifest) -> String {
    let mut out =
        String::from("| select | word | bits | content | per |\n|---:|---|---|---|---|\n");
    for r in m.registers.iter().filter(|r| r.target == "shell") {
        for (i, f) in r.fields.iter().enumerate() {
            let (select, name, per) = match i {
                0 => (format!("`{:02x}`", r.select), r.name, r.per),
                _ => (String::new(), "", ""),
            };
            let bits = match f.high - f.low {
                0 => f.high.to_string(),
                _ => format!("{}:{}", f.high, f.low),
            };
            // Writing to a string cannot fail.
            let _ = writeln!(
                out,
                "| {select} | {name} | {bits} | {} | {per} |",
                f.meaning
            );
        }
    }
    out
}

fn channel_rows(m: &Manifest, title: &str, target: &str, selects: &[u8]) -> String {
    let mut out = String::new();
    let _ = write!(
            out,
            "\n### {title}\n\n| select | word | format | bits | content | per |\n|---|---|---|---:|---|---|\n"
        );
    for r in m.registers.iter().filter(|r| r.target == target) {
        let _ = writeln!(out, "{}", channel_row(r, selects));
    }
    out
}

fn channel_row(r: &Register, masks: &[u8]) -> String {
    let selects: Vec<String> = masks
        .iter()
        .map(|m| format!("`{:02x}`", m << 4 | r.word))
        .collect();
    format!(
        "| {} | {} | {} | {} | {} | {} |",
        selects.join(", "),
        r.name,
        r.format,
        r.bits,
        r.meaning,
        r.per
    )
}

/// The address map of the wrappers and what leaves them; nothing where there are none.
pub fn wrappers(m: &Manifest) -> String {
    let Some(w) = &m.wrappers else {
        return String::new();
    };
    let modules: String = w
        .names
        .iter()
        .map(|n| format!("- `wrappers/{}_{n}.v`: {}.\n", m.top, n.about()))
        .collect();
    let rows: String = w
        .map
        .iter()
        .map(|e| {
            let address = if e.address == e.last {
                format!("`{:03x}`", e.address)
            } else {
                format!("`{:03x}` to `{:03x}`", e.address, e.last)
            };
            format!(
                "| {address} | {} | {} | {} |\n",
                e.name, e.access, e.meaning
            )
        })
        .collect();
    let reset = if m.ports.iter().any(|p| p.name == crate::netlist::RESET) {
        "The reset is that of the core too; pixels on their way out are forgotten, the depth memory keeps its words."
    } else {
        "The reset is the wrapper's alone and forgets pixels on their way out; the core has none."
    };
    format!(
        "## Bus wrappers\n\n{modules}\n\
         | address | register | access | meaning |\n|---|---|---|---|\n{rows}\n\
         Addresses count bytes. A write that the core cannot take yet is not answered until it can; a host that must \
         not wait reads `status` first. Writes of fewer than four bytes, and accesses where nothing can be written or \
         read, are refused: SLVERR, or ERR_O. {reset}\n\n\
         A word of the pixel stream is {{2'b0, depth[15:0], blue[7:0], green[7:0], red[7:0], y[10:0], x[10:0]}}, 64 \
         bits. The stream may be held up at any time. A frame is what is started before the host writes `end`: its \
         last visible pixel bears the mark (TLAST), and leaves when the core is idle. Until then one pixel is held \
         back. If no pixel was visible, one word with all TKEEP low bears the mark.\n"
    )
}

/// What was measured.
pub fn resources(m: &Manifest) -> String {
    let r = &m.resources;
    let memory = match m.core.as_str() {
        "bresenham" => "No memory and no multiplier is used.\n".to_owned(),
        "box" | "cone" => format!(
            "The frame memory holds {} bits, 24 per pixel. Blending takes {} multipliers of 9 bits.\n",
            r.depth_memory_bits, r.multipliers
        ),
        _ => format!(
            "The depth memory holds {} bits, 16 per pixel. {}\n",
            r.depth_memory_bits,
            match r.multipliers {
                0 => "No multiplier is used.".to_owned(),
                n => format!("{n} multipliers and one block RAM for the power table come on top."),
            }
        ),
    };
    let Some(measured) = &r.measured else {
        return format!(
            "## Resources\n\n{memory}Logic was not measured for this core, frame and family.\n"
        );
    };
    let rows: String = measured
        .iter()
        .map(|m| {
            format!(
                "| {} | {} | {} | {} | {} |\n",
                m.family, m.lut, m.ff, m.bram, m.dsp
            )
        })
        .collect();
    format!(
        "## Resources\n\n{memory}\n\
         | family | LUT | FF | block RAM | DSP |\n|---|---:|---:|---:|---:|\n{rows}\n\
         Counted by {}.\n",
        r.tool
    )
}
