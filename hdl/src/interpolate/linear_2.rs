//! A linear function over a triangle (Abbas 2003, section 2.2.2), walked exactly along pixel centres.
//!
//! f is a plane, so its differences along the line step s, the carrying line step s' = s + p and the pixel step p are
//! constants: f(P + s) = f(P) + d_line, f(P + s') = f(P) + d_line_carry, f(P + p) = f(P) + d_pixel.
//! Abbas steps the span start by a truncated real slope, which samples up to a pixel beside the centre; the carry removes
//! that error with one more constant. After k_y lines and k_x pixels (carries included) the error is
//! e(value) + k_y·e(d_line) + k_x·e(d_pixel).

use super::linear_1::{Linear1, Linear1Model};
use crate::format::{signed_cast_bits, wrap, Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Words of the register file.
pub const WORDS: usize = 4;

/// Register words: 0 value at the first span start, 1 d_pixel, 2 d_line, 3 d_line_carry = d_line + d_pixel.
/// `D` is the width of the register bus.
#[derive(LogicBlock, Default)]
pub struct Linear2<const D: usize, const M: usize, const N: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to register word `word`.
    pub write: Signal<In, Bit>,
    /// Register word to write, 0 to 3; others are ignored.
    pub word: Signal<In, U<4>>,
    /// Register bus; the low 1 + M + N bits are used.
    pub data: Signal<In, U<D>>,
    /// Moves the register words to the line registers: a new triangle begins.
    pub load: Signal<In, Bit>,
    /// Steps the line registers to the next span start.
    pub step: Signal<In, Bit>,
    /// The step is the carrying one.
    pub carry: Signal<In, Bit>,
    /// Moves the line registers to the pixel registers: a new span begins.
    pub take: Signal<In, Bit>,
    /// Steps the pixel registers.
    pub run: Signal<In, Bit>,
    /// Integer part of the value at the current pixel, rounded down.
    pub value: Signal<Out, Q<M, 0>>,
    /// Register bus as a word of this format.
    bus: Wire<Q<M, N>>,
    /// Next triangle, value at the first span start.
    word_value: Register<Q<M, N>>,
    /// Next triangle, difference along the pixel step.
    word_d_pixel: Register<Q<M, N>>,
    /// Next triangle, difference along the line step.
    word_d_line: Register<Q<M, N>>,
    /// Next triangle, difference along the carrying line step.
    word_d_line_carry: Register<Q<M, N>>,
    /// Value at the start of the next span.
    value_line: Register<Q<M, N>>,
    /// Difference along the pixel step.
    d_pixel: Register<Q<M, N>>,
    /// Difference along the line step.
    d_line: Register<Q<M, N>>,
    /// Difference along the carrying line step.
    d_line_carry: Register<Q<M, N>>,
    /// The current span.
    span: Quiet<Linear1<M, N>>,
}

impl<const D: usize, const M: usize, const N: usize> Logic for Linear2<D, M, N> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name linear_2");
        comment!(
            "title A linear function over a triangle, exact at pixel centres, double-buffered."
        );
        comment!("equation f(P+s) = f(P) + d_line;  f(P+s+p) = f(P) + d_line_carry;  f(P+p) = f(P) + d_pixel");
        comment!("source Abbas 2003, section 2.2.2, with the exact edge walk instead of the truncated slope.");
        comment!("latency One clock each from write, load and take to value; one value per clock.");
        dff_setup!(
            self,
            clock,
            word_value,
            word_d_pixel,
            word_d_line,
            word_d_line_carry,
            value_line,
            d_pixel,
            d_line,
            d_line_carry
        );
        self.bus.next = signed_cast_bits::<M, N, D>(self.data.val());
        if self.write.val() {
            if self.word.val() == 0u64.into() {
                self.word_value.d.next = self.bus.val();
            }
            if self.word.val() == 1u64.into() {
                self.word_d_pixel.d.next = self.bus.val();
            }
            if self.word.val() == 2u64.into() {
                self.word_d_line.d.next = self.bus.val();
            }
            if self.word.val() == 3u64.into() {
                self.word_d_line_carry.d.next = self.bus.val();
            }
        }
        if self.load.val() {
            self.value_line.d.next = self.word_value.q.val();
            self.d_pixel.d.next = self.word_d_pixel.q.val();
            self.d_line.d.next = self.word_d_line.q.val();
            self.d_line_carry.d.next = self.word_d_line_carry.q.val();
        } else if self.step.val() {
            if self.carry.val() {
                self.value_line.d.next = self.value_line.q.val() + self.d_line_carry.q.val();
            } else {
                self.value_line.d.next = self.value_line.q.val() + self.d_line.q.val();
            }
        }
        self.span.clock.next = self.clock.val();
        self.span.load.next = self.take.val();
        self.span.run.next = self.run.val();
        self.span.start.next = self.value_line.q.val();
        self.span.step.next = self.d_pixel.q.val();
        self.value.next = self.span.value.val();
    }
}

crate::clocked!(Linear2<D, M, N>, const D: usize, const M: usize, const N: usize;
    inputs write, word, data, load, step, carry, take, run;
    outputs value);

/// Controls of a two-variate interpolant in one clock, shared by all channels of a core.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Controls {
    /// A new triangle begins.
    pub load: bool,
    /// The span start moves to the next line.
    pub step: bool,
    /// That step carries.
    pub carry: bool,
    /// A new span begins.
    pub take: bool,
    /// The pixel moves on.
    pub run: bool,
}

/// Integer model of [`Linear2`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Linear2Model {
    words: [i64; WORDS],
    line: [i64; WORDS],
    span: Linear1Model,
}

impl Linear2Model {
    /// Value at the current pixel.
    #[must_use]
    pub fn value(&self) -> i64 {
        self.span.value
    }

    /// One clock of a module of `width` bits; `write` is a register word and its data.
    pub fn clock(&mut self, width: usize, write: Option<(usize, u64)>, c: Controls) {
        let [value, d_pixel, d_line, d_line_carry] = self.line;
        self.span.clock(width, c.take, c.run, value, d_pixel);
        if c.load {
            self.line = self.words;
        } else if c.step {
            let d = if c.carry { d_line_carry } else { d_line };
            self.line[0] = wrap(value.wrapping_add(d), width);
        }
        if let Some((word, data)) = write {
            if word < WORDS {
                self.words[word] = wrap(data as i64, width);
            }
        }
    }
}
