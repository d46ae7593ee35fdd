//! Where an OBJ file is broken. Called only for files that were refused; nothing is built here.

use super::lines;
use crate::mesh::MeshError;

fn numbers(words: &[&str], what: &str) -> Result<(), MeshError> {
    let expected = "expected three finite numbers";
    let Some(three) = words.get(..3) else {
        return Err(MeshError::new(
            format!("{what} has {} numbers", words.len()),
            expected,
        ));
    };
    let finite = |w: &str| w.parse().is_ok_and(f64::is_finite);
    match three.iter().find(|w| !finite(w)) {
        Some(w) => Err(MeshError::new(format!("{what} has '{w}'"), expected)),
        None => Ok(()),
    }
}

/// Vertices or normals: so far, which relative indices count from, and in the whole file.
#[derive(Clone, Copy, Default)]
struct Count {
    so_far: usize,
    total: usize,
}

fn index(word: &str, count: Count, what: &str) -> Result<(), MeshError> {
    let n: i64 = word.parse().map_err(|_| {
        MeshError::new(
            format!("'{word}' is not an index"),
            "expected v, v/t, v//n or v/t/n",
        )
    })?;
    let Count { so_far, total } = count;
    let last = if n < 0 { so_far } else { total };
    if n != 0 && n.unsigned_abs() <= last as u64 {
        return Ok(());
    }
    Err(MeshError::new(
        format!("{what} {n} does not exist"),
        format!("expected 1 to {total} or -1 to -{so_far}"),
    ))
}

fn face(words: &[&str], vertices: Count, normals: Count) -> Result<(), MeshError> {
    if words.len() < 3 {
        return Err(MeshError::new(
            format!("a face of {} corners", words.len()),
            "expected at least three",
        ));
    }
    for word in words {
        let mut parts = word.split('/');
        index(parts.next().unwrap_or(""), vertices, "vertex")?;
        if let Some(normal) = parts.nth(1).filter(|w| !w.is_empty()) {
            index(normal, normals, "normal")?;
        }
    }
    Ok(())
}

/// The first thing that is wrong, with its line.
pub(super) fn first_fault(text: &str) -> Option<MeshError> {
    let total = |kind: &str| Count {
        so_far: 0,
        total: lines(text).filter(|w| w.first() == Some(&kind)).count(),
    };
    let (mut vertices, mut normals) = (total("v"), total("vn"));
    for (i, words) in lines(text).enumerate() {
        let sound = match words.as_slice() {
            ["v", rest @ ..] => {
                vertices.so_far += 1;
                numbers(rest, "vertex")
            }
            ["vn", rest @ ..] => {
                normals.so_far += 1;
                numbers(rest, "normal")
            }
            ["f", rest @ ..] => face(rest, vertices, normals),
            _ => Ok(()),
        };
        if let Err(e) = sound {
            return Some(e.at(i + 1));
        }
    }
    None
}
