//! A prepared scene as the triangles of a core: knots of its method, depths in words.

mod bumped;
mod depths;
mod reflected;
mod set_up;
mod textured;

pub use bumped::{fitting, has_bumps};
pub use depths::{DepthFormat, UnknownDepthFormat};
pub use reflected::{suited, Unsuited};
pub use set_up::{SetUp, ENGINES};
pub use textured::{is_textured, texturing};

use crate::spans;
use crate::stimulus::{Line, Material, Triangle};
use shadegate_hdl::bump::Bend;
use shadegate_hdl::light::Glint;
use shadegate_hdl::line::Filter;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::shade::span_core::SpanKind;
use shadegate_hdl::texture::{Mapping, Texturing, USUAL_TEXELS_LOG2};
use shadegate_reference::line::{wireframe, LineFilter};
use shadegate_reference::{depth, shade, Method, Prepared, Scene, ScreenTriangle};

/// Methods that have a core, by catalogue name.
pub const CORES: [(&str, Order, Method); 13] = [
    ("gouraud", Order::Linear, Method::Gouraud),
    ("quadratic", Order::Quadratic, Method::Quadratic),
    (
        "quadratic-dots",
        Order::QuadraticDots,
        Method::QuadraticDots,
    ),
    ("duff", Order::Duff, Method::Duff),
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
    (
        "blake-trapezium",
        Order::Span(SpanKind::BlakeTrapezium),
        Method::BlakeTrapezium,
    ),
];

/// Methods that a core draws by their set-up alone, beside its own.
pub const SET_UPS: [(Method, Order); 4] = [
    (Method::Taylor, Order::QuadraticDots),
    (Method::TaylorVertex, Order::QuadraticDots),
    (Method::XShading, Order::QuadraticDots),
    (Method::XShadingCached, Order::QuadraticDots),
];

/// The textured cores, by catalogue name, with a texture memory of the usual size. They draw what the methods `gouraud`
/// and `quadratic` draw, times a texture.
pub const TEXTURED: [(&str, Order); 3] = [
    ("textured-affine", usual(Mapping::Affine)),
    ("textured-quadratic", usual(Mapping::Quadratic)),
    ("textured-perspective", usual(Mapping::Perspective)),
];

const fn usual(mapping: Mapping) -> Order {
    Order::Textured(Texturing {
        mapping,
        texels_log2: USUAL_TEXELS_LOG2,
    })
}

/// Cores that a method takes where the lights and materials of a scene ask for them.
pub const BY_SCENE: [(&str, Order, Method); 4] = [
    (
        "quadratic-dots-kappa",
        Order::Glint(Glint::Kappa),
        Method::QuadraticDots,
    ),
    (
        "quadratic-dots-spot",
        Order::Glint(Glint::Spot),
        Method::QuadraticDots,
    ),
    ("bump-newton", Order::Bump(Bend::Newton), Method::Phong),
    (
        "bump-reflection",
        Order::Bump(Bend::Reflection),
        Method::Phong,
    ),
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

/// Every core, by catalogue name.
#[must_use]
pub fn catalogue() -> Vec<(&'static str, Order)> {
    let faces = CORES.iter().chain(&BY_SCENE).map(|c| (c.0, c.1));
    let lines = LINES.iter().map(|l| (l.0, l.1));
    let engines = ENGINES.iter().map(|e| (e.0, e.1));
    faces.chain(TEXTURED).chain(lines).chain(engines).collect()
}

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
    "{file}: material '{material}' has a {what}, which no core of this method draws; expected method phong, materials \
     without bump, or the command render"
)]
pub struct Undrawable {
    /// The scene file.
    pub file: String,
    /// The name of the material.
    pub material: String,
    /// What it has.
    pub what: &'static str,
}

/// Whether a core can draw the bumps of a scene. What cores draw of textures is in [`texturing`], of bumps in [`suited`].
///
/// # Errors
/// The first material of an object that they cannot draw.
pub fn drawable(scene: &Scene, order: Order) -> Result<(), Undrawable> {
    if let Order::Bump(_) = order {
        return Ok(());
    }
    let used = scene
        .objects
        .iter()
        .filter_map(|o| scene.materials.get(o.material));
    for m in used {
        let what = match &m.bump {
            None => continue,
            Some(_) => "bump map",
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
    let own = CORES.iter().map(|(_, order, m)| (*m, *order));
    own.chain(SET_UPS)
        .find(|(m, _)| *m == method)
        .map(|(_, order)| order)
}

/// The core of a method for a scene: what its bumps, its textures, or else its lights and materials, ask for. None where the method has
/// no core.
///
/// # Errors
/// Textures that no core draws.
pub fn order_for(scene: &Scene, method: Method) -> Result<Option<Order>, Unsuited> {
    if let Some(order) = bumped::order_for(scene, method) {
        return Ok(Some(order));
    }
    let lit = reflected::order_for(scene, method);
    lit.map(|order| textured::order_for(scene, order))
        .transpose()
}

/// The software method that has the name of a core.
#[must_use]
pub fn method_of(order: Order) -> Method {
    match order {
        Order::Linear => Method::Gouraud,
        Order::Quadratic | Order::QuadraticEngine => Method::Quadratic,
        Order::QuadraticDots | Order::Glint(_) => Method::QuadraticDots,
        // Wires are the same whatever shades the faces.
        Order::Line(_) => Method::Exact,
        Order::Span(SpanKind::Slerp) => Method::Slerp,
        Order::Span(SpanKind::Chebyshev) => Method::SlerpChebyshev,
        Order::Span(SpanKind::Spherical(4)) => Method::SphericalCos2Rom4,
        Order::Span(SpanKind::Spherical(6)) => Method::SphericalCos2Rom6,
        Order::Span(SpanKind::Spherical(8)) => Method::SphericalCos2Rom8,
        Order::Span(SpanKind::Spherical(_)) => Method::SphericalCos2,
        Order::Span(SpanKind::SphericalPower(_)) => Method::SphericalCosN,
        Order::Span(SpanKind::Blake) => Method::Blake,
        Order::Span(SpanKind::BlakeRefit) => Method::BlakeRefit,
        Order::Span(SpanKind::BlakeTrapezium) => Method::BlakeTrapezium,
        Order::Duff => Method::Duff,
        Order::Textured(_) => Method::Quadratic,
        Order::Bump(_) => Method::Phong,
    }
}

/// Knots of a triangle, and its material where the core shades per pixel.
fn knots(p: &Prepared, index: usize, method: Method) -> (Vec<[f64; 3]>, Option<Material>) {
    let t = &p.triangles[index];
    match order_of(method).unwrap_or(Order::Linear) {
        Order::Linear => (shade::gouraud::knots(p, t).to_vec(), None),
        Order::Quadratic | Order::QuadraticEngine | Order::Textured(_) => {
            (shade::quadratic::knots(p, t).to_vec(), None)
        }
        Order::QuadraticDots | Order::Duff | Order::Glint(_) => {
            let (knots, material) = reflected::knots(p, index, method);
            (knots, Some(material))
        }
        Order::Line(_) => (vec![], None),
        // Their knots are vectors: see `bumped::triangles`.
        Order::Bump(_) => (vec![], None),
        // Their knots are the rows of a surface, made per triangle of the scene: see `triangles_of`.
        Order::Span(_) => (vec![], None),
    }
}

/// All triangles of a prepared scene, in drawing order, for the method that has the name of a core.
#[must_use]
pub fn triangles(p: &Prepared, order: Order) -> Vec<Triangle> {
    triangles_for(p, method_of(order), order)
}

/// All triangles of a prepared scene, in drawing order, for a method that has a core.
#[must_use]
pub fn triangles_of(p: &Prepared, method: Method) -> Vec<Triangle> {
    if let Some(Order::Span(_)) = order_of(method) {
        return spans::triangles(p);
    }
    let one = |(index, t): (usize, &ScreenTriangle)| {
        let (knots, material) = knots(p, index, method);
        Triangle {
            position: t.position,
            depth: t.depth.map(depth::scaled),
            knots,
            material,
            covering: None,
            relief: None,
            label: format!("object {}, face {}", t.object, t.face),
        }
    };
    p.triangles.iter().enumerate().map(one).collect()
}

/// The same for a core, which may be a textured one, then with the pictures of the materials, or a bump core.
#[must_use]
pub fn triangles_for(p: &Prepared, method: Method, order: Order) -> Vec<Triangle> {
    if let Order::Bump(_) = order {
        return bumped::triangles(p);
    }
    let mut all = triangles_of(p, method);
    if let Order::Textured(t) = order {
        textured::cover(p, t.mapping, &mut all);
    }
    all
}
