//! Methods that approximate the cosines N·L and N·H of each light and have everything else in common: from the cosines
//! of a pixel, limited to 0..=1, comes the colour
//!
//!   I = ambient + Σ diffuse·(N·L) + specular·(N·H)ⁿ,
//!
//! n by a true power. Colours that differ between the vertices (fall-off) are blended linearly on the screen. Per pixel
//! and light beside the cosines: one power and 6 multiplications, 6 additions for RGB.

use super::corners::{Corners, Term};
use super::form::{Quantity, Start, Step};
use super::shader::{Run, Shader};
use crate::geometry::Prepared;
use crate::raster::{Point, Span};
use glam::DVec3;
use smallvec::SmallVec;

/// A way to the cosines.
pub trait Cosines: Sync {
    /// What all lights share on a triangle.
    type Shared: Quantity;
    /// What each light has of its own.
    type Own: Quantity;

    /// The shared part of a triangle.
    fn shared(&self, corners: &Corners) -> Self::Shared;

    /// The part of one light.
    fn own(&self, corners: &Corners, term: &Term) -> Self::Own;

    /// N·L and N·H at a pixel, not limited.
    fn cosines(shared: &Along<Self::Shared>, own: &Along<Self::Own>) -> [f64; 2];

    /// (N·H)ⁿ from the second of the cosines, limited to 0..=1 and not 0.
    fn highlight(half: f64, n: f64) -> f64 {
        half.powf(n)
    }
}

/// What a quantity is along a span.
pub type Along<Q> = <Q as Quantity>::Walk;

/// A [`Cosines`] method for the renderer.
pub struct Lit<M>(pub M);

/// A triangle set up.
pub struct Surface<M: Cosines> {
    position: [Point; 3],
    ambient: DVec3,
    shininess: f64,
    shared: M::Shared,
    terms: SmallVec<[Own<M::Own>; 2]>,
}

/// One light on a triangle.
struct Own<Q> {
    cosines: Q,
    diffuse: Colour,
    specular: Colour,
}

/// A colour that is the same everywhere, or linear between the vertices.
struct Colour([DVec3; 3]);

impl Colour {
    fn start(&self, at: &Start) -> Tint {
        let [a, b, c] = self.0;
        if a == b && b == c {
            return Tint {
                value: a,
                step: DVec3::ZERO,
            };
        }
        let sum = |w: [f64; 3]| a * w[0] + b * w[1] + c * w[2];
        Tint {
            value: sum(at.weights),
            step: sum(at.steps),
        }
    }
}

/// A colour along a span.
struct Tint {
    value: DVec3,
    step: DVec3,
}

impl Tint {
    fn step(&mut self) {
        if self.step != DVec3::ZERO {
            self.value += self.step;
        }
    }
}

/// One light along a span.
struct Glow<W> {
    cosines: W,
    diffuse: Tint,
    specular: Tint,
}

/// A span.
pub struct Lights<M: Cosines> {
    ambient: DVec3,
    shininess: f64,
    shared: Along<M::Shared>,
    terms: SmallVec<[Glow<Along<M::Own>>; 2]>,
}

impl<M: Cosines> Shader for Lit<M> {
    type Triangle = Surface<M>;
    type Run<'a>
        = Lights<M>
    where
        M: 'a;

    fn triangle(&self, p: &Prepared, index: usize) -> Surface<M> {
        let c = Corners::new(p, index);
        let own = |term: &Term| Own {
            cosines: self.0.own(&c, term),
            diffuse: Colour(term.diffuse),
            specular: Colour(term.specular),
        };
        Surface {
            position: p.triangles[index].position,
            ambient: c.ambient,
            shininess: c.shininess,
            shared: self.0.shared(&c),
            terms: c.terms.iter().map(own).collect(),
        }
    }

    fn start<'a>(&'a self, _: &'a Prepared, t: &'a Surface<M>, span: Span) -> Lights<M> {
        let at = Start::new(t.position, span);
        let own = |o: &Own<M::Own>| Glow {
            cosines: o.cosines.start(&at),
            diffuse: o.diffuse.start(&at),
            specular: o.specular.start(&at),
        };
        Lights {
            ambient: t.ambient,
            shininess: t.shininess,
            shared: t.shared.start(&at),
            terms: t.terms.iter().map(own).collect(),
        }
    }
}

impl<M: Cosines> Run for Lights<M> {
    fn colour(&self) -> [f64; 3] {
        let mut sum = self.ambient;
        for term in &self.terms {
            let [light, half] = M::cosines(&self.shared, &term.cosines).map(limit);
            sum += term.diffuse.value * light;
            // At a shininess of 0 a power alone would light what is turned away.
            if half > 0.0 && term.specular.value != DVec3::ZERO {
                sum += term.specular.value * M::highlight(half, self.shininess);
            }
        }
        sum.to_array()
    }

    fn step(&mut self) {
        self.shared.step();
        for term in &mut self.terms {
            term.cosines.step();
            term.diffuse.step();
            term.specular.step();
        }
    }
}

/// A cosine limited to 0..=1; 0 for what is not a number.
#[must_use]
pub fn limit(cosine: f64) -> f64 {
    if cosine > 0.0 {
        cosine.min(1.0)
    } else {
        0.0
    }
}

/// L or H of a light for a method that normalises what it blends: as they are where they do not change, else
/// [`weighted`].
#[must_use]
pub fn directions(corners: &Corners, term: &Term, v: [DVec3; 3]) -> [DVec3; 3] {
    if term.constant {
        v
    } else {
        weighted(corners, v)
    }
}

/// p/√q, a cosine from a product and the product of squared lengths; 0 where vectors have cancelled and there is no
/// direction.
#[must_use]
pub fn over_root(p: f64, q: f64) -> f64 {
    if q > super::CANCELLED {
        p / q.sqrt()
    } else {
        0.0
    }
}

/// The vectors whose blend Σ λᵢwᵢvᵢ has the direction of the perspective-correct blend of `v`: each times its weight
/// 1/w, relative to the greatest of the three.
#[must_use]
pub fn weighted(corners: &Corners, v: [DVec3; 3]) -> [DVec3; 3] {
    let w = corners.weight;
    let greatest = w[0].max(w[1]).max(w[2]);
    [0, 1, 2].map(|i| v[i] * (w[i] / greatest))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::{Viewport, Walk};
    use crate::scene::{Brdf, Camera, Light, LightKind, Material, Projection};
    use crate::shade::barycentric::weights;
    use crate::shade::duff::Duff;
    use crate::shade::{unit_normal, Surroundings};
    use crate::ScreenTriangle;

    #[test]
    fn cosines_are_limited_and_never_undefined() {
        let cases = [
            (-0.5, 0.0),
            (0.0, 0.0),
            (0.25, 0.25),
            (1.5, 1.0),
            (f64::NAN, 0.0),
        ];
        for (c, want) in cases {
            assert_eq!(limit(c), want);
        }
        assert_eq!(over_root(3.0, 4.0), 1.5);
        assert_eq!(over_root(1.0, 0.0), 0.0);
        assert_eq!(over_root(1.0, f64::NAN), 0.0);
    }

    /// Two coloured lights on a coloured material: with exact cosines every channel is that of the reflection model.
    #[test]
    fn lights_add_up_in_every_channel() {
        let light = |direction: DVec3, colour: DVec3| Light {
            kind: LightKind::Directional {
                direction: direction.normalize(),
            },
            colour,
        };
        let lights = vec![
            light(DVec3::new(0.3, 0.1, -1.0), DVec3::new(1.0, 0.5, 0.2)),
            light(DVec3::new(-0.6, 0.4, -0.7), DVec3::new(0.1, 0.9, 0.4)),
        ];
        let material = Material {
            name: "m".into(),
            brdf: Brdf::Blinn,
            ambient: DVec3::new(0.1, 0.2, 0.05),
            diffuse: DVec3::new(0.4, 0.3, 0.7),
            specular: DVec3::new(0.5, 0.2, 0.9),
            shininess: 17.0,
            ..Material::default()
        };
        let camera = Camera {
            eye: DVec3::Z,
            target: DVec3::ZERO,
            up: DVec3::Y,
            projection: Projection::Orthographic { height: 2.0 },
            near: 0.1,
            far: 9.0,
        };
        let normal = [(0.0, 0.1), (0.5, 0.0), (-0.2, 0.6)];
        let t = ScreenTriangle {
            uv: [glam::DVec2::ZERO; 3],
            position: [(300, 9_000), (9_000, 8_000), (2_000, 500)].map(|(x, y)| Point { x, y }),
            inv_w: [1.0, 0.4, 2.0],
            depth: [0.5; 3],
            world: [DVec3::ZERO, DVec3::X, DVec3::Y],
            normal: normal.map(|(x, y)| DVec3::new(x, y, 1.0).normalize()),
            material: 0,
            object: 0,
            face: 0,
        };
        let s = Surroundings::of(lights, vec![material], &camera);
        let p = Prepared::from_triangles((40, 40), [0; 3], vec![t], s);
        let (method, size) = (
            Lit(Duff),
            Viewport {
                width: 40,
                height: 40,
            },
        );
        let setup = method.triangle(&p, 0);
        let mut pixels = 0;
        for span in Walk::new(t.position, size).iter().flat_map(|w| w.spans(40)) {
            let mut run = method.start(&p, &setup, span);
            for x in span.start..span.end {
                let w = weights(&t.position, x, span.y);
                let blend = (0..3).map(|i| t.normal[i] * (w[i] * t.inv_w[i])).sum();
                let want = p
                    .surroundings()
                    .shade(0, DVec3::ZERO, unit_normal(&t, blend));
                let got = DVec3::from_array(run.colour());
                assert!(got.distance(want) < 1e-9, "{got} {want}");
                run.step();
                pixels += 1;
            }
        }
        assert!(pixels > 400);
    }
}
