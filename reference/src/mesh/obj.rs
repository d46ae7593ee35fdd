//! Wavefront OBJ: `v`, `vn` and `f` (polygons as fans; indices from 1, or negative from the end), read by `tobj`;
//! `vt` by [`coordinates`], so that seams of the texture split no vertex. Everything else in a file is passed over: it is taken out before the library sees it, since the library would
//! split the mesh at groups and texture seams, and refuse what does not matter here. When it refuses a file, or is
//! more lenient than this crate, [`diagnose`] looks for the line.

mod coordinates;
mod diagnose;

use super::{Mesh, MeshError};
use glam::DVec3;
use std::fmt::Write;
use std::path::Path;

/// Longer numbers cannot be indices, and the arithmetic of the library is not made for them.
const INDEX_LENGTH: usize = 11;

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

/// Reads what [`relevant`] left.
fn read(relevant: &str) -> Result<Mesh, tobj::LoadError> {
    let options = tobj::LoadOptions {
        triangulate: true,
        single_index: true,
        ..tobj::LoadOptions::default()
    };
    let no_materials = |_: &Path| Err(tobj::LoadError::OpenFileFailed);
    let (models, _) = tobj::load_obj_buf(&mut relevant.as_bytes(), &options, no_materials)?;
    // One model: there are no groups.
    let Some(model) = models.into_iter().next() else {
        return Ok(Mesh::default());
    };
    Ok(Mesh {
        positions: vectors(&model.mesh.positions),
        normals: vectors(&model.mesh.normals),
        triangles: model
            .mesh
            .indices
            .chunks_exact(3)
            .map(|t| [t[0], t[1], t[2]])
            .collect(),
        uv: Vec::new(),
    })
}

fn parse(text: &str) -> Result<Mesh, MeshError> {
    let refused = |why: String| {
        diagnose::first_fault(text).unwrap_or_else(|| {
            MeshError::new(format!("not readable ({why})"), "expected Wavefront OBJ")
        })
    };
    let relevant = relevant(text).ok_or_else(|| refused("not plain OBJ".to_owned()))?;
    let mut mesh = read(&relevant).map_err(|e| refused(e.to_string()))?;
    let finite = |all: &[DVec3]| all.iter().all(|v| v.is_finite());
    // A normal of index 0 the library takes for none at all.
    let whole = mesh.positions.len() == mesh.normals.len();
    if !whole || !finite(&mesh.positions) || !finite(&mesh.normals) {
        return Err(refused("not finite".to_owned()));
    }
    // Broken ones do not matter until a material has a texture.
    mesh.uv = coordinates::read(text).unwrap_or_default();
    if mesh.normals.contains(&DVec3::ZERO) {
        // Smooth what has no normals; keep the normals that were given.
        let given = std::mem::take(&mut mesh.normals);
        mesh.smooth();
        for (n, g) in mesh.normals.iter_mut().zip(given) {
            if g != DVec3::ZERO {
                *n = g;
            }
        }
    }
    Ok(mesh)
}

#[cfg(test)]
mod tests;
