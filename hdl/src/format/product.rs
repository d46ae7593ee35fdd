//! Products: whole, before a format is chosen for them.
//!
//! A product of two words has as many bits as both together, more than the formats hold, so it is a value and not a
//! signal: it is converted at once, `signed_cast_product::<M, N>(a * b)`, to a word that keeps the wanted bits. In
//! hardware this is a multiplier whose product is taken whole and then sliced, which is what a DSP block does.

use super::{Q, U};
use std::ops::Mul;

/// The product of two fixed-point words: its code, and how many of its bits are fraction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SignedProduct {
    code: i128,
    fraction: usize,
}

/// The product of two unsigned words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnsignedProduct(u128);

impl<const M1: usize, const N1: usize, const M2: usize, const N2: usize> Mul<Q<M2, N2>>
    for Q<M1, N1>
{
    type Output = SignedProduct;
    #[inline(always)]
    fn mul(self, other: Q<M2, N2>) -> SignedProduct {
        SignedProduct {
            code: i128::from(self.code()) * i128::from(other.code()),
            fraction: N1 + N2,
        }
    }
}

impl<const A: usize, const B: usize> Mul<U<B>> for U<A> {
    type Output = UnsignedProduct;
    #[inline(always)]
    fn mul(self, other: U<B>) -> UnsignedProduct {
        UnsignedProduct(u128::from(self.get()) * u128::from(other.get()))
    }
}

/// The product with its binary point moved: fraction bits are dropped (rounding towards minus infinity) or appended,
/// integer bits beyond the format are dropped (modulo 2^(1+M+N), as sums are).
#[must_use]
#[inline(always)]
pub fn signed_cast_product<const M: usize, const N: usize>(x: SignedProduct) -> Q<M, N> {
    let code = if x.fraction >= N {
        x.code >> (x.fraction - N)
    } else {
        x.code << (N - x.fraction)
    };
    Q::from_code(code as i64)
}

/// The low bits of the product.
#[must_use]
#[inline(always)]
pub fn bit_cast_product<const N: usize>(x: UnsignedProduct) -> U<N> {
    U::new(x.0 as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_product_of_a_small_format_is_rounded_down() {
        for a in -32..32i64 {
            for b in -32..32i64 {
                let product = Q::<2, 3>::from_code(a) * Q::<2, 3>::from_code(b);
                let value = (a as f64 / 8.0) * (b as f64 / 8.0);
                assert_eq!(signed_cast_product::<5, 6>(product).value(), value);
                assert_eq!(
                    signed_cast_product::<5, 2>(product).value(),
                    (value * 4.0).floor() / 4.0
                );
                let wrapped = ((value.floor() as i64 + 4).rem_euclid(8) - 4) as f64;
                assert_eq!(signed_cast_product::<2, 0>(product).value(), wrapped);
            }
        }
    }

    #[test]
    fn unsigned_products_keep_low_bits() {
        let product = U::<40>::new((1 << 40) - 1) * U::<40>::new((1 << 40) - 1);
        assert_eq!(bit_cast_product::<8>(product).get(), 1);
        assert_eq!(
            bit_cast_product::<63>(product).get(),
            ((1u128 << 80) - (1 << 41) + 1) as u64 & ((1 << 63) - 1)
        );
    }
}
