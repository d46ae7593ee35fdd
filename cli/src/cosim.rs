//! `shadegate cosim`: a core draws a scene in simulation, and every pixel is checked.

use crate::args::Global;
use crate::measures::duration;
use crate::names::{
    all_cores, check_names, cores, depth_formats, drawing_of, engines, set_up, set_ups, Drawing,
    Offer,
};
use crate::outcome::{Exit, Failure, Outcome, Report};
use crate::progress::Progress;
use crate::{output, size};
use anstyle::{AnsiColor, Style};
use clap::Args;
use serde_json::Value;
use shadegate_gen::package::PackageError;
use shadegate_gen::scene::{DepthFormat, SetUp};
use shadegate_gen::stimulus::StimulusOptions;
use shadegate_reference::scene;
use shadegate_testbench::cosim::{cosim_by, CosimError, CosimOptions, CosimReport, ErrorReport};
use shadegate_testbench::engine::{Engine, EngineError, Wave};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Arguments of `cosim`.
#[derive(Debug, Args)]
#[command(
    after_help = "Exit codes: 0 every check holds; 1 some pixel is not the expected one; 2 bad input; \
                  3 the engine is missing or failed."
)]
pub struct CosimArgs {
    /// Scene file
    scene: PathBuf,
    /// Shading method or filter of lines, one that has a core [default: the scene's]
    #[arg(long, value_parser = Offer(cores))]
    method: Option<String>,
    /// Core [default: the one of the method]
    #[arg(long, value_parser = Offer(all_cores))]
    core: Option<String>,
    /// Who sets triangles up: the host, or an engine in front of the core [default: host]
    #[arg(long, value_parser = Offer(set_ups), value_name = "BY")]
    set_up: Option<String>,
    /// What simulates: compiled the netlist, rust-hdl the description itself, the others the emitted Verilog
    #[arg(long, value_parser = Offer(engines), default_value = "compiled")]
    engine: String,
    /// Waveform to write; the compiled engine also writes FILE.fst
    #[arg(long, value_name = "FILE.vcd")]
    wave: Option<PathBuf>,
    /// Signals of the waveform: names of signals or instances, or patterns with * and ? [default: all]
    #[arg(long, value_name = "PATTERN", requires = "wave", value_delimiter = ',')]
    signals: Vec<String>,
    /// First clock of the waveform [default: 0]
    #[arg(long, value_name = "CYC", requires = "wave")]
    from: Option<String>,
    /// Clock at which the waveform ends [default: the last]
    #[arg(long, value_name = "CYC", requires = "wave")]
    to: Option<String>,
    /// Frame size [default: the scene's]
    #[arg(long, value_name = "WxH")]
    size: Option<String>,
    /// Register words that the core takes per clock: 1, 2 or 4 [default: 2 in cores that follow spans, 1 in others]
    #[arg(long, value_name = "W")]
    load_words: Option<usize>,
    /// Write every register word, also where the register holds it already
    #[arg(long)]
    all_words: bool,
    /// What depth words are linear in: 1/z, exact on the screen, or z, evenly spread over the scene
    #[arg(long, value_name = "FORMAT", value_parser = Offer(depth_formats))]
    depth: Option<String>,
    /// Folder for frames, Verilog and reports; made if it is missing [default: out/<scene>-<method>-<engine>]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// Runs the command.
pub fn run(a: &CosimArgs, global: Global) -> Outcome {
    let engine: Engine = a.engine.parse().map_err(Failure::input)?;
    // The names are checked before the scene is read; the scene's own method only matters without them.
    check_names(a.method.as_deref(), a.core.as_deref())?;
    let by = set_up(a.set_up.as_deref(), a.core.as_deref())?;
    let size = a.size.as_deref().map(size::parse).transpose()?;
    let depth = a.depth.as_deref().map(str::parse::<DepthFormat>);
    let depth = depth.transpose().map_err(Failure::input)?;
    let wave = wave(a, engine)?;
    a.output.as_deref().map(output::folder).transpose()?;
    let progress = Progress::new("reading the scene", global);
    let mut scene = scene::load(&a.scene).map_err(Failure::input)?;
    let drawing = drawing_of(a.method.as_deref(), a.core.as_deref(), &mut scene)?;
    if depth.is_some() && matches!(drawing, Drawing::Lines(_)) {
        return Err(Failure::input(
            "--depth is for triangles; lines are drawn without a depth test",
        ));
    }
    let name = drawing.name();
    let suffix = match by {
        SetUp::Host => "",
        SetUp::Engine => "-engine",
    };
    progress.say(format!("{name} draws {} in {engine}", scene.name));
    let folder = a.output.clone().unwrap_or_else(|| {
        Path::new("out").join(format!("{}-{name}{suffix}-{engine}", scene.name))
    });
    let options = CosimOptions {
        method: match drawing {
            Drawing::Shaded(method) => method,
            Drawing::Lines(_) | Drawing::Core(_) => scene.render.method,
        },
        engine,
        size,
        wave,
        output: Some(folder.clone()),
        stimulus: StimulusOptions {
            skip_unchanged: !a.all_words,
            load_words: a.load_words,
            depth: depth.unwrap_or_default(),
            ..StimulusOptions::default()
        },
        command: command(a, name, by, engine, size),
    };
    let report = cosim_by(&scene, &options, by).map_err(failure)?;
    drop(progress);
    let exit = if report.holds() {
        Exit::Done
    } else {
        Exit::CheckFailed
    };
    let text = if global.quiet {
        String::new()
    } else {
        text(&report, a.wave.as_deref(), &folder, global.verbose)
    };
    let json = serde_json::to_value(&report).unwrap_or(Value::Null);
    Ok(Report { text, json, exit })
}

fn wave(a: &CosimArgs, engine: Engine) -> Result<Option<Wave>, Failure> {
    let clock = |name: &str, text: &str| {
        let number = text.parse::<u64>().ok();
        number.ok_or_else(|| {
            Failure::input(format!(
                "--{name} '{text}' is not a clock; expected a whole number from 0"
            ))
        })
    };
    let from = a.from.as_deref().map(|t| clock("from", t)).transpose()?;
    let to = a.to.as_deref().map(|t| clock("to", t)).transpose()?;
    let Some(file) = &a.wave else {
        return Ok(None);
    };
    let endings: &[&str] = match engine {
        Engine::Compiled => &["vcd", "fst"],
        _ if a.signals.is_empty() => &["vcd"],
        _ => {
            return Err(Failure::input(format!(
                "engine {engine} shows all signals; use --engine compiled for --signals"
            )))
        }
    };
    output::file_of(file, endings)?;
    let (from, to) = (from.unwrap_or(0), to.unwrap_or(u64::from(u32::MAX)));
    if from >= to {
        return Err(Failure::input(format!(
            "the waveform from clock {from} to clock {to} is empty; expected --from below --to"
        )));
    }
    Ok(Some(Wave {
        file: file.clone(),
        from,
        to,
        signals: a.signals.clone(),
    }))
}

/// The command that does this again.
fn command(
    a: &CosimArgs,
    method: &str,
    by: SetUp,
    engine: Engine,
    size: Option<(u32, u32)>,
) -> String {
    let scene = a.scene.to_string_lossy();
    let plain = |c: char| c.is_ascii_alphanumeric() || "/._-".contains(c);
    let scene = if scene.chars().all(plain) {
        scene.into_owned()
    } else {
        format!("'{}'", scene.replace('\'', r"'\''"))
    };
    let size = size.map(|(w, h)| format!(" --size {w}x{h}"));
    let lanes = a.load_words.map(|words| format!(" --load-words {words}"));
    let all = a.all_words.then_some(" --all-words");
    let depth = a.depth.as_ref().map(|d| format!(" --depth {d}"));
    let by = match by {
        SetUp::Host => "",
        SetUp::Engine => " --set-up engine",
    };
    let more = [size, lanes, all.map(str::to_owned), depth];
    let more: String = more.into_iter().flatten().collect();
    format!("shadegate cosim {scene} --method {method}{by} --engine {engine}{more}")
}

/// Whose fault it is.
pub fn failure(e: CosimError) -> Failure {
    match e {
        CosimError::Engine(EngineError::Missing { .. } | EngineError::Failed { .. }) => {
            Failure::tool(e)
        }
        CosimError::Package(PackageError::Constraints(_) | PackageError::LoadWords(_)) => {
            Failure::input(e)
        }
        CosimError::Package(_) => Failure::tool(e),
        _ => Failure::input(e),
    }
}

fn text(r: &CosimReport, wave: Option<&Path>, folder: &Path, verbose: bool) -> String {
    let mut out = format!(
        "{}: {}x{}, {} core, {}\n",
        r.scene, r.width, r.height, r.core, r.engine
    );
    let colour = if r.holds() {
        AnsiColor::Green
    } else {
        AnsiColor::Red
    };
    let style = Style::new().bold().fg_color(Some(colour.into()));
    let verdict = match r.mismatches {
        0 => "no mismatch".to_owned(),
        1 => "1 mismatch".to_owned(),
        n => format!("{n} mismatches"),
    };
    // Writing to a string cannot fail.
    let _ = writeln!(
        out,
        "{style}{verdict}{style:#} in {} pixels and {} clocks ({:.3} pixels per clock)",
        r.pixels, r.cycles, r.pixels_per_cycle
    );
    let spent = &r.clocks;
    let part = |clocks: u64| 100.0 * clocks as f64 / r.cycles.max(1) as f64;
    let _ = writeln!(
        out,
        "clocks     {} drawing ({:.1} %), {} loading ({:.1} %), {} waiting ({:.1} %){}",
        spent.drawing,
        part(spent.drawing),
        spent.loading,
        part(spent.loading),
        spent.waiting,
        part(spent.waiting),
        match r.load_words {
            1 => String::new(),
            words => format!(", {words} register words per clock"),
        }
    );
    if let Some(m) = &r.first_mismatch {
        let _ = writeln!(
            out,
            "first mismatch in clock {}, pixel {},{}: {} is {}, expected {}\n  {}",
            m.cycle, m.pixel.0, m.pixel.1, m.signal, m.got, m.expected, m.reproduce
        );
    }
    let error = |e: &ErrorReport| {
        let psnr = e
            .psnr_db
            .map_or("infinite".to_owned(), |p| format!("{p:.2} dB"));
        format!(
            "max {} LSB, RMS {:.4} LSB, PSNR {psnr}, FLIP {:.6}",
            e.max_lsb, e.rms_lsb, e.flip_mean
        )
    };
    let _ =
        writeln!(
        out,
        "error      {}\narithmetic max {} LSB, RMS {:.4} LSB\nspeed      {:.0} clocks per second{}",
        error(&r.error),
        r.arithmetic.get("max_lsb").unwrap_or(&0.0),
        r.arithmetic.get("rms_lsb").unwrap_or(&0.0),
        r.cycles_per_second,
        // In this process both are one.
        r.loop_cycles_per_second
            .filter(|_| r.time_ns.simulate_loop != Some(r.time_ns.simulate))
            .map_or(String::new(), |l| format!(" with its files, {l:.0} without"))
    );
    if verbose {
        let t = &r.time_ns;
        let _ = writeln!(
            out,
            "time       set-up {}, emit {}, build {}, simulate {}, compare {}\n\
             host       {} {} in {} writes\n\
             method     {} against {} in f64",
            duration(t.setup),
            duration(t.emit),
            duration(t.build),
            duration(t.simulate),
            duration(t.compare),
            r.host.triangles,
            if r.host.skipped.contains_key("unseen-lines") {
                "pieces of lines"
            } else {
                "triangles"
            },
            r.host.writes,
            error(&r.method_f64),
            r.method
        );
    }
    for path in wave.into_iter().chain([folder]) {
        let _ = writeln!(out, "wrote {}", path.display());
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    #[derive(Parser)]
    struct Only {
        #[command(flatten)]
        args: CosimArgs,
    }

    #[test]
    fn the_command_can_be_pasted() {
        let again = |scene: &str, more: &[&str]| {
            let words = ["cosim", scene].into_iter().chain(more.iter().copied());
            let a = Only::parse_from(words).args;
            command(&a, "gouraud", SetUp::Host, Engine::Icarus, Some((8, 6)))
        };
        assert_eq!(
            again("scenes/a.toml", &[]),
            "shadegate cosim scenes/a.toml --method gouraud --engine icarus --size 8x6"
        );
        assert!(
            again("my scene's.toml", &[]).starts_with(r"shadegate cosim 'my scene'\''s.toml' --m")
        );
        assert!(again("a.toml", &["--load-words", "4", "--all-words"])
            .ends_with(" --load-words 4 --all-words"));
    }
}
