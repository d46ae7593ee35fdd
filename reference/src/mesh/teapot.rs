//! The Utah teapot from its 32 bicubic Bézier patches: P(s, t) = Σᵢⱼ Bᵢ(t)·Bⱼ(s)·Cᵢⱼ, normal ∂P/∂s × ∂P/∂t.
//!
//! The Bernstein weights are exactly 0 and 1 at the ends, so patches that share border control points share border
//! vertices to the last bit. Where a border shrinks to a point (lid tip, bottom), ∂P/∂s vanishes like t·∂²P/∂s∂t, and
//! the mixed derivative takes its place.

use super::teapot_data::{Ring, TubeRow, PROFILES, TUBES};
use super::Mesh;
use glam::{DVec2, DVec3};

/// Control points, rows along t, columns along s.
type Patch = [[DVec3; 4]; 4];

/// A quarter of a surface of revolution, clockwise seen from above, then turned by `quarter` right angles (exactly).
fn revolved(profile: &[Ring; 4], quarter: u32) -> Patch {
    profile.map(|(r, z, arc)| {
        [(r, 0.0), (r, -arc * r), (arc * r, -r), (0.0, -r)].map(|(mut x, mut y)| {
            for _ in 0..quarter {
                (x, y) = (y, -x);
            }
            DVec3::new(x, y, z)
        })
    })
}

/// Half a tube on the side of −y, or its mirror image with the columns reversed so that it keeps facing outwards.
fn tube(rows: &[TubeRow; 4], mirrored: bool) -> Patch {
    rows.map(|(x0, z0, x1, z1, half)| {
        let y = if mirrored { half } else { -half };
        let mut row = [
            DVec3::new(x0, 0.0, z0),
            DVec3::new(x0, y, z0),
            DVec3::new(x1, y, z1),
            DVec3::new(x1, 0.0, z1),
        ];
        if mirrored {
            row.reverse();
        }
        row
    })
}

/// The 32 patches, z up: 24 of revolution (rim, upper and lower body, bottom, knob, lid; four quarters each), four of
/// the handle and four of the spout.
#[must_use]
pub fn patches() -> Vec<[[DVec3; 4]; 4]> {
    let mut all = Vec::with_capacity(32);
    for profile in &PROFILES {
        all.extend((0..4).map(|q| revolved(profile, q)));
    }
    for rows in &TUBES {
        all.extend([false, true].map(|m| tube(rows, m)));
    }
    all
}

fn bernstein(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t]
}

fn bernstein_slope(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [
        -3.0 * s * s,
        3.0 * s * s - 6.0 * s * t,
        6.0 * s * t - 3.0 * t * t,
        3.0 * t * t,
    ]
}

fn combine(patch: &Patch, across: [f64; 4], along: [f64; 4]) -> DVec3 {
    let mut sum = DVec3::ZERO;
    for (row, b) in patch.iter().zip(along) {
        let mut inner = DVec3::ZERO;
        for (c, a) in row.iter().zip(across) {
            inner += *c * a;
        }
        sum += inner * b;
    }
    sum
}

/// The position; a row shrunk to a point is that point for every s, to the last bit.
fn place(patch: &Patch, across: [f64; 4], along: [f64; 4]) -> DVec3 {
    let mut sum = DVec3::ZERO;
    for (row, b) in patch.iter().zip(along) {
        let point = row.iter().all(|c| *c == row[0]);
        let inner = if point {
            row[0]
        } else {
            combine(&[*row, *row, *row, *row], across, [1.0, 0.0, 0.0, 0.0])
        };
        sum += inner * b;
    }
    sum
}

/// Position and outward unit normal at (s, t).
fn evaluate(patch: &Patch, s: f64, t: f64) -> (DVec3, DVec3) {
    let (bs, bt) = (bernstein(s), bernstein(t));
    let (ds, dt) = (bernstein_slope(s), bernstein_slope(t));
    let mut across = combine(patch, ds, bt);
    let along = combine(patch, bs, dt);
    if across.length() < 1e-9 {
        across = combine(patch, ds, dt) * if t < 0.5 { 1.0 } else { -1.0 };
    }
    (
        place(patch, bs, bt),
        across.cross(along).normalize_or_zero(),
    )
}

/// The teapot, y up, standing on y = 0, spout towards +x, 3.15 high; each patch divided into `subdivisions`² squares:
/// 64·n² − 8·n triangles. A texture fills each patch once, u along s and v along t.
#[must_use]
pub fn teapot(subdivisions: u32) -> Mesh {
    let n = subdivisions.max(1);
    let mut mesh = Mesh::default();
    for patch in patches() {
        let first = mesh.positions.len() as u32;
        for i in 0..=n {
            for j in 0..=n {
                let at = |k: u32| f64::from(k) / f64::from(n);
                let (p, normal) = evaluate(&patch, at(j), at(i));
                // A proper turn about x, exact: z up becomes y up. Adding zero makes -0 into 0.
                let upright = |v: DVec3| DVec3::new(v.x, v.z, -v.y) + DVec3::ZERO;
                mesh.positions.push(upright(p));
                mesh.normals.push(upright(normal));
            }
        }
        let index = |i: u32, j: u32| first + i * (n + 1) + j;
        for i in 0..n {
            for j in 0..n {
                let quad = [
                    index(i, j),
                    index(i, j + 1),
                    index(i + 1, j + 1),
                    index(i + 1, j),
                ];
                let place = |i: u32, j: u32| DVec2::new(f64::from(j), f64::from(i)) / f64::from(n);
                let corner = [
                    place(i, j),
                    place(i, j + 1),
                    place(i + 1, j + 1),
                    place(i + 1, j),
                ];
                for k in [[0, 1, 2], [0, 2, 3]] {
                    let t = k.map(|k| quad[k]);
                    let [a, b, c] = t.map(|v| mesh.positions[v as usize]);
                    // At a pole two corners are one.
                    if a != b && b != c && c != a {
                        mesh.triangles.push(t);
                        mesh.uv.push(k.map(|k| corner[k]));
                    }
                }
            }
        }
    }
    mesh
}

#[cfg(test)]
mod tests {
    use super::super::{assert_mapped, assert_outward};
    use super::*;
    use std::collections::HashMap;

    #[test]
    fn thirty_two_patches_of_306_vertices() {
        let all = patches();
        assert_eq!(all.len(), 32);
        let mut seen: HashMap<[i64; 3], ()> = HashMap::new();
        for p in all.iter().flatten().flatten() {
            seen.insert(p.to_array().map(|v| (v * 1e9).round() as i64), ());
        }
        // The published set numbers 306 vertices, some of them at one place.
        assert!((290..=306).contains(&seen.len()), "{}", seen.len());
    }

    #[test]
    fn the_bounding_box_and_the_count() {
        let m = teapot(10);
        assert_eq!(m.triangles.len(), 64 * 100 - 80);
        assert_mapped(&m);
        let (mut lo, mut hi) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for p in &m.positions {
            (lo, hi) = (lo.min(*p), hi.max(*p));
        }
        assert_eq!((lo.y, hi.y), (0.0, 3.15));
        assert!(
            (lo.x + 3.0).abs() < 0.05 && (hi.x - 3.43).abs() < 0.05,
            "{lo} {hi}"
        );
        assert!(
            (lo.z + 2.0).abs() < 0.01 && (hi.z - 2.0).abs() < 0.01,
            "{lo} {hi}"
        );
        assert_eq!(m.check(), Ok(()));
        assert!(m.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-12));
        assert_outward(&m, 0.0);
    }

    #[test]
    fn only_the_real_rims_are_open() {
        let m = teapot(6);
        let key = |i: u32| m.positions[i as usize].to_array().map(f64::to_bits);
        let mut edges: HashMap<_, i32> = HashMap::new();
        for t in &m.triangles {
            for k in 0..3 {
                let (a, b) = (key(t[k]), key(t[(k + 1) % 3]));
                *edges.entry((a, b)).or_default() += 1;
                *edges.entry((b, a)).or_default() -= 1;
            }
        }
        let open = edges.values().filter(|n| **n > 0).count();
        assert!(edges.values().all(|n| n.abs() <= 1));
        // Rim (inner edge) and lid (lower edge): four quarters each; handle and spout: two ends of two halves each.
        assert_eq!(open, 6 * (4 + 4 + 4 + 4));
    }

    #[test]
    fn the_poles_look_up_and_down() {
        let m = teapot(5);
        for (p, n) in m.positions.iter().zip(&m.normals) {
            if p.x.abs() < 1e-9 && p.z.abs() < 1e-9 {
                let want = if p.y > 1.0 { DVec3::Y } else { DVec3::NEG_Y };
                assert!(n.distance(want) < 1e-9, "{p} {n}");
            }
        }
    }
}
