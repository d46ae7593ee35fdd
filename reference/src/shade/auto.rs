//! The cheapest way to draw each triangle within a given error: one colour, linear, quadratic, Phong's vectors per pixel, or
//! quadratic dot products, the first whose proved bound ([`super::bound`]) is small enough.

use super::bound::sampled::{noise, sample};
use super::bound::{Bounds, Tables};
use super::paint::{self, is_plain, Dots, Paint, Phong};
use super::shared::{self, Table};
use super::KNOT_MAX;
use crate::geometry::{Prepared, ScreenTriangle};
use crate::parallel;
use crate::raster::{area2, SUBPIXELS};
use crate::skips::{self, Skips};
use fearless_simd::Level;
use glam::DVec3;
use std::collections::BTreeMap;

/// What fixed point and f32 may add to the error of constant, linear and quadratic colours and of quadratic products, LSB (see
/// the renderer).
pub(crate) const ARITHMETIC: f64 = 0.02;

/// Triangles of fewer pixels are shaded per pixel without asking what would be enough.
const FEW: u64 = 12;

/// How a triangle is drawn, cheapest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Choice {
    /// One colour: the mean of the vertices.
    Constant,
    /// Linear between the vertices.
    Linear,
    /// Quadratic through six colours.
    Quadratic,
    /// Blended vectors, everything per pixel.
    Phong,
    /// Quadratic dot products, the power per pixel.
    Dots,
    /// The definition per pixel: nothing less is enough, or the material or a light is of another kind.
    Exact,
}

/// The plan for a prepared scene.
pub struct Auto<'a> {
    prepared: &'a Prepared,
    plan: Vec<Plan>,
    vertices: Table,
    edges: Table,
}

#[derive(Clone, Copy)]
struct Plan {
    choice: Choice,
    specular: bool,
    diffuse: bool,
    bounded: bool,
}

impl<'a> Auto<'a> {
    /// Chooses for every triangle; `error` is the largest error wanted, LSB, beside the rounding of the byte.
    #[must_use]
    pub fn new(p: &'a Prepared, error: f64, skips: &Skips, level: Level) -> Self {
        let tables = Tables::new(p);
        let vertices = shared::vertices(p);
        let plan = parallel::map(p.triangles.len(), |i| {
            let t = &p.triangles[i];
            if !is_plain(p, t) {
                Plan::whole(Choice::Exact)
            } else if skips.is_on(skips::BOUNDS) && is_few(t) {
                Plan {
                    bounded: false,
                    ..Plan::whole(per_pixel(p, t, error).0)
                }
            } else {
                let bounds = tables.of_plain(p, t);
                choose(p, t, &bounds, &vertices.of(i), error, skips, level)
            }
        });
        let edges = shared::edges(p, |i| plan[i].choice == Choice::Quadratic);
        Self {
            prepared: p,
            plan,
            vertices,
            edges,
        }
    }

    /// What triangle `i` is painted with.
    #[must_use]
    pub fn paint(&self, i: usize) -> Paint {
        let p = self.prepared;
        let (plan, t) = (self.plan[i], &p.triangles[i]);
        let paint = match plan.choice {
            Choice::Constant => Some(Paint::Constant(mean(&self.vertices.of(i)))),
            Choice::Linear => Some(Paint::Linear(self.vertices.of(i))),
            Choice::Quadratic => {
                let ([a, b, c], [d, e, f]) = (self.vertices.of(i), self.edges.of(i));
                Some(Paint::Quadratic([a, b, c, d, e, f]))
            }
            Choice::Dots => Dots::new(p, t, Dots::normals(t)).map(|mut d| {
                for t in &mut d.terms {
                    plan.thin(&mut t.diffuse, &mut t.specular);
                }
                Paint::Dots(d)
            }),
            Choice::Phong => Phong::new(p, t).map(|mut d| {
                for t in &mut d.terms {
                    plan.thin(&mut t.diffuse, &mut t.specular);
                }
                Paint::Phong(d)
            }),
            Choice::Exact => None,
        };
        paint.unwrap_or(Paint::Exact)
    }

    /// How triangle `i` is drawn.
    #[must_use]
    pub fn choice(&self, i: usize) -> Choice {
        self.plan[i].choice
    }

    /// Triangles for which work was left out, by reason.
    #[must_use]
    pub fn skipped(&self) -> BTreeMap<&'static str, u64> {
        let mut counts = BTreeMap::new();
        for plan in &self.plan {
            let mut count = |name: Option<&'static str>| {
                if let Some(name) = name {
                    *counts.entry(name).or_default() += 1;
                }
            };
            count(match plan.choice {
                Choice::Constant => Some(skips::FLAT_ENOUGH),
                Choice::Linear => Some(skips::LINEAR_ENOUGH),
                Choice::Quadratic => Some(skips::QUADRATIC_ENOUGH),
                Choice::Dots => Some(skips::PRODUCTS_ENOUGH),
                Choice::Phong | Choice::Exact => None,
            });
            count((!plan.specular).then_some(skips::SPECULAR));
            count((!plan.diffuse).then_some(skips::DIFFUSE));
            count((!plan.bounded).then_some(skips::BOUNDS));
        }
        counts
    }
}

impl Plan {
    /// A way to draw with all there is.
    fn whole(choice: Choice) -> Self {
        Self {
            choice,
            specular: true,
            diffuse: true,
            bounded: true,
        }
    }

    fn thin(self, diffuse: &mut DVec3, specular: &mut DVec3) {
        if !self.diffuse {
            *diffuse = DVec3::ZERO;
        }
        if !self.specular {
            *specular = DVec3::ZERO;
        }
    }
}

fn mean(knots: &[[f64; 3]; 3]) -> [f64; 3] {
    [0, 1, 2].map(|c| (knots[0][c] + knots[1][c] + knots[2][c]) / 3.0)
}

/// The cheapest way for a triangle of the kinds that every way draws.
fn choose(
    p: &Prepared,
    t: &ScreenTriangle,
    bounds: &Bounds,
    knots: &[[f64; 3]; 3],
    error: f64,
    skips: &Skips,
    level: Level,
) -> Plan {
    let room = error - ARITHMETIC;
    let enough = |way: &str, bound: f64| bound <= room && skips.is_on(way);
    // Knots that saturate are not where the polynomial wants them.
    let free = knots.iter().flatten().all(|k| *k < KNOT_MAX);
    if free {
        let m = mean(knots);
        let apart = |k: &[f64; 3]| (0..3).fold(0.0f64, |a, c| a.max((k[c] - m[c]).abs()));
        let spread = knots.iter().map(apart).fold(0.0, f64::max);
        if enough(skips::FLAT_ENOUGH, bounds.linear + spread) {
            return Plan::whole(Choice::Constant);
        }
        if enough(skips::LINEAR_ENOUGH, bounds.linear) {
            return Plan::whole(Choice::Linear);
        }
        let quadratic = enough(skips::QUADRATIC_ENOUGH, bounds.quadratic);
        if enough(skips::LINEAR_ENOUGH, bounds.linear_between)
            || (!quadratic && enough(skips::QUADRATIC_ENOUGH, bounds.quadratic_between))
        {
            if let Some(phong) = Phong::new(p, t) {
                let sampled = sample(level, &phong);
                let noise = noise(&phong);
                if enough(
                    skips::LINEAR_ENOUGH,
                    sampled.linear + bounds.linear_between + noise,
                ) {
                    return Plan::whole(Choice::Linear);
                }
                if enough(
                    skips::QUADRATIC_ENOUGH,
                    4.0 / 3.0 * sampled.quadratic + bounds.quadratic_between + noise,
                ) {
                    return Plan::whole(Choice::Quadratic);
                }
            }
        }
        if quadratic {
            return Plan::whole(Choice::Quadratic);
        }
    }
    let m = p.surroundings.material(t.material);
    // Eight pixels at a time, vectors cost less than products and their bounds: products where f32 is not enough.
    let (choice, left) = match per_pixel(p, t, error) {
        (Choice::Exact, _) if enough(skips::PRODUCTS_ENOUGH, bounds.dots) => {
            (Choice::Dots, room - bounds.dots)
        }
        other => other,
    };
    if choice == Choice::Exact {
        return Plan::whole(choice);
    }
    let has_highlight = m.specular != DVec3::ZERO;
    let specular = !(has_highlight && bounds.specular <= left && skips.is_on(skips::SPECULAR));
    let has_diffuse = m.diffuse != DVec3::ZERO;
    let diffuse = !(has_diffuse && bounds.diffuse <= 0.0 && skips.is_on(skips::DIFFUSE));
    Plan {
        choice,
        specular,
        diffuse,
        bounded: true,
    }
}

/// The way that needs no bound, and what it leaves of the error: vectors blended in f32 where that is accurate enough.
fn per_pixel(p: &Prepared, t: &ScreenTriangle, error: f64) -> (Choice, f64) {
    let left = error - paint::arithmetic(p, t);
    if left >= 0.0 {
        (Choice::Phong, left)
    } else {
        (Choice::Exact, error)
    }
}

/// Whether a triangle covers so few pixels that bounds cost more than they can save.
fn is_few(t: &ScreenTriangle) -> bool {
    area2(t.position).unsigned_abs() < 2 * FEW * (SUBPIXELS * SUBPIXELS) as u64
}
