//! Clocking a description in one thread: set the inputs, let the design settle, raise and lower the clock.
//!
//! rust-hdl's own `Simulation` hands control between threads several times a clock and visits every signal in every
//! pass; this simulator needs no test bench thread, and [`Quiet`] blocks and [`Register`]s are visited only when
//! something moves.

mod quiet;
mod register;

pub use quiet::{check_ports, Ports, Quiet};
pub use register::{Pin, Register, Wire};

use rust_hdl_core::prelude::*;

/// Passes after which a design that still changes is taken to oscillate.
const MAX_PASSES: usize = 200;

/// A description that has one clock input.
pub trait Clocked: Ports {
    /// The clock input.
    fn clock_input(&mut self) -> &mut Signal<In, Clock>;
}

/// A connected, checked and settled description, ready to be clocked.
pub struct Simulator<B: Clocked> {
    /// The design; write its inputs' `next`, read its outputs' `val()`.
    pub design: Box<Quiet<B>>,
}

impl<B: Clocked> Simulator<B> {
    /// Connects and checks the design.
    ///
    /// # Errors
    /// What rust-hdl's own checks find: undriven inputs, logic loops, writes to inputs.
    pub fn new(design: B) -> Result<Self, String> {
        let mut design = Box::new(Quiet::from(design));
        design.connect_all();
        check_all(design.as_ref()).map_err(|e| format!("{e:?}"))?;
        let mut simulator = Self { design };
        simulator.settle();
        Ok(simulator)
    }

    /// Propagates until nothing changes: afterwards the outputs show what inputs and state imply.
    ///
    /// # Panics
    /// When the design oscillates, which the checks in [`Simulator::new`] exclude.
    #[inline]
    pub fn settle(&mut self) {
        self.design.update_all();
        assert!(
            self.design.is_stable(),
            "the design did not settle in {MAX_PASSES} passes"
        );
    }

    /// One clock: the inputs set before the call are seen by the rising edge; afterwards the outputs show the state
    /// behind that edge. (The falling edge is made together with the next inputs; nothing reacts to it.)
    #[inline]
    pub fn clock(&mut self) {
        self.design.clock_input().next = false.into();
        self.settle();
        self.design.clock_input().next = true.into();
        self.settle();
    }
}
