//! Registers and wires for fast simulation: the same atoms, blocks and Verilog as rust-hdl's `DFF` and local signals.
//!
//! rust-hdl's flip-flop is made of three general signals and needs three passes to see an edge. This one keeps a word
//! per port and fires in the pass in which its parent raises the clock; the parent has computed `d` from the state
//! before the edge in that same pass, so no race arises.

use rust_hdl_core::prelude::*;
use rust_hdl_core::signal::get_signal_id;
use std::marker::PhantomData;

/// A wire or a port of a [`Register`]: a word and what probes ask about it.
#[derive(Clone, Debug)]
pub struct Pin<D: Direction, T: Synth> {
    /// The value.
    pub next: T,
    id: u32,
    connected: bool,
    direction: PhantomData<D>,
}

impl<D: Direction, T: Synth> Pin<D, T> {
    /// The value.
    #[must_use]
    #[inline(always)]
    pub fn val(&self) -> T {
        self.next
    }
}

impl<D: Direction, T: Synth> Default for Pin<D, T> {
    fn default() -> Self {
        Self {
            next: T::default(),
            id: get_signal_id() as u32,
            connected: false,
            direction: PhantomData,
        }
    }
}

impl<D: Direction, T: Synth> Atom for Pin<D, T> {
    fn bits(&self) -> usize {
        T::BITS
    }

    fn connected(&self) -> bool {
        self.connected
    }

    fn changed(&self) -> bool {
        false
    }

    fn kind(&self) -> AtomKind {
        D::KIND
    }

    fn descriptor(&self) -> TypeDescriptor {
        T::descriptor()
    }

    fn vcd(&self) -> VCDValue {
        self.next.vcd()
    }

    fn id(&self) -> usize {
        self.id as usize
    }

    fn verilog(&self) -> VerilogLiteral {
        self.next.verilog()
    }

    fn constraints(&self) -> Vec<PinConstraint> {
        vec![]
    }
}

impl<D: Direction, T: Synth> Logic for Pin<D, T> {
    fn update(&mut self) {}

    fn connect(&mut self) {
        self.connected = true;
    }
}

impl<D: Direction, T: Synth> Block for Pin<D, T> {
    fn connect_all(&mut self) {}

    #[inline(always)]
    fn update_all(&mut self) {}

    #[inline(always)]
    fn has_changed(&self) -> bool {
        false
    }

    fn accept(&self, name: &str, probe: &mut dyn Probe) {
        probe.visit_atom(name, self);
    }
}

/// An intermediate value. Its block writes it before it reads it, in every pass, so a new value is no reason for
/// another pass (rust-hdl's `Signal<Local, T>` would ask for one).
pub type Wire<T> = Pin<Local, T>;

/// A register of any format, zero at power-up. Drive it with rust-hdl's `dff_setup!`.
#[derive(Clone, Debug, Default)]
pub struct Register<T: Synth> {
    /// The value after the next rising edge.
    pub d: Pin<In, T>,
    /// The value now.
    pub q: Pin<Out, T>,
    /// Clock.
    pub clock: Pin<In, Clock>,
    was_high: bool,
    changed: bool,
}

impl<T: Synth> Logic for Register<T> {
    fn update(&mut self) {}

    fn connect(&mut self) {
        self.q.connect();
    }

    fn hdl(&self) -> Verilog {
        Verilog::Custom(format!(
            "\
initial begin
   q = {:x};
end

always @(posedge clock) begin
   q <= d;
end
      ",
            T::default().verilog()
        ))
    }

    fn timing(&self) -> Vec<TimingInfo> {
        vec![TimingInfo {
            name: "dff".into(),
            clock: "clock".into(),
            inputs: vec!["d".into()],
            outputs: vec!["q".into()],
        }]
    }
}

impl<T: Synth> Block for Register<T> {
    fn connect_all(&mut self) {
        self.connect();
    }

    #[inline(always)]
    fn update_all(&mut self) {
        let high = self.clock.next.clk;
        self.changed = high && !self.was_high && self.q.next != self.d.next;
        if self.changed {
            self.q.next = self.d.next;
        }
        self.was_high = high;
    }

    #[inline(always)]
    fn has_changed(&self) -> bool {
        self.changed
    }

    fn accept(&self, name: &str, probe: &mut dyn Probe) {
        probe.visit_start_scope(name, self);
        probe.visit_atom("d", &self.d);
        probe.visit_atom("q", &self.q);
        probe.visit_atom("clock", &self.clock);
        probe.visit_end_scope(name, self);
    }
}
