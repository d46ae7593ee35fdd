//! Eight pixels from the definition, one after the other: for what no other kernel draws.

use super::kernel::{rows_anew, Kernel};
use super::patch::Patch;
use crate::geometry::{Prepared, ScreenTriangle};
use crate::shade::{exact, to_byte};
use fearless_simd::{prelude::*, u32x8, Simd};

/// A triangle drawn from the definition.
pub(super) struct ExactKernel<'a> {
    pub prepared: &'a Prepared,
    pub triangle: &'a ScreenTriangle,
}

impl<S: Simd> Kernel<S> for ExactKernel<'_> {
    type Run = [i32; 2];

    rows_anew!();

    #[inline(always)]
    fn start(&self, _: S, _: [f64; 2], at: [i32; 2]) -> [i32; 2] {
        at
    }

    #[inline(always)]
    fn pixels(&self, simd: S, run: &[i32; 2]) -> u32x8<S> {
        let mut words = [0; 8];
        for (k, word) in words.iter_mut().enumerate() {
            let colour = exact::value(self.prepared, self.triangle, run[0] + k as i32, run[1]);
            *word = super::pack::word(colour.map(to_byte));
        }
        u32x8::simd_from(simd, words)
    }

    #[inline(always)]
    fn advance(&self, run: &mut [i32; 2]) {
        run[0] += 8;
    }
}
