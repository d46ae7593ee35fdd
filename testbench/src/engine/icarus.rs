//! Icarus Verilog: the generated Verilog test bench under `vvp`.

use super::process::{output, read_pixels, read_verdict, rtl_paths, unpack};
use super::{Engine, EngineError, Run, Wave};
use shadegate_gen::package::PackageFile;
use shadegate_gen::vectors::Trace;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

const ENGINE: Engine = Engine::Icarus;

/// Compiles and runs the test bench.
pub fn run(
    trace: &Trace,
    package: &[PackageFile],
    scratch: &Path,
    wave: Option<&Wave>,
) -> Result<Run, EngineError> {
    unpack(ENGINE, package, scratch)?;
    let core = trace.core.module();
    let begin = Instant::now();
    let mut compile = Command::new("iverilog");
    compile
        .current_dir(scratch)
        .args(["-g2001", "-o", "simulation"]);
    compile.args(rtl_paths(package));
    compile.arg(format!("sim/tb_{core}_core.v"));
    output(ENGINE, &mut compile, false)?;
    let build_ns = begin.elapsed().as_nanos() as u64;
    let begin = Instant::now();
    let mut vvp = Command::new("vvp");
    vvp.current_dir(scratch).args([
        "-N",
        "simulation",
        "+vectors=sim/vectors.txt",
        "+pixels=pixels.txt",
    ]);
    if let Some(w) = wave {
        let file = std::path::absolute(&w.file).unwrap_or_else(|_| w.file.clone());
        vvp.arg(format!("+wave={}", file.display()))
            .arg(format!("+from={}", w.from))
            .arg(format!("+to={}", w.to.min(i32::MAX as u64)));
    }
    let text = output(ENGINE, &mut vvp, true)?;
    let simulate_ns = begin.elapsed().as_nanos() as u64;
    let pixels = read_pixels(ENGINE, &scratch.join("pixels.txt"))?;
    Ok(Run {
        pixels,
        simulate_ns,
        build_ns,
        ..read_verdict(ENGINE, &text)?
    })
}
