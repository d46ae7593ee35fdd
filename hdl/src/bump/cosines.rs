//! From a bump's normal to what the reflection model takes: N·L and the place in the lobe, for light and half-way vector in
//! the frame of the surface. The normal is (−F_u, −F_v, 1) times its factors.

use super::dot::BumpDot;
use crate::format::{signed_cast_align, signed_cast_bits, Q, U};
use crate::shade::phong::lobe_place::LobePlace;
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Clocks from the factors to the arguments of the reflection model.
pub const STAGES: usize = super::dot::STAGES + 1;

/// Latency: four clocks.
#[derive(LogicBlock, Default)]
pub struct BumpCosines {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Writes the scale, whether the stages move or not.
    pub write_scale: Signal<In, Bit>,
    /// Scale s of the lobe.
    pub scale: Signal<In, U<3>>,
    /// F_u.
    pub slope_u: Signal<In, Q<1, 16>>,
    /// F_v.
    pub slope_v: Signal<In, Q<1, 16>>,
    /// Factor of the parts across the surface.
    pub across: Signal<In, Q<1, 16>>,
    /// Part along its normal.
    pub along: Signal<In, Q<1, 16>>,
    /// Light along the first tangent, in units of 2^-16.
    pub light_u: Signal<In, Q<17, 0>>,
    /// Light along the second tangent, in units of 2^-16.
    pub light_v: Signal<In, Q<17, 0>>,
    /// Light along the normal, in units of 2^-16.
    pub light_n: Signal<In, Q<17, 0>>,
    /// Half-way vector along the first tangent, in units of 2^-16.
    pub half_u: Signal<In, Q<17, 0>>,
    /// Half-way vector along the second tangent, in units of 2^-16.
    pub half_v: Signal<In, Q<17, 0>>,
    /// Half-way vector along the normal, in units of 2^-16.
    pub half_n: Signal<In, Q<17, 0>>,
    /// N.L of four clocks ago, in units of 2^-16.
    pub light: Signal<Out, Q<18, 0>>,
    /// Its place in the lobe, in units of 2^-19.
    pub place: Signal<Out, Q<29, 0>>,
    /// Scale s of the lobe.
    held_scale: Register<U<3>>,
    /// Light along the first tangent as bits.
    light_u_bits: Wire<U<18>>,
    /// Light along the second tangent as bits.
    light_v_bits: Wire<U<18>>,
    /// Light along the normal as bits.
    light_n_bits: Wire<U<18>>,
    /// Half-way vector along the first tangent as bits.
    half_u_bits: Wire<U<18>>,
    /// Half-way vector along the second tangent as bits.
    half_v_bits: Wire<U<18>>,
    /// Half-way vector along the normal as bits.
    half_n_bits: Wire<U<18>>,
    /// N.L with more fraction bits.
    light_fine: Wire<Q<19, 12>>,
    /// The same as bits.
    light_fine_bits: Wire<U<32>>,
    /// N.H with more fraction bits.
    half_fine: Wire<Q<19, 12>>,
    /// The same as bits.
    half_fine_bits: Wire<U<32>>,
    /// N.L.
    light_dot: Quiet<BumpDot>,
    /// N.H.
    half_dot: Quiet<BumpDot>,
    /// Arguments of the reflection model.
    arguments: Quiet<LobePlace>,
}

impl Logic for BumpCosines {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name bump_cosines");
        comment!("title N.L and the place in the lobe for the normal of a bump.");
        comment!(
            "equation light = N.L; place = (1 - N.H) 2^s; N = (-F_u across, -F_v across, along)"
        );
        comment!("source Hast 2004, section 2.3, with the place of the power table.");
        comment!("latency Four clocks; one pair per clock.");
        dff_setup!(self, clock, held_scale);
        if self.write_scale.val() {
            self.held_scale.d.next = self.scale.val();
        }
        self.light_u_bits.next = self.light_u.val().get_bits::<18>(0);
        self.light_v_bits.next = self.light_v.val().get_bits::<18>(0);
        self.light_n_bits.next = self.light_n.val().get_bits::<18>(0);
        self.half_u_bits.next = self.half_u.val().get_bits::<18>(0);
        self.half_v_bits.next = self.half_v.val().get_bits::<18>(0);
        self.half_n_bits.next = self.half_n.val().get_bits::<18>(0);

        self.light_dot.clock.next = self.clock.val();
        self.light_dot.go.next = self.go.val();
        self.light_dot.slope_u.next = self.slope_u.val();
        self.light_dot.slope_v.next = self.slope_v.val();
        self.light_dot.across.next = self.across.val();
        self.light_dot.along.next = self.along.val();
        self.light_dot.light_u.next = signed_cast_bits::<1, 16, 18>(self.light_u_bits.val());
        self.light_dot.light_v.next = signed_cast_bits::<1, 16, 18>(self.light_v_bits.val());
        self.light_dot.light_n.next = signed_cast_bits::<1, 16, 18>(self.light_n_bits.val());
        self.light_fine.next = signed_cast_align::<19, 12, 18, 0>(self.light_dot.cosine.val());
        self.light_fine_bits.next = self.light_fine.val().get_bits::<32>(0);

        self.half_dot.clock.next = self.clock.val();
        self.half_dot.go.next = self.go.val();
        self.half_dot.slope_u.next = self.slope_u.val();
        self.half_dot.slope_v.next = self.slope_v.val();
        self.half_dot.across.next = self.across.val();
        self.half_dot.along.next = self.along.val();
        self.half_dot.light_u.next = signed_cast_bits::<1, 16, 18>(self.half_u_bits.val());
        self.half_dot.light_v.next = signed_cast_bits::<1, 16, 18>(self.half_v_bits.val());
        self.half_dot.light_n.next = signed_cast_bits::<1, 16, 18>(self.half_n_bits.val());
        self.half_fine.next = signed_cast_align::<19, 12, 18, 0>(self.half_dot.cosine.val());
        self.half_fine_bits.next = self.half_fine.val().get_bits::<32>(0);

        self.arguments.clock.next = self.clock.val();
        self.arguments.go.next = self.go.val();
        self.arguments.light_cosine.next =
            signed_cast_bits::<31, 0, 32>(self.light_fine_bits.val());
        self.arguments.half_cosine.next = signed_cast_bits::<31, 0, 32>(self.half_fine_bits.val());
        self.arguments.scale.next = self.held_scale.q.val();
        self.light.next = self.arguments.light.val();
        self.place.next = self.arguments.place.val();
    }
}

crate::clocked!(BumpCosines;
    inputs go, write_scale, scale, slope_u, slope_v, across, along, light_u, light_v, light_n, half_u, half_v, half_n;
    outputs light, place);
