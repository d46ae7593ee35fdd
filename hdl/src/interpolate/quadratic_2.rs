//! A quadratic function over a triangle (Abbas 2003, section 2.2.3), walked exactly along pixel centres.
//!
//! Along the pixel step p = (1, 0), the line step s = (a, 1) and the carrying line step t = (a + 1, 1) a quadric has
//! first differences that are linear and second differences dd(u, v) that are constant:
//! d_u(P + v) = d_u(P) + dd(u, v). So every line costs four additions and every pixel two, and all samples lie exactly
//! on pixel centres (Abbas' printed algorithm samples up to one pixel beside them).
//!
//! Only six of the ten words are independent: d_line_carry = d_line + d_pixel + dd_pixel_line,
//! dd_pixel_carry = dd_pixel_line + dd_pixel, dd_line_carry = dd_line + dd_pixel_line,
//! dd_carry = dd_line_carry + dd_pixel_carry. The host forms the other four by exact integer addition, so the walk
//! evaluates one quadric whatever path it takes. With n = lines + pixels + carries the accumulated error is at most
//! (1 + n(n + 1)/2) half-ulps (Abbas 2.10 forgets the cross term).

use super::linear_2::Controls;
use super::quadratic_1::{Quadratic1, Quadratic1Model};
use crate::format::{signed_cast_bits, wrap, Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Words of the register file.
pub const WORDS: usize = 10;

/// Register words: 0 value, 1 d_pixel, 2 d_line, 3 d_line_carry at the first span start; 4 dd_pixel, 5 dd_pixel_line,
/// 6 dd_pixel_carry, 7 dd_line, 8 dd_line_carry, 9 dd_carry. `D` is the width of the register bus.
#[derive(LogicBlock, Default)]
pub struct Quadratic2<const D: usize, const M: usize, const N: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to register word `word`.
    pub write: Signal<In, Bit>,
    /// Register word to write, 0 to 9; others are ignored.
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
    /// Next triangle, difference along the pixel step p.
    word_d_pixel: Register<Q<M, N>>,
    /// Next triangle, difference along the line step s.
    word_d_line: Register<Q<M, N>>,
    /// Next triangle, difference along the carrying line step t.
    word_d_line_carry: Register<Q<M, N>>,
    /// Next triangle, second difference p,p.
    word_dd_pixel: Register<Q<M, N>>,
    /// Next triangle, second difference p,s.
    word_dd_pixel_line: Register<Q<M, N>>,
    /// Next triangle, second difference p,t.
    word_dd_pixel_carry: Register<Q<M, N>>,
    /// Next triangle, second difference s,s.
    word_dd_line: Register<Q<M, N>>,
    /// Next triangle, second difference s,t.
    word_dd_line_carry: Register<Q<M, N>>,
    /// Next triangle, second difference t,t.
    word_dd_carry: Register<Q<M, N>>,
    /// Value at the start of the next span.
    value_line: Register<Q<M, N>>,
    /// Difference along p at the span start.
    d_pixel: Register<Q<M, N>>,
    /// Difference along s at the span start.
    d_line: Register<Q<M, N>>,
    /// Difference along t at the span start.
    d_line_carry: Register<Q<M, N>>,
    /// Second difference p,p.
    dd_pixel: Register<Q<M, N>>,
    /// Second difference p,s.
    dd_pixel_line: Register<Q<M, N>>,
    /// Second difference p,t.
    dd_pixel_carry: Register<Q<M, N>>,
    /// Second difference s,s.
    dd_line: Register<Q<M, N>>,
    /// Second difference s,t.
    dd_line_carry: Register<Q<M, N>>,
    /// Second difference t,t.
    dd_carry: Register<Q<M, N>>,
    /// The current span.
    span: Quiet<Quadratic1<M, N>>,
}

impl<const D: usize, const M: usize, const N: usize> Logic for Quadratic2<D, M, N> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name quadratic_2");
        comment!(
            "title A quadratic function over a triangle, exact at pixel centres, double-buffered."
        );
        comment!("equation f(P+u) = f(P) + d_u(P);  d_u(P+v) = d_u(P) + dd(u,v)  for u, v in p = (1,0), s = (a,1), t = (a+1,1)");
        comment!("source Abbas 2003, section 2.2.3 and figure 2.7, with the exact edge walk instead of the truncated slope.");
        comment!("latency One clock each from write, load and take to value; one value per clock.");
        dff_setup!(
            self,
            clock,
            word_value,
            word_d_pixel,
            word_d_line,
            word_d_line_carry,
            word_dd_pixel,
            word_dd_pixel_line,
            word_dd_pixel_carry,
            word_dd_line,
            word_dd_line_carry,
            word_dd_carry,
            value_line,
            d_pixel,
            d_line,
            d_line_carry,
            dd_pixel,
            dd_pixel_line,
            dd_pixel_carry,
            dd_line,
            dd_line_carry,
            dd_carry
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
            if self.word.val() == 4u64.into() {
                self.word_dd_pixel.d.next = self.bus.val();
            }
            if self.word.val() == 5u64.into() {
                self.word_dd_pixel_line.d.next = self.bus.val();
            }
            if self.word.val() == 6u64.into() {
                self.word_dd_pixel_carry.d.next = self.bus.val();
            }
            if self.word.val() == 7u64.into() {
                self.word_dd_line.d.next = self.bus.val();
            }
            if self.word.val() == 8u64.into() {
                self.word_dd_line_carry.d.next = self.bus.val();
            }
            if self.word.val() == 9u64.into() {
                self.word_dd_carry.d.next = self.bus.val();
            }
        }
        if self.load.val() {
            self.value_line.d.next = self.word_value.q.val();
            self.d_pixel.d.next = self.word_d_pixel.q.val();
            self.d_line.d.next = self.word_d_line.q.val();
            self.d_line_carry.d.next = self.word_d_line_carry.q.val();
            self.dd_pixel.d.next = self.word_dd_pixel.q.val();
            self.dd_pixel_line.d.next = self.word_dd_pixel_line.q.val();
            self.dd_pixel_carry.d.next = self.word_dd_pixel_carry.q.val();
            self.dd_line.d.next = self.word_dd_line.q.val();
            self.dd_line_carry.d.next = self.word_dd_line_carry.q.val();
            self.dd_carry.d.next = self.word_dd_carry.q.val();
        } else if self.step.val() {
            if self.carry.val() {
                self.value_line.d.next = self.value_line.q.val() + self.d_line_carry.q.val();
                self.d_pixel.d.next = self.d_pixel.q.val() + self.dd_pixel_carry.q.val();
                self.d_line.d.next = self.d_line.q.val() + self.dd_line_carry.q.val();
                self.d_line_carry.d.next = self.d_line_carry.q.val() + self.dd_carry.q.val();
            } else {
                self.value_line.d.next = self.value_line.q.val() + self.d_line.q.val();
                self.d_pixel.d.next = self.d_pixel.q.val() + self.dd_pixel_line.q.val();
                self.d_line.d.next = self.d_line.q.val() + self.dd_line.q.val();
                self.d_line_carry.d.next = self.d_line_carry.q.val() + self.dd_line_carry.q.val();
            }
        }
        self.span.clock.next = self.clock.val();
        self.span.load.next = self.take.val();
        self.span.run.next = self.run.val();
        self.span.start.next = self.value_line.q.val();
        self.span.step.next = self.d_pixel.q.val();
        self.span.bend.next = self.dd_pixel.q.val();
        self.value.next = self.span.value.val();
    }
}

crate::clocked!(Quadratic2<D, M, N>, const D: usize, const M: usize, const N: usize;
    inputs write, word, data, load, step, carry, take, run;
    outputs value);

/// Integer model of [`Quadratic2`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Quadratic2Model {
    words: [i64; WORDS],
    line: [i64; WORDS],
    span: Quadratic1Model,
}

impl Quadratic2Model {
    /// Value at the current pixel.
    #[must_use]
    pub fn value(&self) -> i64 {
        self.span.value
    }

    /// One clock of a module of `width` bits; `write` is a register word and its data.
    pub fn clock(&mut self, width: usize, write: Option<(usize, u64)>, c: Controls) {
        let l = self.line;
        self.span.clock(width, c.take, c.run, l[0], l[1], l[4]);
        if c.load {
            self.line = self.words;
        } else if c.step {
            let add = |a: i64, b: i64| wrap(a.wrapping_add(b), width);
            let steps = if c.carry {
                [l[3], l[6], l[8], l[9]]
            } else {
                [l[2], l[5], l[7], l[8]]
            };
            for (i, step) in steps.into_iter().enumerate() {
                self.line[i] = add(l[i], step);
            }
        }
        if let Some((word, data)) = write {
            if word < WORDS {
                self.words[word] = wrap(data as i64, width);
            }
        }
    }
}
