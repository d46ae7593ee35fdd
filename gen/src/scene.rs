//! A prepared scene as the triangles of a core: knots of its method, depths in words.

use crate::stimulus::Triangle;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::{depth, shade, Method, Prepared, Scene, ScreenTriangle};

/// Methods that have a core, by catalogue name.
pub const CORES: [(&str, Order, Method); 2] = [
    ("gouraud", Order::Linear, Method::Gouraud),
    ("quadratic", Order::Quadratic, Method::Quadratic),
];

/// What a scene has that no core draws.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{file}: material '{material}' has a {what}, which no core draws; expected materials without texture and bump, \
     or the command render"
)]
pub struct Undrawable {
    /// The scene file.
    pub file: String,
    /// The name of the material.
    pub material: String,
    /// What it has.
    pub what: &'static str,
}

/// Whether cores can draw a scene.
///
/// # Errors
/// The first material of an object that they cannot draw.
pub fn drawable(scene: &Scene) -> Result<(), Undrawable> {
    let used = scene
        .objects
        .iter()
        .filter_map(|o| scene.materials.get(o.material));
    for m in used {
        let what = match (&m.texture, &m.bump) {
            (None, None) => continue,
            (Some(_), _) => "texture",
            (None, Some(_)) => "bump map",
        };
        return Err(Undrawable {
            file: scene.file.display().to_string(),
            material: m.name.clone(),
            what,
        });
    }
    Ok(())
}

/// The core of a method.
#[must_use]
pub fn order_of(method: Method) -> Option<Order> {
    CORES
        .iter()
        .find(|(_, _, m)| *m == method)
        .map(|(_, order, _)| *order)
}

/// The software method that a core draws.
#[must_use]
pub fn method_of(order: Order) -> Method {
    match order {
        Order::Linear => Method::Gouraud,
        Order::Quadratic => Method::Quadratic,
    }
}

fn knots(p: &Prepared, t: &ScreenTriangle, order: Order) -> Vec<[f64; 3]> {
    match order {
        Order::Linear => shade::gouraud::knots(p, t).to_vec(),
        Order::Quadratic => shade::quadratic::knots(p, t).to_vec(),
    }
}

/// All triangles of a prepared scene, in drawing order.
#[must_use]
pub fn triangles(p: &Prepared, order: Order) -> Vec<Triangle> {
    let one = |t: &ScreenTriangle| Triangle {
        position: t.position,
        depth: t.depth.map(depth::scaled),
        knots: knots(p, t, order),
        label: format!("object {}, face {}", t.object, t.face),
    };
    p.triangles.iter().map(one).collect()
}
