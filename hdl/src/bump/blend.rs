//! One part of a gradient at a place between four samples: twice between columns, once between rows.
//!
//! A difference of two gradients within ±2 fits Q2.16; what lies between them is within ±2 again. Weights have 12 fraction
//! bits; each product is cut to the 16 of a gradient.

use crate::format::{bit_cast_u, signed_cast_align, signed_cast_bits, signed_cast_product, Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Clocks from the samples to what lies between them.
pub const STAGES: usize = 4;

/// Latency: four clocks.
#[derive(LogicBlock, Default)]
pub struct BumpBlend {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Upper row, left column.
    pub upper_left: Signal<In, Q<1, 16>>,
    /// Upper row, right column.
    pub upper_right: Signal<In, Q<1, 16>>,
    /// Lower row, left column.
    pub lower_left: Signal<In, Q<1, 16>>,
    /// Lower row, right column.
    pub lower_right: Signal<In, Q<1, 16>>,
    /// Place between the columns.
    pub part_u: Signal<In, U<12>>,
    /// Place between the rows.
    pub part_v: Signal<In, U<12>>,
    /// What lies at the place, four clocks ago.
    pub slope: Signal<Out, Q<1, 16>>,
    /// Upper row, left column, with another integer bit.
    upper_left_wide: Wire<Q<2, 16>>,
    /// Upper row, right column, with another integer bit.
    upper_right_wide: Wire<Q<2, 16>>,
    /// Lower row, left column, with another integer bit.
    lower_left_wide: Wire<Q<2, 16>>,
    /// Lower row, right column, with another integer bit.
    lower_right_wide: Wire<Q<2, 16>>,
    /// Upper row, left.
    upper_1: Register<Q<2, 16>>,
    /// Its change to the right.
    upper_rise_1: Register<Q<2, 16>>,
    /// Lower row, left.
    lower_1: Register<Q<2, 16>>,
    /// Its change to the right.
    lower_rise_1: Register<Q<2, 16>>,
    /// Place between the columns.
    part_u_1: Register<U<12>>,
    /// Place between the rows.
    part_v_1: Register<U<12>>,
    /// Upper row, at the column.
    upper_2: Register<Q<2, 16>>,
    /// Lower row, at the column.
    lower_2: Register<Q<2, 16>>,
    /// Place between the rows.
    part_v_2: Register<U<12>>,
    /// Upper row.
    top_3: Register<Q<2, 16>>,
    /// Its change to the lower row.
    rise_3: Register<Q<2, 16>>,
    /// Place between the rows.
    part_v_3: Register<U<12>>,
    /// At the place.
    slope_4: Register<Q<2, 16>>,
    /// Place between the columns with a sign.
    weight_u_bits: Wire<U<13>>,
    /// The same as a number.
    weight_u: Wire<Q<0, 12>>,
    /// Place between the rows with a sign.
    weight_v_bits: Wire<U<13>>,
    /// The same as a number.
    weight_v: Wire<Q<0, 12>>,
    /// What the column adds to the upper row.
    upper_add: Wire<Q<2, 16>>,
    /// What it adds to the lower row.
    lower_add: Wire<Q<2, 16>>,
    /// What the row adds.
    add: Wire<Q<2, 16>>,
}

impl Logic for BumpBlend {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name bump_blend");
        comment!("title One part of a gradient, bilinear between four samples.");
        comment!("equation slope = (1 - fv) ((1 - fu) a + fu b) + fv ((1 - fu) c + fu d)");
        comment!("source Hast 2004, section 3.4.1: linear interpolation of gradients.");
        comment!("latency Four clocks; one gradient per clock.");
        dff_setup!(
            self,
            clock,
            upper_1,
            upper_rise_1,
            lower_1,
            lower_rise_1,
            part_u_1,
            part_v_1,
            upper_2,
            lower_2,
            part_v_2,
            top_3,
            rise_3,
            part_v_3,
            slope_4
        );
        self.upper_left_wide.next = signed_cast_align::<2, 16, 1, 16>(self.upper_left.val());
        self.upper_right_wide.next = signed_cast_align::<2, 16, 1, 16>(self.upper_right.val());
        self.lower_left_wide.next = signed_cast_align::<2, 16, 1, 16>(self.lower_left.val());
        self.lower_right_wide.next = signed_cast_align::<2, 16, 1, 16>(self.lower_right.val());
        self.weight_u_bits.next = bit_cast_u::<13, 12>(self.part_u_1.q.val());
        self.weight_u.next = signed_cast_bits::<0, 12, 13>(self.weight_u_bits.val());
        self.weight_v_bits.next = bit_cast_u::<13, 12>(self.part_v_3.q.val());
        self.weight_v.next = signed_cast_bits::<0, 12, 13>(self.weight_v_bits.val());
        self.upper_add.next =
            signed_cast_product::<2, 16>(self.upper_rise_1.q.val() * self.weight_u.val());
        self.lower_add.next =
            signed_cast_product::<2, 16>(self.lower_rise_1.q.val() * self.weight_u.val());
        self.add.next = signed_cast_product::<2, 16>(self.rise_3.q.val() * self.weight_v.val());
        if self.go.val() {
            self.upper_1.d.next = self.upper_left_wide.val();
            self.upper_rise_1.d.next = self.upper_right_wide.val() - self.upper_left_wide.val();
            self.lower_1.d.next = self.lower_left_wide.val();
            self.lower_rise_1.d.next = self.lower_right_wide.val() - self.lower_left_wide.val();
            self.part_u_1.d.next = self.part_u.val();
            self.part_v_1.d.next = self.part_v.val();
            self.upper_2.d.next = self.upper_1.q.val() + self.upper_add.val();
            self.lower_2.d.next = self.lower_1.q.val() + self.lower_add.val();
            self.part_v_2.d.next = self.part_v_1.q.val();
            self.top_3.d.next = self.upper_2.q.val();
            self.rise_3.d.next = self.lower_2.q.val() - self.upper_2.q.val();
            self.part_v_3.d.next = self.part_v_2.q.val();
            self.slope_4.d.next = self.top_3.q.val() + self.add.val();
        }
        self.slope.next = signed_cast_align::<1, 16, 2, 16>(self.slope_4.q.val());
    }
}

crate::clocked!(BumpBlend;
    inputs go, upper_left, upper_right, lower_left, lower_right, part_u, part_v;
    outputs slope);
