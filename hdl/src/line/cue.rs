//! Depth cueing: one channel of the colour along a line, an accumulator beside the walk (Abbas 2003, equation 3.14).
//!
//! I(Z) = I₀·(C_max − (C_max − C_min)·Z/Z_max) is linear in Z, and Z is taken as linear along the line, so the colour of
//! column k is value + k·step. The host computes both words; a line of one pixel has step 0 and needs no division.
//!
//! # Range and rounding
//! Q11.20 with half an LSB added to the value. Both ends lie in 0..=255, so every column does, to within the rounding of
//! the words: (1 + k)·2^−21 LSB after k columns, less than 0.001 LSB for 2040 columns. So 0 ≤ value < 256 and no clamp is
//! needed.

use crate::format::{signed_cast_bits, wrap, Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Words of a channel: value, step.
pub const WORDS: usize = 2;
/// Fraction bits of the accumulator.
pub const FRACTION_BITS: usize = 20;

/// Latency: one clock from `load`; one column per clock.
#[derive(LogicBlock, Default)]
pub struct Cue {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to register word `word`.
    pub write: Signal<In, Bit>,
    /// Register word: 0 value at the first column plus half an LSB, 1 step; others are ignored.
    pub word: Signal<In, U<4>>,
    /// Register bus.
    pub data: Signal<In, U<32>>,
    /// Moves the register words to the accumulator: a new line begins.
    pub load: Signal<In, Bit>,
    /// Steps to the next column.
    pub advance: Signal<In, Bit>,
    /// The channel as a byte.
    pub level: Signal<Out, U<8>>,
    /// Register bus as a word of this format.
    bus: Wire<Q<11, 20>>,
    /// Next line, value at the first column.
    word_value: Register<Q<11, 20>>,
    /// Next line, change per column.
    word_step: Register<Q<11, 20>>,
    /// Value at the column.
    value: Register<Q<11, 20>>,
    /// Change per column.
    step: Register<Q<11, 20>>,
}

impl Logic for Cue {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name line_cue");
        comment!("title One colour channel along a line: depth cueing by one addition per column.");
        comment!("equation I(k+1) = I(k) + dI,  dI = (I(Z2) - I(Z1)) / N");
        comment!("source Abbas 2003, equation 3.14, without its division by zero for N = 0.");
        comment!("latency One clock from load to level; one column per clock.");
        dff_setup!(self, clock, word_value, word_step, value, step);
        self.bus.next = signed_cast_bits::<11, 20, 32>(self.data.val());
        if self.write.val() {
            if self.word.val() == 0u64.into() {
                self.word_value.d.next = self.bus.val();
            }
            if self.word.val() == 1u64.into() {
                self.word_step.d.next = self.bus.val();
            }
        }
        if self.load.val() {
            self.value.d.next = self.word_value.q.val();
            self.step.d.next = self.word_step.q.val();
        } else if self.advance.val() {
            self.value.d.next = self.value.q.val() + self.step.q.val();
        }
        self.level.next = self.value.q.val().get_bits::<8>(20);
    }
}

crate::clocked!(Cue;
    inputs write, word, data, load, advance;
    outputs level);

/// Integer model of [`Cue`].
#[derive(Clone, Copy, Debug, Default)]
pub struct CueModel {
    words: [i64; WORDS],
    value: i64,
    step: i64,
}

impl CueModel {
    /// The channel as a byte.
    #[must_use]
    pub fn level(&self) -> u8 {
        (self.value >> FRACTION_BITS) as u8
    }

    /// One clock edge; `write` is a register word and its data.
    pub fn clock(&mut self, write: Option<(usize, u64)>, load: bool, advance: bool) {
        if load {
            [self.value, self.step] = self.words;
        } else if advance {
            self.value = wrap(self.value + self.step, 32);
        }
        if let Some((word, data)) = write {
            if word < WORDS {
                self.words[word] = wrap(data as i64, 32);
            }
        }
    }
}
