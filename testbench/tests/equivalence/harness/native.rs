//! rust-hdl's own simulation, the authority: one thread, a settle loop, no shortcuts.

use super::code::{Driven, Port};
use rust_hdl_core::prelude::{Atom, AtomKind, Block, Probe};

/// Passes after which a description is taken to oscillate.
const MAX_PASSES: usize = 1000;

/// Propagates until nothing changes.
pub fn settle(design: &mut dyn Driven) {
    for _ in 0..MAX_PASSES {
        design.update_all();
        if !design.has_changed() {
            return;
        }
    }
    panic!("the description does not settle in {MAX_PASSES} passes");
}

/// The outputs of a design: the atoms of its own scope.
#[derive(Default)]
struct Outputs {
    depth: usize,
    namespaces: Vec<String>,
    found: Vec<(Port, u128)>,
}

impl Probe for Outputs {
    fn visit_start_scope(&mut self, _: &str, _: &dyn Block) {
        self.depth += 1;
    }

    fn visit_end_scope(&mut self, _: &str, _: &dyn Block) {
        self.depth -= 1;
    }

    fn visit_start_namespace(&mut self, name: &str, _: &dyn Block) {
        self.namespaces.push(name.to_string());
    }

    fn visit_end_namespace(&mut self, _: &str, _: &dyn Block) {
        self.namespaces.pop();
    }

    fn visit_atom(&mut self, name: &str, atom: &dyn Atom) {
        if self.depth != 1 || atom.kind() != AtomKind::OutputParameter {
            return;
        }
        let mut path = self.namespaces.clone();
        path.push(name.to_string());
        let text = format!("{:x}", atom.verilog());
        let digits = text.split_once("'h").expect("a sized literal").1;
        let port = Port {
            name: path.join("_").replace('$', "_"),
            width: atom.bits(),
        };
        let code = u128::from_str_radix(digits, 16).expect("no negative literals");
        self.found.push((port, code));
    }
}

/// The outputs with their codes, in order of declaration.
pub fn outputs(design: &dyn Driven) -> Vec<(Port, u128)> {
    let mut probe = Outputs::default();
    design.accept("top", &mut probe);
    probe.found
}

/// The outputs' codes.
pub fn codes(design: &dyn Driven) -> Vec<u128> {
    outputs(design).into_iter().map(|(_, code)| code).collect()
}

/// Runs a connected design: per vector the settled outputs with the clock low, and, if it has a clock, again behind the
/// rising edge.
pub fn run(design: &mut dyn Driven, vectors: &[Vec<u128>], clocked: bool) -> Vec<Vec<u128>> {
    let mut samples = vec![];
    for vector in vectors {
        for (i, code) in vector.iter().enumerate() {
            design.set(i, *code);
        }
        design.set_clock(false);
        settle(design);
        samples.push(codes(design));
        if clocked {
            design.set_clock(true);
            settle(design);
            samples.push(codes(design));
        }
    }
    samples
}
