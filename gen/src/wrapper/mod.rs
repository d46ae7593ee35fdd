//! Bus wrappers of a core, as Verilog-2001 and each with a test bench of its own.
//!
//! ```text
//!  bus ──► <core>_axi or <core>_wishbone      handshakes of the bus
//!            ├── <core>_host                  addresses to register writes; waits while the core cannot take them
//!            ├── <core>                       the core itself
//!            └── <core>_frames                pixel words with an end-of-frame mark
//! ```
//!
//! [`map`] is the address map that all of them share. The texts depend on the core's name and on the width of its
//! register bus, nothing else.

mod axi;
mod bench;
mod frames;
mod host;
pub mod map;
mod parts;
mod wishbone;

use crate::package::PackageFile;
use serde::Serialize;
use shadegate_hdl::shade::device::Core;
use std::fmt;
use std::str::FromStr;

/// A bus that a core can be wrapped for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Wrapper {
    /// AXI4-Lite slave for the registers, AXI4-Stream master for the pixels.
    Axi,
    /// Wishbone B4 classic slave for the registers; the pixels leave as with AXI4-Stream.
    Wishbone,
}

impl Wrapper {
    /// All of them.
    pub const ALL: [Wrapper; 2] = [Wrapper::Axi, Wrapper::Wishbone];

    /// Name in the command line and in file names.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Wrapper::Axi => "axi",
            Wrapper::Wishbone => "wishbone",
        }
    }

    /// What it is, for tables.
    #[must_use]
    pub fn about(self) -> &'static str {
        match self {
            Wrapper::Axi => "AXI4-Lite slave for the registers, AXI4-Stream master for the pixels",
            Wrapper::Wishbone => {
                "Wishbone B4 classic slave for the registers, the same words with valid and ready for the pixels"
            }
        }
    }
}

impl fmt::Display for Wrapper {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A name that is no wrapper's.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("unknown wrapper '{}'; expected axi or wishbone", .0.escape_debug())]
pub struct UnknownWrapper(pub String);

impl FromStr for Wrapper {
    type Err = UnknownWrapper;

    fn from_str(name: &str) -> Result<Self, UnknownWrapper> {
        let known = Self::ALL.into_iter().find(|w| w.name() == name);
        known.ok_or_else(|| UnknownWrapper(name.to_owned()))
    }
}

/// What the texts depend on.
#[derive(Clone, Debug)]
pub(crate) struct Context {
    /// Top module of the core: `quadratic_core`.
    pub top: String,
    /// Bits of its register bus, 32 to 64.
    pub bus_bits: usize,
    /// The line of the header that names generator and configuration.
    pub stamp: String,
    /// Whether the core has a reset.
    pub reset: bool,
}

impl Context {
    /// Bits of the register bus above the 32 of a bus write.
    pub fn high_bits(&self) -> usize {
        self.bus_bits.saturating_sub(32)
    }

    /// The comment at the head of a module, as the back end writes it.
    pub fn header(&self, module: &str, title: &str, lines: &[(&str, &str)]) -> String {
        let body: String = lines
            .iter()
            .map(|(key, text)| format!("// {key:9} {text}\n"))
            .collect();
        format!(
            "// {module}: {title}\n//\n{body}//\n// {}\n\n`default_nettype none\n\n",
            self.stamp
        )
    }
}

/// The files of these wrappers, each once: modules under `wrappers/`, test benches under `sim/`. `clocks` is the length
/// of the vector file, from which the benches take how long to wait before they give up.
#[must_use]
pub fn files(
    core: &Core,
    wrappers: &[Wrapper],
    stamp: &str,
    clocks: usize,
    reset: bool,
) -> Vec<PackageFile> {
    let mut wrappers = wrappers.to_vec();
    wrappers.sort_unstable();
    wrappers.dedup();
    if wrappers.is_empty() {
        return vec![];
    }
    let c = Context {
        top: format!("{}_core", core.module()),
        bus_bits: core.bus_bits(),
        stamp: stamp.to_owned(),
        reset,
    };
    let top = &c.top;
    let file = |path: String, text: String| PackageFile { path, text };
    let mut files = vec![
        file(format!("wrappers/{top}_host.v"), host::module(&c)),
        file(format!("wrappers/{top}_frames.v"), frames::module(&c)),
    ];
    let limit = 200 * clocks + 4 * core.pixels + 100_000;
    for w in wrappers {
        let (module, bench) = match w {
            Wrapper::Axi => (axi::module(&c), bench::text(&c, w, axi::BENCH, limit)),
            Wrapper::Wishbone => (
                wishbone::module(&c),
                bench::text(&c, w, wishbone::BENCH, limit),
            ),
        };
        files.push(file(format!("wrappers/{top}_{w}.v"), module));
        files.push(file(format!("sim/tb_{top}_{w}.v"), bench));
    }
    files
}
