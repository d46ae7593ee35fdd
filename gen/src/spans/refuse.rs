//! What a scene may not have for a span core.

use crate::scene::{method_of, Unsuited};
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::shade::span_core::SpanKind;
use shadegate_reference::scene::LightKind;
use shadegate_reference::{supported, Prepared, Scene, Unsupported};

/// Why a span core cannot draw a scene.
#[derive(Clone, Debug, thiserror::Error)]
pub enum Refused {
    /// The method cannot.
    #[error(transparent)]
    Method(#[from] Unsupported),
    /// The core has less than the method.
    #[error(transparent)]
    Core(#[from] Unsuited),
}

/// Whether the core of an order can draw a scene; those that are no span cores are not asked.
///
/// # Errors
/// The first thing that it cannot draw.
pub fn drawable(scene: &Scene, p: &Prepared, order: Order) -> Result<(), Refused> {
    let Order::Span(kind) = order else {
        return Ok(());
    };
    supported(p, method_of(order))?;
    let s = p.surroundings();
    let refuse = |expected, what| {
        Err(Refused::Core(Unsuited {
            file: scene.file.display().to_string(),
            what,
            core: kind.name(),
            expected,
        }))
    };
    if s.lights() > 1 {
        return refuse("one light", format!("the scene has {} lights", s.lights()));
    }
    for k in 0..s.lights() {
        let fades = match &s.light(k).0.kind {
            LightKind::Directional { .. } => None,
            LightKind::Point { attenuation, .. } => {
                let fades = attenuation.linear != 0.0 || attenuation.quadratic != 0.0;
                fades.then_some("the light falls off with distance")
            }
            LightKind::Spot { .. } => Some("the light is a spot"),
        };
        if let Some(has) = fades {
            return refuse("a light of one colour everywhere", has.to_owned());
        }
        let blake = matches!(
            kind,
            SpanKind::Blake | SpanKind::BlakeRefit | SpanKind::BlakeTrapezium
        );
        if blake && !s.is_constant(k) {
            return refuse(
                "an orthographic camera (height) and a directional light",
                "the camera or the light is near".to_owned(),
            );
        }
    }
    Ok(())
}
