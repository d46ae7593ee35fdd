//! hⁿ for any n from 1 to [`MAX_EXPONENT`], by linear interpolation in a table that covers the visible part of the lobe.
//!
//! Only the neighbourhood of h = 1 shows: hⁿ < 2^−14 (0.016 LSB of a full highlight) from h = 2^(−14/n) downwards. So the
//! argument is not h but the place in the lobe
//!
//!   t = (1 − h)·2^s,  s the largest of 0..=7 with (1 − 2^(−14/n))·2^s ≤ 1,
//!
//! and the table holds p(t) = (1 − t·2^−s)ⁿ over 0 ≤ t < 1; t < 0 is taken as 0 (h is limited to 1), and beyond 1 the
//! power is 0. The interpolant of N·H accumulates t itself: the host scales its words by the exact factor 2^s, so there
//! is no shifter, and the error of the accumulator is magnified by |p′(t)| = n·2^−s·h^(n−1) ≤ [`STEEPEST`] for every n,
//! where it would be by n for h itself.
//!
//! # The bound of the table
//! With 512 intervals of width w = 2^−9 the chord of p is off by at most w²/8·max|p″|, on one side; the host moves it by
//! half of what it is off in the middle of the interval, so w²/16·max|p″| is left, up to the third order. |p″| =
//! n(n − 1)·2^(−2s)·h^(n−2) ≤ [`STEEPEST`]² where n ≥ 2; for 1 < n < 2 the second derivative has no bound at h = 0, but
//! there p is below w^n. So, for 2^−18 as the unit of a word:
//!
//! | from | bound |
//! |---|---:|
//! | chord | 9.0e−5 |
//! | start and fall to nearest units | 2^−18 |
//! | t to 19 fraction bits, to nearest | [`STEEPEST`]·2^−20 |
//! | cut of the fall (upwards), then of the power to 17 bits (downwards) | 2^−17 |
//!
//! Together at most [`ERROR`], 1.2e−4, which exceeds the 2^−14 that are lost beyond the table. `gen` has the words and tests them over every t and many n against f64.
//! Source: a power by table as Abbas 2003, chapter 6, has it for cos²; the place in the lobe and the bound are ours.

use super::power_table::PowerTable;
use crate::format::{bit_cast_product, bit_cast_u, signed_cast_bits, Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Fraction bits of the place in the lobe: 9 of the interval, 10 within it.
pub const PLACE_FRACTION_BITS: usize = 19;
/// Integer bits of the interpolant of the place: six knots of N·H within ±2 give −7/3·2^s to 13/3·2^s, s ≤ 7.
pub const PLACE_INTEGER_BITS: usize = 10;
/// Fraction bits of the words of the table.
pub const TABLE_FRACTION_BITS: usize = 18;
/// Largest s.
pub const MAX_SCALE: u32 = 7;
/// Largest exponent: beyond it the table of s = 7 would be too coarse.
pub const MAX_EXPONENT: f64 = 2048.0;
/// Largest |p′(t)|: 2·14·ln 2, since (1 − 2^(−14/n))·2^(s+1) > 1 and 1 − 2^(−14/n) ≤ 14·ln 2/n, unless s = 7, where
/// n·2^−7 ≤ 16.
pub const STEEPEST: f64 = 28.0 * std::f64::consts::LN_2;
/// Largest error of the power.
pub const ERROR: f64 = STEEPEST * STEEPEST / (16.0 * (1u64 << 18) as f64)
    + 3.0 / (1u64 << 18) as f64
    + STEEPEST / (1u64 << 20) as f64;

/// Latency: four clocks.
#[derive(LogicBlock, Default)]
pub struct Power {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Place in the lobe, in units of 2^-19.
    pub place: Signal<In, Q<29, 0>>,
    /// Writes the table.
    pub write: Signal<In, Bit>,
    /// Interval to write.
    pub write_address: Signal<In, U<9>>,
    /// Word to write.
    pub write_data: Signal<In, U<32>>,
    /// The power of four clocks ago.
    pub power: Signal<Out, Q<0, 17>>,
    /// Place, limited to the table.
    place_1: Register<U<19>>,
    /// The place lies beyond the table.
    dark_1: Register<Bit>,
    /// Place within the interval being read.
    fraction_2: Register<U<10>>,
    /// That place lies beyond the table.
    dark_2: Register<Bit>,
    /// Power at the beginning of the interval.
    start_3: Register<U<18>>,
    /// How far it falls to the place.
    fall_3: Register<U<14>>,
    /// The place lies beyond the table.
    dark_3: Register<Bit>,
    /// The power.
    power_4: Register<U<17>>,
    /// Integer bits of the place.
    beyond: Wire<U<10>>,
    /// Interval to read.
    interval: Wire<U<9>>,
    /// The interval that was read.
    word: Wire<U<32>>,
    /// Fall over the interval.
    fall: Wire<U<14>>,
    /// Fall times place.
    product: Wire<U<24>>,
    /// Fall to the place, as wide as the power.
    fall_wide: Wire<U<18>>,
    /// The power in units of the table.
    difference: Wire<U<18>>,
    /// The power with a sign bit.
    power_bits: Wire<U<18>>,
    /// The table.
    powers: Quiet<PowerTable>,
}

impl Logic for Power {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name power");
        comment!("title Power of a cosine from its place in the lobe, by table and linear interpolation.");
        comment!("equation power = (1 - t / 2^s)^n from start - fall * fraction; 1 for t < 0, 0 for t >= 1");
        comment!("source Table of a highlight as in Abbas 2003, chapter 6; place in the lobe instead of an angle.");
        comment!("latency Four clocks from place to power; one power per clock.");
        dff_setup!(
            self, clock, place_1, dark_1, fraction_2, dark_2, start_3, fall_3, dark_3, power_4
        );
        self.beyond.next = self.place.val().get_bits::<10>(19);
        self.interval.next = self.place_1.q.val().get_bits::<9>(10);
        self.powers.clock.next = self.clock.val();
        self.powers.read.next = self.go.val();
        self.powers.read_address.next = self.interval.val();
        self.powers.write.next = self.write.val();
        self.powers.write_address.next = self.write_address.val();
        self.powers.write_data.next = self.write_data.val();
        self.word.next = self.powers.read_data.val();
        self.fall.next = self.word.val().get_bits::<14>(0);
        self.product.next = bit_cast_product::<24>(self.fall.val() * self.fraction_2.q.val());
        self.fall_wide.next = bit_cast_u::<18, 14>(self.fall_3.q.val());
        self.difference.next = self.start_3.q.val() - self.fall_wide.val();
        if self.go.val() {
            self.place_1.d.next = self.place.val().get_bits::<19>(0);
            self.dark_1.d.next = self.beyond.val().any();
            if self.place.val().get_bit(29) {
                self.place_1.d.next = 0u64.into();
                self.dark_1.d.next = false;
            }
            self.fraction_2.d.next = self.place_1.q.val().get_bits::<10>(0);
            self.dark_2.d.next = self.dark_1.q.val();
            self.start_3.d.next = self.word.val().get_bits::<18>(14);
            self.fall_3.d.next = self.product.val().get_bits::<14>(10);
            self.dark_3.d.next = self.dark_2.q.val();
            self.power_4.d.next = self.difference.val().get_bits::<17>(1);
            if self.dark_3.q.val() {
                self.power_4.d.next = 0u64.into();
            }
        }
        self.power_bits.next = bit_cast_u::<18, 17>(self.power_4.q.val());
        self.power.next = signed_cast_bits::<0, 17, 18>(self.power_bits.val());
    }
}

crate::clocked!(Power;
    inputs go, place, write, write_address, write_data;
    outputs power);
