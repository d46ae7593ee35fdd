//! From a TOML document to a checked scene: image, camera, lights, materials and the wish for a method.

use super::object::object;
use super::read::{Document, Table};
use super::surface;
use super::{
    Brdf, Camera, Image, Light, LightKind, Material, Projection, Render, Scene, SceneError,
    IMAGE_LIMIT,
};
use crate::mesh::TRIANGLE_LIMIT;
use crate::method::Method;
use glam::DVec3;
use std::path::Path;
use toml::de::DeTable;

const COLOUR: &str = "a number or [r, g, b], each from 0 to 100";

fn is_colour(x: f64) -> bool {
    (0.0..=100.0).contains(&x)
}

/// Reads and checks a scene file and the meshes it names (relative to the scene's folder).
///
/// # Errors
/// The first thing that is wrong, with file, line, field and what would be accepted.
pub fn load(path: &Path) -> Result<Scene, SceneError> {
    let text = std::fs::read_to_string(path).map_err(|e| {
        let what = format!("cannot be read ({e})");
        SceneError::new(path, 1, "scene", &what, "expected a readable TOML file")
    })?;
    parse(path, &text)
}

/// Checks the text of a scene file; mesh files are looked for beside `path`.
pub(super) fn parse(path: &Path, text: &str) -> Result<Scene, SceneError> {
    let doc = Document { file: path, text };
    let root = DeTable::parse(text).map_err(|e| {
        let line = e.span().map_or(1, |s| doc.line(s.start));
        doc.error(line, "scene", e.message(), "expected TOML 1.0")
    })?;
    let known = ["image", "camera", "light", "material", "object", "render"];
    let root = Table::new(doc, root.get_ref(), "", 1, &known)?;

    let image = image(&root)?;
    let camera = camera(&root)?;
    let lights = root
        .tables(
            "light",
            &["kind", "direction", "position", "colour", "intensity"],
        )?
        .iter()
        .map(light)
        .collect::<Result<_, _>>()?;
    let materials = materials(&root, path)?;
    let objects = root
        .tables("object", super::object::KEYS)?
        .iter()
        .map(|t| object(t, path, &materials))
        .collect::<Result<Vec<_>, _>>()?;
    if objects.is_empty() {
        return Err(root.missing("object", "at least one table [[object]]"));
    }
    let total: usize = objects.iter().map(|o| o.mesh.triangles.len()).sum();
    if total > TRIANGLE_LIMIT {
        return Err(root.error(
            "object",
            &format!("{total} triangles in all"),
            &format!("expected at most {TRIANGLE_LIMIT}"),
        ));
    }
    let method = match root.table("render", &["method"])? {
        Some(t) => t.word("method", Method::NAMES)?,
        None => None,
    };
    Ok(Scene {
        name: path
            .file_stem()
            .map_or_else(|| "scene".to_owned(), |s| s.to_string_lossy().into_owned()),
        file: path.to_owned(),
        image,
        camera,
        lights,
        materials,
        objects,
        render: Render {
            method: method
                .and_then(|m| m.parse().ok())
                .unwrap_or(Method::Quadratic),
        },
    })
}

fn image(root: &Table<'_>) -> Result<Image, SceneError> {
    let t = root
        .table("image", &["width", "height", "background"])?
        .ok_or_else(|| root.missing("image", "a table [image] with width and height"))?;
    let side = |key: &str| {
        t.integer(key, 1, IMAGE_LIMIT)?
            .ok_or_else(|| t.missing(key, &format!("an integer from 1 to {IMAGE_LIMIT}")))
    };
    let accepted = "[r, g, b], each an integer from 0 to 255";
    let background = t
        .vector_if("background", accepted, false, |x| {
            (0.0..=255.0).contains(&x) && x.fract() == 0.0
        })?
        .unwrap_or(DVec3::ZERO);
    Ok(Image {
        width: side("width")?,
        height: side("height")?,
        background: background.to_array().map(|v| v as u8),
    })
}

fn camera(root: &Table<'_>) -> Result<Camera, SceneError> {
    let keys = ["eye", "target", "up", "fov", "height", "near", "far"];
    let t = root.table("camera", &keys)?.ok_or_else(|| {
        root.missing(
            "camera",
            "a table [camera] with eye, target and fov or height",
        )
    })?;
    let need = |key: &str| {
        t.vector(key)?
            .ok_or_else(|| t.missing(key, "three numbers [x, y, z]"))
    };
    let (eye, target) = (need("eye")?, need("target")?);
    let up = t.vector("up")?.unwrap_or(DVec3::Y);
    let view = target - eye;
    if view.length() < 1e-9 {
        return Err(t.error(
            "target",
            "is where the eye is",
            "expected a point apart from camera.eye",
        ));
    }
    if up.length() < 1e-9 {
        return Err(t.error(
            "up",
            "has no length",
            "expected a direction such as [0, 1, 0]",
        ));
    }
    if view.normalize().cross(up.normalize()).length() < 1e-9 {
        return Err(t.error(
            "up",
            "is parallel to the view",
            "expected a direction across target - eye",
        ));
    }
    let fov = t.number_if("fov", "degrees above 0 and below 180", |x| {
        x > 0.0 && x < 180.0
    })?;
    let height = t.number_if("height", "a number above 0", |x| x > 0.0)?;
    let projection = match (fov, height) {
        (Some(fov), None) => Projection::Perspective { fov },
        (None, Some(height)) => Projection::Orthographic { height },
        (None, None) => {
            return Err(t.missing("fov", "fov (perspective, degrees) or height (orthographic)"));
        }
        (Some(_), Some(_)) => {
            return Err(t.error(
                "height",
                "given together with fov",
                "expected one of fov and height",
            ));
        }
    };
    let positive = "a number above 0";
    let near = t.number_if("near", positive, |x| x > 0.0)?.unwrap_or(0.01);
    let far = t
        .number_if("far", positive, |x| x > 0.0)?
        .unwrap_or(near.max(1.0) * 1e4);
    if near >= far {
        return Err(t.error(
            "near",
            &format!("is {near}, not below far = {far}"),
            "expected near < far",
        ));
    }
    Ok(Camera {
        eye,
        target,
        up,
        projection,
        near,
        far,
    })
}

fn light(t: &Table<'_>) -> Result<Light, SceneError> {
    let kind = t
        .word("kind", &["directional", "point"])?
        .ok_or_else(|| t.missing("kind", "'directional' or 'point'"))?;
    let alien = if kind == "point" {
        "direction"
    } else {
        "position"
    };
    if t.has(alien) {
        return Err(t.error(
            alien,
            &format!("does not belong to a {kind} light"),
            &format!("expected it only with the other kind, not '{kind}'"),
        ));
    }
    let kind = if kind == "point" {
        LightKind::Point {
            position: t
                .vector("position")?
                .ok_or_else(|| t.missing("position", "three numbers [x, y, z]"))?,
        }
    } else {
        let d = t
            .vector("direction")?
            .ok_or_else(|| t.missing("direction", "three numbers [x, y, z]"))?;
        if d.length() < 1e-9 {
            return Err(t.error(
                "direction",
                "has no length",
                "expected the direction in which the light travels",
            ));
        }
        LightKind::Directional {
            direction: d.normalize(),
        }
    };
    let colour = t
        .vector_if("colour", COLOUR, true, is_colour)?
        .unwrap_or(DVec3::ONE);
    let intensity = t
        .number_if("intensity", "a number from 0 to 100", is_colour)?
        .unwrap_or(1.0);
    Ok(Light {
        kind,
        colour: colour * intensity,
    })
}

fn materials(root: &Table<'_>, scene: &Path) -> Result<Vec<Material>, SceneError> {
    let keys = [
        "name",
        "brdf",
        "ambient",
        "diffuse",
        "specular",
        "shininess",
    ];
    let keys = [&keys, surface::KEYS].concat();
    let mut all: Vec<Material> = Vec::new();
    for t in root.tables("material", &keys)? {
        let name = t
            .string("name", "a name")?
            .ok_or_else(|| t.missing("name", "a name for objects to use"))?;
        if all.iter().any(|m| m.name == name) {
            return Err(t.error(
                "name",
                &format!("'{name}' is taken"),
                "expected a name of its own",
            ));
        }
        let brdf = match t.word("brdf", &["lambert", "blinn"])? {
            Some("lambert") => Brdf::Lambert,
            _ => Brdf::Blinn,
        };
        let colour = |key: &str, default: f64| {
            Ok(t.vector_if(key, COLOUR, true, is_colour)?
                .unwrap_or(DVec3::splat(default)))
        };
        let mut specular = colour("specular", 0.0)?;
        let shininess = t.number_if("shininess", "a number from 0 to 10000", |x| {
            (0.0..=1e4).contains(&x)
        })?;
        if brdf == Brdf::Lambert {
            if let Some(key) = ["specular", "shininess"].into_iter().find(|k| t.has(k)) {
                return Err(t.error(
                    key,
                    "does not belong to the lambert model",
                    "expected it only with brdf = 'blinn'",
                ));
            }
            specular = DVec3::ZERO;
        }
        all.push(Material {
            name: name.to_owned(),
            brdf,
            ambient: colour("ambient", 0.0)?,
            diffuse: colour("diffuse", 0.8)?,
            specular,
            shininess: shininess.unwrap_or(20.0),
            texture: surface::texture(&t, scene)?,
            bump: surface::bump(&t, scene)?,
        });
    }
    if all.is_empty() {
        return Err(root.missing("material", "at least one table [[material]]"));
    }
    Ok(all)
}
