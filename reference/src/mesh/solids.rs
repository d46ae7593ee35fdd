//! Flat things: a square in the x–z plane and a cube, each face divided into n × n squares of two triangles.

use super::Mesh;
use glam::DVec3;

/// Adds the square centre + s·u + t·v, s and t in −1..=1, facing u × v.
fn face(mesh: &mut Mesh, centre: DVec3, u: DVec3, v: DVec3, n: u32) {
    let n = n.max(1);
    let first = mesh.positions.len() as u32;
    let at = |i: u32| 2.0 * f64::from(i) / f64::from(n) - 1.0;
    for j in 0..=n {
        for i in 0..=n {
            mesh.positions.push(centre + u * at(i) + v * at(j));
            mesh.normals.push(u.cross(v));
        }
    }
    let index = |i: u32, j: u32| first + j * (n + 1) + i;
    for j in 0..n {
        for i in 0..n {
            let quad = [
                index(i, j),
                index(i + 1, j),
                index(i + 1, j + 1),
                index(i, j + 1),
            ];
            mesh.triangles.push([quad[0], quad[1], quad[2]]);
            mesh.triangles.push([quad[0], quad[2], quad[3]]);
        }
    }
}

/// The square −1..=1 in x and z at y = 0, facing up.
#[must_use]
pub fn plane(subdivisions: u32) -> Mesh {
    let mut mesh = Mesh::default();
    face(&mut mesh, DVec3::ZERO, DVec3::Z, DVec3::X, subdivisions);
    mesh
}

/// The cube −1..=1 in all directions, with the normals of its faces.
#[must_use]
pub fn cube(subdivisions: u32) -> Mesh {
    let mut mesh = Mesh::default();
    for axis in 0..3 {
        let (u, v) = (DVec3::AXES[(axis + 1) % 3], DVec3::AXES[(axis + 2) % 3]);
        face(&mut mesh, DVec3::AXES[axis], u, v, subdivisions);
        face(&mut mesh, -DVec3::AXES[axis], v, u, subdivisions);
    }
    mesh
}

#[cfg(test)]
mod tests {
    use super::super::{assert_closed, assert_outward};
    use super::*;

    #[test]
    fn the_cube_is_closed() {
        for n in [1, 3, 10] {
            let c = cube(n);
            assert_eq!(c.triangles.len(), 12 * (n * n) as usize);
            assert_closed(&c);
            assert_outward(&c, 0.999);
        }
    }

    #[test]
    fn the_plane_faces_up() {
        let p = plane(4);
        assert_eq!(p.triangles.len(), 32);
        assert_outward(&p, 0.999);
        assert!(p.normals.iter().all(|n| *n == DVec3::Y));
    }
}
