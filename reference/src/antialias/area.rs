//! The area of a triangle in a pixel, exactly: the polygon that the four sides of the pixel leave of it
//! (Sutherland–Hodgman), measured by the shoelace formula. What every coverage below is judged by.

use crate::raster::Point;

/// The share of pixel (`x`, `y`) that a triangle covers, 0..=1, for any order of its vertices.
#[must_use]
pub fn coverage(triangle: [Point; 3], x: i32, y: i32) -> f64 {
    let corner = [f64::from(x), f64::from(y)];
    let mut polygon: Vec<[f64; 2]> = triangle
        .iter()
        .map(|p| p.pixels())
        .map(|(px, py)| [px - corner[0], py - corner[1]])
        .collect();
    // Inside of each side: sign · (coordinate − limit) ≥ 0.
    for (axis, limit, sign) in [(0, 0.0, 1.0), (0, 1.0, -1.0), (1, 0.0, 1.0), (1, 1.0, -1.0)] {
        let inside = |p: &[f64; 2]| sign * (p[axis] - limit);
        let mut next = Vec::with_capacity(polygon.len() + 1);
        for (k, p) in polygon.iter().enumerate() {
            let q = &polygon[(k + 1) % polygon.len()];
            let (a, b) = (inside(p), inside(q));
            if a >= 0.0 {
                next.push(*p);
            }
            if (a < 0.0) != (b < 0.0) {
                let t = a / (a - b);
                next.push([0, 1].map(|i| p[i] + (q[i] - p[i]) * t));
            }
        }
        polygon = next;
    }
    let doubled: f64 = (0..polygon.len())
        .map(|k| {
            let (p, q) = (polygon[k], polygon[(k + 1) % polygon.len()]);
            p[0] * q[1] - p[1] * q[0]
        })
        .sum();
    doubled.abs() / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::area2;
    use proptest::prelude::*;

    fn p(x: f64, y: f64) -> Point {
        Point::snap(x, y).unwrap()
    }

    #[test]
    fn by_hand() {
        let t = [p(0.0, 0.0), p(4.0, 0.0), p(0.0, 4.0)];
        assert_eq!(coverage(t, 0, 0), 1.0);
        assert_eq!(coverage(t, 3, 0), 0.5);
        assert_eq!(coverage(t, 2, 2), 0.0);
        assert_eq!(coverage(t, -1, 0), 0.0);
        let small = [p(5.25, 5.25), p(5.75, 5.25), p(5.25, 5.75)];
        assert_eq!(coverage(small, 5, 5), 0.125);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]
        #[test]
        fn all_pixels_together_have_the_area(v in prop::array::uniform3((0..3000i32, 0..3000i32))) {
            let t = v.map(|(x, y)| Point { x, y });
            let sum: f64 = (0..12).flat_map(|y| (0..12).map(move |x| (x, y))).map(|(x, y)| coverage(t, x, y)).sum();
            let area = area2(t).abs() as f64 / 2.0 / 65536.0;
            prop_assert!((sum - area).abs() < 1e-9, "{sum} {area}");
        }
    }
}
