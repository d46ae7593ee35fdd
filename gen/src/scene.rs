//! A prepared scene as the triangles of a core: knots of its method, depths in words.

use crate::stimulus::{Line, Triangle};
use shadegate_hdl::line::Filter;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::line::{wireframe, LineFilter};
use shadegate_reference::{depth, shade, Method, Prepared, Scene, ScreenTriangle};

/// Methods that have a core, by catalogue name.
pub const CORES: [(&str, Order, Method); 2] = [
    ("gouraud", Order::Linear, Method::Gouraud),
    ("quadratic", Order::Quadratic, Method::Quadratic),
];

/// Filters of lines, each with its core, by catalogue name.
pub const LINES: [(&str, Order, LineFilter); 3] = [
    (
        "bresenham",
        Order::Line(Filter::Bresenham),
        LineFilter::Bresenham,
    ),
    ("box", Order::Line(Filter::Box), LineFilter::Box),
    ("cone", Order::Line(Filter::Cone), LineFilter::Cone),
];

/// The core that draws lines with a filter.
#[must_use]
pub fn line_order(filter: LineFilter) -> Order {
    Order::Line(match filter {
        LineFilter::Bresenham => Filter::Bresenham,
        LineFilter::Box => Filter::Box,
        LineFilter::Cone => Filter::Cone,
    })
}

/// The lines of a prepared scene, far ones first, hidden parts left out.
#[must_use]
pub fn lines(p: &Prepared) -> Vec<Line> {
    let strokes = wireframe::strokes(&p.wires, p.width, p.height);
    let one = |stroke: wireframe::Stroke| Line {
        label: format!(
            "object {}, edge {}",
            p.wires.edges[stroke.edge].object, stroke.edge
        ),
        stroke,
    };
    strokes.into_iter().map(one).collect()
}

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
        // Wires are the same whatever shades the faces.
        Order::Line(_) => Method::Exact,
    }
}

fn knots(p: &Prepared, t: &ScreenTriangle, order: Order) -> Vec<[f64; 3]> {
    match order {
        Order::Linear => shade::gouraud::knots(p, t).to_vec(),
        Order::Quadratic => shade::quadratic::knots(p, t).to_vec(),
        Order::Line(_) => vec![],
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
