//! The gradient of a height map between its samples, from block RAM: bilinear, which Hast (2004, section 3.4.1) found to
//! compare with the gradients of a Catmull–Rom surface at a fraction of the cost.
//!
//! [`super::banks`] gives four samples per clock, [`super::blend`] what lies between them. The host subtracts half a sample
//! from the place, since samples lie at half-integers.

use super::banks::BumpBanks;
use super::blend::BumpBlend;
use crate::format::{signed_cast_bits, Q, U};
use crate::simulate::{Quiet, Wire};
use rust_hdl_core::prelude::*;

/// Clocks from the place to the gradient.
pub const STAGES: usize = super::banks::STAGES + super::blend::STAGES;

/// Latency: six clocks.
#[derive(LogicBlock, Default)]
pub struct BumpFetch {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Column of the map, less half a sample, 12 fraction bits; the map repeats.
    pub u: Signal<In, U<18>>,
    /// Row, likewise.
    pub v: Signal<In, U<18>>,
    /// Writes a sample, whether the stages move or not.
    pub write: Signal<In, Bit>,
    /// Sample to write: row in bits 11 to 6, column in bits 5 to 0.
    pub write_address: Signal<In, U<12>>,
    /// The sample: F_u in bits 35 to 18, F_v in bits 17 to 0, both in 2^-16.
    pub write_data: Signal<In, U<36>>,
    /// F_u of six clocks ago.
    pub slope_u: Signal<Out, Q<1, 16>>,
    /// F_v of six clocks ago.
    pub slope_v: Signal<Out, Q<1, 16>>,
    /// Upper row, left column.
    upper_left: Wire<U<36>>,
    /// Its F_u as bits.
    upper_left_u: Wire<U<18>>,
    /// Its F_v as bits.
    upper_left_v: Wire<U<18>>,
    /// Upper row, right column.
    upper_right: Wire<U<36>>,
    /// Its F_u as bits.
    upper_right_u: Wire<U<18>>,
    /// Its F_v as bits.
    upper_right_v: Wire<U<18>>,
    /// Lower row, left column.
    lower_left: Wire<U<36>>,
    /// Its F_u as bits.
    lower_left_u: Wire<U<18>>,
    /// Its F_v as bits.
    lower_left_v: Wire<U<18>>,
    /// Lower row, right column.
    lower_right: Wire<U<36>>,
    /// Its F_u as bits.
    lower_right_u: Wire<U<18>>,
    /// Its F_v as bits.
    lower_right_v: Wire<U<18>>,
    /// The samples.
    banks: Quiet<BumpBanks>,
    /// F_u between them.
    blend_u: Quiet<BumpBlend>,
    /// F_v between them.
    blend_v: Quiet<BumpBlend>,
}

impl Logic for BumpFetch {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name bump_fetch");
        comment!("title Gradient of a height map at a place, bilinear between four samples in block RAM.");
        comment!("equation slope = sum of w(u) w(v) sample over the four samples around (u, v)");
        comment!("source Hast 2004, section 3.4.1: linear interpolation of gradients, comparable to Catmull-Rom.");
        comment!("latency Six clocks from place to slope; one slope per clock.");
        self.banks.clock.next = self.clock.val();
        self.banks.go.next = self.go.val();
        self.banks.u.next = self.u.val();
        self.banks.v.next = self.v.val();
        self.banks.write.next = self.write.val();
        self.banks.write_address.next = self.write_address.val();
        self.banks.write_data.next = self.write_data.val();
        self.upper_left.next = self.banks.upper_left.val();
        self.upper_left_u.next = self.upper_left.val().get_bits::<18>(18);
        self.upper_left_v.next = self.upper_left.val().get_bits::<18>(0);
        self.upper_right.next = self.banks.upper_right.val();
        self.upper_right_u.next = self.upper_right.val().get_bits::<18>(18);
        self.upper_right_v.next = self.upper_right.val().get_bits::<18>(0);
        self.lower_left.next = self.banks.lower_left.val();
        self.lower_left_u.next = self.lower_left.val().get_bits::<18>(18);
        self.lower_left_v.next = self.lower_left.val().get_bits::<18>(0);
        self.lower_right.next = self.banks.lower_right.val();
        self.lower_right_u.next = self.lower_right.val().get_bits::<18>(18);
        self.lower_right_v.next = self.lower_right.val().get_bits::<18>(0);

        self.blend_u.clock.next = self.clock.val();
        self.blend_u.go.next = self.go.val();
        self.blend_u.part_u.next = self.banks.part_u.val();
        self.blend_u.part_v.next = self.banks.part_v.val();
        self.blend_u.upper_left.next = signed_cast_bits::<1, 16, 18>(self.upper_left_u.val());
        self.blend_u.upper_right.next = signed_cast_bits::<1, 16, 18>(self.upper_right_u.val());
        self.blend_u.lower_left.next = signed_cast_bits::<1, 16, 18>(self.lower_left_u.val());
        self.blend_u.lower_right.next = signed_cast_bits::<1, 16, 18>(self.lower_right_u.val());

        self.blend_v.clock.next = self.clock.val();
        self.blend_v.go.next = self.go.val();
        self.blend_v.part_u.next = self.banks.part_u.val();
        self.blend_v.part_v.next = self.banks.part_v.val();
        self.blend_v.upper_left.next = signed_cast_bits::<1, 16, 18>(self.upper_left_v.val());
        self.blend_v.upper_right.next = signed_cast_bits::<1, 16, 18>(self.upper_right_v.val());
        self.blend_v.lower_left.next = signed_cast_bits::<1, 16, 18>(self.lower_left_v.val());
        self.blend_v.lower_right.next = signed_cast_bits::<1, 16, 18>(self.lower_right_v.val());

        self.slope_u.next = self.blend_u.slope.val();
        self.slope_v.next = self.blend_v.slope.val();
    }
}

crate::clocked!(BumpFetch;
    inputs go, u, v, write, write_address, write_data;
    outputs slope_u, slope_v);
