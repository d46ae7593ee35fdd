//! Random designs against the interpreter, for some hundred clocks each: outputs always, every signal and memory word
//! now and then.

use super::interpreter::Interpreter;
use super::maker::Maker;
use proptest::prelude::*;
use shadegate_gen::compile::Simulator;
use shadegate_gen::netlist::{Format, SignalKind};

fn agree(seed: u64, depth: u32) {
    let mut maker = Maker::new(seed);
    let m = maker.module(depth);
    let mut simulator = Simulator::new(&m).unwrap_or_else(|e| panic!("seed {seed}: {e}"));
    let mut model = Interpreter::new(&m);
    let inputs: Vec<_> = m
        .signals
        .iter()
        .filter(|s| s.kind == SignalKind::Input && s.format != Format::Clock)
        .collect();
    let handles: Vec<_> = simulator
        .signals()
        .map(|(name, _, signal)| (name.to_string(), signal))
        .collect();
    for clock in 0..150 {
        for s in &inputs {
            if clock % 3 != 0 {
                let code = maker.code(s.format.width());
                let input = simulator.input(&s.name).expect("declared");
                simulator.set(input, code);
                model.wires.insert(s.name.clone(), code);
            }
        }
        let only_settle = clock % 10 == 9;
        if only_settle {
            simulator.settle();
            model.settle();
        } else {
            simulator.clock();
            model.clock();
        }
        for s in m.signals.iter().filter(|s| s.kind == SignalKind::Output) {
            let output = simulator.output(&s.name).expect("declared");
            let (got, want) = (simulator.get(output), model.wires[&s.name]);
            assert_eq!(
                got, want,
                "seed {seed}, clock {clock}: {} of {m:#?}",
                s.name
            );
        }
        // Every wire and register, in some clocks only: peeking must not be what keeps the state right.
        if clock % 7 == 6 {
            for (name, handle) in &handles {
                let wire = || model.wires.get(name);
                let want = model.registers.get(name).or_else(wire).expect("modelled");
                let got = simulator.peek(*handle).expect("compiles");
                assert_eq!(got, *want, "seed {seed}, clock {clock}: {name} of {m:#?}");
            }
            for (path, words) in &model.memories {
                let memory = simulator.memory(path).expect("declared");
                for (address, word) in words.iter().enumerate() {
                    assert_eq!(simulator.word(memory, address), Some(*word), "{path}");
                }
                assert_eq!(simulator.word(memory, words.len()), None);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn one_module(seed: u64) {
        agree(seed, 0);
    }

    #[test]
    fn a_hierarchy(seed: u64) {
        agree(seed, 3);
    }
}
