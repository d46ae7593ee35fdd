//! Weighted writing of one channel: old·(1 − w) + new·w with w = weight/255, rounded to nearest.
//!
//! Abbas (2003) adds the weighted colour to what is there, which overflows where lines cross. Here the new level lies
//! between the two. S = 255·old + (new − old)·weight is 255 times the result, 0 ≤ S ≤ 65 025, and with T = S + 128 the
//! quotient round(S/255) is (T + ⌊T/256⌋)/256, rounded down, for all such S: no divider. 255 is odd, so nothing lies
//! half-way between two levels.
//!
//! # Range
//! new − old in ±255 (Q8.0); times the weight ±65 025, kept modulo 2¹⁶, as is 255·old + 128: their sum T lies in
//! 128..=65 153 and is right; T + T/256 stays below 65 536.

use crate::format::{
    bit_cast_u, signed_cast_bits, signed_cast_product, unsigned_cast_integer, Q, U,
};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Latency: one clock, behind the multiplier. One value per clock.
#[derive(LogicBlock)]
pub struct Blend {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The pipeline moves; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Level in the frame.
    pub old: Signal<In, U<8>>,
    /// Level of the line.
    pub target: Signal<In, U<8>>,
    /// Weight of the line, of 255.
    pub weight: Signal<In, U<8>>,
    /// The level between them, one clock later.
    pub level: Signal<Out, U<8>>,
    /// Old level, one bit more.
    old_wide: Wire<U<9>>,
    /// New level, one bit more.
    new_wide: Wire<U<9>>,
    /// Weight, one bit more.
    weight_wide: Wire<U<9>>,
    /// Old level, signed.
    old_signed: Wire<Q<8, 0>>,
    /// New level, signed.
    new_signed: Wire<Q<8, 0>>,
    /// Weight, signed.
    weight_signed: Wire<Q<8, 0>>,
    /// New less old.
    difference: Wire<Q<8, 0>>,
    /// Old level in a long word.
    old_long: Wire<U<16>>,
    /// 255 times the old level, and 128.
    old_scaled: Wire<U<16>>,
    /// Weighted difference, its low 16 bits.
    product: Register<Q<15, 0>>,
    /// 255 times the old level, and 128.
    base: Register<Q<15, 0>>,
    /// 255 times the result, and 128.
    total: Wire<U<16>>,
    /// Its upper byte.
    upper: Wire<U<8>>,
    /// Its upper byte in a long word.
    upper_long: Wire<U<16>>,
    /// Half of 255, rounded up.
    half: Constant<U<16>>,
}

impl Default for Blend {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            go: Default::default(),
            old: Default::default(),
            target: Default::default(),
            weight: Default::default(),
            level: Default::default(),
            old_wide: Default::default(),
            new_wide: Default::default(),
            weight_wide: Default::default(),
            old_signed: Default::default(),
            new_signed: Default::default(),
            weight_signed: Default::default(),
            difference: Default::default(),
            old_long: Default::default(),
            old_scaled: Default::default(),
            product: Default::default(),
            base: Default::default(),
            total: Default::default(),
            upper: Default::default(),
            upper_long: Default::default(),
            half: Constant::new(U::new(128)),
        }
    }
}

impl Logic for Blend {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name blend");
        comment!("title One channel of weighted writing: between the old level and the new one.");
        comment!("equation level = round((255 old + (target - old) weight) / 255)");
        comment!("source In place of the += of Abbas 2003, chapter 3, which holds on an empty background only.");
        comment!("latency One clock from old, target and weight to level; one value per clock.");
        dff_setup!(self, clock, product, base);
        self.old_wide.next = bit_cast_u::<9, 8>(self.old.val());
        self.new_wide.next = bit_cast_u::<9, 8>(self.target.val());
        self.weight_wide.next = bit_cast_u::<9, 8>(self.weight.val());
        self.old_signed.next = signed_cast_bits::<8, 0, 9>(self.old_wide.val());
        self.new_signed.next = signed_cast_bits::<8, 0, 9>(self.new_wide.val());
        self.weight_signed.next = signed_cast_bits::<8, 0, 9>(self.weight_wide.val());
        self.difference.next = self.new_signed.val() - self.old_signed.val();
        self.old_long.next = bit_cast_u::<16, 8>(self.old.val());
        self.old_scaled.next =
            (self.old_long.val() << 8u64) - self.old_long.val() + self.half.val();
        if self.go.val() {
            self.product.d.next =
                signed_cast_product::<15, 0>(self.difference.val() * self.weight_signed.val());
            self.base.d.next = signed_cast_bits::<15, 0, 16>(self.old_scaled.val());
        }
        self.total.next =
            unsigned_cast_integer::<16, 15, 0>(self.product.q.val() + self.base.q.val());
        self.upper.next = self.total.val().get_bits::<8>(8);
        self.upper_long.next = bit_cast_u::<16, 8>(self.upper.val());
        self.level.next = bit_cast_u::<8, 16>((self.total.val() + self.upper_long.val()) >> 8u64);
    }
}

crate::clocked!(Blend;
    inputs go, old, target, weight;
    outputs level);

/// What [`Blend`] makes of a level.
#[must_use]
pub fn blend_model(old: u8, new: u8, weight: u8) -> u8 {
    let [o, n, w] = [old, new, weight].map(i32::from);
    let total = 255 * o + (n - o) * w + 128;
    ((total + (total >> 8)) >> 8) as u8
}

#[cfg(test)]
mod tests {
    use super::*;
    use shadegate_reference::line::blend::blend;

    /// Against the definition, for all levels and weights.
    #[test]
    fn the_quotient_without_a_divider_is_rounded_to_nearest() {
        for old in 0..=255u8 {
            for new in 0..=255u8 {
                for weight in 0..=255u8 {
                    let [o, n, w] = [old, new, weight].map(u32::from);
                    let want = (2 * (o * (255 - w) + n * w) + 255) / 510;
                    let got = blend_model(old, new, weight);
                    assert_eq!(u32::from(got), want, "{old} {new} {weight}");
                }
            }
        }
    }

    #[test]
    fn the_renderer_blends_alike() {
        for old in (0..=255u8).step_by(3) {
            for weight in 0..=255u8 {
                let new = old.wrapping_mul(7).wrapping_add(weight);
                let want = blend([old; 3], [new; 3], u16::from(weight), 255);
                assert_eq!([blend_model(old, new, weight); 3], want);
            }
        }
    }
}
