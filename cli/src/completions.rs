//! `shadegate completions`: a script for a shell.

use crate::args::Cli;
use crate::outcome::{Outcome, Report};
use clap::{Args, CommandFactory, ValueEnum};
use clap_complete::Shell;
use serde_json::json;

/// Arguments of `completions`.
#[derive(Debug, Args)]
pub struct CompletionsArgs {
    /// The shell
    shell: Shell,
}

/// Runs the command.
pub fn run(a: &CompletionsArgs) -> Outcome {
    let mut script = Vec::new();
    clap_complete::generate(a.shell, &mut Cli::command(), "shadegate", &mut script);
    let script = String::from_utf8_lossy(&script).into_owned();
    let shell = a.shell.to_possible_value().map(|v| v.get_name().to_owned());
    let json = json!({ "shell": shell, "script": script });
    Ok(Report::done(script, json))
}
