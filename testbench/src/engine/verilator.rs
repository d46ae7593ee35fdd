//! Verilator: the generated C++ main program around the compiled model. Builds are kept by content.

use super::process::{output, read_pixels, read_verdict, unpack};
use super::{Engine, EngineError, Run, Wave};
use sha2::{Digest, Sha256};
use shadegate_gen::package::PackageFile;
use shadegate_gen::vectors::Trace;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

const ENGINE: Engine = Engine::Verilator;

/// Where builds are kept: `$SHADEGATE_CACHE`, `$XDG_CACHE_HOME/shadegate`, or `~/.cache/shadegate`.
fn cache_directory() -> Option<PathBuf> {
    let set = |name: &str| {
        std::env::var_os(name)
            .filter(|v| !v.is_empty())
            .map(PathBuf::from)
    };
    set("SHADEGATE_CACHE")
        .or_else(|| set("XDG_CACHE_HOME").map(|p| p.join("shadegate")))
        .or_else(|| set("HOME").map(|p| p.join(".cache/shadegate")))
}

/// Hash of everything that goes into the binary.
fn key(sources: &[&PackageFile], version: &str) -> String {
    let mut hash = Sha256::new();
    hash.update(version.as_bytes());
    for f in sources {
        hash.update(f.path.as_bytes());
        hash.update([0]);
        hash.update(f.text.as_bytes());
        hash.update([0]);
    }
    hash.finalize()
        .iter()
        .take(16)
        .map(|b| format!("{b:02x}"))
        .collect()
}

fn build(core: &str, sources: &[&PackageFile], scratch: &Path) -> Result<PathBuf, EngineError> {
    let mut command = Command::new("verilator");
    command.current_dir(scratch).args([
        "-O3",
        "--x-assign",
        "fast",
        "--noassert",
        "--cc",
        "--exe",
        "--build",
        "-j",
        "2",
    ]);
    command.args([
        "-CFLAGS",
        "-O2",
        "-Mdir",
        "verilated",
        "--top-module",
        &format!("{core}_core"),
    ]);
    let main = scratch.join("sim/main.cpp");
    command.arg(std::path::absolute(&main).unwrap_or(main));
    command.args(
        sources
            .iter()
            .filter(|f| f.path.ends_with(".v"))
            .map(|f| &f.path),
    );
    output(ENGINE, &mut command, false)?;
    Ok(scratch.join(format!("verilated/V{core}_core")))
}

/// Copies the binary into the cache under a name that appears only when it is whole. A cache that cannot be written
/// costs the next run a build, nothing else.
fn keep(binary: &Path, kept: &Path) {
    let Some(parent) = kept.parent() else { return };
    let copied = std::fs::create_dir_all(parent)
        .and_then(|()| {
            tempfile::Builder::new()
                .prefix("building")
                .tempdir_in(parent)
        })
        .and_then(|d| {
            let whole = d.path().join("simulation");
            std::fs::copy(binary, &whole)?;
            std::fs::rename(&whole, kept)
        });
    drop(copied);
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
            what: "writes no waveforms; use --engine rust-hdl or icarus for --wave".into(),
        });
    }
    unpack(ENGINE, package, scratch)?;
    let core = trace.core.name();
    let sources: Vec<&PackageFile> = package
        .iter()
        .filter(|f| {
            f.path.ends_with(".v") && f.path.starts_with("rtl/") || f.path == "sim/main.cpp"
        })
        .collect();
    let version = output(ENGINE, Command::new("verilator").arg("--version"), false)?;
    let kept = cache_directory().map(|c| c.join("verilator").join(key(&sources, &version)));
    let begin = Instant::now();
    let (binary, build_cached) = match &kept {
        Some(kept) if kept.is_file() => (kept.clone(), true),
        _ => {
            let binary = build(core, &sources, scratch)?;
            if let Some(kept) = &kept {
                keep(&binary, kept);
            }
            (binary, false)
        }
    };
    let build_ns = if build_cached {
        0
    } else {
        begin.elapsed().as_nanos() as u64
    };
    let begin = Instant::now();
    let mut simulation = Command::new(std::path::absolute(&binary).unwrap_or(binary));
    simulation
        .current_dir(scratch)
        .args(["sim/vectors.txt", "pixels.txt"]);
    let text = output(ENGINE, &mut simulation, true)?;
    let simulate_ns = begin.elapsed().as_nanos() as u64;
    let pixels = read_pixels(ENGINE, &scratch.join("pixels.txt"))?;
    Ok(Run {
        pixels,
        simulate_ns,
        build_ns,
        build_cached,
        ..read_verdict(ENGINE, &text)?
    })
}
