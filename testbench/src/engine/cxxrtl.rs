//! CXXRTL: Yosys writes the design as one C++ class, the generated main program is compiled around it. Builds are kept
//! by content; one for speed, and one with all signals visible for waveforms.

use super::process::{output, replay, rtl_paths, unpack};
use super::{Engine, EngineError, Run, Wave};
use crate::cache::{entry, key, Wanted};
use shadegate_gen::package::PackageFile;
use shadegate_gen::simulators::cxxrtl_main;
use shadegate_gen::vectors::Trace;
use shadegate_gen::write::write_file;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

const ENGINE: Engine = Engine::Cxxrtl;

/// How the model and the program around it are built. `-O2` makes a faster program than `-O3` here.
struct Recipe {
    script: String,
    options: &'static [&'static str],
    main: String,
}

impl Recipe {
    fn new(trace: &Trace, package: &[PackageFile], visible: bool) -> Self {
        let sources = rtl_paths(package).collect::<Vec<_>>().join(" ");
        let debug = if visible { "-g4" } else { "-g0" };
        let top = format!("{}_core", trace.core.module());
        Self {
            script: format!(
                "read_verilog {sources}; hierarchy -check -top {top}; write_cxxrtl {debug} core.cpp"
            ),
            options: if visible {
                &["-std=c++17", "-O1", "-DSHADEGATE_WAVE"]
            } else {
                &["-std=c++17", "-O2"]
            },
            main: cxxrtl_main(&trace.core),
        }
    }

    fn build(&self, scratch: &Path, into: &Path) -> Result<(), EngineError> {
        let mut yosys = Command::new("yosys");
        yosys.current_dir(scratch).args(["-q", "-p", &self.script]);
        output(ENGINE, &mut yosys, false)?;
        let main = scratch.join("main_cxxrtl.cpp");
        write_file(&main, self.main.as_bytes()).map_err(failed)?;
        let data = output(ENGINE, Command::new("yosys-config").arg("--datdir"), false)?;
        let headers = Path::new(data.trim()).join("include");
        let mut compile = Command::new("g++");
        compile.current_dir(scratch).args(self.options);
        compile.arg("-I").arg(headers).arg("main_cxxrtl.cpp");
        let binary = into.join("simulation");
        compile
            .arg("-o")
            .arg(std::path::absolute(&binary).unwrap_or(binary));
        output(ENGINE, &mut compile, false)?;
        Ok(())
    }
}

fn failed(e: impl std::fmt::Display) -> EngineError {
    EngineError::Failed {
        engine: ENGINE,
        what: e.to_string(),
    }
}

/// Arguments of a run that writes a waveform.
fn wave_arguments(wave: &Wave, trace: &Trace) -> Result<Vec<String>, EngineError> {
    let clocks = trace.clocks.len() as u64;
    if wave.from >= clocks {
        return Err(EngineError::Unsupported {
            engine: ENGINE,
            what: format!(
                "has no clock to show from {} on: the run has {clocks} clocks",
                wave.from
            ),
        });
    }
    let file = std::path::absolute(&wave.file).unwrap_or_else(|_| wave.file.clone());
    let file = file.into_os_string().into_string();
    let file = file.map_err(|f| failed(format!("{}: not a name in UTF-8", f.display())))?;
    Ok(vec![file, wave.from.to_string(), wave.to.to_string()])
}

/// Builds (or finds) the binary and runs it.
pub fn run(
    trace: &Trace,
    package: &[PackageFile],
    scratch: &Path,
    wave: Option<&Wave>,
) -> Result<Run, EngineError> {
    let arguments = match wave {
        Some(w) => wave_arguments(w, trace)?,
        None => vec![],
    };
    unpack(ENGINE, package, scratch)?;
    let begin = Instant::now();
    let recipe = Recipe::new(trace, package, wave.is_some());
    let yosys = output(ENGINE, Command::new("yosys").arg("-V"), false)?;
    let compiler = output(ENGINE, Command::new("g++").arg("--version"), false)?;
    let fixed = [&yosys, &compiler, &recipe.script, &recipe.main].map(String::as_str);
    let sources = package.iter().filter(|f| f.path.starts_with("rtl/"));
    let sources = sources.flat_map(|f| [f.path.as_str(), f.text.as_str()]);
    let options = recipe.options.iter().copied();
    let key = key(fixed.into_iter().chain(options).chain(sources));
    let wanted = Wanted {
        kind: "cxxrtl",
        key: &key,
        keep: true,
    };
    let built = entry(wanted, scratch, failed, |into| recipe.build(scratch, into))?;
    let build_ns = begin.elapsed().as_nanos() as u64;
    let binary = built.directory.join("simulation");
    Ok(Run {
        build_ns: if built.cached { 0 } else { build_ns },
        build_cached: built.cached,
        ..replay(ENGINE, &binary, scratch, &arguments)?
    })
}
