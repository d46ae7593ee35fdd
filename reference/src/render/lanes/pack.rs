//! Pixels as words and as bytes.

use fearless_simd::{prelude::*, u32x4, u8x16, Simd};

/// A colour as a word, red in the lowest byte.
pub(super) fn word([r, g, b]: [u8; 3]) -> u32 {
    u32::from_le_bytes([r, g, b, 0])
}

/// Drops the fourth byte of every pixel: four pixels become twelve bytes. Sixteen are written and the next store begins
/// four bytes earlier, so the last pixels of a row are done one by one.
#[inline(always)]
pub(super) fn row<S: Simd>(simd: S, words: &[u32], out: &mut [[u8; 3]]) {
    let order = u8x16::simd_from(
        simd,
        [0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 15, 15, 15, 15],
    );
    let bytes = out.as_flattened_mut();
    let mut done = 0;
    while done + 8 <= words.len() {
        let four: u8x16<S> = u32x4::from_slice(simd, &words[done..done + 4]).bitcast();
        four.swizzle_dyn(order)
            .store_slice(&mut bytes[3 * done..3 * done + 16]);
        done += 4;
    }
    for (word, pixel) in words[done..].iter().zip(&mut out[done..]) {
        let [r, g, b, _] = word.to_le_bytes();
        *pixel = [r, g, b];
    }
}
