//! The pixels that a triangle touches: row by row, from the leftmost to the rightmost of its points in the row.

use crate::raster::Point;
use std::ops::Range;

/// Rounding of a crossing never exceeds this, pixels.
const ROUNDING: f64 = 1e-6;

/// The rows of `limit` that a triangle touches.
pub(super) fn rows(t: [Point; 3], limit: Range<i32>) -> Range<i32> {
    let [a, b, c] = t.map(|p| p.pixels().1);
    let (top, bottom) = (a.min(b).min(c), a.max(b).max(c));
    // The conversions saturate far outside the frame.
    let first = (top.floor() as i32).max(limit.start);
    let end = (bottom.ceil() as i32).clamp(limit.start, limit.end);
    first.min(end)..end
}

/// The columns of `0..width` that a triangle touches in a row: all that it does, at most one more on either side.
pub(super) fn columns(t: [Point; 3], row: i32, width: i32) -> Range<i32> {
    let (top, bottom) = (f64::from(row), f64::from(row) + 1.0);
    let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
    for i in 0..3 {
        let ((ax, ay), (bx, by)) = (t[i].pixels(), t[(i + 1) % 3].pixels());
        let (lo, hi) = (ay.min(by).max(top), ay.max(by).min(bottom));
        if lo > hi {
            continue;
        }
        for y in [lo, hi] {
            let xs = if ay == by {
                [ax, bx]
            } else {
                [ax + (bx - ax) * ((y - ay) / (by - ay)); 2]
            };
            left = left.min(xs[0].min(xs[1]));
            right = right.max(xs[0].max(xs[1]));
        }
    }
    if left > right {
        return 0..0;
    }
    let first = ((left - ROUNDING).floor() as i32).max(0);
    let end = ((right + ROUNDING).ceil() as i32).clamp(0, width);
    first.min(end)..end
}

#[cfg(test)]
mod tests {
    use super::super::area::coverage;
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn whatever_has_an_area_is_touched(v in prop::array::uniform3((-900..3500i32, -900..3500i32))) {
            let t = v.map(|(x, y)| Point { x, y });
            let touched = rows(t, 0..9);
            for y in 0..9 {
                let xs = if touched.contains(&y) { columns(t, y, 11) } else { 0..0 };
                for x in 0..11 {
                    let area = coverage(t, x, y);
                    prop_assert!(area < 1e-9 || xs.contains(&x), "{x} {y} {area}");
                }
                prop_assert!(xs.start >= 0 && xs.end <= 11);
            }
        }
    }
}
