//! Eight numbers at a time: what the renderer and the proofs of `auto` share. Arithmetic is the same for every width of
//! vector registers, so results are the same bits.

pub(crate) mod real;
pub(crate) mod reflect;

/// Runs an expression with vector registers. Of the many generations of x86-64 two are compiled, those with AVX2 and all
/// others: each costs a minute of compilation.
macro_rules! on_vectors {
    ($level:expr, $simd:ident => $work:expr) => {{
        #[cfg(target_arch = "x86_64")]
        if let Some($simd) = $level.as_avx2() {
            $simd.vectorize(
                #[inline(always)]
                || $work,
            )
        } else if let Some($simd) = $level.as_sse2() {
            $simd.vectorize(
                #[inline(always)]
                || $work,
            )
        } else {
            unreachable!("every x86-64 has SSE2")
        }
        #[cfg(not(target_arch = "x86_64"))]
        fearless_simd::dispatch!($level, $simd => $work)
    }};
}
pub(crate) use on_vectors;

/// An array of three, written out: functions that take closures are compiled without the vector instructions.
macro_rules! three {
    ($c:ident => $value:expr) => {{
        let a = {
            let $c = 0usize;
            $value
        };
        let b = {
            let $c = 1usize;
            $value
        };
        let c = {
            let $c = 2usize;
            $value
        };
        [a, b, c]
    }};
}
pub(crate) use three;
