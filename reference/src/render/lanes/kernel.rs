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
    coefficients: [[f64; 3]; 6],
    du: f64,
    dv: f64,
    /// Half the second difference.
    half: [f64; 3],
    second: [i32; 3],
    s64: [i32x8<S>; 3],
    /// Half the second difference downwards, and the mixed one.
    half_down: [f64; 3],
    dy: [f64; 2],
    mixed: [i32; 3],
    mixed8: [i32x8<S>; 3],
    second_down: [i32x8<S>; 3],
}

impl<S: Simd, const CLAMP: bool> Quadratic<S, CLAMP> {
    /// From knots at vertices 0, 1, 2 and mid-edges 01, 02, 12 (coefficients as in [`crate::shade::differences`]).
    #[inline(always)]
    pub(super) fn new(simd: S, patch: &Patch, knots: &[[f64; 3]; 6]) -> Self {
        let ([du, dv], [eu, ev]) = (patch.dx, patch.dy);
        let mut coefficients = [[0.0; 3]; 6];
        let (mut half, mut half_down, mut mixed) = ([0.0; 3], [0.0; 3], [0; 3]);
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
            half_down[c] = (a * eu + m * ev) * eu + b * ev * ev;
            mixed[c] = word(2.0 * (a * du * eu + b * dv * ev) + m * (du * ev + dv * eu));
        }
        let second = three!(c => word(2.0 * half[c]));
        Self {
            coefficients,
            du,
            dv,
            half,
            second,
            half_down,
            dy: patch.dy,
            mixed,
            mixed8: three!(c => i32x8::splat(simd, mixed[c].wrapping_mul(8))),
            second_down: three!(c => i32x8::splat(simd, word(2.0 * half_down[c]))),
            s64: three!(c => i32x8::splat(simd, second[c].wrapping_mul(64))),
        }
    }
}

impl<S: Simd, const CLAMP: bool> Kernel<S> for Quadratic<S, CLAMP> {
    type Run = Channels<S>;
    type Row = (Channels<S>, [i32x8<S>; 3]);

    #[inline(always)]
    fn first_row(&self, simd: S, patch: &Patch, at: [i32; 2]) -> Self::Row {
        let [u, v] = patch.at(at[0], at[1]);
        let [a, b, m, d, e, _] = &self.coefficients;
        let k = lanes(simd);
        let down = three!(c => {
            let alongu = 2.0 * a[c] * u + m[c] * v + d[c];
            let alongv = 2.0 * b[c] * v + m[c] * u + e[c];
            let first = word(alongu * self.dy[0] + alongv * self.dy[1] + self.half_down[c]);
            i32x8::splat(simd, first) + k * self.mixed[c]
        });
        (self.start(simd, [u, v], at), down)
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
