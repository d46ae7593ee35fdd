//! `shadegate gen`: a core as a folder that builds and checks itself.

use crate::args::Global;
use crate::cosim::failure;
use crate::names::{
    all_cores, boards, check_names, cores, devices, drawing, drawing_of, set_up, set_ups, wrappers,
    Drawing, Offer,
};
use crate::outcome::{Failure, Outcome, Report};
use crate::progress::Progress;
use crate::{output, size};
use clap::Args;
use serde_json::Value;
use shadegate_constraints::{board, device};
use shadegate_gen::package::{package_with, rtl_with, Options, Package, Target};
use shadegate_gen::scene::SetUp;
use shadegate_gen::stimulus::{sample as sample_stimulus, StimulusOptions};
use shadegate_gen::vectors::Trace;
use shadegate_gen::wrapper::Wrapper;
use shadegate_gen::write::write_file;
use shadegate_reference::raster::Viewport;
use shadegate_reference::scene;
use shadegate_testbench::cosim::{prelude_by, CosimError};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Clock period of the constraints: 100 MHz.
const PERIOD_NS: f64 = 10.0;
/// Frame of a core that is generated without a scene.
const FRAME: (u32, u32) = (320, 240);
/// Triangles of its vectors, and the seed they come from.
const SAMPLE: (usize, u64) = (24, 1);

/// Arguments of `gen`.
#[derive(Debug, Args)]
#[command(group(clap::ArgGroup::new("what").required(true).args(["core", "scene"])))]
#[command(group(clap::ArgGroup::new("place").args(["target", "board"])))]
pub struct GenArgs {
    /// Core
    #[arg(value_parser = Offer(all_cores))]
    core: Option<String>,
    /// Scene that the core is to draw: its frame size, its method, its vectors
    #[arg(long, value_name = "FILE")]
    scene: Option<PathBuf>,
    /// Device to write constraints for
    #[arg(long, value_parser = Offer(devices), value_name = "DEVICE")]
    target: Option<String>,
    /// Board to write constraints for, pins included
    #[arg(long, value_parser = Offer(boards), value_name = "BOARD")]
    board: Option<String>,
    /// Shading method, one that has a core [default: the scene's]
    #[arg(long, value_parser = Offer(cores), requires = "scene")]
    method: Option<String>,
    /// Who sets triangles up: the host, or an engine in front of the core [default: host]
    #[arg(long, value_parser = Offer(set_ups), value_name = "BY")]
    set_up: Option<String>,
    /// Frame size [default: the scene's, or 320x240]
    #[arg(long, value_name = "WxH")]
    size: Option<String>,
    /// Bus wrappers to add; may be repeated, or a list with commas
    #[arg(long, value_parser = Offer(wrappers), value_delimiter = ',', value_name = "BUS")]
    wrapper: Vec<String>,
    /// Register words that the core takes per clock: 1, 2 or 4 [default: 2 in cores that follow spans, 1 in others, and 1
    /// behind a bus]
    #[arg(long, value_name = "W")]
    load_words: Option<usize>,
    /// Give every register a synchronous reset, active high
    #[arg(long)]
    reset: bool,
    /// Clock period in nanoseconds, for the constraints [default: 10]
    #[arg(long, value_name = "NS", requires = "place")]
    period: Option<String>,
    /// Folder to fill; made if it is missing [default: <CORE>-core, or <SCENE>-<CORE>-core]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// Runs the command.
pub fn run(a: &GenArgs, global: Global) -> Outcome {
    let target = target(a)?;
    let wrappers = (a.wrapper.iter())
        .map(|name| name.parse::<Wrapper>().map_err(Failure::input))
        .collect::<Result<Vec<_>, _>>()?;
    let options = Options {
        target,
        wrappers: &wrappers,
    };
    let by = set_up(a.set_up.as_deref(), a.core.as_deref())?;
    let size = a.size.as_deref().map(size::parse).transpose()?;
    a.output.as_deref().map(output::folder).transpose()?;
    let progress = Progress::new("generating", global);
    let (package, name) = match (&a.scene, &a.core) {
        (Some(file), _) => of_scene(file, a, by, size, &options)?,
        (None, Some(name)) if name.ends_with(".toml") => {
            return Err(Failure::input(format!(
                "'{name}' is not a core; for a scene: shadegate gen --scene {name}"
            )));
        }
        (None, Some(name)) => {
            let frame = size.unwrap_or(FRAME);
            let drawing = drawing(name)?;
            let package = sample(drawing, by, frame, &options, a)?;
            let name = match by {
                SetUp::Host => name,
                SetUp::Engine => &package.manifest.core,
            };
            let folder = format!("{name}-core");
            (package, folder)
        }
        // clap demands one of them.
        (None, None) => return Err(Failure::input("expected a core or --scene FILE")),
    };
    let folder = match &a.output {
        Some(folder) => folder.clone(),
        None => {
            let folder = PathBuf::from(name);
            output::folder(&folder)?;
            folder
        }
    };
    for f in &package.files {
        write_file(&folder.join(&f.path), f.text.as_bytes()).map_err(Failure::input)?;
    }
    drop(progress);
    let text = if global.quiet {
        String::new()
    } else {
        text(&package, &folder, global.verbose)
    };
    let mut json = serde_json::to_value(&package.manifest).unwrap_or(Value::Null);
    if let Some(object) = json.as_object_mut() {
        object.insert("output".into(), folder.to_string_lossy().into());
    }
    Ok(Report::done(text, json))
}

fn period(text: &str) -> Result<f64, Failure> {
    let fits = |p: &f64| (0.1..=1e6).contains(p);
    text.parse().ok().filter(fits).ok_or_else(|| {
        Failure::input(format!(
            "period '{text}' cannot be kept; expected 0.1 to 1000000 nanoseconds"
        ))
    })
}

fn target(a: &GenArgs) -> Result<Option<Target<'static>>, Failure> {
    let period_ns = a.period.as_deref().map_or(Ok(PERIOD_NS), period)?;
    let board = a
        .board
        .as_deref()
        .map(board)
        .transpose()
        .map_err(Failure::input)?;
    let name = board.map(|b| b.device.as_str()).or(a.target.as_deref());
    let device = name.map(device).transpose().map_err(Failure::input)?;
    Ok(device.map(|device| Target {
        device,
        board,
        period_ns,
    }))
}

/// The load port that is asked for, and that of a bus where none is.
fn load_words(a: &GenArgs) -> Option<usize> {
    let bus = (!a.wrapper.is_empty()).then_some(1);
    a.load_words.or(bus)
}

/// A core that draws a scene, with the scene's vectors; and the name of its folder.
fn of_scene(
    file: &Path,
    a: &GenArgs,
    by: SetUp,
    size: Option<(u32, u32)>,
    options: &Options,
) -> Result<(Package, String), Failure> {
    let method = a.method.as_deref();
    check_names(method, None)?;
    let mut scene = scene::load(file).map_err(Failure::input)?;
    let drawing = drawing_of(method, None, &mut scene)?;
    let method = match drawing {
        Drawing::Shaded(method) => method,
        Drawing::Lines(_) | Drawing::Core(_) => scene.render.method,
    };
    let stimulus = StimulusOptions {
        load_words: load_words(a),
        ..StimulusOptions::default()
    };
    let p = prelude_by(&scene, method, by, size, &stimulus).map_err(failure)?;
    let name = match by {
        SetUp::Host => drawing.name(),
        SetUp::Engine => p.trace.core.name(),
    };
    let name = format!("{}-{name}-core", scene.name);
    if options.target.is_none() && options.wrappers.is_empty() && !a.reset {
        return Ok((p.package, name));
    }
    let frame = (p.prepared.width, p.prepared.height);
    Ok((pack(&p.trace, frame, options, a.reset)?, name))
}

/// A core by itself, with vectors that exercise all of it.
fn sample(
    drawing: Drawing,
    by: SetUp,
    frame: (u32, u32),
    options: &Options,
    a: &GenArgs,
) -> Result<Package, Failure> {
    let (width, height) = frame;
    let core = drawing.core_by(by, width, height).map_err(failure)?;
    let words = load_words(a).unwrap_or(core.load_words);
    let core = core.with_load_words(words).map_err(Failure::input)?;
    let viewport = Viewport { width, height };
    let (count, seed) = SAMPLE;
    let stimulus = sample_stimulus(&core, viewport, count, seed)
        .map_err(|e| failure(CosimError::Stimulus(e)))?;
    let trace = Trace::record(core, &stimulus, |_| true);
    pack(&trace, frame, options, a.reset)
}

fn pack(
    trace: &Trace,
    frame: (u32, u32),
    options: &Options,
    reset: bool,
) -> Result<Package, Failure> {
    rtl_with(&trace.core, reset)
        .and_then(|rtl| package_with(&rtl, trace, frame, options))
        .map_err(|e| failure(CosimError::Package(e)))
}

fn text(p: &Package, folder: &Path, verbose: bool) -> String {
    let m = &p.manifest;
    let place = match (&m.target, &m.board) {
        (Some(part), Some(board)) => format!(", {part} on {board}"),
        (Some(part), None) => format!(", {part}"),
        _ => String::new(),
    };
    let mut out = format!("{} core, {}x{}{place}\n", m.core, m.frame.0, m.frame.1);
    let bits: Vec<String> = m
        .formats
        .iter()
        .map(|(name, f)| format!("{name} Q{}.{}", f.int, f.frac))
        .collect();
    // Writing to a string cannot fail.
    let _ = writeln!(
        out,
        "formats    {}\nlatency    {} clocks\nerror      at most {:.4} LSB before rounding\nmemory     {:.0} kbit for {}{}",
        bits.join(", "),
        m.latency,
        m.error_bound_lsb,
        m.block_ram.needed_kbit,
        if m.formats.contains_key("depth") {
            "depth"
        } else {
            "colours"
        },
        match (m.block_ram.available_kbit, m.block_ram.fits) {
            (Some(kbit), Some(false)) => format!(", but the device has {kbit} kbit of block RAM"),
            (Some(kbit), _) => format!(" of {kbit} kbit of block RAM"),
            _ => String::new(),
        }
    );
    if verbose {
        for f in &p.files {
            let _ = writeln!(out, "  {}", f.path);
        }
    }
    let _ = writeln!(out, "wrote {} files to {}", p.files.len(), folder.display());
    out
}
