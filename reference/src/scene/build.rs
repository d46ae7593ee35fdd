//! From a TOML document to a checked scene: its parts, image, camera and the wish for a method.

use super::material::materials;
use super::object::object;
use super::read::{Document, Table};
use super::{light, Camera, Image, Projection, Render, Scene, SceneError, IMAGE_LIMIT};
use crate::antialias::Antialias;
use crate::line::cue::Cue;
use crate::line::LineFilter;
use crate::mesh::TRIANGLE_LIMIT;
use crate::method::Method;
use crate::sample::{Filter, SAMPLE_LIMIT};
use glam::DVec3;
use std::path::Path;
use toml::de::DeTable;

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
///
/// # Errors
/// As [`load`].
pub fn parse(path: &Path, text: &str) -> Result<Scene, SceneError> {
    let doc = Document { file: path, text };
    let root = DeTable::parse(text).map_err(|e| {
        let line = e.span().map_or(1, |s| doc.line(s.start));
        doc.error(line, "scene", e.message(), "expected TOML 1.0")
    })?;
    let known = [
        "image",
        "camera",
        "light",
        "material",
        "object",
        "render",
        "animation",
    ];
    let root = Table::new(doc, root.get_ref(), "", 1, &known)?;

    let image = image(&root)?;
    let camera = camera(&root)?;
    let lights = root
        .tables("light", light::KEYS)?
        .iter()
        .map(light::light)
        .collect::<Result<_, _>>()?;
    let materials = materials(&root, path)?;
    let object_tables = root.tables("object", super::object::KEYS)?;
    let objects = object_tables
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
    let animation = super::animation::animation(&root, &camera, &object_tables)?;
    let render = render(&root)?;
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
        render,
        animation,
    })
}

fn render(root: &Table<'_>) -> Result<Render, SceneError> {
    const KEYS: [&str; 6] = ["method", "line", "cue", "antialias", "samples", "filter"];
    let mut render = Render::default();
    let Some(t) = root.table("render", &KEYS)? else {
        return Ok(render);
    };
    if let Some(m) = t
        .word("method", Method::NAMES)?
        .and_then(|m| m.parse().ok())
    {
        render.method = m;
    }
    if let Some(n) = t.integer("samples", 1, SAMPLE_LIMIT)? {
        render.samples = n;
    }
    if let Some(f) = t
        .word("filter", &Filter::NAMES)?
        .and_then(|f| f.parse().ok())
    {
        render.filter = f;
    }
    let line = t.word("line", &LineFilter::ALL.map(LineFilter::name))?;
    if let Some(line) = LineFilter::ALL.into_iter().find(|l| Some(l.name()) == line) {
        render.line = line;
    }
    let accepted = "[nearest, farthest], two factors from 0 to 1";
    if let Some([near, far]) = t.pair_if("cue", accepted, |x| (0.0..=1.0).contains(&x))? {
        render.cue = Cue { near, far };
    }
    let antialias = t.word("antialias", &Antialias::ALL.map(Antialias::name))?;
    if let Some(a) = antialias.and_then(|a| a.parse().ok()) {
        render.antialias = a;
    }
    Ok(render)
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
    check_view(&t, eye, target, up)?;
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

/// Refuses views that look nowhere or along their up; `t` has the keys `target` and `up`.
pub(super) fn check_view(
    t: &Table<'_>,
    eye: DVec3,
    target: DVec3,
    up: DVec3,
) -> Result<(), SceneError> {
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
    Ok(())
}
