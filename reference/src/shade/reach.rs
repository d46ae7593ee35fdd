//! Which lights reach a triangle, and how bright they can be on it: bounds from a ball around the triangle.
//!
//! The ball has its centre C in the centroid and reaches to the farthest vertex, so it holds the triangle. Seen from a
//! light in P at the distance d = |C − P| > r, all of the ball lies within the angle β = arcsin(r/d) around C − P. With
//! θ the angle between C − P and the axis of a spot, no point of the ball is closer to the axis than θ − β, so its
//! cosine e is at most cos(θ − β) = cos θ·cos β + sin θ·sin β, or 1 where θ ≤ β or d ≤ r. The fall-off D never decreases with e and the
//! one with distance never increases, and no point is closer than d − r; hence the bound. Where D is 0 for the largest e
//! the cone misses the triangle. sin θ is taken from the cross product, which does not cancel at small angles, and e is
//! raised by more than rounding can lower it.

use super::attenuation;
use super::light::Surroundings;
use crate::geometry::ScreenTriangle;
use crate::parallel;
use crate::scene::LightKind;
use glam::DVec3;

/// Rounding of the ball and of the cosine, with room.
const MARGIN: f64 = 1e-12;

/// The lights that may reach a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reaching {
    /// One bit for each of the first 64 lights; those after them always may.
    mask: u64,
    lights: usize,
}

impl Reaching {
    /// Their numbers, in order.
    pub fn iter(self) -> impl Iterator<Item = usize> {
        (0..self.lights).filter(move |k| *k >= 64 || self.mask >> k & 1 == 1)
    }

    /// How many lights do not reach the triangle.
    #[must_use]
    pub fn missing(self) -> usize {
        self.lights - self.iter().count()
    }
}

impl Surroundings {
    /// Switches the skip of spots on or off.
    #[must_use]
    pub(crate) fn skipping_spots(mut self, on: bool) -> Self {
        self.skip_spots = on;
        self
    }

    /// The lights that may reach a triangle with these world positions; all of them when the skip is off.
    #[must_use]
    pub fn reaching(&self, world: &[DVec3; 3]) -> Reaching {
        let lights = self.lights();
        let mut mask = u64::MAX;
        if self.skip_spots {
            for k in (0..lights.min(64)).filter(|k| self.light(*k).1.is_some()) {
                if self.brightest(k, world) == DVec3::ZERO {
                    mask &= !(1 << k);
                }
            }
        }
        Reaching { mask, lights }
    }

    /// A bound on the colour of light `k` anywhere on a triangle, fractions of full scale; zero only where the light
    /// cannot reach it.
    #[must_use]
    pub fn brightest(&self, k: usize, world: &[DVec3; 3]) -> DVec3 {
        let (light, cone) = self.light(k);
        let (from, axis, fall_off) = match light.kind {
            LightKind::Directional { .. } => return light.colour,
            LightKind::Point {
                position,
                attenuation,
            } => (position, DVec3::ZERO, attenuation),
            LightKind::Spot {
                position,
                direction,
                attenuation,
                ..
            } => (position, direction, attenuation),
        };
        let centre = (world[0] + world[1] + world[2]) / 3.0;
        let largest = |least: f64, of: [f64; 3]| of.into_iter().fold(least, f64::max);
        let radius = largest(0.0, world.map(|v| v.distance(centre)));
        let size = largest(from.length(), world.map(DVec3::length));
        let radius = radius + MARGIN * (radius + size);
        let to = centre - from;
        let nearest = (to.length() - radius).max(0.0);
        let beside = cone.map_or(1.0, |c| c.factor(largest_cosine(to, axis, radius)));
        light.colour * (attenuation::factor(&fall_off, nearest) * beside)
    }
}

/// The largest cosine from `axis` of any point in the ball at `to` with `radius`, seen from the origin.
fn largest_cosine(to: DVec3, axis: DVec3, radius: f64) -> f64 {
    let distance = to.length();
    if distance <= radius {
        return 1.0;
    }
    let sin_ball = radius / distance;
    let cos_ball = ((1.0 - sin_ball) * (1.0 + sin_ball)).sqrt();
    let (cos, sin) = (to.dot(axis) / distance, to.cross(axis).length() / distance);
    // The axis passes through the ball: θ ≤ β.
    if cos > 0.0 && sin <= sin_ball {
        return 1.0;
    }
    (cos * cos_ball + sin * sin_ball + MARGIN).min(1.0)
}

/// How many pairs of a light and a triangle are skipped.
#[must_use]
pub(crate) fn missing(s: &Surroundings, triangles: &[ScreenTriangle]) -> u64 {
    if (0..s.lights()).all(|k| s.light(k).1.is_none()) {
        return 0;
    }
    let missing = |t: &ScreenTriangle| s.reaching(&t.world).missing() as u64;
    parallel::sum(triangles.len(), |range| {
        triangles[range].iter().map(missing).sum()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Attenuation, Camera, Falloff, Light, Material, Projection, SpotWidth};
    use rand::rngs::StdRng;
    use rand::{Rng, SeedableRng};

    fn surroundings(kind: LightKind) -> Surroundings {
        let camera = Camera {
            eye: DVec3::Z * 9.0,
            target: DVec3::ZERO,
            up: DVec3::Y,
            projection: Projection::Perspective { fov: 40.0 },
            near: 0.1,
            far: 100.0,
        };
        let light = Light {
            kind,
            colour: DVec3::new(1.0, 2.0, 0.5),
        };
        Surroundings::of(vec![light], vec![Material::default()], &camera)
    }

    fn vector(rng: &mut StdRng, size: f64) -> DVec3 {
        DVec3::from_array(std::array::from_fn(|_| rng.random_range(-size..size)))
    }

    fn triangle(world: [DVec3; 3]) -> ScreenTriangle {
        ScreenTriangle {
            position: [crate::raster::Point::default(); 3],
            inv_w: [1.0; 3],
            depth: [0.0; 3],
            world,
            normal: [DVec3::Z; 3],
            uv: [glam::DVec2::ZERO; 3],
            material: 0,
            object: 0,
            face: 0,
        }
    }

    /// 20 000 random triangles and lights, 40 points on each: never brighter than the bound, never lit where skipped.
    #[test]
    fn no_point_is_brighter_than_the_bound() {
        let mut rng = StdRng::seed_from_u64(4);
        let (mut dark, mut useful) = (0, 0);
        for _ in 0..20_000 {
            let position = vector(&mut rng, 3.0);
            let attenuation = Attenuation {
                constant: rng.random_range(0.0..1.0),
                linear: rng.random_range(0.0..1.0),
                quadratic: rng.random_range(0.0..1.0),
            };
            let falloff =
                [Falloff::Warn, Falloff::Soft, Falloff::Hard][rng.random_range(0..3usize)];
            let s = surroundings(if rng.random_bool(0.2) {
                LightKind::Point {
                    position,
                    attenuation,
                }
            } else {
                LightKind::Spot {
                    position,
                    direction: vector(&mut rng, 1.0).normalize(),
                    falloff,
                    width: SpotWidth::Field(10f64.powf(rng.random_range(-1.0..2.25))),
                    attenuation,
                }
            });
            let size = 10f64.powf(rng.random_range(-6.0..1.0));
            let at = vector(&mut rng, 4.0);
            let world = std::array::from_fn(|_| at + vector(&mut rng, size));
            let bound = s.brightest(0, &world);
            let skipped = s.reaching(&world).missing() == 1;
            assert_eq!(skipped, bound == DVec3::ZERO && s.light(0).1.is_some());
            dark += usize::from(skipped);
            let mut most = DVec3::ZERO;
            for i in 0..40 {
                let u: f64 = rng.random();
                let v = rng.random_range(0.0..=1.0 - u);
                // Edges and vertices as well.
                let q = match i % 4 {
                    0 => [u, 1.0 - u, 0.0],
                    1 => [1.0, 0.0, 0.0],
                    _ => [u, v, 1.0 - u - v],
                };
                let x = world[i % 3] * q[0] + world[(i + 1) % 3] * q[1] + world[(i + 2) % 3] * q[2];
                let c = s.incident(0, x).colour;
                assert!(c.cmple(bound).all(), "{c} above {bound}");
                most = most.max(c);
            }
            useful += usize::from(most.x > 0.8 * bound.x && most.x > 0.0);
        }
        println!("{dark} skipped, {useful} bounds within a quarter of the truth");
        assert!(dark > 2000 && useful > 2000, "{dark} {useful}");
    }

    #[test]
    fn a_cone_that_touches_is_kept_and_switched_off_means_all() {
        let spot = |direction| LightKind::Spot {
            position: DVec3::ZERO,
            direction,
            falloff: Falloff::Hard,
            width: SpotWidth::Field(20.0),
            attenuation: Attenuation::NONE,
        };
        let world = [DVec3::X, DVec3::Y, DVec3::Z].map(|v| v * 0.1 + DVec3::Z * 5.0);
        let toward = surroundings(spot(DVec3::Z));
        assert_eq!(toward.reaching(&world).iter().count(), 1);
        for away in [DVec3::NEG_Z, DVec3::X] {
            let s = surroundings(spot(away));
            assert_eq!(s.reaching(&world).iter().count(), 0);
            assert_eq!(missing(&s, &[triangle(world), triangle(world)]), 2);
            let s = s.skipping_spots(false);
            assert_eq!(s.reaching(&world).iter().collect::<Vec<_>>(), [0]);
        }
        // The light within the ball around the triangle.
        let around = [DVec3::X, DVec3::Y, DVec3::new(-1.0, -1.0, 0.0)];
        assert_eq!(
            surroundings(spot(DVec3::NEG_Z)).reaching(&around).missing(),
            0
        );
    }
}
