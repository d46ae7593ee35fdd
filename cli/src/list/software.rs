//! The shading methods of the software renderer.

use super::Section;
use serde_json::json;
use shadegate_gen::scene::order_of;
use shadegate_reference::Method;

fn about(m: Method) -> &'static str {
    match m {
        Method::Exact => "every pixel from the definition, in f64: the truth",
        Method::Flat => "one colour per triangle",
        Method::Gouraud => "linear interpolation of three vertex colours",
        Method::Quadratic => "quadratic interpolation of six colours",
    }
}

/// Every method, and whether a core draws it.
pub fn methods() -> Section {
    let mut section = Section::new(&["method", "core", "about"]);
    for m in Method::ALL {
        let core = order_of(m).map(|_| m.name());
        section.add(
            [
                m.name().to_owned(),
                core.unwrap_or("-").to_owned(),
                about(m).to_owned(),
            ],
            json!({ "name": m.name(), "core": core, "about": about(m) }),
        );
    }
    section
}
