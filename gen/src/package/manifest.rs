//! `manifest.json`: what a package is, for people and tools.

use super::line;
use super::registers::{registers, Register};
use super::resources::{resources, Resources};
use super::{PackageFile, Rtl, Target};
use crate::netlist::SignalKind;
use crate::vectors::Trace;
use crate::wrapper::{map, Wrapper};
use serde::Serialize;
use sha2::{Digest, Sha256};
use shadegate_hdl::shade::device::longest_run;
use shadegate_hdl::shade::model::Order;
use std::collections::BTreeMap;

/// A port of the top module.
#[derive(Clone, Debug, Serialize)]
pub struct PortEntry {
    /// Name.
    pub name: String,
    /// `input` or `output`.
    pub direction: &'static str,
    /// Bits.
    pub width: usize,
    /// What it means.
    pub description: String,
}

/// A fixed-point format.
#[derive(Clone, Debug, Serialize)]
pub struct FormatEntry {
    /// Integer bits, without the sign.
    pub int: usize,
    /// Fraction bits.
    pub frac: usize,
    /// Bits in all.
    pub width: usize,
}

/// Block RAM for the depth memory, or the frame memory of a line core.
#[derive(Clone, Debug, Serialize)]
pub struct BlockRam {
    /// Kilobits that the memory holds.
    pub needed_kbit: f64,
    /// Kilobits of the device, if one is named.
    pub available_kbit: Option<u32>,
    /// Whether they suffice.
    pub fits: Option<bool>,
}

/// The wrappers and the address map they share.
#[derive(Clone, Debug, Serialize)]
pub struct Wrappers {
    /// Names.
    pub names: Vec<Wrapper>,
    /// Byte addresses.
    pub map: Vec<map::Entry>,
}

/// The manifest.
#[derive(Clone, Debug, Serialize)]
pub struct Manifest {
    /// Core.
    pub core: String,
    /// Top module.
    pub top: String,
    /// Device part, or null.
    pub target: Option<String>,
    /// Board, or null.
    pub board: Option<String>,
    /// Files, by path inside the package, without the manifest.
    pub files: Vec<String>,
    /// SHA-256 of each of them, in hexadecimal digits.
    pub sha256: BTreeMap<String, String>,
    /// Ports of the top module.
    pub ports: Vec<PortEntry>,
    /// Register words.
    pub registers: Vec<Register>,
    /// Register words per clock.
    pub load_words: usize,
    /// Bus wrappers, or null.
    pub wrappers: Option<Wrappers>,
    /// Formats by signal class: colour, depth, column, error term.
    pub formats: BTreeMap<&'static str, FormatEntry>,
    /// Clocks from the edge that takes `start` to the edge at which the first pixel can be taken.
    pub latency: u32,
    /// Largest arithmetic error before the final rounding, LSB, for the longest run in this frame.
    pub error_bound_lsb: f64,
    /// Columns and rows of the frame.
    pub frame: (u32, u32),
    /// Depth memory, or frame memory of a line core.
    pub block_ram: BlockRam,
    /// What was measured of the core's size.
    pub resources: Resources,
    /// Clocks and pixels of the vectors.
    pub vectors: BTreeMap<&'static str, u64>,
    /// Hash that names this configuration.
    pub configuration: String,
    /// Version of the generator.
    pub generator: String,
}

impl Manifest {
    /// As indented JSON.
    #[must_use]
    pub fn to_json(&self) -> String {
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }
}

/// SHA-256 of a text, in hexadecimal digits.
fn digest(text: &str) -> String {
    let hash = Sha256::digest(text.as_bytes());
    hash.iter().map(|b| format!("{b:02x}")).collect()
}

pub(super) fn entry(int: usize, frac: usize) -> FormatEntry {
    FormatEntry {
        int,
        frac,
        width: 1 + int + frac,
    }
}

/// Fills in the manifest.
pub fn manifest(
    rtl: &Rtl,
    trace: &Trace,
    size: (u32, u32),
    target: Option<Target>,
    wrappers: &[Wrapper],
    files: &[PackageFile],
) -> Manifest {
    let core = &trace.core;
    let wrappers = (!wrappers.is_empty()).then(|| Wrappers {
        names: wrappers.to_vec(),
        map: map::entries(core.bus_bits()),
    });
    let sum = |f: &PackageFile| (f.path.clone(), digest(&f.text));
    let ports = rtl.top.signals.iter().filter_map(|s| {
        let direction = match s.kind {
            SignalKind::Input => "input",
            SignalKind::Output => "output",
            _ => return None,
        };
        Some(PortEntry {
            name: s.name.clone(),
            direction,
            width: s.format.width(),
            description: s.doc.clone(),
        })
    });
    let own = core.formats();
    let own = own
        .iter()
        .map(|(name, int, frac)| (*name, entry(*int, *frac)));
    let shared = [
        (
            "depth",
            entry(
                shadegate_hdl::shade::DEPTH_INTEGER_BITS,
                shadegate_hdl::shade::DEPTH_FRACTION_BITS,
            ),
        ),
        ("column", entry(shadegate_hdl::raster::COLUMN_BITS - 1, 0)),
        (
            "edge_error",
            entry(shadegate_hdl::raster::ERROR_BITS - 1, 0),
        ),
    ];
    let formats: BTreeMap<_, _> = match core.order {
        Order::Line(filter) => line::formats(filter),
        _ => own.chain(shared).collect(),
    };
    let needed_kbit = core.memory_bits() as f64 / 1024.0;
    let available_kbit = target.map(|t| t.device.block_ram_total_kbit());
    Manifest {
        core: core.name().to_string(),
        top: format!("{}_core", core.module()),
        target: target.map(|t| t.part()),
        board: target.and_then(|t| t.board).map(|b| b.name.clone()),
        files: files.iter().map(|f| f.path.clone()).collect(),
        sha256: files.iter().map(sum).collect(),
        ports: ports.collect(),
        registers: registers(core),
        load_words: core.load_words,
        wrappers,
        formats,
        latency: core.latency(),
        error_bound_lsb: core.error_bound(longest_run(size.0, size.1).unwrap_or(u32::MAX)),
        frame: size,
        block_ram: BlockRam {
            needed_kbit,
            available_kbit,
            fits: available_kbit.map(|a| needed_kbit <= f64::from(a)),
        },
        resources: resources(core, size, target.map(|t| t.device)),
        vectors: BTreeMap::from([
            ("clocks", trace.clocks.len() as u64),
            ("pixels", trace.pixels.len() as u64),
        ]),
        configuration: rtl.configuration.clone(),
        generator: super::GENERATOR.to_string(),
    }
}
