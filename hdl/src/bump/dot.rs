//! The cosine of a bump's normal with the light, or with the half-way vector: the vector comes turned into the frame of the
//! surface, so that the normal is (−F_u, −F_v, 1) times its factors (Hast 2004, section 2.3).
//!
//! Parts of unit vectors are at most 1, gradients below 2: slants below 4, and with the length of the vector 1 their sum
//! below √8. A cosine of normalised vectors is at most 1; with factors of other gradients than theirs it may reach 4,
//! which the 3 integer bits hold and the 19 bits of the output, ±4, do.

use crate::format::{signed_cast_bits, signed_cast_product, Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Clocks from the factors to the cosine.
pub const STAGES: usize = 3;

/// Latency: three clocks.
#[derive(LogicBlock, Default)]
pub struct BumpDot {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// F_u.
    pub slope_u: Signal<In, Q<1, 16>>,
    /// F_v.
    pub slope_v: Signal<In, Q<1, 16>>,
    /// Factor of the parts across the surface.
    pub across: Signal<In, Q<1, 16>>,
    /// Part along its normal.
    pub along: Signal<In, Q<1, 16>>,
    /// Light along the first tangent.
    pub light_u: Signal<In, Q<1, 16>>,
    /// Light along the second tangent.
    pub light_v: Signal<In, Q<1, 16>>,
    /// Light along the normal.
    pub light_n: Signal<In, Q<1, 16>>,
    /// Cosine of three clocks ago, in units of 2^-16.
    pub cosine: Signal<Out, Q<18, 0>>,
    /// F_u times light.
    slant_u_1: Register<Q<3, 18>>,
    /// F_v times light.
    slant_v_1: Register<Q<3, 18>>,
    /// Part along the normal times light.
    straight_1: Register<Q<3, 18>>,
    /// Factor across.
    across_1: Register<Q<1, 16>>,
    /// Both slants.
    slant_2: Register<Q<3, 18>>,
    /// Part along the normal times light.
    straight_2: Register<Q<3, 18>>,
    /// Factor across.
    across_2: Register<Q<1, 16>>,
    /// The cosine.
    cosine_3: Register<Q<3, 18>>,
    /// Slants times factor.
    bent: Wire<Q<3, 18>>,
    /// The cosine in units of 2^-16.
    code: Wire<U<20>>,
    /// The same, as wide as N.L.
    low: Wire<U<19>>,
}

impl Logic for BumpDot {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name bump_dot");
        comment!("title Cosine between a bump's normal and a light that is turned into the frame of the surface.");
        comment!("equation cosine = along light_n - across (F_u light_u + F_v light_v)");
        comment!("source Hast 2004, section 2.3: I_d = n_B.l', the light in the moving frame.");
        comment!("latency Three clocks from factors and light to cosine; one cosine per clock.");
        dff_setup!(
            self, clock, slant_u_1, slant_v_1, straight_1, across_1, slant_2, straight_2, across_2,
            cosine_3
        );
        self.bent.next = signed_cast_product::<3, 18>(self.slant_2.q.val() * self.across_2.q.val());
        if self.go.val() {
            self.slant_u_1.d.next =
                signed_cast_product::<3, 18>(self.slope_u.val() * self.light_u.val());
            self.slant_v_1.d.next =
                signed_cast_product::<3, 18>(self.slope_v.val() * self.light_v.val());
            self.straight_1.d.next =
                signed_cast_product::<3, 18>(self.along.val() * self.light_n.val());
            self.across_1.d.next = self.across.val();
            self.slant_2.d.next = self.slant_u_1.q.val() + self.slant_v_1.q.val();
            self.straight_2.d.next = self.straight_1.q.val();
            self.across_2.d.next = self.across_1.q.val();
            self.cosine_3.d.next = self.straight_2.q.val() - self.bent.val();
        }
        self.code.next = self.cosine_3.q.val().get_bits::<20>(2);
        self.low.next = self.code.val().get_bits::<19>(0);
        self.cosine.next = signed_cast_bits::<18, 0, 19>(self.low.val());
    }
}

crate::clocked!(BumpDot;
    inputs go, slope_u, slope_v, across, along, light_u, light_v, light_n;
    outputs cosine);
