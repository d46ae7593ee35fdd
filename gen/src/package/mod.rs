//! A core as a directory that builds and checks itself: Verilog, constraints, vectors, test benches, Makefile, manifest.
//!
//! ```text
//! README.md            register map, ports, formats, timing, how to build, an example
//! rtl/*.v              one module per file, top last in rtl/files.f
//! sim/                 vectors.txt, tb_<core>_core.v (any simulator), main.cpp (Verilator), benches of the wrappers
//! constraints/*        UCF, XDC, PCF or LPF, when a device or board is named
//! build/               yosys.ys; vivado.tcl, or ise.tcl and a project, where the device is one of theirs
//! wrappers/*.v         bus wrappers, when asked for
//! example/*.v          the core in a design
//! doc/                 the timing diagram: WaveDrom JSON and SVG
//! <core>_core.core     FuseSoC
//! Makefile             icarus, verilator, lint, yosys, …
//! manifest.json        what this is: ports, registers, formats, latency, error bound, resources, files
//! ```

mod build;
mod example;
mod fusesoc;
mod line;
mod makefile;
mod manifest;
mod readme;
mod registers;
mod resources;
mod span_registers;
pub mod timing;

pub use manifest::{BlockRam, FormatEntry, Manifest, PortEntry, Wrappers};
pub use registers::{registers, Field, Register};
pub use resources::{resources, Measured, Resources};

use crate::netlist::{
    collect, elaborate, undocumented, with_reset, Module, NetlistError, SignalKind, RESET,
};
use crate::simulators::{main_cpp, test_bench};
use crate::stimulus::StimulusError;
use crate::vectors::Trace;
use crate::verilog::check::{check, Refusal};
use crate::verilog::{emit, hash, VerilogFile};
use crate::wrapper::{self, Wrapper};
use shadegate_constraints::{
    default_bindings, Board, ConstraintError, Device, Direction, Port, Request,
};
use shadegate_hdl::shade::device::{Core, CoreSimulator};

/// Why a package cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum PackageError {
    /// rust-hdl's own checks.
    #[error("the description fails rust-hdl's checks: {0}")]
    Description(String),
    /// The description uses something the back end refuses.
    #[error(transparent)]
    Netlist(#[from] NetlistError),
    /// Emitted text outside the safe subset: a defect of the back end.
    #[error("emitted Verilog is not in the safe subset: {0}")]
    Unsafe(#[from] Refusal),
    /// Device, board, period or bindings do not fit.
    #[error(transparent)]
    Constraints(#[from] ConstraintError),
    /// Bus wrappers have one register bus.
    #[error("bus wrappers write one register word per clock, and the core takes {0}; leave out the wrappers, or take 1 load word")]
    LoadWords(usize),
    /// A primitive of the package's own cannot be drawn: a defect of the generator.
    #[error("the package's example cannot be set up: {0}")]
    Example(#[from] StimulusError),
}

/// Where a core is to go.
#[derive(Clone, Copy, Debug)]
pub struct Target<'a> {
    /// Device.
    pub device: &'a Device,
    /// Board, if one is named.
    pub board: Option<&'a Board>,
    /// Clock period, ns.
    pub period_ns: f64,
}

impl Target<'_> {
    /// The whole part name, as the device's tool spells it.
    #[must_use]
    pub fn part(&self) -> String {
        match self.board {
            Some(b) => self.device.part_in(&b.package, b.speed),
            None => self.device.part(),
        }
    }
}

/// What a package is made for.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options<'a> {
    /// Device and board, if named.
    pub target: Option<Target<'a>>,
    /// Bus wrappers that come with it.
    pub wrappers: &'a [Wrapper],
}

/// The Verilog of a core.
#[derive(Clone, Debug)]
pub struct Rtl {
    /// Files, top module last.
    pub files: Vec<VerilogFile>,
    /// The netlist they were printed from.
    pub top: Module,
    /// Twelve hexadecimal digits that name this configuration: a hash of the Verilog itself.
    pub configuration: String,
}

/// One file of a package.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PackageFile {
    /// Path inside the package, `/` between folders.
    pub path: String,
    /// Contents.
    pub text: String,
}

/// A core's package.
#[derive(Clone, Debug)]
pub struct Package {
    /// Files in a fixed order; the manifest comes last.
    pub files: Vec<PackageFile>,
    /// What the manifest says.
    pub manifest: Manifest,
}

/// What made the files, as their headers and the manifest name it.
pub const GENERATOR: &str = concat!("shadegate ", env!("CARGO_PKG_VERSION"));

impl Rtl {
    /// Whether the core has the optional synchronous reset.
    #[must_use]
    pub fn has_reset(&self) -> bool {
        self.top.signal(RESET).is_some()
    }
}

/// Emits and checks a core's Verilog.
///
/// # Errors
/// See [`PackageError`].
pub fn rtl(core: &Core) -> Result<Rtl, PackageError> {
    rtl_with(core, false)
}

/// The same, with a synchronous reset if that is wanted.
///
/// # Errors
/// See [`PackageError`].
pub fn rtl_with(core: &Core, reset: bool) -> Result<Rtl, PackageError> {
    let simulator = CoreSimulator::new(*core).map_err(PackageError::Description)?;
    let mut top = collect(simulator.design())?;
    if let Some(missing) = undocumented(&top) {
        return Err(missing.into());
    }
    if reset {
        top = with_reset(&top)?;
    }
    // One clock, and no wire that depends on itself, through the whole hierarchy.
    elaborate(&top)?;
    let files = emit(&top, GENERATOR)?;
    let texts: Vec<&str> = files.iter().map(|f| f.text.as_str()).collect();
    let configuration = hash(&texts);
    for f in &files {
        check(&f.file_name(), &f.text)?;
    }
    Ok(Rtl {
        files,
        top,
        configuration,
    })
}

/// The line of every header that names generator and configuration.
fn stamp(configuration: &str) -> String {
    format!("Generated by {GENERATOR}, for configuration {configuration}.")
}

/// Ports of the top module, for constraints.
fn ports(top: &Module) -> Vec<Port> {
    let port = |s: &crate::netlist::Signal| {
        let direction = match s.kind {
            SignalKind::Input => Direction::Input,
            SignalKind::Output => Direction::Output,
            _ => return None,
        };
        Some(Port::new(
            s.name.clone(),
            s.format.width() as u32,
            direction,
        ))
    };
    top.signals.iter().filter_map(port).collect()
}

/// Makes the package of a core for a frame of `size`, with the vectors of a recorded run.
///
/// # Errors
/// See [`PackageError`].
pub fn package(
    rtl: &Rtl,
    trace: &Trace,
    size: (u32, u32),
    target: Option<Target>,
) -> Result<Package, PackageError> {
    let options = Options {
        target,
        wrappers: &[],
    };
    package_with(rtl, trace, size, &options)
}

/// Makes the package with everything that can be asked for.
///
/// # Errors
/// See [`PackageError`].
pub fn package_with(
    rtl: &Rtl,
    trace: &Trace,
    size: (u32, u32),
    options: &Options,
) -> Result<Package, PackageError> {
    let core = &trace.core;
    let (target, mut wrappers) = (options.target, options.wrappers.to_vec());
    wrappers.sort_unstable();
    wrappers.dedup();
    if core.load_words > 1 && !wrappers.is_empty() {
        return Err(PackageError::LoadWords(core.load_words));
    }
    let top = format!("{}_core", core.module());
    let stamp = stamp(&rtl.configuration);
    let paths = rtl.files.iter().map(|f| format!("rtl/{}", f.file_name()));
    let paths: Vec<String> = paths.collect();
    let mut files = vec![];
    let mut add = |path: String, text: String| files.push(PackageFile { path, text });
    for f in &rtl.files {
        add(format!("rtl/{}", f.file_name()), f.text.clone());
    }
    add(
        "rtl/files.f".into(),
        rtl.files.iter().map(|f| f.file_name() + "\n").collect(),
    );
    add("sim/vectors.txt".into(), trace.to_text());
    add(format!("sim/tb_{top}.v"), test_bench(core, rtl.has_reset()));
    add("sim/main.cpp".into(), main_cpp(core, rtl.has_reset()));
    let constraints = target.map(|t| constraints(rtl, &top, t)).transpose()?;
    if let Some(f) = &constraints {
        add(f.path.clone(), f.text.clone());
    }
    let example = example::example(core, size, &stamp, rtl.has_reset())?;
    add(format!("example/{top}_example.v"), example.clone());
    let diagram = timing::diagram(core, size)?;
    add("doc/timing.json".into(), timing::wavedrom(&diagram));
    add("doc/timing.svg".into(), timing::svg(&diagram));
    add(
        "Makefile".into(),
        makefile::makefile(&top, &paths, &wrappers, target.map(|t| t.device)),
    );
    let clocks = trace.clocks.len();
    files.extend(wrapper::files(
        core,
        &wrappers,
        &stamp,
        clocks,
        rtl.has_reset(),
    ));
    let sources = build::Sources {
        top: &top,
        rtl: paths.iter().map(String::as_str).collect(),
        constraints: constraints.as_ref().map(|f| f.path.as_str()),
    };
    files.extend(build::scripts(&sources, target));
    files.push(PackageFile {
        path: format!("{top}.core"),
        text: fusesoc::core_file(&top, &files, target),
    });
    let fill =
        |files: &[PackageFile]| manifest::manifest(rtl, trace, size, target, &wrappers, files);
    let text = readme::readme(&fill(&files), core, target, &example);
    files.push(PackageFile {
        path: "README.md".into(),
        text,
    });
    let manifest = fill(&files);
    files.push(PackageFile {
        path: "manifest.json".into(),
        text: manifest.to_json(),
    });
    Ok(Package { files, manifest })
}

/// The constraint file of a core.
fn constraints(rtl: &Rtl, top: &str, t: Target) -> Result<PackageFile, PackageError> {
    let ports = ports(&rtl.top);
    let bindings = t
        .board
        .map(|b| default_bindings(b, &ports, "clock", t.period_ns))
        .unwrap_or_default();
    let file = shadegate_constraints::emit(&Request {
        design: top,
        device: t.device,
        board: t.board,
        ports: &ports,
        clock_port: "clock",
        period_ns: t.period_ns,
        bindings: &bindings,
    })?;
    Ok(PackageFile {
        path: format!("constraints/{}", file.name),
        text: file.text,
    })
}
