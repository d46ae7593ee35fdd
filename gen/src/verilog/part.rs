//! Wires for values that need a name, and for bits that nothing needs.

use super::wiring::line;
use crate::netlist::Format;
use std::collections::BTreeSet;

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

/// Runs of a word's bits that nothing reads: lowest and highest.
fn unused(width: usize, used: u128) -> Vec<(usize, usize)> {
    let mut runs: Vec<(usize, usize)> = vec![];
    for bit in (0..width).filter(|b| used >> b & 1 == 0) {
        match runs.last_mut() {
            Some((_, high)) if *high + 1 == bit => *high = bit,
            _ => runs.push((bit, bit)),
        }
    }
    runs
}

/// Declares a wire for each run of a word's bits that nothing reads. A lint tool takes a name that says so as the
/// author's word that they are left over on purpose.
pub fn name_unused(
    out: &mut String,
    name: &str,
    width: usize,
    used: u128,
    taken: &BTreeSet<String>,
) {
    for (i, (low, high)) in unused(width, used).into_iter().enumerate() {
        let range = Format::Unsigned(high - low + 1).range();
        let bits = if width == 1 {
            name.to_string()
        } else {
            format!("{name}[{high}:{low}]")
        };
        let mut wire = format!("unused_{name}");
        if i > 0 {
            wire += &format!("_run{}", i + 1);
        }
        while taken.contains(&wire) {
            wire += "_bits";
        }
        let declaration = format!("  wire {range}{wire} = {bits};");
        line(out, &declaration, "Bits that nothing needs.");
    }
}
