//! Names that users type: offered by help and completion, checked by the libraries that own them.

use crate::outcome::Failure;
use clap::builder::{PossibleValue, TypedValueParser};
use clap::{Arg, Command};
use shadegate_gen::scene::{order_of, DepthFormat, CORES, LINES};
use shadegate_gen::wrapper::Wrapper;
use shadegate_hdl::shade::device::Core;
use shadegate_reference::antialias::Antialias;
use shadegate_reference::line::LineFilter;
use shadegate_reference::method::UnknownName;
use shadegate_reference::{Method, Scene};
use shadegate_testbench::cosim::{core_for, is_wireframe, line_core_for, CosimError};
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

/// Names of the cores; the method, or the filter of lines, that a core draws has the same name.
pub fn cores() -> Vec<&'static str> {
    let triangles = CORES.iter().map(|c| c.0);
    triangles.chain(LINES.iter().map(|l| l.0)).collect()
}

/// Engines of the co-simulation.
pub fn engines() -> Vec<&'static str> {
    Engine::ALL.map(Engine::name).to_vec()
}

/// What depth words are linear in.
pub fn depth_formats() -> Vec<&'static str> {
    DepthFormat::ALL.map(DepthFormat::name).to_vec()
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

/// What a core draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drawing {
    /// Triangles, shaded by a method.
    Shaded(Method),
    /// Lines, by a filter.
    Lines(LineFilter),
}

impl Drawing {
    /// Name of the method or filter.
    pub fn name(self) -> &'static str {
        match self {
            Self::Shaded(method) => method.name(),
            Self::Lines(filter) => filter.name(),
        }
    }

    /// Its core for a frame.
    pub fn core(self, width: u32, height: u32) -> Result<Core, CosimError> {
        match self {
            Self::Shaded(method) => core_for(method, width, height),
            Self::Lines(filter) => line_core_for(filter, width, height),
        }
    }
}

fn filter_of(name: &str) -> Option<LineFilter> {
    LINES.iter().find(|l| l.0 == name).map(|l| l.2)
}

/// What the core of this name draws.
pub fn drawing(name: &str) -> Result<Drawing, Failure> {
    match filter_of(name) {
        Some(filter) => Ok(Drawing::Lines(filter)),
        None => core(name).map(Drawing::Shaded),
    }
}

/// Checks what the user says of method and core before a scene is read.
pub fn check_names(method_name: Option<&str>, core_name: Option<&str>) -> Result<(), Failure> {
    let line = |name: Option<&str>| name.is_some_and(|n| filter_of(n).is_some());
    match (method_name, core_name) {
        (Some(m), Some(c)) if (line(Some(m)) || line(Some(c))) && m != c => Err(Failure::input(
            format!("core '{c}' does not draw method '{m}'; leave out one of --core and --method"),
        )),
        (m, c) if line(m) || line(c) => Ok(()),
        (m, c) => hardware_method(m, c, Method::Quadratic).map(|_| ()),
    }
}

/// What is drawn of a scene, from what the user says of method and core, or else from the scene; a filter that the user
/// names becomes the scene's.
pub fn drawing_of(
    method_name: Option<&str>,
    core_name: Option<&str>,
    scene: &mut Scene,
) -> Result<Drawing, Failure> {
    check_names(method_name, core_name)?;
    let wires = is_wireframe(scene).map_err(Failure::input)?;
    let named = method_name.or(core_name);
    let filter = named.and_then(filter_of);
    match (wires, named, filter) {
        (true, _, Some(filter)) => {
            scene.render.line = filter;
            Ok(Drawing::Lines(filter))
        }
        (true, None, _) => Ok(Drawing::Lines(scene.render.line)),
        (true, Some(name), None) => Err(Failure::input(format!(
            "core '{name}' does not draw wireframes, and object[0] of the scene is one; cores that do: {}",
            LINES.map(|l| l.0).join(", ")
        ))),
        (false, Some(name), Some(_)) => Err(Failure::input(format!(
            "core '{name}' draws wireframes, and the scene has none; cores of triangles: {}",
            CORES.map(|c| c.0).join(", ")
        ))),
        (false, _, None) => {
            hardware_method(method_name, core_name, scene.render.method).map(Drawing::Shaded)
        }
        // No name, no filter.
        (false, None, Some(_)) => hardware_method(None, None, scene.render.method).map(Drawing::Shaded),
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
            format!(
                "unknown core 'goraud'; the nearest is 'gouraud' of {}",
                cores().join(", ")
            )
        );
        assert_eq!(
            with_core(Method::Flat).unwrap_err().message,
            format!("method 'flat' has no core; cores: {}", cores().join(", "))
        );
    }

    #[test]
    fn filters_are_cores_too() {
        for (name, _, filter) in LINES {
            assert_eq!(drawing(name).unwrap(), Drawing::Lines(filter));
            assert_eq!(Drawing::Lines(filter).name(), name);
            check_names(Some(name), Some(name)).unwrap();
            check_names(None, Some(name)).unwrap();
        }
        assert_eq!(
            drawing("gouraud").unwrap(),
            Drawing::Shaded(Method::Gouraud)
        );
        assert_eq!(
            check_names(Some("gouraud"), Some("box"))
                .unwrap_err()
                .message,
            "core 'box' does not draw method 'gouraud'; leave out one of --core and --method"
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
