//! Conversions between formats. In a description each stands alone on the right of an assignment, so that the target's
//! type says what is meant and the Verilog can be written without any context-dependent width.

use super::{Q, U};

/// Zero-extends or truncates an unsigned word.
#[must_use]
#[inline(always)]
pub fn bit_cast_u<const TO: usize, const FROM: usize>(x: U<FROM>) -> U<TO> {
    U::new(x.get())
}

/// Takes the low bits of a bus word as a code of the target format; the bus must be at least as wide.
#[must_use]
#[inline(always)]
pub fn signed_cast_bits<const M: usize, const N: usize, const FROM: usize>(x: U<FROM>) -> Q<M, N> {
    Q::from_code(x.get() as i64)
}

/// Aligns the binary point: drops fraction bits (rounding towards minus infinity) or appends zeros, and sign-extends or
/// drops integer bits (modulo 2^(1+TM+TN), as sums are).
#[must_use]
#[inline(always)]
pub fn signed_cast_align<const TM: usize, const TN: usize, const M: usize, const N: usize>(
    x: Q<M, N>,
) -> Q<TM, TN> {
    Q::from_code(if TN >= N {
        x.code() << (TN - N)
    } else {
        x.code() >> (N - TN)
    })
}

/// The low `TO` integer bits (rounding towards minus infinity), as an unsigned word.
#[must_use]
#[inline(always)]
pub fn unsigned_cast_integer<const TO: usize, const M: usize, const N: usize>(x: Q<M, N>) -> U<TO> {
    U::new((x.code() >> N) as u64)
}
