//! A quadratic function along spans that a host sets up one by one: [`super::quadratic_1`] behind double-buffered words.
//!
//! After k pixels the error is e(value) + k·e(step) + k(k − 1)/2·e(bend), e the rounding of a word.

use super::quadratic_1::{Quadratic1, Quadratic1Model};
use crate::format::{signed_cast_bits, wrap, Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Register words: 0 value at the first pixel, 1 first difference there, 2 second difference; each has 1 + M + N bits,
/// at most 32. Latency: one clock from `take`; one value per clock while `run`.
#[derive(LogicBlock, Default)]
pub struct QuadraticSpan<const M: usize, const N: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to register word `word`.
    pub write: Signal<In, Bit>,
    /// Register word to write, 0 to 2; others are ignored.
    pub word: Signal<In, U<4>>,
    /// Register bus.
    pub data: Signal<In, U<32>>,
    /// Moves the register words to the pixel registers: a new span begins.
    pub take: Signal<In, Bit>,
    /// Steps the pixel registers.
    pub run: Signal<In, Bit>,
    /// Integer part of the value at the current pixel, rounded down.
    pub value: Signal<Out, Q<M, 0>>,
    /// Next span, value at the first pixel.
    word_value: Register<Q<M, N>>,
    /// Next span, first difference at the first pixel.
    word_step: Register<Q<M, N>>,
    /// Next span, second difference.
    word_bend: Register<Q<M, N>>,
    /// Register bus as a word of this format.
    bus: Wire<Q<M, N>>,
    /// The current span.
    span: Quiet<Quadratic1<M, N>>,
}

impl<const M: usize, const N: usize> Logic for QuadraticSpan<M, N> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name quadratic_span");
        comment!(
            "title A quadratic function along spans that are set up one by one, double-buffered."
        );
        comment!("equation f(k+1) = f(k) + d(k);  d(k+1) = d(k) + dd");
        comment!("source Abbas 2003, section 2.1.3.");
        comment!("latency One clock from take to value; one value per clock.");
        dff_setup!(self, clock, word_value, word_step, word_bend);
        self.bus.next = signed_cast_bits::<M, N, 32>(self.data.val());
        if self.write.val() {
            if self.word.val() == 0u64.into() {
                self.word_value.d.next = self.bus.val();
            }
            if self.word.val() == 1u64.into() {
                self.word_step.d.next = self.bus.val();
            }
            if self.word.val() == 2u64.into() {
                self.word_bend.d.next = self.bus.val();
            }
        }
        self.span.clock.next = self.clock.val();
        self.span.load.next = self.take.val();
        self.span.run.next = self.run.val();
        self.span.start.next = self.word_value.q.val();
        self.span.step.next = self.word_step.q.val();
        self.span.bend.next = self.word_bend.q.val();
        self.value.next = self.span.value.val();
    }
}

crate::clocked!(QuadraticSpan<M, N>, const M: usize, const N: usize;
    inputs write, word, data, take, run;
    outputs value);

/// Integer model of [`QuadraticSpan`].
#[derive(Clone, Copy, Debug, Default)]
pub struct QuadraticSpanModel {
    words: [i64; 3],
    span: Quadratic1Model,
}

impl QuadraticSpanModel {
    /// Value at the current pixel.
    #[must_use]
    pub fn value(&self) -> i64 {
        self.span.value
    }

    /// One clock of a module of `width` bits; `write` is a register word and its data.
    pub fn clock(&mut self, width: usize, write: Option<(usize, u64)>, take: bool, run: bool) {
        let [value, step, bend] = self.words;
        self.span.clock(width, take, run, value, step, bend);
        if let Some((word @ 0..=2, data)) = write {
            self.words[word] = wrap(data as i64, width);
        }
    }
}
