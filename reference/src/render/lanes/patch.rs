//! The affine frame of a triangle: u = λ₁ and v = λ₂ at pixel centres, as plane equations from a pixel of its own
//! bounding box, so that the start of every row costs a few multiplications and no division.
//!
//! With U = max |∂u/∂x|, |∂u/∂y| (v likewise) and a bounding box of n pixels, u at a covered pixel is the sum of two
//! products of at most U·n, with an error of a few U·n·2⁻⁵³. While U·n ≤ 2²⁰ that is below 2⁻³⁰. Thinner triangles
//! take every start from the exact integer edge functions.

use crate::raster::{area2, Point, SUBPIXELS};
use crate::shade::barycentric::weights;

/// Where plane equations stop being exact enough.
const STEEP: f64 = 1_048_576.0;

/// u and v over the pixels of a triangle.
pub(super) struct Patch {
    position: [Point; 3],
    /// Reference pixel: the upper left one of the bounding box.
    pub x0: i32,
    pub y0: i32,
    /// u and v at the reference pixel.
    at: [f64; 2],
    /// Their changes per column.
    pub dx: [f64; 2],
    /// Their changes per row.
    pub dy: [f64; 2],
    /// Too thin for plane equations.
    pub sliver: bool,
    /// Last pixel of the bounding box.
    pub x1: i32,
    pub y1: i32,
}

impl Patch {
    /// The frame of a triangle with area.
    #[inline(always)]
    pub(super) fn new(position: [Point; 3]) -> Self {
        let [a, b, c] = position;
        let (left, right) = (a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x));
        let (top, bottom) = (a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y));
        // First and last pixels whose centres may lie inside.
        let first = |v: i32| (v + SUBPIXELS / 2 - 1) >> crate::raster::SUBPIXEL_BITS;
        let last = |v: i32| (v - SUBPIXELS / 2) >> crate::raster::SUBPIXEL_BITS;
        let (x0, y0) = (first(left), first(top));
        let (x1, y1) = (last(right), last(bottom));
        let inverse = 1.0 / area2(position) as f64;
        let centre = |v: i32| i64::from(v) * i64::from(SUBPIXELS) + i64::from(SUBPIXELS / 2);
        let (cx, cy) = (centre(x0), centre(y0));
        let edge = |p: Point, q: Point| {
            let (px, py) = (i64::from(p.x), i64::from(p.y));
            let e = (i64::from(q.x) - px) * (cy - py) - (i64::from(q.y) - py) * (cx - px);
            e as f64 * inverse
        };
        let fall = f64::from(SUBPIXELS) * inverse;
        let at = [edge(c, a), edge(a, b)];
        let dx = [f64::from(c.y - a.y) * fall, f64::from(a.y - b.y) * fall];
        let dy = [f64::from(a.x - c.x) * fall, f64::from(b.x - a.x) * fall];
        let steepest = dx.iter().chain(&dy).fold(0.0f64, |m, v| m.max(v.abs()));
        let extent = f64::from((x1 - x0).max(y1 - y0).max(0) + 16);
        Self {
            position,
            x0,
            y0,
            at,
            dx,
            dy,
            sliver: steepest * extent > STEEP,
            x1,
            y1,
        }
    }

    /// u and v at the centre of a pixel.
    #[inline(always)]
    pub(super) fn at(&self, x: i32, y: i32) -> [f64; 2] {
        if self.sliver {
            let w = weights(&self.position, x, y);
            return [w[1], w[2]];
        }
        let (x, y) = (f64::from(x - self.x0), f64::from(y - self.y0));
        [
            self.at[0] + x * self.dx[0] + y * self.dy[0],
            self.at[1] + x * self.dx[1] + y * self.dy[1],
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn the_frame_is_the_barycentric_weights(
            p in prop::array::uniform3((-3000..90_000i32, -3000..90_000i32)), s in 0.0..1.0f64, t in 0.0..1.0f64,
        ) {
            let p = p.map(|(x, y)| Point { x, y });
            prop_assume!(area2(p) != 0);
            let patch = Patch::new(p);
            let mix = |a: i32, b: i32, t: f64| a + (f64::from((b - a).max(0)) * t) as i32;
            let (x, y) = (mix(patch.x0, patch.x1, s), mix(patch.y0, patch.y1, t));
            let (got, want) = (patch.at(x, y), weights(&p, x, y));
            // Where the box is wide and the triangle thin, weights far outside are large.
            for i in 0..2 {
                prop_assert!((got[i] - want[i + 1]).abs() < 1e-9 * (1.0 + want[i + 1].abs()), "{got:?} {want:?}");
            }
        }
    }
}
