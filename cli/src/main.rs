//! The `shadegate` program: arguments, progress and printing. No algorithm lives here.

mod args;
mod bench;
mod compare;
mod completions;
mod cosim;
mod frames;
mod gen;
mod list;
mod man;
mod measures;
mod names;
mod outcome;
mod output;
mod plan;
mod progress;
mod render;
mod run;
mod size;
mod synth;
mod table;

fn main() -> std::process::ExitCode {
    run::main()
}
