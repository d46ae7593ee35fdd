//! The multiplier: a word of 25 bits times one of up to 64, sixteen bits per clock in one DSP block, and the product
//! moved to where its reader wants the binary point.
//!
//! # Range and rounding
//! x is taken modulo 2^25 with its sign; y has `limbs` of 16 bits, the last one with its sign. A limb's product has 43
//! bits and the running total, which passes 16 bits on to the low part with every limb, fewer than 45: nothing overflows.
//! The product is exact. It is then x·y·2^(64 − 16(limbs − 1) − places) modulo 2^64, rounded down.

use super::instruction::Exponent;
use crate::format::{bit_cast_u, signed_cast_align, signed_cast_bits, signed_cast_product, Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Latency: four clocks and one per limb from `start` to `product`; a new product may be started after as many clocks as
/// the last one has limbs.
#[derive(LogicBlock, Default)]
pub struct Multiplier {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move.
    pub go: Signal<In, Bit>,
    /// Takes operands.
    pub start: Signal<In, Bit>,
    /// First operand, of which the low 25 bits count.
    pub x: Signal<In, U<64>>,
    /// Second operand.
    pub y: Signal<In, U<64>>,
    /// Limbs of the second operand, less one.
    pub limbs: Signal<In, U<2>>,
    /// Places down.
    pub places: Signal<In, U<7>>,
    /// What is added to them: 0 nothing, 1 the exponent, 2 twice the exponent.
    pub kind: Signal<In, U<2>>,
    /// Exponent of the last reciprocal.
    pub exponent: Signal<In, U<6>>,
    /// The last product.
    pub product: Signal<Out, U<64>>,
    /// First operand.
    x_held: Register<Q<24, 0>>,
    /// What is left of the second operand.
    y_left: Register<U<64>>,
    /// Its limbs.
    limbs_left: Register<U<3>>,
    /// The next limb is the lowest one.
    first: Register<Bit>,
    /// Places down.
    places_held: Register<U<7>>,
    /// Product of a limb.
    part: Register<Q<42, 0>>,
    /// There is one.
    part_valid: Register<Bit>,
    /// It is that of the lowest limb.
    part_first: Register<Bit>,
    /// It is that of the highest limb.
    part_last: Register<Bit>,
    /// Its places down.
    part_places: Register<U<7>>,
    /// Running total, less what has passed to the low part.
    total: Register<Q<47, 0>>,
    /// Bits below the total.
    low: Register<U<48>>,
    /// The total is complete.
    total_done: Register<Bit>,
    /// Its places down.
    total_places: Register<U<7>>,
    /// Sixteen bits of the product from the coarse place up.
    window_0: Register<U<16>>,
    /// The next sixteen.
    window_1: Register<U<16>>,
    /// The next sixteen.
    window_2: Register<U<16>>,
    /// The next sixteen.
    window_3: Register<U<16>>,
    /// The next sixteen.
    window_4: Register<U<16>>,
    /// The window is filled.
    window_done: Register<Bit>,
    /// Places down within the window.
    fine: Register<U<4>>,
    /// The product.
    result: Register<U<64>>,
    /// Bits of the first operand.
    x_bits: Wire<U<25>>,
    /// Places to add.
    more: Wire<U<7>>,
    /// Twice the exponent.
    doubled: Wire<U<7>>,
    /// The limb in work.
    limb_bits: Wire<U<16>>,
    /// The limb as one that carries the sign.
    limb_signed: Wire<Q<15, 0>>,
    /// The limb as one that does not.
    limb_plain: Wire<U<18>>,
    /// The limb as the multiplier takes it.
    limb: Wire<Q<17, 0>>,
    /// The limb is the highest.
    last: Wire<Bit>,
    /// A limb is in work.
    working: Wire<Bit>,
    /// Total as bits.
    total_bits: Wire<U<48>>,
    /// Total with the binary point moved.
    total_point: Wire<Q<31, 16>>,
    /// Total over 2^16.
    passed: Wire<Q<47, 0>>,
    /// The limb's product as wide as the total.
    part_wide: Wire<Q<47, 0>>,
    /// Bits that pass to the low part.
    passing: Wire<U<16>>,
    /// The same in their place.
    passing_high: Wire<U<48>>,
    /// Low part moved down.
    low_down: Wire<U<48>>,
    /// Sixteen copies of the sign.
    sign: Wire<U<16>>,
    /// Sixteen bits of the low part.
    low_0: Wire<U<16>>,
    /// The next sixteen.
    low_1: Wire<U<16>>,
    /// The next sixteen.
    low_2: Wire<U<16>>,
    /// Sixteen bits of the total.
    total_0: Wire<U<16>>,
    /// The next sixteen.
    total_1: Wire<U<16>>,
    /// The next sixteen.
    total_2: Wire<U<16>>,
    /// Places down in units of sixteen.
    coarse: Wire<U<3>>,
    /// Lower part of the window.
    window_low: Wire<U<48>>,
    /// Upper part of the window.
    window_high: Wire<U<48>>,
    /// The same at the fine place.
    fine_low: Wire<U<48>>,
    /// The same at the fine place.
    fine_high: Wire<U<48>>,
    /// Lower half of the product.
    half_low: Wire<U<32>>,
    /// Upper half of the product.
    half_high: Wire<U<32>>,
}

impl Logic for Multiplier {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name set_up_multiplier");
        comment!(
            "title Shared multiplier: 25 by 16 bits a clock, a running total, a shifter behind it."
        );
        comment!("equation product = floor(x y 2^(64 - 16 (limbs - 1) - places)) mod 2^64");
        comment!("source Schoolbook multiplication, low limb first.");
        comment!("latency Four clocks and one per limb from start to product.");
        dff_setup!(
            self,
            clock,
            x_held,
            y_left,
            limbs_left,
            first,
            places_held,
            part,
            part_valid,
            part_first,
            part_last,
            part_places,
            total,
            low,
            total_done,
            total_places,
            window_0,
            window_1,
            window_2,
            window_3,
            window_4,
            window_done,
            fine,
            result
        );
        self.x_bits.next = self.x.val().get_bits::<25>(0);
        self.doubled.next = bit_cast_u::<7, 6>(self.exponent.val()) << 1u64;
        self.more.next = 0u64.into();
        if self.kind.val() == 1u64.into() {
            self.more.next = bit_cast_u::<7, 6>(self.exponent.val());
        }
        if self.kind.val() == 2u64.into() {
            self.more.next = self.doubled.val();
        }
        // Limbs.
        self.working.next = self.limbs_left.q.val().any();
        self.last.next = self.limbs_left.q.val() == 1u64.into();
        self.limb_bits.next = self.y_left.q.val().get_bits::<16>(0);
        self.limb_signed.next = signed_cast_bits::<15, 0, 16>(self.limb_bits.val());
        self.limb_plain.next = bit_cast_u::<18, 16>(self.limb_bits.val());
        self.limb.next = signed_cast_bits::<17, 0, 18>(self.limb_plain.val());
        if self.last.val() {
            self.limb.next = signed_cast_align::<17, 0, 15, 0>(self.limb_signed.val());
        }
        // The total and what it passes down.
        self.total_bits.next = self.total.q.val().get_bits::<48>(0);
        self.total_point.next = signed_cast_bits::<31, 16, 48>(self.total_bits.val());
        self.passed.next = signed_cast_align::<47, 0, 31, 16>(self.total_point.val());
        self.part_wide.next = signed_cast_align::<47, 0, 42, 0>(self.part.q.val());
        self.passing.next = self.total_bits.val().get_bits::<16>(0);
        self.passing_high.next = bit_cast_u::<48, 16>(self.passing.val()) << 32u64;
        self.low_down.next = self.low.q.val() >> 16u64;
        // The shifter.
        self.sign.next = 0u64.into();
        if self.total_bits.val().get_bit(47) {
            self.sign.next = 0xffffu64.into();
        }
        self.low_0.next = self.low.q.val().get_bits::<16>(0);
        self.low_1.next = self.low.q.val().get_bits::<16>(16);
        self.low_2.next = self.low.q.val().get_bits::<16>(32);
        self.total_0.next = self.total_bits.val().get_bits::<16>(0);
        self.total_1.next = self.total_bits.val().get_bits::<16>(16);
        self.total_2.next = self.total_bits.val().get_bits::<16>(32);
        self.coarse.next = self.total_places.q.val().get_bits::<3>(4);
        self.window_low.next = bit_cast_u::<48, 16>(self.window_0.q.val())
            | (bit_cast_u::<48, 16>(self.window_1.q.val()) << 16u64)
            | (bit_cast_u::<48, 16>(self.window_2.q.val()) << 32u64);
        self.window_high.next = bit_cast_u::<48, 16>(self.window_2.q.val())
            | (bit_cast_u::<48, 16>(self.window_3.q.val()) << 16u64)
            | (bit_cast_u::<48, 16>(self.window_4.q.val()) << 32u64);
        self.fine_low.next = self.window_low.val() >> self.fine.q.val();
        self.fine_high.next = self.window_high.val() >> self.fine.q.val();
        self.half_low.next = self.fine_low.val().get_bits::<32>(0);
        self.half_high.next = self.fine_high.val().get_bits::<32>(0);
        if self.go.val() {
            if self.window_done.q.val() {
                self.result.d.next = bit_cast_u::<64, 32>(self.half_low.val())
                    | (bit_cast_u::<64, 32>(self.half_high.val()) << 32u64);
            }
            self.window_done.d.next = self.total_done.q.val();
            if self.total_done.q.val() {
                self.fine.d.next = self.total_places.q.val().get_bits::<4>(0);
                self.window_0.d.next = self.sign.val();
                self.window_1.d.next = self.sign.val();
                self.window_2.d.next = self.sign.val();
                self.window_3.d.next = self.sign.val();
                self.window_4.d.next = self.sign.val();
                if self.coarse.val() == 0u64.into() {
                    self.window_0.d.next = 0u64.into();
                    self.window_1.d.next = self.low_0.val();
                    self.window_2.d.next = self.low_1.val();
                    self.window_3.d.next = self.low_2.val();
                    self.window_4.d.next = self.total_0.val();
                }
                if self.coarse.val() == 1u64.into() {
                    self.window_0.d.next = self.low_0.val();
                    self.window_1.d.next = self.low_1.val();
                    self.window_2.d.next = self.low_2.val();
                    self.window_3.d.next = self.total_0.val();
                    self.window_4.d.next = self.total_1.val();
                }
                if self.coarse.val() == 2u64.into() {
                    self.window_0.d.next = self.low_1.val();
                    self.window_1.d.next = self.low_2.val();
                    self.window_2.d.next = self.total_0.val();
                    self.window_3.d.next = self.total_1.val();
                    self.window_4.d.next = self.total_2.val();
                }
                if self.coarse.val() == 3u64.into() {
                    self.window_0.d.next = self.low_2.val();
                    self.window_1.d.next = self.total_0.val();
                    self.window_2.d.next = self.total_1.val();
                    self.window_3.d.next = self.total_2.val();
                }
                if self.coarse.val() == 4u64.into() {
                    self.window_0.d.next = self.total_0.val();
                    self.window_1.d.next = self.total_1.val();
                    self.window_2.d.next = self.total_2.val();
                }
                if self.coarse.val() == 5u64.into() {
                    self.window_0.d.next = self.total_1.val();
                    self.window_1.d.next = self.total_2.val();
                }
                if self.coarse.val() == 6u64.into() {
                    self.window_0.d.next = self.total_2.val();
                }
            }
            self.total_done.d.next = self.part_valid.q.val() && self.part_last.q.val();
            if self.part_valid.q.val() {
                self.total_places.d.next = self.part_places.q.val();
                self.total.d.next = self.part_wide.val();
                self.low.d.next = 0u64.into();
                if !self.part_first.q.val() {
                    self.total.d.next = self.part_wide.val() + self.passed.val();
                    self.low.d.next = self.low_down.val() | self.passing_high.val();
                }
            }
            self.part_valid.d.next = self.working.val();
            if self.working.val() {
                self.part.d.next =
                    signed_cast_product::<42, 0>(self.x_held.q.val() * self.limb.val());
                self.part_first.d.next = self.first.q.val();
                self.part_last.d.next = self.last.val();
                self.part_places.d.next = self.places_held.q.val();
                self.y_left.d.next = self.y_left.q.val() >> 16u64;
                self.first.d.next = false;
                self.limbs_left.d.next = self.limbs_left.q.val() - 1u64.into();
            }
            if self.start.val() {
                self.x_held.d.next = signed_cast_bits::<24, 0, 25>(self.x_bits.val());
                self.y_left.d.next = self.y.val();
                self.limbs_left.d.next = bit_cast_u::<3, 2>(self.limbs.val()) + 1u64.into();
                self.first.d.next = true;
                self.places_held.d.next = self.places.val() + self.more.val();
            }
        }
        self.product.next = self.result.q.val();
    }
}

crate::clocked!(Multiplier;
    inputs go, start, x, y, limbs, places, kind, exponent;
    outputs product);

/// Integer model of the multiplier.
#[derive(Clone, Copy, Debug, Default)]
pub struct MultiplierModel {
    x: i64,
    y: i64,
    limbs_left: u8,
    first: bool,
    places: u8,
    product_1: Option<(i64, bool, bool, u8)>,
    total: i64,
    low: u64,
    total_done: Option<u8>,
    window: [u16; 5],
    fine: Option<u8>,
    /// The last product.
    pub product: i64,
}

impl MultiplierModel {
    /// One clock: x, y, limbs of y, places, exponent.
    pub fn clock(&mut self, start: Option<(i64, i64, u8, u8, Exponent)>, exponent: u8) {
        if let Some(fine) = self.fine {
            let whole = self
                .window
                .iter()
                .rev()
                .fold(0u128, |v, p| v << 16 | u128::from(*p));
            self.product = (whole >> fine) as i64;
        }
        self.fine = self.total_done.map(|places| {
            let whole = i128::from(self.total) << 64 | i128::from(self.low) << 16;
            let coarse = whole >> (places & 0x70);
            for (k, piece) in self.window.iter_mut().enumerate() {
                *piece = (coarse >> (16 * k)) as u16;
            }
            places & 15
        });
        self.total_done = None;
        if let Some((product, first, last, places)) = self.product_1 {
            self.low = if first {
                0
            } else {
                self.low >> 16 | (self.total as u64 & 0xffff) << 32
            };
            self.total = product + if first { 0 } else { self.total >> 16 };
            self.total_done = last.then_some(places);
        }
        self.product_1 = None;
        if self.limbs_left > 0 {
            let last = self.limbs_left == 1;
            let limb = self.y & 0xffff;
            let limb = if last { limb as i16 as i64 } else { limb };
            self.product_1 = Some((self.x * limb, self.first, last, self.places));
            self.y >>= 16;
            self.first = false;
            self.limbs_left -= 1;
        }
        if let Some((x, y, limbs, places, e)) = start {
            let more = match e {
                Exponent::None => 0,
                Exponent::Once => exponent,
                Exponent::Twice => 2 * exponent,
            };
            self.x = x << 39 >> 39;
            self.y = y;
            self.limbs_left = limbs;
            self.first = true;
            self.places = (places + more) & 127;
        }
    }
}
