//! Lights of a scene: what there is to say about them, and how they are read.

use super::read::Table;
use super::SceneError;
use glam::DVec3;

/// A light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Where the light comes from.
    pub kind: LightKind,
    /// RGB times intensity, each at least 0.
    pub colour: DVec3,
}

/// Where a light comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// From infinitely far.
    Directional {
        /// Unit vector in the direction the light travels.
        direction: DVec3,
    },
    /// From a point, the same in all directions.
    Point {
        /// World position.
        position: DVec3,
        /// How it falls off with distance.
        attenuation: Attenuation,
    },
    /// From a point, strongest along an axis.
    Spot {
        /// World position.
        position: DVec3,
        /// Unit vector in the direction the light travels in the middle.
        direction: DVec3,
        /// How it falls off beside the axis.
        falloff: Falloff,
        /// How wide it is.
        width: SpotWidth,
        /// How it falls off with distance.
        attenuation: Attenuation,
    },
}

/// Fall-off with the distance d: 1/(constant + linear·d + quadratic·d²), at most 1. All at least 0, not all 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attenuation {
    /// The constant term.
    pub constant: f64,
    /// Factor of d, per world unit.
    pub linear: f64,
    /// Factor of d², per square world unit.
    pub quadratic: f64,
}

impl Attenuation {
    /// Light that does not fall off.
    pub const NONE: Self = Self {
        constant: 1.0,
        linear: 0.0,
        quadratic: 0.0,
    };
}

/// How the light of a spot falls off beside its axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Falloff {
    /// A power of the cosine (Warn 1983).
    Warn,
    /// Quadratic, with a smooth edge.
    Soft,
    /// Quadratic, with a steep edge.
    Hard,
}

/// The width of a spot, said in one of the two ways of the stage. Full angles in degrees, 0.1 to 179.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpotWidth {
    /// The angle within which there is at least half the light of the axis.
    Beam(f64),
    /// The angle within which there is at least a tenth of it.
    Field(f64),
}

pub(super) const KEYS: &[&str] = &[
    "kind",
    "direction",
    "position",
    "colour",
    "intensity",
    "falloff",
    "beam",
    "field",
    "attenuation",
];

/// Keys that not every kind has, and the kinds that have them.
const OWN: [(&str, &[&str]); 6] = [
    ("direction", &["directional", "spot"]),
    ("position", &["point", "spot"]),
    ("falloff", &["spot"]),
    ("beam", &["spot"]),
    ("field", &["spot"]),
    ("attenuation", &["point", "spot"]),
];

/// Colours of lights and materials.
pub(super) const COLOUR: &str = "a number or [r, g, b], each from 0 to 100";

/// Whether one channel of a colour is acceptable.
pub(super) fn is_colour(x: f64) -> bool {
    (0.0..=100.0).contains(&x)
}

pub(super) fn light(t: &Table<'_>) -> Result<Light, SceneError> {
    let kind = t
        .word("kind", &["directional", "point", "spot"])?
        .ok_or_else(|| t.missing("kind", "'directional', 'point' or 'spot'"))?;
    for (key, kinds) in OWN {
        if t.has(key) && !kinds.contains(&kind) {
            let quoted: Vec<String> = kinds.iter().map(|k| format!("'{k}'")).collect();
            return Err(t.error(
                key,
                &format!("does not belong to a {kind} light"),
                &format!("expected it only with kind = {}", quoted.join(" or ")),
            ));
        }
    }
    let kind = match kind {
        "directional" => LightKind::Directional {
            direction: direction(t)?,
        },
        "point" => LightKind::Point {
            position: position(t)?,
            attenuation: attenuation(t)?,
        },
        _ => LightKind::Spot {
            position: position(t)?,
            direction: direction(t)?,
            falloff: match t.word("falloff", &["warn", "soft", "hard"])? {
                Some("warn") => Falloff::Warn,
                Some("hard") => Falloff::Hard,
                _ => Falloff::Soft,
            },
            width: width(t)?,
            attenuation: attenuation(t)?,
        },
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

fn position(t: &Table<'_>) -> Result<DVec3, SceneError> {
    t.vector("position")?
        .ok_or_else(|| t.missing("position", "three numbers [x, y, z]"))
}

fn direction(t: &Table<'_>) -> Result<DVec3, SceneError> {
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
    Ok(d.normalize())
}

fn attenuation(t: &Table<'_>) -> Result<Attenuation, SceneError> {
    let accepted = "[constant, linear, quadratic], each at least 0, not all 0";
    let Some(a) = t.vector_if("attenuation", accepted, false, |x| x >= 0.0)? else {
        return Ok(Attenuation::NONE);
    };
    if a == DVec3::ZERO {
        return Err(t.error("attenuation", "is all 0", &format!("expected {accepted}")));
    }
    Ok(Attenuation {
        constant: a.x,
        linear: a.y,
        quadratic: a.z,
    })
}

fn width(t: &Table<'_>) -> Result<SpotWidth, SceneError> {
    let angle = |key| {
        t.number_if(key, "degrees from 0.1 to 179", |x| {
            (0.1..=179.0).contains(&x)
        })
    };
    match (angle("beam")?, angle("field")?) {
        (Some(beam), None) => Ok(SpotWidth::Beam(beam)),
        (None, Some(field)) => Ok(SpotWidth::Field(field)),
        (None, None) => Err(t.missing("field", "one of beam and field, degrees from 0.1 to 179")),
        (Some(_), Some(_)) => Err(t.error(
            "field",
            "given together with beam",
            "expected one of beam and field; the other follows from the fall-off",
        )),
    }
}
