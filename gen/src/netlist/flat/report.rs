//! How errors name places: an instance by its path, the top module by its name.

use crate::netlist::{Name, NetlistError, Target};

/// The name of `name` below the instance `path`.
pub(super) fn join(path: &str, name: &str) -> String {
    if path.is_empty() {
        name.to_string()
    } else {
        format!("{path}.{name}")
    }
}

/// A name as the description writes it.
pub(super) fn spell(name: &Name) -> String {
    match name {
        Name::Signal(s) | Name::Register(s) => s.clone(),
        Name::Port { child, port } => format!("{child}.{port}"),
    }
}

/// A target as the description writes it.
pub(super) fn spell_target(target: &Target) -> String {
    match target {
        Target::Wire(name) => spell(name),
        Target::Register(name) => name.clone(),
    }
}

/// An error in the instance `path` of the module `name`.
pub(super) fn error(name: &str, path: &str, what: impl Into<String>) -> NetlistError {
    let place = if path.is_empty() {
        name.to_string()
    } else {
        format!("{name} (instance {path})")
    };
    NetlistError::new(&place, what)
}
