//! A constant along a span: f(k) = c (Abbas 2003, section 2.1.1).

use crate::format::{signed_cast_align, Q};
use crate::simulate::Register;
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Holds the value of a span. Latency: one clock from `load`.
#[derive(LogicBlock, Default)]
pub struct Constant1<const M: usize, const N: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Takes `start`.
    pub load: Signal<In, Bit>,
    /// Value of the next span.
    pub start: Signal<In, Q<M, N>>,
    /// Integer part of the value of the current span, rounded down.
    pub value: Signal<Out, Q<M, 0>>,
    /// Value of the current span.
    held: Register<Q<M, N>>,
}

impl<const M: usize, const N: usize> Logic for Constant1<M, N> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name constant_1");
        comment!("title A constant along a span.");
        comment!("equation f(k) = c");
        comment!("source Abbas 2003, section 2.1.1.");
        comment!("latency One clock from load to value.");
        dff_setup!(self, clock, held);
        if self.load.val() {
            self.held.d.next = self.start.val();
        }
        self.value.next = signed_cast_align::<M, 0, M, N>(self.held.q.val());
    }
}

crate::clocked!(Constant1<M, N>, const M: usize, const N: usize;
    inputs load, start;
    outputs value);

/// Integer model of [`Constant1`]: codes of one width.
#[derive(Clone, Copy, Debug, Default)]
pub struct Constant1Model {
    /// Value of the current span.
    pub value: i64,
}

impl Constant1Model {
    /// One clock.
    pub fn clock(&mut self, load: bool, start: i64) {
        if load {
            self.value = start;
        }
    }
}
