//! u·w, v·w and w times the power of two that brings w between 1/2 and 1, so that the division sees 24 good bits.
//!
//! 2^s with s of 0..=15, found and done bit by bit: by 8 and 4 in the first stage, by 2 and 1 in the second. The same
//! shifts go to all three, so quotients stay as they are. The host keeps w between 2⁻¹⁵ and 1, where abs(u) < 1024, so
//! u·w·2^s stays below 1024 as well and no bit is lost at the top; below, it is cut to 13 fraction bits, which moves u by
//! less than 2⁻¹² texel.

use crate::format::{signed_cast_bits, Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Clocks.
pub const STAGES: usize = 2;

/// Latency: two clocks.
#[derive(LogicBlock, Default)]
pub struct Shift {
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
    /// u w 2^s of two clocks ago, doubled.
    pub late_u: Signal<Out, Q<11, 12>>,
    /// v w 2^s, doubled.
    pub late_v: Signal<Out, Q<11, 12>>,
    /// w 2^s, doubled, in units of 2^-24: 1 to 2.
    pub m: Signal<Out, U<25>>,
    /// u w after the first shifts.
    u_1: Register<U<39>>,
    /// v w after them.
    v_1: Register<U<39>>,
    /// w after them.
    w_1: Register<U<39>>,
    /// u w after all shifts, in units of 2^-13.
    u_2: Register<U<24>>,
    /// v w after all shifts.
    v_2: Register<U<24>>,
    /// w after all shifts, in units of 2^-25.
    w_2: Register<U<25>>,
    /// u w as bits.
    u_bits: Wire<U<39>>,
    /// v w as bits.
    v_bits: Wire<U<39>>,
    /// w as bits.
    w_bits: Wire<U<39>>,
    /// The eight highest bits of w.
    high_8: Wire<U<8>>,
    /// u w, shifted by 8 if w has eight zeros.
    u_8: Wire<U<39>>,
    /// v w likewise.
    v_8: Wire<U<39>>,
    /// w likewise.
    w_8: Wire<U<39>>,
    /// The four highest bits of w then.
    high_4: Wire<U<4>>,
    /// u w, shifted by 4 if w has four zeros then.
    u_4: Wire<U<39>>,
    /// v w likewise.
    v_4: Wire<U<39>>,
    /// w likewise.
    w_4: Wire<U<39>>,
    /// The two highest bits of w then.
    high_2: Wire<U<2>>,
    /// u w, shifted by 2 if w has two zeros then.
    u_shift_2: Wire<U<39>>,
    /// v w likewise.
    v_shift_2: Wire<U<39>>,
    /// w likewise.
    w_shift_2: Wire<U<39>>,
    /// u w, shifted by 1 if w has a zero then.
    u_shift_1: Wire<U<39>>,
    /// v w likewise.
    v_shift_1: Wire<U<39>>,
    /// w likewise.
    w_shift_1: Wire<U<39>>,
}

impl Logic for Shift {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name shift");
        comment!(
            "title Brings 1/z between 1/2 and 1 for its reciprocal; u/z and v/z are shifted along."
        );
        comment!("equation m = 2 w 2^s, 1 <= m < 2; u and v likewise");
        comment!("source Normalisation of a fixed-point divisor.");
        comment!("latency Two clocks.");
        dff_setup!(self, clock, u_1, v_1, w_1, u_2, v_2, w_2);
        self.u_bits.next = self.u.val().get_bits::<39>(0);
        self.v_bits.next = self.v.val().get_bits::<39>(0);
        self.w_bits.next = self.w.val().get_bits::<39>(0);

        self.high_8.next = self.w_bits.val().get_bits::<8>(31);
        self.u_8.next = self.u_bits.val();
        self.v_8.next = self.v_bits.val();
        self.w_8.next = self.w_bits.val();
        if !self.high_8.val().any() {
            self.u_8.next = self.u_bits.val() << 8u64;
            self.v_8.next = self.v_bits.val() << 8u64;
            self.w_8.next = self.w_bits.val() << 8u64;
        }
        self.high_4.next = self.w_8.val().get_bits::<4>(35);
        self.u_4.next = self.u_8.val();
        self.v_4.next = self.v_8.val();
        self.w_4.next = self.w_8.val();
        if !self.high_4.val().any() {
            self.u_4.next = self.u_8.val() << 4u64;
            self.v_4.next = self.v_8.val() << 4u64;
            self.w_4.next = self.w_8.val() << 4u64;
        }

        self.high_2.next = self.w_1.q.val().get_bits::<2>(37);
        self.u_shift_2.next = self.u_1.q.val();
        self.v_shift_2.next = self.v_1.q.val();
        self.w_shift_2.next = self.w_1.q.val();
        if !self.high_2.val().any() {
            self.u_shift_2.next = self.u_1.q.val() << 2u64;
            self.v_shift_2.next = self.v_1.q.val() << 2u64;
            self.w_shift_2.next = self.w_1.q.val() << 2u64;
        }
        self.u_shift_1.next = self.u_shift_2.val();
        self.v_shift_1.next = self.v_shift_2.val();
        self.w_shift_1.next = self.w_shift_2.val();
        if !self.w_shift_2.val().get_bit(38) {
            self.u_shift_1.next = self.u_shift_2.val() << 1u64;
            self.v_shift_1.next = self.v_shift_2.val() << 1u64;
            self.w_shift_1.next = self.w_shift_2.val() << 1u64;
        }

        if self.go.val() {
            self.u_1.d.next = self.u_4.val();
            self.v_1.d.next = self.v_4.val();
            self.w_1.d.next = self.w_4.val();
            self.u_2.d.next = self.u_shift_1.val().get_bits::<24>(15);
            self.v_2.d.next = self.v_shift_1.val().get_bits::<24>(15);
            self.w_2.d.next = self.w_shift_1.val().get_bits::<25>(14);
        }
        self.late_u.next = signed_cast_bits::<11, 12, 24>(self.u_2.q.val());
        self.late_v.next = signed_cast_bits::<11, 12, 24>(self.v_2.q.val());
        self.m.next = self.w_2.q.val();
    }
}

crate::clocked!(Shift;
    inputs go, u, v, w;
    outputs late_u, late_v, m);

/// What [`Shift`] makes of u·w, v·w and w: twice the shifted products in units of 2⁻¹², and m in units of 2⁻²⁴.
#[must_use]
pub fn shift_model(u: i64, v: i64, w: i64) -> ([i64; 2], u64) {
    use crate::format::{mask, wrap};
    let mut words = [u, v, w].map(|x| x as u64 & mask(39));
    for by in [8, 4, 2, 1] {
        if words[2] >> (39 - by) == 0 {
            words = words.map(|x| x << by & mask(39));
        }
    }
    let [u, v, w] = words;
    ([u, v].map(|x| wrap((x >> 15) as i64, 24)), w >> 14)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_power_of_two_comes_to_the_top() {
        for s in 0..=15 {
            let w = 0x55_5555_5555i64 >> s;
            let ([u, v], m) = shift_model(w >> 1, -(w >> 1), w);
            assert_eq!(m >> 24, 1, "{s}");
            let back = (0x55_5555_5555i64 >> s >> 1) << s >> 15;
            assert!((u - back).abs() <= 1 && (u + v).abs() <= 1, "{s}: {u} {v}");
        }
        assert_eq!(shift_model(1, -1, 1), ([1, -1], 2), "shifts by 15 at most");
    }
}
