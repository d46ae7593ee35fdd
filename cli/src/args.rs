//! The command line: global options and one variant per command.

use crate::{bench, compare, completions, cosim, gen, list, man, plan, render, synth};
use clap::{Args, Parser, Subcommand};

/// Turns shading interpolators into FPGA hardware and checks every pixel of it.
///
/// Exit codes: 0 done and all checks hold; 1 done but a check failed; 2 bad input or usage; 3 a tool it needed is
/// missing or failed.
#[derive(Debug, Parser)]
#[command(
    name = "shadegate",
    version,
    propagate_version = true,
    arg_required_else_help = true
)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
    /// Options of all commands.
    #[command(flatten)]
    pub global: Global,
}

/// Options of all commands.
#[derive(Clone, Copy, Debug, Args)]
pub struct Global {
    /// Print one JSON object on standard output, and nothing else there
    #[arg(long, global = true)]
    pub json: bool,
    /// Print only what cannot be done without
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    pub quiet: bool,
    /// Print more
    #[arg(short, long, global = true)]
    pub verbose: bool,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Simulate a core drawing a scene, and check every pixel
    Cosim(cosim::CosimArgs),
    /// Draw a scene in software
    Render(render::RenderArgs),
    /// Write a core as Verilog, with constraints, test bench and vectors
    Gen(gen::GenArgs),
    /// Say what a core takes of a device family, and how fast a routed one runs
    Synth(synth::SynthArgs),
    /// Say what a scene needs of a core, unit by unit, and why
    Plan(plan::PlanArgs),
    /// Say how far two images are apart (exit code 1 if they differ)
    Compare(compare::CompareArgs),
    /// Measure run time against error of every method
    Bench(bench::BenchArgs),
    /// List what there is: methods, cores, devices, boards, scenes, engines
    List(list::ListArgs),
    /// Print a completion script for a shell
    Completions(completions::CompletionsArgs),
    /// Write the manual pages
    Man(man::ManArgs),
}
