//! Eight real numbers at a time: powers, unit lengths, bytes.

use super::three;
use fearless_simd::{f32x8, i32x8, prelude::*, u32x8, Simd};

/// A vector per lane.
pub(crate) type Vector<S> = [f32x8<S>; 3];

/// 0, 1, … 7 as numbers.
#[inline(always)]
pub(crate) fn ramp<S: Simd>(simd: S) -> f32x8<S> {
    f32x8::simd_from(simd, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0])
}

/// The same number in all lanes.
#[inline(always)]
pub(crate) fn splat<S: Simd>(simd: S, v: f64) -> f32x8<S> {
    f32x8::splat(simd, v as f32)
}

/// The same vector in all lanes.
#[inline(always)]
pub(crate) fn vector<S: Simd>(simd: S, v: glam::DVec3) -> Vector<S> {
    [splat(simd, v.x), splat(simd, v.y), splat(simd, v.z)]
}

#[inline(always)]
pub(crate) fn dot<S: Simd>(a: &Vector<S>, b: &Vector<S>) -> f32x8<S> {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// 1/|v|; 0 for the zero vector.
#[inline(always)]
pub(crate) fn inverse_length<S: Simd>(simd: S, v: &Vector<S>) -> f32x8<S> {
    let square = dot(v, v);
    let tiny = f32x8::splat(simd, 1e-30);
    square.simd_gt(tiny).select(
        f32x8::splat(simd, 1.0) / square.sqrt(),
        f32x8::splat(simd, 0.0),
    )
}

/// max(0, x)ⁿ for x up to 1 and n ≥ 0; 0 where x ≤ 0. Relative error below 2⁻²¹ + n·(1 + |log₂ x|)·2⁻²³: 2^(n·log₂ x) with
/// log₂ m = 2/ln 2·artanh((m − 1)/(m + 1)) for m in √½..√2 and a polynomial for 2^f, |f| ≤ ½.
#[inline(always)]
pub(crate) fn power<S: Simd>(simd: S, x: f32x8<S>, n: f32x8<S>) -> f32x8<S> {
    const HALF_ROOT: i32 = 0x3f35_04f3;
    let bits: i32x8<S> = x.bitcast();
    let from = bits - i32x8::splat(simd, HALF_ROOT);
    let exponent = f32x8::float_from(from >> 23);
    let significand = (from & i32x8::splat(simd, 0x007f_ffff)) + i32x8::splat(simd, HALF_ROOT);
    let m: f32x8<S> = significand.bitcast();
    let one = f32x8::splat(simd, 1.0);
    let s = (m - one) / (m + one);
    let s2 = s * s;
    let series = ((s2 * 0.412_198_58 + 0.577_078_04) * s2 + 0.961_796_7) * s2 + 2.885_39;
    let y = n * (exponent + s * series);
    let y = y.max(f32x8::splat(simd, -126.0));
    // Rounds to nearest: the sum has no room for a fraction.
    let shift = f32x8::splat(simd, 12_582_912.0);
    let whole = (y + shift) - shift;
    let f = y - whole;
    let mut p = f * 0.000_154_035_3 + 0.001_333_355_8;
    p = p * f + 0.009_618_129;
    p = p * f + 0.055_504_11;
    p = p * f + 0.240_226_5;
    p = p * f + std::f32::consts::LN_2;
    p = p * f + 1.0;
    let scale: i32x8<S> = i32x8::truncate_from(whole) << 23;
    let result: f32x8<S> = (p.bitcast::<i32x8<S>>() + scale).bitcast();
    x.simd_gt(f32x8::splat(simd, 0.0))
        .select(result, f32x8::splat(simd, 0.0))
}

/// An exponent for many powers.
#[derive(Clone, Copy)]
pub(crate) enum Exponent<S: Simd> {
    /// A whole number, and the base whose power is 2⁻⁶⁰: lesser ones count as that, so that no product is subnormal.
    Whole(u32, f32x8<S>),
    /// Any other.
    Real(f32x8<S>),
}

impl<S: Simd> Exponent<S> {
    /// For n ≥ 0.
    #[inline(always)]
    pub(crate) fn new(simd: S, n: f64) -> Self {
        if n > 0.0 && n <= 1024.0 && n.fract() == 0.0 {
            Self::Whole(n as u32, splat(simd, (-60.0 / n).exp2()))
        } else {
            Self::Real(splat(simd, n))
        }
    }

    /// max(0, x)ⁿ for x up to 1, by squaring or by [`power`]; relative error below 2⁻²¹ + n·(1 + |log₂ x|)·2⁻²³, or less than
    /// 2⁻⁵⁹ in all.
    #[inline(always)]
    pub(crate) fn of(&self, simd: S, x: f32x8<S>) -> f32x8<S> {
        match *self {
            Self::Whole(n, least) => {
                let mut square = x.max(least);
                // The first factor, without a product by one.
                let mut rest = n;
                while rest & 1 == 0 {
                    square *= square;
                    rest >>= 1;
                }
                let mut result = square;
                rest >>= 1;
                while rest != 0 {
                    square *= square;
                    if rest & 1 == 1 {
                        result *= square;
                    }
                    rest >>= 1;
                }
                let zero = f32x8::splat(simd, 0.0);
                x.simd_gt(zero).select(result, zero)
            }
            Self::Real(n) => power(simd, x, n),
        }
    }
}

/// The pixels of three channels in LSB: rounded, limited, red in the lowest byte.
#[inline(always)]
pub(crate) fn pixels<S: Simd>(simd: S, colour: &Vector<S>) -> u32x8<S> {
    let (low, high) = (f32x8::splat(simd, 0.5), f32x8::splat(simd, 255.5));
    let bytes: [i32x8<S>; 3] = three!(c => {
        i32x8::truncate_from((colour[c] + low).max(f32x8::splat(simd, 0.0)).min(high))
    });
    (bytes[0] | (bytes[1] << 8) | (bytes[2] << 16)).bitcast()
}

/// A vector that grows linearly along a row.
#[derive(Clone, Copy)]
pub(crate) struct Walk<S: Simd> {
    value: Vector<S>,
    step: Vector<S>,
}

impl<S: Simd> Walk<S> {
    /// From the value at the first pixel and its change per pixel.
    #[inline(always)]
    pub(crate) fn new(simd: S, at: glam::DVec3, step: glam::DVec3) -> Self {
        let (k, at, step) = (ramp(simd), vector(simd, at), vector(simd, step));
        Self {
            value: three!(c => at[c] + k * step[c]),
            step: three!(c => step[c] * 8.0),
        }
    }

    #[inline(always)]
    pub(crate) fn value(&self) -> &Vector<S> {
        &self.value
    }

    #[inline(always)]
    pub(crate) fn advance(&mut self) {
        self.value = three!(c => self.value[c] + self.step[c]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fearless_simd::{dispatch, Level};

    #[inline(always)]
    fn powers<S: Simd>(simd: S, x: [f32; 8], n: f32, whole: bool) -> [f32; 8] {
        let x = f32x8::simd_from(simd, x);
        let n = f64::from(n);
        let way = if whole {
            Exponent::new(simd, n)
        } else {
            Exponent::Real(splat(simd, n))
        };
        way.of(simd, x).to_array()
    }

    #[test]
    fn powers_are_powers() {
        for (level, whole) in [
            (Level::new(), false),
            (Level::baseline(), false),
            (Level::new(), true),
            (Level::baseline(), true),
        ] {
            for n in [
                0.0f32, 0.5, 1.0, 3.0, 5.0, 20.0, 50.0, 64.0, 100.0, 500.0, 1023.0, 10_000.0,
            ] {
                for i in 0..20_000 {
                    let x = [0, 1, 2, 3, 4, 5, 6, 7].map(|k| (i * 8 + k) as f32 / 160_000.0);
                    let got = dispatch!(level, simd => powers(simd, x, n, whole));
                    for (g, x) in got.into_iter().zip(x) {
                        let want = if x > 0.0 {
                            f64::from(x).powf(f64::from(n))
                        } else {
                            0.0
                        };
                        let steep = f64::from(n) * (1.0 + f64::from(x).max(1e-38).log2().abs());
                        let bound =
                            want * (2f64.powi(-21) + steep * 2f64.powi(-23)) + 2f64.powi(-59);
                        assert!(
                            (f64::from(g) - want).abs() <= bound,
                            "{x}^{n} = {g}, not {want}"
                        );
                    }
                }
                let odd = [
                    -1.0,
                    -0.0,
                    0.0,
                    1.0,
                    1e-38,
                    -1e30,
                    f32::MIN_POSITIVE,
                    0.999_999_9,
                ];
                let got = dispatch!(level, simd => powers(simd, odd, n, whole));
                assert_eq!((got[0], got[1], got[2], got[3]), (0.0, 0.0, 0.0, 1.0));
                assert!(got.iter().all(|v| (0.0..=1.0).contains(v)), "{got:?}");
            }
        }
    }
}
