//! Reading what Yosys says: `stat -json`, `ltp`, `sta`.

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
}
