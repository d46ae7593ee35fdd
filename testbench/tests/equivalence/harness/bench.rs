//! Units side by side in one Verilog module, and the text files that their words travel in.

use super::case::{Stimulus, Unit};
use super::code::Port;
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::Path;
use std::rc::Rc;

/// What an engine answered: per unit, sample and output a code, or `None` where bits are unknown.
pub type Answers = Vec<Vec<Vec<Option<u128>>>>;

/// Several units.
pub struct Bench<'a> {
    /// The units; all stimuli have the same number of vectors.
    pub units: &'a [Unit],
    /// Whether a clock rises after each vector, so that there are two samples per vector.
    pub clocked: bool,
}

/// Bits of a list of widths.
fn total(widths: impl Iterator<Item = usize>) -> usize {
    widths.sum::<usize>().max(1)
}

/// Codes side by side, the first lowest, as hexadecimal.
fn packed(codes: &[u128], widths: impl Iterator<Item = usize>) -> String {
    let mut bits: Vec<bool> = vec![];
    for (code, width) in codes.iter().zip(widths) {
        bits.extend((0..width).map(|i| code >> i & 1 == 1));
    }
    let digit = |four: &[bool]| {
        let value = four.iter().rev().fold(0, |v, b| v << 1 | u32::from(*b));
        char::from_digit(value, 16).expect("four bits")
    };
    let text: String = bits.chunks(4).map(digit).collect();
    let text: String = text.chars().rev().collect();
    if text.is_empty() {
        "0".to_string()
    } else {
        text
    }
}

/// The code of a word; `None` when one of its digits is unknown.
fn unpacked(text: &str, width: usize) -> Option<u128> {
    let code = text.chars().try_fold(0u128, |code, c| {
        Some(code << 4 | u128::from(c.to_digit(16)?))
    })?;
    assert!(width == 128 || code >> width == 0, "{text} in {width} bits");
    Some(code)
}

impl Bench<'_> {
    /// The different stimuli.
    pub fn stimuli(&self) -> Vec<&Rc<Stimulus>> {
        let mut list: Vec<&Rc<Stimulus>> = vec![];
        for u in self.units {
            if !list.iter().any(|s| Rc::ptr_eq(s, &u.stimulus)) {
                list.push(&u.stimulus);
            }
        }
        list
    }

    /// Number of vectors.
    pub fn vectors(&self) -> usize {
        let counts: BTreeSet<usize> = self
            .units
            .iter()
            .map(|u| u.stimulus.vectors.len())
            .collect();
        assert_eq!(counts.len(), 1, "all stimuli have the same length");
        counts.into_iter().next().unwrap_or(0)
    }

    /// Bits of a stimulus.
    pub fn input_bits(s: &Stimulus) -> usize {
        total(s.inputs.iter().map(|p| p.width))
    }

    /// The outputs of all units: name in the top module, width.
    pub fn outputs(&self) -> Vec<(String, usize)> {
        let units = self.units.iter().enumerate();
        let outputs = units.flat_map(|(i, u)| {
            let outputs = u.outputs.iter().enumerate();
            outputs.map(move |(j, p)| (format!("y{i}_{j}"), p.width))
        });
        outputs.collect()
    }

    /// The module that holds all units: inputs `x0`, `x1`, … per stimulus, side by side; outputs `y0_0`, `y0_1`, … per
    /// unit, each a port of its own. (Verilator 5.006 leaves stray bits where signed outputs of thousands of instances
    /// are put side by side in one long port.)
    pub fn top(&self) -> String {
        let stimuli = self.stimuli();
        let clocked = self.units.iter().any(|u| u.clock);
        let mut ports = vec![];
        if clocked {
            ports.push("  input  wire clock".to_string());
        }
        for (i, s) in stimuli
            .iter()
            .enumerate()
            .filter(|(_, s)| !s.inputs.is_empty())
        {
            ports.push(format!(
                "  input  wire [{}:0] x{i}",
                Self::input_bits(s) - 1
            ));
        }
        for (name, width) in self.outputs() {
            ports.push(format!("  output wire [{}:0] {name}", width - 1));
        }
        let mut out = format!(
            "`default_nettype none\n\nmodule everything (\n{}\n);\n",
            ports.join(",\n")
        );
        for (i, u) in self.units.iter().enumerate() {
            let x = stimuli
                .iter()
                .position(|s| Rc::ptr_eq(s, &u.stimulus))
                .expect("listed");
            let mut connections = vec![];
            if u.clock {
                connections.push("    .clock(clock)".to_string());
            }
            let mut at = 0;
            for p in &u.stimulus.inputs {
                let top = at + p.width - 1;
                connections.push(format!("    .{}(x{x}[{top}:{at}])", p.name));
                at += p.width;
            }
            for (j, p) in u.outputs.iter().enumerate() {
                connections.push(format!("    .{}(y{i}_{j})", p.name));
            }
            let _ = write!(
                out,
                "\n  {} u{i} (\n{}\n  );\n",
                u.verilog_name(),
                connections.join(",\n")
            );
        }
        out + "\nendmodule\n\n`default_nettype wire\n"
    }

    /// Writes `everything.v` and all emitted files; gives their names.
    pub fn write_verilog(&self, directory: &Path) -> Vec<String> {
        let mut names = vec![];
        let files = self.units.iter().flat_map(|u| &u.files);
        for f in files {
            names.push(f.file_name());
            std::fs::write(directory.join(f.file_name()), &f.text).expect("writable");
        }
        let unique: BTreeSet<&String> = names.iter().collect();
        assert_eq!(unique.len(), names.len(), "a module name is used twice");
        std::fs::write(directory.join("everything.v"), self.top()).expect("writable");
        names.push("everything.v".to_string());
        names
    }

    /// One line per vector: the words of all stimuli.
    pub fn write_stimuli(&self, file: &Path) {
        let stimuli = self.stimuli();
        let mut text = String::new();
        for v in 0..self.vectors() {
            let words = stimuli
                .iter()
                .map(|s| packed(&s.vectors[v], s.inputs.iter().map(|p| p.width)));
            text += &words.collect::<Vec<_>>().join(" ");
            text.push('\n');
        }
        std::fs::write(file, text).expect("writable");
    }

    /// Samples that an engine must give.
    pub fn samples(&self) -> usize {
        self.vectors() * if self.clocked { 2 } else { 1 }
    }

    /// Reads what a simulator wrote: one line per sample, one word per output.
    pub fn read_answers(&self, file: &Path) -> Answers {
        let text = std::fs::read_to_string(file).expect("the simulator wrote its outputs");
        let mut answers: Answers = vec![vec![]; self.units.len()];
        let lines: Vec<&str> = text.lines().filter(|l| !l.trim().is_empty()).collect();
        assert_eq!(lines.len(), self.samples(), "samples in {}", file.display());
        for line in lines {
            let mut words = line.split_whitespace();
            for (u, answer) in self.units.iter().zip(&mut answers) {
                let code = |p: &Port| unpacked(words.next().expect("a word"), p.width);
                answer.push(u.outputs.iter().map(code).collect());
            }
            assert_eq!(words.next(), None, "a word too many");
        }
        answers
    }
}

#[test]
fn words_are_packed_and_unpacked() {
    let widths = [3, 1, 128, 5];
    let codes = [5, 1, u128::MAX - 6, 17];
    let text = packed(&codes, widths.into_iter());
    assert_eq!(text, "11fffffffffffffffffffffffffffffff9d");
    assert_eq!(unpacked("1f", 5), Some(31));
    assert_eq!(unpacked("x3", 6), None);
}
