//! `shadegate man`: the manual pages, one for the program and one per command.

use crate::args::{Cli, Global};
use crate::outcome::{Failure, Outcome, Report};
use crate::output;
use clap::{Args, Command, CommandFactory};
use serde_json::json;
use shadegate_gen::write::write_file;
use std::path::PathBuf;

/// Arguments of `man`.
#[derive(Debug, Args)]
pub struct ManArgs {
    /// Folder for the pages; made if it is missing
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
}

fn page(command: Command) -> Result<(String, Vec<u8>), Failure> {
    let man = clap_mangen::Man::new(command);
    let mut text = Vec::new();
    man.render(&mut text).map_err(Failure::input)?;
    Ok((man.get_filename(), text))
}

/// Runs the command.
pub fn run(a: &ManArgs, global: Global) -> Outcome {
    output::folder(&a.output)?;
    let mut program = Cli::command().disable_help_subcommand(true);
    program.build();
    let commands: Vec<Command> = program.get_subcommands().cloned().collect();
    let pages = std::iter::once(program)
        .chain(commands)
        .map(page)
        .collect::<Result<Vec<_>, _>>()?;
    let mut files = Vec::new();
    for (name, text) in pages {
        write_file(&a.output.join(&name), &text).map_err(Failure::input)?;
        files.push(name);
    }
    let text = if global.quiet {
        String::new()
    } else {
        format!("wrote {} pages to {}\n", files.len(), a.output.display())
    };
    let json = json!({ "output": a.output.to_string_lossy(), "files": files });
    Ok(Report::done(text, json))
}
