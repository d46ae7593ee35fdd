//! Device families as Yosys knows them.

use std::fmt;
use std::str::FromStr;

/// A family that Yosys maps to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Family {
    /// Virtex-E and Spartan-IIE.
    Xcve,
    /// Spartan-3.
    Xc3s,
    /// Spartan-3E.
    Xc3se,
    /// Spartan-6.
    Xc6s,
    /// Spartan-7 and its relatives.
    Xc7,
    /// Lattice iCE40.
    Ice40,
    /// Lattice ECP5.
    Ecp5,
}

impl Family {
    /// All families.
    pub const ALL: [Self; 7] = [
        Self::Xcve,
        Self::Xc3s,
        Self::Xc3se,
        Self::Xc6s,
        Self::Xc7,
        Self::Ice40,
        Self::Ecp5,
    ];
    /// Those that are counted when nobody names a device: one per generation that has the block RAM of a core.
    pub const USUAL: [Self; 3] = [Self::Xc3s, Self::Xc6s, Self::Xc7];

    /// Name, as the device catalogue has it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Xcve => "xcve",
            Self::Xc3s => "xc3s",
            Self::Xc3se => "xc3se",
            Self::Xc6s => "xc6s",
            Self::Xc7 => "xc7",
            Self::Ice40 => "ice40",
            Self::Ecp5 => "ecp5",
        }
    }

    /// Look-up tables and flip-flops of a slice, where slices are what its maker counts.
    pub(super) fn slice(self) -> Option<(u64, u64)> {
        match self {
            Self::Xcve | Self::Xc3s | Self::Xc3se => Some((2, 2)),
            Self::Xc6s | Self::Xc7 => Some((4, 8)),
            Self::Ice40 | Self::Ecp5 => None,
        }
    }

    /// The commands that map a design with this top module, without pads and clock buffers where Yosys would add them.
    pub(super) fn synthesis(self, top: &str, wide_muxes: bool) -> String {
        match self {
            Self::Ice40 => format!("synth_ice40 -top {top}"),
            Self::Ecp5 => format!("synth_ecp5 -top {top}"),
            // Yosys 0.23 leaves out the clock enable of shift registers that it makes look-up tables of.
            _ => {
                let without = if wide_muxes { "" } else { " -nowidelut" };
                format!("synth_xilinx -family {self} -top {top} -flatten -noiopad -noclkbuf -nosrl{without}")
            }
        }
    }

    /// Cells at which paths begin and end: flip-flops and memories, as patterns of cell types.
    pub(super) fn path_ends(self) -> &'static [&'static str] {
        match self {
            Self::Ice40 => &["SB_DFF*", "SB_RAM*", "SB_SPRAM*", "SB_MAC16"],
            Self::Ecp5 => &["TRELLIS_FF", "TRELLIS_DPR*", "DP16KD", "PDPW16KD"],
            _ => &["FD*", "RAM*", "SRL*"],
        }
    }

    /// Whether Yosys knows how long its cells take.
    pub(super) fn has_delays(self) -> bool {
        self == Self::Xc7
    }
}

impl fmt::Display for Family {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Family {
    type Err = shadegate_reference::method::UnknownName;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let all = Self::ALL.into_iter();
        all.clone()
            .find(|f| f.name() == name)
            .ok_or_else(|| Self::Err::new("family", name, &Self::ALL.map(Self::name)))
    }
}
