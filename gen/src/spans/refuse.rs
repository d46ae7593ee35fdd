//! What a scene may not have for a span core.

use crate::scene::method_of;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::shade::span_core::SpanKind;
use shadegate_reference::scene::LightKind;
use shadegate_reference::{supported, Prepared, Unsupported};

/// Why a span core cannot draw a scene.
#[derive(Clone, Debug, thiserror::Error)]
pub enum Refused {
    /// The method cannot.
    #[error(transparent)]
    Method(#[from] Unsupported),
    /// The core has less than the method.
    #[error("the {core} core draws {takes}, and the scene has {has}")]
    Core {
        /// Name of the core.
        core: &'static str,
        /// What it draws.
        takes: &'static str,
        /// What is in the way.
        has: String,
    },
}

/// Whether the core of an order can draw a scene; those that are no span cores are not asked.
///
/// # Errors
/// The first thing that it cannot draw.
pub fn drawable(p: &Prepared, order: Order) -> Result<(), Refused> {
    let Order::Span(kind) = order else {
        return Ok(());
    };
    supported(p, method_of(order))?;
    let s = p.surroundings();
    let refuse = |takes, has| {
        Err(Refused::Core {
            core: kind.name(),
            takes,
            has,
        })
    };
    if s.lights() > 1 {
        return refuse("one light", format!("{} lights", s.lights()));
    }
    for k in 0..s.lights() {
        let fades = match &s.light(k).0.kind {
            LightKind::Directional { .. } => None,
            LightKind::Point { attenuation, .. } => {
                let fades = attenuation.linear != 0.0 || attenuation.quadratic != 0.0;
                fades.then_some("a point light that falls off with distance")
            }
            LightKind::Spot { .. } => Some("a spot"),
        };
        if let Some(has) = fades {
            return refuse("light of one colour everywhere", has.to_owned());
        }
        let blake = matches!(kind, SpanKind::Blake | SpanKind::BlakeRefit);
        if blake && !s.is_constant(k) {
            return refuse(
                "light and viewer that are infinitely far",
                "perspective or a light nearby".to_owned(),
            );
        }
    }
    Ok(())
}
