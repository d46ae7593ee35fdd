//! Blake, Disselkoen and Kuijk's own algebra for trapezia with level sides: where the great circles of the left and of
//! the right edge meet, S, both edge normals are given by one angle each, and with λ and ρ the angles from S,
//!
//!   cos Δθ = cos λ·cos ρ + sin λ·sin ρ·(c_l·c_r),   cos φ_l = cos λ·(S·L) + sin λ·(c_l·L),   likewise on the right,
//!
//! c_l and c_r being the unit vectors across S along the two edges: no vector is blended per row. λ and ρ grow evenly
//! from row to row. The printed set-up (appendix of the paper) takes the sign of λ from a triple product that is already
//! oriented by the direction of travel; the angles must be signed, λ₀ = atan2(N·c_l, N·S). A triangle is two trapezia,
//! each with one edge collapsed to a vertex; S is the normal there, and no intersection can fail to exist.

use super::super::circular::{Ends, Sweeps};
use super::super::corners::Corners;
use super::super::cut::Cut;
use super::super::sweep::Sweep;
use super::super::turn::Arc;
use super::referred::{Referred, Turned};
use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::{Point, Span, SUBPIXELS};
use glam::DVec3;
use smallvec::SmallVec;

/// Ends by way of trapezia, normals turned to references.
pub struct Trapezia(pub Referred);

/// Two edge arcs from the top row (0) to the bottom row (1) of a trapezium.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Trapezium {
    /// λ and ρ at the top, rad.
    start: [f64; 2],
    /// Their change to the bottom, rad.
    change: [f64; 2],
    /// cos of the angle in which the edge arcs cross.
    crossing: f64,
    /// S·V, c_l·V and c_r·V.
    vector: [f64; 3],
}

/// The cosines of an edge pair, as a [`Sweep`] has them: N_l·V, N_r·V, N_l·N_r.
pub type Cosines = [f64; 3];

/// Normals closer than this (sine) count as equal.
const EQUAL: f64 = 1e-12;
/// Planes closer than this (sine) count as one: their intersection has too few digits left.
const COPLANAR: f64 = 1e-8;

impl Trapezium {
    /// Of the normals at top and bottom of the left and of the right edge, and the constant vector `v`.
    #[must_use]
    pub fn new(left: [DVec3; 2], right: [DVec3; 2], v: DVec3) -> Self {
        let equal = |a: DVec3, b: DVec3| a.dot(b) > 0.0 && a.cross(b).length() < EQUAL;
        let axis = |e: [DVec3; 2]| e[0].cross(e[1]).try_normalize();
        // An edge of one normal lies on every great circle through it: take that to the other edge's top.
        let constant = (equal(left[0], left[1]), equal(right[0], right[1]));
        let meet = match (axis(left), axis(right)) {
            _ if equal(left[0], right[0]) => left[0],
            _ if equal(left[1], right[1]) => left[1],
            _ if constant.0 => right[0],
            _ if constant.1 => left[0],
            // On one plane every vector in it is an intersection.
            (Some(l), Some(r)) if l.cross(r).length() > COPLANAR => l.cross(r).normalize(),
            _ => left[0],
        };
        let [l, r] = [left, right].map(|e| {
            // What rounding leaves of a normal that is the meeting point itself has no direction.
            let across = |n: DVec3| {
                let c = n - meet * n.dot(meet);
                if c.length() < EQUAL {
                    DVec3::ZERO
                } else {
                    c.normalize()
                }
            };
            let c = match axis(e) {
                Some(axis) if !equal(e[0], e[1]) => axis.cross(meet).normalize_or_zero(),
                // The circle through the constant normal.
                _ => across(e[0]),
            };
            let turned = Arc::new(e[0], e[1]).angle;
            (c, e[0].dot(c).atan2(e[0].dot(meet)), turned)
        });
        Self {
            start: [l.1, r.1],
            change: [l.2, r.2],
            crossing: l.0.dot(r.0),
            vector: [meet.dot(v), l.0.dot(v), r.0.dot(v)],
        }
    }

    /// The cosines at `t`, 0 at the top row and 1 at the bottom row.
    #[must_use]
    pub fn at(&self, t: f64) -> Cosines {
        let [(sl, cl), (sr, cr)] = [0, 1].map(|i| (self.start[i] + t * self.change[i]).sin_cos());
        [
            cl * self.vector[0] + sl * self.vector[1],
            cr * self.vector[0] + sr * self.vector[2],
            cl * cr + sl * sr * self.crossing,
        ]
    }
}

/// The upper and the lower trapezium of a triangle for one dot product.
pub type Halves = [Trapezium; 2];

/// What a triangle keeps.
pub struct Setup {
    /// Heights of the three vertices from the top, pixels.
    rows: [f64; 3],
    halves: SmallVec<[(Halves, Option<Halves>); 2]>,
}

/// Vertices from top to bottom, and whether the middle one lies left of the long edge.
fn sorted(p: &[Point; 3]) -> ([usize; 3], bool) {
    let mut order = [0, 1, 2];
    order.sort_by_key(|i| (p[*i].y, p[*i].x));
    let [t, m, b] = order;
    (order, crate::raster::area2([p[t], p[m], p[b]]) < 0)
}

impl Ends for Trapezia {
    type Triangle = Setup;

    fn triangle(&self, _: &Prepared, t: &ScreenTriangle, c: &Corners) -> Setup {
        let (order, left) = sorted(&t.position);
        let rows = order.map(|i| f64::from(t.position[i].y) / f64::from(SUBPIXELS));
        let height = rows[2] - rows[0];
        let share = if height > 0.0 {
            (rows[1] - rows[0]) / height
        } else {
            0.0
        };
        let halves = |(normal, v): Turned| {
            let [top, middle, bottom] = order.map(|i| normal[i]);
            let cut = Arc::new(top, bottom).at(share);
            let trapezium = |short: [DVec3; 2], long: [DVec3; 2]| {
                let (l, r) = if left { (short, long) } else { (long, short) };
                Trapezium::new(l, r, v)
            };
            [
                trapezium([top, middle], [top, cut]),
                trapezium([middle, bottom], [cut, bottom]),
            ]
        };
        Setup {
            rows,
            halves: self
                .0
                .turned(t.object, c)
                .into_iter()
                .map(|(diffuse, specular)| (halves(diffuse), specular.map(halves)))
                .collect(),
        }
    }

    fn sweeps(
        &self,
        t: &ScreenTriangle,
        _: &Corners,
        setup: &Setup,
        span: Span,
    ) -> SmallVec<[Sweeps; 2]> {
        let cut = Cut::new(&t.position, span);
        let [top, middle, bottom] = setup.rows;
        let row = f64::from(span.y) + 0.5;
        let half = usize::from(row >= middle && bottom > middle);
        let (from, to) = if half == 0 {
            (top, middle)
        } else {
            (middle, bottom)
        };
        let t = if to > from {
            ((row - from) / (to - from)).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let sweep = |h: &Halves| {
            let [l, r, turn] = h[half].at(t);
            let cos = turn.clamp(-1.0, 1.0);
            Sweep {
                from: l,
                to: r,
                cos,
                sin: (1.0 - cos * cos).sqrt(),
                first: cut.first,
                step: cut.step,
            }
        };
        setup
            .halves
            .iter()
            .map(|(diffuse, specular)| (sweep(diffuse), specular.as_ref().map(sweep)))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn unit() -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-1.0..1.0f64)
            .prop_map(|v| DVec3::from(v) * 0.8 + DVec3::Z)
            .prop_filter_map("no direction", DVec3::try_normalize)
    }

    fn check(left: [DVec3; 2], right: [DVec3; 2], v: DVec3) -> Result<(), TestCaseError> {
        let z = Trapezium::new(left, right, v);
        for i in 0..=8 {
            let t = f64::from(i) / 8.0;
            let (l, r) = (
                Arc::new(left[0], left[1]).at(t),
                Arc::new(right[0], right[1]).at(t),
            );
            let (got, want) = (z.at(t), [l.dot(v), r.dot(v), l.dot(r)]);
            for k in 0..3 {
                prop_assert!((got[k] - want[k]).abs() < 1e-9, "{t}: {got:?} {want:?}");
            }
        }
        Ok(())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn any_trapezium_is_two_slerps(a in unit(), b in unit(), c in unit(), d in unit(), v in unit()) {
            prop_assume!(a.cross(b).length() > 1e-3 && c.cross(d).length() > 1e-3);
            prop_assume!(a.cross(b).normalize().cross(c.cross(d).normalize()).length() > 1e-3);
            check([a, b], [c, d], v)?;
        }

        #[test]
        fn collapsed_constant_and_coplanar_ones_too(a in unit(), b in unit(), c in unit(), v in unit(), t in 0.1..0.9f64) {
            let arc = Arc::new(a, b);
            check([a, b], [a, c], v)?;
            check([a, b], [c, b], v)?;
            check([a, a], [b, c], v)?;
            check([a, b], [c, c], v)?;
            check([a, a], [b, b], v)?;
            check([a, a], [a, a], v)?;
            check([a, b], [a, b], v)?;
            // All on one great circle.
            prop_assume!(arc.angle > 1e-2);
            check([a, b], [arc.at(t), arc.at(0.9)], v)?;
        }
    }
}
