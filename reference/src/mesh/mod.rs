//! Triangle meshes: read from files or generated. Vertices turn counter-clockwise seen from outside.

pub mod gltf;
pub mod newell;
pub mod obj;
pub mod pseudo_normals;
pub mod solids;
pub mod sphere;
pub mod teapot;
mod teapot_data;
pub mod torus;
pub mod triangulate;

use glam::{DVec2, DVec3};

/// Most triangles that one mesh may have.
pub const TRIANGLE_LIMIT: usize = 10_000_000;

/// An indexed triangle mesh in its own coordinates.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Vertex positions.
    pub positions: Vec<DVec3>,
    /// One normal per vertex, any length; the zero vector stands for "the normal of the face".
    pub normals: Vec<DVec3>,
    /// Three vertex indices per triangle, counter-clockwise from outside.
    pub triangles: Vec<[u32; 3]>,
    /// For every triangle, the texture coordinates (u to the right, v upwards) at its three corners; empty when there
    /// are none. They belong to corners and not to vertices, so that a seam of the texture splits no vertex.
    pub uv: Vec<[DVec2; 3]>,
}

/// Why a mesh cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}{what}; {accepted}", line.map(|l| format!("{l}: ")).unwrap_or_default())]
pub struct MeshError {
    /// Line of the mesh file, for text formats.
    pub line: Option<usize>,
    /// What is wrong.
    pub what: String,
    /// What would be accepted.
    pub accepted: String,
}

impl MeshError {
    pub(crate) fn new(what: impl Into<String>, accepted: impl Into<String>) -> Self {
        Self {
            line: None,
            what: what.into(),
            accepted: accepted.into(),
        }
    }

    pub(crate) fn at(mut self, line: usize) -> Self {
        self.line = Some(line);
        self
    }
}

impl Mesh {
    /// Checks that there is something to draw, that every index exists, that every number is finite and that there are
    /// texture coordinates for all triangles or for none.
    ///
    /// # Errors
    /// The first thing that is wrong.
    pub fn check(&self) -> Result<(), MeshError> {
        if self.triangles.is_empty() {
            return Err(MeshError::new(
                "the mesh has no triangles",
                "expected at least one",
            ));
        }
        if self.triangles.len() > TRIANGLE_LIMIT {
            return Err(MeshError::new(
                format!("the mesh has {} triangles", self.triangles.len()),
                format!("expected at most {TRIANGLE_LIMIT}"),
            ));
        }
        let count = self.positions.len().min(self.normals.len());
        for (t, corner) in self.triangles.iter().enumerate() {
            if let Some(bad) = corner.iter().find(|i| **i as usize >= count) {
                return Err(MeshError::new(
                    format!("triangle {t} names vertex {bad} of {count}"),
                    format!("expected indices 0 to {}", count.saturating_sub(1)),
                ));
            }
        }
        for (i, (p, n)) in self.positions.iter().zip(&self.normals).enumerate() {
            if !p.is_finite() || !n.is_finite() {
                return Err(MeshError::new(
                    format!("vertex {i} is not finite"),
                    "expected finite positions and normals",
                ));
            }
        }
        if !self.uv.is_empty() && self.uv.len() != self.triangles.len() {
            return Err(MeshError::new(
                format!(
                    "{} triangles have texture coordinates, of {}",
                    self.uv.len(),
                    self.triangles.len()
                ),
                "expected them for all triangles or for none",
            ));
        }
        match self
            .uv
            .iter()
            .position(|t| t.iter().any(|v| !v.is_finite()))
        {
            None => Ok(()),
            Some(t) => Err(MeshError::new(
                format!("the texture coordinates of triangle {t} are not finite"),
                "expected finite texture coordinates",
            )),
        }
    }
}

/// Closed and outward: every directed edge has exactly one partner the other way (vertices compared by position), and
/// the signed volume is positive.
#[cfg(test)]
pub(crate) fn assert_closed(mesh: &Mesh) {
    use std::collections::HashMap;
    let key = |i: u32| {
        mesh.positions[i as usize]
            .to_array()
            .map(|v| (v + 0.0).to_bits())
    };
    let mut edges: HashMap<_, i32> = HashMap::new();
    let mut volume = 0.0;
    for t in &mesh.triangles {
        for k in 0..3 {
            let (a, b) = (key(t[k]), key(t[(k + 1) % 3]));
            assert_ne!(a, b, "an edge without length");
            *edges.entry((a, b)).or_default() += 1;
            *edges.entry((b, a)).or_default() -= 1;
        }
        let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
        volume += a.dot(b.cross(c));
    }
    assert!(edges.values().all(|n| *n == 0), "open edges");
    assert!(volume > 0.0, "inside out: {volume}");
}

/// Every vertex normal points to the front of every face it is used in.
#[cfg(test)]
pub(crate) fn assert_outward(mesh: &Mesh, least_cosine: f64) {
    for t in &mesh.triangles {
        let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
        let n = (b - a).cross(c - a).normalize();
        for i in t {
            let cosine = n.dot(mesh.normals[*i as usize].normalize());
            assert!(cosine > least_cosine, "{cosine} at {a} {b} {c}");
        }
    }
}

/// Every triangle has texture coordinates that turn as its vertices do, u to the right and v upwards seen from the
/// front; only at poles may they shrink to nothing.
#[cfg(test)]
pub(crate) fn assert_mapped(mesh: &Mesh) {
    assert_eq!(mesh.uv.len(), mesh.triangles.len());
    for (t, uv) in mesh.uv.iter().enumerate() {
        let area = (uv[1] - uv[0]).perp_dot(uv[2] - uv[0]);
        assert!(area > 0.0, "triangle {t}: {uv:?}");
        assert!(uv
            .iter()
            .all(|v| (0.0..=1.0).contains(&v.x) && (0.0..=1.0).contains(&v.y)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_wrong_is_said() {
        let mut m = Mesh::default();
        assert_eq!(
            m.check().unwrap_err().to_string(),
            "the mesh has no triangles; expected at least one"
        );
        m.positions = vec![DVec3::X, DVec3::Y, DVec3::Z];
        m.normals = vec![DVec3::ZERO; 3];
        m.triangles = vec![[0, 1, 3]];
        assert_eq!(
            m.check().unwrap_err().to_string(),
            "triangle 0 names vertex 3 of 3; expected indices 0 to 2"
        );
        m.triangles = vec![[0, 1, 2]];
        assert_eq!(m.check(), Ok(()));
        m.positions[1].x = f64::NAN;
        assert_eq!(
            m.check().unwrap_err().to_string(),
            "vertex 1 is not finite; expected finite positions and normals"
        );
        m.positions[1] = DVec3::Y;
        m.uv = vec![[DVec2::ZERO; 3]; 2];
        assert_eq!(
            m.check().unwrap_err().to_string(),
            "2 triangles have texture coordinates, of 1; expected them for all triangles or for none"
        );
        m.uv = vec![[DVec2::ZERO, DVec2::NAN, DVec2::ZERO]];
        assert_eq!(
            m.check().unwrap_err().to_string(),
            "the texture coordinates of triangle 0 are not finite; expected finite texture coordinates"
        );
    }
}
