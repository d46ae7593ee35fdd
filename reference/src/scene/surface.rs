//! What lies on a material: a texture and a bump map, from PNG files beside the scene or computed.

use super::read::Table;
use super::SceneError;
use crate::bump::{BumpMap, Gradient, Normalise, Relief};
use crate::method::nearest;
use crate::texture::{pattern, Filter, Layout, Mapping, Texels, Texture, Wrap};
use glam::DVec2;
use std::path::Path;
use std::sync::Arc;

/// Keys of a material.
pub(super) const KEYS: &[&str] = &[
    "texture",
    "mapping",
    "filter",
    "bump",
    "bump_scale",
    "bump_gradient",
    "bump_normalise",
    "wrap",
    "repeat",
];

const MAPPINGS: [(&str, Mapping); 3] = [
    ("perspective", Mapping::Perspective),
    ("affine", Mapping::Affine),
    ("quadratic", Mapping::Quadratic),
];

const FILTERS: [(&str, Filter); 5] = [
    ("nearest", Filter::Nearest),
    ("bilinear", Filter::Bilinear),
    ("mip-map", Filter::MipMap),
    ("ripmap", Filter::Ripmap),
    ("summed-area", Filter::SummedArea),
];

const WRAPS: [(&str, Wrap); 2] = [("repeat", Wrap::Repeat), ("clamp", Wrap::Clamp)];

const GRADIENTS: [(&str, Gradient); 4] = [
    ("nearest", Gradient::Nearest),
    ("linear", Gradient::Linear),
    ("catmull-rom", Gradient::CatmullRom),
    ("b-spline", Gradient::BSpline),
];

const NORMALISATIONS: [(&str, Normalise); 3] = [
    ("exact", Normalise::Exact),
    ("reflection", Normalise::Reflection),
    ("newton", Normalise::Newton),
];

/// The value of a word, or the default.
fn choice<T: Copy + Default, const N: usize>(
    t: &Table<'_>,
    key: &str,
    all: &[(&'static str, T); N],
) -> Result<T, SceneError> {
    let word = t.word(key, &all.map(|(name, _)| name))?;
    let found = all.iter().find(|(name, _)| Some(*name) == word);
    Ok(found.map_or_else(T::default, |(_, value)| *value))
}

/// The picture that `key` names: computed, or a PNG file beside the scene.
fn picture(
    t: &Table<'_>,
    key: &str,
    scene: &Path,
    patterns: &[&str],
    pattern: fn(&str) -> Option<Texels>,
) -> Result<Option<Texels>, SceneError> {
    let known = patterns.join(", ");
    let accepted = format!("{known} or the name of a PNG file");
    let Some(name) = t.string(key, &accepted)? else {
        return Ok(None);
    };
    if let Some(texels) = pattern(name) {
        return Ok(Some(texels));
    }
    if !name.to_lowercase().ends_with(".png") {
        let near = nearest(name, patterns).unwrap_or_default();
        return Err(t.error(
            key,
            &format!("unknown '{name}'"),
            &format!(
                "the nearest is '{near}' of {known}; expected one of them or a file ending in .png"
            ),
        ));
    }
    let path = scene.parent().unwrap_or(Path::new("")).join(name);
    match Texels::load_png(&path) {
        Ok(texels) => Ok(Some(texels)),
        Err(e) => Err(t.error(key, &format!("{name}: {}", e.what), &e.accepted)),
    }
}

/// Refuses a key that would do nothing without one of `needed`.
fn needs(t: &Table<'_>, keys: &[&str], needed: &[&str]) -> Result<(), SceneError> {
    if needed.iter().any(|n| t.has(n)) {
        return Ok(());
    }
    match keys.iter().find(|k| t.has(k)) {
        None => Ok(()),
        Some(key) => Err(t.error(
            key,
            "given without a picture",
            &format!("expected it only together with {}", needed.join(" or ")),
        )),
    }
}

fn wrap_and_repeat(t: &Table<'_>) -> Result<(Wrap, DVec2), SceneError> {
    needs(t, &["wrap", "repeat"], &["texture", "bump"])?;
    let accepted = "a number or [u, v], each of size 0.001 to 1000";
    let repeat = t.numbers_if("repeat", accepted, true, |x| {
        (0.001..=1000.0).contains(&x.abs())
    })?;
    Ok((
        choice(t, "wrap", &WRAPS)?,
        repeat.map_or(DVec2::ONE, DVec2::from_array),
    ))
}

/// The texture of a material, if it has one.
pub(super) fn texture(t: &Table<'_>, scene: &Path) -> Result<Option<Arc<Texture>>, SceneError> {
    needs(t, &["mapping", "filter"], &["texture"])?;
    let (wrap, repeat) = wrap_and_repeat(t)?;
    let layout = Layout {
        mapping: choice(t, "mapping", &MAPPINGS)?,
        filter: choice(t, "filter", &FILTERS)?,
        wrap,
        repeat,
    };
    let picture = picture(t, "texture", scene, pattern::NAMES, pattern::colour)?;
    Ok(picture.map(|p| Arc::new(Texture::new(p, layout))))
}

/// The bump map of a material, if it has one.
pub(super) fn bump(t: &Table<'_>, scene: &Path) -> Result<Option<Arc<BumpMap>>, SceneError> {
    needs(
        t,
        &["bump_scale", "bump_gradient", "bump_normalise"],
        &["bump"],
    )?;
    let (wrap, repeat) = wrap_and_repeat(t)?;
    let scale = t.number_if("bump_scale", "a number from -1000 to 1000", |x| {
        x.abs() <= 1000.0
    })?;
    let relief = Relief {
        scale: scale.unwrap_or(0.05),
        gradient: choice(t, "bump_gradient", &GRADIENTS)?,
        normalise: choice(t, "bump_normalise", &NORMALISATIONS)?,
        wrap,
        repeat,
    };
    let picture = picture(t, "bump", scene, pattern::HEIGHT_NAMES, pattern::height)?;
    Ok(picture.map(|p| Arc::new(BumpMap::new(&p, relief))))
}
