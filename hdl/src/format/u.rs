//! Unsigned words.

use super::{literal, mask, waveform};
use rust_hdl_core::prelude::*;
use std::ops::{Add, BitAnd, BitOr, BitXor, Not, Shl, Shr, Sub};

/// An unsigned word of `N` bits (1 to 64); arithmetic is modulo 2^N.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct U<const N: usize>(u64);

impl<const N: usize> U<N> {
    /// The low `N` bits of `value`.
    #[must_use]
    #[inline(always)]
    pub const fn new(value: u64) -> Self {
        Self(value & mask(N))
    }

    /// The word as an integer in `0..2^N`.
    #[must_use]
    #[inline(always)]
    pub const fn get(self) -> u64 {
        self.0
    }

    /// Bit `index`, 0 being the least significant.
    #[must_use]
    #[inline(always)]
    pub fn get_bit(self, index: usize) -> bool {
        self.0 >> index & 1 == 1
    }

    /// `M` bits from `index` upwards.
    #[must_use]
    #[inline(always)]
    pub fn get_bits<const M: usize>(self, index: usize) -> U<M> {
        U::new(self.0 >> index)
    }

    /// Whether any bit is set.
    #[must_use]
    #[inline(always)]
    pub fn any(self) -> bool {
        self.0 != 0
    }
}

impl<const N: usize> From<u64> for U<N> {
    #[inline(always)]
    fn from(value: u64) -> Self {
        Self::new(value)
    }
}

impl<const N: usize> Synth for U<N> {
    const BITS: usize = N;

    fn descriptor() -> TypeDescriptor {
        TypeDescriptor {
            name: format!("U{N}"),
            kind: TypeKind::Bits(N),
        }
    }

    fn vcd(self) -> VCDValue {
        waveform(self.0, N)
    }

    fn verilog(self) -> VerilogLiteral {
        literal(self.0, N)
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $with:ident) => {
        impl<const N: usize> $trait for U<N> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self::new(self.0.$with(other.0))
            }
        }
    };
}
operator!(Add, add, wrapping_add);
operator!(Sub, sub, wrapping_sub);
operator!(BitAnd, bitand, bitand);
operator!(BitOr, bitor, bitor);
operator!(BitXor, bitxor, bitxor);

impl<const N: usize> Not for U<N> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self::new(!self.0)
    }
}

macro_rules! shift {
    ($trait:ident, $method:ident, $with:ident) => {
        impl<const N: usize> $trait<u64> for U<N> {
            type Output = Self;
            /// Amounts of `N` or more give zero.
            #[inline(always)]
            fn $method(self, by: u64) -> Self {
                let by = u32::try_from(by).unwrap_or(u32::MAX);
                Self::new(self.0.$with(by).unwrap_or(0))
            }
        }

        impl<const N: usize, const M: usize> $trait<U<M>> for U<N> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, by: U<M>) -> Self {
                $trait::$method(self, by.get())
            }
        }
    };
}
shift!(Shl, shl, checked_shl);
shift!(Shr, shr, checked_shr);
