//! One colour channel times its texel. The colour waits five clocks for the texel.
//!
//! The colour, Q11.6 and scaled by 256/255 by the host, may leave 0..=255: it is clamped after the product, as in
//! software. Its cut to six fraction bits and the product's lower it by at most 2·2⁻⁶ LSB together; then comes the half
//! for rounding. |colour| ≤ 2048 and texel < 1, so the product fits Q11.

use crate::format::{signed_cast_align, signed_cast_bits, signed_cast_product, Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Clocks from the colour to the modulated one; from the texel it is one.
pub const STAGES: usize = 6;

/// Latency: six clocks from colour, one from texel.
#[derive(LogicBlock)]
pub struct Modulate {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Shaded colour, in units of 1/64 LSB.
    pub colour: Signal<In, Q<17, 0>>,
    /// Texel of the colour of five clocks ago, in 256ths of full scale.
    pub texel: Signal<In, Q<0, 17>>,
    /// Integer part of the product, with half an LSB added.
    pub level: Signal<Out, Q<11, 0>>,
    /// Colour, stage 1.
    colour_1: Register<Q<17, 0>>,
    /// Stage 2.
    colour_2: Register<Q<17, 0>>,
    /// Stage 3.
    colour_3: Register<Q<17, 0>>,
    /// Stage 4.
    colour_4: Register<Q<17, 0>>,
    /// Stage 5.
    colour_5: Register<Q<17, 0>>,
    /// The product.
    product_6: Register<Q<11, 6>>,
    /// Colour of stage 5 as bits.
    colour_bits: Wire<U<18>>,
    /// The same in LSB.
    colour_number: Wire<Q<11, 6>>,
    /// The product before rounding.
    product: Wire<Q<11, 6>>,
    /// Half an LSB.
    half: Constant<Q<11, 6>>,
}

impl Default for Modulate {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            go: Default::default(),
            colour: Default::default(),
            texel: Default::default(),
            level: Default::default(),
            colour_1: Default::default(),
            colour_2: Default::default(),
            colour_3: Default::default(),
            colour_4: Default::default(),
            colour_5: Default::default(),
            product_6: Default::default(),
            colour_bits: Default::default(),
            colour_number: Default::default(),
            product: Default::default(),
            half: Constant::new(Q::from_code(HALF)),
        }
    }
}

/// Half an LSB in units of 2⁻⁶.
const HALF: i64 = 1 << 5;

impl Logic for Modulate {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name modulate");
        comment!("title A shaded colour times its texel.");
        comment!("equation level = colour * texel + 1/2, rounded down");
        comment!(
            "source Modulation of fixed-function hardware: the texel multiplies the whole colour."
        );
        comment!("latency Six clocks from colour, one from texel.");
        dff_setup!(self, clock, colour_1, colour_2, colour_3, colour_4, colour_5, product_6);
        self.colour_bits.next = self.colour_5.q.val().get_bits::<18>(0);
        self.colour_number.next = signed_cast_bits::<11, 6, 18>(self.colour_bits.val());
        self.product.next =
            signed_cast_product::<11, 6>(self.colour_number.val() * self.texel.val());
        if self.go.val() {
            self.colour_1.d.next = self.colour.val();
            self.colour_2.d.next = self.colour_1.q.val();
            self.colour_3.d.next = self.colour_2.q.val();
            self.colour_4.d.next = self.colour_3.q.val();
            self.colour_5.d.next = self.colour_4.q.val();
            self.product_6.d.next = self.product.val() + self.half.val();
        }
        self.level.next = signed_cast_align::<11, 0, 11, 6>(self.product_6.q.val());
    }
}

crate::clocked!(Modulate;
    inputs go, colour, texel;
    outputs level);

/// What [`Modulate`] makes of a colour in units of 2⁻⁶ and a texel in units of 2⁻⁹.
#[must_use]
pub fn modulate_model(colour: i64, texel: i64) -> i64 {
    crate::format::wrap(((colour * texel) >> 17) + HALF, 18) >> 6
}
