//! Verilator: the generated C++ main program around the compiled model. Builds are kept by content.

use super::process::{output, replay, rtl_paths, unpack};
use super::{Engine, EngineError, Run, Wave};
use crate::cache::{entry, key, Wanted};
use shadegate_gen::package::PackageFile;
use shadegate_gen::vectors::Trace;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

const ENGINE: Engine = Engine::Verilator;

/// Options of the compilation; part of the key.
const OPTIONS: [&str; 12] = [
    "-O3",
    "--x-assign",
    "fast",
    "--noassert",
    "--cc",
    "--exe",
    "--build",
    "-j",
    "2",
    "-CFLAGS",
    "-O2",
    "-Mdir",
];

fn build(
    core: &str,
    package: &[PackageFile],
    scratch: &Path,
    into: &Path,
) -> Result<(), EngineError> {
    let mut command = Command::new("verilator");
    command.current_dir(scratch).args(OPTIONS);
    command.args(["verilated", "--top-module", &format!("{core}_core")]);
    let main = scratch.join("sim/main.cpp");
    command.arg(std::path::absolute(&main).unwrap_or(main));
    command.args(rtl_paths(package));
    output(ENGINE, &mut command, false)?;
    let binary = scratch.join(format!("verilated/V{core}_core"));
    std::fs::copy(binary, into.join("simulation")).map_err(failed)?;
    Ok(())
}

fn failed(e: std::io::Error) -> EngineError {
    EngineError::Failed {
        engine: ENGINE,
        what: e.to_string(),
    }
}

/// Builds (or finds) the binary and runs it.
pub fn run(
    trace: &Trace,
    package: &[PackageFile],
    scratch: &Path,
    wave: Option<&Wave>,
) -> Result<Run, EngineError> {
    if wave.is_some() {
        return Err(EngineError::Unsupported {
            engine: ENGINE,
            what: "writes no waveforms; use --engine rust-hdl, icarus or cxxrtl for --wave".into(),
        });
    }
    unpack(ENGINE, package, scratch)?;
    let begin = Instant::now();
    let version = output(ENGINE, Command::new("verilator").arg("--version"), false)?;
    let sources = package.iter().filter(|f| {
        f.path.ends_with(".v") && f.path.starts_with("rtl/") || f.path == "sim/main.cpp"
    });
    let sources = sources.flat_map(|f| [f.path.as_str(), f.text.as_str()]);
    let key = key([version.as_str()].into_iter().chain(OPTIONS).chain(sources));
    let wanted = Wanted {
        kind: "verilator",
        key: &key,
        keep: true,
    };
    let built = entry(wanted, scratch, failed, |into| {
        build(&trace.core.module(), package, scratch, into)
    })?;
    let build_ns = begin.elapsed().as_nanos() as u64;
    let binary = built.directory.join("simulation");
    Ok(Run {
        build_ns: if built.cached { 0 } else { build_ns },
        build_cached: built.cached,
        ..replay(ENGINE, &binary, scratch, &[])?
    })
}
