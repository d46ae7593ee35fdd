//! A highlight κ(ε − γ)^d without power and without table, for d = 2, 3 and 4 (Hast 2004, 3.276; paper XI).
//!
//! With the place in the lobe t = (1 − ε)/(1 − γ) it is (1 − t)^d for t < 1, else 0; see [`super`] for the bounds. Two
//! multipliers serve all three degrees: the square, and the square times the rest or times itself. A pixel at or beyond γ
//! says so (`skip`), and so does every pixel of a triangle that has no highlight (`off`): then the square holds still
//! and the highlight is zero.

use crate::format::{bit_cast_product, bit_cast_u, signed_cast_bits, Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Clocks from the place to the highlight.
pub const STAGES: usize = 3;

/// Latency: three clocks.
#[derive(LogicBlock, Default)]
pub struct Highlight {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Degree d: 2, 3 or 4; holds still while pixels are on their way.
    pub degree: Signal<In, U<3>>,
    /// Place in the lobe, in units of 2^-19, less half of 2^-17.
    pub place: Signal<In, Q<29, 0>>,
    /// The triangle has no highlight here.
    pub off: Signal<In, Bit>,
    /// The highlight of three clocks ago.
    pub highlight: Signal<Out, Q<0, 17>>,
    /// There is none: the pixel lies beyond the edge of the lobe.
    pub skip: Signal<Out, Bit>,
    /// 1 - t, limited.
    rest_1: Register<U<17>>,
    /// Nothing of the highlight is left.
    skip_1: Register<Bit>,
    /// 1 - t.
    rest_2: Register<U<17>>,
    /// Its square.
    square_2: Register<U<17>>,
    /// Nothing of the highlight is left.
    skip_2: Register<Bit>,
    /// The highlight.
    value_3: Register<U<17>>,
    /// Nothing of the highlight is left.
    skip_3: Register<Bit>,
    /// Integer bits of the place.
    beyond: Wire<U<10>>,
    /// The place with the fraction bits that are used, limited.
    inner: Wire<U<17>>,
    /// 1 - t squared, whole.
    square: Wire<U<34>>,
    /// The square is the highlight.
    is_square: Wire<Bit>,
    /// The square is squared again.
    is_fourth: Wire<Bit>,
    /// What the square is multiplied by.
    factor: Wire<U<17>>,
    /// Cube or fourth power, whole.
    product: Wire<U<34>>,
    /// The highlight with a sign bit.
    value_bits: Wire<U<18>>,
}

impl Logic for Highlight {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name highlight");
        comment!("title Highlight as a shifted low power of the cosine, with its skip.");
        comment!("equation highlight = (1 - t)^d, t = (1 - N.H) / (1 - gamma); 1 for t < 0, 0 and skip for t >= 1 or off");
        comment!("source Hast 2004, equation 3.276: kappa (e - gamma)^d, kappa = 1 / (1 - gamma)^d; the test is needed for even d too.");
        comment!("latency Three clocks from place to highlight; one highlight per clock.");
        dff_setup!(self, clock, rest_1, skip_1, rest_2, square_2, skip_2, value_3, skip_3);
        self.beyond.next = self.place.val().get_bits::<10>(19);
        self.inner.next = self.place.val().get_bits::<17>(2);
        if self.place.val().get_bit(29) {
            self.inner.next = 0u64.into();
        }
        self.square.next = bit_cast_product::<34>(self.rest_1.q.val() * self.rest_1.q.val());
        self.is_square.next = self.degree.val() == 2u64.into();
        self.is_fourth.next = self.degree.val() == 4u64.into();
        self.factor.next = self.rest_2.q.val();
        if self.is_fourth.val() {
            self.factor.next = self.square_2.q.val();
        }
        self.product.next = bit_cast_product::<34>(self.square_2.q.val() * self.factor.val());
        if self.go.val() {
            self.rest_1.d.next = !self.inner.val();
            self.skip_1.d.next = self.beyond.val().any() || self.off.val();
            if self.place.val().get_bit(29) {
                self.skip_1.d.next = self.off.val();
            }
            self.skip_2.d.next = self.skip_1.q.val();
            if !self.skip_1.q.val() {
                self.rest_2.d.next = self.rest_1.q.val();
                self.square_2.d.next = self.square.val().get_bits::<17>(17);
            }
            self.skip_3.d.next = self.skip_2.q.val();
            self.value_3.d.next = self.product.val().get_bits::<17>(17);
            if self.is_square.val() {
                self.value_3.d.next = self.square_2.q.val();
            }
            if self.skip_2.q.val() {
                self.value_3.d.next = 0u64.into();
            }
        }
        self.value_bits.next = bit_cast_u::<18, 17>(self.value_3.q.val());
        self.highlight.next = signed_cast_bits::<0, 17, 18>(self.value_bits.val());
        self.skip.next = self.skip_3.q.val();
    }
}

crate::clocked!(Highlight;
    inputs go, degree, place, off;
    outputs highlight, skip);
