//! The report for people.

use crate::table::Table;
use shadegate_testbench::synthesis::Row;
use std::path::Path;

/// A table, what its columns mean, and what was routed.
pub fn text(title: &str, rows: &[Row], folder: Option<&Path>) -> String {
    let mut table = Table::new(&[
        "target",
        "family",
        "LUT",
        "FF",
        "carry",
        "block RAM",
        "DSP",
        "slices",
        "fits",
        "depth",
        "cells, ns",
        "Fmax, MHz",
    ]);
    let dash = || "-".to_owned();
    for r in rows {
        let n = &r.resources;
        let kinds = n.bram_cells.iter().map(|(kind, n)| format!("{n} {kind}"));
        let kinds: Vec<String> = kinds.collect();
        table.row([
            r.target.clone().unwrap_or_else(dash),
            r.family.to_owned(),
            n.lut.to_string(),
            n.ff.to_string(),
            match &n.carry_cell {
                Some(cell) => format!("{} {cell}", n.carry),
                None => "0".to_owned(),
            },
            if kinds.is_empty() {
                "0".to_owned()
            } else {
                kinds.join(", ")
            },
            n.dsp.to_string(),
            r.slices.map_or_else(dash, |s| s.to_string()),
            r.fits
                .map_or_else(dash, |f| if f { "yes" } else { "no" }.to_owned()),
            r.depth.map_or_else(dash, |d| d.to_string()),
            r.arrival_ps
                .map_or_else(dash, |ps| format!("{:.2}", ps as f64 / 1e3)),
            r.fmax_mhz.map_or_else(dash, |f| format!("{f:.1}")),
        ]);
    }
    let mut out = format!("{title}: cells before placement\n{}", table.text());
    out += "slices  if every one is filled: the most that LUT, FF or carry need\n\
            depth   cells on the longest path between registers\n\
            cells   delay of these cells without wires: no clock is that fast\n";
    for r in rows {
        if let (Some(part), Some(fmax)) = (&r.target, r.fmax_mhz) {
            out += &format!(
                "routed on {part} by {}: {fmax:.1} MHz; not a Spartan figure\n",
                r.tool
            );
        }
        if let Some(p) = &r.slowest_path {
            out += &format!(
                "  its slowest path takes {:.1} ns in cells and {:.1} ns in wires, from {} to {}\n",
                p.cells_ns, p.wires_ns, p.from, p.to
            );
        }
    }
    if let Some(folder) = folder {
        out += &format!("wrote {}\n", folder.display());
    }
    out
}
