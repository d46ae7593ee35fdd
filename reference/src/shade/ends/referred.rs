//! Light and viewer in the scene, as Blake, Disselkoen and Kuijk 1992 (section 3.5) have them: each vertex normal is
//! turned by the smallest rotation that takes its own L (or H) to one reference, and the triangle is shaded with that
//! constant vector. The vertices stay exact. Two triangles with different references would differ along their common
//! edge by up to 10 LSB at a turn of 40°, so there is one reference for each light and object: the mean over its
//! vertices. For far lights nothing is turned. Edges are slerped.

use super::super::circular::{Ends, Sweeps};
use super::super::corners::{Corners, Term};
use super::super::cut::Cut;
use super::super::sweep::Sweep;
use super::super::turn::{carry, Arc};
use super::slerped::{arcs, between};
use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::Span;
use glam::DVec3;
use smallvec::SmallVec;

/// The references of a scene.
pub struct Referred {
    /// For each object and light the references for L and for H.
    references: Vec<Vec<[DVec3; 2]>>,
}

/// One dot product: arcs of the turned normals, and the vector that stays.
#[derive(Clone, Copy, Debug)]
pub struct Still {
    /// Along the edges.
    pub arcs: [Arc; 3],
    /// L or H.
    pub vector: DVec3,
}

/// The dot products of one light; none for a highlight that cannot be seen.
pub type Stills = (Still, Option<Still>);

impl Referred {
    /// Takes the mean L and H of every object, for the lights that are near.
    #[must_use]
    pub fn new(p: &Prepared) -> Self {
        let s = &p.surroundings;
        let objects = p.triangles.iter().map(|t| t.object + 1).max().unwrap_or(0);
        let near: Vec<usize> = (0..s.lights()).filter(|k| !s.is_constant(*k)).collect();
        let mut references = vec![vec![[DVec3::ZERO; 2]; s.lights()]; objects];
        for t in &p.triangles {
            for x in t.world {
                for k in near.iter().copied() {
                    let light = s.incident(k, x).direction;
                    references[t.object][k][0] += light;
                    references[t.object][k][1] += (light + s.view(x)).normalize_or_zero();
                }
            }
        }
        for reference in references.iter_mut().flatten().flatten() {
            *reference = reference.normalize_or_zero();
        }
        Self { references }
    }

    /// The reference for `v` of a light: its own direction where it is constant or where no mean exists.
    fn reference(&self, term: &Term, v: &[DVec3; 3], mean: DVec3) -> DVec3 {
        if term.constant || mean == DVec3::ZERO {
            v[0]
        } else {
            mean
        }
    }

    /// Vertex normals turned to the references, for each light: for L and, when there is a highlight, for H.
    #[must_use]
    pub fn turned(&self, object: usize, c: &Corners) -> SmallVec<[TurnedTerms; 2]> {
        let normals = |v: &[DVec3; 3], to: DVec3| {
            [0, 1, 2].map(|i| {
                // Opposite to the reference there is no smallest rotation; half a turn about any normal to it will do.
                carry(c.normal[i], v[i], to).unwrap_or_else(|| {
                    let axis = to.any_orthonormal_vector();
                    axis * (2.0 * axis.dot(c.normal[i])) - c.normal[i]
                })
            })
        };
        c.terms
            .iter()
            .enumerate()
            .map(|(k, term)| {
                let [light, half] = self.references[object][k];
                let (light, half) = (
                    self.reference(term, &term.light, light),
                    self.reference(term, &term.half, half),
                );
                let highlight = term.shines().then(|| (normals(&term.half, half), half));
                ((normals(&term.light, light), light), highlight)
            })
            .collect()
    }
}

/// Normals at the vertices and the constant vector they are to be multiplied with.
pub type Turned = ([DVec3; 3], DVec3);
/// The two of one light.
pub type TurnedTerms = (Turned, Option<Turned>);

impl Ends for Referred {
    type Triangle = SmallVec<[Stills; 2]>;

    fn triangle(&self, _: &Prepared, t: &ScreenTriangle, c: &Corners) -> Self::Triangle {
        let still = |(normals, vector): Turned| Still {
            arcs: arcs(&normals),
            vector,
        };
        self.turned(t.object, c)
            .into_iter()
            .map(|(diffuse, specular)| (still(diffuse), specular.map(still)))
            .collect()
    }

    fn sweeps(
        &self,
        t: &ScreenTriangle,
        _: &Corners,
        setup: &Self::Triangle,
        span: Span,
    ) -> SmallVec<[Sweeps; 2]> {
        let cut = Cut::new(&t.position, span);
        let sweep =
            |s: &Still| Sweep::new(between(&s.arcs, &cut), [s.vector; 2], cut.first, cut.step);
        setup
            .iter()
            .map(|(diffuse, specular)| (sweep(diffuse), specular.as_ref().map(sweep)))
            .collect()
    }
}
