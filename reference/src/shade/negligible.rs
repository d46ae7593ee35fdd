//! Parts of the reflection that a triangle does not need, by bounds that hold everywhere on it and not only at its
//! vertices.
//!
//! Everywhere on a triangle the vectors are non-negative sums of those at the vertices, normalised: N of the normals Nᵢ
//! (blended with positive weights, on the screen or in perspective), L of the Lⱼ (P − x = Σ qⱼ(P − xⱼ), and P − xⱼ is Lⱼ
//! times a length), V of the Vⱼ likewise. So for two such vectors u = Σaᵢuᵢ/|Σaᵢuᵢ| and v = Σbⱼvⱼ/|Σbⱼvⱼ|
//!
//! ```text
//! u·v = Σᵢⱼ aᵢbⱼ(uᵢ·vⱼ) / (|Σaᵢuᵢ|·|Σbⱼvⱼ|).
//! ```
//!
//! *No diffuse light* (S1): when all uᵢ·vⱼ ≤ 0 so is u·v; with u = N, v = L this is exact, for lights near and far.
//!
//! *How much highlight* (S2): with c the least dot product of two of the uᵢ and Σaᵢ = 1,
//! |Σaᵢuᵢ|² = 1 − 2Σ_{i<j} aᵢaⱼ(1 − uᵢ·uⱼ) ≥ 1 − 2(1 − c)/3 = (1 + 2c)/3 =: ρ², because Σ_{i<j} aᵢaⱼ ≤ 1/3. With M the
//! largest of the uᵢ·vⱼ therefore u·v ≤ M/(ρᵤρᵥ) where M > 0, and u·v ≤ M where not; the least one gives a lower bound in
//! the same way. Needs c > −1/2.
//!  * Constant H: N·H ≤ B from M = max Nᵢ·H.
//!  * Light or viewer near: N·H = (N·L + N·V)/|L + V| with |L + V|² = 2 + 2L·V, all three bounded.
//!  * Phong's R·V = 2(N·L)(N·V) − L·V: N·L + N·V = |L + V|·N·H and xy ≤ (x + y)²/4 for x > 0 give
//!    R·V ≤ (1 + L·V)·max(0, B)² − L·V; light or viewer near: R·V ≤ 2·max(0, N·L)·max(0, N·V) − L·V.
//!
//! No highlight function decreases with its cosine, so its value at the bound is a bound. The colour of the light is
//! bounded by [`Surroundings::brightest`](super::light::Surroundings::brightest).

use super::corners::{Corners, Term};
use crate::scene::Brdf;
use glam::DVec3;

/// Raises a bound by more than rounding lowers it.
const MARGIN: f64 = 1e-12;

/// Whether no light causes a diffuse reflection anywhere on the triangle.
#[must_use]
pub fn diffuse_is_zero(c: &Corners) -> bool {
    c.terms.iter().all(|t| {
        t.diffuse_peak == DVec3::ZERO || dots(&c.normal, &t.light).all(|cosine| cosine <= 0.0)
    })
}

/// A bound on the highlights of all lights together, anywhere on the triangle, in any channel, LSB; infinite where
/// nothing is known.
#[must_use]
pub fn specular_bound(c: &Corners) -> f64 {
    let one = |t: &Term| {
        let peak = t.specular_peak.max_element();
        if peak == 0.0 {
            return 0.0;
        }
        match c.brdf {
            Brdf::Lambert => 0.0,
            Brdf::Phong => peak * c.curve.value(reflected_cosine(c, t)),
            Brdf::Blinn => peak * c.curve.value(half_way_cosine(c, t)),
            Brdf::CookTorrance { .. } if half_way_cosine(c, t) <= 0.0 => 0.0,
            Brdf::CookTorrance { .. } => f64::INFINITY,
        }
    };
    c.terms.iter().map(one).sum()
}

fn dots<'a>(a: &'a [DVec3; 3], b: &'a [DVec3; 3]) -> impl Iterator<Item = f64> + 'a {
    a.iter().flat_map(move |u| b.iter().map(move |v| u.dot(*v)))
}

/// The least length ρ of a blend of unit vectors, weights summing to 1; none where they may cancel.
fn least_length(a: &[DVec3; 3]) -> Option<f64> {
    let c = a[0].dot(a[1]).min(a[0].dot(a[2])).min(a[1].dot(a[2]));
    (c > -0.499).then(|| ((1.0 + 2.0 * c) / 3.0).sqrt().min(1.0))
}

/// Bounds of u·v from below and above.
fn range(a: &[DVec3; 3], b: &[DVec3; 3]) -> (f64, f64) {
    let (Some(shrink_a), Some(shrink_b)) = (least_length(a), least_length(b)) else {
        return (-1.0, 1.0);
    };
    let grown = |m: f64| m * (1.0 + MARGIN) / (shrink_a * shrink_b);
    let low = dots(a, b).fold(f64::INFINITY, f64::min);
    let high = dots(a, b).fold(f64::NEG_INFINITY, f64::max);
    (
        if low < 0.0 { grown(low).max(-1.0) } else { low },
        if high > 0.0 {
            grown(high).min(1.0)
        } else {
            high
        },
    )
}

/// The vectors towards the viewer: L mirrored at H. None where H or L is missing.
fn view(t: &Term) -> Option<[DVec3; 3]> {
    let known = |v: &[DVec3; 3]| v.iter().all(|v| *v != DVec3::ZERO);
    (known(&t.light) && known(&t.half))
        .then(|| [0, 1, 2].map(|i| t.half[i] * (2.0 * t.half[i].dot(t.light[i])) - t.light[i]))
}

/// A bound on N·H.
fn half_way_cosine(c: &Corners, t: &Term) -> f64 {
    if t.constant {
        return match t.half[0] {
            DVec3::ZERO => -1.0,
            _ => range(&c.normal, &t.half).1,
        };
    }
    let Some(view) = view(t) else {
        return 1.0;
    };
    let sum = range(&c.normal, &t.light).1 + range(&c.normal, &view).1;
    let square = 2.0 + 2.0 * range(&t.light, &view).0;
    if sum <= 0.0 {
        // |L + V| is at most 2.
        sum / 2.0
    } else if square > MARGIN {
        (sum / square.sqrt()).min(1.0)
    } else {
        1.0
    }
}

/// A bound on R·V where N·L > 0.
fn reflected_cosine(c: &Corners, t: &Term) -> f64 {
    let Some(view) = view(t) else {
        return 1.0;
    };
    let facing = range(&c.normal, &t.light).1;
    if facing <= 0.0 {
        return -1.0;
    }
    let across = range(&t.light, &view).0;
    let bound = if t.constant {
        (1.0 + across) * half_way_cosine(c, t).max(0.0).powi(2) - across
    } else {
        2.0 * facing * range(&c.normal, &view).1.max(0.0) - across
    };
    (bound + MARGIN).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Prepared, ScreenTriangle};
    use crate::raster::Point;
    use crate::scene::{
        Attenuation, Camera, Falloff, Light, LightKind, Material, Projection, SpotWidth,
    };
    use crate::shade::Surroundings;
    use rand::rngs::StdRng;
    use rand::{Rng, SeedableRng};

    const TRIANGLES: usize = 20_000;

    fn vector(rng: &mut StdRng) -> DVec3 {
        loop {
            let v = DVec3::from_array(std::array::from_fn(|_| rng.random_range(-1.0..1.0)));
            if (0.01..1.0).contains(&v.length_squared()) {
                return v.normalize();
            }
        }
    }

    /// Any light, viewer and material.
    fn surroundings(rng: &mut StdRng) -> (Surroundings, Option<DVec3>, DVec3) {
        let eye = vector(rng) * rng.random_range(2.0..6.0);
        let distant = rng.random_bool(0.5);
        let camera = Camera {
            eye,
            target: DVec3::ZERO,
            up: eye.any_orthonormal_vector(),
            projection: if distant {
                Projection::Orthographic { height: 2.0 }
            } else {
                Projection::Perspective { fov: 40.0 }
            },
            near: 0.1,
            far: 100.0,
        };
        let position = vector(rng) * rng.random_range(1.5..6.0);
        let attenuation = Attenuation {
            constant: 0.2,
            linear: 0.1,
            quadratic: 0.3,
        };
        let kind = match rng.random_range(0..3) {
            0 => LightKind::Directional {
                direction: -position.normalize(),
            },
            1 => LightKind::Point {
                position,
                attenuation,
            },
            _ => LightKind::Spot {
                position,
                direction: (vector(rng) * 0.2 - position.normalize()).normalize(),
                falloff: Falloff::Soft,
                width: SpotWidth::Field(40.0),
                attenuation,
            },
        };
        let material = Material {
            brdf: [Brdf::Blinn, Brdf::Phong][rng.random_range(0..2usize)],
            specular: DVec3::new(0.5, 1.0, 0.2),
            shininess: 10f64.powf(rng.random_range(0.0..2.5)),
            ..Material::default()
        };
        let light = Light {
            kind,
            colour: DVec3::new(1.0, 0.8, 0.6),
        };
        let s = Surroundings::of(vec![light], vec![material], &camera);
        (s, distant.then(|| eye.normalize()), eye)
    }

    fn triangle(rng: &mut StdRng) -> ScreenTriangle {
        let normal = vector(rng);
        let (spread, size) = (rng.random_range(0.0..1.0), rng.random_range(0.01..0.8));
        let world = std::array::from_fn(|_| vector(rng) * size);
        ScreenTriangle {
            position: [(0, 0), (0, 2560), (2560, 0)].map(|(x, y)| Point { x, y }),
            inv_w: [1.0; 3],
            depth: [0.5; 3],
            world,
            normal: std::array::from_fn(|_| (normal + vector(rng) * spread).normalize()),
            uv: [glam::DVec2::ZERO; 3],
            material: 0,
            object: 0,
            face: 0,
        }
    }

    /// Diffuse and specular reflection from the definition at blend weights `q`.
    fn truth(
        s: &Surroundings,
        eye: (Option<DVec3>, DVec3),
        t: &ScreenTriangle,
        q: [f64; 3],
    ) -> (f64, f64) {
        let blend = |v: [DVec3; 3]| v[0] * q[0] + v[1] * q[1] + v[2] * q[2];
        let (x, n) = (blend(t.world), blend(t.normal).normalize());
        let v = eye.0.unwrap_or((eye.1 - x).normalize());
        let arriving = s.incident(0, x);
        let l = arriving.direction;
        let m = s.material(0);
        let cosine = if m.brdf == Brdf::Blinn {
            n.dot((l + v).normalize())
        } else if n.dot(l) > 0.0 {
            (2.0 * n.dot(l) * n - l).dot(v)
        } else {
            0.0
        };
        let highlight = cosine.max(0.0).powf(m.shininess);
        let specular = 255.0 * (arriving.colour * m.specular).max_element() * highlight;
        let diffuse = (arriving.colour * m.diffuse).max_element() * n.dot(l).max(0.0);
        (255.0 * diffuse, specular)
    }

    /// 20 000 triangles under any light, 40 points on each: no violation. And the bounds are of use.
    #[test]
    fn no_point_shows_more_than_the_bounds() {
        let mut rng = StdRng::seed_from_u64(9);
        let (mut unlit, mut matt, mut lit, mut close) = (0, 0, 0, 0);
        for _ in 0..TRIANGLES {
            let (s, view, eye) = surroundings(&mut rng);
            let p = Prepared::from_triangles((16, 16), [0; 3], vec![triangle(&mut rng)], s);
            let t = &p.triangles[0];
            let c = Corners::new(&p, 0);
            let (zero, bound) = (diffuse_is_zero(&c), specular_bound(&c));
            let (mut most, mut brightest) = (0.0f64, 0.0f64);
            for i in 0..40 {
                let u: f64 = rng.random();
                let v = rng.random_range(0.0..=1.0 - u);
                let q = match i {
                    0..3 => [0, 1, 2].map(|k| if k == i { 1.0 } else { 0.0 }),
                    3..9 => [u, 1.0 - u, 0.0],
                    _ => [u, v, 1.0 - u - v],
                };
                let (diffuse, specular) = truth(p.surroundings(), (view, eye), t, q);
                assert!(!zero || diffuse < 1e-10, "{diffuse}");
                assert!(specular <= bound * (1.0 + 1e-9), "{specular} above {bound}");
                (most, brightest) = (most.max(specular), brightest.max(diffuse));
            }
            unlit += usize::from(zero);
            lit += usize::from(brightest > 0.0);
            matt += usize::from(bound <= 0.5);
            close += usize::from(most <= 0.5);
        }
        println!(
            "no diffuse {unlit} of {}, no highlight {matt} of {close}",
            TRIANGLES - lit
        );
        assert!(unlit * 10 > (TRIANGLES - lit) * 6 && matt * 10 > close * 5);
    }

    /// The largest N·H that is allowed a highlight of half an LSB, ks = 1: the table of the literature study.
    #[test]
    fn thresholds_of_the_highlight() {
        let table = [
            (5.0, 0.287),
            (10.0, 0.536),
            (20.0, 0.732),
            (50.0, 0.883),
            (100.0, 0.940),
            (200.0, 0.969),
            (500.0, 0.988),
        ];
        for (shininess, cosine) in table {
            let below = |cosine: f64| {
                let n = DVec3::new(f64::sqrt(1.0 - cosine * cosine), 0.0, cosine);
                let c = Corners {
                    normal: [n; 3],
                    ..straight(shininess)
                };
                specular_bound(&c) <= 0.5
            };
            assert!(
                below(cosine - 0.001) && !below(cosine + 0.001),
                "{shininess}"
            );
        }
    }

    /// A triangle under one distant light of full strength.
    fn straight(shininess: f64) -> Corners {
        let camera = Camera {
            eye: DVec3::Z,
            target: DVec3::ZERO,
            up: DVec3::Y,
            projection: Projection::Orthographic { height: 2.0 },
            near: 0.1,
            far: 10.0,
        };
        let light = Light {
            kind: LightKind::Directional {
                direction: DVec3::NEG_Z,
            },
            colour: DVec3::ONE,
        };
        let material = Material {
            specular: DVec3::ONE,
            shininess,
            ..Material::default()
        };
        let s = Surroundings::of(vec![light], vec![material], &camera);
        let t = triangle(&mut StdRng::seed_from_u64(1));
        Corners::new(&Prepared::from_triangles((16, 16), [0; 3], vec![t], s), 0)
    }

    #[test]
    fn normals_that_may_cancel_promise_nothing() {
        let c = Corners {
            normal: [DVec3::X, DVec3::NEG_X, DVec3::Y],
            ..straight(50.0)
        };
        assert_eq!(specular_bound(&c), 255.0);
        let behind = Corners {
            normal: [DVec3::NEG_Z; 3],
            ..straight(50.0)
        };
        assert!(diffuse_is_zero(&behind));
        assert_eq!(specular_bound(&behind), 0.0);
    }
}
