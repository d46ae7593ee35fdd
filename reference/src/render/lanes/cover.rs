//! Which pixels of a small triangle are covered: eight at a time by the signs of its three edge functions, without the
//! divisions that the walk along the edges begins with. The rule is that of [`crate::raster::covers`].
//!
//! E(x, y) = (bx − ax)(y − ay) − (by − ay)(x − ax) in 1/256 pixel, positive inside; on an edge exactly only the top and the left
//! one belong to the triangle, so E of the others is lowered by one. For boxes of up to 16 by 64 pixels all E stay below
//! 2²⁹.

use super::fixed::lanes;
use super::patch::Patch;
use crate::raster::{area2, Point, SUBPIXELS};
use crate::simd::three;
use fearless_simd::{i32x8, mask32x8, prelude::*, Simd};

/// Largest bounding box, in pixels, for which this is meant.
pub(super) const WIDTH: i32 = 16;
pub(super) const HEIGHT: i32 = 64;

/// The ends of edge `i`, so that the inside is on the positive side.
#[inline(always)]
fn ends(p: &[Point; 3], i: usize, turned: bool) -> (Point, Point) {
    let j = if i == 2 { 0 } else { i + 1 };
    if turned {
        (p[j], p[i])
    } else {
        (p[i], p[j])
    }
}

/// The edge functions at the first eight pixels of the current row.
pub(super) struct Cover<S: Simd> {
    value: [i32x8<S>; 3],
    right: [i32x8<S>; 3],
    down: [i32x8<S>; 3],
}

impl<S: Simd> Cover<S> {
    /// The edge functions at row `y` and the eight pixels from column `x`.
    #[inline(always)]
    pub(super) fn new(simd: S, p: &[Point; 3], x: i32, y: i32) -> Self {
        let turned = area2(*p) < 0;
        let k = lanes(simd);
        let centre = |v: i32| i64::from(v * SUBPIXELS + SUBPIXELS / 2);
        let at = three!(i => {
            let (a, b) = ends(p, i, turned);
            let (dx, dy) = (b.x - a.x, b.y - a.y);
            // With y downwards and the inside on the positive side: top edges run right, left edges up.
            let closed = dy < 0 || (dy == 0 && dx > 0);
            i64::from(dx) * (centre(y) - i64::from(a.y))
                - i64::from(dy) * (centre(x) - i64::from(a.x))
                - i64::from(!closed)
        });
        let across = three!(i => {
            let (a, b) = ends(p, i, turned);
            (a.y - b.y) * SUBPIXELS
        });
        let along = three!(i => {
            let (a, b) = ends(p, i, turned);
            (b.x - a.x) * SUBPIXELS
        });
        Self {
            value: three!(i => i32x8::splat(simd, at[i] as i32) + k * across[i]),
            right: three!(i => i32x8::splat(simd, across[i] * 8)),
            down: three!(i => i32x8::splat(simd, along[i])),
        }
    }

    /// Covered pixels of the first eight.
    #[inline(always)]
    pub(super) fn first(&self, simd: S) -> mask32x8<S> {
        let [a, b, c] = self.value;
        (a | b | c).simd_ge(i32x8::splat(simd, 0))
    }

    /// Covered pixels of the next eight.
    #[inline(always)]
    pub(super) fn second(&self, simd: S) -> mask32x8<S> {
        let [a, b, c] = three!(i => self.value[i] + self.right[i]);
        (a | b | c).simd_ge(i32x8::splat(simd, 0))
    }

    /// Moves down one row.
    #[inline(always)]
    pub(super) fn down(&mut self) {
        for i in 0..3 {
            self.value[i] += self.down[i];
        }
    }
}

/// Whether a triangle is drawn this way.
#[inline(always)]
pub(super) fn is_small(patch: &Patch) -> bool {
    !patch.sliver && patch.x1 - patch.x0 < WIDTH && patch.y1 - patch.y0 < HEIGHT
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::covers;
    use fearless_simd::{dispatch, Level};
    use proptest::prelude::*;

    #[inline(always)]
    fn check<S: Simd>(simd: S, p: [Point; 3]) -> Result<(), TestCaseError> {
        let patch = Patch::new(p);
        let mut cover = Cover::new(simd, &p, patch.x0, patch.y0);
        for y in patch.y0..=patch.y1 {
            let bits = cover.first(simd).to_bitmask() | cover.second(simd).to_bitmask() << 8;
            for k in 0..16 {
                let want = covers(p, patch.x0 + k, y);
                prop_assert_eq!(bits >> k & 1 == 1, want, "{:?} {} {}", p, k, y);
            }
            cover.down();
        }
        Ok(())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]
        #[test]
        fn the_rule_is_kept(p in prop::array::uniform3((-2000..2000i32, -2000..2000i32)), coarse in any::<bool>()) {
            // Coarse positions hit every tie.
            let p = p.map(|(x, y)| if coarse { Point { x: x / 128 * 128, y: y / 128 * 128 } } else { Point { x, y } });
            let p = p.map(|q| Point { x: q.x.rem_euclid(4096), y: q.y });
            if area2(p) != 0 {
                dispatch!(Level::new(), simd => check(simd, p))?;
            }
        }
    }
}
