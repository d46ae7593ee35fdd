//! A cosine along a span by the difference recurrence of slerp: d −= κ·I, I += d, κ = 4·sin²(K/2), K the angle from
//! pixel to pixel. It is Chebyshev's recurrence (Hast 2004, equations 3.38 to 3.45) in a form that keeps K whole.
//!
//! # Formats
//! I and d are Q1.42, of which words give Q1.30. κ, at most 4, is a mantissa of 24 bits and an exponent of two: κ =
//! m·2^(−22−8e), so that it keeps 16 significant bits down to 2^−30 and an absolute 2^−47 below. The multiplier takes I
//! cut to Q1.23: 25 by 25 bits, two DSP blocks of 25 by 18.
//!
//! # Range and rounding
//! |I| ≤ 1 and |d| ≤ 2; sums are residues modulo 4, so d = 2 does no harm, and κI ≤ 4 is taken modulo 4 as well. What the
//! roundings of the words, of κ, of the operand and of every step add up to is in [`crate::shade::span_bound::swing`]:
//! 3·10⁻⁶ of full scale after 1024 pixels.

use crate::format::{signed_cast_align, signed_cast_bits, signed_cast_product, wrap, Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Fraction bits of the accumulators.
pub const FRACTION_BITS: usize = 42;
/// Fraction bits of the words of value and change.
pub const WORD_FRACTION_BITS: usize = 30;
/// Bits of the mantissa of κ.
pub const MANTISSA_BITS: usize = 24;
/// Fraction bits of κ with exponent 0.
pub const KAPPA_FRACTION_BITS: usize = 22;
/// Binary places of a step of the exponent.
pub const EXPONENT_STEP: usize = 8;

/// Register words: 0 value at the first pixel, 1 change up to it, 2 κ (exponent\[25:24\], mantissa\[23:0\]).
/// Latency: one clock from `take`; one value per clock while `run`.
#[derive(LogicBlock, Default)]
pub struct Swing {
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
    /// Next span, change up to it.
    word_change: Register<Q<1, 30>>,
    /// Next span, mantissa of the multiplier.
    word_mantissa: Register<Q<24, 0>>,
    /// Next span, exponent of the multiplier.
    word_exponent: Register<U<2>>,
    /// Value at the current pixel.
    total: Register<Q<1, 42>>,
    /// Change up to it.
    change: Register<Q<1, 42>>,
    /// Mantissa of the multiplier.
    mantissa: Register<Q<24, 0>>,
    /// Exponent of the multiplier.
    exponent: Register<U<2>>,
    /// Register bus as a word.
    bus: Wire<Q<1, 30>>,
    /// Mantissa on the register bus.
    bus_mantissa: Wire<U<25>>,
    /// Value as the multiplier takes it.
    operand: Wire<Q<1, 23>>,
    /// Value times mantissa.
    product: Wire<Q<26, 23>>,
    /// Its bits.
    product_bits: Wire<U<50>>,
    /// Product for exponent 0, in units of the 42nd fraction bit.
    drop_0: Wire<Q<46, 0>>,
    /// Product for exponent 1.
    drop_1: Wire<Q<46, 0>>,
    /// Product for exponent 2.
    drop_2: Wire<Q<46, 0>>,
    /// Product for exponent 3.
    drop_3: Wire<Q<46, 0>>,
    /// The product with the binary point of 3 places.
    placed_0: Wire<Q<46, 3>>,
    /// The product with the binary point of 11 places.
    placed_1: Wire<Q<38, 11>>,
    /// The product with the binary point of 19 places.
    placed_2: Wire<Q<30, 19>>,
    /// The product with the binary point of 27 places.
    placed_3: Wire<Q<22, 27>>,
    /// The product that counts.
    drop_chosen: Wire<Q<46, 0>>,
    /// Its bits.
    drop_bits: Wire<U<44>>,
    /// What the change falls by.
    drop: Wire<Q<1, 42>>,
    /// Change up to the next pixel.
    next_change: Wire<Q<1, 42>>,
    /// Value with 16 fraction bits.
    coarse: Wire<Q<1, 16>>,
    /// Its bits.
    coarse_bits: Wire<U<18>>,
}

impl Logic for Swing {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name swing");
        comment!("title A cosine along a span by differences: one multiplier, two adders.");
        comment!(
            "equation d(k+1) = d(k) - kappa I(k);  I(k+1) = I(k) + d(k+1);  kappa = 4 sin^2(K/2)"
        );
        comment!("source Hast 2004, equations 3.38 to 3.45 (slerp, paper IV), in difference form.");
        comment!("latency One clock from take to value; one value per clock.");
        dff_setup!(
            self,
            clock,
            word_value,
            word_change,
            word_mantissa,
            word_exponent,
            total,
            change,
            mantissa,
            exponent
        );
        self.bus.next = signed_cast_bits::<1, 30, 32>(self.data.val());
        self.bus_mantissa.next = self.data.val().get_bits::<25>(0);
        if self.write.val() {
            if self.word.val() == 0u64.into() {
                self.word_value.d.next = self.bus.val();
            }
            if self.word.val() == 1u64.into() {
                self.word_change.d.next = self.bus.val();
            }
            if self.word.val() == 2u64.into() {
                self.word_mantissa.d.next = signed_cast_bits::<24, 0, 25>(self.bus_mantissa.val());
                self.word_exponent.d.next = self.data.val().get_bits::<2>(25);
            }
        }
        self.operand.next = signed_cast_align::<1, 23, 1, 42>(self.total.q.val());
        self.product.next =
            signed_cast_product::<26, 23>(self.operand.val() * self.mantissa.q.val());
        self.product_bits.next = self.product.val().get_bits::<50>(0);
        self.placed_0.next = signed_cast_bits::<46, 3, 50>(self.product_bits.val());
        self.placed_1.next = signed_cast_bits::<38, 11, 50>(self.product_bits.val());
        self.placed_2.next = signed_cast_bits::<30, 19, 50>(self.product_bits.val());
        self.placed_3.next = signed_cast_bits::<22, 27, 50>(self.product_bits.val());
        self.drop_0.next = signed_cast_align::<46, 0, 46, 3>(self.placed_0.val());
        self.drop_1.next = signed_cast_align::<46, 0, 38, 11>(self.placed_1.val());
        self.drop_2.next = signed_cast_align::<46, 0, 30, 19>(self.placed_2.val());
        self.drop_3.next = signed_cast_align::<46, 0, 22, 27>(self.placed_3.val());
        self.drop_chosen.next = self.drop_0.val();
        if self.exponent.q.val() == 1u64.into() {
            self.drop_chosen.next = self.drop_1.val();
        }
        if self.exponent.q.val() == 2u64.into() {
            self.drop_chosen.next = self.drop_2.val();
        }
        if self.exponent.q.val() == 3u64.into() {
            self.drop_chosen.next = self.drop_3.val();
        }
        self.drop_bits.next = self.drop_chosen.val().get_bits::<44>(0);
        self.drop.next = signed_cast_bits::<1, 42, 44>(self.drop_bits.val());
        self.next_change.next = self.change.q.val() - self.drop.val();
        if self.take.val() {
            self.total.d.next = signed_cast_align::<1, 42, 1, 30>(self.word_value.q.val());
            self.change.d.next = signed_cast_align::<1, 42, 1, 30>(self.word_change.q.val());
            self.mantissa.d.next = self.word_mantissa.q.val();
            self.exponent.d.next = self.word_exponent.q.val();
        } else if self.run.val() {
            self.total.d.next = self.total.q.val() + self.next_change.val();
            self.change.d.next = self.next_change.val();
        }
        self.coarse.next = signed_cast_align::<1, 16, 1, 42>(self.total.q.val());
        self.coarse_bits.next = self.coarse.val().get_bits::<18>(0);
        self.value.next = self.total.q.val();
        self.level.next = signed_cast_bits::<17, 0, 18>(self.coarse_bits.val());
    }
}

crate::clocked!(Swing;
    inputs write, word, data, take, run;
    outputs value, level);

/// Integer model of [`Swing`].
#[derive(Clone, Copy, Debug, Default)]
pub struct SwingModel {
    words: [i64; 4],
    change: i64,
    mantissa: i64,
    exponent: i64,
    /// Cosine at the current pixel, Q1.42.
    pub value: i64,
}

impl SwingModel {
    /// One clock; `write` is a register word and its data.
    pub fn clock(&mut self, write: Option<(usize, u64)>, take: bool, run: bool) {
        const WIDTH: usize = 2 + FRACTION_BITS;
        let [value, change, mantissa, exponent] = self.words;
        if take {
            self.value = value << (FRACTION_BITS - WORD_FRACTION_BITS);
            self.change = change << (FRACTION_BITS - WORD_FRACTION_BITS);
            (self.mantissa, self.exponent) = (mantissa, exponent);
        } else if run {
            let product = (self.value >> (FRACTION_BITS - 23)) * self.mantissa;
            let drop = wrap(product >> (3 + EXPONENT_STEP as i64 * self.exponent), WIDTH);
            self.change = wrap(self.change - drop, WIDTH);
            self.value = wrap(self.value + self.change, WIDTH);
        }
        match write {
            Some((word @ (0 | 1), data)) => self.words[word] = wrap(data as i64, 32),
            Some((2, data)) => {
                self.words[2] = wrap(data as i64, 25);
                self.words[3] = (data >> 25 & 3) as i64;
            }
            _ => {}
        }
    }
}
