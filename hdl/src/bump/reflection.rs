//! Factors of a bump's normal by reflection: the normal of the surface is mirrored in the half-way vector to the bent one,
//! so the length stays 1 and only the angle is off (Hast 2004, 3.269 to 3.271).
//!
//! t = 4/(g² + 4) = 1/(1 + x) with x = g²/4, which is 0 to 1 for gradients up to 2: no leading zeros to count, so a table of
//! chords and one multiplier divide. At g = 2 the normal lies in the surface; beyond, it is left there.

use super::reciprocal_table::ReciprocalTable;
use crate::format::{bit_cast_product, bit_cast_u, signed_cast_bits, signed_cast_product, Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Clocks from the gradient to the factors.
pub const STAGES: usize = 4;

/// Latency: four clocks.
#[derive(LogicBlock)]
pub struct BumpReflection {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// F_u.
    pub slope_u: Signal<In, Q<1, 16>>,
    /// F_v.
    pub slope_v: Signal<In, Q<1, 16>>,
    /// Factor t of the parts across the surface, of four clocks ago.
    pub across: Signal<Out, Q<1, 16>>,
    /// Part along its normal, 2t - 1.
    pub along: Signal<Out, Q<1, 16>>,
    /// F_u of four clocks ago.
    pub late_u: Signal<Out, Q<1, 16>>,
    /// F_v of four clocks ago.
    pub late_v: Signal<Out, Q<1, 16>>,
    /// F_u squared.
    square_u_1: Register<Q<3, 22>>,
    /// F_v squared.
    square_v_1: Register<Q<3, 22>>,
    /// F_u.
    slope_u_1: Register<Q<1, 16>>,
    /// F_v.
    slope_v_1: Register<Q<1, 16>>,
    /// A quarter of the squared gradient, limited.
    place_2: Register<U<16>>,
    /// F_u.
    slope_u_2: Register<Q<1, 16>>,
    /// F_v.
    slope_v_2: Register<Q<1, 16>>,
    /// Place within the interval that is read.
    fraction_3: Register<U<8>>,
    /// F_u.
    slope_u_3: Register<Q<1, 16>>,
    /// F_v.
    slope_v_3: Register<Q<1, 16>>,
    /// The factor, in units of 2^-18.
    factor_4: Register<U<18>>,
    /// F_u.
    slope_u_4: Register<Q<1, 16>>,
    /// F_v.
    slope_v_4: Register<Q<1, 16>>,
    /// Squared gradient.
    sum: Wire<Q<3, 22>>,
    /// Bits of it at and above 4.
    steep: Wire<U<2>>,
    /// Interval to read.
    interval: Wire<U<8>>,
    /// The interval that was read.
    word: Wire<U<28>>,
    /// Value at its beginning.
    start: Wire<U<18>>,
    /// Fall over the interval.
    fall: Wire<U<10>>,
    /// Fall times place.
    product: Wire<U<18>>,
    /// Fall to the place.
    fallen: Wire<U<10>>,
    /// The same, as wide as the factor.
    fallen_wide: Wire<U<18>>,
    /// The factor in units of 2^-16.
    across_bits: Wire<U<16>>,
    /// The same with integer and sign.
    across_wide: Wire<U<18>>,
    /// Twice the factor, in units of 2^-16.
    double: Wire<U<17>>,
    /// The same with a sign.
    double_wide: Wire<U<18>>,
    /// The part along the normal as bits.
    along_bits: Wire<U<18>>,
    /// The table.
    quotients: Quiet<ReciprocalTable>,
    /// 1 in units of 2^-16.
    one: Constant<U<18>>,
    /// Largest place.
    last: Constant<U<16>>,
}

impl Default for BumpReflection {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            go: Default::default(),
            slope_u: Default::default(),
            slope_v: Default::default(),
            across: Default::default(),
            along: Default::default(),
            late_u: Default::default(),
            late_v: Default::default(),
            square_u_1: Default::default(),
            square_v_1: Default::default(),
            slope_u_1: Default::default(),
            slope_v_1: Default::default(),
            place_2: Default::default(),
            slope_u_2: Default::default(),
            slope_v_2: Default::default(),
            fraction_3: Default::default(),
            slope_u_3: Default::default(),
            slope_v_3: Default::default(),
            factor_4: Default::default(),
            slope_u_4: Default::default(),
            slope_v_4: Default::default(),
            sum: Default::default(),
            steep: Default::default(),
            interval: Default::default(),
            word: Default::default(),
            start: Default::default(),
            fall: Default::default(),
            product: Default::default(),
            fallen: Default::default(),
            fallen_wide: Default::default(),
            across_bits: Default::default(),
            across_wide: Default::default(),
            double: Default::default(),
            double_wide: Default::default(),
            along_bits: Default::default(),
            quotients: Default::default(),
            one: Constant::new(U::new(1 << 16)),
            last: Constant::new(U::new((1 << 16) - 1)),
        }
    }
}

impl Logic for BumpReflection {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name bump_reflection");
        comment!("title Factors of a bump's normal by reflection, which keeps its length.");
        comment!("equation across = 4 / (g^2 + 4), along = 2 across - 1, g^2 = F_u^2 + F_v^2 < 4; normal = (-F_u across, -F_v across, along)");
        comment!("source Hast 2004, section 3.4.2, equations 3.269 to 3.271.");
        comment!("latency Four clocks from gradient to factors; one pair per clock.");
        dff_setup!(
            self, clock, square_u_1, square_v_1, slope_u_1, slope_v_1, place_2, slope_u_2,
            slope_v_2, fraction_3, slope_u_3, slope_v_3, factor_4, slope_u_4, slope_v_4
        );
        self.sum.next = self.square_u_1.q.val() + self.square_v_1.q.val();
        self.steep.next = self.sum.val().get_bits::<2>(24);
        self.interval.next = self.place_2.q.val().get_bits::<8>(8);
        self.quotients.clock.next = self.clock.val();
        self.quotients.read.next = self.go.val();
        self.quotients.read_address.next = self.interval.val();
        self.word.next = self.quotients.read_data.val();
        self.start.next = self.word.val().get_bits::<18>(10);
        self.fall.next = self.word.val().get_bits::<10>(0);
        self.product.next = bit_cast_product::<18>(self.fall.val() * self.fraction_3.q.val());
        self.fallen.next = self.product.val().get_bits::<10>(8);
        self.fallen_wide.next = bit_cast_u::<18, 10>(self.fallen.val());
        if self.go.val() {
            self.square_u_1.d.next =
                signed_cast_product::<3, 22>(self.slope_u.val() * self.slope_u.val());
            self.square_v_1.d.next =
                signed_cast_product::<3, 22>(self.slope_v.val() * self.slope_v.val());
            self.place_2.d.next = self.sum.val().get_bits::<16>(8);
            if self.steep.val().any() {
                self.place_2.d.next = self.last.val();
            }
            self.fraction_3.d.next = self.place_2.q.val().get_bits::<8>(0);
            self.factor_4.d.next = self.start.val() - self.fallen_wide.val();
            self.slope_u_1.d.next = self.slope_u.val();
            self.slope_v_1.d.next = self.slope_v.val();
            self.slope_u_2.d.next = self.slope_u_1.q.val();
            self.slope_v_2.d.next = self.slope_v_1.q.val();
            self.slope_u_3.d.next = self.slope_u_2.q.val();
            self.slope_v_3.d.next = self.slope_v_2.q.val();
            self.slope_u_4.d.next = self.slope_u_3.q.val();
            self.slope_v_4.d.next = self.slope_v_3.q.val();
        }
        self.across_bits.next = self.factor_4.q.val().get_bits::<16>(2);
        self.across_wide.next = bit_cast_u::<18, 16>(self.across_bits.val());
        self.across.next = signed_cast_bits::<1, 16, 18>(self.across_wide.val());
        self.double.next = self.factor_4.q.val().get_bits::<17>(1);
        self.double_wide.next = bit_cast_u::<18, 17>(self.double.val());
        self.along_bits.next = self.double_wide.val() - self.one.val();
        self.along.next = signed_cast_bits::<1, 16, 18>(self.along_bits.val());
        self.late_u.next = self.slope_u_4.q.val();
        self.late_v.next = self.slope_v_4.q.val();
    }
}

crate::clocked!(BumpReflection;
    inputs go, slope_u, slope_v;
    outputs across, along, late_u, late_v);
