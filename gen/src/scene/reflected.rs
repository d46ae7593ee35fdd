//! Scenes for cores that shade per pixel: which of them they draw, and the cosines at the knots of a triangle.

use super::{bumped, order_of};
use crate::stimulus::{greatest_exponent, Cone, Lobe, Material};
use glam::DVec3;
use shadegate_hdl::light::{Glint, DEGREES, MAX_SCALE};
use shadegate_hdl::shade::model::Order;
use shadegate_reference::scene::{
    self, Attenuation, Brdf, Falloff, Highlight, Light, LightKind, Projection, SpotWidth,
};
use shadegate_reference::shade::corners::Corners;
use shadegate_reference::shade::duff::Duff;
use shadegate_reference::shade::form::Form;
use shadegate_reference::shade::highlight::kappa::Kappa;
use shadegate_reference::shade::highlight::Curve;
use shadegate_reference::shade::lit::Cosines;
use shadegate_reference::shade::paint::Dots;
use shadegate_reference::shade::quadratic::EDGES;
use shadegate_reference::shade::spot;
use shadegate_reference::shade::taylor::Taylor;
use shadegate_reference::shade::x_shading::XShading;
use shadegate_reference::{Method, Prepared, Scene, ScreenTriangle};

/// What a scene has that a core with one light and a power table cannot draw.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{file}: {what}, which the {core} core does not draw; expected {expected}, or the command render")]
pub struct Unsuited {
    /// The scene file.
    pub file: String,
    /// What it has.
    pub what: String,
    /// The core.
    pub core: &'static str,
    /// What it should have.
    pub expected: &'static str,
}

/// Whether a core can draw the lights and materials of a scene.
///
/// # Errors
/// The first thing that it cannot draw.
pub fn suited(scene: &Scene, order: Order) -> Result<(), Unsuited> {
    let core = match order {
        Order::Linear
        | Order::Quadratic
        | Order::QuadraticEngine
        | Order::Line(_)
        | Order::Span(_)
        | Order::Textured(_) => return Ok(()),
        Order::QuadraticDots => "quadratic-dots",
        Order::Duff => "duff",
        Order::Glint(glint) => glint.name(),
        Order::Bump(bend) => {
            bumped::suited(scene, bend)?;
            bend.name()
        }
    };
    let spot = order == Order::Glint(Glint::Spot);
    let greatest = greatest_exponent(order);
    let refuse = |what: String, expected: &'static str| {
        Err(Unsuited {
            file: scene.file.display().to_string(),
            what,
            core,
            expected,
        })
    };
    if scene.lights.len() > 1 {
        return refuse(
            format!("the scene has {} lights", scene.lights.len()),
            "one light",
        );
    }
    let far = matches!(scene.camera.projection, Projection::Orthographic { .. });
    if matches!(order, Order::Duff | Order::Bump(_)) && !far {
        return refuse(
            "the camera is near".to_owned(),
            "an orthographic camera (height)",
        );
    }
    for light in &scene.lights {
        let (what, expected) = match light.kind {
            LightKind::Spot {
                falloff,
                width,
                attenuation,
                ..
            } if spot => match (falloff, attenuation == Attenuation::NONE) {
                (Falloff::Warn, _) => (
                    "the spot has the fall-off of Warn",
                    "falloff = 'soft' or 'hard'",
                ),
                (_, false) => ("the light has an attenuation", "a light without it"),
                _ if 1.0 / edge(falloff, width) > MAX_SCALE => (
                    "the spot is too narrow",
                    "a cone whose edge has a cosine of at most 127/128",
                ),
                _ => continue,
            },
            _ if spot => ("the light is none", "a spot"),
            LightKind::Directional { .. } => continue,
            LightKind::Point { .. } if order == Order::Duff => {
                ("the light is near", "a directional light")
            }
            LightKind::Point { attenuation, .. } if attenuation == Attenuation::NONE => continue,
            LightKind::Point { .. } => ("the light has an attenuation", "a light without it"),
            LightKind::Spot { .. } => ("the light is a spot", "a directional or a point light"),
        };
        return refuse(what.to_owned(), expected);
    }
    let used = scene.objects.iter();
    for m in used.filter_map(|o| scene.materials.get(o.material)) {
        let name = &m.name;
        let shines = shines(m);
        if !matches!(m.brdf, Brdf::Lambert | Brdf::Blinn) {
            let what = format!("material '{name}' has another brdf");
            return refuse(what, "brdf = 'lambert' or 'blinn'");
        }
        if let (Order::Glint(_), true) = (order, shines) {
            if let Err((what, expected)) = shifted(m) {
                return refuse(format!("material '{name}' has {what}"), expected);
            }
        }
        let by_table = !matches!(order, Order::Glint(_));
        if by_table && m.highlight != Highlight::Pow {
            let what = format!("material '{name}' has another highlight");
            return refuse(what, "highlight = 'pow'");
        }
        if m.shadow != 0.0 {
            let what = format!("material '{name}' has a shadow");
            return refuse(what, "shadow = 0");
        }
        if shines && by_table && !(1.0..=greatest).contains(&m.shininess) {
            let what = format!("material '{name}' has a shininess of {}", m.shininess);
            let expected = match order {
                Order::Duff => "1 to 600",
                Order::Bump(_) => "1 to 144",
                _ => "1 to 2048",
            };
            return refuse(what, expected);
        }
    }
    Ok(())
}

/// The core of a method for a scene: what its lights and materials ask for.
#[must_use]
pub(super) fn order_for(scene: &Scene, method: Method) -> Option<Order> {
    let order = order_of(method)?;
    if order != Order::QuadraticDots {
        return Some(order);
    }
    let is_spot = |l: &Light| matches!(l.kind, LightKind::Spot { .. });
    let mut used = scene
        .objects
        .iter()
        .filter_map(|o| scene.materials.get(o.material));
    Some(if scene.lights.iter().any(is_spot) {
        Order::Glint(Glint::Spot)
    } else if used.any(|m| shines(m) && matches!(m.highlight, Highlight::Kappa { .. })) {
        Order::Glint(Glint::Kappa)
    } else {
        order
    })
}

/// Whether a material has a highlight.
pub(super) fn shines(m: &scene::Material) -> bool {
    m.brdf != Brdf::Lambert && m.specular.max_element() > 0.0
}

/// 1 less the cosine of the edge of a spot.
fn edge(falloff: Falloff, width: SpotWidth) -> f64 {
    1.0 - spot::Cone::new(falloff, width).cutoff()
}

/// Whether the highlight unit has the highlight of a material.
fn shifted(m: &scene::Material) -> Result<(), (&'static str, &'static str)> {
    match m.highlight {
        Highlight::Kappa { degree } if !DEGREES.contains(&degree) => {
            Err(("a highlight of another degree", "degree = 2, 3 or 4"))
        }
        Highlight::Kappa { degree } => {
            let gamma = Kappa::fitted(m.shininess, degree).gamma;
            if 1.0 / (1.0 - gamma) > MAX_SCALE {
                let expected =
                    "a shininess of at most about 340, 470 and 590 for degree 2, 3 and 4";
                return Err(("too narrow a highlight", expected));
            }
            Ok(())
        }
        _ => Err(("another highlight", "highlight = 'kappa'")),
    }
}

/// N·L, N·H and the cosine from the axis of a spot at six knots, under the only light; for whatever material.
fn six_knots(p: &Prepared, t: &ScreenTriangle, c: &Corners) -> [[f64; 6]; 3] {
    let s = p.surroundings();
    let mut normal = [DVec3::ZERO; 6];
    let mut place = [DVec3::ZERO; 6];
    for i in 0..3 {
        (normal[i], place[i]) = (c.normal[i], t.world[i]);
    }
    for (k, (i, j)) in EDGES.into_iter().enumerate() {
        let sum = t.inv_w[i] + t.inv_w[j];
        let (qi, qj) = (t.inv_w[i] / sum, t.inv_w[j] / sum);
        let blend = t.normal[i] * qi + t.normal[j] * qj;
        normal[3 + k] = blend.try_normalize().unwrap_or_else(|| t.face_normal());
        place[3 + k] = t.world[i] * qi + t.world[j] * qj;
    }
    let light = place.map(|x| s.incident(0, x).direction);
    let half: [DVec3; 6] =
        std::array::from_fn(|i| (light[i] + s.view(place[i])).normalize_or_zero());
    let axis = match s.light(0).0.kind {
        LightKind::Spot { direction, .. } => -direction,
        _ => DVec3::ZERO,
    };
    [
        std::array::from_fn(|i| normal[i].dot(light[i])),
        std::array::from_fn(|i| normal[i].dot(half[i])),
        light.map(|l| axis.dot(l)),
    ]
}

/// Six knots of a triangle, [N·L, N·H, e] each, e being the cosine from the axis of a spot, else 0 ([N·L, N·H, |N|²] for [`Method::Duff`]), and its material; no knots where [`suited`] should have refused.
pub fn knots(p: &Prepared, index: usize, method: Method) -> (Vec<[f64; 3]>, Material) {
    let c = Corners::new(p, index);
    let term = c.terms.first();
    let s = p.surroundings();
    let lit = (s.lights() > 0).then(|| s.light(0).0);
    let cone = lit.and_then(|l| match l.kind {
        LightKind::Spot { falloff, width, .. } => Some(Cone {
            hard: falloff == Falloff::Hard,
            width: edge(falloff, width),
        }),
        _ => None,
    });
    let mut material = Material {
        ambient: c.ambient.to_array(),
        diffuse: term.map_or([0.0; 3], |t| t.diffuse[0].to_array()),
        specular: term.map_or([0.0; 3], |t| t.specular[0].to_array()),
        shininess: c.shininess,
        lobe: match c.curve {
            Curve::Kappa(Kappa { gamma, degree }) => Lobe::Kappa { degree, gamma },
            _ => Lobe::Power,
        },
        cone,
    };
    if let (Some(light), Some(_)) = (lit, cone) {
        // The core has the fall-off; the same material where the spot does not reach.
        let m = s.material(p.triangles[index].material);
        material.diffuse = (light.colour * m.diffuse * 255.0).to_array();
        material.specular = (light.colour * m.specular * 255.0).to_array();
    }
    if method == Method::Duff {
        let square = six(&Duff.shared(&c));
        let dots = term.map_or([[0.0; 6]; 2], |t| Duff.own(&c, t).0.map(|f| six(&f)));
        let knots = (0..6).map(|i| [dots[0][i], dots[1][i], square[i]]);
        return (knots.collect(), material);
    }
    let at = match lit {
        Some(_) => six_knots(p, &p.triangles[index], &c),
        None => [[0.0; 6]; 3],
    };
    let form = |of: [Form; 2]| of.map(|f| six(&f));
    let cosines = match (term, method) {
        // A spot that does not reach the triangle: the cosine from its axis says so.
        (None, _) if cone.is_some() => Some([at[0], at[1]]),
        (None, _) => Some([[0.0; 6]; 2]),
        (Some(t), Method::Taylor) => Some(form(Taylor::Centroid.own(&c, t))),
        (Some(t), Method::TaylorVertex) => Some(form(Taylor::Vertex.own(&c, t))),
        (Some(t), Method::XShading) => Some(form(XShading::Newton.own(&c, t))),
        (Some(t), Method::XShadingCached) => Some(form(XShading::Cached.own(&c, t))),
        (Some(_), _) => Dots::new(p, &p.triangles[index], Dots::normals(&p.triangles[index]))
            .and_then(|d| d.terms.first().copied())
            .map(|t| [t.light, t.half])
            .or(Some([at[0], at[1]])),
    };
    let knots = cosines.map_or(vec![], |[light, half]| {
        (0..6).map(|i| [light[i], half[i], at[2][i]]).collect()
    });
    (knots, material)
}

/// The values of a quadratic form at the knots.
fn six(form: &Form) -> [f64; 6] {
    let h = 0.5;
    [
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [h, h, 0.0],
        [h, 0.0, h],
        [0.0, h, h],
    ]
    .map(|w| form.at(w))
}
