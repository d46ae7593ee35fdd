//! Euler shading: along a span p/√q is integrated by Euler's method from slopes at both ends, the change of slope being
//! constant (Hast 2004, eqs 3.8–3.12). Written out,
//!
//!   φ(t) = (1 − t)I_a + t·I_b + (1 − c)(I_a + I_b)/2·t(1 − t),  c = n_a·n_b,
//!
//! so its middle is (5 − c)/8·(n_a + n_b)·L, that of [`x_shading`](super::x_shading). n_a and n_b are the normals where
//! the row cuts the edges, blended and normalised there. (The end value in 3.8 that is printed as φ_n is the one the
//! uncorrected integration reaches.)
//!
//! Near lights: the vectors of L and H are treated like the normals, and the middle is the product of the two.
//!
//! Work for one light: per triangle nothing; per span two normalised normals, 5 dot products, about 12 multiplications a
//! function; per pixel 2 additions a function and a power.

use super::case::Case;
use super::corners::{Corners, Term};
use super::cut::{Cut, Side};
use super::form::{Quantity, Slide, Start};
use super::lit::Cosines;
use super::quadratic::EDGES;
use super::x_shading::XShading;
use glam::DVec3;

/// The method; see [`super::lit::Lit`].
pub struct Euler;

/// Normals, and L and H, at the vertices.
pub struct Vectors {
    normal: [DVec3; 3],
    others: [[DVec3; 3]; 2],
}

/// φ(first + k·step) for k = 0, 1, 2 …, between the ends with dot products `ends`; `bow` is (1 − c)(I_a + I_b)/2.
fn slide(ends: [f64; 2], bow: f64, cut: &Cut) -> Slide {
    let ([a, b], t, d) = (ends, cut.first, cut.step);
    Slide {
        r: (1.0 - t) * a + t * b + bow * t * (1.0 - t),
        dr: (b - a) * d + bow * d * (1.0 - 2.0 * t - d),
        d2r: -2.0 * bow * d * d,
    }
}

/// The direction of a blend along an edge; zero where opposite vectors cancel.
fn on_edge(v: &[DVec3; 3], side: Side) -> DVec3 {
    let (i, j) = EDGES[side.edge];
    v[i].lerp(v[j], side.t).normalize_or_zero()
}

impl Quantity for Vectors {
    type Walk = [Slide; 2];

    fn start(&self, at: &Start) -> [Slide; 2] {
        let cut = Cut::new(&at.position, at.span);
        let ends = |v: &[DVec3; 3]| [cut.left, cut.right].map(|s| on_edge(v, s));
        let middle = |[a, b]: [DVec3; 2]| (a + b) * XShading::Newton.factor(a.dot(b));
        let n = ends(&self.normal);
        self.others.map(|v| {
            let v = ends(&v);
            let dots = [n[0].dot(v[0]), n[1].dot(v[1])];
            let bow = 4.0 * middle(n).dot(middle(v)) - 2.0 * (dots[0] + dots[1]);
            slide(dots, bow, &cut)
        })
    }
}

impl Cosines for Euler {
    type Shared = ();
    type Own = Vectors;

    fn shared(&self, _: &Corners) {}

    fn own(&self, c: &Corners, t: &Term) -> Vectors {
        Vectors {
            normal: c.normal,
            others: [t.light, t.half],
        }
    }

    fn cosines((): &(), own: &[Slide; 2]) -> [f64; 2] {
        own.map(|c| c.r)
    }
}

/// Length (least, greatest) of the vector that stands for the unit normal, and its angle to it, rad, for a spread up to
/// 90°. Measured over random triangles and rows, with some room; the length of a span alone is least in its middle,
/// 1 − 3s⁴/128 to the fourth order, and never above 1.
#[must_use]
pub fn deviation(s: f64) -> ([f64; 2], f64) {
    let angle = 0.0366 * s.powi(3) * (1.0 + 0.13 * s * s);
    ([1.0 - 0.0236 * s.powi(4), 1.0], angle)
}

/// Bound on the error, LSB, for a far light and viewer and a spread up to 90°, the whole range otherwise. Proved but for
/// the figures of [`deviation`], which are measured.
#[must_use]
pub fn bound(case: &Case) -> f64 {
    case.replaced_when_acute(deviation)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shade::form::Step;
    use crate::shade::probe::{normals, Shape, SPREADS};
    use rand::rngs::StdRng;
    use rand::{Rng, SeedableRng};

    fn cut(first: f64, step: f64) -> Cut {
        Cut {
            first,
            step,
            ..Cut::default()
        }
    }

    /// Equations 3.9 to 3.12 as they stand: n steps from slopes at both ends, the first slope lowered so that the last
    /// value is met.
    #[test]
    fn the_closed_form_is_the_integration() {
        let mut rng = StdRng::seed_from_u64(3);
        for steps in [1u32, 2, 3, 10, 333, 2048] {
            let [a, b, l] = normals(&mut rng, 0.8, Shape::Any);
            let n = f64::from(steps);
            let (pa, pb, c) = (a.dot(l), b.dot(l), a.dot(b));
            let p = (pb - pa) / n;
            let qa = 2.0 * (c - 1.0) / n;
            let (from, to) = (p - pa * qa / 2.0, p + pb * qa / 2.0);
            let ds = (to - from) / n;
            // The end that the uncorrected integration reaches.
            let reached = pa + from * n + ds * n * (n - 1.0) / 2.0;
            let t0 = from - (reached - pb) / n;
            let mut slide = slide([pa, pb], (1.0 - c) * (pa + pb) / 2.0, &cut(0.0, 1.0 / n));
            for m in 0..=steps {
                let m = f64::from(m);
                let want = pa + t0 * m + ds * m * (m - 1.0) / 2.0;
                assert!(
                    (slide.r - want).abs() < 1e-12,
                    "{steps} {m}: {} {want}",
                    slide.r
                );
                slide.step();
            }
        }
    }

    #[test]
    fn on_an_edge_it_is_x_shading() {
        let mut rng = StdRng::seed_from_u64(4);
        for _ in 0..100 {
            let [a, b, l] = normals(&mut rng, 1.2, Shape::Any);
            let (ia, ib, c) = (a.dot(l), b.dot(l), a.dot(b));
            let bow = (1.0 - c) * (ia + ib) / 2.0;
            let x = XShading::Newton.form(&[a, b, a], &[l; 3], true);
            for t in [0.0, 0.2, 0.5, 0.9, 1.0] {
                let got = slide([ia, ib], bow, &cut(t, 0.0)).r;
                assert!((got - x.at([1.0 - t, t, 0.0])).abs() < 1e-14);
            }
            let middle = slide([ia, ib], bow, &cut(0.5, 0.0)).r;
            assert!((middle - (5.0 - c) / 8.0 * (ia + ib)).abs() < 1e-15);
        }
    }

    #[test]
    fn the_vector_in_place_of_the_normal_stays_where_it_is_stated_to_be() {
        for s in SPREADS {
            let s = s.to_radians();
            let ([least, greatest], angle) = deviation(s);
            let mut rng = StdRng::seed_from_u64(s.to_bits());
            let (mut short, mut wide) = (1.0f64, 0.0f64);
            for k in 0..20_000 {
                let shape = [Shape::Even, Shape::Thin, Shape::Any][k % 3];
                let n = normals(&mut rng, s, shape);
                let [a, b, t]: [f64; 3] = [0; 3].map(|_| rng.random());
                // A row from edge 01, or its end, to edge 02.
                let a = if k.is_multiple_of(2) { 1.0 } else { a };
                let (p, q) = (n[0].lerp(n[1], a), n[0].lerp(n[2], b));
                let truth = p.lerp(q, t).normalize();
                let (p, q) = (p.normalize(), q.normalize());
                let part = |l: DVec3| {
                    let (x, y) = (p.dot(l), q.dot(l));
                    slide([x, y], (1.0 - p.dot(q)) * (x + y) / 2.0, &cut(t, 0.0)).r
                };
                let m = DVec3::new(part(DVec3::X), part(DVec3::Y), part(DVec3::Z));
                short = short.min(m.length());
                wide = wide.max(m.cross(truth).length().atan2(m.dot(truth)));
                assert!(m.length() <= greatest + 1e-12);
            }
            assert!(short >= least && wide <= angle, "{s}: {short} {wide}");
            assert!(1.0 - short > 0.75 * (1.0 - least), "{s}: {short} {least}");
            assert!(wide > 0.75 * angle, "{s}: {wide} {angle}");
        }
    }
}
