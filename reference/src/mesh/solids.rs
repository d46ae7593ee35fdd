//! Flat things: a square in the x–z plane and a cube, each face divided into n × n squares of two triangles.

use super::Mesh;
use glam::{DVec2, DVec3};

/// Adds the square centre + s·u + t·v, s and t in −1..=1, facing u × v. A texture fills it once, with `up` upwards.
fn face(mesh: &mut Mesh, centre: DVec3, u: DVec3, v: DVec3, up: DVec3, n: u32) {
    let n = n.max(1);
    let first = mesh.positions.len() as u32;
    let right = up.cross(u.cross(v));
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
            for t in [[quad[0], quad[1], quad[2]], [quad[0], quad[2], quad[3]]] {
                mesh.triangles.push(t);
                mesh.uv.push(t.map(|k| {
                    let p = mesh.positions[k as usize];
                    DVec2::new(1.0 + right.dot(p), 1.0 + up.dot(p)) / 2.0
                }));
            }
        }
    }
}

/// The square −1..=1 in x and z at y = 0, facing up. Of a texture, u runs along +x and v along −z.
#[must_use]
pub fn plane(subdivisions: u32) -> Mesh {
    let mut mesh = Mesh::default();
    let (u, v, up) = (DVec3::Z, DVec3::X, DVec3::NEG_Z);
    face(&mut mesh, DVec3::ZERO, u, v, up, subdivisions);
    mesh
}

/// The cube −1..=1 in all directions, with the normals of its faces. A texture stands upright on the four sides; its
/// upper edge is at the back on top and in front below.
#[must_use]
pub fn cube(subdivisions: u32) -> Mesh {
    let mut mesh = Mesh::default();
    for axis in 0..3 {
        let (u, v) = (DVec3::AXES[(axis + 1) % 3], DVec3::AXES[(axis + 2) % 3]);
        let normal = DVec3::AXES[axis];
        let [above, below] = match axis {
            1 => [DVec3::NEG_Z, DVec3::Z],
            _ => [DVec3::Y; 2],
        };
        face(&mut mesh, normal, u, v, above, subdivisions);
        face(&mut mesh, -normal, v, u, below, subdivisions);
    }
    mesh
}

#[cfg(test)]
mod tests {
    use super::super::{assert_closed, assert_mapped, assert_outward};
    use super::*;

    #[test]
    fn the_cube_is_closed() {
        for n in [1, 3, 10] {
            let c = cube(n);
            assert_eq!(c.triangles.len(), 12 * (n * n) as usize);
            assert_closed(&c);
            assert_outward(&c, 0.999);
            assert_mapped(&c);
        }
    }

    #[test]
    fn the_plane_faces_up() {
        let p = plane(4);
        assert_eq!(p.triangles.len(), 32);
        assert_outward(&p, 0.999);
        assert!(p.normals.iter().all(|n| *n == DVec3::Y));
        assert_mapped(&p);
        for (t, uv) in p.triangles.iter().zip(&p.uv) {
            for (i, uv) in t.iter().zip(uv) {
                let p = p.positions[*i as usize];
                assert_eq!(*uv, DVec2::new(1.0 + p.x, 1.0 - p.z) / 2.0);
            }
        }
    }
}
