//! Latitude–longitude sphere about the y axis: m slices and k stacks give 2·m·(k − 1) triangles, as in the sphere
//! sets of Abbas 2003 (168 = 12 × 8, 374 = 17 × 12, 690 = 23 × 16; the splits are inferred, the thesis gives totals).

use super::Mesh;
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// A sphere of `radius` with exact normals. A texture goes around it once, its middle at −z. `slices` is at least 3, `stacks` at least 2.
#[must_use]
pub fn sphere(slices: u32, stacks: u32, radius: f64) -> Mesh {
    let (m, k) = (slices.max(3), stacks.max(2));
    let mut normals = vec![DVec3::Y];
    for i in 1..k {
        let (sin, cos) = (PI * f64::from(i) / f64::from(k)).sin_cos();
        for j in 0..m {
            let (s, c) = (TAU * f64::from(j) / f64::from(m)).sin_cos();
            normals.push(DVec3::new(sin * s, cos, sin * c));
        }
    }
    normals.push(DVec3::NEG_Y);
    let south = normals.len() as u32 - 1;
    let at = |i: u32, j: u32| 1 + (i - 1) * m + j % m;
    // Around from the front (+z) eastwards, and from pole to pole; a pole has the longitude of each face's middle.
    let place = |i: u32, j: f64| DVec2::new(j / f64::from(m), 1.0 - f64::from(i) / f64::from(k));
    let mut triangles = Vec::with_capacity(2 * m as usize * (k as usize - 1));
    let mut uv = Vec::with_capacity(triangles.capacity());
    for j in 0..m {
        let (west, east) = (f64::from(j), f64::from(j + 1));
        let middle = (west + east) / 2.0;
        triangles.push([0, at(1, j), at(1, j + 1)]);
        uv.push([place(0, middle), place(1, west), place(1, east)]);
        for i in 1..k - 1 {
            let quad = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            triangles.push([quad[0], quad[1], quad[2]]);
            triangles.push([quad[0], quad[2], quad[3]]);
            let corner = [
                place(i, west),
                place(i + 1, west),
                place(i + 1, east),
                place(i, east),
            ];
            uv.push([corner[0], corner[1], corner[2]]);
            uv.push([corner[0], corner[2], corner[3]]);
        }
        triangles.push([at(k - 1, j), south, at(k - 1, j + 1)]);
        uv.push([place(k - 1, west), place(k, middle), place(k - 1, east)]);
    }
    Mesh {
        positions: normals.iter().map(|n| *n * radius).collect(),
        normals,
        triangles,
        uv,
    }
}

#[cfg(test)]
mod tests {
    use super::super::{assert_closed, assert_mapped, assert_outward};
    use super::*;

    #[test]
    fn the_sphere_sets_of_the_literature() {
        for (m, k, n) in [
            (23, 16, 690),
            (17, 12, 374),
            (12, 8, 168),
            (14, 7, 168),
            (3, 2, 6),
        ] {
            let s = sphere(m, k, 2.5);
            assert_eq!(s.triangles.len(), n);
            assert_closed(&s);
            assert_outward(&s, 0.3);
            assert_mapped(&s);
            assert!(s.positions.iter().all(|p| (p.length() - 2.5).abs() < 1e-12));
        }
    }
}
