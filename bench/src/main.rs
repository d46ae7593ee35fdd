//! Shadegate's software renderer beside other ones: the same triangles, the same machine, one run, all taking turns.
//! What is compared with what, and what is unequal about it, is in the README beside this package.

mod fill;
mod phong;
mod report;
mod threads;
mod turns;

use clap::{Parser, ValueEnum};
use report::Report;
use shadegate_testbench::bench::clock::Effort;
use std::path::PathBuf;
use std::process::ExitCode;

/// Compares Shadegate's software renderer with other ones.
#[derive(Debug, Parser)]
#[command(version)]
struct Arguments {
    /// Comparisons to make [default: all]
    #[arg(value_enum)]
    what: Vec<Comparison>,
    /// Fewer rounds
    #[arg(long)]
    quick: bool,
    /// File for the tables, as Markdown [default: standard output]
    #[arg(short, long, value_name = "FILE.md")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Comparison {
    /// Triangles of one shape in several sizes: retrofire, Mesa
    Fill,
    /// A teapot shaded per pixel: euc
    Phong,
    /// Two threads against one
    Threads,
}

fn main() -> ExitCode {
    let a = Arguments::parse();
    let effort = if a.quick { Effort::QUICK } else { Effort::FULL };
    let wants = |c| a.what.is_empty() || a.what.contains(&c);
    let mut report = Report::new();
    type Job = fn(Effort, &mut Report) -> Result<(), String>;
    let jobs: [(Comparison, Job); 3] = [
        (Comparison::Fill, fill::compare),
        (Comparison::Phong, phong::compare),
        (Comparison::Threads, threads::compare),
    ];
    for (what, job) in jobs {
        if wants(what) {
            eprintln!("measuring: {what:?}");
            if let Err(e) = job(effort, &mut report) {
                eprintln!("error: {e}");
                return ExitCode::FAILURE;
            }
        }
    }
    let text = report.text();
    match &a.output {
        None => print!("{text}"),
        Some(file) => {
            if let Err(e) = std::fs::write(file, text) {
                eprintln!("error: {}: cannot be written: {e}", file.display());
                return ExitCode::FAILURE;
            }
        }
    }
    ExitCode::SUCCESS
}
