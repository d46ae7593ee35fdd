//! The weights of a box-filtered line: 255·(1 − f) and 255·f, rounded to nearest, with f the fraction of the line's minor
//! coordinate (Abbas 2003, section 3.2).
//!
//! Eq. 3.8 prints Round where floor is meant, and the listing's increment lacks the intensity and drifts. Here the level
//! is walked like an edge: 255·dY = W·dX + Z, so every column adds W, and one more when the remainder carries; a second
//! error term H in units of 1/(2·dX) says when. When the line passes into the next row, f falls by one and the level by
//! 255, which is +1 modulo 256: an 8-bit register needs no subtraction. Nothing is ever rounded, so nothing drifts: level
//! and error term are ⌊255·f + ½⌋ and its remainder in every column.
//!
//! Lane 1 has the level L, lane 0 has ⌊255·(1 − f) + ½⌋ = 255 − L, or one more when 255·f lies exactly half-way between two
//! levels (f = ½, say, where both are 128).
//!
//! Register words: 6 tie\[16\], whole\[15:8\], level\[7:0\] of the first column; 7, 8, 9 H behind the first column, 2·Z,
//! 2·(Z − dX). |H| ≤ 2·dX.

use crate::format::{signed_cast_bits, wrap, Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// First register word.
pub const FIRST_WORD: usize = 6;
/// Register words.
pub const WORDS: usize = 4;

/// Latency: one clock from `load`; one column per clock.
#[derive(LogicBlock)]
pub struct BoxWeight {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to register word `word`.
    pub write: Signal<In, Bit>,
    /// Register word, 6 to 9; others are ignored.
    pub word: Signal<In, U<4>>,
    /// Register bus; its low 17 bits are enough.
    pub data: Signal<In, U<17>>,
    /// Moves the register words to the accumulator: a new line begins.
    pub load: Signal<In, Bit>,
    /// Steps to the next column.
    pub advance: Signal<In, Bit>,
    /// The minor coordinate moves with it.
    pub rises: Signal<In, Bit>,
    /// The weight of lane 1 is wanted, not that of lane 0.
    pub upper: Signal<In, Bit>,
    /// The weight, of 255.
    pub weight: Signal<Out, U<8>>,
    /// Bits of an error term on the register bus.
    error_bits: Wire<U<14>>,
    /// An error term on the register bus.
    error_word: Wire<Q<13, 0>>,
    /// Next line, level of lane 1 in the first column.
    word_level: Register<U<8>>,
    /// Next line, whole levels per column.
    word_whole: Register<U<8>>,
    /// Next line, both weights of the first column are rounded up.
    word_tie: Register<Bit>,
    /// Next line, error term behind the first column.
    word_error: Register<Q<13, 0>>,
    /// Next line, error step without carry.
    word_up: Register<Q<13, 0>>,
    /// Next line, error step with carry.
    word_down: Register<Q<13, 0>>,
    /// Level of lane 1.
    level: Register<U<8>>,
    /// Whole levels per column.
    whole: Register<U<8>>,
    /// Both weights are rounded up.
    tie: Register<Bit>,
    /// Error term: positive where the next column carries.
    error: Register<Q<13, 0>>,
    /// Error step without carry.
    up: Register<Q<13, 0>>,
    /// Error step with carry.
    down: Register<Q<13, 0>>,
    /// The next column carries.
    carries: Wire<Bit>,
    /// Levels that carry and row add.
    extra: Wire<U<8>>,
    /// Weight of lane 0 without a tie.
    lower: Wire<U<8>>,
    /// No remainder.
    zero: Constant<Q<13, 0>>,
    /// The remainder of a tie.
    one: Constant<Q<13, 0>>,
    /// One level.
    one_level: Constant<U<8>>,
    /// Two levels.
    two_levels: Constant<U<8>>,
}

impl Default for BoxWeight {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            write: Default::default(),
            word: Default::default(),
            data: Default::default(),
            load: Default::default(),
            advance: Default::default(),
            rises: Default::default(),
            upper: Default::default(),
            weight: Default::default(),
            error_bits: Default::default(),
            error_word: Default::default(),
            word_level: Default::default(),
            word_whole: Default::default(),
            word_tie: Default::default(),
            word_error: Default::default(),
            word_up: Default::default(),
            word_down: Default::default(),
            level: Default::default(),
            whole: Default::default(),
            tie: Default::default(),
            error: Default::default(),
            up: Default::default(),
            down: Default::default(),
            carries: Default::default(),
            extra: Default::default(),
            lower: Default::default(),
            zero: Constant::new(Q::from_code(0)),
            one: Constant::new(Q::from_code(1)),
            one_level: Constant::new(U::new(1)),
            two_levels: Constant::new(U::new(2)),
        }
    }
}

impl Logic for BoxWeight {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name box_weight");
        comment!("title Weights of the two pixels of a box-filtered column, exact to rounding, without drift.");
        comment!("equation L = floor(255 f + 1/2), f = frac(k dY / dX); weights 255 - L (+ 1 in a tie) and L");
        comment!("source Abbas 2003, section 3.2, with floor for the Round of eq. 3.8; the error term is ours.");
        comment!("latency One clock from load to weight; one column per clock.");
        dff_setup!(
            self, clock, word_level, word_whole, word_tie, word_error, word_up, word_down, level,
            whole, tie, error, up, down
        );
        self.error_bits.next = self.data.val().get_bits::<14>(0);
        self.error_word.next = signed_cast_bits::<13, 0, 14>(self.error_bits.val());
        if self.write.val() {
            if self.word.val() == 6u64.into() {
                self.word_level.d.next = self.data.val().get_bits::<8>(0);
                self.word_whole.d.next = self.data.val().get_bits::<8>(8);
                self.word_tie.d.next = self.data.val().get_bit(16);
            }
            if self.word.val() == 7u64.into() {
                self.word_error.d.next = self.error_word.val();
            }
            if self.word.val() == 8u64.into() {
                self.word_up.d.next = self.error_word.val();
            }
            if self.word.val() == 9u64.into() {
                self.word_down.d.next = self.error_word.val();
            }
        }
        self.carries.next = self.zero.val() < self.error.q.val();
        self.extra.next = 0u64.into();
        if self.carries.val() && self.rises.val() {
            self.extra.next = self.two_levels.val();
        } else if self.carries.val() || self.rises.val() {
            self.extra.next = self.one_level.val();
        }
        if self.load.val() {
            self.level.d.next = self.word_level.q.val();
            self.whole.d.next = self.word_whole.q.val();
            self.tie.d.next = self.word_tie.q.val();
            self.error.d.next = self.word_error.q.val();
            self.up.d.next = self.word_up.q.val();
            self.down.d.next = self.word_down.q.val();
        } else if self.advance.val() {
            self.level.d.next = self.level.q.val() + self.whole.q.val() + self.extra.val();
            self.tie.d.next = self.error.q.val() == self.one.val();
            if self.carries.val() {
                self.error.d.next = self.error.q.val() + self.down.q.val();
            } else {
                self.error.d.next = self.error.q.val() + self.up.q.val();
            }
        }
        self.lower.next = !self.level.q.val();
        if self.upper.val() {
            self.weight.next = self.level.q.val();
        } else if self.tie.q.val() {
            self.weight.next = self.lower.val() + self.one_level.val();
        } else {
            self.weight.next = self.lower.val();
        }
    }
}

crate::clocked!(BoxWeight;
    inputs write, word, data, load, advance, rises, upper;
    outputs weight);

/// Integer model of [`BoxWeight`].
#[derive(Clone, Copy, Debug, Default)]
pub struct BoxModel {
    words: [u64; WORDS],
    level: u8,
    whole: u8,
    tie: bool,
    error: [i64; 3],
}

impl BoxModel {
    /// The weight of a lane, 0 or 1.
    #[must_use]
    pub fn weight(&self, upper: bool) -> u8 {
        if upper {
            self.level
        } else {
            (!self.level).wrapping_add(u8::from(self.tie))
        }
    }

    /// One clock edge; `write` is a register word and its data.
    pub fn clock(&mut self, write: Option<(usize, u64)>, load: bool, advance: bool, rises: bool) {
        let [error, up, down] = self.error;
        if load {
            let w = &self.words;
            self.level = w[0] as u8;
            self.whole = (w[0] >> 8) as u8;
            self.tie = w[0] >> 16 & 1 == 1;
            self.error = [w[1], w[2], w[3]].map(|v| wrap(v as i64, 14));
        } else if advance {
            let carry = error > 0;
            let extra = u8::from(carry) + u8::from(rises);
            self.level = self.level.wrapping_add(self.whole).wrapping_add(extra);
            self.tie = error == 1;
            self.error[0] = wrap(error + if carry { down } else { up }, 14);
        }
        if let Some((word, data)) = write {
            if let Some(to) = word
                .checked_sub(FIRST_WORD)
                .and_then(|i| self.words.get_mut(i))
            {
                *to = data;
            }
        }
    }
}
