//! Normals at vertices from the faces around them, N = normalise(Σ w·N_face), for meshes that come without (Loisel 1996).
//! Three weights are in use: the same for each face, the area of the face, and the angle of the face at the vertex
//! (Thürmer and Wüthrich 1998). Only the last does not depend on how a surface is cut into triangles.

use super::Mesh;
use crate::method::UnknownName;
use glam::DVec3;
use std::str::FromStr;

/// What the faces around a vertex count for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Weighting {
    /// No pseudo-normals: each face has its own normal all over.
    Face,
    /// Each face the same.
    Uniform,
    /// Each face by its area.
    #[default]
    Area,
    /// Each face by its angle at the vertex.
    Angle,
}

impl Weighting {
    const ALL: [Self; 4] = [Self::Face, Self::Uniform, Self::Area, Self::Angle];
    /// Their names.
    pub const NAMES: [&'static str; 4] = ["face", "uniform", "area", "angle"];
}

impl FromStr for Weighting {
    type Err = UnknownName;

    fn from_str(s: &str) -> Result<Self, UnknownName> {
        let names = Self::NAMES.iter().zip(Self::ALL);
        let found = names.into_iter().find(|(name, _)| **name == s);
        found
            .map(|(_, w)| w)
            .ok_or_else(|| UnknownName::new("weighting", s, &Self::NAMES))
    }
}

/// The unit normals at the vertices of a mesh; zero, which stands for the normal of the face, where the faces around a
/// vertex cancel, and everywhere for [`Weighting::Face`]. Vertices at one index share one normal; faces without area
/// count for nothing.
#[must_use]
pub fn pseudo_normals(mesh: &Mesh, weighting: Weighting) -> Vec<DVec3> {
    let mut sum = vec![DVec3::ZERO; mesh.positions.len()];
    if weighting == Weighting::Face {
        return sum;
    }
    for t in &mesh.triangles {
        let corners = t.map(|i| mesh.positions[i as usize]);
        let [a, b, c] = corners;
        // Twice the area times the unit normal.
        let area = (b - a).cross(c - a);
        for (k, i) in t.iter().enumerate() {
            sum[*i as usize] += match weighting {
                Weighting::Face => DVec3::ZERO,
                Weighting::Uniform => area.normalize_or_zero(),
                Weighting::Area => area,
                Weighting::Angle => {
                    let (u, v) = (
                        corners[(k + 1) % 3] - corners[k],
                        corners[(k + 2) % 3] - corners[k],
                    );
                    area.normalize_or_zero() * u.cross(v).length().atan2(u.dot(v))
                }
            };
        }
    }
    let cancelled = |n: &DVec3| n.length() < CANCELLED && weighting != Weighting::Area;
    sum.into_iter()
        .map(|n| {
            if cancelled(&n) {
                DVec3::ZERO
            } else {
                n.normalize_or_zero()
            }
        })
        .collect()
}

/// Sums of unit normals below this are rounding.
const CANCELLED: f64 = 1e-12;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{solids, sphere};

    /// A cube with one vertex per corner, its faces cut along diagonals as they come.
    fn welded() -> Mesh {
        let mut m = solids::cube(1);
        let mut unique: Vec<DVec3> = Vec::new();
        let mut index = Vec::new();
        for p in &m.positions {
            let at = unique.iter().position(|q| q == p).unwrap_or(unique.len());
            if at == unique.len() {
                unique.push(*p);
            }
            index.push(at as u32);
        }
        m.triangles = m
            .triangles
            .iter()
            .map(|t| t.map(|i| index[i as usize]))
            .collect();
        m.positions = unique;
        m.normals = vec![DVec3::ZERO; 8];
        m
    }

    #[test]
    fn only_angles_do_not_depend_on_how_faces_are_cut() {
        let m = welded();
        let off = |weighting| {
            let n = pseudo_normals(&m, weighting);
            m.positions
                .iter()
                .zip(&n)
                .map(|(p, n)| n.distance(p.normalize()))
                .fold(0.0, f64::max)
        };
        assert!(off(Weighting::Angle) < 1e-15);
        // A corner where two triangles of one side meet leans to that side.
        assert!(off(Weighting::Uniform) > 0.1 && off(Weighting::Area) > 0.1);
    }

    #[test]
    fn each_weight_is_what_it_says() {
        // At the first vertex: a face of area 1/2 and angle 90° facing +z, and one of area 2 and angle 45° facing +x.
        let m = Mesh {
            positions: vec![
                DVec3::ZERO,
                DVec3::X,
                DVec3::Y,
                DVec3::new(0.0, 2.0, 0.0),
                DVec3::new(0.0, 2.0, 2.0),
            ],
            normals: vec![DVec3::ZERO; 5],
            triangles: vec![[0, 1, 2], [0, 3, 4]],
            uv: Vec::new(),
        };
        let at = |w| pseudo_normals(&m, w)[0];
        let want = |z: f64, x: f64| DVec3::new(x, 0.0, z).normalize();
        assert!(at(Weighting::Uniform).distance(want(1.0, 1.0)) < 1e-15);
        assert!(at(Weighting::Area).distance(want(1.0, 4.0)) < 1e-15);
        assert!(at(Weighting::Angle).distance(want(2.0, 1.0)) < 1e-15);
        assert_eq!(at(Weighting::Face), DVec3::ZERO);
    }

    #[test]
    fn opposite_faces_cancel_to_the_normal_of_the_face() {
        let m = Mesh {
            positions: vec![DVec3::ZERO, DVec3::X, DVec3::new(0.3, 0.7, 0.1)],
            normals: vec![DVec3::ZERO; 3],
            triangles: vec![[0, 1, 2], [0, 2, 1], [0, 0, 1]],
            uv: Vec::new(),
        };
        for w in Weighting::ALL {
            assert_eq!(pseudo_normals(&m, w), [DVec3::ZERO; 3], "{w:?}");
        }
    }

    #[test]
    fn on_a_sphere_all_come_near_the_true_normal() {
        let m = sphere::sphere(40, 20, 2.0);
        for (w, bound) in [
            (Weighting::Uniform, 0.02),
            (Weighting::Area, 0.03),
            (Weighting::Angle, 0.005),
        ] {
            let worst = pseudo_normals(&m, w)
                .iter()
                .zip(&m.normals)
                .map(|(n, truth)| n.distance(truth.normalize()))
                .fold(0.0, f64::max);
            assert!(worst < bound, "{w:?} {worst}");
        }
    }

    #[test]
    fn names() {
        for (name, w) in Weighting::NAMES.iter().zip(Weighting::ALL) {
            assert_eq!(name.parse(), Ok(w));
        }
        let e = "angel".parse::<Weighting>().unwrap_err().to_string();
        assert_eq!(
            e,
            "unknown weighting 'angel'; the nearest is 'angle' of face, uniform, area, angle"
        );
    }
}
