//! A colour over a triangle: the quadric of [`crate::interpolate::quadratic_2`] with six words and one adder per register.
//!
//! f(P + s) = f + d_s, then d_s += dd_ss and d_p += dd_ps; a carrying step goes one pixel further, as along a span:
//! f += d_p, d_p += dd_pp, d_s += dd_ps. That is f + d_t and d_t = d_s + d_p + dd_ps, so words and sums are those of the
//! quadratic core, bit for bit (the extra pixel step on the same adders is the one that the notes on Abbas 2003, figure
//! 2.7, ask for).
//!
//! # Range and rounding
//! All registers are residues modulo 2^(1+M), as in the quadratic core. The value is kept with `V` of the `N` fraction
//! bits of the differences: each of n additions then drops less than 2^−V, so the value is at most n·2^−V low, beside the
//! (1 + n(n + 1)/2)·2^−(N+1) of the words' rounding. With V = N nothing is dropped.

use super::word_memory::WordMemory;
use crate::format::{signed_cast_align, signed_cast_bits, Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// `D` = 1 + `M` + `N`: width of a word; `V`: fraction bits of the value.
#[derive(LogicBlock)]
pub struct CompactChannel<const D: usize, const M: usize, const N: usize, const V: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to the word at `address`.
    pub write: Signal<In, Bit>,
    /// Word to read or write.
    pub address: Signal<In, U<4>>,
    /// Word to write.
    pub data: Signal<In, U<D>>,
    /// Clears the line registers.
    pub clear: Signal<In, Bit>,
    /// Clears the difference along the line step alone.
    pub clear_line: Signal<In, Bit>,
    /// Adds a difference to the value.
    pub add_value: Signal<In, Bit>,
    /// Adds the word to the difference along the line step.
    pub add_line: Signal<In, Bit>,
    /// Adds the word to the difference along the pixel step.
    pub add_pixel: Signal<In, Bit>,
    /// The value takes the difference along the pixel step, not along the line step.
    pub pixel_step: Signal<In, Bit>,
    /// Keeps the word as second difference along the span.
    pub keep_bend: Signal<In, Bit>,
    /// Moves the line registers to the pixel registers: a new span begins.
    pub take: Signal<In, Bit>,
    /// Steps the pixel registers.
    pub run: Signal<In, Bit>,
    /// Integer part of the value at the current pixel, rounded down.
    pub value: Signal<Out, Q<M, 0>>,
    /// Words of this triangle and the next.
    memory: Quiet<WordMemory<D>>,
    /// The word at the address.
    word: Wire<Q<M, N>>,
    /// What the value takes, with its fraction bits.
    value_step: Wire<Q<M, V>>,
    /// Difference along the span, with the value's fraction bits.
    first_cut: Wire<Q<M, V>>,
    /// Value at the start of the next span.
    value_line: Register<Q<M, V>>,
    /// Difference along the line step at the span start.
    d_line: Register<Q<M, N>>,
    /// Difference along the pixel step at the span start.
    d_pixel: Register<Q<M, N>>,
    /// Second difference along the span.
    bend: Register<Q<M, N>>,
    /// Value at the current pixel.
    total: Register<Q<M, V>>,
    /// First difference at the current pixel.
    first: Register<Q<M, N>>,
    /// A cleared value.
    no_value: Constant<Q<M, V>>,
    /// A cleared difference.
    no_step: Constant<Q<M, N>>,
}

impl<const D: usize, const M: usize, const N: usize, const V: usize> Default
    for CompactChannel<D, M, N, V>
{
    fn default() -> Self {
        Self {
            clock: Default::default(),
            write: Default::default(),
            address: Default::default(),
            data: Default::default(),
            clear: Default::default(),
            clear_line: Default::default(),
            add_value: Default::default(),
            add_line: Default::default(),
            add_pixel: Default::default(),
            pixel_step: Default::default(),
            keep_bend: Default::default(),
            take: Default::default(),
            run: Default::default(),
            value: Default::default(),
            memory: Default::default(),
            word: Default::default(),
            value_step: Default::default(),
            first_cut: Default::default(),
            value_line: Default::default(),
            d_line: Default::default(),
            d_pixel: Default::default(),
            bend: Default::default(),
            total: Default::default(),
            first: Default::default(),
            no_value: Constant::new(Q::from_code(0)),
            no_step: Constant::new(Q::from_code(0)),
        }
    }
}

impl<const D: usize, const M: usize, const N: usize, const V: usize> Logic
    for CompactChannel<D, M, N, V>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name compact_channel");
        comment!("title A quadratic function over a triangle, six words in look-up tables, one adder per register.");
        comment!("equation line step: f += ds, ds += dd_ss, dp += dd_ps;  pixel step: f += dp, dp += dd_pp, ds += dd_ps");
        comment!("source Abbas 2003, section 2.2.3 and appendix; exact at pixel centres, a carry is one more pixel step.");
        comment!("latency One clock per addition; one value per clock along a span.");
        dff_setup!(self, clock, value_line, d_line, d_pixel, bend, total, first);
        self.memory.clock.next = self.clock.val();
        self.memory.write.next = self.write.val();
        self.memory.address.next = self.address.val();
        self.memory.write_data.next = self.data.val();
        self.word.next = signed_cast_bits::<M, N, D>(self.memory.read_data.val());

        self.value_step.next = signed_cast_align::<M, V, M, N>(self.d_line.q.val());
        if self.pixel_step.val() {
            self.value_step.next = signed_cast_align::<M, V, M, N>(self.d_pixel.q.val());
        }
        self.first_cut.next = signed_cast_align::<M, V, M, N>(self.first.q.val());

        if self.clear.val() {
            self.value_line.d.next = self.no_value.val();
        } else if self.add_value.val() {
            self.value_line.d.next = self.value_line.q.val() + self.value_step.val();
        }
        if self.clear.val() || self.clear_line.val() {
            self.d_line.d.next = self.no_step.val();
        } else if self.add_line.val() {
            self.d_line.d.next = self.d_line.q.val() + self.word.val();
        }
        if self.clear.val() {
            self.d_pixel.d.next = self.no_step.val();
        } else if self.add_pixel.val() {
            self.d_pixel.d.next = self.d_pixel.q.val() + self.word.val();
        }
        if self.keep_bend.val() {
            self.bend.d.next = self.word.val();
        }
        if self.take.val() {
            self.total.d.next = self.value_line.q.val();
            self.first.d.next = self.d_pixel.q.val();
        } else if self.run.val() {
            self.total.d.next = self.total.q.val() + self.first_cut.val();
            self.first.d.next = self.first.q.val() + self.bend.q.val();
        }
        self.value.next = signed_cast_align::<M, 0, M, V>(self.total.q.val());
    }
}

crate::clocked!(CompactChannel<D, M, N, V>, const D: usize, const M: usize, const N: usize, const V: usize;
    inputs write, address, data, clear, clear_line, add_value, add_line, add_pixel, pixel_step, keep_bend, take, run;
    outputs value);
