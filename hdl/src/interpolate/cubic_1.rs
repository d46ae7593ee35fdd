//! A cubic function along a span: f(k) = c + d·k + dd·k(k − 1)/2 + ddd·k(k − 1)(k − 2)/6.
//!
//! Abbas (2003, section 2.1) stops at the quadratic; the third difference continues his figure 2.3 by one accumulator
//! (Newton's forward formula). With e the rounding of a word, the error after k steps is
//! e(c) + k·e(d) + k(k − 1)/2·e(dd) + k(k − 1)(k − 2)/6·e(ddd), see [`super::run`].

use crate::format::{signed_cast_align, wrap, Q};
use crate::simulate::Register;
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Three accumulators. Latency: one clock from `load`; one value per clock while `run`.
#[derive(LogicBlock, Default)]
pub struct Cubic1<const M: usize, const N: usize> {
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
    /// Second difference at the first pixel.
    pub bend: Signal<In, Q<M, N>>,
    /// Third difference.
    pub twist: Signal<In, Q<M, N>>,
    /// Integer part of the value at the current pixel, rounded down.
    pub value: Signal<Out, Q<M, 0>>,
    /// Value at the current pixel.
    total: Register<Q<M, N>>,
    /// First difference at the current pixel.
    first: Register<Q<M, N>>,
    /// Second difference at the current pixel.
    second: Register<Q<M, N>>,
    /// Third difference.
    third: Register<Q<M, N>>,
}

impl<const M: usize, const N: usize> Logic for Cubic1<M, N> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name cubic_1");
        comment!(
            "title A cubic function along a span, by its first, second and third differences."
        );
        comment!("equation f(k+1) = f(k) + d(k);  d(k+1) = d(k) + dd(k);  dd(k+1) = dd(k) + ddd");
        comment!("source Newton's forward differences, as figure 2.3 of Abbas 2003 with one accumulator more.");
        comment!("latency One clock from load to value; one value per clock.");
        dff_setup!(self, clock, total, first, second, third);
        if self.load.val() {
            self.total.d.next = self.start.val();
            self.first.d.next = self.step.val();
            self.second.d.next = self.bend.val();
            self.third.d.next = self.twist.val();
        } else if self.run.val() {
            self.total.d.next = self.total.q.val() + self.first.q.val();
            self.first.d.next = self.first.q.val() + self.second.q.val();
            self.second.d.next = self.second.q.val() + self.third.q.val();
        }
        self.value.next = signed_cast_align::<M, 0, M, N>(self.total.q.val());
    }
}

crate::clocked!(Cubic1<M, N>, const M: usize, const N: usize;
    inputs load, run, start, step, bend, twist;
    outputs value);

/// Integer model of [`Cubic1`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Cubic1Model {
    /// Value at the current pixel.
    pub value: i64,
    differences: [i64; 3],
}

impl Cubic1Model {
    /// One clock of a module of `width` bits; `words` are the value and its first, second and third difference.
    pub fn clock(&mut self, width: usize, load: bool, run: bool, words: [i64; 4]) {
        let [first, second, third] = self.differences;
        let add = |a: i64, b: i64| wrap(a.wrapping_add(b), width);
        if load {
            self.value = words[0];
            self.differences = [words[1], words[2], words[3]];
        } else if run {
            self.value = add(self.value, first);
            self.differences = [add(first, second), add(second, third), third];
        }
    }
}
