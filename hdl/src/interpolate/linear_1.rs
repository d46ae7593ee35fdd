//! A linear function along a span: f(k) = c + d·k (Abbas 2003, section 2.1.2).
//!
//! Each step adds d once, so after k steps the error is e(c) + k·e(d), e being the rounding of a word.

use crate::format::{signed_cast_align, wrap, Q};
use crate::simulate::Register;
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// One accumulator. Latency: one clock from `load`; one value per clock while `run`.
#[derive(LogicBlock, Default)]
pub struct Linear1<const M: usize, const N: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Takes the start values; wins over `run`.
    pub load: Signal<In, Bit>,
    /// Steps one pixel.
    pub run: Signal<In, Bit>,
    /// Value at the first pixel.
    pub start: Signal<In, Q<M, N>>,
    /// Difference from pixel to pixel.
    pub step: Signal<In, Q<M, N>>,
    /// Integer part of the value at the current pixel, rounded down.
    pub value: Signal<Out, Q<M, 0>>,
    /// Value at the current pixel.
    total: Register<Q<M, N>>,
    /// Difference from pixel to pixel.
    first: Register<Q<M, N>>,
}

impl<const M: usize, const N: usize> Logic for Linear1<M, N> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name linear_1");
        comment!("title A linear function along a span, by its first difference.");
        comment!("equation f(k) = c + d k;  f(k+1) = f(k) + d");
        comment!("source Abbas 2003, section 2.1.2.");
        comment!("latency One clock from load to value; one value per clock.");
        dff_setup!(self, clock, total, first);
        if self.load.val() {
            self.total.d.next = self.start.val();
            self.first.d.next = self.step.val();
        } else if self.run.val() {
            self.total.d.next = self.total.q.val() + self.first.q.val();
        }
        self.value.next = signed_cast_align::<M, 0, M, N>(self.total.q.val());
    }
}

crate::clocked!(Linear1<M, N>, const M: usize, const N: usize;
    inputs load, run, start, step;
    outputs value);

/// Integer model of [`Linear1`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Linear1Model {
    /// Value at the current pixel.
    pub value: i64,
    first: i64,
}

impl Linear1Model {
    /// One clock of a module of `width` bits.
    pub fn clock(&mut self, width: usize, load: bool, run: bool, start: i64, step: i64) {
        if load {
            *self = Self {
                value: start,
                first: step,
            };
        } else if run {
            self.value = wrap(self.value.wrapping_add(self.first), width);
        }
    }
}
