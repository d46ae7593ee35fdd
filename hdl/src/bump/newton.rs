//! Factors of a bump's normal by one Newton step towards the reciprocal square root: no table, no division.
//!
//! 1/√(1 + g²) ≈ 1 − g²/2, so the normal is (−F_u, −F_v, 1)·k with k = 1 − min(g², 2)/2 (Hast 2004, 3.271; the general step
//! is 3.270). True in direction, short by at most 3g⁴/8; from g² = 2 on the formula would turn it around.

use crate::format::{bit_cast_u, signed_cast_bits, signed_cast_product, Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Clocks from the gradient to the factor.
pub const STAGES: usize = 2;

/// Latency: two clocks.
#[derive(LogicBlock)]
pub struct BumpNewton {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// F_u.
    pub slope_u: Signal<In, Q<1, 16>>,
    /// F_v.
    pub slope_v: Signal<In, Q<1, 16>>,
    /// Factor of all parts of the normal of two clocks ago.
    pub factor: Signal<Out, Q<1, 16>>,
    /// F_u of two clocks ago.
    pub late_u: Signal<Out, Q<1, 16>>,
    /// F_v of two clocks ago.
    pub late_v: Signal<Out, Q<1, 16>>,
    /// F_u squared.
    square_u_1: Register<Q<3, 22>>,
    /// F_v squared.
    square_v_1: Register<Q<3, 22>>,
    /// F_u.
    slope_u_1: Register<Q<1, 16>>,
    /// F_v.
    slope_v_1: Register<Q<1, 16>>,
    /// The factor.
    factor_2: Register<U<17>>,
    /// F_u.
    slope_u_2: Register<Q<1, 16>>,
    /// F_v.
    slope_v_2: Register<Q<1, 16>>,
    /// Squared gradient.
    sum: Wire<Q<3, 22>>,
    /// Bits of it at and above 2.
    steep: Wire<U<3>>,
    /// Half of it, fraction bits of the factor.
    half: Wire<U<17>>,
    /// The factor with a sign bit.
    factor_bits: Wire<U<18>>,
    /// 1 in units of 2^-16.
    one: Constant<U<17>>,
}

impl Default for BumpNewton {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            go: Default::default(),
            slope_u: Default::default(),
            slope_v: Default::default(),
            factor: Default::default(),
            late_u: Default::default(),
            late_v: Default::default(),
            square_u_1: Default::default(),
            square_v_1: Default::default(),
            slope_u_1: Default::default(),
            slope_v_1: Default::default(),
            factor_2: Default::default(),
            slope_u_2: Default::default(),
            slope_v_2: Default::default(),
            sum: Default::default(),
            steep: Default::default(),
            half: Default::default(),
            factor_bits: Default::default(),
            one: Constant::new(U::new(1 << 16)),
        }
    }
}

impl Logic for BumpNewton {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name bump_newton");
        comment!("title Factor of a bump's normal by one Newton step.");
        comment!("equation factor = 1 - min(g^2, 2) / 2, g^2 = F_u^2 + F_v^2; normal = factor (-F_u, -F_v, 1)");
        comment!(
            "source Hast 2004, section 3.4.2 and equation 3.270, with the limit that it needs."
        );
        comment!("latency Two clocks from gradient to factor; one factor per clock.");
        dff_setup!(
            self, clock, square_u_1, square_v_1, slope_u_1, slope_v_1, factor_2, slope_u_2,
            slope_v_2
        );
        self.sum.next = self.square_u_1.q.val() + self.square_v_1.q.val();
        self.steep.next = self.sum.val().get_bits::<3>(23);
        self.half.next = self.sum.val().get_bits::<17>(7);
        if self.go.val() {
            self.square_u_1.d.next =
                signed_cast_product::<3, 22>(self.slope_u.val() * self.slope_u.val());
            self.square_v_1.d.next =
                signed_cast_product::<3, 22>(self.slope_v.val() * self.slope_v.val());
            self.slope_u_1.d.next = self.slope_u.val();
            self.slope_v_1.d.next = self.slope_v.val();
            self.factor_2.d.next = self.one.val() - self.half.val();
            if self.steep.val().any() {
                self.factor_2.d.next = 0u64.into();
            }
            self.slope_u_2.d.next = self.slope_u_1.q.val();
            self.slope_v_2.d.next = self.slope_v_1.q.val();
        }
        self.factor_bits.next = bit_cast_u::<18, 17>(self.factor_2.q.val());
        self.factor.next = signed_cast_bits::<1, 16, 18>(self.factor_bits.val());
        self.late_u.next = self.slope_u_2.q.val();
        self.late_v.next = self.slope_v_2.q.val();
    }
}

crate::clocked!(BumpNewton;
    inputs go, slope_u, slope_v;
    outputs factor, late_u, late_v);
