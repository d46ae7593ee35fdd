//! Torus about the y axis: ((R + r·cos ψ)·sin φ, r·sin ψ, (R + r·cos ψ)·cos φ), 2 · segments · sides triangles.

use super::Mesh;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// A torus with exact normals: `major` is the radius of the ring, `minor` that of the tube; at least 3 segments around
/// the ring and 3 sides around the tube. Of a texture, u runs once around the ring and v once around the tube.
#[must_use]
pub fn torus(major: f64, minor: f64, segments: u32, sides: u32) -> Mesh {
    let (n, k) = (segments.max(3), sides.max(3));
    let mut mesh = Mesh::default();
    for i in 0..n {
        let (s, c) = (TAU * f64::from(i) / f64::from(n)).sin_cos();
        for j in 0..k {
            let (sj, cj) = (TAU * f64::from(j) / f64::from(k)).sin_cos();
            let out = DVec3::new(s, 0.0, c);
            let normal = out * cj + DVec3::Y * sj;
            mesh.positions.push(out * major + normal * minor);
            mesh.normals.push(normal);
        }
    }
    let at = |i: u32, j: u32| (i % n) * k + j % k;
    for i in 0..n {
        for j in 0..k {
            let quad = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            mesh.triangles.push([quad[0], quad[1], quad[2]]);
            mesh.triangles.push([quad[0], quad[2], quad[3]]);
            let place = |i: u32, j: u32| {
                DVec2::new(f64::from(i) / f64::from(n), f64::from(j) / f64::from(k))
            };
            let corner = [
                place(i, j),
                place(i + 1, j),
                place(i + 1, j + 1),
                place(i, j + 1),
            ];
            mesh.uv.push([corner[0], corner[1], corner[2]]);
            mesh.uv.push([corner[0], corner[2], corner[3]]);
        }
    }
    mesh
}

#[cfg(test)]
mod tests {
    use super::super::{assert_closed, assert_mapped, assert_outward};
    use super::*;

    #[test]
    fn closed_and_outward() {
        let t = torus(2.0, 0.75, 12, 12);
        assert_eq!(t.triangles.len(), 288);
        assert_closed(&t);
        assert_outward(&t, 0.7);
        assert_mapped(&t);
    }
}
