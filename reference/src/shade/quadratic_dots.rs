//! Six-knot quadratics of the dot products, the power per pixel: ours, with the coefficients of [`super::quadric`].
//!
//! N·L and N·H are smooth where max(0, N·L) has a kink and (N·H)ⁿ a peak, so six knots do for them what they cannot do
//! for the colour: 0.4 LSB where six-knot colours have 5.4 (20°, n = 20). The knots are those of the *normalised* normal.
//! For a far light no normal is normalised per triangle: with bᵢ = wᵢnᵢ (w the perspective weight) the knot at a mid-edge is
//!
//!   (bᵢ·L + bⱼ·L)·f_ij,  f_ij = 1/|bᵢ + bⱼ|  (1/√(2 + 2nᵢ·nⱼ) without perspective, Hast 2004 section 6.7's upgrade),
//!
//! and f_ij belongs to the edge, whatever turns the mesh or moves the light. For near lights L and H are found anew at
//! the mid-edges. Both triangles at an edge get the same knots, so no seam shows.
//!
//! | work for each light | |
//! |---|---|
//! | pixel | 4 add, 1 power, 2 limits and the colours' 6 mul 6 add |
//! | span | 6 add when walked down the edge (here anew from exact weights, 24 mul 20 add) |
//! | triangle | 6 dots, 6 mul 6 add for the mid-edges, 22 add 10 shifts for two quadrics; 3 square roots an edge shares |

use super::case::Case;
use super::circular::{at, Ramp};
use super::corners::{Corners, Term};
use super::quadratic::EDGES;
use super::quadric::{Forward, Quadric};
use super::shader::{Run, Shader};
use super::CANCELLED;
use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::Span;
use glam::DVec3;
use smallvec::SmallVec;

/// The method.
pub struct QuadraticDots;

/// What a triangle keeps.
pub struct Setup {
    index: usize,
    corners: Corners,
    lights: SmallVec<[(Quadric, Option<Quadric>); 2]>,
}

/// The blend at one mid-edge before it is normalised, and what normalises it.
#[derive(Clone, Copy, Debug)]
struct Middle {
    blend: DVec3,
    factor: f64,
}

/// The three mid-edges of a triangle.
fn middles(t: &ScreenTriangle) -> [Middle; 3] {
    EDGES.map(|(i, j)| {
        let blend = t.normal[i] * t.inv_w[i] + t.normal[j] * t.inv_w[j];
        // Opposite normals cancel: there the normal of the face stands in.
        if blend.length_squared() > CANCELLED * (t.inv_w[i] + t.inv_w[j]).powi(2) {
            Middle {
                blend,
                factor: 1.0 / blend.length(),
            }
        } else {
            Middle {
                blend: t.face_normal(),
                factor: 1.0,
            }
        }
    })
}

/// Six knots of N·V, V constant.
fn constant(c: &Corners, middles: &[Middle; 3], v: DVec3) -> [f64; 6] {
    let at = c.normal.map(|n| n.dot(v));
    let mid = middles.map(|m| m.blend.dot(v) * m.factor);
    [at[0], at[1], at[2], mid[0], mid[1], mid[2]]
}

/// L and H at the three mid-edges, at the positions that are seen there.
fn near(p: &Prepared, t: &ScreenTriangle, light: usize) -> [(DVec3, DVec3); 3] {
    let s = &p.surroundings;
    EDGES.map(|(i, j)| {
        let x = (t.world[i] * t.inv_w[i] + t.world[j] * t.inv_w[j]) / (t.inv_w[i] + t.inv_w[j]);
        let l = s.incident(light, x).direction;
        (l, (l + s.view(x)).normalize_or_zero())
    })
}

/// The quadrics of light `k`.
fn quadrics(
    p: &Prepared,
    t: &ScreenTriangle,
    c: &Corners,
    k: usize,
    term: &Term,
) -> (Quadric, Option<Quadric>) {
    let middles = middles(t);
    if term.constant {
        let quadric = |v: DVec3| Quadric::quadratic(constant(c, &middles, v));
        return (
            quadric(term.light[0]),
            term.shines().then(|| quadric(term.half[0])),
        );
    }
    let there = near(p, t, k);
    let quadric = |v: &[DVec3; 3], mid: [DVec3; 3]| {
        let at = [0, 1, 2].map(|i| c.normal[i].dot(v[i]));
        let mid = [0, 1, 2].map(|i| middles[i].blend.dot(mid[i]) * middles[i].factor);
        Quadric::quadratic([at[0], at[1], at[2], mid[0], mid[1], mid[2]])
    };
    (
        quadric(&term.light, there.map(|v| v.0)),
        term.shines()
            .then(|| quadric(&term.half, there.map(|v| v.1))),
    )
}

/// One light along a span.
struct Lit {
    diffuse: (Forward, Ramp),
    specular: Option<(Forward, Ramp)>,
}

/// The current pixel of a span.
pub struct Along {
    ambient: DVec3,
    n: f64,
    lights: SmallVec<[Lit; 2]>,
}

impl Shader for QuadraticDots {
    type Triangle = Setup;
    type Run<'a> = Along;

    fn triangle(&self, p: &Prepared, index: usize) -> Setup {
        let (t, corners) = (&p.triangles[index], Corners::new(p, index));
        let lights = corners.terms.iter().enumerate();
        Setup {
            index,
            lights: lights
                .map(|(k, term)| quadrics(p, t, &corners, k, term))
                .collect(),
            corners,
        }
    }

    fn start<'a>(&'a self, p: &'a Prepared, t: &'a Setup, span: Span) -> Along {
        let (w, s) = at(&p.triangles[t.index].position, span);
        let forward = |q: &Quadric| q.start((w[1], w[2]), (s[1], s[2]));
        Along {
            ambient: t.corners.ambient,
            n: t.corners.shininess,
            lights: t
                .lights
                .iter()
                .zip(&t.corners.terms)
                .map(|((d, h), term)| Lit {
                    diffuse: (forward(d), Ramp::new(&term.diffuse, &w, &s)),
                    specular: h
                        .as_ref()
                        .map(|h| (forward(h), Ramp::new(&term.specular, &w, &s))),
                })
                .collect(),
        }
    }
}

impl Run for Along {
    fn colour(&self) -> [f64; 3] {
        let mut sum = self.ambient;
        for l in &self.lights {
            sum += l.diffuse.1.value() * l.diffuse.0.r.clamp(0.0, 1.0);
            if let Some((cos, colour)) = &l.specular {
                if cos.r > 0.0 {
                    sum += colour.value() * cos.r.min(1.0).powf(self.n);
                }
            }
        }
        sum.to_array()
    }

    fn step(&mut self) {
        for l in &mut self.lights {
            l.diffuse.0.step();
            l.diffuse.1.step();
            if let Some((cos, colour)) = &mut l.specular {
                cos.step();
                colour.step();
            }
        }
    }
}

/// The largest error of the six-knot quadratic of N·V, V constant, for a spread s of up to 90°: 0.027·s³·(1 + 0.1·s²).
/// Measured as the largest over random triangles and all V, 0.0251·s³ for small s, with a margin of 7 %: proved bounds
/// belong to single triangles.
#[must_use]
pub fn cosine_error(spread: f64) -> f64 {
    0.027 * spread.powi(3) * (1.0 + 0.1 * spread * spread)
}

/// Bound on |method − truth|, LSB, for a spread of up to 90°. For far lights measured: see [`cosine_error`]. Near lights may
/// be anywhere, also close to one vertex, so there only this is proved: over the triangle N·L differs by at most the
/// sum of spread and turn, thus by half of that from some constant, and six-knot interpolation, with its Lebesgue constant
/// of 5/3, errs by at most 8/3 times as much. The truth for this method takes L and H at the position of each pixel.
#[must_use]
pub fn bound(case: &Case) -> f64 {
    if case.spread > std::f64::consts::FRAC_PI_2 {
        return case.whole();
    }
    case.cosine(if case.turn == 0.0 {
        cosine_error(case.spread)
    } else {
        4.0 / 3.0 * (case.spread + case.turn)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Brdf, Highlight};
    use crate::shade::highlight::Curve;
    use crate::shade::quadratic;
    use rand::rngs::StdRng;
    use rand::{Rng, SeedableRng};

    /// The error of the six-knot quadratic of N as a vector is the largest of N·V over all V.
    fn miss(n: [DVec3; 3]) -> f64 {
        let mid = EDGES.map(|(i, j)| (n[i] + n[j]).normalize());
        let knots = [n[0], n[1], n[2], mid[0], mid[1], mid[2]];
        let quadric = [0, 1, 2].map(|c| Quadric::quadratic(knots.map(|k| k[c])));
        let mut worst = 0.0f64;
        for i in 0..=12 {
            for j in 0..=12 - i {
                let (u, v) = (f64::from(i) / 12.0, f64::from(j) / 12.0);
                let truth = (n[0] * (1.0 - u - v) + n[1] * u + n[2] * v).normalize();
                let got = DVec3::from_array(quadric.map(|q| q.value(u, v)));
                worst = worst.max(got.distance(truth));
            }
        }
        worst
    }

    #[test]
    fn the_measured_bound_of_cosines_holds_with_its_margin() {
        let mut rng = StdRng::seed_from_u64(3);
        for degrees in [2.0, 10.0, 20.0, 30.0, 45.0, 60.0, 90.0] {
            let spread = f64::to_radians(degrees);
            let mut worst = 0.0f64;
            for k in 0..400 {
                // On a cone, scaled until the two farthest apart are `spread` apart; some narrow, some even.
                let places = [0.0, 1.0, 2.0].map(|i| {
                    let narrow = if k % 2 == 0 {
                        1.0
                    } else {
                        rng.random_range(0.02..1.0)
                    };
                    (
                        i * 2.1 * narrow + rng.random_range(-0.1..0.1),
                        rng.random_range(0.6..1.0),
                    )
                });
                let at = |reach: f64| {
                    places.map(|(a, r): (f64, f64)| {
                        let (sin, cos) = (r * reach).sin_cos();
                        DVec3::new(sin * a.cos(), sin * a.sin(), cos)
                    })
                };
                let widest = |n: [DVec3; 3]| {
                    n[0].angle_between(n[1])
                        .max(n[0].angle_between(n[2]))
                        .max(n[1].angle_between(n[2]))
                };
                let (mut lo, mut hi) = (0.0, 1.5);
                for _ in 0..40 {
                    let mid = 0.5 * (lo + hi);
                    if widest(at(mid)) < spread {
                        lo = mid
                    } else {
                        hi = mid
                    }
                }
                worst = worst.max(miss(at(lo)));
            }
            let bound = cosine_error(spread);
            println!(
                "{degrees} deg: {worst:.3e} of {bound:.3e}, {:.3}",
                worst / bound
            );
            assert!(
                worst <= bound && worst > 0.75 * bound,
                "{degrees}: {worst} {bound}"
            );
        }
    }

    #[test]
    fn factors_of_edges_give_the_knots_of_normalised_normals() {
        let mut rng = StdRng::seed_from_u64(5);
        for _ in 0..200 {
            let mut vector = || {
                DVec3::new(
                    rng.random_range(-1.0..1.0),
                    rng.random_range(-1.0..1.0),
                    rng.random_range(0.2..1.0),
                )
            };
            let normal = [0; 3].map(|_| vector().normalize());
            let v = vector().normalize();
            let inv_w = [0; 3].map(|_| vector().z);
            let t = ScreenTriangle {
                uv: [glam::DVec2::ZERO; 3],
                position: Default::default(),
                inv_w,
                depth: [0.5; 3],
                world: [DVec3::ZERO, DVec3::X, DVec3::Y],
                normal,
                material: 0,
                object: 0,
                face: 0,
            };
            let c = Corners {
                normal,
                weight: inv_w,
                ambient: DVec3::ZERO,
                brdf: Brdf::Blinn,
                shininess: 1.0,
                curve: Curve::new(Highlight::Pow, 1.0),
                terms: SmallVec::new(),
            };
            let got = constant(&c, &middles(&t), v);
            for (k, (i, j)) in quadratic::EDGES.into_iter().enumerate() {
                let want = (normal[i] * inv_w[i] + normal[j] * inv_w[j])
                    .normalize()
                    .dot(v);
                assert!((got[3 + k] - want).abs() < 1e-14);
            }
            // Without perspective the factor is that of Hast: 1/√(2 + 2c).
            let even = ScreenTriangle {
                inv_w: [1.0; 3],
                ..t
            };
            let c01 = normal[0].dot(normal[1]);
            assert!((middles(&even)[0].factor - 1.0 / (2.0 + 2.0 * c01).sqrt()).abs() < 1e-12);
        }
    }

    #[test]
    fn opposite_normals_take_that_of_the_face() {
        let t = ScreenTriangle {
            uv: [glam::DVec2::ZERO; 3],
            position: Default::default(),
            inv_w: [1.0; 3],
            depth: [0.5; 3],
            world: [DVec3::ZERO, DVec3::X, DVec3::Y],
            normal: [DVec3::X, DVec3::NEG_X, DVec3::X],
            material: 0,
            object: 0,
            face: 0,
        };
        let m = middles(&t);
        assert_eq!(m[0].blend * m[0].factor, DVec3::Z);
        assert_eq!(m[1].blend * m[1].factor, DVec3::X);
    }
}
