//! Engines: ways to run a core's vectors. Each answers the same questions: do all outputs agree with the integer model
//! in every clock, which pixels came out, and how fast was it.

mod compiled;
mod cxxrtl;
mod icarus;
mod process;
mod rust_hdl;
mod verilator;

use serde::Serialize;
use shadegate_gen::package::PackageFile;
use shadegate_gen::vectors::Trace;
use std::fmt;
use std::path::{Path, PathBuf};
use std::str::FromStr;

pub use crate::process::find_tool;

/// An engine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Engine {
    /// rust-hdl's simulation of the description, in this process.
    RustHdl,
    /// The netlist as native code, in this process.
    Compiled,
    /// The emitted Verilog in Icarus Verilog.
    Icarus,
    /// The emitted Verilog compiled by Verilator.
    Verilator,
    /// The emitted Verilog compiled by CXXRTL, the simulation back end of Yosys.
    Cxxrtl,
}

impl Engine {
    /// All engines.
    pub const ALL: [Self; 5] = [
        Self::RustHdl,
        Self::Compiled,
        Self::Icarus,
        Self::Verilator,
        Self::Cxxrtl,
    ];

    /// Name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::RustHdl => "rust-hdl",
            Self::Compiled => "compiled",
            Self::Icarus => "icarus",
            Self::Verilator => "verilator",
            Self::Cxxrtl => "cxxrtl",
        }
    }

    /// Programs it needs, each with the Debian package that brings it.
    #[must_use]
    pub fn tools(self) -> &'static [(&'static str, &'static str)] {
        match self {
            Self::RustHdl | Self::Compiled => &[],
            Self::Icarus => &[("iverilog", "iverilog"), ("vvp", "iverilog")],
            Self::Verilator => &[("verilator", "verilator"), ("make", "make"), ("g++", "g++")],
            // yosys-config says where the headers of the C++ model are.
            Self::Cxxrtl => &[
                ("yosys", "yosys"),
                ("yosys-config", "yosys-dev"),
                ("g++", "g++"),
            ],
        }
    }
}

impl fmt::Display for Engine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Engine {
    type Err = shadegate_reference::method::UnknownName;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        Self::ALL
            .into_iter()
            .find(|e| e.name() == name)
            .ok_or_else(|| {
                shadegate_reference::method::UnknownName::new(
                    "engine",
                    name,
                    &Self::ALL.map(Self::name),
                )
            })
    }
}

/// Where an engine's outputs first differ from the integer model's.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct SignalMismatch {
    /// Clock, from 0: the line of the vector file.
    pub cycle: u64,
    /// Output.
    pub signal: String,
    /// Value of the integer model.
    pub expected: u64,
    /// Value of the engine.
    pub got: u64,
    /// Column of the pixel that the model shows in this clock.
    pub x: u32,
    /// Its row.
    pub y: u32,
}

/// A run's result.
#[derive(Clone, Debug, Default)]
pub struct Run {
    /// Clocks in which some output differs.
    pub mismatches: u64,
    /// The first of them.
    pub first: Option<SignalMismatch>,
    /// Pixels in order: column, row, colour.
    pub pixels: Vec<(u16, u16, [u8; 3])>,
    /// Clocks simulated.
    pub cycles: u64,
    /// Time of the simulation: of the whole process where it is one, reading the vectors and writing the pixels
    /// included.
    pub simulate_ns: u64,
    /// Time of the simulation loop alone, vectors and pixels in memory, where the engine can tell.
    pub loop_ns: Option<u64>,
    /// Time to build the simulator; zero where nothing is built or the build was cached.
    pub build_ns: u64,
    /// The build came from the cache.
    pub build_cached: bool,
}

/// A waveform of a window of clocks.
#[derive(Clone, Debug)]
pub struct Wave {
    /// VCD file; the compiled engine writes FST by that ending.
    pub file: PathBuf,
    /// First clock.
    pub from: u64,
    /// One past the last clock.
    pub to: u64,
    /// Patterns of the signals to show, see [`crate::wave`]; all if empty. Only the compiled engine chooses.
    pub signals: Vec<String>,
}

/// Why an engine could not run.
#[derive(Debug, thiserror::Error)]
pub enum EngineError {
    /// A program is missing.
    #[error(
        "engine {engine}: `{tool}` is not installed; install it with `apt-get install {package}`"
    )]
    Missing {
        /// Engine.
        engine: Engine,
        /// Program.
        tool: &'static str,
        /// Debian package.
        package: &'static str,
    },
    /// A program failed.
    #[error("engine {engine}: {what}")]
    Failed {
        /// Engine.
        engine: Engine,
        /// What it said.
        what: String,
    },
    /// The engine cannot do what was asked.
    #[error("engine {engine} {what}")]
    Unsupported {
        /// Engine.
        engine: Engine,
        /// What.
        what: String,
    },
}

/// Runs vectors. `package` holds the emitted files; `scratch` is a directory for temporary ones.
///
/// # Errors
/// See [`EngineError`].
pub fn run(
    engine: Engine,
    trace: &Trace,
    package: &[PackageFile],
    scratch: &Path,
    wave: Option<&Wave>,
) -> Result<Run, EngineError> {
    for (tool, package) in engine.tools() {
        if find_tool(tool).is_none() {
            return Err(EngineError::Missing {
                engine,
                tool,
                package,
            });
        }
    }
    let chooses = engine == Engine::Compiled || wave.is_none_or(|w| w.signals.is_empty());
    if !chooses {
        let what = "shows all signals; use --engine compiled for --signals".into();
        return Err(EngineError::Unsupported { engine, what });
    }
    match engine {
        Engine::RustHdl => rust_hdl::run(trace, wave),
        Engine::Compiled => compiled::run(trace, wave),
        Engine::Icarus => icarus::run(trace, package, scratch, wave),
        Engine::Verilator => verilator::run(trace, package, scratch, wave),
        Engine::Cxxrtl => cxxrtl::run(trace, package, scratch, wave),
    }
}
