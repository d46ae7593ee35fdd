//! Cores, devices and boards.

use super::Section;
use serde_json::json;
use shadegate_gen::scene::catalogue;
use shadegate_hdl::shade::device::{Core, MAX_HEIGHT, MAX_WIDTH, NARROW_RUN, WIDE_RUN};

/// Every core in its narrow and its wide format.
pub fn cores() -> Section {
    let mut section = Section::new(&[
        "core",
        "interpolants",
        "bus",
        "address",
        "words per clock",
        "longest run",
        "bound, LSB",
    ]);
    for (name, order) in catalogue() {
        for (wide, run) in [(false, NARROW_RUN), (true, WIDE_RUN)] {
            let core = Core {
                order,
                wide,
                pixels: 2,
                load_words: Core::usual_load_words(order),
            };
            let formats = core.formats();
            let q = |(_, int, frac): &(&str, usize, usize)| format!("Q{int}.{frac}");
            let all: Vec<String> = formats.iter().map(q).collect();
            let (_, int, frac) = formats.first().copied().unwrap_or_default();
            section.add(
                [
                    name.to_owned(),
                    all.join(", "),
                    core.bus_bits().to_string(),
                    core.address_bits().to_string(),
                    core.load_words.to_string(),
                    run.to_string(),
                    format!("{:.4}", core.error_bound(run)),
                ],
                json!({
                    "name": name,
                    "format": { "int": int, "frac": frac },
                    "wide": wide,
                    "bus_bits": core.bus_bits(),
                    "address_bits": core.address_bits(),
                    "load_words": core.load_words,
                    "longest_run": run,
                    "error_bound_lsb": core.error_bound(run),
                    "max_width": MAX_WIDTH,
                    "max_height": MAX_HEIGHT,
                }),
            );
        }
    }
    section.note = Some(format!(
        "A frame has a run of 1.5·columns + 2·rows (guard band, carries), and at most {MAX_WIDTH}x{MAX_HEIGHT} pixels; the narrowest format \
         that fits is taken."
    ));
    section
}

/// Every device.
pub fn targets() -> Section {
    let mut section = Section::new(&[
        "target",
        "family",
        "part",
        "LUTs",
        "FFs",
        "BRAM kbit",
        "DSPs",
        "tool",
    ]);
    for d in shadegate_constraints::devices() {
        section.add(
            [
                d.name.clone(),
                d.family.clone(),
                d.part(),
                d.luts.to_string(),
                d.flip_flops.to_string(),
                d.block_ram_total_kbit().to_string(),
                d.multipliers.to_string(),
                d.vendor_tool.clone(),
            ],
            json!({
                "name": d.name,
                "family": d.family,
                "part": d.part(),
                "slices": d.slices,
                "lut_inputs": d.lut_inputs,
                "luts": d.luts,
                "flip_flops": d.flip_flops,
                "block_ram_kbit": d.block_ram_total_kbit(),
                "multipliers": d.multipliers,
                "constraints": d.constraints.extension(),
                "vendor_tool": d.vendor_tool,
            }),
        );
    }
    section
}

/// Every board.
pub fn boards() -> Section {
    let mut section = Section::new(&["board", "device", "package", "speed", "title"]);
    for b in shadegate_constraints::boards() {
        section.add(
            [
                b.name.clone(),
                b.device.clone(),
                b.package.clone(),
                b.speed.to_string(),
                b.title.clone(),
            ],
            json!({
                "name": b.name,
                "device": b.device,
                "package": b.package,
                "speed": b.speed,
                "title": b.title,
            }),
        );
    }
    section
}
