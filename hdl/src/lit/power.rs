//! xⁿ as a table of chords: 256 of them over w = 1 − x from 0 to 2^−s, for up to four materials side by side.
//!
//! A highlight of exponent n has faded to e^−8.5 at w = 8.5/n, so the table of a large n is stretched by 2^s, the
//! largest power of two up to n/8.5 (at most 2^7); beyond its end the factor is 0. A word holds the value at the begin of
//! its interval and how far the chord falls along it; the host puts the chord half its own error below the curve, so
//! that it is within h²n²/16 of it, h = 2^−s/256: 0.07 LSB of full scale at worst.
//!
//! # Formats
//! x is taken with 25 fraction bits, of which 8 address the table when s = 7 and 10 go along the chord. A word is
//! value\[31:14\], 18 bits in units of 2^−17, and fall\[13:0\] in the same units: 17/256 of full scale is the most that
//! a chord falls by. Nothing overflows: the value is at least as large as the fall (the host takes care; the words of
//! [`super::chord::chord`] are), and the difference of two words of 18 bits modulo 2^18 is their difference.

use super::table_memory::{TableMemory, TableMemoryModel};
use crate::format::{bit_cast_product, bit_cast_u, mask, signed_cast_align, Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Latency: three clocks with `go`.
#[derive(LogicBlock)]
pub struct PowerTable {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move.
    pub go: Signal<In, Bit>,
    /// x.
    pub value: Signal<In, Q<1, 42>>,
    /// Binary places that the table is stretched by.
    pub shift: Signal<In, U<3>>,
    /// Material.
    pub material: Signal<In, U<2>>,
    /// Writes a word of the table.
    pub write: Signal<In, Bit>,
    /// Its place: interval, material.
    pub write_address: Signal<In, U<10>>,
    /// The word.
    pub write_data: Signal<In, U<32>>,
    /// Factor, 65536 is 1.
    pub factor: Signal<Out, U<17>>,
    /// Interval in the first stage.
    interval: Register<U<8>>,
    /// Material in the first stage.
    interval_material: Register<U<2>>,
    /// Place in the interval in the first stage.
    along_first: Register<U<10>>,
    /// x is beyond the table, first stage.
    beyond_first: Register<Bit>,
    /// Place in the interval in the second stage.
    along_second: Register<U<10>>,
    /// x is beyond the table, second stage.
    beyond_second: Register<Bit>,
    /// The factor in the third stage.
    third: Register<U<17>>,
    /// x with the bits that count.
    cosine: Wire<Q<2, 25>>,
    /// 1 - x.
    below: Wire<Q<2, 25>>,
    /// Its bits; 0 if x is more than 1.
    below_bits: Wire<U<28>>,
    /// The same, wider.
    wide: Wire<U<35>>,
    /// Stretched by one place if the shift has it.
    wide_1: Wire<U<35>>,
    /// Stretched by two more.
    wide_2: Wire<U<35>>,
    /// Stretched by four more.
    wide_4: Wire<U<35>>,
    /// Bits of the stretched difference beyond the table.
    high: Wire<U<10>>,
    /// Address of the table.
    table_address: Wire<U<10>>,
    /// Fall along the whole chord.
    fall: Wire<U<14>>,
    /// Fall up to x, with 10 bits of fraction.
    fallen: Wire<U<24>>,
    /// Fall up to x.
    fallen_whole: Wire<U<18>>,
    /// Value at the begin of the interval.
    origin: Wire<U<18>>,
    /// Value at x.
    power: Wire<U<18>>,
    /// Chords.
    chords: Quiet<TableMemory<10, 32>>,
    /// 1.
    one: Constant<Q<2, 25>>,
    /// No light.
    zero: Constant<U<17>>,
    /// x is 1.
    nothing: Constant<U<28>>,
}

impl Default for PowerTable {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            go: Default::default(),
            value: Default::default(),
            shift: Default::default(),
            material: Default::default(),
            write: Default::default(),
            write_address: Default::default(),
            write_data: Default::default(),
            factor: Default::default(),
            interval: Default::default(),
            interval_material: Default::default(),
            along_first: Default::default(),
            beyond_first: Default::default(),
            along_second: Default::default(),
            beyond_second: Default::default(),
            third: Default::default(),
            cosine: Default::default(),
            below: Default::default(),
            below_bits: Default::default(),
            wide: Default::default(),
            wide_1: Default::default(),
            wide_2: Default::default(),
            wide_4: Default::default(),
            high: Default::default(),
            table_address: Default::default(),
            fall: Default::default(),
            fallen: Default::default(),
            fallen_whole: Default::default(),
            origin: Default::default(),
            power: Default::default(),
            chords: Default::default(),
            one: Constant::new(Q::from_code(1 << 25)),
            zero: Constant::new(U::new(0)),
            nothing: Constant::new(U::new(0)),
        }
    }
}

impl Logic for PowerTable {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name lit_power");
        comment!("title A power by a table of chords that is stretched for large exponents.");
        comment!("equation x^n = value(i) - fall(i) f,  i + f = 256 2^s (1 - x)");
        comment!("source Ours; the table is loaded by the host, one for each material.");
        comment!("latency Three clocks with go.");
        dff_setup!(
            self,
            clock,
            interval,
            interval_material,
            along_first,
            beyond_first,
            along_second,
            beyond_second,
            third
        );
        // Where in the table.
        self.cosine.next = signed_cast_align::<2, 25, 1, 42>(self.value.val());
        self.below.next = self.one.val() - self.cosine.val();
        self.below_bits.next = self.below.val().get_bits::<28>(0);
        if self.below.val().get_bit(27) {
            self.below_bits.next = self.nothing.val();
        }
        self.wide.next = bit_cast_u::<35, 28>(self.below_bits.val());
        self.wide_1.next = self.wide.val();
        if self.shift.val().get_bit(0) {
            self.wide_1.next = self.wide.val() << 1u64;
        }
        self.wide_2.next = self.wide_1.val();
        if self.shift.val().get_bit(1) {
            self.wide_2.next = self.wide_1.val() << 2u64;
        }
        self.wide_4.next = self.wide_2.val();
        if self.shift.val().get_bit(2) {
            self.wide_4.next = self.wide_2.val() << 4u64;
        }
        self.high.next = self.wide_4.val().get_bits::<10>(25);
        self.table_address.next = (bit_cast_u::<10, 8>(self.interval.q.val()) << 2u64)
            | bit_cast_u::<10, 2>(self.interval_material.q.val());

        // The chord.
        self.chords.clock.next = self.clock.val();
        self.chords.read.next = self.go.val();
        self.chords.read_address.next = self.table_address.val();
        self.chords.write.next = self.write.val();
        self.chords.write_address.next = self.write_address.val();
        self.chords.write_data.next = self.write_data.val();
        self.fall.next = self.chords.read_data.val().get_bits::<14>(0);
        self.origin.next = self.chords.read_data.val().get_bits::<18>(14);
        self.fallen.next = bit_cast_product::<24>(self.fall.val() * self.along_second.q.val());
        self.fallen_whole.next = bit_cast_u::<18, 14>(self.fallen.val().get_bits::<14>(10));
        self.power.next = self.origin.val() - self.fallen_whole.val();

        if self.go.val() {
            self.interval.d.next = self.wide_4.val().get_bits::<8>(17);
            self.interval_material.d.next = self.material.val();
            self.along_first.d.next = self.wide_4.val().get_bits::<10>(7);
            self.beyond_first.d.next = self.high.val().any();
            self.along_second.d.next = self.along_first.q.val();
            self.beyond_second.d.next = self.beyond_first.q.val();
            if self.beyond_second.q.val() {
                self.third.d.next = self.zero.val();
            } else {
                self.third.d.next = self.power.val().get_bits::<17>(1);
            }
        }
        self.factor.next = self.third.q.val();
    }
}

crate::clocked!(PowerTable;
    inputs go, value, shift, material, write, write_address, write_data;
    outputs factor);

/// Integer model of [`PowerTable`].
#[derive(Clone, Debug)]
pub struct PowerTableModel {
    chords: TableMemoryModel,
    first: (u64, u64, bool),
    second: (u64, bool),
    third: u64,
}

impl Default for PowerTableModel {
    fn default() -> Self {
        Self {
            chords: TableMemoryModel::new(10, 32),
            first: (0, 0, false),
            second: (0, false),
            third: 0,
        }
    }
}

impl PowerTableModel {
    /// The factor of the third stage.
    #[must_use]
    pub fn factor(&self) -> u64 {
        self.third
    }

    /// One clock; `value` is Q1.42, `write` an address and a word.
    pub fn clock(
        &mut self,
        go: bool,
        value: i64,
        [shift, material]: [u64; 2],
        write: Option<(u64, u64)>,
    ) {
        let address = self.first.0;
        if go {
            let (along, beyond) = self.second;
            let (begin, fall) = (
                self.chords.read_data >> 14,
                self.chords.read_data & mask(14),
            );
            let power = begin.wrapping_sub((fall * along) >> 10) & mask(18);
            self.third = if beyond { 0 } else { power >> 1 };
            self.second = (self.first.1, self.first.2);
            let below = ((1i64 << 25) - (value >> 17)).max(0) as u64;
            let wide = below << shift;
            self.first = (
                (wide >> 17 & mask(8)) << 2 | material,
                wide >> 7 & mask(10),
                wide >> 25 != 0,
            );
        }
        self.chords.clock(go.then_some(address), write);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lit::chord::{chord, shift_of, CHORDS};
    use crate::lit::UNIT;

    /// The factor for one value, through all stages.
    fn factor(m: &mut PowerTableModel, x: f64, shift: u32) -> f64 {
        let value = (x * 2f64.powi(42)).round() as i64;
        for _ in 0..3 {
            m.clock(true, value, [u64::from(shift), 2], None);
        }
        m.factor() as f64 / UNIT as f64
    }

    #[test]
    fn every_exponent_is_within_its_chords() {
        for n in [
            1.0, 1.5, 2.0, 5.0, 8.5, 16.9, 17.0, 20.0, 64.0, 128.0, 300.0, 1024.0,
        ] {
            let mut m = PowerTableModel::default();
            for i in 0..CHORDS {
                m.clock(false, 0, [0; 2], Some(((i as u64) << 2 | 2, chord(n, i))));
            }
            let s = shift_of(n);
            let mut worst = 0.0f64;
            for k in 0..=8000 {
                // Dense where the highlight is, then everywhere down to -1.
                let w = if k < 6000 {
                    f64::from(k) / 6000.0 * 1.1 / f64::from(1u32 << s)
                } else {
                    f64::from(k - 6000) / 1000.0
                };
                let x = 1.0 - w;
                let want = x.max(0.0).powf(n);
                worst = worst.max((factor(&mut m, x, s) - want).abs());
            }
            println!("n = {n}: {:.3} LSB", 255.0 * worst);
            // 0.07 LSB for the chord, what is cut at the end of the table, and two units of a factor.
            assert!(255.0 * worst < 0.14, "{n}: {}", 255.0 * worst);
            assert!(factor(&mut m, 1.0 + 1e-9, s) > 0.999, "a little above 1");
        }
    }
}
