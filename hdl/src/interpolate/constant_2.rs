//! A constant over a triangle: f(x, y) = c (Abbas 2003, section 2.2.1), with the double buffering of the raster shell.

use super::constant_1::{Constant1, Constant1Model};
use crate::format::{signed_cast_bits, wrap, Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Words of the register file.
pub const WORDS: usize = 1;

/// Register word 0 is the value. `D` is the width of the register bus.
#[derive(LogicBlock, Default)]
pub struct Constant2<const D: usize, const M: usize, const N: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to the register word.
    pub write: Signal<In, Bit>,
    /// Register bus; the low 1 + M + N bits are used.
    pub data: Signal<In, U<D>>,
    /// Moves the register word to the line registers: a new triangle begins.
    pub load: Signal<In, Bit>,
    /// Moves the line registers to the pixel registers: a new span begins.
    pub take: Signal<In, Bit>,
    /// Integer part of the value at the current pixel, rounded down.
    pub value: Signal<Out, Q<M, 0>>,
    /// Register bus as a word of this format.
    bus: Wire<Q<M, N>>,
    /// Value of the next triangle.
    word_value: Register<Q<M, N>>,
    /// Value of the current triangle.
    line_value: Register<Q<M, N>>,
    /// The current span.
    span: Quiet<Constant1<M, N>>,
}

impl<const D: usize, const M: usize, const N: usize> Logic for Constant2<D, M, N> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name constant_2");
        comment!("title A constant over a triangle, double-buffered.");
        comment!("equation f(x, y) = c");
        comment!("source Abbas 2003, section 2.2.1.");
        comment!("latency One clock each from write, load and take.");
        dff_setup!(self, clock, word_value, line_value);
        self.bus.next = signed_cast_bits::<M, N, D>(self.data.val());
        if self.write.val() {
            self.word_value.d.next = self.bus.val();
        }
        if self.load.val() {
            self.line_value.d.next = self.word_value.q.val();
        }
        self.span.clock.next = self.clock.val();
        self.span.load.next = self.take.val();
        self.span.start.next = self.line_value.q.val();
        self.value.next = self.span.value.val();
    }
}

crate::clocked!(Constant2<D, M, N>, const D: usize, const M: usize, const N: usize;
    inputs write, data, load, take;
    outputs value);

/// Integer model of [`Constant2`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Constant2Model {
    word: i64,
    line: i64,
    span: Constant1Model,
}

impl Constant2Model {
    /// Value at the current pixel.
    #[must_use]
    pub fn value(&self) -> i64 {
        self.span.value
    }

    /// One clock of a module of `width` bits.
    pub fn clock(&mut self, width: usize, write: Option<u64>, load: bool, take: bool) {
        self.span.clock(take, self.line);
        if load {
            self.line = self.word;
        }
        if let Some(data) = write {
            self.word = wrap(data as i64, width);
        }
    }
}
