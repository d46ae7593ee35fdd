//! Materials of a scene: how surfaces reflect, and how that is read.

use super::light::{is_colour, COLOUR};
use super::read::Table;
use super::{surface, SceneError};
use crate::bump::BumpMap;
use crate::texture::Texture;
use glam::DVec3;
use std::path::Path;
use std::sync::Arc;

/// The reflection models known to this crate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Brdf {
    /// Diffuse only.
    Lambert,
    /// Diffuse and a highlight of the reflected light vector (Phong 1975).
    Phong,
    /// Diffuse and a highlight of the half-way vector (Blinn 1977).
    Blinn,
    /// Diffuse and the mirror facets of Cook and Torrance (1982).
    CookTorrance {
        /// Root-mean-square slope m of the facets, 0.01 to 1.
        roughness: f64,
    },
}

/// The function of the cosine that makes the highlight of [`Brdf::Phong`] and [`Brdf::Blinn`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Highlight {
    /// The power cosⁿ.
    Pow,
    /// κ(cos − γ)^d (Hast 2004, 3.276).
    Kappa {
        /// The degree d, 2 to 6.
        degree: u8,
    },
    /// cos²(a·angle) (Abbas 2003, 6.11).
    Cos2,
    /// The quadratic pieces of Kuijk and Blake (1989).
    Blake,
    /// The quotient of Schlick (1994).
    Schlick,
}

/// How a surface reflects. All colours are fractions of full scale, RGB, at least 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The name objects use.
    pub name: String,
    /// The model.
    pub brdf: Brdf,
    /// Added everywhere, but see `shadow`.
    pub ambient: DVec3,
    /// Light of its own, added everywhere.
    pub emission: DVec3,
    /// How far the ambient part fades where the surface turns away from all lights, 0 (not at all) to 1.
    pub shadow: f64,
    /// Factor of N·L.
    pub diffuse: DVec3,
    /// Factor of the highlight; zero for [`Brdf::Lambert`], the reflectance at normal incidence f₀ (0 to 1) for
    /// [`Brdf::CookTorrance`].
    pub specular: DVec3,
    /// The exponent n, 0 to 10 000; at least the degree for [`Highlight::Kappa`], 1 for others than [`Highlight::Pow`].
    pub shininess: f64,
    /// The function that makes the highlight.
    pub highlight: Highlight,
    /// A picture that multiplies the colour.
    pub texture: Option<Arc<Texture>>,
    /// A height map that bends the normals.
    pub bump: Option<Arc<BumpMap>>,
}

impl Default for Material {
    /// What a material is without any keys.
    fn default() -> Self {
        Self {
            name: String::new(),
            brdf: Brdf::Blinn,
            ambient: DVec3::ZERO,
            emission: DVec3::ZERO,
            shadow: 0.0,
            diffuse: DVec3::splat(0.8),
            specular: DVec3::ZERO,
            shininess: 20.0,
            highlight: Highlight::Pow,
            texture: None,
            bump: None,
        }
    }
}

pub(super) const KEYS: &[&str] = &[
    "name",
    "brdf",
    "ambient",
    "diffuse",
    "specular",
    "shininess",
    "highlight",
    "degree",
    "roughness",
    "f0",
    "emission",
    "shadow",
];

/// Keys that not every model has, and the models that have them.
const OWN: [(&str, &[&str]); 6] = [
    ("specular", &["phong", "blinn"]),
    ("shininess", &["phong", "blinn"]),
    ("highlight", &["phong", "blinn"]),
    ("degree", &["phong", "blinn"]),
    ("roughness", &["cook-torrance"]),
    ("f0", &["cook-torrance"]),
];

pub(super) fn materials(root: &Table<'_>, scene: &Path) -> Result<Vec<Material>, SceneError> {
    let mut all: Vec<Material> = Vec::new();
    for t in root.tables("material", &[KEYS, surface::KEYS].concat())? {
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
        all.push(material(&t, name, scene)?);
    }
    if all.is_empty() {
        return Err(root.missing("material", "at least one table [[material]]"));
    }
    Ok(all)
}

fn material(t: &Table<'_>, name: &str, scene: &Path) -> Result<Material, SceneError> {
    let plain = Material::default();
    let model = t
        .word("brdf", &["lambert", "phong", "blinn", "cook-torrance"])?
        .unwrap_or("blinn");
    for (key, models) in OWN {
        if t.has(key) && !models.contains(&model) {
            let quoted: Vec<String> = models.iter().map(|m| format!("'{m}'")).collect();
            return Err(t.error(
                key,
                &format!("does not belong to the {model} model"),
                &format!("expected it only with brdf = {}", quoted.join(" or ")),
            ));
        }
    }
    let colour = |key: &str, default: DVec3| {
        Ok(t.vector_if(key, COLOUR, true, is_colour)?
            .unwrap_or(default))
    };
    let fraction = |key: &str, accepted: &str, from: f64| {
        t.number_if(key, accepted, |x| (from..=1.0).contains(&x))
    };
    let specular = match model {
        "cook-torrance" => t
            .vector_if("f0", "a number or [r, g, b], each from 0 to 1", true, |x| {
                (0.0..=1.0).contains(&x)
            })?
            .unwrap_or(DVec3::splat(0.04)),
        _ => colour("specular", plain.specular)?,
    };
    let brdf = match model {
        "lambert" => Brdf::Lambert,
        "phong" => Brdf::Phong,
        "blinn" => Brdf::Blinn,
        _ => Brdf::CookTorrance {
            roughness: fraction("roughness", "a number from 0.01 to 1", 0.01)?.unwrap_or(0.3),
        },
    };
    let (highlight, shininess) = highlight(t)?;
    Ok(Material {
        name: name.to_owned(),
        brdf,
        ambient: colour("ambient", plain.ambient)?,
        emission: colour("emission", plain.emission)?,
        shadow: fraction("shadow", "a number from 0 to 1", 0.0)?.unwrap_or(plain.shadow),
        diffuse: colour("diffuse", plain.diffuse)?,
        specular,
        shininess,
        highlight,
        texture: surface::texture(t, scene)?,
        bump: surface::bump(t, scene)?,
    })
}

/// The function of the highlight and its exponent.
fn highlight(t: &Table<'_>) -> Result<(Highlight, f64), SceneError> {
    let words = ["pow", "kappa", "cos2", "blake", "schlick"];
    let word = t.word("highlight", &words)?.unwrap_or("pow");
    if t.has("degree") && word != "kappa" {
        return Err(t.error(
            "degree",
            &format!("does not belong to highlight '{word}'"),
            "expected it only with highlight = 'kappa'",
        ));
    }
    let (least, accepted) = match word {
        "pow" => (0.0, "a number from 0 to 10000"),
        "kappa" => (2.0, "a number from 2 to 10000 with highlight 'kappa'"),
        _ => (
            1.0,
            "a number from 1 to 10000 with highlights other than 'pow'",
        ),
    };
    let shininess = t
        .number_if("shininess", accepted, |x| (least..=1e4).contains(&x))?
        .unwrap_or(Material::default().shininess);
    let degree = match t.integer("degree", 2, 6)? {
        Some(degree) if f64::from(degree) > shininess => {
            return Err(t.error(
                "degree",
                &format!("is {degree}, above shininess = {shininess}"),
                "expected a degree up to the shininess",
            ));
        }
        Some(degree) => degree as u8,
        None => shininess.min(4.0) as u8,
    };
    let highlight = match word {
        "pow" => Highlight::Pow,
        "kappa" => Highlight::Kappa { degree },
        "cos2" => Highlight::Cos2,
        "blake" => Highlight::Blake,
        _ => Highlight::Schlick,
    };
    Ok((highlight, shininess))
}
