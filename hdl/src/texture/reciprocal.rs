//! 1/m for 1 ≤ m < 2, faithful to 21 fraction bits: table and one Newton step, one result per clock.
//!
//! With y₀ of the table and e = 1 − m·y₀ a Newton step gives y = y₀ + y₀·e = (1 − e²)/m, which is short of 1/m by at most
//! (2⁻¹¹ + 2⁻¹⁶)² < 1.07·2⁻²². Half of that is added again together with the half unit for rounding.
//!
//! # Range and rounding
//! m has 24 fraction bits, m·y₀ is exact, e is cut to 27 fraction bits (upwards) and has 18 bits with its sign, y is cut
//! to 24 fraction bits and then, with 6·2⁻²⁴ added, to 21. So the result is within 2⁻²² + 1.07·2⁻²³ + 2⁻²⁴ + 2⁻²⁷, less
//! than one unit of 2⁻²¹, of 1/m: faithful. The test runs through all m.
//! Source: Newton's iteration for the reciprocal; Zed3D 1996 divides once per pixel and multiplies twice.

use super::reciprocal_table::ReciprocalTable;
use crate::format::{bit_cast_product, bit_cast_u, signed_cast_bits, signed_cast_product, Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Clocks from m to its reciprocal.
pub const STAGES: usize = 3;

/// Latency: three clocks.
#[derive(LogicBlock)]
pub struct Reciprocal {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// m, in units of 2^-24; the highest bit is set.
    pub m: Signal<In, U<25>>,
    /// 1/m of three clocks ago.
    pub reciprocal: Signal<Out, Q<1, 21>>,
    /// m, one clock later.
    m_1: Register<U<25>>,
    /// First approximation, 16 fraction bits.
    seed_2: Register<U<16>>,
    /// (1 - m y0) 2^10, with 17 fraction bits.
    miss_2: Register<Q<0, 17>>,
    /// The reciprocal.
    reciprocal_3: Register<U<22>>,
    /// Interval of m.
    interval: Wire<U<10>>,
    /// Word of the interval.
    word: Wire<U<16>>,
    /// m times the word.
    product: Wire<U<41>>,
    /// The same, low bits in units of 2^-27.
    product_low: Wire<U<18>>,
    /// The miss as bits.
    miss_bits: Wire<U<18>>,
    /// First approximation with a sign.
    seed_wide: Wire<U<17>>,
    /// The same as a number.
    seed_number: Wire<Q<0, 16>>,
    /// What the Newton step adds, in units of 2^-24.
    step: Wire<Q<10, 14>>,
    /// The same as bits.
    step_bits: Wire<U<25>>,
    /// First approximation in units of 2^-24, with what rounds the result.
    start: Wire<U<25>>,
    /// Second approximation in units of 2^-24.
    sum: Wire<U<25>>,
    /// The reciprocal with a sign.
    result_bits: Wire<U<23>>,
    /// The table.
    seeds: Quiet<ReciprocalTable>,
    /// Low bits of 1 in units of 2^-27.
    one: Constant<U<18>>,
    /// Half a unit of the result, and half of what the Newton step is short of.
    rounding: Constant<U<25>>,
}

/// What rounds the result, in units of 2⁻²⁴.
pub const ROUNDING: u64 = 6;

impl Default for Reciprocal {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            go: Default::default(),
            m: Default::default(),
            reciprocal: Default::default(),
            m_1: Default::default(),
            seed_2: Default::default(),
            miss_2: Default::default(),
            reciprocal_3: Default::default(),
            interval: Default::default(),
            word: Default::default(),
            product: Default::default(),
            product_low: Default::default(),
            miss_bits: Default::default(),
            seed_wide: Default::default(),
            seed_number: Default::default(),
            step: Default::default(),
            step_bits: Default::default(),
            start: Default::default(),
            sum: Default::default(),
            result_bits: Default::default(),
            seeds: Default::default(),
            one: Constant::new(U::new(0)),
            rounding: Constant::new(U::new(ROUNDING)),
        }
    }
}

impl Logic for Reciprocal {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name reciprocal");
        comment!("title One over a number from 1 to 2, by table and one Newton step, faithful.");
        comment!("equation reciprocal = y0 + y0 (1 - m y0), y0 of the table, rounded to 2^-21");
        comment!("source Newton iteration; Zed3D 1996 needs one reciprocal per pixel.");
        comment!("latency Three clocks from m to reciprocal; one result per clock.");
        dff_setup!(self, clock, m_1, seed_2, miss_2, reciprocal_3);
        self.interval.next = self.m.val().get_bits::<10>(14);
        self.seeds.clock.next = self.clock.val();
        self.seeds.read.next = self.go.val();
        self.seeds.read_address.next = self.interval.val();
        self.word.next = self.seeds.read_data.val();
        self.product.next = bit_cast_product::<41>(self.m_1.q.val() * self.word.val());
        self.product_low.next = self.product.val().get_bits::<18>(13);
        self.miss_bits.next = self.one.val() - self.product_low.val();
        self.seed_wide.next = bit_cast_u::<17, 16>(self.seed_2.q.val());
        self.seed_number.next = signed_cast_bits::<0, 16, 17>(self.seed_wide.val());
        self.step.next =
            signed_cast_product::<10, 14>(self.seed_number.val() * self.miss_2.q.val());
        self.step_bits.next = self.step.val().get_bits::<25>(0);
        self.start.next = (bit_cast_u::<25, 16>(self.seed_2.q.val()) << 8u64) | self.rounding.val();
        self.sum.next = self.start.val() + self.step_bits.val();
        if self.go.val() {
            self.m_1.d.next = self.m.val();
            self.seed_2.d.next = self.word.val();
            self.miss_2.d.next = signed_cast_bits::<0, 17, 18>(self.miss_bits.val());
            self.reciprocal_3.d.next = self.sum.val().get_bits::<22>(3);
        }
        self.result_bits.next = bit_cast_u::<23, 22>(self.reciprocal_3.q.val());
        self.reciprocal.next = signed_cast_bits::<1, 21, 23>(self.result_bits.val());
    }
}

crate::clocked!(Reciprocal;
    inputs go, m;
    outputs reciprocal);

/// What [`Reciprocal`] gives for m in units of 2⁻²⁴, in units of 2⁻²¹.
#[must_use]
pub fn reciprocal_model(m: u64) -> u64 {
    use crate::format::{mask, wrap};
    let seed = super::reciprocal_table::reciprocal_word((m >> 14 & mask(10)) as usize);
    let low = (m * seed) >> 13 & mask(18);
    let miss = wrap((low.wrapping_neg() & mask(18)) as i64, 18);
    let step = (seed as i64 * miss) >> 19;
    let sum = ((seed << 8 | ROUNDING) as i64 + step) as u64 & mask(25);
    sum >> 3 & mask(22)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every m, against the exact quotient in integers: the error is less than one unit, and more than half of one
    /// somewhere, so the test is about this table.
    #[test]
    fn the_reciprocal_is_faithful_for_every_mantissa() {
        let (mut worst, mut exact) = (0i64, 0u32);
        for m in 1u64 << 24..1 << 25 {
            // 1/m in units of 2^-21 is 2^45/m; errors in units of 2^-21/64.
            let want = ((1u64 << 51) / m) as i64;
            let got = (reciprocal_model(m) << 6) as i64;
            let off = (got - want).abs();
            exact += u32::from(off <= 32);
            worst = worst.max(off);
        }
        assert!(worst < 63 && worst > 40, "{worst} / 64");
        assert!(exact > 1 << 23, "{exact}");
    }

    #[test]
    fn one_is_one() {
        assert_eq!(reciprocal_model(1 << 24), 1 << 21);
    }
}
