//! glTF 2.0 and GLB: the triangles of the default scene, nodes' transforms applied. Materials and cameras of the file
//! are not used; of texture coordinates the first set (TEXCOORD_0) is read, and its v, which glTF counts downwards, is
//! turned upwards. Buffers may be the GLB's own, `data:` URIs or files beside the mesh.

use super::pseudo_normals::{pseudo_normals, Weighting};
use super::{Mesh, MeshError};
use glam::{DMat4, DVec2, DVec3};
use std::path::Path;

fn broken(what: impl Into<String>) -> MeshError {
    MeshError::new(what, "expected glTF 2.0 with triangles")
}

/// Reads a glTF or GLB file; primitives without normals get them by `weighting`.
///
/// # Errors
/// What is wrong.
pub fn load(path: &Path, weighting: Weighting) -> Result<Mesh, MeshError> {
    let bytes = std::fs::read(path).map_err(|e| {
        MeshError::new(
            format!("cannot be read ({e})"),
            "expected a readable glTF file",
        )
    })?;
    parse(&bytes, path, weighting)
}

fn parse(bytes: &[u8], path: &Path, weighting: Weighting) -> Result<Mesh, MeshError> {
    let unreadable = |e: gltf::Error| broken(format!("not readable ({e})"));
    let unchecked = gltf::Gltf::from_slice_without_validation(bytes).map_err(unreadable)?;
    check_attributes(&unchecked)?;
    let mut file = gltf::Gltf::from_slice(bytes).map_err(unreadable)?;
    let blob = file.blob.take();
    let buffers = file
        .buffers()
        .map(|b| buffer(&b, blob.as_deref(), path))
        .collect::<Result<Vec<_>, _>>()?;
    for a in file.accessors() {
        check_accessor(&a, &buffers)?;
    }
    let mut mesh = Mesh::default();
    let scene = file
        .default_scene()
        .or_else(|| file.scenes().next())
        .ok_or_else(|| broken("no scene"))?;
    let mut todo: Vec<(gltf::Node<'_>, DMat4)> =
        scene.nodes().map(|n| (n, DMat4::IDENTITY)).collect();
    todo.reverse();
    let mut visits = 0;
    while let Some((node, above)) = todo.pop() {
        // A tree visits each node once; more means that nodes form a ring.
        visits += 1;
        if visits > file.nodes().len() {
            return Err(broken("the nodes are not a tree"));
        }
        let own = DMat4::from_cols_array_2d(&node.transform().matrix().map(|c| c.map(f64::from)));
        let to_root = above * own;
        for primitive in node.mesh().iter().flat_map(gltf::Mesh::primitives) {
            add(&mut mesh, &primitive, to_root, &buffers, weighting)?;
        }
        todo.extend(node.children().map(|c| (c, to_root)));
    }
    Ok(mesh)
}

/// The validation of the `gltf` crate (1.4) looks up the accessors of attributes before it checks that they exist.
fn check_attributes(file: &gltf::Gltf) -> Result<(), MeshError> {
    let root = file.document.as_json();
    let attributes = root
        .meshes
        .iter()
        .flat_map(|m| &m.primitives)
        .flat_map(|p| p.attributes.values());
    match attributes
        .map(|i| i.value())
        .find(|i| *i >= root.accessors.len())
    {
        Some(i) => Err(broken(format!("accessor {i} does not exist"))),
        None => Ok(()),
    }
}

fn buffer(b: &gltf::Buffer<'_>, blob: Option<&[u8]>, path: &Path) -> Result<Vec<u8>, MeshError> {
    let data = match b.source() {
        gltf::buffer::Source::Bin => blob
            .map(<[u8]>::to_vec)
            .ok_or_else(|| broken("no binary chunk"))?,
        gltf::buffer::Source::Uri(uri) => match uri.strip_prefix("data:") {
            Some(data) => data
                .split_once(";base64,")
                .and_then(|(_, text)| base64(text))
                .ok_or_else(|| broken("a data URI that is not base64"))?,
            None => std::fs::read(path.parent().unwrap_or(Path::new("")).join(uri))
                .map_err(|e| broken(format!("buffer '{uri}' cannot be read ({e})")))?,
        },
    };
    if data.len() < b.length() {
        return Err(broken(format!(
            "buffer of {} bytes, {} announced",
            data.len(),
            b.length()
        )));
    }
    Ok(data)
}

/// RFC 4648 base64, padding optional.
fn base64(text: &str) -> Option<Vec<u8>> {
    let mut out = Vec::with_capacity(text.len() * 3 / 4);
    let (mut bits, mut held) = (0u32, 0);
    for c in text.trim_end_matches('=').bytes() {
        let v = match c {
            b'A'..=b'Z' => c - b'A',
            b'a'..=b'z' => c - b'a' + 26,
            b'0'..=b'9' => c - b'0' + 52,
            b'+' => 62,
            b'/' => 63,
            _ => return None,
        };
        bits = (bits << 6) | u32::from(v);
        held += 6;
        if held >= 8 {
            held -= 8;
            out.push((bits >> held) as u8);
            bits &= (1 << held) - 1;
        }
    }
    Some(out)
}

/// Everything an accessor reaches must lie in its buffer; the reader below relies on it.
fn check_accessor(a: &gltf::Accessor<'_>, buffers: &[Vec<u8>]) -> Result<(), MeshError> {
    if a.sparse().is_some() {
        return Err(broken(format!("accessor {} is sparse", a.index())));
    }
    let Some(view) = a.view() else {
        return Err(broken(format!("accessor {} has no data", a.index())));
    };
    let stride = view.stride().unwrap_or(a.size());
    let reach = a
        .count()
        .checked_sub(1)
        .and_then(|n| n.checked_mul(stride))
        .and_then(|n| n.checked_add(a.size()))
        .and_then(|n| n.checked_add(a.offset()));
    let inside = reach.is_some_and(|r| r <= view.length())
        && view.offset().checked_add(view.length()).is_some_and(|end| {
            buffers
                .get(view.buffer().index())
                .is_some_and(|b| end <= b.len())
        });
    if inside && stride >= a.size() {
        Ok(())
    } else {
        Err(broken(format!(
            "accessor {} reaches beyond its buffer",
            a.index()
        )))
    }
}

fn add(
    mesh: &mut Mesh,
    p: &gltf::Primitive<'_>,
    to_root: DMat4,
    buffers: &[Vec<u8>],
    weighting: Weighting,
) -> Result<(), MeshError> {
    if p.mode() != gltf::mesh::Mode::Triangles {
        return Err(broken(format!("a primitive of {:?}", p.mode())));
    }
    use gltf::accessor::{DataType, Dimensions};
    for (semantic, a) in p.attributes() {
        let wanted = matches!(
            semantic,
            gltf::Semantic::Positions | gltf::Semantic::Normals
        );
        if wanted && (a.data_type() != DataType::F32 || a.dimensions() != Dimensions::Vec3) {
            return Err(broken("positions or normals that are not three floats"));
        }
        if semantic == gltf::Semantic::TexCoords(0)
            && (!matches!(a.data_type(), DataType::F32 | DataType::U8 | DataType::U16)
                || a.dimensions() != Dimensions::Vec2)
        {
            return Err(broken("texture coordinates that are not two numbers"));
        }
    }
    if let Some(a) = p.indices() {
        let whole = matches!(a.data_type(), DataType::U8 | DataType::U16 | DataType::U32);
        if !whole || a.dimensions() != Dimensions::Scalar {
            return Err(broken("indices that are not whole numbers"));
        }
    }
    let reader = p.reader(|b| buffers.get(b.index()).map(Vec::as_slice));
    let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
    let mut part = Mesh {
        positions: reader
            .read_positions()
            .ok_or_else(|| broken("a primitive without positions"))?
            .map(|v| to_root.transform_point3(vector(v)))
            .collect(),
        ..Mesh::default()
    };
    let count = part.positions.len() as u32;
    let indices: Vec<u32> = match reader.read_indices() {
        Some(i) => i.into_u32().collect(),
        None => (0..count).collect(),
    };
    if let Some(bad) = indices.iter().find(|i| **i >= count) {
        return Err(broken(format!("index {bad} of {count} vertices")));
    }
    if !indices.len().is_multiple_of(3) {
        return Err(broken(format!(
            "{} indices, not a multiple of three",
            indices.len()
        )));
    }
    // A mirroring node turns the winding around.
    let linear = glam::DMat3::from_mat4(to_root);
    let flip = linear.determinant() < 0.0;
    part.triangles = indices
        .chunks_exact(3)
        .map(|t| {
            if flip {
                [t[0], t[2], t[1]]
            } else {
                [t[0], t[1], t[2]]
            }
        })
        .collect();
    match reader.read_normals() {
        Some(normals) => {
            let turn = linear.try_inverse().map_or(linear, |i| i.transpose());
            part.normals = normals.map(|v| turn * vector(v)).collect();
            part.normals.resize(part.positions.len(), DVec3::ZERO);
        }
        None => part.normals = pseudo_normals(&part, weighting),
    }
    if let Some(all) = reader.read_tex_coords(0) {
        let all: Vec<DVec2> = all
            .into_f32()
            .map(|[u, v]| DVec2::new(f64::from(u), 1.0 - f64::from(v)))
            .collect();
        let at = |i: u32| all.get(i as usize).copied().unwrap_or_default();
        part.uv = part.triangles.iter().map(|t| t.map(at)).collect();
    }
    // Of several primitives with and without coordinates, the latter lie in the origin of the texture.
    if !(mesh.uv.is_empty() && part.uv.is_empty()) {
        mesh.uv.resize(mesh.triangles.len(), [DVec2::ZERO; 3]);
        part.uv.resize(part.triangles.len(), [DVec2::ZERO; 3]);
        mesh.uv.append(&mut part.uv);
    }
    let first = mesh.positions.len() as u32;
    mesh.positions.extend(part.positions);
    mesh.normals.extend(part.normals);
    mesh.triangles
        .extend(part.triangles.iter().map(|t| t.map(|i| i + first)));
    if mesh.triangles.len() > super::TRIANGLE_LIMIT {
        return Err(MeshError::new(
            "too many triangles",
            format!("expected at most {}", super::TRIANGLE_LIMIT),
        ));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_of_the_standard() {
        assert_eq!(base64("Zm9vYmFy").unwrap(), b"foobar");
        assert_eq!(base64("Zm9vYg==").unwrap(), b"foob");
        assert_eq!(base64("Zm9vYmE=").unwrap(), b"fooba");
        assert_eq!(base64("Zm9*"), None);
    }

    /// A file of two triangles with the same positions, the first with texture coordinates as `coordinates` says.
    fn two_primitives(coordinates: &str) -> String {
        let numbers: [f32; 15] = [
            0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, // positions
            0.0, 1.0, 0.75, 1.0, 0.0, 0.25, // coordinates, v downwards
        ];
        let bits: String = numbers
            .iter()
            .flat_map(|n| n.to_le_bytes())
            .map(|b| format!("{b:08b}"))
            .collect();
        let sextet = |c: &[u8]| {
            let index = c.iter().fold(0, |v, b| v * 2 + usize::from(b - b'0'));
            char::from(b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"[index])
        };
        let text: String = bits.as_bytes().chunks(6).map(sextet).collect();
        format!(
            r#"{{"asset":{{"version":"2.0"}},"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],
            "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"TEXCOORD_0":1}}}},{{"attributes":{{"POSITION":0}}}}]}}],
            "buffers":[{{"byteLength":60,"uri":"data:;base64,{text}"}}],
            "bufferViews":[{{"buffer":0,"byteLength":36}},{{"buffer":0,"byteOffset":36,"byteLength":24}}],
            "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}},
            {{"bufferView":1,"componentType":5126,{coordinates}}}]}}"#
        )
    }

    #[test]
    fn texture_coordinates_are_turned_upwards() {
        let here = Path::new("two.gltf");
        let text = two_primitives(r#""count":3,"type":"VEC2""#);
        let m = parse(
            text.as_bytes(),
            here,
            crate::mesh::pseudo_normals::Weighting::default(),
        )
        .unwrap();
        assert_eq!(m.check(), Ok(()));
        let first = [
            DVec2::new(0.0, 0.0),
            DVec2::new(0.75, 0.0),
            DVec2::new(0.0, 0.75),
        ];
        assert_eq!(m.uv, [first, [DVec2::ZERO; 3]]);
        let text = two_primitives(r#""count":2,"type":"VEC3""#);
        assert_eq!(
            parse(
                text.as_bytes(),
                here,
                crate::mesh::pseudo_normals::Weighting::default()
            )
            .unwrap_err()
            .to_string(),
            "texture coordinates that are not two numbers; expected glTF 2.0 with triangles"
        );
    }

    #[test]
    fn damaged_files_are_refused_and_never_panic() {
        let good = include_bytes!("../../../scenes/meshes/ring.glb");
        let here = Path::new("ring.glb");
        let whole = parse(
            good,
            here,
            crate::mesh::pseudo_normals::Weighting::default(),
        )
        .unwrap();
        assert_eq!(whole.check(), Ok(()));
        for cut in (0..good.len()).step_by(7) {
            assert!(parse(
                &good[..cut],
                here,
                crate::mesh::pseudo_normals::Weighting::default()
            )
            .is_err());
        }
        let mut seed = 1u32;
        for _ in 0..3000 {
            let mut bad = good.to_vec();
            for _ in 0..3 {
                seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                let at = (seed >> 8) as usize % bad.len();
                bad[at] = (seed >> 3) as u8;
            }
            let _ = parse(
                &bad,
                here,
                crate::mesh::pseudo_normals::Weighting::default(),
            )
            .map(|m| m.check());
        }
    }
}
