//! `shadegate render`: a software frame, with its time and its error.

use crate::args::Global;
use crate::measures::{duration, error_json, error_text};
use crate::names::{antialiasing, method, methods, Offer};
use crate::outcome::{Failure, Outcome, Report};
use crate::progress::Progress;
use crate::{frames, output, size};
use clap::Args;
use serde_json::{json, Value};
use shadegate_reference::animation::Player;
use shadegate_reference::antialias::{self, Antialias};
use shadegate_reference::sample::{self, Filter, Wanted, SAMPLE_LIMIT};
use shadegate_reference::{scene, supported, with_threads};
use shadegate_reference::{Frame, Method, Prepared, RenderOptions, Skips};
use shadegate_testbench::compare::{compare, save_png, Comparison, Rgb8Ref};
use std::fmt::Write;
use std::path::PathBuf;
use std::time::Instant;

/// More threads than this are a slip of the keyboard.
const THREADS: usize = 1024;

/// Arguments of `render`.
#[derive(Debug, Args)]
pub struct RenderArgs {
    /// Scene file
    scene: PathBuf,
    /// Shading method [default: the scene's]
    #[arg(long, value_parser = Offer(methods))]
    method: Option<String>,
    /// Frame size [default: the scene's]
    #[arg(long, value_name = "WxH")]
    size: Option<String>,
    /// Threads [default: as many as there are processors]
    #[arg(long, value_name = "N")]
    threads: Option<String>,
    /// Picture to write [default: <SCENE>-<METHOD>.png in the current directory]
    #[arg(short, long, value_name = "FILE.png")]
    output: Option<PathBuf>,
    /// Method to measure the error against, anti-aliased likewise; `exact` is the truth
    #[arg(long, value_parser = Offer(methods), value_name = "METHOD")]
    against: Option<String>,
    /// Largest error of method `auto`, in 255ths of full scale, beside the rounding to a byte [default: 1]
    #[arg(long, value_name = "LSB")]
    max_error: Option<String>,
    /// Samples in each direction of a pixel, 1 to 16 [default: the scene's]
    #[arg(long, value_name = "N")]
    samples: Option<String>,
    /// How samples are weighted: box or tent [default: the scene's]
    #[arg(long, value_name = "FILTER")]
    filter: Option<String>,
    /// Frame of an animated scene, from 0
    #[arg(long, value_name = "K", default_value = "0", hide_default_value = true)]
    frame: String,
    /// Draw all frames of an animated scene: FILE-0000.png and so on
    #[arg(long, conflicts_with_all = ["frame", "against"])]
    frames: bool,
    /// Anti-aliasing of the edges of polygons [default: the scene's]
    #[arg(long, value_parser = Offer(antialiasing), value_name = "NAME")]
    antialias: Option<String>,
    /// Skips to switch off, separated by commas, or all; `shadegate list skips` names them
    #[arg(long, value_name = "LIST")]
    no_skip: Option<String>,
}

/// A frame, or several, and all that is known about them.
struct Drawn {
    work: sample::Drawn,
    method: Method,
    sampling: (u32, Filter),
    antialias: Antialias,
    total_ns: u64,
    error: Option<(Method, Comparison)>,
    numbers: Vec<u32>,
    /// Frames of the scene.
    count: u32,
    files: Vec<PathBuf>,
}

/// Runs the command.
pub fn run(a: &RenderArgs, global: Global) -> Outcome {
    let wanted = a.method.as_deref().map(method).transpose()?;
    let against = a.against.as_deref().map(method).transpose()?;
    let antialias = a
        .antialias
        .as_deref()
        .map(str::parse)
        .transpose()
        .map_err(Failure::input)?;
    let size = a.size.as_deref().map(size::parse).transpose()?;
    let threads = a.threads.as_deref().map(parse_threads).transpose()?;
    let max_error = a.max_error.as_deref().map(parse_error).transpose()?;
    let samples = a.samples.as_deref().map(parse_samples).transpose()?;
    let filter = a.filter.as_deref().map(str::parse::<Filter>).transpose();
    let filter = filter.map_err(Failure::input)?;
    let skips = Skips::without(a.no_skip.as_deref().unwrap_or("")).map_err(Failure::input)?;
    if let Some(file) = &a.output {
        output::file(file, "png")?;
        output::not_over(file, &a.scene)?;
    }
    let progress = Progress::new("reading the scene", global);
    let scene = scene::load(&a.scene).map_err(Failure::input)?;
    let method = wanted.unwrap_or(scene.render.method);
    let count = scene.animation.as_ref().map_or(1, |a| a.frames);
    let numbers = if a.frames {
        (0..count).collect()
    } else {
        vec![frames::number(&a.frame, count)?]
    };
    if max_error.is_some() && method != Method::Auto {
        return Err(Failure::input(format!(
            "max-error is a wish to method 'auto', not to '{method}'; expected --method auto with it"
        )));
    }
    let base = match &a.output {
        Some(file) => file.clone(),
        None => PathBuf::from(format!("{}-{method}.png", scene.name)),
    };
    let files: Vec<PathBuf> = match numbers.as_slice() {
        [k] if !a.frames && (a.output.is_some() || count == 1 || *k == 0) => vec![base],
        many => many.iter().map(|k| frames::file(&base, *k)).collect(),
    };
    for file in &files {
        output::file(file, "png")?;
    }
    let wanted = Wanted {
        size,
        method,
        samples: samples.unwrap_or(scene.render.samples),
        filter: filter.unwrap_or(scene.render.filter),
        antialias: antialias.unwrap_or(scene.render.antialias),
        options: RenderOptions {
            threads,
            skips,
            max_error: max_error.unwrap_or(RenderOptions::default().max_error),
            ..RenderOptions::default()
        },
    };
    let first = with_threads(threads, || Prepared::new(&scene, size, &skips));
    let first = first.map_err(Failure::input)?;
    for m in against.into_iter().chain([method]) {
        supported(&first, m).map_err(Failure::input)?;
        antialias::supported(m, wanted.antialias).map_err(Failure::input)?;
    }
    let name = scene.name.clone();
    let mut player = Player::new(scene);
    let mut done: Option<sample::Drawn> = None;
    let mut total_ns = 0;
    for (k, file) in numbers.iter().zip(&files) {
        progress.say(format!("drawing {name} with {method}: {}", file.display()));
        let begin = Instant::now();
        let drawn = sample::draw(&mut player, *k, &wanted).map_err(Failure::input)?;
        total_ns += nanoseconds(begin);
        save_png(file, view(&drawn.frame)?).map_err(Failure::input)?;
        match &mut done {
            Some(before) => before.follow(drawn),
            None => done = Some(drawn),
        }
    }
    // There is at least one frame.
    let work = done.ok_or_else(|| Failure::input("there is no frame to draw"))?;
    let error = match against {
        None => None,
        Some(m) => {
            progress.say(format!("comparing with {m}"));
            let other = Wanted {
                method: m,
                ..wanted
            };
            let truth = sample::draw(&mut player, numbers[0], &other).map_err(Failure::input)?;
            let apart = compare(view(&truth.frame)?, view(&work.frame)?).map_err(Failure::input)?;
            Some((m, apart))
        }
    };
    drop(progress);
    let drawn = Drawn {
        work,
        method,
        sampling: (wanted.samples, wanted.filter),
        antialias: wanted.antialias,
        total_ns,
        error,
        numbers,
        count,
        files,
    };
    let text = if global.quiet {
        String::new()
    } else {
        drawn.text(global.verbose)
    };
    Ok(Report::done(text, drawn.json(a.frames)))
}

fn parse_samples(text: &str) -> Result<u32, Failure> {
    let n = text.parse().ok().filter(|n| (1..=SAMPLE_LIMIT).contains(n));
    n.ok_or_else(|| {
        Failure::input(format!(
            "samples '{text}' cannot be used; expected a number from 1 to {SAMPLE_LIMIT}"
        ))
    })
}

fn parse_threads(text: &str) -> Result<usize, Failure> {
    let n = text.parse().ok().filter(|n| (1..=THREADS).contains(n));
    n.ok_or_else(|| {
        Failure::input(format!(
            "threads '{text}' cannot be used; expected a number from 1 to {THREADS}"
        ))
    })
}

/// A largest error that was typed.
///
/// # Errors
/// What is not a number from 0 to 255.
pub fn parse_error(text: &str) -> Result<f64, Failure> {
    let e = text.parse().ok().filter(|e| (0.0..=255.0).contains(e));
    e.ok_or_else(|| {
        Failure::input(format!(
            "max-error '{text}' cannot be used; expected a number from 0 to 255, in 255ths of full scale"
        ))
    })
}

fn view(f: &Frame) -> Result<Rgb8Ref<'_>, Failure> {
    Rgb8Ref::new(f.width, f.height, &f.pixels).map_err(Failure::input)
}

fn nanoseconds(since: Instant) -> u64 {
    u64::try_from(since.elapsed().as_nanos()).unwrap_or(u64::MAX)
}

impl Drawn {
    fn setup_ns(&self) -> u64 {
        self.work.prepare_ns + self.work.stats.setup_ns
    }

    fn json(&self, all: bool) -> Value {
        let (p, s, frame) = (&self.work.prepared, &self.work.stats, &self.work.frame);
        let name = |f: &PathBuf| f.to_string_lossy().into_owned();
        let mut json = json!({
            "scene": p.scene_name,
            "method": self.method.name(),
            "width": frame.width,
            "height": frame.height,
            "antialias": self.antialias.name(),
            "samples": self.sampling.0,
            "filter": self.sampling.1.name(),
            "frame": self.numbers.last(),
            "subframes": self.work.subframes,
            "triangles": {
                "in": p.counts.in_,
                "culled": p.counts.culled,
                "clipped": p.counts.clipped,
                "drawn": p.counts.drawn,
            },
            "edges": p.wires.edges.len(),
            "pixels": {
                "tested": s.pixels_tested,
                "shaded": s.pixels_shaded,
                "written": s.pixels_written,
            },
            "skipped": s.skipped,
            "time_ns": { "setup": self.setup_ns(), "raster": s.raster_ns, "total": self.total_ns },
            "threads": s.threads,
            "output": self.files.last().map(name),
        });
        if all {
            json["outputs"] = self.files.iter().map(name).collect();
        }
        if let Some((against, c)) = &self.error {
            let mut error = error_json(c);
            error["against"] = against.name().into();
            json["error"] = error;
        }
        json
    }

    /// Which frames, where there are several.
    fn which(&self) -> String {
        match self.numbers.as_slice() {
            _ if self.count == 1 => String::new(),
            [k] => format!(", frame {k} of {}", self.count),
            many => format!(", {} frames", many.len()),
        }
    }

    fn text(&self, verbose: bool) -> String {
        let (p, s, frame) = (&self.work.prepared, &self.work.stats, &self.work.frame);
        let n = &p.counts;
        let mut out = format!(
            "{}: {}x{}, {}{}",
            p.scene_name,
            frame.width,
            frame.height,
            self.method,
            self.which()
        );
        if self.antialias != Antialias::None {
            let _ = write!(out, ", anti-aliased by {}", self.antialias);
        }
        out += "\n";
        let threads = match s.threads {
            1 => "1 thread".to_owned(),
            n => format!("{n} threads"),
        };
        let (samples, filter) = (self.sampling.0, self.sampling.1.name());
        let subframes = self.work.subframes;
        if samples > 1 || subframes as usize > self.numbers.len() {
            // Writing to a string cannot fail.
            let _ = writeln!(
                out,
                "samples    {samples}x{samples}, {filter}; {subframes} sub-frames"
            );
        }
        let _ = writeln!(
            out,
            "triangles  {} in, {} culled, {} clipped, {} drawn\n\
             pixels     {} tested, {} shaded, {} written\n\
             time       {} (set-up {}, raster {}), {threads}",
            n.in_,
            n.culled,
            n.clipped,
            n.drawn,
            s.pixels_tested,
            s.pixels_shaded,
            s.pixels_written,
            duration(self.total_ns),
            duration(self.setup_ns()),
            duration(s.raster_ns),
        );
        if !p.wires.is_empty() {
            let _ = writeln!(
                out,
                "edges      {} drawn by {}",
                p.wires.edges.len(),
                p.wires.filter
            );
        }
        if verbose {
            out += "skipped\n";
            for (reason, count) in &s.skipped {
                let _ = writeln!(out, "  {reason:<12}  {count}");
            }
        }
        if let Some((against, c)) = &self.error {
            let _ = write!(out, "error against {against}\n{}", error_text(c));
        }
        for file in &self.files {
            let _ = writeln!(out, "wrote {}", file.display());
        }
        out
    }
}
