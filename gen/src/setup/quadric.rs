//! Register words of a six-knot quadric, set up directly as forward differences: no polynomial in x and y is formed.
//!
//! Over the barycentric weights u (vertex 1) and v (vertex 2)
//!   f = k0 + d·u + e·v + a·u² + b·v² + c·u·v,
//!   a = 2(k0 + k1 − 2k01), b = 2(k0 + k2 − 2k02), c = 4(k0 + k12 − k01 − k02), d = k1 − k0 − a, e = k2 − k0 − b
//! (Hast 2004, section 3.3.3, the ortho-normalised triangle). For a lattice step with weight changes (δu, δv)
//!   first difference  D(u, v) = d·δu + e·δv + a(2u·δu + δu²) + b(2v·δv + δv²) + c(u·δv + v·δu + δu·δv),
//!   second difference of two steps  2a·δu·δu' + 2b·δv·δv' + c(δu·δv' + δv·δu').
//! Hast's direct set-up (3.213–3.233) is the case of a real edge slope; lattice steps keep all samples on centres.
//! Abbas' 7.3 and 7.4 divide by the height of an edge and fail when two vertices are level; only zero area does here.

use super::rational::{residue, word};
use super::Frame;

struct Quadric {
    k0: i128,
    a: i128,
    b: i128,
    c: i128,
    d: i128,
    e: i128,
}

impl Quadric {
    fn new(k: [i128; 6]) -> Self {
        let [k0, k1, k2, k01, k02, k12] = k;
        let a = 2 * (k0 + k1 - 2 * k01);
        let b = 2 * (k0 + k2 - 2 * k02);
        let c = 4 * (k0 + k12 - k01 - k02);
        Self {
            k0,
            a,
            b,
            c,
            d: k1 - k0 - a,
            e: k2 - k0 - b,
        }
    }

    /// f, times the squared area.
    fn value(&self, f: &Frame) -> i128 {
        let [u, v] = f.start;
        self.k0 * f.area * f.area
            + (self.d * u + self.e * v) * f.area
            + self.a * u * u
            + self.b * v * v
            + self.c * u * v
    }

    /// First difference at the start, times the squared area.
    fn first(&self, f: &Frame, [s, t]: [i128; 2]) -> i128 {
        let [u, v] = f.start;
        (self.d * s + self.e * t) * f.area
            + self.a * (2 * u * s + s * s)
            + self.b * (2 * v * t + t * t)
            + self.c * (u * t + v * s + s * t)
    }

    /// Second difference, times the squared area.
    fn second(&self, [s, t]: [i128; 2], [s2, t2]: [i128; 2]) -> i128 {
        2 * self.a * s * s2 + 2 * self.b * t * t2 + self.c * (s * t2 + t * s2)
    }
}

/// The ten words of `quadratic_2` for knots (vertices 0, 1, 2, mid-edges 01, 02, 12) in units of 2^−20, in a register
/// of `width` bits with `fraction_bits`; `offset` (in code units) is added to the value.
///
/// Magnitudes: knots below 2^31 units give coefficients below 2^35; weights below 2^42 for coordinates within the
/// core's range; so sums stay below 2^122 and 128-bit integers never overflow.
#[must_use]
pub fn quadric_words(
    f: &Frame,
    knots: [i128; 6],
    fraction_bits: u32,
    width: u32,
    offset: i128,
) -> [u64; 10] {
    let q = Quadric::new(knots);
    let square = f.area * f.area;
    let code = |numerator: i128| word(numerator, square, fraction_bits);
    let value = code(q.value(f)) + offset;
    let (d_pixel, d_line) = (code(q.first(f, f.pixel)), code(q.first(f, f.line)));
    let dd_pixel = code(q.second(f.pixel, f.pixel));
    let dd_pixel_line = code(q.second(f.pixel, f.line));
    let dd_line = code(q.second(f.line, f.line));
    // The carrying step is line plus pixel; these sums keep all paths on one quadric.
    let d_line_carry = d_line + d_pixel + dd_pixel_line;
    let dd_pixel_carry = dd_pixel_line + dd_pixel;
    let dd_line_carry = dd_line + dd_pixel_line;
    let dd_carry = dd_line_carry + dd_pixel_carry;
    [
        value,
        d_pixel,
        d_line,
        d_line_carry,
        dd_pixel,
        dd_pixel_line,
        dd_pixel_carry,
        dd_line,
        dd_line_carry,
        dd_carry,
    ]
    .map(|code| residue(code, width))
}
