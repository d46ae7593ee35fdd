//! What a span core's host needs of a triangle: vectors and colours at its corners, kept as the rows of its knots.

use crate::stimulus::Triangle;
use shadegate_reference::scene::{Brdf, Highlight};
use shadegate_reference::shade::corners::{Corners, Term};
use shadegate_reference::shade::highlight::Curve;
use shadegate_reference::{depth, Prepared, ScreenTriangle};

/// Rows of the knots of such a triangle: normals, world positions, vectors to light and half-way at the three vertices;
/// perspective weights; colours ambient, diffuse, highlight; exponent, lights, material.
pub const KNOTS: usize = 17;

/// A triangle as the software methods see it.
#[derive(Clone, Debug)]
pub struct Surface {
    /// Where it is; texture and object are not known.
    pub triangle: ScreenTriangle,
    /// Vectors and colours at its corners; one light, or none that reaches it.
    pub corners: Corners,
}

/// Every triangle of a prepared scene for a span core, in drawing order.
#[must_use]
pub fn triangles(p: &Prepared) -> Vec<Triangle> {
    let one = |(index, t): (usize, &ScreenTriangle)| {
        let c = Corners::new(p, index);
        let zero = [[0.0; 3]; 3];
        let term = c.terms.first();
        let vectors = |f: &dyn Fn(&Term) -> [[f64; 3]; 3]| term.map_or(zero, f);
        let colour = |f: &dyn Fn(&Term) -> [f64; 3]| term.map_or([0.0; 3], f);
        let mut knots = vec![];
        knots.extend(c.normal.map(|n| n.to_array()));
        knots.extend(t.world.map(|x| x.to_array()));
        knots.extend(vectors(&|t| t.light.map(|v| v.to_array())));
        knots.extend(vectors(&|t| t.half.map(|v| v.to_array())));
        knots.push(c.weight);
        knots.push(c.ambient.to_array());
        knots.push(colour(&|t| t.diffuse[0].to_array()));
        knots.push(colour(&|t| t.specular[0].to_array()));
        let constant = term.is_some_and(|t| t.constant);
        let lights = if constant { 1.0 } else { 2.0 };
        let lights = term.map_or(0.0, |_| lights);
        knots.push([c.shininess, lights, t.material as f64]);
        Triangle {
            position: t.position,
            depth: t.depth.map(depth::scaled),
            knots,
            material: None,
            covering: None,
            relief: None,
            label: format!("object {}, face {}", t.object, t.face),
        }
    };
    p.triangles.iter().enumerate().map(one).collect()
}

/// Knots for a triangle that belongs to no scene: these normals, one far light, a shining surface.
#[must_use]
pub fn sample(normals: [[f64; 3]; 3], colours: [[f64; 3]; 3], exponent: f64) -> Vec<[f64; 3]> {
    let unit = |v: [f64; 3]| {
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        v.map(|x| x / length)
    };
    let mut knots: Vec<[f64; 3]> = normals.map(unit).to_vec();
    knots.extend([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    knots.extend([unit([0.3, 0.4, 0.8]); 3]);
    knots.extend([unit([0.16, 0.2, 0.96]); 3]);
    knots.push([1.0; 3]);
    knots.extend(colours);
    knots.push([exponent, 1.0, 0.0]);
    knots
}

impl Surface {
    /// From the knots of a triangle.
    ///
    /// # Errors
    /// Knots of another core, and vectors or colours that are no numbers.
    pub fn new(t: &Triangle) -> Result<Self, String> {
        let k: &[[f64; 3]; KNOTS] = t.knots.as_slice().try_into().map_err(|_| {
            format!(
                "{} knots where a span core takes {KNOTS} rows",
                t.knots.len()
            )
        })?;
        if let Some(bad) = k.iter().flatten().find(|v| !v.is_finite()) {
            return Err(format!("knot {bad} is not a finite number"));
        }
        let [exponent, lights, material] = k[16];
        let three = |i: usize| [0, 1, 2].map(|j| k[i + j].into());
        let term = Term {
            light: three(6),
            half: three(9),
            constant: lights == 1.0,
            diffuse: [k[14].into(); 3],
            specular: [k[15].into(); 3],
            diffuse_peak: k[14].into(),
            specular_peak: k[15].into(),
        };
        Ok(Self {
            triangle: ScreenTriangle {
                position: t.position,
                inv_w: k[12],
                depth: [0.0; 3],
                world: three(3),
                normal: three(0),
                uv: Default::default(),
                material: material as usize,
                object: 0,
                face: 0,
            },
            corners: Corners {
                normal: three(0),
                weight: k[12],
                ambient: k[13].into(),
                brdf: Brdf::Blinn,
                shininess: exponent,
                curve: Curve::new(Highlight::Pow, exponent),
                terms: (lights > 0.0).then_some(term).into_iter().collect(),
            },
        })
    }
}
