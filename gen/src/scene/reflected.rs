//! Scenes for cores that shade per pixel: which of them they draw, and the cosines at the knots of a triangle.

use crate::stimulus::greatest_exponent;
use crate::stimulus::Material;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::scene::{Attenuation, Brdf, Highlight, LightKind, Projection};
use shadegate_reference::shade::corners::Corners;
use shadegate_reference::shade::duff::Duff;
use shadegate_reference::shade::form::Form;
use shadegate_reference::shade::lit::Cosines;
use shadegate_reference::shade::paint::Dots;
use shadegate_reference::shade::taylor::Taylor;
use shadegate_reference::shade::x_shading::XShading;
use shadegate_reference::{Method, Prepared, Scene};

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
        | Order::Span(_) => return Ok(()),
        Order::QuadraticDots => "quadratic-dots",
        Order::Duff => "duff",
    };
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
    if order == Order::Duff && !far {
        return refuse(
            "the camera is near".to_owned(),
            "an orthographic camera (height)",
        );
    }
    for light in &scene.lights {
        let (what, expected) = match light.kind {
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
        let shines = m.brdf != Brdf::Lambert && m.specular.max_element() > 0.0;
        if !matches!(m.brdf, Brdf::Lambert | Brdf::Blinn) {
            let what = format!("material '{name}' has another brdf");
            return refuse(what, "brdf = 'lambert' or 'blinn'");
        }
        if m.highlight != Highlight::Pow {
            let what = format!("material '{name}' has another highlight");
            return refuse(what, "highlight = 'pow'");
        }
        if m.shadow != 0.0 {
            let what = format!("material '{name}' has a shadow");
            return refuse(what, "shadow = 0");
        }
        if shines && !(1.0..=greatest).contains(&m.shininess) {
            let what = format!("material '{name}' has a shininess of {}", m.shininess);
            let expected = match order {
                Order::Duff => "1 to 600",
                _ => "1 to 2048",
            };
            return refuse(what, expected);
        }
    }
    Ok(())
}

/// Six knots of a triangle, [N·L, N·H, 0] each ([N·L, N·H, |N|²] for [`Method::Duff`]), and its material; no knots where [`suited`] should have refused.
pub fn knots(p: &Prepared, index: usize, method: Method) -> (Vec<[f64; 3]>, Material) {
    let c = Corners::new(p, index);
    let term = c.terms.first();
    let material = Material {
        ambient: c.ambient.to_array(),
        diffuse: term.map_or([0.0; 3], |t| t.diffuse[0].to_array()),
        specular: term.map_or([0.0; 3], |t| t.specular[0].to_array()),
        shininess: c.shininess,
    };
    if method == Method::Duff {
        let square = six(&Duff.shared(&c));
        let dots = term.map_or([[0.0; 6]; 2], |t| Duff.own(&c, t).0.map(|f| six(&f)));
        let knots = (0..6).map(|i| [dots[0][i], dots[1][i], square[i]]);
        return (knots.collect(), material);
    }
    let form = |of: [Form; 2]| of.map(|f| six(&f));
    let cosines = match (term, method) {
        (None, _) => Some([[0.0; 6]; 2]),
        (Some(t), Method::Taylor) => Some(form(Taylor::Centroid.own(&c, t))),
        (Some(t), Method::TaylorVertex) => Some(form(Taylor::Vertex.own(&c, t))),
        (Some(t), Method::XShading) => Some(form(XShading::Newton.own(&c, t))),
        (Some(t), Method::XShadingCached) => Some(form(XShading::Cached.own(&c, t))),
        (Some(_), _) => Dots::new(p, index)
            .and_then(|d| d.terms.first().copied())
            .map(|t| [t.light, t.half]),
    };
    let knots = cosines.map_or(vec![], |[light, half]| {
        (0..6).map(|i| [light[i], half[i], 0.0]).collect()
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
