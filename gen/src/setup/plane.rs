//! Register words of a linear interpolant: f = k0 + (k1 − k0)·u + (k2 − k0)·v over the barycentric weights u, v
//! (Hast 2004, 3.176–3.187; Abbas 2003, 4.2), differenced along the walk's lattice steps.

use super::rational::{residue, word};
use super::Frame;

/// The four words of `linear_2` (value, d_pixel, d_line, d_line_carry) for knots in units of 2^−20, in a register of
/// `width` bits with `fraction_bits`; `offset` (in code units) is added to the value.
#[must_use]
pub fn plane_words(
    f: &Frame,
    knots: [i128; 3],
    fraction_bits: u32,
    width: u32,
    offset: i128,
) -> [u64; 4] {
    let (d1, d2) = (knots[1] - knots[0], knots[2] - knots[0]);
    let along = |w: [i128; 2]| word(d1 * w[0] + d2 * w[1], f.area, fraction_bits);
    let value = word(
        knots[0] * f.area + d1 * f.start[0] + d2 * f.start[1],
        f.area,
        fraction_bits,
    ) + offset;
    let (pixel, line) = (along(f.pixel), along(f.line));
    [value, pixel, line, line + pixel].map(|code| residue(code, width))
}
