//! Polygons cut into triangles (Loisel 1996, section on triangulation, with its two errors put right: a corner is concave
//! where it turns against the polygon, and a diagonal must lie inside, not only cross no edge).
//!
//! A convex polygon becomes the fan of its first corner. Of any other, *ears* are cut: convex corners whose triangle with
//! both neighbours holds no further corner, so that the third side is a diagonal inside. Every simple polygon of more
//! than three corners has two (Meisters 1975), so n corners always give n − 2 triangles.

use super::newell;
use glam::{DVec2, DVec3};

/// More corners than this are refused unless the polygon is convex: looking for ears takes time with the square of their
/// number or worse.
pub const CORNER_LIMIT: usize = 2048;

/// Why a polygon cannot be cut into triangles that cover it once.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Fault {
    /// Fewer than three corners.
    #[error("has fewer than three corners")]
    TooFew,
    /// More than [`CORNER_LIMIT`], and not convex.
    #[error("is not convex and has more than {CORNER_LIMIT} corners")]
    TooMany,
    /// No area, or not finite.
    #[error("has no area")]
    NoArea,
    /// Its border meets itself.
    #[error("crosses itself")]
    Crosses,
}

/// Twice the signed area of a triangle; positive for counter-clockwise.
fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

/// Cuts a polygon, plane or nearly so, into `corners.len() − 2` triangles of indices into `corners`, which turn as the
/// polygon does. A convex polygon becomes a fan, in order; only there a triangle may be without area, where three
/// corners lie on a line.
///
/// # Errors
/// A polygon that does not bound an area once.
pub fn triangulate(corners: &[DVec3]) -> Result<Vec<[usize; 3]>, Fault> {
    if corners.len() < 3 {
        return Err(Fault::TooFew);
    }
    let area = newell::area_vector(corners);
    if area == DVec3::ZERO || !area.is_finite() {
        return Err(Fault::NoArea);
    }
    let flat: Vec<DVec2> = corners
        .iter()
        .map(|c| project(*c - corners[0], area))
        .collect();
    if is_convex(&flat) {
        return Ok((2..corners.len()).map(|k| [0, k - 1, k]).collect());
    }
    if corners.len() > CORNER_LIMIT {
        return Err(Fault::TooMany);
    }
    if crosses_itself(&flat) {
        return Err(Fault::Crosses);
    }
    ears(&flat)
}

/// Onto the coordinate plane that shows most of the area, so that the polygon turns counter-clockwise there.
fn project(p: DVec3, area: DVec3) -> DVec2 {
    let a = area.abs();
    let (flat, up) = if a.z >= a.x && a.z >= a.y {
        (DVec2::new(p.x, p.y), area.z)
    } else if a.x >= a.y {
        (DVec2::new(p.y, p.z), area.x)
    } else {
        (DVec2::new(p.z, p.x), area.y)
    };
    if up < 0.0 {
        DVec2::new(flat.y, flat.x)
    } else {
        flat
    }
}

/// No corner turns right, and seen from the first no edge runs backwards (which a star's would).
fn is_convex(p: &[DVec2]) -> bool {
    let n = p.len();
    let left = |k: usize| turn(p[k], p[(k + 1) % n], p[(k + 2) % n]) >= 0.0;
    (0..n).all(left) && (2..n).all(|k| turn(p[0], p[k - 1], p[k]) >= 0.0)
}

/// Whether two edges without a common corner cross.
fn crosses_itself(p: &[DVec2]) -> bool {
    let n = p.len();
    let apart = |a: f64, b: f64| (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0);
    (0..n).any(|i| {
        let (a, b) = (p[i], p[(i + 1) % n]);
        (i + 2..n).any(|j| {
            let (c, d) = (p[j], p[(j + 1) % n]);
            apart(turn(a, b, c), turn(a, b, d)) && apart(turn(c, d, a), turn(c, d, b))
        })
    })
}

fn ears(p: &[DVec2]) -> Result<Vec<[usize; 3]>, Fault> {
    let mut ring: Vec<usize> = (0..p.len()).collect();
    let mut triangles = Vec::with_capacity(p.len() - 2);
    // Where the last ear was: its neighbours are the likeliest next ones.
    let mut at = 0;
    while ring.len() > 3 {
        let n = ring.len();
        let ear = (0..n).map(|k| (at + k) % n).find(|k| is_ear(p, &ring, *k));
        let k = ear.ok_or(Fault::Crosses)?;
        triangles.push([ring[(k + n - 1) % n], ring[k], ring[(k + 1) % n]]);
        ring.remove(k);
        // One further, so that a round polygon is not eaten from one corner as a fan of slivers.
        at = (k + 1) % ring.len();
    }
    let last = [ring[0], ring[1], ring[2]];
    if turn(p[last[0]], p[last[1]], p[last[2]]) <= 0.0 {
        return Err(Fault::Crosses);
    }
    triangles.push(last);
    Ok(triangles)
}

/// Whether corner `k` of a ring is convex and no other corner lies in its triangle or on it. Corners in the same place
/// as one of the three do not count: a bridge to a hole has them.
fn is_ear(p: &[DVec2], ring: &[usize], k: usize) -> bool {
    let n = ring.len();
    let own = [ring[(k + n - 1) % n], ring[k], ring[(k + 1) % n]];
    let [a, b, c] = own.map(|i| p[i]);
    if turn(a, b, c) <= 0.0 {
        return false;
    }
    ring.iter().filter(|i| !own.contains(i)).all(|i| {
        let q = p[*i];
        let inside = turn(a, b, q) >= 0.0 && turn(b, c, q) >= 0.0 && turn(c, a, q) >= 0.0;
        !inside || [a, b, c].contains(&q)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DQuat;
    use proptest::prelude::*;

    fn flat(points: &[(f64, f64)]) -> Vec<DVec3> {
        points
            .iter()
            .map(|(x, y)| DVec3::new(*x, *y, 0.0))
            .collect()
    }

    fn inside(p: &[DVec3], x: f64, y: f64) -> bool {
        // Even–odd, independent of the cutting.
        let n = p.len();
        (0..n).fold(false, |odd, i| {
            let (a, b) = (p[i], p[(i + 1) % n]);
            let crosses = (a.y > y) != (b.y > y) && x < a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
            odd != crosses
        })
    }

    /// n − 2 triangles which turn as the polygon and cover each of many points as often as the polygon does.
    fn check(p: &[DVec3]) {
        let triangles = triangulate(p).unwrap();
        assert_eq!(triangles.len(), p.len() - 2);
        let area: f64 = triangles
            .iter()
            .map(|t| {
                let a = newell::area_vector(&t.map(|i| p[i])).z;
                assert!(a >= 0.0, "{t:?} of {p:?}");
                a
            })
            .sum();
        let whole = newell::area_vector(p).z;
        assert!((area - whole).abs() <= 1e-9 * whole);
        for k in 0..900 {
            let (x, y) = (
                f64::from(k % 30) * 0.310_17 - 1.030_71,
                f64::from(k / 30) * 0.290_11 - 1.011_37,
            );
            let times = triangles
                .iter()
                .filter(|t| inside(&t.map(|i| p[i]), x, y))
                .count();
            assert_eq!(times, usize::from(inside(p, x, y)), "{x} {y} of {p:?}");
        }
    }

    #[test]
    fn convex_polygons_become_fans() {
        let p = flat(&[(0.0, 0.0), (4.0, 0.0), (5.0, 2.0), (3.0, 4.0), (0.0, 3.0)]);
        assert_eq!(triangulate(&p).unwrap(), [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
        check(&p);
        let on_a_line = flat(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 2.0)]);
        assert_eq!(triangulate(&on_a_line).unwrap(), [[0, 1, 2], [0, 2, 3]]);
    }

    /// Loisel's rule that a diagonal only must cross no edge cuts this one outside, from (4, 1) to (1, 4).
    #[test]
    fn concave_polygons_are_cut_inside() {
        check(&flat(&[
            (0.0, 0.0),
            (6.0, 0.0),
            (6.0, 4.0),
            (5.0, 4.0),
            (4.0, 1.0),
            (2.0, 1.0),
            (1.0, 4.0),
            (0.0, 4.0),
        ]));
        // An arrow, concave in its first corner: a fan from there would be right, from any other wrong.
        for k in 0..4 {
            let mut arrow = flat(&[(1.0, 1.0), (0.0, 0.0), (4.0, 1.0), (0.0, 2.0)]);
            arrow.rotate_left(k);
            check(&arrow);
        }
        // A comb, a corner in the middle of an edge, and a hole with its bridge.
        check(&flat(&[
            (0.0, 0.0),
            (7.0, 0.0),
            (7.0, 5.0),
            (6.0, 1.0),
            (5.0, 5.0),
            (4.0, 1.0),
            (3.0, 5.0),
            (2.0, 1.0),
            (1.0, 5.0),
        ]));
        check(&flat(&[
            (0.0, 0.0),
            (2.0, 0.0),
            (4.0, 0.0),
            (4.0, 4.0),
            (3.0, 1.0),
            (0.0, 4.0),
        ]));
        check(&flat(&[
            (0.0, 0.0),
            (6.0, 0.0),
            (6.0, 6.0),
            (0.0, 6.0),
            (0.0, 0.0),
            (2.0, 2.0),
            (2.0, 4.0),
            (4.0, 4.0),
            (4.0, 2.0),
            (2.0, 2.0),
        ]));
    }

    #[test]
    fn what_bounds_nothing_is_refused() {
        let star = |k: usize| {
            let (s, c) = (std::f64::consts::TAU * (2 * k) as f64 / 5.0).sin_cos();
            DVec3::new(c, s, 1.0)
        };
        let cases: [(Vec<DVec3>, Fault); 6] = [
            (flat(&[(0.0, 0.0), (1.0, 0.0)]), Fault::TooFew),
            (
                flat(&[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 3.0)]),
                Fault::NoArea,
            ),
            (vec![DVec3::ONE; 5], Fault::NoArea),
            (vec![DVec3::NAN, DVec3::X, DVec3::Y], Fault::NoArea),
            (
                flat(&[(0.0, 0.0), (3.0, 0.0), (0.0, 2.0), (3.0, 2.0), (1.0, 5.0)]),
                Fault::Crosses,
            ),
            ((0..5).map(star).collect(), Fault::Crosses),
        ];
        for (p, fault) in cases {
            assert_eq!(triangulate(&p), Err(fault), "{p:?}");
        }
        let zigzag: Vec<DVec3> = (0..CORNER_LIMIT + 1)
            .map(|k| DVec3::new(k as f64, (k % 2) as f64, 0.0))
            .chain([DVec3::new(0.0, 9.0, 0.0)])
            .collect();
        assert_eq!(triangulate(&zigzag), Err(Fault::TooMany));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]
        /// Polygons that are seen whole from their middle are simple; most are concave.
        #[test]
        fn random_polygons_are_covered_once(radii in prop::collection::vec(0.2..3.5f64, 3..24)) {
            let n = radii.len() as f64;
            let p: Vec<DVec3> = radii.iter().enumerate().map(|(k, r)| {
                let (s, c) = (std::f64::consts::TAU * k as f64 / n).sin_cos();
                DVec3::new(3.5 + r * c, 3.5 + r * s, 0.0)
            }).collect();
            prop_assume!(newell::area_vector(&p).z > 0.1);
            check(&p);
        }

        /// Turned about and moved, clockwise or not: the same triangles.
        #[test]
        fn any_plane_will_do(axis in (-3.0..3.0f64, -3.0..3.0f64, -3.0..3.0f64), far in -9.0..9.0f64) {
            let p = flat(&[(0.0, 0.0), (6.0, 0.0), (6.0, 4.0), (5.0, 4.0), (4.0, 1.0), (2.0, 1.0), (1.0, 4.0), (0.0, 4.0)]);
            let turn = DQuat::from_scaled_axis(DVec3::from(axis));
            let turned: Vec<DVec3> = p.iter().map(|p| turn * *p + DVec3::splat(far)).collect();
            let triangles = triangulate(&turned).unwrap();
            prop_assert_eq!(triangles.len(), 6);
            let normal = newell::normal(&turned).unwrap();
            let sum: f64 = triangles.iter().map(|t| {
                let a = newell::area_vector(&t.map(|i| turned[i])).dot(normal);
                assert!(a > 0.0);
                a
            }).sum();
            prop_assert!((sum - newell::area_vector(&turned).length()).abs() < 1e-9);
        }

        /// Anything at all gives triangles or a fault.
        #[test]
        fn nothing_panics(points in prop::collection::vec((-3..4i32, -3..4i32, -1..2i32), 0..12)) {
            let p: Vec<DVec3> = points.iter().map(|(x, y, z)| DVec3::new(f64::from(*x), f64::from(*y), f64::from(*z))).collect();
            if let Ok(t) = triangulate(&p) {
                prop_assert_eq!(t.len(), p.len() - 2);
            }
        }
    }
}
