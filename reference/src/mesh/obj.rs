//! Wavefront OBJ: `v`, `vn` and `f` (polygons as fans; indices from 1, or negative from the end). Everything else in a
//! file is passed over. Read here rather than by a library because a refusal must name its line, in double precision.

use super::{Mesh, MeshError};
use glam::DVec3;
use std::collections::HashMap;
use std::path::Path;

/// Reads an OBJ file.
///
/// # Errors
/// What is wrong, with its line.
pub fn load(path: &Path) -> Result<Mesh, MeshError> {
    let bytes = std::fs::read(path).map_err(|e| {
        MeshError::new(
            format!("cannot be read ({e})"),
            "expected a readable OBJ file",
        )
    })?;
    parse(&String::from_utf8_lossy(&bytes))
}

fn vector(words: &[&str], what: &str) -> Result<DVec3, MeshError> {
    let expected = "expected three finite numbers";
    if words.len() < 3 {
        return Err(MeshError::new(
            format!("{what} has {} numbers", words.len()),
            expected,
        ));
    }
    let mut v = DVec3::ZERO;
    for i in 0..3 {
        v[i] = words[i]
            .parse()
            .ok()
            .filter(|x: &f64| x.is_finite())
            .ok_or_else(|| MeshError::new(format!("{what} has '{}'", words[i]), expected))?;
    }
    Ok(v)
}

fn index(word: &str, count: usize, what: &str) -> Result<usize, MeshError> {
    let n: i64 = word.parse().map_err(|_| {
        MeshError::new(
            format!("'{word}' is not an index"),
            "expected v, v/t, v//n or v/t/n",
        )
    })?;
    let i = if n < 0 { count as i64 + n } else { n - 1 };
    usize::try_from(i)
        .ok()
        .filter(|i| *i < count)
        .ok_or_else(|| {
            MeshError::new(
                format!("{what} {n} does not exist"),
                format!("expected 1 to {count} or -1 to -{count}"),
            )
        })
}

/// Vertices of the faces, each a pair of a position and perhaps a normal.
#[derive(Default)]
struct Builder {
    positions: Vec<DVec3>,
    normals: Vec<DVec3>,
    corners: HashMap<(usize, Option<usize>), u32>,
    mesh: Mesh,
    bare: bool,
}

impl Builder {
    fn corner(&mut self, word: &str) -> Result<u32, MeshError> {
        let mut parts = word.split('/');
        let p = index(parts.next().unwrap_or(""), self.positions.len(), "vertex")?;
        let n = match parts.nth(1).filter(|w| !w.is_empty()) {
            Some(w) => Some(index(w, self.normals.len(), "normal")?),
            None => None,
        };
        self.bare |= n.is_none();
        let Self {
            positions,
            normals,
            corners,
            mesh,
            ..
        } = self;
        Ok(*corners.entry((p, n)).or_insert_with(|| {
            mesh.positions.push(positions[p]);
            mesh.normals.push(n.map_or(DVec3::ZERO, |n| normals[n]));
            mesh.positions.len() as u32 - 1
        }))
    }

    fn line(&mut self, words: &[&str]) -> Result<(), MeshError> {
        match words {
            ["v", rest @ ..] => self.positions.push(vector(rest, "vertex")?),
            ["vn", rest @ ..] => self.normals.push(vector(rest, "normal")?),
            ["f", rest @ ..] => {
                if rest.len() < 3 {
                    return Err(MeshError::new(
                        format!("a face of {} corners", rest.len()),
                        "expected at least three",
                    ));
                }
                let ring = rest
                    .iter()
                    .map(|w| self.corner(w))
                    .collect::<Result<Vec<_>, _>>()?;
                for k in 1..ring.len() - 1 {
                    self.mesh.triangles.push([ring[0], ring[k], ring[k + 1]]);
                }
            }
            _ => {}
        }
        Ok(())
    }
}

fn parse(text: &str) -> Result<Mesh, MeshError> {
    let mut b = Builder::default();
    for (i, line) in text.lines().enumerate() {
        let words: Vec<&str> = line
            .split('#')
            .next()
            .unwrap_or("")
            .split_whitespace()
            .collect();
        b.line(&words).map_err(|e| e.at(i + 1))?;
        if b.mesh.triangles.len() > super::TRIANGLE_LIMIT {
            break;
        }
    }
    if b.bare {
        // Smooth what has no normals; keep the normals that were given.
        let given = b.mesh.normals.clone();
        b.mesh.smooth();
        for (n, g) in b.mesh.normals.iter_mut().zip(given) {
            if g != DVec3::ZERO {
                *n = g;
            }
        }
    }
    Ok(b.mesh)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(text: &str) -> String {
        parse(text).unwrap_err().to_string()
    }

    #[test]
    fn what_is_wrong_is_said_with_its_line() {
        assert_eq!(
            error("v 0 0 0\nv 1 nan 0\n"),
            "2: vertex has 'nan'; expected three finite numbers"
        );
        assert_eq!(
            error("v 1 2"),
            "1: vertex has 2 numbers; expected three finite numbers"
        );
        assert_eq!(
            error("v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 4\n"),
            "5: vertex 4 does not exist; expected 1 to 3 or -1 to -3"
        );
        assert_eq!(
            error("v 0 0 0\nf 1 1\n"),
            "2: a face of 2 corners; expected at least three"
        );
        assert_eq!(
            error("v 0 0 0\nf 1 x 1\n"),
            "2: 'x' is not an index; expected v, v/t, v//n or v/t/n"
        );
    }

    #[test]
    fn polygons_become_fans_and_normals_smooth() {
        let m = parse("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\n").unwrap();
        assert_eq!(m.triangles, [[0, 1, 2], [0, 2, 3]]);
        assert!(m.normals.iter().all(|n| *n == DVec3::Z));
    }

    #[test]
    fn agrees_with_an_independent_reader() {
        let text = include_str!("../../../scenes/meshes/gem.obj");
        let ours = parse(text).unwrap();
        let options = tobj::LoadOptions {
            triangulate: true,
            single_index: true,
            ..tobj::LoadOptions::default()
        };
        let (models, _) = tobj::load_obj_buf(&mut text.as_bytes(), &options, |_| {
            Ok((vec![], Default::default()))
        })
        .unwrap();
        let theirs: Vec<[f32; 3]> = models
            .iter()
            .flat_map(|m| {
                m.mesh.indices.iter().map(|i| *i as usize * 3).map(|i| {
                    [
                        m.mesh.positions[i],
                        m.mesh.positions[i + 1],
                        m.mesh.positions[i + 2],
                    ]
                })
            })
            .collect();
        let ours: Vec<[f32; 3]> = ours
            .triangles
            .iter()
            .flatten()
            .map(|i| ours.positions[*i as usize].as_vec3().to_array())
            .collect();
        assert_eq!(ours, theirs);
    }
}
