//! Convex parts of triangles on the screen: where they overlap, which is nearer there, and how they are cut.

use crate::geometry::Prepared;
use crate::visibility::piece::Piece;
use crate::visibility::DepthPlane;

/// Depths that differ less, relative to how steep the faces are, are equal.
const EQUAL: f64 = 1e-9;
/// Parts are not cut thinner than this, pixels.
const THIN: f64 = 1e-6;

type Corner = [f64; 2];

/// A convex part of a triangle.
#[derive(Clone, Debug)]
pub(super) struct Part {
    pub piece: Piece,
    plane: DepthPlane,
    /// On the screen, pixels.
    corners: Vec<Corner>,
    pub low: Corner,
    pub high: Corner,
}

impl Part {
    pub(super) fn new(piece: Piece, plane: DepthPlane, corners: Vec<Corner>) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for c in &corners {
            for axis in 0..2 {
                low[axis] = low[axis].min(c[axis]);
                high[axis] = high[axis].max(c[axis]);
            }
        }
        Self {
            piece,
            plane,
            corners,
            low,
            high,
        }
    }

    fn depths(&self) -> impl Iterator<Item = f64> + '_ {
        self.corners.iter().map(|c| self.plane.at(c[0], c[1]))
    }

    /// Reversed depth of the farthest corner.
    pub(super) fn farthest(&self) -> f64 {
        self.depths().fold(f64::INFINITY, f64::min)
    }

    /// The parts on both sides of a line, where `f` is positive and negative; none when no corner is farther than
    /// `thickness` on one of them.
    pub(super) fn cut(&self, p: &Prepared, cut: &Cut) -> Option<[Self; 2]> {
        let over = |c: &Corner| cut.line.at(c[0], c[1]);
        if !self.corners.iter().any(|c| over(c) > cut.thickness)
            || !self.corners.iter().any(|c| over(c) < -cut.thickness)
        {
            return None;
        }
        let values = p.triangles[self.piece.triangle].position.map(|q| {
            let (x, y) = q.pixels();
            over(&[x, y])
        });
        let [inner, outer] = self.piece.cut(values);
        let part = |piece, sign: f64| {
            let corners = clip(&self.corners, |c| sign * over(c));
            Self::new(piece, self.plane, corners)
        };
        Some([part(inner, 1.0), part(outer, -1.0)])
    }
}

/// A function that is affine on the screen.
#[derive(Clone, Copy, Debug)]
enum Line {
    /// Difference of two depths.
    Depth(DepthPlane, DepthPlane),
    /// Distance from the line through a point in a direction of unit length, pixels.
    Edge(Corner, Corner),
}

impl Line {
    fn at(&self, x: f64, y: f64) -> f64 {
        match self {
            Self::Depth(a, b) => a.at(x, y) - b.at(x, y),
            Self::Edge(p, d) => d[0] * (y - p[1]) - d[1] * (x - p[0]),
        }
    }
}

/// Where a part is to be cut.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    line: Line,
    thickness: f64,
}

impl Cut {
    /// Where two parts are equally deep.
    pub(super) fn equally_deep(a: &Part, b: &Part) -> Self {
        Self {
            line: Line::Depth(a.plane, b.plane),
            thickness: equal(a, b),
        }
    }

    /// Along the edges of a part.
    pub(super) fn edges(part: &Part) -> impl Iterator<Item = Self> + '_ {
        (0..part.corners.len()).filter_map(|k| {
            let (p, q) = (part.corners[k], part.corners[(k + 1) % part.corners.len()]);
            let d = [q[0] - p[0], q[1] - p[1]];
            let length = d[0].hypot(d[1]);
            (length > THIN).then(|| Self {
                line: Line::Edge(p, [d[0] / length, d[1] / length]),
                thickness: THIN,
            })
        })
    }
}

/// The part of a convex polygon where `f` is not negative; points and lines are left where no more is.
fn clip(polygon: &[Corner], f: impl Fn(&Corner) -> f64) -> Vec<Corner> {
    let mut rest = Vec::with_capacity(polygon.len() + 1);
    for (k, a) in polygon.iter().enumerate() {
        let b = &polygon[(k + 1) % polygon.len()];
        let (fa, fb) = (f(a), f(b));
        if fa >= 0.0 {
            rest.push(*a);
        }
        if (fa > 0.0 && fb < 0.0) || (fa < 0.0 && fb > 0.0) {
            let t = fa / (fa - fb);
            rest.push([a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t]);
        }
    }
    rest
}

/// How the depths of two parts compare where they overlap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Relation {
    /// They do not overlap, or tie wherever they do.
    Free,
    FirstNearer,
    SecondNearer,
    Interpenetrate,
}

/// Depth differences between the planes of two parts that count as none.
fn equal(a: &Part, b: &Part) -> f64 {
    EQUAL * (1.0 + a.plane.steepness() + b.plane.steepness())
}

pub(super) fn relation(a: &Part, b: &Part) -> Relation {
    let mut overlap = a.corners.clone();
    let turn = orientation(&b.corners);
    for (k, p) in b.corners.iter().enumerate() {
        let q = &b.corners[(k + 1) % b.corners.len()];
        let inside =
            |c: &Corner| turn * ((q[0] - p[0]) * (c[1] - p[1]) - (q[1] - p[1]) * (c[0] - p[0]));
        overlap = clip(&overlap, inside);
        if overlap.is_empty() {
            return Relation::Free;
        }
    }
    let equal = equal(a, b);
    let (mut nearer, mut farther) = (false, false);
    for c in &overlap {
        let d = a.plane.at(c[0], c[1]) - b.plane.at(c[0], c[1]);
        nearer |= d > equal;
        farther |= d < -equal;
    }
    match (nearer, farther) {
        (false, false) => Relation::Free,
        (true, false) => Relation::FirstNearer,
        (false, true) => Relation::SecondNearer,
        (true, true) => Relation::Interpenetrate,
    }
}

/// The sign of a polygon's area.
fn orientation(corners: &[Corner]) -> f64 {
    let area: f64 = (0..corners.len())
        .map(|k| {
            let (p, q) = (corners[k], corners[(k + 1) % corners.len()]);
            p[0] * q[1] - p[1] * q[0]
        })
        .sum();
    area.signum()
}
