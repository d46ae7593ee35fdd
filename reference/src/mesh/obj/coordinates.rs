//! The texture coordinates of an OBJ file: `vt u [v]` (v upwards, 0 when absent) and the second index of a corner.
//! The result has one entry for each face, with one for each of its corners.

use super::lines;
use crate::mesh::MeshError;
use glam::DVec2;

fn coordinate(words: &[&str]) -> Result<DVec2, MeshError> {
    let number = |i: usize| match words.get(i) {
        None if i > 0 => Some(0.0),
        None => None,
        Some(w) => w.parse().ok().filter(|v: &f64| v.is_finite()),
    };
    match (number(0), number(1)) {
        (Some(u), Some(v)) => Ok(DVec2::new(u, v)),
        _ => Err(MeshError::new(
            format!("texture coordinates '{}'", words.join(" ")),
            "expected two finite numbers",
        )),
    }
}

/// The coordinates that a corner `v/t` or `v/t/n` names; relative indices count from those `so_far`.
fn of_corner(word: &str, all: &[DVec2], so_far: usize) -> Result<DVec2, MeshError> {
    let index = word.split('/').nth(1).unwrap_or("");
    if index.is_empty() {
        return Err(MeshError::new(
            format!("corner '{word}' has no texture coordinates"),
            "expected v/t or v/t/n",
        ));
    }
    let place = match index.parse::<i64>() {
        Ok(n) if n > 0 => usize::try_from(n - 1).ok(),
        Ok(n) if n < 0 => usize::try_from(n.unsigned_abs())
            .ok()
            .and_then(|back| so_far.checked_sub(back)),
        _ => None,
    };
    place.and_then(|i| all.get(i)).copied().ok_or_else(|| {
        MeshError::new(
            format!("texture coordinates {index} do not exist"),
            format!("expected 1 to {} or -1 to -{so_far}", all.len()),
        )
    })
}

/// Texture coordinates at the corners of every face.
///
/// # Errors
/// The first corner that has none, or the first that are broken, with the line.
pub(super) fn read(text: &str) -> Result<Vec<Vec<DVec2>>, MeshError> {
    let mut all = Vec::new();
    for (i, words) in lines(text).enumerate() {
        if let ["vt", rest @ ..] = words.as_slice() {
            all.push(coordinate(rest).map_err(|e| e.at(i + 1))?);
        }
    }
    let mut out = Vec::new();
    let mut so_far = 0;
    for (i, words) in lines(text).enumerate() {
        match words.as_slice() {
            ["vt", ..] => so_far += 1,
            ["f", corners @ ..] => {
                let corners = corners
                    .iter()
                    .map(|word| of_corner(word, &all, so_far))
                    .collect::<Result<Vec<_>, _>>()
                    .map_err(|e| e.at(i + 1))?;
                out.push(corners);
            }
            _ => {}
        }
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In this file the coordinates of every vertex are its position; whatever the reader does with polygons, indices
    /// and normals, they must stay so.
    #[test]
    fn coordinates_follow_their_vertices() {
        let m = super::super::parse(
            "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\nvt 1\nvt 2 1 7\n\
             f 1/1/1 2/2 3/3\nvt 1 2\nvt 0 1\nf 1/1 2/-4 3/3 4/4//1 5/-1\nf -5/-5//1 -3/-3 -2/-2 -1/-1\n",
            Default::default(),
        )
        .unwrap();
        assert_eq!(m.triangles.len(), 1 + 3 + 2);
        assert_eq!(m.check(), Ok(()));
        for (t, uv) in m.triangles.iter().zip(&m.uv) {
            for (i, uv) in t.iter().zip(uv) {
                assert_eq!(m.positions[*i as usize].truncate(), *uv);
            }
        }
    }

    #[test]
    fn a_seam_splits_no_vertex() {
        let m = super::super::parse(
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\nf 1/2 3/1 4/3\n",
            Default::default(),
        )
        .unwrap();
        assert_eq!(m.positions.len(), 4);
        assert_eq!(m.uv[0][0], DVec2::ZERO);
        assert_eq!(m.uv[1][0], DVec2::X);
    }

    #[test]
    fn what_is_wrong_is_said_with_its_line() {
        let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
        for (rest, want) in [
            (
                "f 1 2 3",
                "4: corner '1' has no texture coordinates; expected v/t or v/t/n",
            ),
            (
                "vt 1 2\nf 1/1 2//1 3/1",
                "5: corner '2//1' has no texture coordinates; expected v/t or v/t/n",
            ),
            (
                "vt 1 2\nf 1/1 2/2 3/1",
                "5: texture coordinates 2 do not exist; expected 1 to 1 or -1 to -1",
            ),
            (
                "f 1/-1 2/1 3/1\nvt 1 2",
                "4: texture coordinates -1 do not exist; expected 1 to 1 or -1 to -0",
            ),
            (
                "vt 1 2\nf 1/0 2/1 3/1",
                "5: texture coordinates 0 do not exist; expected 1 to 1 or -1 to -1",
            ),
            (
                "vt nan 2",
                "4: texture coordinates 'nan 2'; expected two finite numbers",
            ),
            (
                "vt",
                "4: texture coordinates ''; expected two finite numbers",
            ),
        ] {
            let e = read(&format!("{corners}{rest}\n")).unwrap_err();
            assert_eq!(e.to_string(), want, "{rest}");
        }
    }
}
