//! Handles: names that were found once.

use super::layout::{Slot, Words};

/// An input of the top module. Handles belong to the simulator that gave them (or another of the same design).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Input(pub(super) Slot);

/// An output of the top module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Output(pub(super) Slot);

/// Any signal of the design. Two names of one value have equal handles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Signal(pub(super) Place);

/// A memory of the design.
#[derive(Clone, Copy, Debug)]
pub struct Memory(pub(super) Words);

impl Memory {
    /// Words.
    #[must_use]
    pub fn len(self) -> usize {
        self.0.count
    }

    /// Whether there are none; there always are.
    #[must_use]
    pub fn is_empty(self) -> bool {
        self.0.count == 0
    }
}

/// Where a signal's code is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Place {
    /// Always up to date.
    State(Slot),
    /// Up to date after every wire has been kept.
    Wire(Slot),
    Constant(u128),
}

impl Place {
    #[inline]
    pub(super) fn get(self, state: &[u64]) -> u128 {
        match self {
            Self::State(slot) | Self::Wire(slot) => slot.get(state),
            Self::Constant(code) => code,
        }
    }
}
