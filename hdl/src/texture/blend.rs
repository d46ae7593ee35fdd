//! One channel of four texels, interpolated: along the rows first, then between them.
//!
//! row = even + weight·(odd − even), cut to nine fraction bits, of both rows; then the same of the rows. Weights are
//! exact to their twelve fraction bits, so the texel is short of the mean by less than 2·2⁻⁹ LSB. A weight of 0 or 1 gives
//! the texel itself. Texels stay between 0 and 255, differences between −255 and 255: Q8.9 holds both.
//! Source: Zed3D 1996, "Bilinear", in the form with three products.

use crate::format::{bit_cast_u, signed_cast_align, signed_cast_bits, signed_cast_product, Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Clocks.
pub const STAGES: usize = 2;

/// Latency: two clocks.
#[derive(LogicBlock, Default)]
pub struct TexelBlend {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Texel of the even column and the even row.
    pub even_even: Signal<In, U<8>>,
    /// Texel of the odd column and the even row.
    pub odd_even: Signal<In, U<8>>,
    /// Texel of the even column and the odd row.
    pub even_odd: Signal<In, U<8>>,
    /// Texel of the odd column and the odd row.
    pub odd_odd: Signal<In, U<8>>,
    /// Weight of the odd column.
    pub column_weight: Signal<In, Q<1, 12>>,
    /// Weight of the odd row.
    pub row_weight: Signal<In, Q<1, 12>>,
    /// The mean, in 256ths of full scale.
    pub texel: Signal<Out, Q<0, 17>>,
    /// The even row.
    even_row_1: Register<Q<8, 9>>,
    /// The odd row.
    odd_row_1: Register<Q<8, 9>>,
    /// Weight of the odd row.
    row_weight_1: Register<Q<1, 12>>,
    /// The mean.
    texel_2: Register<Q<8, 9>>,
    /// Texel of the even column and row as a number.
    first: Wire<Q<8, 0>>,
    /// The one beside it.
    second: Wire<Q<8, 0>>,
    /// Texel of the even column and the odd row as a number.
    third: Wire<Q<8, 0>>,
    /// The one beside it.
    fourth: Wire<Q<8, 0>>,
    /// Change along the even row.
    even_change: Wire<Q<8, 0>>,
    /// Change along the odd row.
    odd_change: Wire<Q<8, 0>>,
    /// Change between the rows.
    row_change: Wire<Q<8, 9>>,
    /// Part of the change along the even row.
    even_part: Wire<Q<8, 9>>,
    /// Part of the change along the odd row.
    odd_part: Wire<Q<8, 9>>,
    /// Part of the change between the rows.
    row_part: Wire<Q<8, 9>>,
    /// Begin of the even row.
    even_start: Wire<Q<8, 9>>,
    /// Begin of the odd row.
    odd_start: Wire<Q<8, 9>>,
    /// The mean as bits.
    texel_bits: Wire<U<18>>,
    /// Texels with a sign.
    first_bits: Wire<U<9>>,
    /// The second.
    second_bits: Wire<U<9>>,
    /// The third.
    third_bits: Wire<U<9>>,
    /// The fourth.
    fourth_bits: Wire<U<9>>,
}

impl Logic for TexelBlend {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name texel_blend");
        comment!("title One channel of four texels, interpolated bilinearly.");
        comment!("equation row = even + column_weight (odd - even); texel = even row + row_weight (odd row - even row)");
        comment!("source Zed3D 1996, bilinear.");
        comment!("latency Two clocks; one texel per clock.");
        dff_setup!(self, clock, even_row_1, odd_row_1, row_weight_1, texel_2);
        self.first_bits.next = bit_cast_u::<9, 8>(self.even_even.val());
        self.second_bits.next = bit_cast_u::<9, 8>(self.odd_even.val());
        self.third_bits.next = bit_cast_u::<9, 8>(self.even_odd.val());
        self.fourth_bits.next = bit_cast_u::<9, 8>(self.odd_odd.val());
        self.first.next = signed_cast_bits::<8, 0, 9>(self.first_bits.val());
        self.second.next = signed_cast_bits::<8, 0, 9>(self.second_bits.val());
        self.third.next = signed_cast_bits::<8, 0, 9>(self.third_bits.val());
        self.fourth.next = signed_cast_bits::<8, 0, 9>(self.fourth_bits.val());
        self.even_change.next = self.second.val() - self.first.val();
        self.odd_change.next = self.fourth.val() - self.third.val();
        self.even_part.next =
            signed_cast_product::<8, 9>(self.even_change.val() * self.column_weight.val());
        self.odd_part.next =
            signed_cast_product::<8, 9>(self.odd_change.val() * self.column_weight.val());
        self.even_start.next = signed_cast_align::<8, 9, 8, 0>(self.first.val());
        self.odd_start.next = signed_cast_align::<8, 9, 8, 0>(self.third.val());
        self.row_change.next = self.odd_row_1.q.val() - self.even_row_1.q.val();
        self.row_part.next =
            signed_cast_product::<8, 9>(self.row_change.val() * self.row_weight_1.q.val());
        if self.go.val() {
            self.even_row_1.d.next = self.even_start.val() + self.even_part.val();
            self.odd_row_1.d.next = self.odd_start.val() + self.odd_part.val();
            self.row_weight_1.d.next = self.row_weight.val();
            self.texel_2.d.next = self.even_row_1.q.val() + self.row_part.val();
        }
        self.texel_bits.next = self.texel_2.q.val().get_bits::<18>(0);
        self.texel.next = signed_cast_bits::<0, 17, 18>(self.texel_bits.val());
    }
}

crate::clocked!(TexelBlend;
    inputs go, even_even, odd_even, even_odd, odd_odd, column_weight, row_weight;
    outputs texel);

/// What [`TexelBlend`] makes of four texels (even and odd column of the even row, then of the odd one) and the weights of
/// the odd column and row in units of 2⁻¹²: the mean in units of 2⁻⁹.
#[must_use]
pub fn blend_model([a, b, c, d]: [i64; 4], column: i64, row: i64) -> i64 {
    let along = |from: i64, to: i64| (from << 9) + (((to - from) * column) >> 3);
    let (even, odd) = (along(a, b), along(c, d));
    even + (((odd - even) * row) >> 12)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mean_is_within_its_bound() {
        let texels = [0i64, 1, 100, 254, 255];
        let weights = [0i64, 1, 7, 2048, 4095, 4096];
        let mut worst = 0.0f64;
        for a in texels {
            for b in texels {
                for c in texels {
                    for d in texels {
                        for x in weights {
                            for y in weights {
                                let (f, g) = (x as f64 / 4096.0, y as f64 / 4096.0);
                                let row = |p: i64, q: i64| p as f64 + (q - p) as f64 * f;
                                let want = row(a, b) + (row(c, d) - row(a, b)) * g;
                                let got = blend_model([a, b, c, d], x, y);
                                assert!((0..=255 << 9).contains(&got));
                                worst = worst.max(want - got as f64 / 512.0);
                                assert!(got as f64 / 512.0 <= want + 1e-9);
                            }
                        }
                    }
                }
            }
        }
        assert!(worst < 2.0 / 512.0 && worst > 1.0 / 512.0, "{worst}");
    }
}
