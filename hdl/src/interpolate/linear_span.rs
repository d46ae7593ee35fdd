//! A linear function along spans that a host sets up one by one: [`super::linear_1`] behind double-buffered words.
//!
//! After k pixels the error is e(value) + k·e(step), e the rounding of a word: (1 + k)·2^−(N+1).

use super::linear_1::{Linear1, Linear1Model};
use crate::format::{signed_cast_bits, wrap, Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Register words: 0 value at the first pixel, 1 difference from pixel to pixel; each has 1 + M + N bits, at most 32.
/// Latency: one clock from `take`; one value per clock while `run`.
#[derive(LogicBlock, Default)]
pub struct LinearSpan<const M: usize, const N: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to register word `word`.
    pub write: Signal<In, Bit>,
    /// Register word to write, 0 or 1; others are ignored.
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
    /// Next span, difference from pixel to pixel.
    word_step: Register<Q<M, N>>,
    /// Register bus as a word of this format.
    bus: Wire<Q<M, N>>,
    /// The current span.
    span: Quiet<Linear1<M, N>>,
}

impl<const M: usize, const N: usize> Logic for LinearSpan<M, N> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name linear_span");
        comment!(
            "title A linear function along spans that are set up one by one, double-buffered."
        );
        comment!("equation f(k) = c + d k;  f(k+1) = f(k) + d");
        comment!("source Abbas 2003, section 2.1.2.");
        comment!("latency One clock from take to value; one value per clock.");
        dff_setup!(self, clock, word_value, word_step);
        self.bus.next = signed_cast_bits::<M, N, 32>(self.data.val());
        if self.write.val() {
            if self.word.val() == 0u64.into() {
                self.word_value.d.next = self.bus.val();
            }
            if self.word.val() == 1u64.into() {
                self.word_step.d.next = self.bus.val();
            }
        }
        self.span.clock.next = self.clock.val();
        self.span.load.next = self.take.val();
        self.span.run.next = self.run.val();
        self.span.start.next = self.word_value.q.val();
        self.span.step.next = self.word_step.q.val();
        self.value.next = self.span.value.val();
    }
}

crate::clocked!(LinearSpan<M, N>, const M: usize, const N: usize;
    inputs write, word, data, take, run;
    outputs value);

/// Integer model of [`LinearSpan`].
#[derive(Clone, Copy, Debug, Default)]
pub struct LinearSpanModel {
    words: [i64; 2],
    span: Linear1Model,
}

impl LinearSpanModel {
    /// Value at the current pixel.
    #[must_use]
    pub fn value(&self) -> i64 {
        self.span.value
    }

    /// One clock of a module of `width` bits; `write` is a register word and its data.
    pub fn clock(&mut self, width: usize, write: Option<(usize, u64)>, take: bool, run: bool) {
        let [value, step] = self.words;
        self.span.clock(width, take, run, value, step);
        if let Some((word @ (0 | 1), data)) = write {
            self.words[word] = wrap(data as i64, width);
        }
    }
}
