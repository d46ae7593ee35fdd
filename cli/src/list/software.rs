//! The shading methods of the software renderer, and what it leaves out.

use super::Section;
use serde_json::json;
use shadegate_gen::scene::order_of;
use shadegate_reference::{Method, Skips};

/// Every method, and whether a core draws it.
pub fn methods() -> Section {
    let mut section = Section::new(&["method", "core", "about"]);
    for m in Method::ALL.iter().copied() {
        let core = order_of(m).map(|_| m.name());
        section.add(
            [
                m.name().to_owned(),
                core.unwrap_or("-").to_owned(),
                m.about().to_owned(),
            ],
            json!({ "name": m.name(), "core": core, "about": m.about() }),
        );
    }
    section
}

/// Every skip that can be switched off.
pub fn skips() -> Section {
    let mut section = Section::new(&["skip", "about"]);
    for name in Skips::NAMES {
        let about = Skips::about(name);
        section.add(
            [(*name).to_owned(), about.to_owned()],
            json!({ "name": name, "about": about }),
        );
    }
    section
}
