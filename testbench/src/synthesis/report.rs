//! One row of the report per target; field names are the JSON keys.

use super::{Places, Resources, Routed, SlowestPath, Synthesis};
use serde::Serialize;

/// What a device has.
#[derive(Clone, Copy, Debug)]
pub struct Capacity {
    /// Look-up tables.
    pub lut: u64,
    /// Flip-flops.
    pub ff: u64,
    /// Kilobits of block RAM, parity bits included.
    pub bram_kbit: u64,
    /// Multipliers.
    pub dsp: u64,
}

impl Capacity {
    /// Whether it suffices, by each count alone; a placer may still fail.
    #[must_use]
    pub fn holds(&self, r: &Resources) -> bool {
        r.lut <= self.lut && r.ff <= self.ff && r.bram_kbit <= self.bram_kbit && r.dsp <= self.dsp
    }
}

/// What a design takes of a target.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Device, the part that was routed, or null for a family as a whole.
    pub target: Option<String>,
    /// Family.
    pub family: &'static str,
    /// Cells.
    #[serde(flatten)]
    pub resources: Resources,
    /// Slices if every one is filled, or null.
    pub slices: Option<u64>,
    /// How they follow from the cells, or null.
    pub slices_formula: Option<String>,
    /// Cells on the longest path between registers.
    pub depth: Option<u64>,
    /// Picoseconds of the slowest path in cells alone, or null.
    pub arrival_ps: Option<u64>,
    /// What a router achieved on this very target, or null.
    pub fmax_mhz: Option<f64>,
    /// Places that the router used, and how many there are; null if nothing was routed.
    pub placed: Option<Places>,
    /// The path that sets `fmax_mhz`, or null.
    pub slowest_path: Option<SlowestPath>,
    /// Whether the device has enough of everything, or null.
    pub fits: Option<bool>,
    /// Programs and versions.
    pub tool: String,
    /// The result is of an earlier run.
    pub cached: bool,
}

impl Row {
    /// Of a family, and of a device of it if one is named.
    #[must_use]
    pub fn mapped(s: &Synthesis, device: Option<(&str, Capacity)>) -> Self {
        let slices = s.resources.slices(s.family);
        Self {
            target: device.map(|d| d.0.to_string()),
            family: s.family.name(),
            resources: s.resources.clone(),
            slices: slices.as_ref().map(|s| s.0),
            slices_formula: slices.map(|s| s.1),
            depth: s.depth,
            arrival_ps: s.arrival_ps,
            fmax_mhz: None,
            placed: None,
            slowest_path: None,
            fits: device.map(|d| d.1.holds(&s.resources)),
            tool: s.tool.clone(),
            cached: s.cached,
        }
    }

    /// Of a part that was routed.
    #[must_use]
    pub fn routed(s: &Synthesis, r: &Routed) -> Self {
        Self {
            target: Some(r.part.clone()),
            fmax_mhz: Some(r.fmax_mhz),
            placed: Some(r.used.clone()),
            slowest_path: r.path.clone(),
            fits: Some(true),
            tool: format!("{}, {}", s.tool, r.tool),
            cached: s.cached && r.cached,
            ..Self::mapped(s, None)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::Family;

    #[test]
    fn a_design_fits_if_nothing_is_short() {
        let r = Resources {
            lut: 10,
            ff: 20,
            bram_kbit: 30,
            dsp: 1,
            ..Resources::default()
        };
        let enough = Capacity {
            lut: 10,
            ff: 20,
            bram_kbit: 30,
            dsp: 1,
        };
        assert!(enough.holds(&r));
        for short in [
            Capacity { lut: 9, ..enough },
            Capacity { ff: 19, ..enough },
            Capacity {
                bram_kbit: 29,
                ..enough
            },
            Capacity { dsp: 0, ..enough },
        ] {
            assert!(!short.holds(&r), "{short:?}");
        }
    }

    #[test]
    fn only_what_was_routed_has_a_frequency() {
        let s = Synthesis {
            family: Family::Xc7,
            resources: Resources::default(),
            depth: Some(3),
            arrival_ps: Some(4),
            tool: "Yosys 0.23".into(),
            cached: true,
        };
        let row = Row::mapped(&s, None);
        assert_eq!((row.fmax_mhz, row.target, row.fits), (None, None, None));
        let s = Synthesis {
            family: Family::Ecp5,
            ..s
        };
        let r = Routed {
            part: "LFE5U-25F".into(),
            fmax_mhz: 70.5,
            used: Places::new(),
            path: None,
            tool: "nextpnr-ecp5 0.11".into(),
            cached: false,
        };
        let row = Row::routed(&s, &r);
        assert_eq!((row.fmax_mhz, row.cached), (Some(70.5), false));
        assert_eq!(row.tool, "Yosys 0.23, nextpnr-ecp5 0.11");
        assert_eq!(row.slices, None);
    }
}
