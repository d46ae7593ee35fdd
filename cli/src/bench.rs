//! `shadegate bench`: run time against error of every method, what each skip saves, and the papers' comparisons.

use crate::args::Global;
use crate::measures::duration;
use crate::names::Offer;
use crate::outcome::{Failure, Outcome, Report};
use crate::output;
use crate::progress::Progress;
use crate::table::Table;
use clap::Args;
use serde_json::{json, Value};
use shadegate_gen::write::write_file;
use shadegate_testbench::bench::clock::Effort;
use shadegate_testbench::bench::machine::Machine;
use shadegate_testbench::bench::papers::{papers, Claim};
use shadegate_testbench::bench::row::Row;
use shadegate_testbench::bench::select::Selection;
use shadegate_testbench::bench::skips::{scenes_in, skips, SkipRow};
use shadegate_testbench::bench::sweep::{sweep, Grid};
use shadegate_testbench::bench::within::{fastest_within, ACCEPTED};
use shadegate_testbench::bench::write::{
    claim_files, files, front_name, groups, json, skip_files, File,
};
use shadegate_testbench::bench::BenchError;
use std::path::{Path, PathBuf};

/// Arguments of `bench`.
#[derive(Debug, Args)]
#[command(
    after_help = "Times are medians over rounds in which all methods take turns, on one thread. The full sweep takes \
                  many minutes; leave the machine alone meanwhile. How to read the results: docs/bench.md."
)]
pub struct BenchArgs {
    /// Fewer and smaller: a first look in seconds
    #[arg(long)]
    quick: bool,
    /// Methods and spheres to measure, separated by commas [default: all]
    #[arg(long, value_parser = Offer(Selection::names), value_name = "LIST")]
    only: Option<String>,
    /// Measure what each skip saves on the scenes of a folder; --only names methods [default: each scene's own]
    #[arg(long, conflicts_with = "papers")]
    skips: bool,
    /// Folder of scenes for --skips
    #[arg(long, default_value = "scenes", requires = "skips", value_name = "DIR")]
    dir: PathBuf,
    /// Make the comparisons that the papers printed again
    #[arg(long, conflicts_with = "only")]
    papers: bool,
    /// Folder for CSV, JSON, Markdown and plots [default: none are written]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// What was measured, in the three forms in which it is handed out.
struct Measured {
    text: String,
    json: Value,
    files: Vec<File>,
}

/// Runs the command.
pub fn run(a: &BenchArgs, global: Global) -> Outcome {
    let selection = Selection::parse(a.only.as_deref().unwrap_or("")).map_err(Failure::input)?;
    a.output.as_deref().map(output::folder).transpose()?;
    let effort = if a.quick { Effort::QUICK } else { Effort::FULL };
    let progress = Progress::new("preparing", global);
    let mut on_step = |done: usize, of: usize, what: &str| progress.at(done, of, what);
    let machine = Machine::here();
    let measured = if a.skips {
        if selection.scenes_named {
            return Err(Failure::input(
                "--skips takes its scenes from a folder; --only may name methods alone",
            ));
        }
        let scenes = scenes_in(&a.dir).map_err(fault)?;
        let methods: &[_] = if selection.methods_named {
            &selection.methods
        } else {
            &[]
        };
        let rows = skips(&scenes, methods, effort, &mut on_step).map_err(fault)?;
        Measured {
            text: skip_text(&rows),
            json: json!({ "machine": machine, "threads": 1, "skips": rows }),
            files: skip_files(&machine, &rows),
        }
    } else if a.papers {
        let claims = papers(effort, &mut on_step).map_err(fault)?;
        Measured {
            text: claim_text(&claims),
            json: json!({ "machine": machine, "threads": 1, "claims": claims }),
            files: claim_files(&machine, &claims),
        }
    } else {
        let grid = if a.quick { Grid::quick() } else { Grid::full() };
        let rows = sweep(&selection, &grid, &mut on_step).map_err(fault)?;
        Measured {
            text: row_text(&rows, global.verbose),
            json: json(&machine, &rows),
            files: files(&machine, &rows).map_err(fault)?,
        }
    };
    drop(progress);
    finish(measured, &machine, a.output.as_deref(), global)
}

fn fault(e: BenchError) -> Failure {
    match e {
        BenchError::Scene(_) | BenchError::Folder { .. } => Failure::input(e),
        BenchError::Compare(_) | BenchError::Plot(_) => Failure::tool(e),
    }
}

fn finish(m: Measured, machine: &Machine, folder: Option<&Path>, global: Global) -> Outcome {
    let (mut text, mut json) = (m.text, m.json);
    let mut written = Vec::new();
    if let Some(folder) = folder {
        for f in &m.files {
            let path = folder.join(&f.name);
            write_file(&path, f.text.as_bytes()).map_err(Failure::input)?;
            written.push(path.to_string_lossy().into_owned());
        }
    }
    json["files"] = json!(written);
    if global.quiet {
        text.clear();
    } else {
        text = format!("{machine}\n{text}");
        for path in &written {
            text += &format!("wrote {path}\n");
        }
    }
    Ok(Report::done(text, json))
}

/// The front of every task, from fast to slow; with `all`, every method.
fn row_text(rows: &[Row], all: bool) -> String {
    let mut out = String::new();
    for mut group in groups(rows, Row::same_task) {
        let first = group[0];
        out += &format!(
            "\n{}, n = {}, {}x{}: {}\n",
            first.scene,
            first.exponent,
            first.width,
            first.height,
            if all { "all methods" } else { "the front" },
        );
        group.sort_by(|a, b| a.ns_per_frame.total_cmp(&b.ns_per_frame));
        let mut table = Table::new(&[
            "method",
            "frame",
            "by pixel",
            "ns/triangle",
            "ns/pixel",
            "max",
            "RMS",
            "front",
        ]);
        for r in group.iter().filter(|r| all || r.front_rms || r.front_max) {
            table.row([
                r.method.to_owned(),
                duration(r.ns_per_frame as u64),
                duration(r.ns_per_frame_scalar as u64),
                format!("{:.1}", r.ns_per_triangle),
                format!("{:.2}", r.ns_per_pixel),
                r.max_lsb.to_string(),
                format!("{:.4}", r.rms_lsb),
                front_name(r).to_owned(),
            ]);
        }
        out += &table.text();
    }
    out + "\nThe fastest method by the largest error, in LSB, that is accepted:\n"
        + &answer_text(rows)
}

/// For every task the fastest method within each of the [`ACCEPTED`] errors.
fn answer_text(rows: &[Row]) -> String {
    let mut table = Table::new(&["scene", "n", "size", "0", "1", "2", "5", "10", "20"]);
    for task in groups(rows, Row::same_task) {
        let first = task[0];
        let (scene, exponent) = (first.scene.to_owned(), first.exponent.to_string());
        let size = format!("{}x{}", first.width, first.height);
        let name = |e| fastest_within(&task, e).map_or("-", |r| r.method);
        let [a, b, c, d, e, f] = ACCEPTED.map(name).map(str::to_owned);
        table.row([scene, exponent, size, a, b, c, d, e, f]);
    }
    table.text()
}

fn skip_text(rows: &[SkipRow]) -> String {
    let mut table = Table::new(&[
        "scene", "method", "skip", "count", "without", "with", "alone", "in all", "max",
    ]);
    for r in rows {
        table.row([
            r.scene.clone(),
            r.method.to_owned(),
            r.skip.to_owned(),
            r.count.to_string(),
            duration(r.ns_without as u64),
            duration(r.ns_with as u64),
            format!("{:.3}", r.speedup_alone),
            format!("{:.3}", r.speedup_among_all),
            r.max_lsb.to_string(),
        ]);
    }
    table.text()
}

fn claim_text(claims: &[Claim]) -> String {
    let mut table = Table::new(&["source", "what", "unit", "paper", "ours", "reproduced", ""]);
    for c in claims {
        table.row([
            c.source.to_owned(),
            c.what.clone(),
            c.unit.to_owned(),
            c.figure(c.paper),
            c.figure(c.ours),
            c.verdict().to_owned(),
            c.note.to_owned(),
        ]);
    }
    table.text()
}
