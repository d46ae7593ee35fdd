//! A cosine along a span by Chebyshev's recurrence: I(k+1) = U·I(k) − I(k−1), U = 2·cos K (Hast 2004, equations 3.38 to
//! 3.45, as printed: one multiplication, one addition, two moves).
//!
//! It is here to be compared with [`super::swing`], with the same accumulators and the same multiplier of 25 by 25 bits.
//! 2·cos K = 2 − K² + … loses K: a rounding of U by 2^−23 is an error of up to M²/2·2^−23 of full scale after M pixels,
//! 8 LSB after 512 and 16 and more after 1024, where the difference form keeps below a hundredth.

use crate::format::{signed_cast_align, signed_cast_bits, signed_cast_product, wrap, Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Fraction bits of U.
pub const TWICE_FRACTION_BITS: usize = 22;

/// Register words: 0 value at the first pixel, 1 value at the pixel before it, 2 U = 2·cos K.
/// Latency: one clock from `take`; one value per clock while `run`.
#[derive(LogicBlock, Default)]
pub struct Chebyshev {
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
    /// Cosine at the current pixel.
    pub value: Signal<Out, Q<1, 42>>,
    /// The same in units of 1/65536, rounded down.
    pub level: Signal<Out, Q<17, 0>>,
    /// Next span, value at the first pixel.
    word_value: Register<Q<1, 30>>,
    /// Next span, value at the pixel before.
    word_before: Register<Q<1, 30>>,
    /// Next span, multiplier.
    word_twice: Register<Q<2, 22>>,
    /// Value at the current pixel.
    total: Register<Q<1, 42>>,
    /// Value at the pixel before.
    behind: Register<Q<1, 42>>,
    /// Multiplier.
    twice: Register<Q<2, 22>>,
    /// Register bus as a word.
    bus: Wire<Q<1, 30>>,
    /// Multiplier on the register bus.
    bus_twice: Wire<U<25>>,
    /// Value as the multiplier takes it.
    operand: Wire<Q<1, 23>>,
    /// Value times multiplier.
    product: Wire<Q<1, 42>>,
    /// Value with 16 fraction bits.
    coarse: Wire<Q<1, 16>>,
    /// Its bits.
    coarse_bits: Wire<U<18>>,
}

impl Logic for Chebyshev {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name chebyshev");
        comment!(
            "title A cosine along a span by Chebyshev's recurrence: one multiplier, one adder."
        );
        comment!("equation I(k+1) = U I(k) - I(k-1);  U = 2 cos K");
        comment!("source Hast 2004, equations 3.38 to 3.45. For comparison: its error grows with the square of the span.");
        comment!("latency One clock from take to value; one value per clock.");
        dff_setup!(
            self,
            clock,
            word_value,
            word_before,
            word_twice,
            total,
            behind,
            twice
        );
        self.bus.next = signed_cast_bits::<1, 30, 32>(self.data.val());
        self.bus_twice.next = self.data.val().get_bits::<25>(0);
        if self.write.val() {
            if self.word.val() == 0u64.into() {
                self.word_value.d.next = self.bus.val();
            }
            if self.word.val() == 1u64.into() {
                self.word_before.d.next = self.bus.val();
            }
            if self.word.val() == 2u64.into() {
                self.word_twice.d.next = signed_cast_bits::<2, 22, 25>(self.bus_twice.val());
            }
        }
        self.operand.next = signed_cast_align::<1, 23, 1, 42>(self.total.q.val());
        self.product.next = signed_cast_product::<1, 42>(self.operand.val() * self.twice.q.val());
        if self.take.val() {
            self.total.d.next = signed_cast_align::<1, 42, 1, 30>(self.word_value.q.val());
            self.behind.d.next = signed_cast_align::<1, 42, 1, 30>(self.word_before.q.val());
            self.twice.d.next = self.word_twice.q.val();
        } else if self.run.val() {
            self.total.d.next = self.product.val() - self.behind.q.val();
            self.behind.d.next = self.total.q.val();
        }
        self.coarse.next = signed_cast_align::<1, 16, 1, 42>(self.total.q.val());
        self.coarse_bits.next = self.coarse.val().get_bits::<18>(0);
        self.value.next = self.total.q.val();
        self.level.next = signed_cast_bits::<17, 0, 18>(self.coarse_bits.val());
    }
}

crate::clocked!(Chebyshev;
    inputs write, word, data, take, run;
    outputs value, level);

/// Integer model of [`Chebyshev`].
#[derive(Clone, Copy, Debug, Default)]
pub struct ChebyshevModel {
    words: [i64; 3],
    before: i64,
    twice: i64,
    /// Cosine at the current pixel, Q1.42.
    pub value: i64,
}

impl ChebyshevModel {
    /// One clock; `write` is a register word and its data.
    pub fn clock(&mut self, write: Option<(usize, u64)>, take: bool, run: bool) {
        const WIDTH: usize = 44;
        let [value, before, twice] = self.words;
        if take {
            self.value = value << 12;
            self.before = before << 12;
            self.twice = twice;
        } else if run {
            let product = wrap(((self.value >> 19) * self.twice) >> 3, WIDTH);
            let next = wrap(product - self.before, WIDTH);
            self.before = self.value;
            self.value = next;
        }
        match write {
            Some((word @ (0 | 1), data)) => self.words[word] = wrap(data as i64, 32),
            Some((2, data)) => self.words[2] = wrap(data as i64, 25),
            _ => {}
        }
    }
}
