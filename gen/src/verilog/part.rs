//! Wires for values that need a name.

use crate::netlist::Format;

/// A wire for a value that needs a name.
#[derive(Clone, Debug)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// Its format.
    pub format: Format,
    /// Its value.
    pub value: String,
    /// What it is part of.
    pub stem: String,
    /// Bits that something reads.
    pub used: u128,
}

impl Part {
    /// Runs of bits that nothing reads: lowest and highest.
    pub fn unused(&self) -> Vec<(usize, usize)> {
        let mut runs: Vec<(usize, usize)> = vec![];
        for bit in (0..self.format.width()).filter(|b| self.used >> b & 1 == 0) {
            match runs.last_mut() {
                Some((_, high)) if *high + 1 == bit => *high = bit,
                _ => runs.push((bit, bit)),
            }
        }
        runs
    }
}
