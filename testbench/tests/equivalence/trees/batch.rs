//! Many trees as one description, which rust-hdl simulates like any other: `update` computes them with its own types,
//! `hdl` shows the trees that `#[hdl_gen]` would have made.

use super::tree::{inputs, Tree};
use super::value::{Format, Value};
use crate::harness::code::{Driven, Port};
use rust_hdl_core::ast::{VerilogExpression, VerilogStatement};
use rust_hdl_core::prelude::*;

/// A signal whose format is known at run time.
struct Pin {
    name: String,
    format: Format,
    kind: AtomKind,
    next: Value,
    value: Value,
    changed: bool,
}

impl Pin {
    fn new(name: &str, format: Format, kind: AtomKind) -> Self {
        let zero = Value::of(format, 0);
        Self {
            name: name.to_string(),
            format,
            kind,
            next: zero,
            value: zero,
            changed: false,
        }
    }

    fn update(&mut self) {
        self.changed = self.value != self.next;
        self.value = self.next;
    }
}

impl Atom for Pin {
    fn bits(&self) -> usize {
        match self.format {
            Format::Bit => 1,
            Format::Word(n) | Format::Int(n) => n,
        }
    }

    fn connected(&self) -> bool {
        true
    }

    fn changed(&self) -> bool {
        self.changed
    }

    fn kind(&self) -> AtomKind {
        self.kind
    }

    fn descriptor(&self) -> TypeDescriptor {
        let (name, kind) = match self.format {
            Format::Bit => ("Bit".to_string(), TypeKind::Bits(1)),
            Format::Word(n) => (format!("Bits::<{n}>"), TypeKind::Bits(n)),
            Format::Int(n) => (format!("Signed::<{n}>"), TypeKind::Signed(n)),
        };
        TypeDescriptor { name, kind }
    }

    fn vcd(&self) -> VCDValue {
        VCDValue::String(self.name.clone())
    }

    fn verilog(&self) -> VerilogLiteral {
        self.value.literal()
    }

    fn id(&self) -> usize {
        0
    }

    fn constraints(&self) -> Vec<PinConstraint> {
        vec![]
    }
}

/// Trees side by side: outputs `o0`, `o1`, …
pub struct Batch {
    inputs: Vec<Pin>,
    outputs: Vec<Pin>,
    trees: Vec<Tree>,
    /// Trees that rust-hdl cannot compute for the present inputs.
    pub undefined: Vec<bool>,
}

impl Batch {
    pub fn new(trees: &[Tree]) -> Self {
        let outputs = trees.iter().enumerate();
        let list = inputs();
        Self {
            inputs: list
                .iter()
                .map(|(n, f)| Pin::new(n, *f, AtomKind::InputParameter))
                .collect(),
            outputs: outputs
                .map(|(i, t)| Pin::new(&format!("o{i}"), t.format, AtomKind::OutputParameter))
                .collect(),
            undefined: vec![false; trees.len()],
            trees: trees.to_vec(),
        }
    }
}

impl Logic for Batch {
    fn update(&mut self) {
        let values: Vec<Value> = self.inputs.iter().map(|p| p.value).collect();
        for (i, tree) in self.trees.iter().enumerate() {
            let value = tree.value(&values);
            self.undefined[i] = value.is_none();
            if let Some(value) = value {
                self.outputs[i].next = value;
            }
        }
    }

    fn hdl(&self) -> Verilog {
        let assign = |(i, tree): (usize, &Tree)| {
            VerilogStatement::Assignment(
                VerilogExpression::Signal(format!("o{i}$next")),
                tree.expression(),
            )
        };
        Verilog::Combinatorial(self.trees.iter().enumerate().map(assign).collect())
    }
}

impl Block for Batch {
    fn connect_all(&mut self) {}

    fn update_all(&mut self) {
        self.update();
        self.inputs
            .iter_mut()
            .chain(&mut self.outputs)
            .for_each(Pin::update);
    }

    fn has_changed(&self) -> bool {
        self.inputs.iter().chain(&self.outputs).any(|p| p.changed)
    }

    fn accept(&self, name: &str, probe: &mut dyn Probe) {
        probe.visit_start_scope(name, self);
        for p in self.inputs.iter().chain(&self.outputs) {
            probe.visit_atom(&p.name, p);
        }
        probe.visit_end_scope(name, self);
    }
}

impl Driven for Batch {
    fn inputs(&self) -> Vec<Port> {
        let port = |p: &Pin| Port {
            name: p.name.clone(),
            width: p.bits(),
        };
        self.inputs.iter().map(port).collect()
    }

    fn set(&mut self, input: usize, code: u128) {
        let format = self.inputs[input].format;
        self.inputs[input].next = Value::of(format, code);
    }

    fn connect_inputs(&mut self) {}

    fn set_clock(&mut self, _: bool) {}

    fn has_clock(&self) -> bool {
        false
    }

    fn rust_hdl_text(&self) -> String {
        generate_verilog_unchecked(self)
    }
}
