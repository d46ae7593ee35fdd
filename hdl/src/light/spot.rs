//! How much of its light a spot sends beside its axis: soft and hard quadratics (Hast 2004, 3.273 and 3.274; paper X).
//!
//! With the place in the cone v = (1 − e)/(1 − g), e being the cosine from the axis and g that of the edge,
//!
//!   soft: D = (e − g)²/(1 − g)² = (1 − v)²,   hard: D = 1 − (e − 1)²/(g − 1)² = 1 − v²   for v < 1, else 0.
//!
//! One multiplier serves both. A pixel at or outside the edge says so (`out`), and so does every pixel of a triangle that
//! the cone does not reach (`off`): then the square holds still and the light is zero.

use crate::format::{bit_cast_product, Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Clocks from the place to the light.
pub const STAGES: usize = 3;

/// Latency: three clocks.
#[derive(LogicBlock, Default)]
pub struct Spot {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Hard fall-off instead of the soft one; holds still while pixels are on their way.
    pub hard: Signal<In, Bit>,
    /// Place in the cone, in units of 2^-19; less half of 2^-17 for the soft fall-off, plus as much for the hard one.
    pub place: Signal<In, Q<29, 0>>,
    /// The cone does not reach the triangle.
    pub off: Signal<In, Bit>,
    /// Light of three clocks ago, in units of 2^-17.
    pub light: Signal<Out, U<17>>,
    /// There is none: the pixel lies outside the cone.
    pub out: Signal<Out, Bit>,
    /// v for the hard fall-off, 1 - v for the soft one, limited.
    base_1: Register<U<17>>,
    /// Outside the cone.
    out_1: Register<Bit>,
    /// Its square.
    square_2: Register<U<17>>,
    /// Outside the cone.
    out_2: Register<Bit>,
    /// The light.
    light_3: Register<U<17>>,
    /// Outside the cone.
    out_3: Register<Bit>,
    /// Integer bits of the place.
    beyond: Wire<U<10>>,
    /// The place with the fraction bits that are used, limited.
    inner: Wire<U<17>>,
    /// Square of the base, whole.
    square: Wire<U<34>>,
}

impl Logic for Spot {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name spot");
        comment!("title Light of a spot beside its axis, with its skip.");
        comment!("equation light = hard ? 1 - v^2 : (1 - v)^2, v = (1 - e) / (1 - g); 1 for v < 0, 0 and out for v >= 1 or off");
        comment!("source Hast 2004, equations 3.273 (soft) and 3.274 (hard); e is the cosine from the axis, g that of the edge.");
        comment!("latency Three clocks from place to light; one light per clock.");
        dff_setup!(self, clock, base_1, out_1, square_2, out_2, light_3, out_3);
        self.beyond.next = self.place.val().get_bits::<10>(19);
        self.inner.next = self.place.val().get_bits::<17>(2);
        if self.place.val().get_bit(29) {
            self.inner.next = 0u64.into();
        }
        self.square.next = bit_cast_product::<34>(self.base_1.q.val() * self.base_1.q.val());
        if self.go.val() {
            self.base_1.d.next = !self.inner.val();
            if self.hard.val() {
                self.base_1.d.next = self.inner.val();
            }
            self.out_1.d.next = self.beyond.val().any() || self.off.val();
            if self.place.val().get_bit(29) {
                self.out_1.d.next = self.off.val();
            }
            self.out_2.d.next = self.out_1.q.val();
            if !self.out_1.q.val() {
                self.square_2.d.next = self.square.val().get_bits::<17>(17);
            }
            self.out_3.d.next = self.out_2.q.val();
            self.light_3.d.next = self.square_2.q.val();
            if self.hard.val() {
                self.light_3.d.next = !self.square_2.q.val();
            }
            if self.out_2.q.val() {
                self.light_3.d.next = 0u64.into();
            }
        }
        self.light.next = self.light_3.q.val();
        self.out.next = self.out_3.q.val();
    }
}

crate::clocked!(Spot;
    inputs go, hard, place, off;
    outputs light, out);
