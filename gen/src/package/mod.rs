//! A core as a directory that builds and checks itself: Verilog, constraints, vectors, test benches, Makefile, manifest.
//!
//! ```text
//! rtl/*.v              one module per file, top last in rtl/files.f
//! sim/                 vectors.txt, tb_<core>_core.v (any simulator), main.cpp (Verilator)
//! constraints/*.ucf|xdc  when a device or board is named
//! Makefile             icarus, verilator, lint, yosys
//! manifest.json        what this is: ports, formats, latency, error bound, files
//! ```

mod makefile;
mod manifest;

pub use manifest::{BlockRam, FormatEntry, Manifest, PortEntry};

use crate::netlist::{collect, undocumented, Module, NetlistError, SignalKind};
use crate::simulators::{main_cpp, test_bench};
use crate::vectors::Trace;
use crate::verilog::check::{check, Refusal};
use crate::verilog::{emit, hash, VerilogFile};
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

/// Emits and checks a core's Verilog.
///
/// # Errors
/// See [`PackageError`].
pub fn rtl(core: &Core) -> Result<Rtl, PackageError> {
    let simulator = CoreSimulator::new(*core).map_err(PackageError::Description)?;
    let top = collect(simulator.design())?;
    if let Some(missing) = undocumented(&top) {
        return Err(missing.into());
    }
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
    let core = &trace.core;
    let name = core.name();
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
    add(format!("sim/tb_{name}_core.v"), test_bench(core));
    add("sim/main.cpp".into(), main_cpp(core));
    if let Some(t) = target {
        let ports = ports(&rtl.top);
        let bindings = t
            .board
            .map(|b| default_bindings(b, &ports, "clock", t.period_ns))
            .unwrap_or_default();
        let file = shadegate_constraints::emit(&Request {
            design: &format!("{name}_core"),
            device: t.device,
            board: t.board,
            ports: &ports,
            clock_port: "clock",
            period_ns: t.period_ns,
            bindings: &bindings,
        })?;
        add(format!("constraints/{}", file.name), file.text);
    }
    add(
        "Makefile".into(),
        makefile::makefile(core, target.map(|t| t.device)),
    );
    let paths = files.iter().map(|f: &PackageFile| f.path.clone()).collect();
    let manifest = manifest::manifest(rtl, trace, size, target, paths);
    files.push(PackageFile {
        path: "manifest.json".into(),
        text: manifest.to_json(),
    });
    Ok(Package { files, manifest })
}
