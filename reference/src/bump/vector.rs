//! Unit vectors over a triangle by second differences (Hast 2004 §3.3.6, paper VI): the light and half-way vectors that
//! bumps are lit with, turned into the frame of the surface at each vertex, would become too short between vertices and
//! highlights vanish with them. Six-point quadratic interpolation of their three components, with the middles of the
//! edges at unit length, keeps the length without a square root per pixel: 6 additions in place of 3.

use crate::raster::Point;
use crate::shade::differences::Interpolant;
use crate::shade::quadratic::EDGES;
use glam::DVec3;

/// Where the vectors in the middles of the edges come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MidEdge {
    /// The normalised sum of the ends, (a + b)/√(2 + 2·a·b).
    Normalised,
    /// X-shading (3.254): (5 − a·b)/8·(a + b), one Newton step from the mean; no square root in the set-up either.
    Newton,
}

impl MidEdge {
    /// The vector half-way between two unit vectors; opposite ones have none.
    #[must_use]
    pub fn between(self, a: DVec3, b: DVec3) -> DVec3 {
        match self {
            Self::Normalised => (a + b).normalize_or_zero(),
            Self::Newton => (a + b) * ((5.0 - a.dot(b)) / 8.0),
        }
    }
}

/// Interpolates unit vectors at the vertices of a triangle on the screen; the three channels are x, y and z.
#[must_use]
pub fn quadratic(position: [Point; 3], ends: &[DVec3; 3], middle: MidEdge) -> Interpolant {
    let [a, b, c] = ends.map(|v| v.to_array());
    let [d, e, f] = EDGES.map(|(i, j)| middle.between(ends[i], ends[j]).to_array());
    Interpolant::quadratic(position, &[a, b, c, d, e, f])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::{Viewport, Walk};
    use crate::shade::barycentric::weights;

    /// Largest distance from the normalised linear blend, and least length, for three vectors `spread` degrees apart.
    fn worst(spread: f64, middle: Option<MidEdge>) -> (f64, f64) {
        let position =
            [(0, 0), (200 * 256, 40 * 256), (30 * 256, 180 * 256)].map(|(x, y)| Point { x, y });
        // On a cone around z, at equal angles from each other.
        let sine = (spread.to_radians() / 2.0).sin() * 2.0 / 3f64.sqrt();
        let ends = [0.0, 120.0, 240.0f64].map(|d| {
            let (s, c) = d.to_radians().sin_cos();
            DVec3::new(sine * c, sine * s, (1.0 - sine * sine).sqrt())
        });
        assert!((ends[0].angle_between(ends[1]).to_degrees() - spread).abs() < 1e-9);
        let six = quadratic(position, &ends, middle.unwrap_or(MidEdge::Normalised));
        let size = Viewport {
            width: 200,
            height: 180,
        };
        let (mut far, mut least) = (0.0f64, f64::INFINITY);
        for s in Walk::new(position, size).unwrap().spans(size.width) {
            for x in s.start..s.end {
                let w = weights(&position, x, s.y);
                let blend = ends[0] * w[0] + ends[1] * w[1] + ends[2] * w[2];
                let v = match middle {
                    Some(_) => DVec3::from_array(six.start(x, s.y).r),
                    None => blend,
                };
                far = far.max(v.distance(blend.normalize()));
                least = least.min(v.length());
            }
        }
        (far, least)
    }

    /// Errors by the angle between the vectors: what was measured, with some room. Linear interpolation is worst in the
    /// centre, (spread)²/6 short.
    #[test]
    fn lengths_are_kept() {
        for (spread, linear, six, newton) in [
            (10.0, 0.0052, 0.000_15, 0.000_15),
            (20.0, 0.021, 0.0011, 0.0012),
            (30.0, 0.048, 0.0038, 0.0042),
            (45.0, 0.104, 0.0127, 0.0157),
            (60.0, 0.185, 0.0306, 0.048),
        ] {
            let (l, short) = worst(spread, None);
            let (s, length) = worst(spread, Some(MidEdge::Normalised));
            let (n, _) = worst(spread, Some(MidEdge::Newton));
            println!("{spread}: linear {l:.5}, six points {s:.5}, X {n:.5}; lengths {short:.4} {length:.4}");
            assert!(l <= linear && s <= six && n <= newton);
            assert!(6.0 * s < l && 1.0 - length < 1.0 - short);
        }
    }

    #[test]
    fn opposite_vectors_have_no_middle() {
        for m in [MidEdge::Normalised, MidEdge::Newton] {
            assert_eq!(m.between(DVec3::X, DVec3::NEG_X), DVec3::ZERO);
            assert!(m.between(DVec3::X, DVec3::X).distance(DVec3::X) < 1e-15);
        }
        let (a, b) = (DVec3::X, DVec3::new(0.6, 0.8, 0.0));
        let mean = (a + b) / 2.0;
        let step = mean / 2.0 * (3.0 - mean.length_squared());
        assert!(MidEdge::Newton.between(a, b).distance(step) < 1e-15);
    }
}
