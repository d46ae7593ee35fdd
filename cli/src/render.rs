//! `shadegate render`: a software frame, with its time and its error.

use crate::args::Global;
use crate::measures::{duration, error_json, error_text};
use crate::names::{antialiasing, method, methods, Offer};
use crate::outcome::{Failure, Outcome, Report};
use crate::progress::Progress;
use crate::{output, size};
use clap::Args;
use serde_json::{json, Value};
use shadegate_reference::antialias::{self, skips_for, Antialias};
use shadegate_reference::{scene, Frame, Method, Prepared, RenderOptions, RenderStats, Skips};
use shadegate_testbench::compare::{compare, save_png, Comparison, Rgb8Ref};
use std::fmt::Write;
use std::path::{Path, PathBuf};
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
    /// Anti-aliasing of the edges of polygons [default: the scene's]
    #[arg(long, value_parser = Offer(antialiasing), value_name = "NAME")]
    antialias: Option<String>,
    /// Skips to switch off, separated by commas, or all; `shadegate list skips` names them
    #[arg(long, value_name = "LIST")]
    no_skip: Option<String>,
}

/// A frame and all that is known about it.
struct Drawn {
    prepared: Prepared,
    method: Method,
    antialias: Antialias,
    stats: RenderStats,
    setup_ns: u64,
    total_ns: u64,
    error: Option<(Method, Comparison)>,
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
    let skips = Skips::without(a.no_skip.as_deref().unwrap_or("")).map_err(Failure::input)?;
    if let Some(file) = &a.output {
        output::file(file, "png")?;
        output::not_over(file, &a.scene)?;
    }
    let progress = Progress::new("reading the scene", global);
    let scene = scene::load(&a.scene).map_err(Failure::input)?;
    let method = wanted.unwrap_or(scene.render.method);
    let file = match &a.output {
        Some(file) => file.clone(),
        None => {
            let file = PathBuf::from(format!("{}-{method}.png", scene.name));
            output::file(&file, "png")?;
            file
        }
    };
    if max_error.is_some() && method != Method::Auto {
        return Err(Failure::input(format!(
            "max-error is a wish to method 'auto', not to '{method}'; expected --method auto with it"
        )));
    }
    let antialias = antialias.unwrap_or(scene.render.antialias);
    let options = RenderOptions {
        threads,
        skips,
        max_error: max_error.unwrap_or(RenderOptions::default().max_error),
        ..RenderOptions::default()
    };
    progress.say(format!("drawing {} with {method}", scene.name));
    let begin = Instant::now();
    let skips = skips_for(antialias, skips);
    let prepared = Prepared::new(&scene, size, &skips).map_err(Failure::input)?;
    let prepare_ns = nanoseconds(begin);
    let draw =
        |method| antialias::draw(&prepared, method, antialias, &options).map_err(Failure::input);
    let (frame, stats) = draw(method)?;
    let total_ns = nanoseconds(begin);
    let error = match against {
        None => None,
        Some(m) => {
            progress.say(format!("comparing with {m}"));
            let (truth, _) = draw(m)?;
            let apart = compare(view(&truth)?, view(&frame)?).map_err(Failure::input)?;
            Some((m, apart))
        }
    };
    save_png(&file, view(&frame)?).map_err(Failure::input)?;
    drop(progress);
    let drawn = Drawn {
        prepared,
        method,
        antialias,
        setup_ns: prepare_ns + stats.setup_ns,
        stats,
        total_ns,
        error,
    };
    let text = if global.quiet {
        String::new()
    } else {
        drawn.text(&file, global.verbose)
    };
    Ok(Report::done(text, drawn.json(&file)))
}

fn parse_threads(text: &str) -> Result<usize, Failure> {
    let n = text.parse().ok().filter(|n| (1..=THREADS).contains(n));
    n.ok_or_else(|| {
        Failure::input(format!(
            "threads '{text}' cannot be used; expected a number from 1 to {THREADS}"
        ))
    })
}

fn parse_error(text: &str) -> Result<f64, Failure> {
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
    fn json(&self, file: &Path) -> Value {
        let (p, s) = (&self.prepared, &self.stats);
        let mut json = json!({
            "scene": p.scene_name,
            "method": self.method.name(),
            "antialias": self.antialias.name(),
            "width": p.width,
            "height": p.height,
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
            "time_ns": { "setup": self.setup_ns, "raster": s.raster_ns, "total": self.total_ns },
            "threads": s.threads,
            "output": file.to_string_lossy(),
        });
        if let Some((against, c)) = &self.error {
            let mut error = error_json(c);
            error["against"] = against.name().into();
            json["error"] = error;
        }
        json
    }

    fn text(&self, file: &Path, verbose: bool) -> String {
        let (p, s, n) = (&self.prepared, &self.stats, &self.prepared.counts);
        let mut out = format!(
            "{}: {}x{}, {}",
            p.scene_name, p.width, p.height, self.method
        );
        if self.antialias != Antialias::None {
            let _ = write!(out, ", anti-aliased by {}", self.antialias);
        }
        out += "\n";
        let threads = match s.threads {
            1 => "1 thread".to_owned(),
            n => format!("{n} threads"),
        };
        // Writing to a string cannot fail.
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
            duration(self.setup_ns),
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
        let _ = writeln!(out, "wrote {}", file.display());
        out
    }
}
