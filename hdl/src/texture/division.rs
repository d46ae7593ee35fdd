//! The perspective division: u = (u/z)/(1/z), v likewise, one reciprocal and two products per pixel.
//!
//! Two stages bring w = 1/z between 1/2 and 1 ([`super::shift`]), three take the reciprocal ([`super::reciprocal`]), one
//! multiplies. With r = 1/m, m = 2·w·2^s, u is 2·(u·w·2^s)·r; the product, modulo 1024 texels, is cut to twelve fraction
//! bits. r is off by less than 2⁻²¹, so u by less than 2⁻²⁰·abs(u), and 2⁻¹² for what [`super::shift`] cuts.
//! Source: Zed3D 1996, "Texture mapping using 1/z", p = (p/z)/(1/z).

use super::reciprocal::Reciprocal;
use super::shift::Shift;
use crate::format::{signed_cast_bits, signed_cast_product, Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Latency: six clocks.
#[derive(LogicBlock, Default)]
pub struct Division {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// u w, in units of 2^-28.
    pub u: Signal<In, Q<38, 0>>,
    /// v w, likewise.
    pub v: Signal<In, Q<38, 0>>,
    /// w, in units of 2^-39.
    pub w: Signal<In, Q<40, 0>>,
    /// u modulo 1024 of six clocks ago, in units of 2^-12 texel.
    pub late_u: Signal<Out, Q<21, 0>>,
    /// v likewise.
    pub late_v: Signal<Out, Q<21, 0>>,
    /// u w 2^s, doubled, stage 3.
    u_3: Register<Q<11, 12>>,
    /// v w 2^s, doubled.
    v_3: Register<Q<11, 12>>,
    /// The same, stage 4.
    u_4: Register<Q<11, 12>>,
    /// v w 2^s, doubled.
    v_4: Register<Q<11, 12>>,
    /// The same, stage 5.
    u_5: Register<Q<11, 12>>,
    /// v w 2^s, doubled.
    v_5: Register<Q<11, 12>>,
    /// u.
    u_6: Register<Q<9, 12>>,
    /// v.
    v_6: Register<Q<9, 12>>,
    /// u as bits.
    u_bits: Wire<U<22>>,
    /// v as bits.
    v_bits: Wire<U<22>>,
    /// Normalisation.
    shift: Quiet<Shift>,
    /// One over m.
    inverse: Quiet<Reciprocal>,
}

impl Logic for Division {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name division");
        comment!("title Perspective division of a texture address.");
        comment!("equation late_u = u / w, late_v = v / w, modulo 1024 texels");
        comment!("source Zed3D 1996, texture mapping using 1/z.");
        comment!("latency Six clocks; one address per clock.");
        dff_setup!(self, clock, u_3, v_3, u_4, v_4, u_5, v_5, u_6, v_6);
        self.shift.clock.next = self.clock.val();
        self.shift.go.next = self.go.val();
        self.shift.u.next = self.u.val();
        self.shift.v.next = self.v.val();
        self.shift.w.next = self.w.val();
        self.inverse.clock.next = self.clock.val();
        self.inverse.go.next = self.go.val();
        self.inverse.m.next = self.shift.m.val();
        if self.go.val() {
            self.u_3.d.next = self.shift.late_u.val();
            self.v_3.d.next = self.shift.late_v.val();
            self.u_4.d.next = self.u_3.q.val();
            self.v_4.d.next = self.v_3.q.val();
            self.u_5.d.next = self.u_4.q.val();
            self.v_5.d.next = self.v_4.q.val();
            self.u_6.d.next =
                signed_cast_product::<9, 12>(self.u_5.q.val() * self.inverse.reciprocal.val());
            self.v_6.d.next =
                signed_cast_product::<9, 12>(self.v_5.q.val() * self.inverse.reciprocal.val());
        }
        self.u_bits.next = self.u_6.q.val().get_bits::<22>(0);
        self.v_bits.next = self.v_6.q.val().get_bits::<22>(0);
        self.late_u.next = signed_cast_bits::<21, 0, 22>(self.u_bits.val());
        self.late_v.next = signed_cast_bits::<21, 0, 22>(self.v_bits.val());
    }
}

crate::clocked!(Division;
    inputs go, u, v, w;
    outputs late_u, late_v);

/// What [`Division`] makes of u·w and v·w in units of 2⁻²⁸ and w in units of 2⁻³⁹: u and v in units of 2⁻¹² texel.
#[must_use]
pub fn division_model(u: i64, v: i64, w: i64) -> [i64; 2] {
    let (products, m) = super::shift::shift_model(u, v, w);
    let r = super::reciprocal::reciprocal_model(m) as i64;
    products.map(|p| crate::format::wrap((p * r) >> 21, 22))
}
