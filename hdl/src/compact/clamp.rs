//! Colour output of the compact unit: the integer part of a value, clamped to 0..=255.
//!
//! Values are residues. A six-knot colour of knots from 0 to K leaves them by a third at most, −K/3 to 4K/3, which lies
//! in the middle of −2^(M−1) .. 3·2^(M−1): so that is what the `M` + 1 bits are read as here. Two's complement would
//! spend one more bit on values far below 0 that no colour has.

use crate::format::{signed_cast_align, unsigned_cast_integer, Q, U};
use crate::simulate::Wire;
use rust_hdl_core::prelude::*;

/// Combinational. `M` is from 8 to 11.
#[derive(LogicBlock)]
pub struct CompactClamp<const M: usize> {
    /// Integer part of the colour in LSB, with half an LSB already added.
    pub value: Signal<In, Q<M, 0>>,
    /// Colour as a byte.
    pub level: Signal<Out, U<8>>,
    /// The value with as many bits for every `M`.
    wide: Wire<Q<11, 0>>,
    /// The same, as bits.
    bits: Wire<U<12>>,
    /// Bits above a byte.
    excess: Wire<U<4>>,
    /// The value is below 0.
    negative: Wire<Bit>,
    /// Bit `M` − 1.
    second: Constant<U<12>>,
    /// Darkest byte.
    zero: Constant<U<8>>,
    /// Brightest byte.
    full: Constant<U<8>>,
}

impl<const M: usize> Default for CompactClamp<M> {
    fn default() -> Self {
        Self {
            value: Default::default(),
            level: Default::default(),
            wide: Default::default(),
            bits: Default::default(),
            excess: Default::default(),
            negative: Default::default(),
            second: Constant::new(U::new(1 << (M - 1))),
            zero: Constant::new(U::new(0)),
            full: Constant::new(U::new(255)),
        }
    }
}

impl<const M: usize> Logic for CompactClamp<M> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name compact_clamp");
        comment!("title Clamps the integer part of a colour to a byte; its two highest bits are both one below 0.");
        comment!("equation level = min(max(value, 0), 255)");
        comment!("source A six-knot colour leaves its knots by up to a third; Abbas 2003, appendix, has no clamp.");
        comment!("latency Combinational.");
        self.wide.next = signed_cast_align::<11, 0, M, 0>(self.value.val());
        self.bits.next = unsigned_cast_integer::<12, 11, 0>(self.wide.val());
        self.excess.next = self.bits.val().get_bits::<4>(8);
        self.negative.next =
            self.bits.val().get_bit(11) && (self.bits.val() & self.second.val()).any();
        if self.negative.val() {
            self.level.next = self.zero.val();
        } else if self.excess.val().any() {
            self.level.next = self.full.val();
        } else {
            self.level.next = self.bits.val().get_bits::<8>(0);
        }
    }
}

crate::ports!(CompactClamp<M>, const M: usize;
    inputs value;
    outputs level);

/// The same: `value` has `integer` + 1 bits, sign-extended.
#[must_use]
pub fn clamp_model(value: i64, integer: usize) -> u8 {
    let past = value < -1 << (integer - 1);
    let value = if past { value + (2 << integer) } else { value };
    value.clamp(0, 255) as u8
}
