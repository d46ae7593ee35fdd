//! 1/√q for a squared length q from 2^−6 to 1: table and one Newton step, one result per clock.
//!
//! q = m·4^−e with 1/4 ≤ m < 1 and e of 0..=2, so 1/√q = 2^e/√m. With y₀ of the table and d = 1 − m·y₀², one Newton step
//! is y = y₀ + y₀·d/2, short of 1/√m by (3/8)·d² of it, d ≤ 2^−9 + 2^−16 ([`super::root_table`]).
//!
//! # Range and rounding
//! q below 2^−6 is taken as 2^−6, q ≥ 1 as 1 − 2^−28; the host refuses triangles on which q gets below. m has 24 bits (cut),
//! y₀² 23 fraction bits (cut), d 28 (cut), y 22 (cut). For every m the result is within [`ERROR`] of 1/√m, which is less
//! than a unit of 17 fraction bits: faithful to 17. The test runs through all of them.
//! Source: Newton's iteration, as Hast 2004, section 3.4, has it for normals; the seed from a table.

use super::root_table::RootTable;
use crate::format::{
    bit_cast_product, bit_cast_u, signed_cast_align, signed_cast_bits, signed_cast_product, Q, U,
};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Clocks from the square to its root.
pub const STAGES: usize = 6;
/// Least square, in units of 2^−28.
pub const LEAST: u64 = 1 << 22;
/// Largest |y − 1/√m|: (3/8)·d²·2, and the cuts.
pub const ERROR: f64 = 4.0e-6;

/// Latency: six clocks.
#[derive(LogicBlock)]
pub struct InverseRoot {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// The square, in units of 2^-28.
    pub square: Signal<In, Q<29, 0>>,
    /// One over the root of m, six clocks ago.
    pub root: Signal<Out, Q<2, 22>>,
    /// The root is to be doubled once.
    pub once: Signal<Out, Bit>,
    /// The root is to be doubled twice.
    pub twice: Signal<Out, Bit>,
    /// The square within its limits.
    square_1: Register<U<28>>,
    /// The square times a power of 4, 1/4 to 1.
    m_2: Register<U<24>>,
    /// That power is 4.
    once_2: Register<Bit>,
    /// That power is 16.
    twice_2: Register<Bit>,
    /// The same, one clock later.
    m_3: Register<U<24>>,
    /// The power is 4.
    once_3: Register<Bit>,
    /// The power is 16.
    twice_3: Register<Bit>,
    /// The same, two clocks later.
    m_4: Register<U<24>>,
    /// The power is 4.
    once_4: Register<Bit>,
    /// The power is 16.
    twice_4: Register<Bit>,
    /// First approximation.
    seed_4: Register<U<17>>,
    /// Its square, 23 fraction bits.
    seed_square_4: Register<U<25>>,
    /// First approximation, one clock later.
    seed_5: Register<U<17>>,
    /// (1 - m y0 y0) 2^8, with 20 fraction bits.
    miss_5: Register<Q<0, 20>>,
    /// The power is 4.
    once_5: Register<Bit>,
    /// The power is 16.
    twice_5: Register<Bit>,
    /// Second approximation.
    root_6: Register<Q<2, 22>>,
    /// The power is 4.
    once_6: Register<Bit>,
    /// The power is 16.
    twice_6: Register<Bit>,
    /// The square as bits.
    bits: Wire<U<28>>,
    /// Bits of the square that make it large enough.
    enough: Wire<U<6>>,
    /// The two highest bits of the square.
    high: Wire<U<2>>,
    /// The two bits below.
    middle: Wire<U<2>>,
    /// Interval of m.
    interval: Wire<U<10>>,
    /// Word of the interval.
    word: Wire<U<17>>,
    /// Its square.
    word_square: Wire<U<34>>,
    /// m times the square of the first approximation.
    product: Wire<U<49>>,
    /// The same, low bits in units of 2^-28.
    product_low: Wire<U<21>>,
    /// The miss as bits.
    miss_bits: Wire<U<21>>,
    /// First approximation with a sign.
    seed_wide: Wire<U<18>>,
    /// The same as a number.
    seed_number: Wire<Q<1, 16>>,
    /// What the Newton step adds, times 2^9, with 13 fraction bits.
    step: Wire<Q<11, 13>>,
    /// The same as bits.
    step_bits: Wire<U<25>>,
    /// The same as a number.
    step_number: Wire<Q<2, 22>>,
    /// First approximation in the format of the second.
    seed_start: Wire<Q<2, 22>>,
    /// The table.
    seeds: Quiet<RootTable>,
    /// Least square.
    least: Constant<U<28>>,
    /// Greatest square.
    greatest: Constant<U<28>>,
    /// Low bits of 1 in units of 2^-28.
    one: Constant<U<21>>,
}

impl Default for InverseRoot {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            go: Default::default(),
            square: Default::default(),
            root: Default::default(),
            once: Default::default(),
            twice: Default::default(),
            square_1: Default::default(),
            m_2: Default::default(),
            once_2: Default::default(),
            twice_2: Default::default(),
            m_3: Default::default(),
            once_3: Default::default(),
            twice_3: Default::default(),
            m_4: Default::default(),
            once_4: Default::default(),
            twice_4: Default::default(),
            seed_4: Default::default(),
            seed_square_4: Default::default(),
            seed_5: Default::default(),
            miss_5: Default::default(),
            once_5: Default::default(),
            twice_5: Default::default(),
            root_6: Default::default(),
            once_6: Default::default(),
            twice_6: Default::default(),
            bits: Default::default(),
            enough: Default::default(),
            high: Default::default(),
            middle: Default::default(),
            interval: Default::default(),
            word: Default::default(),
            word_square: Default::default(),
            product: Default::default(),
            product_low: Default::default(),
            miss_bits: Default::default(),
            seed_wide: Default::default(),
            seed_number: Default::default(),
            step: Default::default(),
            step_bits: Default::default(),
            step_number: Default::default(),
            seed_start: Default::default(),
            seeds: Default::default(),
            least: Constant::new(U::new(LEAST)),
            greatest: Constant::new(U::new((1 << 28) - 1)),
            one: Constant::new(U::new(0)),
        }
    }
}

impl Logic for InverseRoot {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name inverse_root");
        comment!("title One over the root of a squared length, by table and one Newton step.");
        comment!("equation y = y0 + y0 (1 - m y0^2) / 2, m = square 4^e, 1/4 <= m < 1; 1 / sqrt(square) = y 2^e");
        comment!("source Newton iteration; Duff 1979 needs the root per pixel.");
        comment!("latency Six clocks from square to root; one root per clock.");
        dff_setup!(
            self,
            clock,
            square_1,
            m_2,
            once_2,
            twice_2,
            m_3,
            once_3,
            twice_3,
            m_4,
            once_4,
            twice_4,
            seed_4,
            seed_square_4,
            seed_5,
            miss_5,
            once_5,
            twice_5,
            root_6,
            once_6,
            twice_6
        );
        self.bits.next = self.square.val().get_bits::<28>(0);
        self.enough.next = self.bits.val().get_bits::<6>(22);
        self.high.next = self.square_1.q.val().get_bits::<2>(26);
        self.middle.next = self.square_1.q.val().get_bits::<2>(24);
        self.interval.next = self.m_2.q.val().get_bits::<10>(14);
        self.seeds.clock.next = self.clock.val();
        self.seeds.read.next = self.go.val();
        self.seeds.read_address.next = self.interval.val();
        self.word.next = self.seeds.read_data.val();
        self.word_square.next = bit_cast_product::<34>(self.word.val() * self.word.val());
        self.product.next = bit_cast_product::<49>(self.m_4.q.val() * self.seed_square_4.q.val());
        self.product_low.next = self.product.val().get_bits::<21>(19);
        self.miss_bits.next = self.one.val() - self.product_low.val();
        self.seed_wide.next = bit_cast_u::<18, 17>(self.seed_5.q.val());
        self.seed_number.next = signed_cast_bits::<1, 16, 18>(self.seed_wide.val());
        self.step.next =
            signed_cast_product::<11, 13>(self.seed_number.val() * self.miss_5.q.val());
        self.step_bits.next = self.step.val().get_bits::<25>(0);
        self.step_number.next = signed_cast_bits::<2, 22, 25>(self.step_bits.val());
        self.seed_start.next = signed_cast_align::<2, 22, 1, 16>(self.seed_number.val());
        if self.go.val() {
            // The square within its limits.
            self.square_1.d.next = self.bits.val();
            if self.square.val().get_bit(29) {
                self.square_1.d.next = self.least.val();
            } else if self.square.val().get_bit(28) {
                self.square_1.d.next = self.greatest.val();
            } else if !self.enough.val().any() {
                self.square_1.d.next = self.least.val();
            }
            // Times a power of 4.
            self.once_2.d.next = false;
            self.twice_2.d.next = false;
            if self.high.val().any() {
                self.m_2.d.next = self.square_1.q.val().get_bits::<24>(4);
            } else if self.middle.val().any() {
                self.m_2.d.next = self.square_1.q.val().get_bits::<24>(2);
                self.once_2.d.next = true;
            } else {
                self.m_2.d.next = self.square_1.q.val().get_bits::<24>(0);
                self.twice_2.d.next = true;
            }
            // Table.
            self.m_3.d.next = self.m_2.q.val();
            self.once_3.d.next = self.once_2.q.val();
            self.twice_3.d.next = self.twice_2.q.val();
            // Square of the first approximation.
            self.m_4.d.next = self.m_3.q.val();
            self.once_4.d.next = self.once_3.q.val();
            self.twice_4.d.next = self.twice_3.q.val();
            self.seed_4.d.next = self.word.val();
            self.seed_square_4.d.next = self.word_square.val().get_bits::<25>(9);
            // What is missing.
            self.seed_5.d.next = self.seed_4.q.val();
            self.miss_5.d.next = signed_cast_bits::<0, 20, 21>(self.miss_bits.val());
            self.once_5.d.next = self.once_4.q.val();
            self.twice_5.d.next = self.twice_4.q.val();
            // Newton step.
            self.root_6.d.next = self.seed_start.val() + self.step_number.val();
            self.once_6.d.next = self.once_5.q.val();
            self.twice_6.d.next = self.twice_5.q.val();
        }
        self.root.next = self.root_6.q.val();
        self.once.next = self.once_6.q.val();
        self.twice.next = self.twice_6.q.val();
    }
}

crate::clocked!(InverseRoot;
    inputs go, square;
    outputs root, once, twice);
