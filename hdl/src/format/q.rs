//! Signed fixed-point words and their quantisation.

use super::{literal, mask, waveform, wrap, U};
use fixed::types::I64F64;
use rust_hdl_core::prelude::*;
use std::ops::{Add, Not, Sub};

/// A signed word Q`M`.`N`: a sign, `M` integer bits and `N` fraction bits, `1 + M + N` bits in all (at most 64).
/// The value is code · 2^−N; the range −2^M to 2^M − 2^−N. Arithmetic on codes is modulo 2^(1+M+N).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Q<const M: usize, const N: usize>(i64);

impl<const M: usize, const N: usize> Q<M, N> {
    /// Bits of the word.
    pub const WIDTH: usize = 1 + M + N;

    /// The word with this code, reduced modulo 2^WIDTH.
    #[must_use]
    #[inline(always)]
    pub const fn from_code(code: i64) -> Self {
        Self(wrap(code, Self::WIDTH))
    }

    /// The code: the value in units of 2^−N.
    #[must_use]
    #[inline(always)]
    pub const fn code(self) -> i64 {
        self.0
    }

    /// The real value of the word.
    #[must_use]
    pub fn value(self) -> f64 {
        self.0 as f64 / (1u64 << N) as f64
    }

    /// Bit `index` of the code.
    #[must_use]
    #[inline(always)]
    pub fn get_bit(self, index: usize) -> bool {
        self.0 >> index & 1 == 1
    }

    /// `W` bits of the code from `index` upwards; a slice has no sign.
    #[must_use]
    #[inline(always)]
    pub fn get_bits<const W: usize>(self, index: usize) -> U<W> {
        U::new((self.0 >> index) as u64)
    }
}

/// The code of `value` in Q`m`.`n`, rounded to nearest, halves upwards (error at most half an ulp).
/// `None` when the value is not finite or does not fit: quantisation refuses, it never wraps.
#[must_use]
pub fn quantise(value: f64, m: u32, n: u32) -> Option<i64> {
    assert!(m + n < 64, "formats have at most 64 bits");
    // An f64 of this size is exact in 64.64 unless it is below 2^-64, far under half an ulp.
    let exact = I64F64::checked_from_num(value)?;
    let half = 1i128 << (63 - n);
    let code = (exact.to_bits() + half) >> (64 - n);
    let limit = 1i128 << (m + n);
    (-limit..limit).contains(&code).then_some(code as i64)
}

impl<const M: usize, const N: usize> Synth for Q<M, N> {
    const BITS: usize = 1 + M + N;

    fn descriptor() -> TypeDescriptor {
        TypeDescriptor {
            name: format!("Q{M}.{N}"),
            kind: TypeKind::Signed(Self::WIDTH),
        }
    }

    fn vcd(self) -> VCDValue {
        waveform(self.0 as u64, Self::WIDTH)
    }

    fn verilog(self) -> VerilogLiteral {
        literal(self.0 as u64 & mask(Self::WIDTH), Self::WIDTH)
    }
}

impl<const M: usize, const N: usize> Add for Q<M, N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::from_code(self.0.wrapping_add(other.0))
    }
}

impl<const M: usize, const N: usize> Sub for Q<M, N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::from_code(self.0.wrapping_sub(other.0))
    }
}

impl<const M: usize, const N: usize> Not for Q<M, N> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self::from_code(!self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantisation_rounds_to_nearest_and_refuses_what_does_not_fit() {
        assert_eq!(quantise(1.0, 11, 20), Some(1 << 20));
        assert_eq!(quantise(-0.5, 3, 0), Some(0));
        assert_eq!(quantise(0.5, 3, 0), Some(1));
        assert_eq!(quantise(7.49, 3, 0), Some(7));
        assert_eq!(quantise(7.5, 3, 0), None);
        assert_eq!(quantise(-8.5, 3, 0), Some(-8));
        assert_eq!(quantise(-8.51, 3, 0), None);
        assert_eq!(quantise(f64::NAN, 11, 20), None);
        assert_eq!(quantise(f64::INFINITY, 11, 20), None);
    }

    #[test]
    fn every_code_of_a_small_format_is_its_own_rounding() {
        for code in -128..128i64 {
            let value = code as f64 / 8.0;
            assert_eq!(quantise(value, 4, 3), Some(code));
            assert_eq!(Q::<4, 3>::from_code(code).value(), value);
            for off in [-0.0624, 0.0624] {
                assert_eq!(quantise(value + off, 4, 3), Some(code), "{value} {off}");
            }
        }
    }

    #[test]
    fn sums_are_residues() {
        let top = Q::<4, 3>::from_code(127);
        let one = Q::<4, 3>::from_code(1);
        assert_eq!((top + one).code(), -128);
        assert_eq!((top + one - one).code(), 127);
        assert_eq!((!top).code(), -128);
    }
}
