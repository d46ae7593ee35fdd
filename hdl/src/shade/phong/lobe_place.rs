//! From the cosines of a pixel to what the reflection model takes: N·L in its unit, and the place in the lobe.
//!
//! t = (1 − N·H)·2^s ([`super::power`]); s belongs to the material. Both are cut to their units, 2^−16 and 2^−19, which adds
//! half a unit to the bounds of [`super`].

use crate::format::{bit_cast_u, signed_cast_bits, Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Latency: one clock.
#[derive(LogicBlock)]
pub struct LobePlace {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// N.L, in units of 2^-28.
    pub light_cosine: Signal<In, Q<31, 0>>,
    /// N.H, in units of 2^-28.
    pub half_cosine: Signal<In, Q<31, 0>>,
    /// s.
    pub scale: Signal<In, U<3>>,
    /// N.L, in units of 2^-16.
    pub light: Signal<Out, Q<18, 0>>,
    /// Place in the lobe, in units of 2^-19.
    pub place: Signal<Out, Q<29, 0>>,
    /// N.L.
    light_1: Register<U<19>>,
    /// Place in the lobe.
    place_1: Register<U<30>>,
    /// 1 - N.H.
    off: Wire<Q<31, 0>>,
    /// The same without its sign.
    off_bits: Wire<U<31>>,
    /// The same, wide enough to be scaled.
    off_wide: Wire<U<39>>,
    /// The same, scaled.
    scaled: Wire<U<39>>,
    /// 1 in units of 2^-28.
    one: Constant<Q<31, 0>>,
}

impl Default for LobePlace {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            go: Default::default(),
            light_cosine: Default::default(),
            half_cosine: Default::default(),
            scale: Default::default(),
            light: Default::default(),
            place: Default::default(),
            light_1: Default::default(),
            place_1: Default::default(),
            off: Default::default(),
            off_bits: Default::default(),
            off_wide: Default::default(),
            scaled: Default::default(),
            one: Constant::new(Q::from_code(1 << 28)),
        }
    }
}

impl Logic for LobePlace {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name lobe_place");
        comment!("title N.L and the place in the lobe, from two cosines.");
        comment!("equation place = (1 - N.H) 2^s, 0 for N.H > 1");
        comment!("source The argument of the power table.");
        comment!("latency One clock.");
        dff_setup!(self, clock, light_1, place_1);
        self.off.next = self.one.val() - self.half_cosine.val();
        self.off_bits.next = self.off.val().get_bits::<31>(0);
        self.off_wide.next = bit_cast_u::<39, 31>(self.off_bits.val());
        self.scaled.next = self.off_wide.val() << self.scale.val();
        if self.go.val() {
            self.light_1.d.next = self.light_cosine.val().get_bits::<19>(12);
            self.place_1.d.next = self.scaled.val().get_bits::<30>(9);
            if self.off.val().get_bit(31) {
                self.place_1.d.next = 0u64.into();
            }
        }
        self.light.next = signed_cast_bits::<18, 0, 19>(self.light_1.q.val());
        self.place.next = signed_cast_bits::<29, 0, 30>(self.place_1.q.val());
    }
}

crate::clocked!(LobePlace;
    inputs go, light_cosine, half_cosine, scale;
    outputs light, place);
