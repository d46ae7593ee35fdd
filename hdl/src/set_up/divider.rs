//! The divider: one bit of a quotient per clock, for edges and for the two reciprocals of a triangle.
//!
//! # Range
//! *Whole*: (x + 4096·y) / y with 0 ≤ x + 4096·y < 2^14·y, y < 2^20: 14 bits, whose low 12 are those of ⌊x / y⌋.
//! *Fraction*: 1 / y, 1 ≤ y: 43 fraction bits. *Reciprocal*: 1 / y, 1 ≤ y ≤ 2^40: the leading 24 bits q and the number e of
//! zeros before them, 1/y = q·2^(−23−e), short by less than 2^−23 of itself. The remainder is below 2·y·2^13 throughout.
//! Other operands (an edge that no row meets) give a quotient that nobody reads, in as many clocks.

use super::instruction::Division;
use super::schedule::steps;
use crate::format::{bit_cast_u, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Latency: 14, 44 or 64 clocks behind the one that takes `start`.
#[derive(LogicBlock, Default)]
pub struct Divider {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The divider moves.
    pub go: Signal<In, Bit>,
    /// Takes operands.
    pub start: Signal<In, Bit>,
    /// 0 whole, 1 fraction, 2 reciprocal.
    pub kind: Signal<In, U<2>>,
    /// Dividend of a whole division.
    pub x: Signal<In, U<64>>,
    /// Divisor.
    pub y: Signal<In, U<64>>,
    /// Quotient.
    pub quotient: Signal<Out, U<44>>,
    /// What a whole division leaves.
    pub remainder: Signal<Out, U<34>>,
    /// Zeros before the first one of the last reciprocal.
    pub exponent: Signal<Out, U<6>>,
    /// What is left of the dividend.
    rest: Register<U<48>>,
    /// Divisor.
    divisor: Register<U<48>>,
    /// Quotient so far.
    digits: Register<U<44>>,
    /// Zeros so far.
    zeros: Register<U<6>>,
    /// Bits to come.
    left: Register<U<7>>,
    /// The quotient is a reciprocal.
    normal: Register<Bit>,
    /// Dividend.
    x_bits: Wire<U<48>>,
    /// Divisor.
    y_bits: Wire<U<48>>,
    /// The divisor goes into what is left.
    fits: Wire<Bit>,
    /// The same as a digit.
    digit: Wire<U<44>>,
    /// What is left behind it.
    less: Wire<U<48>>,
    /// Quotient with the digit.
    longer: Wire<U<44>>,
    /// The reciprocal has its 24 bits.
    full: Wire<Bit>,
}

impl Logic for Divider {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name set_up_divider");
        comment!("title Shared divider: one bit per clock.");
        comment!("equation whole: floor((x + 4096 y) / y) and rest; fraction: floor(2^43 / y); reciprocal: 24 leading bits of 1 / y");
        comment!("source Restoring division.");
        comment!("latency 14, 44 or 64 clocks behind start.");
        dff_setup!(self, clock, rest, divisor, digits, zeros, left, normal);
        self.x_bits.next = bit_cast_u::<48, 64>(self.x.val());
        self.y_bits.next = bit_cast_u::<48, 64>(self.y.val());
        self.fits.next = self.divisor.q.val() <= self.rest.q.val();
        self.less.next = self.rest.q.val();
        self.digit.next = 0u64.into();
        if self.fits.val() {
            self.less.next = self.rest.q.val() - self.divisor.q.val();
            self.digit.next = 1u64.into();
        }
        self.longer.next = (self.digits.q.val() << 1u64) | self.digit.val();
        self.full.next = self.normal.q.val() && self.digits.q.val().get_bit(23);
        if self.go.val() {
            if self.start.val() {
                self.digits.d.next = 0u64.into();
                self.normal.d.next = false;
                self.rest.d.next = 1u64.into();
                self.divisor.d.next = self.y_bits.val();
                self.left.d.next = 44u64.into();
                if self.kind.val() == 0u64.into() {
                    self.rest.d.next = self.x_bits.val() + (self.y_bits.val() << 12u64);
                    self.divisor.d.next = self.y_bits.val() << 13u64;
                    self.left.d.next = 14u64.into();
                }
                if self.kind.val() == 2u64.into() {
                    self.left.d.next = 64u64.into();
                    self.normal.d.next = true;
                    self.zeros.d.next = 0u64.into();
                }
            } else if self.left.q.val().any() {
                self.rest.d.next = self.less.val() << 1u64;
                if !self.full.val() {
                    self.digits.d.next = self.longer.val();
                    if self.normal.q.val() && !self.longer.val().any() {
                        self.zeros.d.next = self.zeros.q.val() + 1u64.into();
                    }
                }
                self.left.d.next = self.left.q.val() - 1u64.into();
            }
        }
        self.quotient.next = self.digits.q.val();
        self.remainder.next = self.rest.q.val().get_bits::<34>(14);
        self.exponent.next = self.zeros.q.val();
    }
}

crate::clocked!(Divider;
    inputs go, start, kind, x, y;
    outputs quotient, remainder, exponent);

/// Integer model of the divider.
#[derive(Clone, Copy, Debug, Default)]
pub struct DividerModel {
    rest: u64,
    divisor: u64,
    /// The quotient so far.
    pub quotient: u64,
    /// Zeros before the first one of a reciprocal.
    pub exponent: u8,
    left: u8,
    normal: bool,
}

impl DividerModel {
    /// What a whole division leaves.
    #[must_use]
    pub fn remainder(&self) -> i64 {
        (self.rest >> 14) as i64
    }

    /// One clock: x, y, kind.
    pub fn clock(&mut self, start: Option<(i64, i64, Division)>) {
        const MASK: u64 = (1 << 48) - 1;
        if let Some((x, y, kind)) = start {
            let y = y as u64;
            (self.rest, self.divisor) = match kind {
                Division::Whole => ((x as u64).wrapping_add(y << 12), y << 13),
                _ => (1, y),
            };
            self.rest &= MASK;
            self.divisor &= MASK;
            self.quotient = 0;
            self.left = steps(kind) as u8;
            self.normal = kind == Division::Reciprocal;
            if self.normal {
                self.exponent = 0;
            }
        } else if self.left > 0 {
            let fits = self.rest >= self.divisor;
            let rest = self.rest.wrapping_sub(if fits { self.divisor } else { 0 });
            self.rest = rest << 1 & MASK;
            let full = self.normal && self.quotient >> 23 & 1 == 1;
            if !full {
                self.quotient = (self.quotient << 1 | u64::from(fits)) & ((1 << 44) - 1);
                if self.normal && self.quotient == 0 {
                    self.exponent = (self.exponent + 1) & 63;
                }
            }
            self.left -= 1;
        }
    }
}
