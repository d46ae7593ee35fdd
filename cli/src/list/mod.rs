//! `shadegate list`: what there is, one table or array per kind of thing.

mod engines;
mod hardware;
mod scenes;
mod software;

use crate::args::Global;
use crate::outcome::{Failure, Outcome, Report};
use crate::table::Table;
use anstyle::Style;
use clap::{Args, ValueEnum};
use serde_json::{Map, Value};
use std::path::PathBuf;

/// Where scenes are looked for.
const SCENES: &str = "scenes";

/// Arguments of `list`.
#[derive(Debug, Args)]
pub struct ListArgs {
    /// What to list [default: everything]
    kind: Option<Kind>,
    /// Folder of the scenes [default: scenes]
    #[arg(long, value_name = "DIR")]
    dir: Option<PathBuf>,
}

/// Kinds of things.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Kind {
    /// Shading methods
    Methods,
    /// Hardware cores
    Cores,
    /// FPGA devices
    Targets,
    /// FPGA boards
    Boards,
    /// Scene files
    Scenes,
    /// Simulators of the co-simulation, and how to install them
    Engines,
    /// Work that rendering leaves out, by the names of --no-skip
    Skips,
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Self::Methods => "methods",
            Self::Cores => "cores",
            Self::Targets => "targets",
            Self::Boards => "boards",
            Self::Scenes => "scenes",
            Self::Engines => "engines",
            Self::Skips => "skips",
        }
    }
}

/// One kind of things, for people and for programs.
struct Section {
    table: Table,
    json: Vec<Value>,
    note: Option<String>,
}

impl Section {
    fn new(headings: &[&'static str]) -> Self {
        Self {
            table: Table::new(headings),
            json: Vec::new(),
            note: None,
        }
    }

    fn add<const N: usize>(&mut self, cells: [String; N], json: Value) {
        self.table.row(cells);
        self.json.push(json);
    }

    fn text(&self, global: Global) -> String {
        if global.quiet {
            return self.table.names();
        }
        let note = self.note.iter().map(|n| format!("{n}\n"));
        if self.json.is_empty() {
            note.collect()
        } else {
            std::iter::once(self.table.text()).chain(note).collect()
        }
    }
}

/// Runs the command.
pub fn run(a: &ListArgs, global: Global) -> Outcome {
    if let Some(dir) = a.dir.as_ref().filter(|d| !d.is_dir()) {
        return Err(Failure::input(format!(
            "'{}' is not a directory",
            dir.display()
        )));
    }
    let kinds: Vec<Kind> = match a.kind {
        Some(kind) => vec![kind],
        None => Kind::value_variants().to_vec(),
    };
    let mut text = String::new();
    let mut json = Map::new();
    for kind in &kinds {
        let section = match kind {
            Kind::Methods => software::methods(),
            Kind::Cores => hardware::cores(),
            Kind::Targets => hardware::targets(),
            Kind::Boards => hardware::boards(),
            Kind::Scenes => scenes::scenes(a.dir.as_deref().unwrap_or(SCENES.as_ref()))?,
            Kind::Engines => engines::engines(),
            Kind::Skips => software::skips(),
        };
        if kinds.len() > 1 && !global.quiet {
            let style = Style::new().bold().underline();
            let gap = if text.is_empty() { "" } else { "\n" };
            text += &format!("{gap}{style}{}{style:#}\n", kind.name());
        }
        text += &section.text(global);
        json.insert(kind.name().into(), section.json.into());
    }
    Ok(Report::done(text, json.into()))
}
