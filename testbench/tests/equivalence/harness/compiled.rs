//! The units as native code in this process.

use super::bench::{Answers, Bench};
use super::case::Unit;
use shadegate_gen::compile::Simulator;

fn unit(u: &Unit, clocked: bool) -> Vec<Vec<Option<u128>>> {
    let mut s = Simulator::new(&u.module).unwrap_or_else(|e| panic!("{}: {e}", u.name));
    assert_eq!(
        s.clock_name(),
        u.clock.then_some("clock"),
        "clock of {}",
        u.name
    );
    let inputs = u.stimulus.inputs.iter();
    let inputs: Vec<_> = inputs
        .map(|p| s.input(&p.name).expect("an input"))
        .collect();
    let outputs = u.outputs.iter();
    let outputs: Vec<_> = outputs
        .map(|p| s.output(&p.name).expect("an output"))
        .collect();
    let mut samples = vec![];
    for vector in &u.stimulus.vectors {
        for (input, code) in inputs.iter().zip(vector) {
            s.set(*input, *code);
        }
        s.settle();
        samples.push(outputs.iter().map(|o| Some(s.get(*o))).collect());
        if clocked {
            s.clock();
            samples.push(outputs.iter().map(|o| Some(s.get(*o))).collect());
        }
    }
    samples
}

/// Compiles and runs every unit.
pub fn answers(b: &Bench) -> Answers {
    b.units.iter().map(|u| unit(u, b.clocked)).collect()
}
