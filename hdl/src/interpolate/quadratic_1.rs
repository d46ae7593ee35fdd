//! A quadratic function along a span: f(k) = c + d·k + dd·k(k − 1)/2 (Abbas 2003, section 2.1.3).
//!
//! With e the rounding of a word, the error after k steps is e(c) + k·e(d) + k(k − 1)/2·e(dd).
//! (Abbas 2.9 prints the sum of 1..M as M(M − 1)/2; it is M(M + 1)/2.)

use crate::format::{signed_cast_align, wrap, Q};
use crate::simulate::Register;
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Two accumulators. Latency: one clock from `load`; one value per clock while `run`.
#[derive(LogicBlock, Default)]
pub struct Quadratic1<const M: usize, const N: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Takes the start values; wins over `run`.
    pub load: Signal<In, Bit>,
    /// Steps one pixel.
    pub run: Signal<In, Bit>,
    /// Value at the first pixel.
    pub start: Signal<In, Q<M, N>>,
    /// First difference at the first pixel.
    pub step: Signal<In, Q<M, N>>,
    /// Second difference.
    pub bend: Signal<In, Q<M, N>>,
    /// Integer part of the value at the current pixel, rounded down.
    pub value: Signal<Out, Q<M, 0>>,
    /// Value at the current pixel.
    total: Register<Q<M, N>>,
    /// First difference at the current pixel.
    first: Register<Q<M, N>>,
    /// Second difference.
    second: Register<Q<M, N>>,
}

impl<const M: usize, const N: usize> Logic for Quadratic1<M, N> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name quadratic_1");
        comment!("title A quadratic function along a span, by its first and second differences.");
        comment!("equation f(k+1) = f(k) + d(k);  d(k+1) = d(k) + dd");
        comment!("source Abbas 2003, section 2.1.3 and figure 2.3.");
        comment!("latency One clock from load to value; one value per clock.");
        dff_setup!(self, clock, total, first, second);
        if self.load.val() {
            self.total.d.next = self.start.val();
            self.first.d.next = self.step.val();
            self.second.d.next = self.bend.val();
        } else if self.run.val() {
            self.total.d.next = self.total.q.val() + self.first.q.val();
            self.first.d.next = self.first.q.val() + self.second.q.val();
        }
        self.value.next = signed_cast_align::<M, 0, M, N>(self.total.q.val());
    }
}

crate::clocked!(Quadratic1<M, N>, const M: usize, const N: usize;
    inputs load, run, start, step, bend;
    outputs value);

/// Integer model of [`Quadratic1`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Quadratic1Model {
    /// Value at the current pixel.
    pub value: i64,
    first: i64,
    second: i64,
}

impl Quadratic1Model {
    /// One clock of a module of `width` bits.
    pub fn clock(&mut self, width: usize, load: bool, run: bool, start: i64, step: i64, bend: i64) {
        if load {
            *self = Self {
                value: start,
                first: step,
                second: bend,
            };
        } else if run {
            self.value = wrap(self.value.wrapping_add(self.first), width);
            self.first = wrap(self.first.wrapping_add(self.second), width);
        }
    }
}
