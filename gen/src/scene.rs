//! A prepared scene as the triangles of a core: knots of its method, depths in words.

use crate::spans;
use crate::stimulus::Triangle;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::shade::span_core::SpanKind;
use shadegate_reference::{depth, shade, Method, Prepared, Scene, ScreenTriangle};

/// Methods that have a core, by catalogue name.
pub const CORES: [(&str, Order, Method); 10] = [
    ("gouraud", Order::Linear, Method::Gouraud),
    ("quadratic", Order::Quadratic, Method::Quadratic),
    ("slerp", Order::Span(SpanKind::Slerp), Method::Slerp),
    (
        "slerp-chebyshev",
        Order::Span(SpanKind::Chebyshev),
        Method::SlerpChebyshev,
    ),
    (
        "spherical-cos2-rom4",
        Order::Span(SpanKind::Spherical(4)),
        Method::SphericalCos2Rom4,
    ),
    (
        "spherical-cos2-rom6",
        Order::Span(SpanKind::Spherical(6)),
        Method::SphericalCos2Rom6,
    ),
    (
        "spherical-cos2-rom8",
        Order::Span(SpanKind::Spherical(8)),
        Method::SphericalCos2Rom8,
    ),
    (
        "spherical-cosn",
        Order::Span(SpanKind::SphericalPower(8)),
        Method::SphericalCosN,
    ),
    ("blake", Order::Span(SpanKind::Blake), Method::Blake),
    (
        "blake-refit",
        Order::Span(SpanKind::BlakeRefit),
        Method::BlakeRefit,
    ),
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
        Order::Span(SpanKind::Slerp) => Method::Slerp,
        Order::Span(SpanKind::Chebyshev) => Method::SlerpChebyshev,
        Order::Span(SpanKind::Spherical(4)) => Method::SphericalCos2Rom4,
        Order::Span(SpanKind::Spherical(6)) => Method::SphericalCos2Rom6,
        Order::Span(SpanKind::Spherical(8)) => Method::SphericalCos2Rom8,
        Order::Span(SpanKind::Spherical(_)) => Method::SphericalCos2,
        Order::Span(SpanKind::SphericalPower(_)) => Method::SphericalCosN,
        Order::Span(SpanKind::Blake) => Method::Blake,
        Order::Span(SpanKind::BlakeRefit) => Method::BlakeRefit,
    }
}

fn knots(p: &Prepared, t: &ScreenTriangle, order: Order) -> Vec<[f64; 3]> {
    match order {
        Order::Linear => shade::gouraud::knots(p, t).to_vec(),
        Order::Quadratic => shade::quadratic::knots(p, t).to_vec(),
        // Their knots are the rows of a surface, made per triangle of the scene: see `triangles`.
        Order::Span(_) => vec![],
    }
}

/// All triangles of a prepared scene, in drawing order.
#[must_use]
pub fn triangles(p: &Prepared, order: Order) -> Vec<Triangle> {
    if let Order::Span(_) = order {
        return spans::triangles(p);
    }
    let one = |t: &ScreenTriangle| Triangle {
        position: t.position,
        depth: t.depth.map(depth::scaled),
        knots: knots(p, t, order),
        label: format!("object {}, face {}", t.object, t.face),
    };
    p.triangles.iter().map(one).collect()
}
