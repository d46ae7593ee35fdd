//! A table at an angle that grows evenly along a span, times an amplitude: A·f(ξ), ξ = ξ₀ + k·s (Abbas 2003, figure
//! 6.6). f is even and the table holds it from 0 to where it ends, cos or cos² over a quarter of a turn, or the cosⁿ of a
//! material over the angles where it shows; beyond, the factor is 0.
//!
//! # Formats
//! ξ counts words of the table: Q`M`.14 with M = K + 6, so that a phase of 63 times the table does not wrap. The 12 bits
//! of figure 6.6 hold 6 fraction bits and no integer bit: after 512 pixels they are 4 words off, and a highlight returns
//! when the phase wraps. 14 fraction bits are 10 for 1024 pixels and 4 more: words rounded to nearest are within (1 + k)·
//! 2^−15 of a table word after k pixels, 1/32 at 1024.
//! Words of the table have K bits, of which 2^K − 1 is full scale; the amplitude is an unsigned word of 18 bits in units
//! of 2^−16, with 2^K/(2^K − 1) in it, so that the product shifted by K is the factor: at most 65536·(1 + 2^−17).

use crate::format::{
    bit_cast_product, bit_cast_u, mask, signed_cast_align, signed_cast_bits, unsigned_cast_integer,
    Q, U,
};
use crate::interpolate::linear_span::{LinearSpan, LinearSpanModel};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Fraction bits of a phase below a table word.
pub const FRACTION_BITS: usize = 14;
/// Integer bits of a phase above the table.
pub const TURNS_BITS: usize = 6;

/// `K` address and data bits of the table; `M` = `K` + 6; `P` = `K` + 18.
/// Register words: 0 phase at the first pixel, 1 its step, 2 amplitude.
/// Latency: the address one clock behind the pixel registers, the word two, the factor three.
#[derive(LogicBlock)]
pub struct AngleFactor<const K: usize, const M: usize, const P: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move.
    pub go: Signal<In, Bit>,
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
    /// Address of the table, first stage.
    pub address: Signal<Out, U<K>>,
    /// The word there, second stage.
    pub table_word: Signal<In, U<K>>,
    /// Factor, 65536 is 1.
    pub factor: Signal<Out, U<17>>,
    /// Next span, amplitude.
    word_amplitude: Register<U<18>>,
    /// Amplitude of the span.
    amplitude: Register<U<18>>,
    /// Address of the table, first stage.
    place: Register<U<K>>,
    /// The angle is within the table, first stage.
    inside_first: Register<Bit>,
    /// Amplitude, first stage.
    amplitude_first: Register<U<18>>,
    /// The angle is within the table, second stage.
    inside_second: Register<Bit>,
    /// Amplitude, second stage.
    amplitude_second: Register<U<18>>,
    /// The factor in the third stage.
    third: Register<U<17>>,
    /// Phase in words of the table, rounded down.
    whole: Wire<Q<M, 0>>,
    /// Its size: a negative one is complemented, since -1 is the first word on the other side.
    size: Wire<Q<M, 0>>,
    /// The same without sign.
    size_bits: Wire<U<M>>,
    /// Its low bits, the place in the table.
    low_bits: Wire<U<K>>,
    /// The same as wide as the size.
    low_size: Wire<U<M>>,
    /// Word times amplitude.
    product: Wire<U<P>>,
    /// The product with its binary point.
    aligned: Wire<Q<17, K>>,
    /// The product in units of a factor.
    scaled: Wire<Q<17, 0>>,
    /// Phase.
    phase: Quiet<LinearSpan<M, 14>>,
    /// Phase 0.
    origin: Constant<Q<M, 0>>,
    /// No light.
    zero: Constant<U<17>>,
}

impl<const K: usize, const M: usize, const P: usize> Default for AngleFactor<K, M, P> {
    fn default() -> Self {
        assert!(
            M == K + TURNS_BITS && P == K + 18 && M + FRACTION_BITS < 32,
            "a phase counts words of a table of {K} address bits and fits the bus"
        );
        Self {
            clock: Default::default(),
            go: Default::default(),
            write: Default::default(),
            word: Default::default(),
            data: Default::default(),
            take: Default::default(),
            run: Default::default(),
            address: Default::default(),
            table_word: Default::default(),
            factor: Default::default(),
            word_amplitude: Default::default(),
            amplitude: Default::default(),
            place: Default::default(),
            inside_first: Default::default(),
            amplitude_first: Default::default(),
            inside_second: Default::default(),
            amplitude_second: Default::default(),
            third: Default::default(),
            whole: Default::default(),
            size: Default::default(),
            size_bits: Default::default(),
            low_bits: Default::default(),
            low_size: Default::default(),
            product: Default::default(),
            aligned: Default::default(),
            scaled: Default::default(),
            phase: Default::default(),
            origin: Constant::new(Q::from_code(0)),
            zero: Constant::new(U::new(0)),
        }
    }
}

impl<const K: usize, const M: usize, const P: usize> Logic for AngleFactor<K, M, P> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name angle_factor");
        comment!("title A table word at an evenly growing angle, times an amplitude.");
        comment!("equation factor = A f(xi), xi = xi0 + k s; 0 beyond the table");
        comment!("source Abbas 2003, equations 6.8 to 6.11 and figure 6.6; wider phase, so that nothing wraps.");
        comment!("latency Three clocks from phase to factor.");
        dff_setup!(
            self,
            clock,
            word_amplitude,
            amplitude,
            place,
            inside_first,
            amplitude_first,
            inside_second,
            amplitude_second,
            third
        );
        self.phase.clock.next = self.clock.val();
        self.phase.write.next = self.write.val();
        self.phase.word.next = self.word.val();
        self.phase.data.next = self.data.val();
        self.phase.take.next = self.take.val();
        self.phase.run.next = self.run.val();
        if self.write.val() && (self.word.val() == 2u64.into()) {
            self.word_amplitude.d.next = self.data.val().get_bits::<18>(0);
        }
        if self.take.val() {
            self.amplitude.d.next = self.word_amplitude.q.val();
        }

        self.whole.next = self.phase.value.val();
        self.size.next = self.whole.val();
        if self.whole.val() < self.origin.val() {
            self.size.next = !self.whole.val();
        }
        self.size_bits.next = unsigned_cast_integer::<M, M, 0>(self.size.val());
        self.low_bits.next = self.size_bits.val().get_bits::<K>(0);
        self.low_size.next = bit_cast_u::<M, K>(self.low_bits.val());
        self.product.next =
            bit_cast_product::<P>(self.table_word.val() * self.amplitude_second.q.val());
        self.aligned.next = signed_cast_bits::<17, K, P>(self.product.val());
        self.scaled.next = signed_cast_align::<17, 0, 17, K>(self.aligned.val());
        if self.go.val() {
            self.place.d.next = self.low_bits.val();
            self.inside_first.d.next = self.low_size.val() == self.size_bits.val();
            self.amplitude_first.d.next = self.amplitude.q.val();
            self.inside_second.d.next = self.inside_first.q.val();
            self.amplitude_second.d.next = self.amplitude_first.q.val();
            if self.inside_second.q.val() {
                self.third.d.next = self.scaled.val().get_bits::<17>(0);
            } else {
                self.third.d.next = self.zero.val();
            }
        }
        self.address.next = self.place.q.val();
        self.factor.next = self.third.q.val();
    }
}

crate::clocked!(AngleFactor<K, M, P>, const K: usize, const M: usize, const P: usize;
    inputs go, write, word, data, take, run, table_word;
    outputs address, factor);

/// Integer model of [`AngleFactor`] with a table of `K` address bits; the table is outside.
#[derive(Clone, Copy, Debug)]
pub struct AngleFactorModel {
    table_bits: usize,
    phase: LinearSpanModel,
    word_amplitude: u64,
    amplitude: u64,
    first: (u64, bool, u64),
    second: (bool, u64),
    third: u64,
}

impl AngleFactorModel {
    /// At power-up.
    #[must_use]
    pub fn new(table_bits: usize) -> Self {
        Self {
            table_bits,
            phase: LinearSpanModel::default(),
            word_amplitude: 0,
            amplitude: 0,
            first: (0, false, 0),
            second: (false, 0),
            third: 0,
        }
    }

    /// Address of the table, first stage.
    #[must_use]
    pub fn address(&self) -> u64 {
        self.first.0
    }

    /// The factor of the third stage.
    #[must_use]
    pub fn factor(&self) -> u64 {
        self.third
    }

    /// One clock; `table_word` is what the table shows in the second stage.
    pub fn clock(
        &mut self,
        go: bool,
        write: Option<(usize, u64)>,
        [take, run]: [bool; 2],
        table_word: u64,
    ) {
        let k = self.table_bits;
        if go {
            let (inside, amplitude) = self.second;
            let factor = (table_word * amplitude) >> k & mask(17);
            self.third = if inside { factor } else { 0 };
            self.second = (self.first.1, self.first.2);
            let whole = self.phase.value() >> FRACTION_BITS;
            let size = if whole < 0 { !whole } else { whole } as u64;
            self.first = (size & mask(k), size >> k == 0, self.amplitude);
        }
        if take {
            self.amplitude = self.word_amplitude;
        }
        if let Some((2, data)) = write {
            self.word_amplitude = data & mask(18);
        }
        let width = 1 + k + TURNS_BITS + FRACTION_BITS;
        self.phase.clock(width, write, take, run);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every word of a table, at both ends of its bin and on both sides of zero, and what lies beyond the table.
    fn every_word(k: usize) -> f64 {
        let words = 1i64 << k;
        let full = (words - 1) as f64;
        let bin = std::f64::consts::FRAC_PI_2 / words as f64;
        let table = |at: i64| ((at as f64 + 0.5) * bin).cos().powi(2) * full;
        let amplitude = (65_536.0 * words as f64 / full).round() as u64;
        let mut worst = 0.0f64;
        for at in -words - 2..words + 2 {
            for place in [0, 1 << 13, (1 << 14) - 1] {
                let phase = at << FRACTION_BITS | place;
                let mut m = AngleFactorModel::new(k);
                let still = [false; 2];
                m.clock(true, Some((0, phase as u64)), still, 0);
                m.clock(true, Some((2, amplitude)), still, 0);
                m.clock(true, None, [true, false], 0);
                m.clock(true, None, still, 0);
                let address = m.address() as i64;
                m.clock(true, None, still, 0);
                m.clock(true, None, still, table(address).round() as u64);
                let angle = phase as f64 / (1 << FRACTION_BITS) as f64 * bin;
                let want = if angle.abs() < std::f64::consts::FRAC_PI_2 {
                    angle.cos().powi(2)
                } else {
                    0.0
                };
                worst = worst.max((m.factor() as f64 / 65_536.0 - want).abs());
            }
        }
        255.0 * worst
    }

    /// The quantisation that the notes measured for cos² with K address and data bits, in LSB of full scale.
    #[test]
    fn every_word_of_every_table_is_within_its_quantisation() {
        let bounds = [17.6, 9.1, 4.7, 2.6, 1.2, 0.7, 0.3];
        for (k, bound) in (4..).zip(bounds) {
            let worst = every_word(k);
            println!("{k} bits: {worst:.2} LSB");
            assert!(worst < bound + 0.16 && worst > 0.5 * bound, "{k}: {worst}");
        }
    }
}
