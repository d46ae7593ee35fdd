//! Cells of a mapped netlist, sorted into what a device has to offer.
//!
//! Counted is what Yosys mapped to, before placement. A slice estimate follows from the counts alone, see
//! [`Resources::slices`].

use super::Family;
use serde::Serialize;
use std::collections::BTreeMap;

/// What a netlist takes.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Resources {
    /// Look-up tables of any size, inverters, and look-up tables used as memory or shift registers.
    pub lut: u64,
    /// Of these, those used as memory or shift registers: distributed RAM.
    pub lut_memory: u64,
    /// Flip-flops.
    pub ff: u64,
    /// Carry cells.
    pub carry: u64,
    /// Kind of carry cell.
    pub carry_cell: Option<String>,
    /// Multipliers and DSP slices.
    pub dsp: u64,
    /// Block RAMs, of any size.
    pub bram: u64,
    /// Block RAMs by kind.
    pub bram_cells: BTreeMap<String, u64>,
    /// Kilobits of these block RAMs, parity bits included.
    pub bram_kbit: u64,
    /// Everything else by kind: wide multiplexers, buffers, cells that are not known here.
    pub other: BTreeMap<String, u64>,
}

/// Where a cell belongs, and how many look-up tables or kilobits it is.
enum Kind {
    Lut(u64),
    Memory(u64),
    FlipFlop,
    Carry,
    Dsp,
    BlockRam(u64),
    Other,
}

/// The kind of a cell type. Names of different families do not collide.
fn kind(cell: &str) -> Kind {
    let starts = |prefixes: &[&str]| prefixes.iter().any(|p| cell.starts_with(p));
    match cell {
        "INV" | "SB_LUT4" | "LUT1" | "LUT2" | "LUT3" | "LUT4" | "LUT5" | "LUT6" => Kind::Lut(1),
        "LUT6_2" => Kind::Lut(1),
        "SRL16" | "SRL16E" | "SRLC16" | "SRLC16E" | "SRLC32E" => Kind::Memory(1),
        "RAM16X1S" | "RAM32X1S" | "RAM64X1S" => Kind::Memory(1),
        "RAM16X1D" | "RAM32X1D" | "RAM64X1D" => Kind::Memory(2),
        "RAM32M" | "RAM64M" | "RAM128X1D" => Kind::Memory(4),
        "TRELLIS_DPR16X4" => Kind::Memory(4),
        "MUXCY" | "CARRY4" | "SB_CARRY" | "CCU2C" => Kind::Carry,
        "SB_MAC16" | "MULT18X18D" | "ALU54B" => Kind::Dsp,
        "TRELLIS_FF" => Kind::FlipFlop,
        "RAMB36E1" => Kind::BlockRam(36),
        "RAMB18E1" | "DP16KD" | "PDPW16KD" => Kind::BlockRam(18),
        _ if starts(&["RAMB16"]) => Kind::BlockRam(18),
        _ if starts(&["RAMB8"]) => Kind::BlockRam(9),
        _ if starts(&["RAMB4", "SB_RAM40"]) => Kind::BlockRam(4),
        _ if starts(&["SB_DFF", "FD"]) => Kind::FlipFlop,
        _ if starts(&["DSP", "MULT"]) => Kind::Dsp,
        _ => Kind::Other,
    }
}

/// A block RAM without the widths in its name: `RAMB16_S9_S9` is a `RAMB16`.
fn without_widths(cell: &str) -> String {
    cell.split("_S").next().unwrap_or(cell).to_string()
}

impl Resources {
    /// Sorts cells by type.
    #[must_use]
    pub fn new(cells: &BTreeMap<String, u64>) -> Self {
        let mut out = Self::default();
        for (cell, n) in cells {
            match kind(cell) {
                Kind::Lut(each) => out.lut += n * each,
                Kind::Memory(each) => {
                    out.lut += n * each;
                    out.lut_memory += n * each;
                }
                Kind::FlipFlop => out.ff += n,
                Kind::Carry => {
                    out.carry += n;
                    out.carry_cell = Some(cell.clone());
                }
                Kind::Dsp => out.dsp += n,
                Kind::BlockRam(kbit) => {
                    out.bram += n;
                    out.bram_kbit += n * kbit;
                    *out.bram_cells.entry(without_widths(cell)).or_default() += n;
                }
                Kind::Other => {
                    out.other.insert(cell.clone(), *n);
                }
            }
        }
        out
    }

    /// Slices if every one is filled: the largest of what look-up tables, flip-flops and carries need by themselves.
    /// A placer needs more, as far as they cannot share; it may need fewer where two small functions share one
    /// look-up table of six inputs. With the formula; `None` for families whose makers do not count slices.
    #[must_use]
    pub fn slices(&self, family: Family) -> Option<(u64, String)> {
        let (luts, ffs) = family.slice()?;
        // A MUXCY goes with a look-up table, a CARRY4 with a slice.
        let carries = if self.carry_cell.as_deref() == Some("CARRY4") {
            1
        } else {
            luts
        };
        let need = self.lut.div_ceil(luts).max(self.ff.div_ceil(ffs));
        let slices = need.max(self.carry.div_ceil(carries));
        Some((
            slices,
            format!("max(LUT/{luts}, FF/{ffs}, carry/{carries})"),
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(list: &[(&str, u64)]) -> BTreeMap<String, u64> {
        list.iter().map(|(c, n)| ((*c).to_string(), *n)).collect()
    }

    #[test]
    fn every_cell_is_counted_once() {
        let r = Resources::new(&cells(&[
            ("CARRY4", 112),
            ("FDRE", 1876),
            ("FDSE", 1),
            ("INV", 38),
            ("LUT2", 337),
            ("LUT6", 248),
            ("MUXF7", 7),
            ("RAM32M", 2),
            ("SRL16E", 3),
            ("RAMB18E1", 1),
            ("RAMB36E1", 2),
            ("DSP48E1", 4),
            ("NOVEL", 5),
        ]));
        assert_eq!((r.lut, r.lut_memory), (38 + 337 + 248 + 8 + 3, 11));
        assert_eq!((r.ff, r.carry, r.dsp), (1877, 112, 4));
        assert_eq!(r.carry_cell.as_deref(), Some("CARRY4"));
        assert_eq!((r.bram, r.bram_kbit), (3, 18 + 72));
        assert_eq!(r.other, cells(&[("MUXF7", 7), ("NOVEL", 5)]));
    }

    #[test]
    fn the_older_and_the_other_families() {
        let r = Resources::new(&cells(&[
            ("MUXCY", 10),
            ("XORCY", 9),
            ("FDE_1", 3),
            ("RAMB16_S9_S9", 2),
            ("RAMB16BWER", 1),
            ("MULT18X18SIO", 1),
        ]));
        assert_eq!((r.ff, r.carry, r.dsp, r.bram_kbit), (3, 10, 1, 54));
        assert_eq!(r.bram_cells, cells(&[("RAMB16", 2), ("RAMB16BWER", 1)]));
        let r = Resources::new(&cells(&[
            ("SB_LUT4", 7),
            ("SB_DFFESR", 2),
            ("SB_CARRY", 3),
            ("SB_RAM40_4K", 4),
        ]));
        assert_eq!((r.lut, r.ff, r.carry, r.bram_kbit), (7, 2, 3, 16));
        let r = Resources::new(&cells(&[
            ("LUT4", 7),
            ("TRELLIS_FF", 2),
            ("CCU2C", 3),
            ("DP16KD", 4),
            ("PFUMX", 1),
            ("TRELLIS_DPR16X4", 1),
        ]));
        assert_eq!((r.lut, r.lut_memory, r.ff, r.bram_kbit), (11, 4, 2, 72));
    }

    #[test]
    fn a_slice_estimate_is_what_the_scarcest_part_needs() {
        let r = |lut, ff, carry, cell: &str| Resources {
            lut,
            ff,
            carry,
            carry_cell: Some(cell.into()),
            ..Resources::default()
        };
        let slices = |r: Resources, f| r.slices(f).map(|s| s.0);
        assert_eq!(slices(r(9, 8, 1, "CARRY4"), Family::Xc7), Some(3));
        assert_eq!(slices(r(9, 80, 1, "CARRY4"), Family::Xc7), Some(10));
        assert_eq!(slices(r(9, 8, 20, "CARRY4"), Family::Xc6s), Some(20));
        assert_eq!(slices(r(9, 8, 20, "MUXCY"), Family::Xc3s), Some(10));
        assert_eq!(slices(r(9, 8, 20, "CCU2C"), Family::Ecp5), None);
        let (_, formula) = r(1, 1, 1, "MUXCY").slices(Family::Xcve).unwrap();
        assert_eq!(formula, "max(LUT/2, FF/2, carry/2)");
    }
}
