//! The real cores clock by clock against rust-hdl's simulation of the same description.

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use rust_hdl_core::prelude::{Atom, Block, Probe};
use shadegate_gen::compile::CompiledCore;
use shadegate_gen::scene::TEXTURED;
use shadegate_hdl::bump::Bend;
use shadegate_hdl::shade::device::{Core, CoreSimulator};
use shadegate_hdl::shade::model::{CoreInputs, Order};
use std::collections::BTreeMap;

const CLOCKS: usize = 60_000;

/// Every atom of a description with its code, by dotted name; a register by its own.
#[derive(Default)]
struct Atoms {
    path: Vec<String>,
    codes: BTreeMap<String, u128>,
}

impl Probe for Atoms {
    fn visit_start_scope(&mut self, name: &str, _: &dyn Block) {
        self.path.push(name.to_string());
    }

    fn visit_end_scope(&mut self, _: &str, _: &dyn Block) {
        self.path.pop();
    }

    fn visit_atom(&mut self, name: &str, atom: &dyn Atom) {
        let text = format!("{:x}", atom.verilog());
        let Some((_, digits)) = text.split_once('\'') else {
            return;
        };
        let radix = if digits.starts_with('b') { 2 } else { 16 };
        let code = u128::from_str_radix(&digits[1..], radix);
        let path = self.path[1..].join(".");
        let dot = if path.is_empty() { "" } else { "." };
        let full = format!("{path}{dot}{name}");
        let full = full.strip_suffix(".q").unwrap_or(&full);
        self.codes.insert(full.to_string(), code.expect("a number"));
    }
}

fn noise(r: &mut StdRng, clock: usize) -> CoreInputs {
    let select = if r.random() {
        r.random_range(0..12)
    } else {
        r.random()
    };
    let rows = r.random_range(0..9u64);
    CoreInputs {
        write: r.random_ratio(15, 16),
        select,
        // Few rows, or every triangle would take a million clocks.
        data: match select {
            0 => r.random_range(0..2u64) << 22 | rows << 11 | rows,
            11 => r.random_range(1..200),
            _ => r.random(),
        },
        start: r.random_ratio(1, 30),
        clear: clock > CLOCKS / 2 && r.random_ratio(1, 2000),
        ready: r.random_ratio(7, 8),
        ..CoreInputs::default()
    }
}

fn agree(order: Order, size: (u32, u32)) {
    let core = Core::for_frame(order, size.0, size.1).expect("in range");
    let mut described = CoreSimulator::new(core).expect("connects");
    let mut compiled = CompiledCore::new(core).unwrap_or_else(|e| panic!("{e}"));
    let signals: Vec<_> = compiled
        .simulator()
        .signals()
        .map(|(name, _, signal)| (name.to_string(), signal))
        .collect();
    assert!(signals.len() > 150, "{} signals", signals.len());
    let mut r = StdRng::seed_from_u64(11);
    let (mut seen, mut busy) = (0, 0);
    for clock in 0..CLOCKS {
        let inputs = noise(&mut r, clock);
        described.clock(&inputs);
        compiled.clock(&inputs);
        let outputs = compiled.outputs();
        assert_eq!(outputs, described.outputs(), "{core:?}, clock {clock}");
        busy += usize::from(outputs.busy);
        if clock % 97 != 0 {
            continue;
        }
        let mut atoms = Atoms::default();
        described.design().accept("top", &mut atoms);
        for (name, signal) in &signals {
            if let Some(want) = atoms.codes.get(name) {
                let got = compiled.simulator().peek(*signal).expect("compiles");
                assert_eq!(got, *want, "{core:?}, clock {clock}: {name}");
                seen += 1;
            }
        }
    }
    assert!(busy > CLOCKS / 2, "{busy} clocks with work");
    // Nearly every signal has its atom.
    let checks = signals.len() * CLOCKS.div_ceil(97);
    assert!(seen * 10 > checks * 9, "{seen} of {checks} compared");
}

#[test]
fn quadratic() {
    agree(Order::Quadratic, (96, 64));
    agree(Order::Quadratic, (1030, 9));
}

#[test]
fn gouraud() {
    agree(Order::Linear, (96, 64));
    agree(Order::Linear, (1030, 9));
}

#[test]
fn bumps() {
    agree(Order::Bump(Bend::Newton), (96, 64));
    agree(Order::Bump(Bend::Reflection), (1030, 9));
}

#[test]
fn textured() {
    for (_, order) in TEXTURED {
        agree(order, (96, 64));
    }
    agree(TEXTURED[2].1, (1030, 9));
}
