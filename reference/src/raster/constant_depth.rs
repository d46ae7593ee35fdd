//! Triangles along whose rows or columns depth does not change, so that a texture needs one reciprocal for the whole span
//! (Loisel 1996, section on constant-z spans, with its constant put right).
//!
//! On a plane A·x + B·y + C·z = D, seen as u = k₁·x/z, v = k₂·y/z, the points of depth z = k lie on the screen line
//!
//!   k·(A/k₁)·u + k·(B/k₂)·v + (k·C − D) = 0.
//!
//! All these lines have one direction. They are rows where A = 0, as on floors and ceilings under a level camera, columns
//! where B = 0, as on upright walls, and everything is at one depth where both are 0. A and B over k₁·D and k₂·D are the
//! slopes of 1/z over the screen, which is how they are found here.

use super::Point;
use crate::shade::barycentric;

/// Along what depth does not change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConstantDepth {
    /// Neither rows nor columns.
    Nowhere,
    /// Along every row.
    Rows,
    /// Along every column.
    Columns,
    /// All over: affine interpolation is exact.
    Everywhere,
}

/// Along what the depth of a triangle is constant. `inv_w` is 1/w at its vertices, > 0; a change of 1/w along the longest
/// row or column of less than `tolerance` of its least value counts as none. The texture then moves by at most about
/// `tolerance`/4 of its extent along the span. A triangle without area is constant everywhere.
#[must_use]
pub fn constant_depth(position: [Point; 3], inv_w: [f64; 3], tolerance: f64) -> ConstantDepth {
    let extent = |coordinate: fn(&Point) -> i32| {
        let [a, b, c] = [0, 1, 2].map(|i| f64::from(coordinate(&position[i])));
        (a.max(b).max(c) - a.min(b).min(c)) / f64::from(super::SUBPIXELS)
    };
    let least = inv_w[0].min(inv_w[1]).min(inv_w[2]);
    let slope = |steps: [f64; 3]| {
        // Of differences, so that equal values give exactly nothing.
        steps[1] * (inv_w[1] - inv_w[0]) + steps[2] * (inv_w[2] - inv_w[0])
    };
    // Columns of the triangle are rows of its mirror image in the diagonal.
    let swapped = position.map(|q| Point { x: q.y, y: q.x });
    let across = slope(barycentric::steps(&position)).abs() * extent(|q| q.x);
    let down = slope(barycentric::steps(&swapped)).abs() * extent(|q| q.y);
    match (across <= tolerance * least, down <= tolerance * least) {
        (true, true) => ConstantDepth::Everywhere,
        (true, false) => ConstantDepth::Rows,
        (false, true) => ConstantDepth::Columns,
        (false, false) => ConstantDepth::Nowhere,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const K: f64 = 250.0;

    /// Projects points of a camera at the origin that looks along z, x to the right, y down.
    fn seen(points: [[f64; 3]; 3]) -> ([Point; 3], [f64; 3]) {
        (
            points.map(|[x, y, z]| Point::snap(K * x / z, K * y / z).unwrap()),
            points.map(|[_, _, z]| 1.0 / z),
        )
    }

    fn of(points: [[f64; 3]; 3]) -> ConstantDepth {
        let (p, w) = seen(points);
        constant_depth(p, w, 1e-2)
    }

    #[test]
    fn floors_walls_and_what_faces_the_camera() {
        assert_eq!(
            of([[-3.0, 1.0, 4.0], [2.0, 1.0, 5.0], [1.0, 1.0, 9.0]]),
            ConstantDepth::Rows
        );
        assert_eq!(
            of([[-3.0, 1.0, 4.0], [-3.0, -1.5, 4.0], [-2.0, 0.5, 9.0]]),
            ConstantDepth::Columns
        );
        assert_eq!(
            of([[-3.0, 1.0, 4.0], [2.0, 1.0, 4.0], [1.0, -1.0, 4.0]]),
            ConstantDepth::Everywhere
        );
        assert_eq!(
            of([[-3.0, 1.0, 4.0], [2.0, 1.5, 5.0], [1.0, -1.0, 9.0]]),
            ConstantDepth::Nowhere
        );
        // No perspective; no area.
        let (p, _) = seen([[-3.0, 1.0, 4.0], [2.0, 1.5, 5.0], [1.0, -1.0, 9.0]]);
        assert_eq!(constant_depth(p, [1.0; 3], 0.0), ConstantDepth::Everywhere);
        assert_eq!(
            constant_depth([p[0]; 3], [1.0, 2.0, 3.0], 0.0),
            ConstantDepth::Everywhere
        );
    }

    proptest! {
        /// The claim itself: along every row of a triangle called constant the true depth stays within the tolerance, and
        /// lines of one depth are where the corrected formula says (the printed constant C − D is elsewhere).
        #[test]
        fn depth_is_constant_where_it_is_called_so(
            a in prop::sample::select(vec![0.0, 1e-4, 0.01, 0.4]), b in prop::sample::select(vec![0.0, 1e-4, 0.01, 0.4]),
            x in -2.0..2.0f64, y in -2.0..2.0f64, spread in 0.2..2.0f64, tolerance in 1e-3..0.1f64,
        ) {
            // The plane a·x + b·y + z = 6.
            let on = |x: f64, y: f64| [x, y, 6.0 - a * x - b * y];
            let corners = [on(x, y), on(x + spread, y - 0.3 * spread), on(x - 0.2 * spread, y + spread)];
            let (p, w) = seen(corners);
            let called = constant_depth(p, w, tolerance);
            let (mut rows, mut columns) = (0.0f64, 0.0f64);
            for i in 0..20 {
                for k in 0..20 {
                    // Two points of one row, and of one column, inside the box around the corners.
                    let at = |u: f64, v: f64| {
                        let c = |axis: fn(&Point) -> i32, t: f64| {
                            let all = p.map(|q| f64::from(axis(&q)) / 256.0);
                            let (lo, hi) = (all.iter().copied().fold(f64::MAX, f64::min), all.iter().copied().fold(f64::MIN, f64::max));
                            lo + (hi - lo) * t
                        };
                        // 1/z on the plane, straight from its equation.
                        (1.0 + a * c(|q| q.x, u) / K + b * c(|q| q.y, v) / K) / 6.0
                    };
                    let (s, t) = (f64::from(i) / 19.0, f64::from(k) / 19.0);
                    rows = rows.max((at(0.0, t) - at(s, t)).abs());
                    columns = columns.max((at(t, 0.0) - at(t, s)).abs());
                }
            }
            let least = w.iter().copied().fold(f64::MAX, f64::min);
            // Snapping moves the slopes by a part in a hundred or so of what is small here.
            let (sure, never) = (tolerance * least * 1.2, tolerance * least * 0.8);
            let constant_rows = matches!(called, ConstantDepth::Rows | ConstantDepth::Everywhere);
            let constant_columns = matches!(called, ConstantDepth::Columns | ConstantDepth::Everywhere);
            let ok = if constant_rows { rows < sure + 3e-5 } else { rows > never - 3e-5 };
            prop_assert!(ok, "rows");
            let ok = if constant_columns { columns < sure + 3e-5 } else { columns > never - 3e-5 };
            prop_assert!(ok, "columns");

            let depth = 5.5;
            let (u, v) = if b.abs() > 0.005 {
                // A point of that depth: z = depth on the plane, its x chosen.
                (K * x / depth, K * ((6.0 - depth - a * x) / b) / depth)
            } else {
                return Ok(());
            };
            let line = |constant: f64| depth * a / K * u + depth * b / K * v + constant;
            prop_assert!(line(depth - 6.0).abs() < 1e-9);
            prop_assert!(line(1.0 - 6.0).abs() > 1.0, "the printed constant is wrong");
        }
    }
}
