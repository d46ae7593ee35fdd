//! Blocks that are only simulated when one of their inputs moves.
//!
//! rust-hdl visits the whole hierarchy in every pass until nothing changes anywhere. A [`Quiet`] block
//!
//! * returns at once when it was stable and its inputs are what they were;
//! * takes its inputs before it evaluates its equations, not after, which saves a pass per level;
//! * repeats until it is stable itself, so that one pass of its parent sees final outputs;
//! * reports a change to its parent only when an output changed.
//!
//! Probes see the inner block under the same name; the emitted Verilog cannot tell the difference.
//!
//! Edges stay free of races: a rising clock reaches the whole hierarchy in one pass from the top down, every block
//! evaluates its equations before its children, and [`super::Register`]s are children. So every register takes
//! what the state before the edge implied, provided the design was settled then.

use super::MAX_PASSES;
use rust_hdl_core::prelude::*;
use std::ops::{Deref, DerefMut};

/// The ports of a description. Write it with [`crate::ports!`] or [`crate::clocked!`]; [`check_ports`] proves the list.
pub trait Ports: Block {
    /// The names of the inputs and outputs listed.
    fn port_names() -> (&'static [&'static str], &'static [&'static str])
    where
        Self: Sized;
    /// An input was given a value that the block has not seen.
    fn inputs_pending(&self) -> bool;
    /// Makes the inputs' new values visible to the block.
    fn take_inputs(&mut self);
    /// Whether an output changed in the last pass. Clears the marks: nothing inside depends on an output, so its
    /// change is no reason for another pass.
    fn take_output_changes(&mut self) -> bool;
}

/// A block that costs a comparison of its inputs while nothing moves. Use it like the block itself.
#[derive(Clone, Debug, Default)]
pub struct Quiet<B> {
    inner: B,
    stable: bool,
    changed: bool,
}

impl<B> From<B> for Quiet<B> {
    fn from(inner: B) -> Self {
        Self {
            inner,
            stable: false,
            changed: false,
        }
    }
}

impl<B> Quiet<B> {
    /// Whether the last update came to rest.
    #[must_use]
    #[inline(always)]
    pub fn is_stable(&self) -> bool {
        self.stable
    }
}

impl<B> Deref for Quiet<B> {
    type Target = B;
    #[inline(always)]
    fn deref(&self) -> &B {
        &self.inner
    }
}

impl<B> DerefMut for Quiet<B> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut B {
        &mut self.inner
    }
}

impl<B: Ports> Logic for Quiet<B> {
    fn update(&mut self) {
        self.inner.update();
    }

    fn connect(&mut self) {
        self.inner.connect();
    }

    fn hdl(&self) -> Verilog {
        self.inner.hdl()
    }

    fn timing(&self) -> Vec<TimingInfo> {
        self.inner.timing()
    }
}

impl<B: Ports> Block for Quiet<B> {
    fn connect_all(&mut self) {
        self.inner.connect_all();
    }

    #[inline]
    fn update_all(&mut self) {
        self.changed = false;
        if self.stable && !self.inner.inputs_pending() {
            return;
        }
        self.inner.take_inputs();
        for _ in 0..MAX_PASSES {
            self.inner.update_all();
            self.changed |= self.inner.take_output_changes();
            self.stable = !self.inner.has_changed();
            if self.stable {
                return;
            }
        }
    }

    #[inline(always)]
    fn has_changed(&self) -> bool {
        self.changed || !self.stable
    }

    fn accept(&self, name: &str, probe: &mut dyn Probe) {
        self.inner.accept(name, probe);
    }
}

/// The names of a block's own inputs and outputs, as a probe sees them.
#[derive(Default)]
struct OwnPorts {
    depth: usize,
    inputs: Vec<String>,
    outputs: Vec<String>,
}

impl Probe for OwnPorts {
    fn visit_start_scope(&mut self, _name: &str, _node: &dyn Block) {
        self.depth += 1;
    }

    fn visit_atom(&mut self, name: &str, signal: &dyn Atom) {
        if self.depth == 1 {
            match signal.kind() {
                AtomKind::InputParameter => self.inputs.push(name.into()),
                AtomKind::OutputParameter => self.outputs.push(name.into()),
                _ => {}
            }
        }
    }

    fn visit_end_scope(&mut self, _name: &str, _node: &dyn Block) {
        self.depth -= 1;
    }
}

/// Checks that a description's list of ports is complete: an input left out would freeze the block.
///
/// # Errors
/// Both lists, when they differ from what a probe finds.
pub fn check_ports<B: Ports>(block: &B) -> Result<(), String> {
    let mut found = OwnPorts::default();
    block.accept("block", &mut found);
    let (inputs, outputs) = B::port_names();
    if found.inputs == inputs && found.outputs == outputs {
        Ok(())
    } else {
        Err(format!(
            "listed {inputs:?} and {outputs:?}, found {:?} and {:?}",
            found.inputs, found.outputs
        ))
    }
}

/// Implements [`Ports`](crate::simulate::Ports): `ports!(Type<N>, const N: usize; inputs a, b; outputs c)`, in the
/// order of the fields.
#[macro_export]
macro_rules! ports {
    ($type:ty $(, const $n:ident: $t:ty)*; inputs $($input:ident),+; outputs $($output:ident),+) => {
        impl<$(const $n: $t),*> $crate::simulate::Ports for $type {
            fn port_names() -> (&'static [&'static str], &'static [&'static str]) {
                (&[$(stringify!($input)),+], &[$(stringify!($output)),+])
            }

            #[inline(always)]
            fn inputs_pending(&self) -> bool {
                $(self.$input.next != self.$input.val())||+
            }

            #[inline(always)]
            fn take_inputs(&mut self) {
                $(rust_hdl_core::prelude::Block::update_all(&mut self.$input);)+
            }

            #[inline(always)]
            fn take_output_changes(&mut self) -> bool {
                let changed = $(self.$output.changed)||+;
                $(self.$output.changed = false;)+
                changed
            }
        }
    };
}

/// Implements [`Ports`](crate::simulate::Ports) and [`Clocked`](crate::simulate::Clocked) for a description whose
/// first port is its clock, called `clock`; the list names the other ports.
#[macro_export]
macro_rules! clocked {
    ($type:ty $(, const $n:ident: $t:ty)*; inputs $($input:ident),+; outputs $($output:ident),+) => {
        $crate::ports!($type $(, const $n: $t)*; inputs clock, $($input),+; outputs $($output),+);

        impl<$(const $n: $t),*> $crate::simulate::Clocked for $type {
            fn clock_input(&mut self) -> &mut rust_hdl_core::prelude::Signal<rust_hdl_core::prelude::In, rust_hdl_core::prelude::Clock> {
                &mut self.clock
            }
        }
    };
}
