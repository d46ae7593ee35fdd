//! The load port of a core that takes several register words per clock.
//!
//! A core of `W` words per clock has `W` lanes: `write`, `select` and `data`, and the same again as `write_1`,
//! `select_1`, `data_1` and so on. A lane means what the one lane of a core without them means, so the register map
//! does not change: only the words of one *target* (the shell, or one bit of the mask) must come one per clock, since
//! each target keeps its one port. If two lanes write to a target in a clock the lower lane wins.

/// Most register words per clock.
pub const MAX_LANES: usize = 4;

/// Targets of a register write: the shell and the four bits of the mask.
pub const TARGETS: usize = 5;

/// Ports of the further lanes, in order.
pub const LANE_PORTS: [[&str; 3]; MAX_LANES - 1] = [
    ["write_1", "select_1", "data_1"],
    ["write_2", "select_2", "data_2"],
    ["write_3", "select_3", "data_3"],
];

/// Inputs of a lane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Lane {
    /// Register write strobe.
    pub write: bool,
    /// Channel mask and word number.
    pub select: u8,
    /// Register bus.
    pub data: u64,
}

impl Lane {
    /// Whether the lane writes to a target: 0 the shell, 1 to 4 the bits of the mask.
    #[must_use]
    #[inline]
    pub fn writes_to(&self, target: usize) -> bool {
        self.write && reaches(self.select, target)
    }
}

/// Whether a select code means a target: 0 the shell, 1 to 4 the bits of the mask.
#[must_use]
#[inline]
pub fn reaches(select: u8, target: usize) -> bool {
    match target {
        0 => select >> 4 == 0,
        bit => select >> (3 + bit) & 1 == 1,
    }
}
