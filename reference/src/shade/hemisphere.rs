//! The hemisphere table (Loisel 1996, smooth shading): only x and y of the normal are interpolated, linearly on the
//! screen, and a table over the unit disc gives the colour. A normal that faces the viewer is known by its x and y in
//! the plane of the screen, z = √(1 − x² − y²); so where light and viewer are infinitely far, the table can hold *any*
//! function of the normal: any number of lights, any reflection model, or the picture of a mirrored environment
//! ("matcap", [`Table::environment`]).
//!
//! Work: two additions and one look-up per pixel, two dot products of weights per span.
//!
//! Error. Let ℓ be the length of the blended normal, r/ℓ the radius of the true one in the disc (r that of the blend):
//! the table is read at r, so the direction is off by arcsin(r/ℓ) − arcsin(r), which grows with r and falls with ℓ. With
//! ℓ² ≥ (1 + 2cos a)/3 for vertex normals up to a apart, and all of them within the radius ρ (then so are the blends,
//! a cap of the sphere being convex), it is at most [`direction_error`]. At the rim, where ρ = 1, that is arccos ℓ: the
//! method beats Gouraud only for ρ up to about 0.7 and is worse near silhouettes. The table itself is bilinear; towards the
//! rim z has no finite slope, and its error there goes with the root of the step. Coordinates outside the disc take the
//! value at its rim, and so do normals turned away from the viewer.

use super::barycentric::{steps, weights};
use super::light::Surroundings;
use super::shader::{Run, Shader};
use super::unit_normal;
use crate::geometry::Prepared;
use crate::parallel;
use crate::raster::Span;
use glam::{DMat3, DVec2, DVec3};

/// Entries along one side of the tables of the method.
pub const SIZE: usize = 256;

/// RGB as a function of x and y in −1..=1.
#[derive(Clone, Debug)]
pub struct Table {
    size: usize,
    entries: Vec<[f32; 3]>,
}

/// The unit vector with these x and y that faces the viewer (z ≥ 0); beyond the unit circle, the one on the circle.
#[must_use]
pub fn unit(at: DVec2) -> DVec3 {
    let square = at.length_squared();
    if square < 1.0 {
        at.extend((1.0 - square).sqrt())
    } else {
        at.normalize().extend(0.0)
    }
}

impl Table {
    /// Tabulates `f` of unit normals, the viewer in +z, with `size` ≥ 2 entries along each side.
    #[must_use]
    pub fn new(size: usize, f: impl Fn(DVec3) -> DVec3 + Sync + Send) -> Self {
        let size = size.max(2);
        let at = |i: usize| 2.0 * i as f64 / (size - 1) as f64 - 1.0;
        let entry = |k: usize| f(unit(DVec2::new(at(k % size), at(k / size)))).as_vec3();
        Self {
            size,
            entries: parallel::map(size * size, |k| entry(k).to_array()),
        }
    }

    /// The picture of an infinitely large environment in a mirror with the given normal: `f` is what is seen in a
    /// direction.
    #[must_use]
    pub fn environment(size: usize, f: impl Fn(DVec3) -> DVec3 + Sync + Send) -> Self {
        Self::new(size, |n| f(n * (2.0 * n.z) - DVec3::Z))
    }

    /// The value at `x`, `y`, bilinear between entries.
    #[must_use]
    pub fn value(&self, x: f64, y: f64) -> [f64; 3] {
        let last = self.size - 1;
        let place = |v: f64| {
            let v = (v.clamp(-1.0, 1.0) + 1.0) * 0.5 * last as f64;
            let cell = (v as usize).min(last - 1);
            (cell, v - cell as f64)
        };
        let ((i, u), (j, v)) = (place(x), place(y));
        let row = |j: usize| {
            let (a, b) = (
                self.entries[j * self.size + i],
                self.entries[j * self.size + i + 1],
            );
            [0, 1, 2].map(|c| f64::from(a[c]) * (1.0 - u) + f64::from(b[c]) * u)
        };
        let (low, high) = (row(j), row(j + 1));
        [0, 1, 2].map(|c| low[c] * (1.0 - v) + high[c] * v)
    }
}

/// A bound on the angle between the normal that is looked up and the true one, radians: vertex normals at most `spread`
/// apart, all facing the viewer with at most `radius` in the disc. Up to a spread of 120°; π/2 beyond.
#[must_use]
pub fn direction_error(spread: f64, radius: f64) -> f64 {
    let shortest = ((1.0 + 2.0 * spread.cos()) / 3.0).max(0.0).sqrt();
    let radius = radius.clamp(0.0, 1.0);
    radius.asin() - (radius * shortest).asin()
}

/// The method for the renderer: one table for each material. Meant for distant lights and viewers; near ones are taken
/// as seen from the centre of the scene.
pub struct Hemisphere {
    /// Takes world normals to x, y and z of the table.
    turn: DMat3,
    /// By material; those that nothing uses are missing.
    tables: Vec<Option<Table>>,
}

impl Hemisphere {
    /// Tabulates the materials of a scene under its lights.
    #[must_use]
    pub fn new(p: &Prepared) -> Self {
        let count = p.triangles.len().max(1) as f64;
        let centre = p.triangles.iter().map(|t| t.world[0] / count).sum();
        let s: &Surroundings = &p.surroundings;
        let view = s.view(centre);
        let view = if view == DVec3::ZERO { DVec3::Z } else { view };
        let (x, y) = view.any_orthonormal_pair();
        let back = DMat3::from_cols(x, y, view);
        let mut used = vec![false; s.materials().len()];
        for t in &p.triangles {
            used[t.material] = true;
        }
        let table = |(m, used): (usize, bool)| {
            used.then(|| Table::new(SIZE, |n| s.shade(m, centre, back * n)))
        };
        Self {
            turn: back.transpose(),
            tables: used.into_iter().enumerate().map(table).collect(),
        }
    }
}

/// What a triangle needs per span: x and y at its vertices and their change per pixel.
pub struct Plane {
    index: usize,
    vertices: [DVec2; 3],
    step: DVec2,
}

/// A walk over the disc.
pub struct Walk<'a> {
    table: Option<&'a Table>,
    at: DVec2,
    step: DVec2,
}

impl Shader for Hemisphere {
    type Triangle = Plane;
    type Run<'a> = Walk<'a>;

    fn triangle(&self, p: &Prepared, index: usize) -> Plane {
        let t = &p.triangles[index];
        let vertices = t.normal.map(|n| {
            let n = self.turn * unit_normal(t, n);
            if n.z < 0.0 {
                n.truncate().try_normalize().unwrap_or(DVec2::X)
            } else {
                n.truncate()
            }
        });
        let s = steps(&t.position);
        Plane {
            index,
            vertices,
            step: vertices[0] * s[0] + vertices[1] * s[1] + vertices[2] * s[2],
        }
    }

    fn start<'a>(&'a self, p: &'a Prepared, plane: &'a Plane, span: Span) -> Walk<'a> {
        let t = &p.triangles[plane.index];
        let (w, v) = (weights(&t.position, span.start, span.y), &plane.vertices);
        Walk {
            table: self.tables[t.material].as_ref(),
            at: v[0] * w[0] + v[1] * w[1] + v[2] * w[2],
            step: plane.step,
        }
    }
}

impl Run for Walk<'_> {
    fn colour(&self) -> [f64; 3] {
        self.table
            .map_or([0.0; 3], |t| t.value(self.at.x, self.at.y))
    }

    fn step(&mut self) {
        self.at += self.step;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::rngs::StdRng;
    use rand::{Rng, SeedableRng};

    /// A random unit vector within `radius` of the disc, near its border.
    fn normal(rng: &mut StdRng, radius: f64) -> DVec3 {
        let r = radius * rng.random_range(0.6..1.0f64).sqrt();
        let a = rng.random_range(0.0..std::f64::consts::TAU);
        unit(DVec2::new(r * a.cos(), r * a.sin()))
    }

    /// The errors that the literature study measured over spans with vertex normals a apart, by the radius of the
    /// normals, with z from the root. There they are the largest of random samples. The largest found here, where the
    /// worst cases are sampled as well, lie up to a third above, and more at the rim itself, which few random
    /// samples come near: there the largest is arccos ℓ = a/2. The bound holds for all.
    #[test]
    fn errors_by_angle_and_radius() {
        let study = [
            (0.5, [5e-4, 1.9e-3, 7.4e-3]),
            (0.7, [8e-4, 3.3e-3, 1.1e-2]),
            (0.87, [1.6e-3, 5.8e-3, 2.3e-2]),
            (1.0, [3.6e-2, 5.5e-2, 0.135]),
        ];
        let mut rng = StdRng::seed_from_u64(8);
        for (radius, row) in study {
            let room = if radius < 1.0 { 1.35 } else { 1.65 };
            for (spread, want) in [5f64, 10.0, 20.0].into_iter().zip(row) {
                let spread = spread.to_radians();
                let mut worst = 0.0f64;
                for _ in 0..30_000 {
                    // Anywhere, or both on the border, where the worst is.
                    let (a, b) = if rng.random_bool(0.9) {
                        let a = normal(&mut rng, radius);
                        let away = a.any_orthonormal_vector();
                        let turn = rng.random_range(0.0..std::f64::consts::TAU);
                        let away = glam::DQuat::from_axis_angle(a, turn) * away;
                        (a, a * spread.cos() + away * spread.sin())
                    } else {
                        let square = radius * radius;
                        let turn = ((spread.cos() - 1.0 + square) / square).acos();
                        let at = |turn: f64| unit(DVec2::from_angle(turn) * radius * (1.0 - 1e-12));
                        (at(0.0), at(turn))
                    };
                    if b.z < 0.0 || b.truncate().length() > radius {
                        continue;
                    }
                    let t: f64 = rng.random();
                    let blend = a.lerp(b, t);
                    let (truth, looked_up) = (blend.normalize(), unit(blend.truncate()));
                    // Over all lights the largest |N·L − N'·L| is |N − N'|.
                    worst = worst.max(truth.distance(looked_up));
                    let angle = truth.angle_between(looked_up);
                    assert!(angle <= direction_error(spread, radius) + 1e-7);
                }
                println!("ρ {radius}, {:2.0}°: {worst:.2e}", spread.to_degrees());
                assert!(
                    (0.95..room).contains(&(worst / want)),
                    "{radius} {spread}: {worst}"
                );
            }
        }
    }

    #[test]
    fn the_bound_holds_on_triangles_and_is_of_use() {
        let mut rng = StdRng::seed_from_u64(5);
        let mut most = 0.0f64;
        for _ in 0..50_000 {
            let radius = rng.random_range(0.1..1.0);
            let n = [0; 3].map(|_| normal(&mut rng, radius));
            let c = n[0].dot(n[1]).min(n[1].dot(n[2])).min(n[2].dot(n[0]));
            if c < -0.49 {
                continue;
            }
            let u: f64 = rng.random();
            let v = rng.random_range(0.0..=1.0 - u);
            let blend = n[0] * u + n[1] * v + n[2] * (1.0 - u - v);
            let error = blend.normalize().angle_between(unit(blend.truncate()));
            let bound = direction_error(c.clamp(-1.0, 1.0).acos(), radius);
            assert!(error <= bound + 1e-7, "{error} above {bound}");
            most = most.max(error / bound.max(1e-3));
        }
        assert!(most > 0.7, "{most}");
    }

    /// The error of the table itself, in LSB of a function of slope 1: quartered by half the step inside, halved by a
    /// quarter of it at the rim.
    #[test]
    fn entries_between_are_found_by_halving_the_step() {
        let worst = |size: usize, from: f64, to: f64| {
            let table = Table::new(size, |n| DVec3::splat(n.z));
            let mut rng = StdRng::seed_from_u64(2);
            let mut worst = 0.0f64;
            for _ in 0..40_000 {
                let r: f64 = rng.random_range(from..to);
                let a = rng.random_range(0.0..std::f64::consts::TAU);
                let at = DVec2::new(r * a.cos(), r * a.sin());
                worst = worst.max((table.value(at.x, at.y)[0] - unit(at).z).abs());
            }
            255.0 * worst
        };
        let (inner, rim) = (worst(SIZE, 0.0, 0.87), worst(SIZE, 0.87, 1.0));
        println!("table of {SIZE}: {inner:.4} LSB up to 0.87, {rim:.2} LSB at the rim");
        assert!(inner < 0.025 && rim < 11.0, "{inner} {rim}");
        assert!((3.2..4.8).contains(&(worst(SIZE / 2, 0.0, 0.87) / inner)));
        assert!((1.6..2.5).contains(&(worst(SIZE / 4, 0.87, 1.0) / rim)));
    }

    #[test]
    fn the_rim_is_guarded() {
        let table = Table::new(64, |n| n * n);
        for (x, y) in [(1.0, 1.0), (-7.0, 0.1), (1.0 + 1e-15, 0.0), (0.0, -1.0)] {
            let v = table.value(x, y);
            assert!(v.iter().all(|v| (0.0..=1.0 + 1e-6).contains(v)), "{v:?}");
            assert!(unit(DVec2::new(x, y)).is_normalized());
        }
        assert_eq!(unit(DVec2::new(2.0, 0.0)), DVec3::X);
    }

    /// A mirror that faces the viewer shows what is behind the viewer, one at 45° what is beside.
    #[test]
    fn mirrors_show_their_surroundings() {
        let sky = |d: DVec3| DVec3::new(d.x, d.y, d.z).max(DVec3::ZERO);
        let table = Table::environment(257, sky);
        let near = |v: [f64; 3], w: DVec3| assert!((DVec3::from(v) - w).length() < 1e-2, "{v:?}");
        near(table.value(0.0, 0.0), DVec3::Z);
        near(table.value(0.5f64.sqrt(), 0.0), DVec3::X);
        near(table.value(0.0, 0.5f64.sqrt()), DVec3::Y);
        near(table.value(0.0, -0.5), DVec3::Z * 0.5);
    }
}
