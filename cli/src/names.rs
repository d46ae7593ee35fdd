//! Names that users type: offered by help and completion, checked by the libraries that own them.

use crate::outcome::Failure;
use clap::builder::{PossibleValue, TypedValueParser};
use clap::{Arg, Command};
use shadegate_gen::scene::{order_of, CORES};
use shadegate_gen::wrapper::Wrapper;
use shadegate_reference::antialias::Antialias;
use shadegate_reference::method::UnknownName;
use shadegate_reference::Method;
use shadegate_testbench::engine::Engine;
use shadegate_testbench::synthesis::Router;
use std::ffi::OsStr;

/// Takes any text and offers some; the command itself refuses the rest, naming the nearest.
#[derive(Clone, Debug)]
pub struct Offer(pub fn() -> Vec<&'static str>);

impl TypedValueParser for Offer {
    type Value = String;

    fn parse_ref(
        &self,
        _: &Command,
        _: Option<&Arg>,
        value: &OsStr,
    ) -> Result<String, clap::Error> {
        Ok(value.to_string_lossy().into_owned())
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new((self.0)().into_iter().map(PossibleValue::new)))
    }
}

/// Shading methods of the software renderer.
pub fn methods() -> Vec<&'static str> {
    Method::NAMES.to_vec()
}

/// Ways to anti-alias the edges of polygons.
pub fn antialiasing() -> Vec<&'static str> {
    Antialias::ALL.map(Antialias::name).to_vec()
}

/// Names of the cores; the method that a core draws has the same name.
pub fn cores() -> Vec<&'static str> {
    CORES.map(|c| c.0).to_vec()
}

/// Engines of the co-simulation.
pub fn engines() -> Vec<&'static str> {
    Engine::ALL.map(Engine::name).to_vec()
}

/// Bus wrappers of a core.
pub fn wrappers() -> Vec<&'static str> {
    Wrapper::ALL.map(Wrapper::name).to_vec()
}

/// Devices of the catalogue.
pub fn devices() -> Vec<&'static str> {
    let all = shadegate_constraints::devices();
    all.iter().map(|d| d.name.as_str()).collect()
}

/// Boards of the catalogue.
pub fn boards() -> Vec<&'static str> {
    let all = shadegate_constraints::boards();
    all.iter().map(|b| b.name.as_str()).collect()
}

/// Families that can be placed and routed.
pub fn routers() -> Vec<&'static str> {
    let all = Router::ALL.map(|r| r.family().name());
    ["none"].into_iter().chain(all).collect()
}

/// The method of this name.
pub fn method(name: &str) -> Result<Method, Failure> {
    name.parse().map_err(Failure::input)
}

/// The method that the core of this name draws.
pub fn core(name: &str) -> Result<Method, Failure> {
    let known = CORES.iter().find(|c| c.0 == name);
    known
        .map(|c| c.2)
        .ok_or_else(|| Failure::input(UnknownName::new("core", name, &cores())))
}

/// Refuses methods that only software draws.
pub fn with_core(method: Method) -> Result<Method, Failure> {
    match order_of(method) {
        Some(_) => Ok(method),
        None => Err(Failure::input(format!(
            "method '{method}' has no core; cores: {}",
            cores().join(", ")
        ))),
    }
}

/// The method from what the user says of method and core, or else from the scene.
pub fn hardware_method(
    method_name: Option<&str>,
    core_name: Option<&str>,
    of_scene: Method,
) -> Result<Method, Failure> {
    let by_method = method_name.map(|m| with_core(method(m)?)).transpose()?;
    let by_core = core_name.map(core).transpose()?;
    match (by_method, by_core) {
        (Some(m), Some(c)) if order_of(m) != order_of(c) => Err(Failure::input(format!(
            "core '{c}' does not draw method '{m}'; leave out one of --core and --method"
        ))),
        (Some(m), _) | (None, Some(m)) => Ok(m),
        (None, None) => with_core(of_scene),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cores_and_methods_go_together() {
        for (name, _, method) in CORES {
            assert_eq!(core(name).unwrap(), method);
            assert_eq!(with_core(method).unwrap().name(), name);
        }
        assert_eq!(
            core("goraud").unwrap_err().message,
            "unknown core 'goraud'; the nearest is 'gouraud' of gouraud, quadratic, quadratic-dots, duff"
        );
        assert_eq!(
            with_core(Method::Flat).unwrap_err().message,
            "method 'flat' has no core; cores: gouraud, quadratic, quadratic-dots, duff"
        );
    }

    #[test]
    fn one_of_method_and_core_is_enough() {
        let pick = |m, c| hardware_method(m, c, Method::Gouraud);
        assert_eq!(pick(None, None).unwrap(), Method::Gouraud);
        assert_eq!(pick(Some("quadratic"), None).unwrap(), Method::Quadratic);
        assert_eq!(pick(None, Some("quadratic")).unwrap(), Method::Quadratic);
        assert_eq!(
            pick(Some("gouraud"), Some("gouraud")).unwrap(),
            Method::Gouraud
        );
        assert_eq!(
            pick(Some("gouraud"), Some("quadratic"))
                .unwrap_err()
                .message,
            "core 'quadratic' does not draw method 'gouraud'; leave out one of --core and --method"
        );
    }
}
