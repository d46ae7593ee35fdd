//! Barycentric weights of a pixel centre: λᵢ = eᵢ / Σe, with the edge functions e exact in integers.

use crate::raster::{Point, SUBPIXELS};

/// The three weights at the centre of pixel (`x`, `y`), summing to 1; for any orientation. All zero for a triangle
/// without area.
#[must_use]
pub fn weights(p: &[Point; 3], x: i32, y: i32) -> [f64; 3] {
    let centre = |v: i32| i64::from(v) * i64::from(SUBPIXELS) + i64::from(SUBPIXELS / 2);
    let (cx, cy) = (centre(x), centre(y));
    let edge = |a: Point, b: Point| {
        (i64::from(b.x) - i64::from(a.x)) * (cy - i64::from(a.y))
            - (i64::from(b.y) - i64::from(a.y)) * (cx - i64::from(a.x))
    };
    let e = [edge(p[1], p[2]), edge(p[2], p[0]), edge(p[0], p[1])];
    let area = e[0] + e[1] + e[2];
    if area == 0 {
        return [0.0; 3];
    }
    e.map(|v| v as f64 / area as f64)
}

/// The three weights at any place of the screen, in pixels; rounded, where [`weights`] is exact. All zero for a triangle
/// without area.
#[must_use]
pub fn weights_at(p: &[Point; 3], x: f64, y: f64) -> [f64; 3] {
    let area = crate::raster::area2(*p) as f64;
    if area == 0.0 {
        return [0.0; 3];
    }
    let (x, y) = (x * f64::from(SUBPIXELS), y * f64::from(SUBPIXELS));
    let edge = |a: Point, b: Point| {
        let (ax, ay) = (f64::from(a.x), f64::from(a.y));
        ((f64::from(b.x) - ax) * (y - ay) - (f64::from(b.y) - ay) * (x - ax)) / area
    };
    [edge(p[1], p[2]), edge(p[2], p[0]), edge(p[0], p[1])]
}

/// Changes of the weights from one pixel to the next on its right.
#[must_use]
pub fn steps(p: &[Point; 3]) -> [f64; 3] {
    let area = crate::raster::area2(*p) as f64;
    if area == 0.0 {
        return [0.0; 3];
    }
    let rise =
        |a: Point, b: Point| (i64::from(a.y) - i64::from(b.y)) as f64 * f64::from(SUBPIXELS) / area;
    [rise(p[1], p[2]), rise(p[2], p[0]), rise(p[0], p[1])]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_reproduce_the_position_and_steps_their_change() {
        let p = [(100, 300), (5000, 700), (1300, 9000)].map(|(x, y)| Point { x, y });
        for (x, y) in [(0, 0), (7, 9), (-5, 40)] {
            let w = weights(&p, x, y);
            let sum = |f: fn(&Point) -> i32| {
                (0..3)
                    .map(|i| w[i] * f64::from(f(&p[i])) / 256.0)
                    .sum::<f64>()
            };
            assert!((sum(|q| q.x) - (f64::from(x) + 0.5)).abs() < 1e-12);
            assert!((sum(|q| q.y) - (f64::from(y) + 0.5)).abs() < 1e-12);
            let (n, s) = (weights(&p, x + 1, y), steps(&p));
            let anywhere = weights_at(&p, f64::from(x) + 0.5, f64::from(y) + 0.5);
            for i in 0..3 {
                assert!((anywhere[i] - w[i]).abs() < 1e-14);
                assert!((n[i] - w[i] - s[i]).abs() < 1e-14);
            }
        }
    }
}
