//! Scripts that take a core through synthesis: Yosys for any family, Vivado or ISE where the device is one of theirs.
//!
//! All of them are run from the package's folder, write below `out/` and name files by relative paths.

mod ise;
mod nextpnr;
mod vivado;
mod yosys;

pub(super) use ise::family as ise_family;
pub(super) use nextpnr::options as nextpnr_options;

use super::{PackageFile, Target};
use shadegate_constraints::Format;

/// What the scripts name.
pub(super) struct Sources<'a> {
    /// Top module.
    pub top: &'a str,
    /// Verilog files, by path inside the package.
    pub rtl: Vec<&'a str>,
    /// Constraint file, by path inside the package.
    pub constraints: Option<&'a str>,
}

/// The scripts for a core, for `target` if one is named.
pub(super) fn scripts(s: &Sources, target: Option<Target>) -> Vec<PackageFile> {
    let file = |path: String, text: String| PackageFile { path, text };
    let mut files = vec![file("build/yosys.ys".into(), yosys::script(s, target))];
    let Some(t) = target else { return files };
    match t.device.constraints {
        Format::Xdc => files.push(file("build/vivado.tcl".into(), vivado::script(s, t))),
        Format::Ucf => {
            files.push(file("build/ise.tcl".into(), ise::script(s, t)));
            if t.device.vendor_tool == ise::PROJECT_TOOL {
                files.push(file(format!("build/{}.xise", s.top), ise::project(s, t)));
            }
        }
        Format::Pcf | Format::Lpf => {}
    }
    files
}
