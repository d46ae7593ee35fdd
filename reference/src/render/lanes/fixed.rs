//! Colours along a row in fixed point: eight pixels at a time, additions only.
//!
//! A channel is a 32-bit word with [`FRACTION`] fraction bits, ½ added once at the start. Lane k of a block starts at
//! v + k·d + k(k − 1)/2·s; the next block adds 8·d + (28 + 8k)·s, which itself grows by 64·s: one addition per eight
//! pixels and channel when s = 0, two otherwise. A run starts anew from real numbers every [`RUN`] pixels, so rounding
//! v, d and s (half a unit each) adds up to at most ½·(1 + 63 + 63·62/2)·2⁻¹⁹ < 0.002 LSB. Small triangles, of up to 16
//! by 64 pixels, are stepped downwards in the same way, with a mixed difference: < ½·(1 + 2·(63 + 63·62/2) + 15·63)·2⁻¹⁹
//! < 0.005 LSB. Sums wrap; a value that is in range comes out right whatever its registers did in between.

use crate::simd::three;
use fearless_simd::{f64x4, i32x8, prelude::*, u32x8, Simd};

/// Pixels from one start to the next at most.
pub(super) const RUN: i32 = 64;
/// Fraction bits of a channel. Values up to 5/3 of the largest knot (2550) need 12 bits and a sign before them.
pub(super) const FRACTION: u32 = 19;
/// One LSB.
pub(super) const ONE: f64 = (1u32 << FRACTION) as f64;

/// The word of a scaled number: rounded to nearest, modulo 2³². Exact for numbers below 2⁵¹.
#[inline(always)]
pub(super) fn word(scaled: f64) -> i32 {
    (scaled + ROUND).to_bits() as u32 as i32
}

/// Three channels in real numbers; the fourth lane is not used.
pub(super) type Real<S> = f64x4<S>;

/// The same number for each channel.
#[inline(always)]
pub(super) fn all<S: Simd>(simd: S, v: f64) -> Real<S> {
    f64x4::splat(simd, v)
}

/// Three channels.
#[inline(always)]
pub(super) fn real<S: Simd>(simd: S, v: [f64; 3]) -> Real<S> {
    f64x4::simd_from(simd, [v[0], v[1], v[2], 0.0])
}

/// The [`word`] of every channel.
#[inline(always)]
pub(super) fn words<S: Simd>(simd: S, scaled: Real<S>) -> [i32; 3] {
    let sum = (scaled + all(simd, ROUND)).to_array();
    three!(c => sum[c].to_bits() as u32 as i32)
}

/// 1.5·2⁵²: added to a number it leaves the integer in the low bits of the significand.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// 0, 1, … 7.
#[inline(always)]
pub(super) fn lanes<S: Simd>(simd: S) -> i32x8<S> {
    i32x8::simd_from(simd, [0, 1, 2, 3, 4, 5, 6, 7])
}

/// The state of three channels for eight pixels.
#[derive(Clone, Copy)]
pub(super) struct Channels<S: Simd> {
    value: [i32x8<S>; 3],
    step: [i32x8<S>; 3],
}

impl<S: Simd> Channels<S> {
    /// Linear: values at the first pixel, offsets of the lanes and steps of a block.
    #[inline(always)]
    pub(super) fn linear(simd: S, v: [i32; 3], ramp: &[i32x8<S>; 3], step: &[i32x8<S>; 3]) -> Self {
        Self {
            value: three!(c => i32x8::splat(simd, v[c]) + ramp[c]),
            step: *step,
        }
    }

    /// Quadratic: value, first difference and second difference at the first pixel.
    #[inline(always)]
    pub(super) fn quadratic(simd: S, v: [i32; 3], d: [i32; 3], s: [i32; 3]) -> Self {
        let k = lanes(simd);
        let pairs = i32x8::simd_from(simd, [0, 0, 1, 3, 6, 10, 15, 21]);
        let block = i32x8::simd_from(simd, [28, 36, 44, 52, 60, 68, 76, 84]);
        Self {
            value: three!(c => {
                let (first, second) = (i32x8::splat(simd, d[c]), i32x8::splat(simd, s[c]));
                i32x8::splat(simd, v[c]) + k * first + pairs * second
            }),
            step: three!(c => {
                let (first, second) = (i32x8::splat(simd, d[c]), i32x8::splat(simd, s[c]));
                (first << 3) + block * second
            }),
        }
    }

    /// Moves eight pixels to the right, linear.
    #[inline(always)]
    pub(super) fn advance(&mut self) {
        self.value = three!(c => self.value[c] + self.step[c]);
    }

    /// Moves down one row, linear.
    #[inline(always)]
    pub(super) fn below(&mut self, down: &[i32x8<S>; 3]) {
        self.value = three!(c => self.value[c] + down[c]);
    }

    /// Moves down one row, quadratic: `down` is the change of every lane, `mixed` eight times what a step changes by.
    #[inline(always)]
    pub(super) fn below_twice(&mut self, down: &[i32x8<S>; 3], mixed: &[i32x8<S>; 3]) {
        self.value = three!(c => self.value[c] + down[c]);
        self.step = three!(c => self.step[c] + mixed[c]);
    }

    /// Moves eight pixels to the right, quadratic; `s64` is 64 times the second difference.
    #[inline(always)]
    pub(super) fn advance_twice(&mut self, s64: &[i32x8<S>; 3]) {
        self.value = three!(c => self.value[c] + self.step[c]);
        self.step = three!(c => self.step[c] + s64[c]);
    }

    /// The pixels: red in the lowest byte. `clamp` limits to 0..=255; without it, all values must be in range.
    #[inline(always)]
    pub(super) fn pixels<const CLAMP: bool>(&self, simd: S) -> u32x8<S> {
        let top = i32x8::splat(simd, (256 << FRACTION) - 1);
        let zero = i32x8::splat(simd, 0);
        let [r, g, b] = three!(c => {
            let v = self.value[c];
            let v = if CLAMP { v.max(zero).min(top) } else { v };
            v >> FRACTION
        });
        let packed = r | (g << 8) | (b << 16);
        packed.bitcast()
    }
}
