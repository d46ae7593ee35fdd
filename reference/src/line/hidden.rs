//! Hidden lines: over which part of itself an edge lies behind a face. Exact in the plane of the screen, so no depth
//! buffer and no pixel's distance from the line enters (the test of an edge against convex faces goes back to Roberts
//! 1963).
//!
//! Along the edge, P(t) = from + t·(to − from), the three edge functions of the triangle and the difference of nearness
//! δ(t) = face − edge are linear in t, so what is hidden is one interval: inside all edges (borders included) and
//! δ > ε. Two triangles that share an edge get the same bound there from the same two numbers, so no crack opens.
//!
//! **The offset ε.** Vertices are snapped to 1/256 pixel, each coordinate by at most half of that. A face moved so much
//! differs from where it was by at most (|∂n/∂x| + |∂n/∂y|)/2 (per sub-pixel), and so does an edge that lies in it; an
//! edge in the plane of a face is therefore at most ε = |∂n/∂x| + |∂n/∂y| behind it. The edges of a front face, edges on
//! coinciding faces and edges that meet a face in a vertex thus stay visible whatever the slope, and what is shown
//! wrongly lies no farther behind than one sub-pixel to the side would put it. On top come the roundings of f64.

use crate::raster::{area2, Point};

/// An edge on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight {
    /// Its ends, snapped.
    pub ends: [Point; 2],
    /// Nearness at its ends, affine on the screen, greater is nearer.
    pub nearness: [f64; 2],
}

/// A face that may hide edges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Occluder {
    /// Snapped vertices, in any order.
    pub position: [Point; 3],
    /// Nearness at the vertices.
    pub nearness: [f64; 3],
}

impl Occluder {
    /// Change of nearness per sub-pixel, |∂n/∂x| + |∂n/∂y|; the triangle must have an area.
    fn slope(&self) -> f64 {
        let [a, b, c] = self.position;
        let d = |p: Point, q: Point| {
            (
                f64::from(q.x) - f64::from(p.x),
                f64::from(q.y) - f64::from(p.y),
            )
        };
        let ((ux, uy), (vx, vy)) = (d(a, b), d(a, c));
        let (nu, nv) = (
            self.nearness[1] - self.nearness[0],
            self.nearness[2] - self.nearness[0],
        );
        let area = area2(self.position) as f64;
        (((nu * vy - nv * uy) / area).abs()) + (((nv * ux - nu * vx) / area).abs())
    }
}

/// The part of an edge that a face hides, as an interval of t in 0..=1; `None` where it hides nothing.
#[must_use]
pub fn hidden(edge: &Sight, face: &Occluder) -> Option<[f64; 2]> {
    let area = area2(face.position);
    if area == 0 {
        return None;
    }
    let side = |i: usize, p: Point| {
        let [_, b, c] = [0, 1, 2].map(|k| face.position[(i + k) % 3]);
        (area2([b, c, p]) * area.signum()) as f64
    };
    let ends = [0, 1, 2].map(|i| edge.ends.map(|p| side(i, p)));
    let (mut from, mut to) = (0.0f64, 1.0f64);
    for [a, b] in ends {
        if a < 0.0 && b < 0.0 {
            return None;
        }
        if a < 0.0 {
            from = from.max(a / (a - b));
        } else if b < 0.0 {
            to = to.min(a / (a - b));
        }
    }
    if from > to {
        return None;
    }
    let area = area.abs() as f64;
    let mix = |[a, b]: [f64; 2], t: f64| a + (b - a) * t;
    let largest = face
        .nearness
        .iter()
        .chain(&edge.nearness)
        .fold(0.0f64, |m, n| m.max(n.abs()));
    let offset = face.slope() + 1e-12 * largest;
    let behind = [from, to].map(|t| {
        let face: f64 = (0..3)
            .map(|i| mix(ends[i], t).max(0.0) / area * face.nearness[i])
            .sum();
        face - mix(edge.nearness, t) - offset
    });
    let crossing = || from + (to - from) * (behind[0] / (behind[0] - behind[1]));
    match behind.map(|d| d > 0.0) {
        [true, true] => Some([from, to]),
        [true, false] => Some([from, crossing()]),
        [false, true] => Some([crossing(), to]),
        [false, false] => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn at(x: i32, y: i32) -> Point {
        Point {
            x: x * 256,
            y: y * 256,
        }
    }

    fn edge(a: Point, b: Point, nearness: [f64; 2]) -> Sight {
        Sight {
            ends: [a, b],
            nearness,
        }
    }

    const SQUARE: [[(i32, i32); 3]; 2] = [
        [(10, 10), (20, 10), (20, 20)],
        [(10, 10), (20, 20), (10, 20)],
    ];

    fn square(n: f64) -> [Occluder; 2] {
        SQUARE.map(|t| Occluder {
            position: t.map(|(x, y)| at(x, y)),
            nearness: [n; 3],
        })
    }

    #[test]
    fn behind_a_square_between_its_borders() {
        let e = edge(at(0, 14), at(40, 14), [1.0; 2]);
        let parts = square(2.0).map(|f| hidden(&e, &f).unwrap());
        // The diagonal is met at x = 14; both triangles bound there by the same number.
        assert_eq!(parts[0], [0.35, 0.5]);
        assert_eq!(parts[1], [0.25, 0.35]);
        for f in square(0.5) {
            assert_eq!(hidden(&e, &f), None, "in front");
        }
        let beside = edge(at(0, 21), at(40, 22), [1.0; 2]);
        assert!(square(2.0).iter().all(|f| hidden(&beside, f).is_none()));
    }

    #[test]
    fn an_edge_that_pierces_the_face_is_hidden_from_there_on() {
        let e = edge(at(0, 14), at(40, 14), [3.0, 1.0]);
        let [part, _] = square(2.25).map(|f| hidden(&e, &f));
        let [from, to] = part.unwrap();
        assert!((from - 0.375).abs() < 1e-9 && to == 0.5, "{from} {to}");
    }

    #[test]
    fn along_the_diagonal_no_crack() {
        let e = edge(at(5, 5), at(25, 25), [1.0; 2]);
        for f in square(2.0) {
            assert_eq!(hidden(&e, &f), Some([0.25, 0.75]));
        }
    }

    #[test]
    fn points_and_faces_without_area() {
        let e = edge(at(15, 12), at(15, 12), [1.0; 2]);
        assert_eq!(hidden(&e, &square(2.0)[0]), Some([0.0, 1.0]));
        let flat = Occluder {
            position: [at(0, 0), at(10, 10), at(20, 20)],
            nearness: [9.0; 3],
        };
        assert_eq!(hidden(&e, &flat), None);
    }

    fn any_point() -> impl Strategy<Value = (f64, f64)> {
        (0.0..300.0f64, 0.0..300.0f64)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]
        /// Edges of a face, and any segment in the plane of it, stay visible after snapping, however steep the face.
        #[test]
        fn what_lies_in_the_plane_of_a_face_is_not_hidden(
            a in any_point(), b in any_point(), c in any_point(), s in (0.0..1.0f64, 0.0..1.0f64), t in (0.0..1.0f64, 0.0..1.0f64),
            plane in (-9.0..9.0f64, -9.0..9.0f64),
        ) {
            let snap = |(x, y): (f64, f64)| Point::snap(x, y).unwrap();
            let near = |(x, y): (f64, f64)| 5.0 + plane.0 * x + plane.1 * y;
            let face = Occluder { position: [a, b, c].map(snap), nearness: [a, b, c].map(near) };
            prop_assume!(area2(face.position) != 0);
            for (p, q) in [(a, b), (b, c), (c, a)] {
                let e = edge(snap(p), snap(q), [near(p), near(q)]);
                prop_assert_eq!(hidden(&e, &face), None);
            }
            let inside = |(u, v): (f64, f64)| {
                let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
                (a.0 + u * (b.0 - a.0) + v * (c.0 - a.0), a.1 + u * (b.1 - a.1) + v * (c.1 - a.1))
            };
            let (p, q) = (inside(s), inside(t));
            // Only where snapping has not turned the face over or made it a different one.
            let area = area2(face.position).abs() as f64 / 65536.0;
            let longest = [(a, b), (b, c), (c, a)].iter().map(|(p, q)| (p.0 - q.0).hypot(p.1 - q.1)).fold(0.0, f64::max);
            prop_assume!(area > longest);
            let e = edge(snap(p), snap(q), [near(p), near(q)]);
            prop_assert_eq!(hidden(&e, &face), None);
        }

        /// Against points: t is hidden exactly where the point is inside and behind.
        #[test]
        fn the_interval_is_what_points_say(
            v in prop::array::uniform3((0..4000i32, 0..4000i32)), e in prop::array::uniform2((0..4000i32, 0..4000i32)),
            n in prop::array::uniform3(0.0..1.0f64), m in prop::array::uniform2(0.0..1.0f64), k in 0..=200i32,
        ) {
            let p = |(x, y)| Point { x, y };
            let face = Occluder { position: v.map(p), nearness: n };
            prop_assume!(area2(face.position).abs() > 100_000);
            let edge = edge(p(e[0]), p(e[1]), m);
            let t = f64::from(k) / 200.0;
            let at = [0, 1].map(|i| {
                let (a, b) = if i == 0 { (e[0].0, e[1].0) } else { (e[0].1, e[1].1) };
                f64::from(a) + t * (f64::from(b) - f64::from(a))
            });
            // Barycentric weights by Cramer's rule.
            let f = |i: usize| [f64::from(v[i].0), f64::from(v[i].1)];
            let cross = |o: [f64; 2], a: [f64; 2], b: [f64; 2]| (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
            let whole = cross(f(0), f(1), f(2));
            let w = [cross(at, f(1), f(2)), cross(at, f(2), f(0)), cross(at, f(0), f(1))].map(|x| x / whole);
            let margin = w.iter().copied().fold(f64::INFINITY, f64::min);
            let gap = (0..3).map(|i| w[i] * n[i]).sum::<f64>() - (m[0] + t * (m[1] - m[0])) - face.slope();
            prop_assume!(margin.abs() > 1e-9 && gap.abs() > 1e-9);
            let got = hidden(&edge, &face).is_some_and(|[a, b]| (a..=b).contains(&t));
            prop_assert_eq!(got, margin > 0.0 && gap > 0.0);
        }
    }
}
