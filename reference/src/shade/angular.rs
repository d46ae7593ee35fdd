//! Angular interpolation: N turns at a constant rate along the edges and then along the span, and so do L and H; the
//! cosine of the angle between two arcs of great circles follows by spherical trigonometry (Kuijk and Blake 1989; Abbas
//! 2003, eqs 5.6 and 5.7):
//!
//!   cos θ = cos(l + l_t)·cos(n + n_t) + sin(l + l_t)·sin(n + n_t)·cos γ,
//!
//! with l and n the *signed* angles from the place S where the circles cross, and γ between the circles (5.7 must be
//! divided by the lengths of both cross products). S does not exist where an arc has no length or both lie on one circle,
//! so the same is written with the frames of the arcs, N = f cos n_t + g sin n_t: four dot products per span in the place
//! of S and γ, and nothing is undefined.
//!
//! Work for one light: per span 4 arcs (on both edges, and between), for N and, near, for L and H; 2 + 2 dot products
//! (4 + 4); per pixel 1 addition, a sine and a cosine for N, the same for each of L and H when near; 2 multiplications, 1
//! addition a cosine (6 and 3).

use super::case::Case;
use super::corners::{Corners, Term};
use super::cut::Cut;
use super::form::{Quantity, Start, Step};
use super::lit::Cosines;
use super::quadratic::EDGES;
use super::turn::Arc;
use glam::DVec3;

/// The method; see [`super::lit::Lit`].
pub struct Angular;

/// Normals, and L and H, at the vertices.
pub struct Vectors {
    normal: [DVec3; 3],
    others: [[DVec3; 3]; 2],
}

/// The arc along a span between arcs along two edges.
pub(crate) fn across(v: &[DVec3; 3], cut: &Cut) -> Arc {
    let end = |s: super::cut::Side| {
        let (i, j) = EDGES[s.edge];
        Arc::new(v[i], v[j]).at(s.t)
    };
    Arc::new(end(cut.left), end(cut.right))
}

/// An angle that grows evenly along a span.
#[derive(Clone, Copy, Debug)]
pub struct Turn {
    angle: f64,
    step: f64,
}

impl Turn {
    fn new(arc: &Arc, cut: &Cut) -> Self {
        Self {
            angle: arc.angle * cut.first,
            step: arc.angle * cut.step,
        }
    }
}

/// Two turning vectors: dot products of the frames of their arcs, by rows for the second vector.
#[derive(Clone, Copy, Debug)]
pub struct Pair {
    turn: Turn,
    dots: [[f64; 2]; 2],
}

/// A span: the turn of N, and L and H against it.
pub struct Arcs {
    normal: Turn,
    others: [Pair; 2],
}

impl Quantity for Vectors {
    type Walk = Arcs;

    fn start(&self, at: &Start) -> Arcs {
        let cut = Cut::new(&at.position, at.span);
        let n = across(&self.normal, &cut);
        let frame = <[DVec3; 2]>::from(n.frame());
        let pair = |v: &[DVec3; 3]| {
            let arc = across(v, &cut);
            Pair {
                turn: Turn::new(&arc, &cut),
                dots: <[DVec3; 2]>::from(arc.frame()).map(|a| frame.map(|f| a.dot(f))),
            }
        };
        Arcs {
            normal: Turn::new(&n, &cut),
            others: self.others.each_ref().map(pair),
        }
    }
}

impl Step for Arcs {
    fn step(&mut self) {
        self.normal.angle += self.normal.step;
        for p in &mut self.others {
            p.turn.angle += p.turn.step;
        }
    }
}

impl Pair {
    /// The cosine of the angle to a vector turned by an angle with this sine and cosine.
    fn cosine(&self, (sin, cos): (f64, f64)) -> f64 {
        let [across, along] = self.dots.map(|d| d[0] * cos + d[1] * sin);
        // A vector that does not turn needs no sine.
        if self.turn.angle == 0.0 {
            across
        } else {
            let (sin, cos) = self.turn.angle.sin_cos();
            across * cos + along * sin
        }
    }
}

impl Cosines for Angular {
    type Shared = ();
    type Own = Vectors;

    fn shared(&self, _: &Corners) {}

    fn own(&self, c: &Corners, t: &Term) -> Vectors {
        Vectors {
            normal: c.normal,
            others: [t.light, t.half],
        }
    }

    fn cosines((): &(), own: &Arcs) -> [f64; 2] {
        let turned = own.normal.angle.sin_cos();
        own.others.map(|p| p.cosine(turned))
    }
}

/// The farthest that turning at a constant rate and blending get apart on an arc of `angle` rad, rad. With
/// x = (2t − 1)·tan(angle/2), blending has turned by angle/2 + atan x at t; the difference is extreme where its slope is
/// that of the constant rate.
fn lag(angle: f64) -> f64 {
    let half = angle / 2.0;
    let tan = half.tan();
    if half < 1e-4 {
        // Third order; the difference below cancels.
        return angle.powi(3) * 0.0161;
    }
    let x = (tan / half - 1.0).max(0.0).sqrt();
    (half * x / tan - x.atan()).abs()
}

/// Bound on the error, LSB; proved for a spread and a turn up to 90°, the whole range otherwise. Angles add up:
///
/// - each end of the span departs from the blend along its edge by at most the lag of the longest edge, which turning
///   between the ends enlarges by at most 1/cos of half the angle between them;
/// - between the ends, turning and blending unit vectors differ by the lag of a span no longer than the longest edge;
/// - the true blend is that of the ends before they are normalised, of lengths cos(s/2) to 1: its share of one end
///   differs by at most −ln cos(s/2)/4, and the blend of unit vectors turns by at most 2·tan(s/2) per share.
///
/// L and H add the same for the turn.
#[must_use]
pub fn bound(case: &Case) -> f64 {
    if !case.is_acute() {
        return case.whole();
    }
    let one = |s: f64| {
        let edge = lag(s);
        let (sin, cos) = (s / 2.0).sin_cos();
        edge / (s / 2.0 + edge).cos() + edge - sin / cos * cos.ln() / 2.0
    };
    case.direction(one(case.spread) + one(case.turn))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shade::probe::{normals, Shape};
    use rand::rngs::StdRng;
    use rand::{Rng, SeedableRng};

    fn cut(first: f64) -> Cut {
        Cut {
            first,
            ..Cut::default()
        }
    }

    fn cosine(n: &Arc, l: &Arc, t: f64) -> f64 {
        let (a, b) = (<[DVec3; 2]>::from(n.frame()), <[DVec3; 2]>::from(l.frame()));
        let pair = Pair {
            turn: Turn::new(l, &cut(t)),
            dots: b.map(|v| a.map(|f| v.dot(f))),
        };
        pair.cosine(Turn::new(n, &cut(t)).angle.sin_cos())
    }

    /// Equations 5.6 and 5.7 with the place S where the circles cross, signed angles and the lengths that 5.7 lacks.
    #[test]
    fn it_is_the_published_trigonometry() {
        let mut rng = StdRng::seed_from_u64(8);
        for _ in 0..1000 {
            let [n0, n1, l0] = normals(&mut rng, 1.2, Shape::Any);
            let l1 = normals(&mut rng, 0.7, Shape::Any)[0];
            let (an, al) = (n0.cross(n1).normalize(), l0.cross(l1).normalize());
            let Some(s) = al.cross(an).try_normalize() else {
                continue;
            };
            let signed = |axis: DVec3, v: DVec3| s.cross(v).dot(axis).atan2(s.dot(v));
            let (l, n) = (signed(al, l0), signed(an, n0));
            let (n_arc, l_arc) = (Arc::new(n0, n1), Arc::new(l0, l1));
            for t in [0.0, 0.3, 0.5, 1.0] {
                let (lt, nt) = (l + t * l_arc.angle, n + t * n_arc.angle);
                let want = lt.cos() * nt.cos() + lt.sin() * nt.sin() * al.dot(an);
                assert!((cosine(&n_arc, &l_arc, t) - want).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn on_great_circles_it_is_exact() {
        let mut rng = StdRng::seed_from_u64(9);
        for _ in 0..1000 {
            let axis = normals(&mut rng, 1.0, Shape::Any)[0];
            let (e, f) = axis.any_orthonormal_pair();
            let on = |a: f64| e * a.cos() + f * a.sin();
            let from: f64 = rng.random_range(-3.0..3.0);
            let (turn, light) = (
                rng.random_range(1e-9..3.0),
                normals(&mut rng, 0.5, Shape::Any)[1],
            );
            let n = Arc::new(on(from), on(from + turn));
            for t in [0.0, 0.37, 1.0] {
                let truth = on(from + t * turn);
                assert!((cosine(&n, &Arc::new(light, light), t) - truth.dot(light)).abs() < 1e-12);
                // Both on one circle, where S does not exist.
                let l = Arc::new(on(from + 0.2), on(from + 0.2 + turn / 2.0));
                let want = (t * turn - 0.2 - t * turn / 2.0).cos();
                assert!((cosine(&n, &l, t) - want).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn the_lag_is_the_largest_there_is() {
        for s in [1e-5, 1e-3, 0.1, 0.5, 1.0, 1.57] {
            let (e, f) = (DVec3::X, DVec3::new(f64::cos(s), f64::sin(s), 0.0));
            let worst = (0..=2000)
                .map(|k| {
                    let t = f64::from(k) / 2000.0;
                    let b = e.lerp(f, t);
                    (b.y.atan2(b.x) - t * s).abs()
                })
                .fold(0.0, f64::max);
            assert!(
                worst <= lag(s) * (1.0 + 1e-3) + 1e-16,
                "{s}: {worst} {}",
                lag(s)
            );
            assert!(worst > 0.98 * lag(s) - 1e-16, "{s}: {worst} {}", lag(s));
        }
    }
}
