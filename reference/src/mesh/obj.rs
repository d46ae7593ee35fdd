//! Wavefront OBJ: `v`, `vn` and `f` (polygons are cut; indices from 1, or negative from the end), read by `tobj`, and
//! `vt` by [`coordinates`], so that seams of a texture split no vertex.
//! Everything else in a file is passed over: it is taken out before the library sees it, since the library would
//! split the mesh at groups and texture seams, and refuse what does not matter here. When it refuses a file, or is
//! more lenient than this crate, [`diagnose`] looks for the line.

mod coordinates;
mod diagnose;

use super::pseudo_normals::{pseudo_normals, Weighting};
use super::triangulate::triangulate;
use super::{Mesh, MeshError};
use glam::DVec3;
use std::fmt::Write;
use std::path::Path;

/// Longer numbers cannot be indices, and the arithmetic of the library is not made for them.
const INDEX_LENGTH: usize = 11;

/// Reads an OBJ file; corners without a normal get one by `weighting`.
///
/// # Errors
/// What is wrong, with its line.
pub fn load(path: &Path, weighting: Weighting) -> Result<Mesh, MeshError> {
    let bytes = std::fs::read(path).map_err(|e| {
        MeshError::new(
            format!("cannot be read ({e})"),
            "expected a readable OBJ file",
        )
    })?;
    parse(&String::from_utf8_lossy(&bytes), weighting)
}

/// The words of each line, comments left out.
fn lines(text: &str) -> impl Iterator<Item = Vec<&str>> {
    text.lines().map(|line| {
        let statement = line.split('#').next().unwrap_or("");
        statement.split_whitespace().collect()
    })
}

/// The part of a file that is used here. A corner without a normal is given a normal of its own, of no length, put
/// last; the library could not tell such corners from others. `None` where the library would let something pass.
fn relevant(text: &str) -> Option<String> {
    let normals = lines(text).filter(|words| words.first() == Some(&"vn"));
    let bare = normals.count() + 1;
    let mut normals = 0;
    let mut out = String::with_capacity(text.len());
    for words in lines(text) {
        match words.as_slice() {
            [kind @ ("v" | "vn"), numbers @ ..] => {
                let three = numbers.get(..3)?;
                // "nan" or "inf": the library would not look at a vertex that no face uses.
                if three.iter().any(|w| w.contains(['n', 'N'])) {
                    return None;
                }
                normals += usize::from(*kind == "vn");
                writeln!(out, "{kind} {}", three.join(" ")).ok()?;
            }
            ["f", corners @ ..] => {
                // The library takes fewer corners for points and lines.
                if corners.len() < 3 {
                    return None;
                }
                out.push('f');
                for corner in corners {
                    let mut parts = corner.split('/');
                    let position = parts.next()?;
                    let normal = parts.nth(1).unwrap_or("");
                    let back = normal.strip_prefix('-').and_then(|n| n.parse().ok());
                    let absent =
                        back.is_some_and(|n: usize| n > normals) || normal.parse() == Ok(bare);
                    if absent || position.len().max(normal.len()) > INDEX_LENGTH {
                        return None;
                    }
                    match normal {
                        "" => write!(out, " {position}//{bare}").ok()?,
                        _ => write!(out, " {position}//{normal}").ok()?,
                    }
                }
                out.push('\n');
            }
            _ => {}
        }
    }
    out.push_str("vn 0 0 0\n");
    Some(out)
}

/// Why the file at `path` gives no texture coordinates; nothing if it does.
///
/// # Errors
/// A corner without texture coordinates, or with broken ones, and its line.
pub fn check_coordinates(path: &Path) -> Result<(), MeshError> {
    // A file that has just been read; should it be gone, it has no coordinates.
    let bytes = std::fs::read(path).unwrap_or_default();
    coordinates::read(&String::from_utf8_lossy(&bytes)).map(|_| ())
}

fn vectors(flat: &[f64]) -> Vec<DVec3> {
    flat.chunks_exact(3).map(DVec3::from_slice).collect()
}

/// A triangle cut from a face: number of the face, and which of its corners.
type Cut = (usize, [usize; 3]);

/// Cuts faces into triangles; also says where each came from.
fn triangles(positions: &[DVec3], mesh: &tobj::Mesh) -> (Vec<[u32; 3]>, Vec<Cut>) {
    let count = mesh.indices.len() / 3;
    let (mut all, mut cuts) = (Vec::with_capacity(count), Vec::with_capacity(count));
    let mut rest = mesh.indices.as_slice();
    // Where all faces are triangles, nothing is said about their numbers of corners.
    let mut arities = mesh.face_arities.iter();
    let mut number = 0;
    while !rest.is_empty() {
        let n = arities.next().map_or(3, |n| *n as usize).min(rest.len());
        let (face, others) = rest.split_at(n);
        rest = others;
        let corner = |i: &u32| positions.get(*i as usize).copied().unwrap_or(DVec3::NAN);
        let fan = || (2..n).map(|k| [0, k - 1, k]).collect();
        let cut = match n {
            3 => vec![[0, 1, 2]],
            _ => {
                triangulate(&face.iter().map(corner).collect::<Vec<_>>()).unwrap_or_else(|_| fan())
            }
        };
        for t in cut {
            all.push(t.map(|k| face[k]));
            cuts.push((number, t));
        }
        number += 1;
    }
    (all, cuts)
}

/// Reads what [`relevant`] left.
fn read(relevant: &str) -> Result<(Mesh, Vec<Cut>), tobj::LoadError> {
    let options = tobj::LoadOptions {
        single_index: true,
        ..tobj::LoadOptions::default()
    };
    let no_materials = |_: &Path| Err(tobj::LoadError::OpenFileFailed);
    let (models, _) = tobj::load_obj_buf(&mut relevant.as_bytes(), &options, no_materials)?;
    // One model: there are no groups.
    let Some(model) = models.into_iter().next() else {
        return Ok((Mesh::default(), Vec::new()));
    };
    let positions = vectors(&model.mesh.positions);
    let (triangles, cuts) = triangles(&positions, &model.mesh);
    let mesh = Mesh {
        triangles,
        positions,
        normals: vectors(&model.mesh.normals),
        uv: Vec::new(),
    };
    Ok((mesh, cuts))
}

fn parse(text: &str, weighting: Weighting) -> Result<Mesh, MeshError> {
    let refused = |why: String| {
        diagnose::first_fault(text).unwrap_or_else(|| {
            MeshError::new(format!("not readable ({why})"), "expected Wavefront OBJ")
        })
    };
    let relevant = relevant(text).ok_or_else(|| refused("not plain OBJ".to_owned()))?;
    let (mut mesh, cuts) = read(&relevant).map_err(|e| refused(e.to_string()))?;
    let finite = |all: &[DVec3]| all.iter().all(|v| v.is_finite());
    // A normal of index 0 the library takes for none at all.
    let whole = mesh.positions.len() == mesh.normals.len();
    if !whole || !finite(&mesh.positions) || !finite(&mesh.normals) {
        return Err(refused("not finite".to_owned()));
    }
    // Broken ones do not matter until a material has a texture.
    if let Ok(faces) = coordinates::read(text) {
        let of = |(face, t): &Cut| {
            let corners = faces.get(*face)?;
            Some([
                *corners.get(t[0])?,
                *corners.get(t[1])?,
                *corners.get(t[2])?,
            ])
        };
        mesh.uv = cuts
            .iter()
            .map(of)
            .collect::<Option<_>>()
            .unwrap_or_default();
    }
    if mesh.normals.contains(&DVec3::ZERO) {
        // Normals for what has none; those that were given are kept.
        let made = pseudo_normals(&mesh, weighting);
        for (n, made) in mesh.normals.iter_mut().zip(made) {
            if *n == DVec3::ZERO {
                *n = made;
            }
        }
    }
    Ok(mesh)
}

#[cfg(test)]
mod tests;
