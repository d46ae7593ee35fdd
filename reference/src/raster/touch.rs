//! Whether a triangle covers any pixel centre of the viewport: exact, and cheaper than walking its spans. Most
//! triangles are decided by one centre, the one nearest their centroid; small ones by the few centres of their
//! bounding box; only large slivers are walked.

use super::{area2, Point, Viewport, Walk, SUBPIXELS};

/// Bounding boxes of more pixels are walked.
const BOX: i64 = 32;

/// A half plane a·x + b·y + c ≥ 0 over pixel coordinates, exact.
#[derive(Clone, Copy)]
struct Half {
    a: i64,
    b: i64,
    c: i64,
}

impl Half {
    /// The inner side of the edge from `p` to `q` of a clockwise triangle, by the top-left rule (as in
    /// [`super::covers`]). Coordinates are limited, so that nothing exceeds 2^60.
    fn new(p: Point, q: Point) -> Self {
        let (dx, dy) = (
            i64::from(q.x) - i64::from(p.x),
            i64::from(q.y) - i64::from(p.y),
        );
        let (s, half) = (i64::from(SUBPIXELS), i64::from(SUBPIXELS / 2));
        let owns = dy < 0 || (dy == 0 && dx > 0);
        Self {
            a: -dy * s,
            b: dx * s,
            c: dx * (half - i64::from(p.y)) - dy * (half - i64::from(p.x)) - i64::from(!owns),
        }
    }

    fn holds(&self, x: i64, y: i64) -> bool {
        self.a * x + self.b * y + self.c >= 0
    }
}

/// Whether a point in sub-pixels is on the inner side of an edge, as [`Half`] has it for the centres of many pixels.
fn on_side(p: Point, q: Point, x: i64, y: i64) -> bool {
    let (dx, dy) = (
        i64::from(q.x) - i64::from(p.x),
        i64::from(q.y) - i64::from(p.y),
    );
    let e = dx * (y - i64::from(p.y)) - dy * (x - i64::from(p.x));
    e > 0 || (e == 0 && (dy < 0 || (dy == 0 && dx > 0)))
}

/// First and last pixel whose centre lies in `from..=to` (sub-pixels) and in `0..limit`.
fn centres(from: i32, to: i32, limit: u32) -> (i64, i64) {
    let (s, half) = (i64::from(SUBPIXELS), i64::from(SUBPIXELS / 2));
    let first = (i64::from(from) - half + s - 1).div_euclid(s);
    let last = (i64::from(to) - half).div_euclid(s);
    (first.max(0), last.min(i64::from(limit) - 1))
}

/// Whether the triangle covers the centre of some pixel of the viewport, by the rule of [`super::covers`]; false for
/// zero area. Any vertex order; coordinates as [`Point::snap`] makes them.
#[must_use]
pub fn covers_any(p: [Point; 3], viewport: Viewport) -> bool {
    let area = area2(p);
    if area == 0 {
        return false;
    }
    let [a, b, c] = if area > 0 { p } else { [p[0], p[2], p[1]] };
    let (x0, x1) = centres(a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x), viewport.width);
    let (y0, y1) = centres(
        a.y.min(b.y).min(c.y),
        a.y.max(b.y).max(c.y),
        viewport.height,
    );
    if x0 > x1 || y0 > y1 {
        return false;
    }
    let third = |u: i32, v: i32, w: i32| {
        (i64::from(u) + i64::from(v) + i64::from(w)).div_euclid(3 * i64::from(SUBPIXELS))
    };
    let (x, y) = (
        third(a.x, b.x, c.x).clamp(x0, x1),
        third(a.y, b.y, c.y).clamp(y0, y1),
    );
    let centre = |v: i64| v * i64::from(SUBPIXELS) + i64::from(SUBPIXELS / 2);
    let (cx, cy) = (centre(x), centre(y));
    if on_side(a, b, cx, cy) && on_side(b, c, cx, cy) && on_side(c, a, cx, cy) {
        return true;
    }
    if x0 == x1 && y0 == y1 {
        return false;
    }
    let half = [Half::new(a, b), Half::new(b, c), Half::new(c, a)];
    let inside = |x, y| half.iter().all(|h| h.holds(x, y));
    if (x1 - x0 + 1) * (y1 - y0 + 1) <= BOX {
        return (y0..=y1).any(|y| (x0..=x1).any(|x| inside(x, y)));
    }
    Walk::new(p, viewport).is_some_and(|w| w.spans(viewport.width).next().is_some())
}

#[cfg(test)]
mod tests {
    use super::super::{covers, COORDINATE_LIMIT};
    use super::*;
    use proptest::prelude::*;

    fn check(p: [Point; 3]) {
        let viewport = Viewport {
            width: 12,
            height: 9,
        };
        let want = (0..9).any(|y| (0..12).any(|x| covers(p, x, y)));
        for p in [p, [p[1], p[2], p[0]], [p[1], p[0], p[2]]] {
            assert_eq!(covers_any(p, viewport), want, "{p:?}");
        }
    }

    fn point(limit: i32) -> impl Strategy<Value = Point> {
        (-limit..=limit, -limit..=limit).prop_map(|(x, y)| Point { x, y })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]
        #[test]
        fn small_ones(a in point(3500), b in point(300), c in point(300)) {
            let by = |d: Point| Point { x: a.x + d.x, y: a.y + d.y };
            check([a, by(b), by(c)]);
        }

        #[test]
        fn ties(a in point(12), b in point(12), c in point(12)) {
            check([a, b, c].map(|p| Point { x: p.x * 128, y: p.y * 128 }));
        }

        #[test]
        fn slivers(a in point(6000), b in point(6000), c in point(40)) {
            check([a, b, Point { x: a.x + c.x, y: a.y + c.y }]);
        }

        #[test]
        fn huge_ones(a in point(COORDINATE_LIMIT), b in point(COORDINATE_LIMIT), c in point(COORDINATE_LIMIT)) {
            check([a, b, c]);
        }
    }
}
