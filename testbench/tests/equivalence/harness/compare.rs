//! Where an engine and rust-hdl's simulation part.

use super::bench::{Answers, Bench};
use std::fmt;

/// The first difference of one output.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// Engine.
    pub engine: &'static str,
    /// Index of the unit.
    pub unit: usize,
    /// Its name.
    pub name: String,
    /// The sample: with a clock two per vector, before and behind its rising edge.
    pub sample: usize,
    /// The output, by position and name.
    pub output: (usize, String),
    /// What rust-hdl's simulation says.
    pub expected: u128,
    /// What the engine says; `None` when bits are unknown.
    pub got: Option<u128>,
    /// The inputs of that vector.
    pub inputs: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let got = self.got.map_or("unknown".to_string(), |g| format!("{g:x}"));
        write!(
            f,
            "{}: {} sample {}: output {} is {got}, expected {:x} ({})",
            self.engine, self.name, self.sample, self.output.1, self.expected, self.inputs
        )
    }
}

/// The first difference of every output.
pub fn differences(engine: &'static str, b: &Bench, answers: &Answers) -> Vec<Difference> {
    let per_vector = if b.clocked { 2 } else { 1 };
    let mut out = vec![];
    assert_eq!(
        answers.len(),
        b.units.len(),
        "{engine} answered for every unit"
    );
    for (unit, (u, answer)) in b.units.iter().zip(answers).enumerate() {
        assert_eq!(answer.len(), u.expected.len(), "samples of {}", u.name);
        for (at, port) in u.outputs.iter().enumerate() {
            let differs =
                |s: &usize| !(u.undefined)(*s, at) && answer[*s][at] != Some(u.expected[*s][at]);
            let Some(sample) = (0..answer.len()).find(differs) else {
                continue;
            };
            let vector = &u.stimulus.vectors[sample / per_vector];
            let inputs = u.stimulus.inputs.iter().zip(vector);
            let inputs = inputs.map(|(p, c)| format!("{}={c:x}", p.name));
            out.push(Difference {
                engine,
                unit,
                name: u.name.clone(),
                sample,
                output: (at, port.name.clone()),
                expected: u.expected[sample][at],
                got: answer[sample][at],
                inputs: inputs.collect::<Vec<_>>().join(" "),
            });
        }
    }
    out
}

/// Fails with every difference.
pub fn assert_none(differences: &[Difference]) {
    let lines: Vec<String> = differences
        .iter()
        .take(40)
        .map(Difference::to_string)
        .collect();
    assert!(
        differences.is_empty(),
        "{} outputs differ:\n{}",
        differences.len(),
        lines.join("\n")
    );
}
