//! How eight pixels of a triangle get their colour: constant, linear and quadratic.

use super::fixed::{lanes, real, words, Channels, Real, ONE};
use super::patch::Patch;
use crate::simd::three;
use fearless_simd::{i32x8, prelude::*, u32x8, Simd};

/// The colour of a triangle along its rows.
pub(super) trait Kernel<S: Simd> {
    /// What changes along a row.
    type Run: Copy;

    /// The first eight pixels of a run that begins at pixel `at`, where u and v are `uv`.
    fn start(&self, simd: S, uv: [f64; 2], at: [i32; 2]) -> Self::Run;

    /// What changes from row to row of a small triangle.
    type Row: Copy;

    /// The row of a small triangle that begins at pixel `at`.
    fn first_row(&self, simd: S, patch: &Patch, at: [i32; 2]) -> Self::Row;

    /// The run at the beginning of a row.
    fn run(&self, simd: S, patch: &Patch, row: &Self::Row) -> Self::Run;

    /// Moves down one row; at most 64 times.
    fn next_row(&self, row: &mut Self::Row);

    /// Their colours, red in the lowest byte.
    fn pixels(&self, simd: S, run: &Self::Run) -> u32x8<S>;

    /// Moves eight pixels to the right.
    fn advance(&self, run: &mut Self::Run);
}

/// Rows of kernels that start each of them anew.
macro_rules! rows_anew {
    () => {
        type Row = [i32; 2];

        #[inline(always)]
        fn first_row(&self, _: S, _: &Patch, at: [i32; 2]) -> [i32; 2] {
            at
        }

        #[inline(always)]
        fn run(&self, simd: S, patch: &Patch, row: &[i32; 2]) -> Self::Run {
            self.start(simd, patch.at(row[0], row[1]), *row)
        }

        #[inline(always)]
        fn next_row(&self, row: &mut [i32; 2]) {
            row[1] += 1;
        }
    };
}
pub(super) use rows_anew;

/// One colour.
pub(super) struct Constant<S: Simd>(pub u32x8<S>);

impl<S: Simd> Kernel<S> for Constant<S> {
    type Run = ();

    rows_anew!();

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
    d: Real<S>,
    e: Real<S>,
    f: Real<S>,
    ramp: [i32x8<S>; 3],
    step: [i32x8<S>; 3],
    down: [i32x8<S>; 3],
}

impl<S: Simd, const CLAMP: bool> Linear<S, CLAMP> {
    #[inline(always)]
    pub(super) fn new(simd: S, patch: &Patch, knots: &[[f64; 3]; 3]) -> Self {
        let k = three!(i => real(simd, knots[i]) * ONE);
        let (d, e) = (k[1] - k[0], k[2] - k[0]);
        let along = |to: [f64; 2]| d * to[0] + e * to[1];
        let step = words(simd, along(patch.dx));
        let down = words(simd, along(patch.dy));
        let lane = lanes(simd);
        Self {
            d,
            e,
            f: k[0] + 0.5 * ONE,
            ramp: three!(c => lane * step[c]),
            step: three!(c => i32x8::splat(simd, step[c].wrapping_mul(8))),
            down: three!(c => i32x8::splat(simd, down[c])),
        }
    }
}

impl<S: Simd, const CLAMP: bool> Kernel<S> for Linear<S, CLAMP> {
    type Run = Channels<S>;

    #[inline(always)]
    fn start(&self, simd: S, [u, v]: [f64; 2], _: [i32; 2]) -> Channels<S> {
        let at = words(simd, self.d * u + self.e * v + self.f);
        Channels::linear(simd, at, &self.ramp, &self.step)
    }

    type Row = Channels<S>;

    #[inline(always)]
    fn first_row(&self, simd: S, patch: &Patch, at: [i32; 2]) -> Channels<S> {
        self.start(simd, patch.at(at[0], at[1]), at)
    }

    #[inline(always)]
    fn run(&self, _: S, _: &Patch, row: &Channels<S>) -> Channels<S> {
        *row
    }

    #[inline(always)]
    fn next_row(&self, row: &mut Channels<S>) {
        row.below(&self.down);
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
    /// a, b, m, d, e, f of a·u² + b·v² + m·uv + d·u + e·v + f.
    coefficients: [Real<S>; 6],
    dx: [f64; 2],
    dy: [f64; 2],
    /// Half the second difference across and down.
    half: Real<S>,
    half_down: Real<S>,
    second: [i32; 3],
    s64: [i32x8<S>; 3],
    mixed: [i32; 3],
    mixed8: [i32x8<S>; 3],
    second_down: [i32x8<S>; 3],
}

impl<S: Simd, const CLAMP: bool> Quadratic<S, CLAMP> {
    /// From knots at vertices 0, 1, 2 and mid-edges 01, 02, 12 (coefficients as in [`crate::shade::differences`]).
    #[inline(always)]
    pub(super) fn new(simd: S, patch: &Patch, knots: &[[f64; 3]; 6]) -> Self {
        let [i0, i1, i2] = three!(i => real(simd, knots[i]) * ONE);
        let [i01, i02, i12] = three!(i => real(simd, knots[3 + i]) * ONE);
        let ([du, dv], [eu, ev]) = (patch.dx, patch.dy);
        let a = (i0 + i1 - i01 * 2.0) * 2.0;
        let b = (i0 + i2 - i02 * 2.0) * 2.0;
        let m = (i0 + i12 - i01 - i02) * 4.0;
        let d = i01 * 4.0 - i0 * 3.0 - i1;
        let e = i02 * 4.0 - i0 * 3.0 - i2;
        let half = a * (du * du) + m * (du * dv) + b * (dv * dv);
        let half_down = a * (eu * eu) + m * (eu * ev) + b * (ev * ev);
        let both = a * (2.0 * du * eu) + b * (2.0 * dv * ev) + m * (du * ev + dv * eu);
        let second = words(simd, half * 2.0);
        let down = words(simd, half_down * 2.0);
        let mixed = words(simd, both);
        Self {
            coefficients: [a, b, m, d, e, i0 + 0.5 * ONE],
            dx: patch.dx,
            dy: patch.dy,
            half,
            half_down,
            second,
            s64: three!(c => i32x8::splat(simd, second[c].wrapping_mul(64))),
            mixed,
            mixed8: three!(c => i32x8::splat(simd, mixed[c].wrapping_mul(8))),
            second_down: three!(c => i32x8::splat(simd, down[c])),
        }
    }

    /// The value at u, v and the first differences in two directions.
    #[inline(always)]
    fn at(&self, [u, v]: [f64; 2]) -> (Real<S>, Real<S>, Real<S>) {
        let [a, b, m, d, e, f] = self.coefficients;
        let (au, bv) = (a * u, b * v);
        let (pu, pv) = (au + m * v + d, bv + e);
        (pu * u + pv * v + f, pu + au, pv + bv + m * u)
    }
}

impl<S: Simd, const CLAMP: bool> Kernel<S> for Quadratic<S, CLAMP> {
    type Run = Channels<S>;
    type Row = (Channels<S>, [i32x8<S>; 3]);

    #[inline(always)]
    fn first_row(&self, simd: S, patch: &Patch, at: [i32; 2]) -> Self::Row {
        let uv = patch.at(at[0], at[1]);
        let (_, along_u, along_v) = self.at(uv);
        let first = along_u * self.dy[0] + along_v * self.dy[1] + self.half_down;
        let first = words(simd, first);
        let k = lanes(simd);
        let down = three!(c => i32x8::splat(simd, first[c]) + k * self.mixed[c]);
        (self.start(simd, uv, at), down)
    }

    #[inline(always)]
    fn run(&self, _: S, _: &Patch, row: &Self::Row) -> Channels<S> {
        row.0
    }

    #[inline(always)]
    fn next_row(&self, row: &mut Self::Row) {
        row.0.below_twice(&row.1, &self.mixed8);
        row.1 = three!(c => row.1[c] + self.second_down[c]);
    }

    #[inline(always)]
    fn start(&self, simd: S, uv: [f64; 2], _: [i32; 2]) -> Channels<S> {
        let (value, along_u, along_v) = self.at(uv);
        let first = along_u * self.dx[0] + along_v * self.dx[1] + self.half;
        Channels::quadratic(simd, words(simd, value), words(simd, first), self.second)
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
