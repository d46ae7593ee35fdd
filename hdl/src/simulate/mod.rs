//! Clocking a description in one thread: set the inputs, let the design settle, raise and lower the clock.
//!
//! rust-hdl's own `Simulation` hands control between threads several times a clock; this loop does the same settling
//! hundreds of times faster and needs no test bench thread.

use rust_hdl_core::prelude::*;

/// Passes after which a design that still changes is taken to oscillate.
const MAX_PASSES: usize = 200;

/// A description that has one clock input.
pub trait Clocked: Block {
    /// The clock input.
    fn clock_input(&mut self) -> &mut Signal<In, Clock>;
}

/// A connected, checked and settled description, ready to be clocked.
pub struct Simulator<B: Clocked> {
    /// The design; write its inputs' `next`, read its outputs' `val()`.
    pub design: Box<B>,
}

impl<B: Clocked> Simulator<B> {
    /// Connects and checks the design.
    ///
    /// # Errors
    /// What rust-hdl's own checks find: undriven inputs, logic loops, writes to inputs.
    pub fn new(design: B) -> Result<Self, String> {
        let mut design = Box::new(design);
        design.connect_all();
        check_all(design.as_ref()).map_err(|e| format!("{e:?}"))?;
        let mut simulator = Self { design };
        simulator.settle();
        Ok(simulator)
    }

    /// Propagates until nothing changes.
    ///
    /// # Panics
    /// When the design oscillates, which the checks in [`Simulator::new`] exclude.
    #[inline]
    pub fn settle(&mut self) {
        for _ in 0..MAX_PASSES {
            self.design.update_all();
            if !self.design.has_changed() {
                return;
            }
        }
        panic!("the design did not settle in {MAX_PASSES} passes");
    }

    /// One clock: the inputs set before the call are seen by the rising edge; afterwards the outputs show the state
    /// behind that edge.
    #[inline]
    pub fn clock(&mut self) {
        self.settle();
        self.design.clock_input().next = true.into();
        self.settle();
        self.design.clock_input().next = false.into();
        self.settle();
    }
}

/// Implements [`Clocked`] for a description whose clock input is called `clock`.
#[macro_export]
macro_rules! clocked {
    ($type:ty $(, $(const $n:ident: $t:ty),+)?) => {
        impl $(<$(const $n: $t),+>)? $crate::simulate::Clocked for $type {
            fn clock_input(&mut self) -> &mut rust_hdl_core::prelude::Signal<rust_hdl_core::prelude::In, rust_hdl_core::prelude::Clock> {
                &mut self.clock
            }
        }
    };
}
