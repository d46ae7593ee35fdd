//! How eight pixels of a triangle get their colour: constant, linear and quadratic.

use super::fixed::{lanes, three, word, Channels, ONE};
use super::patch::Patch;
use fearless_simd::{i32x8, prelude::*, u32x8, Simd};

/// The colour of a triangle along its rows.
pub(super) trait Kernel<S: Simd> {
    /// What changes along a row.
    type Run: Copy;

    /// The first eight pixels of a run that begins at pixel `at`, where u and v are `uv`.
    fn start(&self, simd: S, uv: [f64; 2], at: [i32; 2]) -> Self::Run;

    /// The run that begins one row lower, at the centre of pixel (`x`, `y`). Used for at most 64 rows.
    #[inline(always)]
    fn below(&self, simd: S, _: Self::Run, patch: &Patch, x: i32, y: i32) -> Self::Run {
        self.start(simd, patch.at(x, y), [x, y])
    }

    /// Their colours, red in the lowest byte.
    fn pixels(&self, simd: S, run: &Self::Run) -> u32x8<S>;

    /// Moves eight pixels to the right.
    fn advance(&self, run: &mut Self::Run);
}

/// One colour.
pub(super) struct Constant<S: Simd>(pub u32x8<S>);

impl<S: Simd> Kernel<S> for Constant<S> {
    type Run = ();

    #[inline(always)]
    fn start(&self, _: S, _: [f64; 2], _: [i32; 2]) {}

    #[inline(always)]
    fn pixels(&self, _: S, (): &()) -> u32x8<S> {
        self.0
    }

    #[inline(always)]
    fn advance(&self, (): &mut ()) {}
}

/// Linear in three channels; `CLAMP` when values may leave 0..=255.
pub(super) struct Linear<S: Simd, const CLAMP: bool> {
    d: [f64; 3],
    e: [f64; 3],
    f: [f64; 3],
    ramp: [i32x8<S>; 3],
    step: [i32x8<S>; 3],
    down: [i32x8<S>; 3],
}

impl<S: Simd, const CLAMP: bool> Linear<S, CLAMP> {
    #[inline(always)]
    pub(super) fn new(simd: S, patch: &Patch, knots: &[[f64; 3]; 3]) -> Self {
        let d = three!(c => (knots[1][c] - knots[0][c]) * ONE);
        let e = three!(c => (knots[2][c] - knots[0][c]) * ONE);
        let step = three!(c => word(d[c] * patch.dx[0] + e[c] * patch.dx[1]));
        let k = lanes(simd);
        Self {
            d,
            e,
            f: three!(c => (knots[0][c] + 0.5) * ONE),
            ramp: three!(c => k * step[c]),
            step: three!(c => i32x8::splat(simd, step[c].wrapping_mul(8))),
            down: three!(c => i32x8::splat(simd, word(d[c] * patch.dy[0] + e[c] * patch.dy[1]))),
        }
    }
}

impl<S: Simd, const CLAMP: bool> Kernel<S> for Linear<S, CLAMP> {
    type Run = Channels<S>;

    #[inline(always)]
    fn start(&self, simd: S, [u, v]: [f64; 2], _: [i32; 2]) -> Channels<S> {
        let at = three!(c => word(self.d[c] * u + self.e[c] * v + self.f[c]));
        Channels::linear(simd, at, &self.ramp, &self.step)
    }

    #[inline(always)]
    fn below(&self, _: S, mut run: Channels<S>, _: &Patch, _: i32, _: i32) -> Channels<S> {
        run.below(&self.down);
        run
    }

    #[inline(always)]
    fn pixels(&self, simd: S, run: &Channels<S>) -> u32x8<S> {
        run.pixels::<CLAMP>(simd)
    }

    #[inline(always)]
    fn advance(&self, run: &mut Channels<S>) {
        run.advance();
    }
}

/// Quadratic in three channels.
pub(super) struct Quadratic<S: Simd, const CLAMP: bool> {
    coefficients: [[f64; 3]; 6],
    du: f64,
    dv: f64,
    /// Half the second difference.
    half: [f64; 3],
    second: [i32; 3],
    s64: [i32x8<S>; 3],
}

impl<S: Simd, const CLAMP: bool> Quadratic<S, CLAMP> {
    /// From knots at vertices 0, 1, 2 and mid-edges 01, 02, 12 (coefficients as in [`crate::shade::differences`]).
    #[inline(always)]
    pub(super) fn new(simd: S, patch: &Patch, knots: &[[f64; 3]; 6]) -> Self {
        let [du, dv] = patch.dx;
        let mut coefficients = [[0.0; 3]; 6];
        let mut half = [0.0; 3];
        for c in 0..3 {
            let k = |i: usize| knots[i][c] * ONE;
            let (i0, i1, i2) = (k(0), k(1), k(2));
            let (i01, i02, i12) = (k(3), k(4), k(5));
            let a = 2.0 * (i0 + i1 - 2.0 * i01);
            let b = 2.0 * (i0 + i2 - 2.0 * i02);
            let m = 4.0 * (i0 + i12 - i01 - i02);
            let d = 4.0 * i01 - 3.0 * i0 - i1;
            let e = 4.0 * i02 - 3.0 * i0 - i2;
            for (k, value) in [a, b, m, d, e, i0 + 0.5 * ONE].into_iter().enumerate() {
                coefficients[k][c] = value;
            }
            half[c] = (a * du + m * dv) * du + b * dv * dv;
        }
        let second = three!(c => word(2.0 * half[c]));
        Self {
            coefficients,
            du,
            dv,
            half,
            second,
            s64: three!(c => i32x8::splat(simd, second[c].wrapping_mul(64))),
        }
    }
}

impl<S: Simd, const CLAMP: bool> Kernel<S> for Quadratic<S, CLAMP> {
    type Run = Channels<S>;

    #[inline(always)]
    fn start(&self, simd: S, [u, v]: [f64; 2], _: [i32; 2]) -> Channels<S> {
        let [a, b, m, d, e, f] = &self.coefficients;
        let (mut value, mut first) = ([0; 3], [0; 3]);
        for c in 0..3 {
            let (pu, pv) = (a[c] * u + d[c], b[c] * v + e[c]);
            let cross = m[c] * v;
            value[c] = word((pu + cross) * u + pv * v + f[c]);
            let alongu = pu + a[c] * u + cross;
            let alongv = pv + b[c] * v + m[c] * u;
            first[c] = word(alongu * self.du + alongv * self.dv + self.half[c]);
        }
        Channels::quadratic(simd, value, first, self.second)
    }

    #[inline(always)]
    fn pixels(&self, simd: S, run: &Channels<S>) -> u32x8<S> {
        run.pixels::<CLAMP>(simd)
    }

    #[inline(always)]
    fn advance(&self, run: &mut Channels<S>) {
        run.advance_twice(&self.s64);
    }
}
