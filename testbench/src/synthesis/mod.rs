//! Synthesis: what a design takes of a device family, how long its longest path is, and, where a free tool can place
//! and route, how fast it runs there.
//!
//! Yosys maps and counts; the counts are of cells before placement. Three kinds of speed are told apart, because they
//! are not the same thing:
//!
//! - *depth*: cells on the longest path between registers, of any family;
//! - *arrival*: what these cells take without any wire between them, where Yosys has delays: a lower bound of the
//!   clock period that no placement reaches;
//! - *Fmax*: what a router achieved, and only for the part that it routed.

mod cells;
mod family;
mod parts;
mod read;
mod report;
mod route;

pub use cells::Resources;
pub use family::Family;
pub use read::{Places, SlowestPath};
pub use report::{Capacity, Row};
pub use route::{route, Routed, Router};

use crate::cache::{entry, key, Wanted};
use crate::process::{find_tool, output};
use shadegate_gen::package::PackageFile;
use shadegate_gen::write::write_file;
use std::path::Path;
use std::process::Command;

/// A design: a top module and the Verilog files that it is made of.
#[derive(Clone, Debug)]
pub struct Design {
    /// Top module.
    pub top: String,
    /// Verilog files; others are passed over.
    pub files: Vec<PackageFile>,
}

/// How to go about it.
#[derive(Clone, Copy, Debug)]
pub struct Options<'a> {
    /// Look into the cache, and keep results there.
    pub cache: bool,
    /// Folder for netlists and the tools' own reports.
    pub output: Option<&'a Path>,
    /// Let Yosys choose with wide multiplexers of several look-up tables: shorter paths, and where a look-up table has four
    /// inputs half as many again of them.
    pub wide_muxes: bool,
}

/// What Yosys made of a design.
#[derive(Clone, Debug)]
pub struct Synthesis {
    /// Family.
    pub family: Family,
    /// Cells.
    pub resources: Resources,
    /// Cells on the longest path between registers.
    pub depth: Option<u64>,
    /// Picoseconds that the slowest path takes in cells alone, without wires.
    pub arrival_ps: Option<u64>,
    /// Program and version.
    pub tool: String,
    /// The result is of an earlier run.
    pub cached: bool,
}

/// Why there is no result.
#[derive(Debug, thiserror::Error)]
pub enum SynthesisError {
    /// A program is missing.
    #[error("`{tool}` is not installed; install it with `{install}`")]
    Missing {
        /// Program.
        tool: &'static str,
        /// A command.
        install: &'static str,
    },
    /// A program failed.
    #[error("{0}")]
    Failed(String),
    /// No part that can be routed is large enough.
    #[error("{0}")]
    TooLarge(String),
}

fn failed(e: impl std::fmt::Display) -> SynthesisError {
    SynthesisError::Failed(e.to_string())
}

/// Maps a design to a family.
///
/// # Errors
/// See [`SynthesisError`].
pub fn synthesise(
    design: &Design,
    family: Family,
    options: &Options,
) -> Result<Synthesis, SynthesisError> {
    mapped(design, family, options, |_| Ok(())).map(|(synthesis, ())| synthesis)
}

/// Maps a design, and does something with the folder of the results while it is there.
fn mapped<R>(
    design: &Design,
    family: Family,
    options: &Options,
    then: impl FnOnce(&Path) -> Result<R, SynthesisError>,
) -> Result<(Synthesis, R), SynthesisError> {
    if find_tool("yosys").is_none() {
        return Err(SynthesisError::Missing {
            tool: "yosys",
            install: "apt-get install yosys",
        });
    }
    let version = output(Command::new("yosys").arg("-V"), false).map_err(failed)?;
    let tool = version.split(" (").next().unwrap_or(&version).trim();
    let script = script(design, family, options.wide_muxes);
    let sources = verilog(design);
    let sources = sources
        .iter()
        .flat_map(|f| [f.path.as_str(), f.text.as_str()]);
    let key = key([version.as_str(), &script].into_iter().chain(sources));
    let scratch = tempfile::tempdir().map_err(failed)?;
    let wanted = Wanted {
        kind: "synth",
        key: &key,
        keep: options.cache,
    };
    let made = entry(wanted, scratch.path(), failed, |into| {
        for f in verilog(design) {
            write_file(&into.join(&f.path), f.text.as_bytes()).map_err(failed)?;
        }
        write_file(&into.join("synth.ys"), script.as_bytes()).map_err(failed)?;
        let mut yosys = Command::new("yosys");
        yosys.current_dir(into).args(["-q", "synth.ys"]);
        output(&mut yosys, false).map_err(failed)?;
        Ok(())
    })?;
    let text = |name: &str| std::fs::read_to_string(made.directory.join(name)).map_err(failed);
    let cells = read::cells(&text("stat.json")?)
        .ok_or_else(|| failed("yosys gave no statistics that can be read"))?;
    let arrival_ps = match family.has_delays() {
        true => read::arrival_ps(&text("arrival.txt")?),
        false => None,
    };
    let synthesis = Synthesis {
        family,
        resources: Resources::new(&cells),
        depth: read::depth(&text("depth.txt")?),
        arrival_ps,
        tool: tool.to_string(),
        cached: made.cached,
    };
    if let Some(output) = options.output {
        hand_out(&made.directory, &output.join(family.name()))?;
    }
    let more = then(&made.directory)?;
    Ok((synthesis, more))
}

/// The Verilog files of a design by name: counts depend a little on the order in which they are read.
fn verilog(design: &Design) -> Vec<&PackageFile> {
    let files = design.files.iter();
    let mut files: Vec<&PackageFile> = files.filter(|f| f.path.ends_with(".v")).collect();
    files.sort_by(|a, b| a.path.cmp(&b.path));
    files
}

/// What Yosys is to do, from sources to reports.
fn script(design: &Design, family: Family, wide_muxes: bool) -> String {
    let mut out = String::new();
    for f in verilog(design) {
        out += &format!("read_verilog \"{}\"\n", f.path);
    }
    let without: String = family
        .path_ends()
        .iter()
        .map(|cell| format!(" t:{cell} %d"))
        .collect();
    out += &format!(
        "{}\ntee -q -o stat.json stat -json\ntee -q -o depth.txt ltp -noff t:*{without} w:* %u\n\
         write_verilog -noattr netlist.v\n",
        family.synthesis(&design.top, wide_muxes)
    );
    if family.has_delays() {
        out += "read_verilog -lib -specify +/xilinx/cells_sim.v\ntee -q -o arrival.txt sta\n";
    } else if Router::of(family).is_some() {
        out += "write_json netlist.json\n";
    }
    out
}

/// Copies the files of an entry to a folder of the user.
fn hand_out(from: &Path, to: &Path) -> Result<(), SynthesisError> {
    let error = |e: std::io::Error| failed(format!("{}: {e}", to.display()));
    std::fs::create_dir_all(to).map_err(error)?;
    for file in std::fs::read_dir(from).map_err(error)? {
        let file = file.map_err(error)?;
        if file.file_type().map_err(error)?.is_file() {
            std::fs::copy(file.path(), to.join(file.file_name())).map_err(error)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scripts_read_verilog_only_and_end_paths_at_registers() {
        let file = |path: &str| PackageFile {
            path: path.into(),
            text: String::new(),
        };
        let design = Design {
            top: "core".into(),
            files: vec![file("rtl/b.v"), file("rtl/files.f"), file("rtl/a.v")],
        };
        let xc7 = script(&design, Family::Xc7, true);
        assert!(xc7.starts_with(
            "read_verilog \"rtl/a.v\"\nread_verilog \"rtl/b.v\"\nsynth_xilinx -family xc7 -top core "
        ));
        assert!(xc7.contains("ltp -noff t:* t:FD* %d t:RAM* %d t:SRL* %d w:* %u\n"));
        assert!(!xc7.contains("-nowidelut"));
        let spartan_3 = script(&design, Family::Xc3s, false);
        assert!(spartan_3.contains(" -top core -flatten -noiopad -noclkbuf -nosrl -nowidelut\n"));
        assert!(xc7.ends_with("tee -q -o arrival.txt sta\n"));
        let ecp5 = script(&design, Family::Ecp5, true);
        assert!(ecp5.contains("\nsynth_ecp5 -top core\n") && ecp5.ends_with("netlist.json\n"));
        assert!(!script(&design, Family::Xc6s, true).contains("sta\n"));
    }
}
