//! The top-left rule, straight from its definition: the oracle for everything that walks a triangle.
//!
//! A pixel belongs to a triangle when its centre lies strictly inside, or on a *top* edge (horizontal, interior below)
//! or a *left* edge (interior to the right). So two triangles that share an edge never both own a centre on it, and
//! never both leave it out.

use super::{area2, Point, SUBPIXELS};

/// Whether the centre of pixel (`x`, `y`) belongs to the triangle; exact, for any vertex order, false for zero area.
#[must_use]
pub fn covers(p: [Point; 3], x: i32, y: i32) -> bool {
    let area = area2(p);
    if area == 0 {
        return false;
    }
    let p = if area > 0 { p } else { [p[0], p[2], p[1]] };
    let cx = i64::from(x) * i64::from(SUBPIXELS) + i64::from(SUBPIXELS / 2);
    let cy = i64::from(y) * i64::from(SUBPIXELS) + i64::from(SUBPIXELS / 2);
    (0..3).all(|i| {
        let (a, b) = (p[i], p[(i + 1) % 3]);
        let (dx, dy) = (
            i64::from(b.x) - i64::from(a.x),
            i64::from(b.y) - i64::from(a.y),
        );
        // Clockwise on a y-down screen: the interior is where this is positive.
        let side = i128::from(dx) * i128::from(cy - i64::from(a.y))
            - i128::from(dy) * i128::from(cx - i64::from(a.x));
        // Walking clockwise, a left edge goes up and a top edge goes right.
        let owns_its_points = dy < 0 || (dy == 0 && dx > 0);
        side > 0 || (side == 0 && owns_its_points)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(x: i32, y: i32) -> Point {
        Point { x, y }
    }

    #[test]
    fn a_square_of_two_triangles_owns_each_centre_once() {
        // Corners exactly on pixel centres: every tie of the rule occurs.
        let (a, b, c, d) = (
            p(128, 128),
            p(128 + 1024, 128),
            p(128 + 1024, 128 + 1024),
            p(128, 128 + 1024),
        );
        for y in -1..7 {
            for x in -1..7 {
                let n = u32::from(covers([a, b, c], x, y)) + u32::from(covers([a, c, d], x, y));
                let inside = (0..4).contains(&x) && (0..4).contains(&y);
                assert_eq!(n, u32::from(inside), "pixel {x} {y}");
            }
        }
    }

    #[test]
    fn vertex_order_does_not_matter() {
        let t = [p(10, 20), p(900, 300), p(200, 1100)];
        for y in 0..5 {
            for x in 0..5 {
                let want = covers(t, x, y);
                assert_eq!(covers([t[1], t[2], t[0]], x, y), want);
                assert_eq!(covers([t[2], t[1], t[0]], x, y), want);
            }
        }
    }
}
