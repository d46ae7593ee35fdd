//! Objects of a scene: a mesh file or a generated shape, its transform and its material.

use super::read::Table;
use super::{Draw, Material, Object, SceneError};
use crate::mesh::pseudo_normals::Weighting;
use crate::mesh::{self, Mesh};
use crate::method::nearest;
use glam::{DMat3, DMat4, DQuat, DVec3, EulerRot};
use std::path::{Path, PathBuf};

pub(super) const KEYS: &[&str] = &[
    "mesh",
    "normals",
    "shape",
    "material",
    "draw",
    "translate",
    "rotate",
    "scale",
    "slices",
    "stacks",
    "radius",
    "major",
    "minor",
    "segments",
    "sides",
    "subdivisions",
];

/// The shapes and the keys each of them takes.
const SHAPES: [(&str, &[&str]); 5] = [
    ("sphere", &["slices", "stacks", "radius"]),
    ("torus", &["major", "minor", "segments", "sides"]),
    ("plane", &["subdivisions"]),
    ("box", &["subdivisions"]),
    ("teapot", &["subdivisions"]),
];

pub(super) fn object(
    t: &Table<'_>,
    scene: &Path,
    materials: &[Material],
) -> Result<Object, SceneError> {
    let file = t.string("mesh", "the name of an OBJ, glTF or GLB file")?;
    let shape = t.word("shape", &SHAPES.map(|s| s.0))?;
    let (source, mesh) = match (file, shape) {
        (Some(file), None) => {
            refuse_foreign(t, "mesh", &[])?;
            (file, from_file(t, file, scene)?)
        }
        (None, Some(_)) if t.has("normals") => {
            return Err(t.error(
                "normals",
                "does not belong to a shape",
                "expected it only with a mesh",
            ));
        }
        (None, Some(shape)) => (shape, generated(t, shape)?),
        (None, None) => {
            return Err(t.missing("shape", "mesh = 'file' or shape = 'sphere' and the like"))
        }
        (Some(_), Some(_)) => {
            return Err(t.error(
                "shape",
                "given together with mesh",
                "expected one of mesh and shape",
            ));
        }
    };
    let material = material(t, materials)?;
    if mesh.uv.is_empty() {
        without_coordinates(t, source, scene, &materials[material])?;
    }
    Ok(Object {
        source: source.to_owned(),
        mesh,
        transform: transform(t)?,
        material,
        draw: match t.word("draw", &["shaded", "wireframe"])? {
            Some("wireframe") => Draw::Wireframe,
            _ => Draw::Shaded,
        },
    })
}

/// Refuses a mesh without texture coordinates for a material that needs them.
fn without_coordinates(
    t: &Table<'_>,
    file: &str,
    scene: &Path,
    material: &Material,
) -> Result<(), SceneError> {
    let what = match (&material.texture, &material.bump) {
        (Some(_), _) => "texture",
        (_, Some(_)) => "bump map",
        (None, None) => return Ok(()),
    };
    let needs = format!("material '{}' has a {what}, but {file}", material.name);
    let fault = match ending(file).as_str() {
        "obj" => mesh::obj::check_coordinates(&beside(scene, file)).err(),
        _ => None,
    };
    match fault {
        Some(e) => Err(t.error(
            "mesh",
            &format!("{needs}:{}: {}", e.line.unwrap_or(1), e.what),
            &e.accepted,
        )),
        None => Err(t.error(
            "mesh",
            &format!("{needs} has no texture coordinates"),
            "expected TEXCOORD_0",
        )),
    }
}

fn beside(scene: &Path, file: &str) -> PathBuf {
    scene.parent().unwrap_or(Path::new("")).join(file)
}

/// The ending of a file name, in small letters.
fn ending(file: &str) -> String {
    let ending = Path::new(file).extension().unwrap_or_default();
    ending.to_string_lossy().to_lowercase()
}

fn from_file(t: &Table<'_>, file: &str, scene: &Path) -> Result<Mesh, SceneError> {
    let path = beside(scene, file);
    let weighting = t.word("normals", &Weighting::NAMES)?;
    let weighting = weighting.and_then(|w| w.parse().ok()).unwrap_or_default();
    let mesh = match ending(file).as_str() {
        "obj" => mesh::obj::load(&path, weighting),
        "gltf" | "glb" => mesh::gltf::load(&path, weighting),
        _ => {
            return Err(t.error(
                "mesh",
                &format!("'{file}' has no known ending"),
                "expected a file ending in .obj, .gltf or .glb",
            ));
        }
    };
    mesh.and_then(|m| m.check().map(|()| m)).map_err(|e| {
        let at = e.line.map(|l| format!(":{l}")).unwrap_or_default();
        t.error("mesh", &format!("{file}{at}: {}", e.what), &e.accepted)
    })
}

/// Refuses keys of other shapes: they would silently do nothing.
fn refuse_foreign(t: &Table<'_>, what: &str, own: &[&str]) -> Result<(), SceneError> {
    let foreign = SHAPES
        .iter()
        .flat_map(|s| s.1)
        .find(|k| t.has(k) && !own.contains(k));
    match foreign {
        None => Ok(()),
        Some(key) => Err(t.error(
            key,
            &format!("does not belong to {what}"),
            &if own.is_empty() {
                "expected it only with a shape".to_owned()
            } else {
                format!("expected only {}", own.join(", "))
            },
        )),
    }
}

fn generated(t: &Table<'_>, shape: &str) -> Result<Mesh, SceneError> {
    let own = SHAPES
        .iter()
        .find(|s| s.0 == shape)
        .map_or(&[][..], |s| s.1);
    refuse_foreign(t, shape, own)?;
    let length = |key: &str, default: f64| {
        Ok(t.number_if(key, "a number above 0", |x| x > 0.0)?
            .unwrap_or(default))
    };
    let count = |key: &str, least: u32, most: u32, default: u32| {
        Ok(t.integer(key, least, most)?.unwrap_or(default))
    };
    Ok(match shape {
        "sphere" => mesh::sphere::sphere(
            count("slices", 3, 2048, 23)?,
            count("stacks", 2, 2048, 16)?,
            length("radius", 1.0)?,
        ),
        "torus" => {
            let (major, minor) = (length("major", 1.0)?, length("minor", 0.4)?);
            if minor >= major {
                return Err(t.error(
                    "minor",
                    &format!("is {minor}, not below major = {major}"),
                    "expected minor < major",
                ));
            }
            mesh::torus::torus(
                major,
                minor,
                count("segments", 3, 2048, 12)?,
                count("sides", 3, 2048, 12)?,
            )
        }
        "plane" => mesh::solids::plane(count("subdivisions", 1, 1024, 1)?),
        "box" => mesh::solids::cube(count("subdivisions", 1, 512, 1)?),
        _ => mesh::teapot::teapot(count("subdivisions", 1, 256, 10)?),
    })
}

/// What the object is moved by.
pub(super) fn translation(t: &Table<'_>) -> Result<DVec3, SceneError> {
    Ok(t.vector("translate")?.unwrap_or(DVec3::ZERO))
}

/// How it is turned: about x first, then y, then z.
pub(super) fn rotation(t: &Table<'_>) -> Result<DQuat, SceneError> {
    let accepted = "three angles [x, y, z] in degrees";
    let rotate = t.vector_if("rotate", accepted, false, |_| true)?;
    let [x, y, z] = rotate
        .unwrap_or(DVec3::ZERO)
        .to_array()
        .map(f64::to_radians);
    Ok(DQuat::from_euler(EulerRot::ZYX, z, y, x))
}

/// What it is scaled by, before all else.
pub(super) fn scale(t: &Table<'_>) -> Result<DVec3, SceneError> {
    let accepted = "a number or [x, y, z], each of size 1e-6 to 1e6";
    let scale = t.vector_if("scale", accepted, true, |x| (1e-6..=1e6).contains(&x.abs()))?;
    Ok(scale.unwrap_or(DVec3::ONE))
}

fn transform(t: &Table<'_>) -> Result<DMat4, SceneError> {
    let (translate, turn) = (translation(t)?, DMat3::from_quat(rotation(t)?));
    let linear = turn * DMat3::from_diagonal(scale(t)?);
    Ok(DMat4::from_translation(translate) * DMat4::from_mat3(linear))
}

fn material(t: &Table<'_>, materials: &[Material]) -> Result<usize, SceneError> {
    let names: Vec<&str> = materials.iter().map(|m| m.name.as_str()).collect();
    let Some(name) = t.string("material", "the name of a material")? else {
        return if materials.len() == 1 {
            Ok(0)
        } else {
            Err(t.missing("material", &format!("one of {}", names.join(", "))))
        };
    };
    materials
        .iter()
        .position(|m| m.name == name)
        .ok_or_else(|| {
            let near = nearest(name, &names).unwrap_or_default();
            t.error(
                "material",
                &format!("unknown '{name}'"),
                &format!("the nearest is '{near}' of {}", names.join(", ")),
            )
        })
}
