//! Names that users type: offered by help and completion, checked by the libraries that own them.

use crate::outcome::Failure;
use clap::builder::{PossibleValue, TypedValueParser};
use clap::{Arg, Command};
use shadegate_gen::scene::{catalogue, BY_SCENE, CORES, ENGINES, LINES, TEXTURED};
use shadegate_gen::scene::{method_of, order_for, order_of, DepthFormat, SetUp};
use shadegate_gen::wrapper::Wrapper;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::antialias::Antialias;
use shadegate_reference::line::LineFilter;
use shadegate_reference::method::UnknownName;
use shadegate_reference::{Method, Scene};
use shadegate_testbench::cosim::{core_for, is_wireframe, line_core_for, with_set_up, CosimError};
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

/// Names of the cores that the host sets up; the method, or the filter of lines, that a core draws has the same name.
pub fn cores() -> Vec<&'static str> {
    let mut names = all_cores();
    names.retain(|name| ENGINES.iter().all(|e| e.0 != *name));
    names
}

/// Whether the core of this name is a textured one.
fn is_textured(name: &str) -> bool {
    TEXTURED.iter().any(|t| t.0 == name)
}

/// The core of this name, if a scene chooses it by its textures, lights and materials.
fn by_scene(name: &str) -> Option<Order> {
    let lit = BY_SCENE.iter().map(|c| (c.0, c.1));
    let found = lit.chain(TEXTURED).find(|c| c.0 == name);
    found.map(|c| c.1)
}

/// Names of all cores.
pub fn all_cores() -> Vec<&'static str> {
    catalogue().into_iter().map(|(name, _)| name).collect()
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
    let known = CORES.iter().chain(&BY_SCENE).find(|c| c.0 == name);
    let known = known.map(|c| c.2);
    let engine = ENGINES.iter().find(|e| e.0 == name);
    known
        .or(engine.map(|e| method_of(e.1)))
        .ok_or_else(|| Failure::input(UnknownName::new("core", name, &all_cores())))
}

/// Who sets triangles up: what the user says of it, or else what the core's name says.
pub fn set_up(named: Option<&str>, core_name: Option<&str>) -> Result<SetUp, Failure> {
    let engine = core_name.is_some_and(|c| ENGINES.iter().any(|e| e.0 == c));
    match (named, engine) {
        (None, false) | (Some("host"), false) => Ok(SetUp::Host),
        (None, true) | (Some("engine"), _) => Ok(SetUp::Engine),
        (Some("host"), true) => Err(Failure::input(format!(
            "core '{}' has a set-up engine; leave out --set-up host",
            core_name.unwrap_or_default()
        ))),
        (Some(other), _) => Err(Failure::input(UnknownName::new(
            "set-up",
            other,
            &set_ups(),
        ))),
    }
}

/// Who can set triangles up.
pub fn set_ups() -> Vec<&'static str> {
    SetUp::ALL.map(SetUp::name).to_vec()
}

/// Refuses methods that only software draws.
pub fn with_core(method: Method) -> Result<Method, Failure> {
    let by_scene = BY_SCENE.iter().find(|c| c.2 == method).map(|c| c.1);
    match order_of(method).or(by_scene) {
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
    /// Whatever a core draws that scenes choose by their textures, lights and materials.
    Core(Order),
}

impl Drawing {
    /// Name of the method or filter.
    pub fn name(self) -> &'static str {
        match self {
            Self::Shaded(method) => method.name(),
            Self::Lines(filter) => filter.name(),
            Self::Core(Order::Textured(t)) => t.name(),
            Self::Core(order) => {
                let by_scene = BY_SCENE.iter().find(|c| c.1 == order);
                by_scene.map_or("", |c| c.0)
            }
        }
    }

    /// Its core for a frame, set up by the host or by an engine.
    pub fn core_by(self, set_up: SetUp, width: u32, height: u32) -> Result<Core, CosimError> {
        with_set_up(self.core(width, height)?, set_up)
    }

    /// Its core for a frame.
    fn core(self, width: u32, height: u32) -> Result<Core, CosimError> {
        match self {
            Self::Shaded(method) => core_for(method, width, height),
            Self::Lines(filter) => line_core_for(filter, width, height),
            Self::Core(order) => {
                Core::for_frame(order, width, height).ok_or(CosimError::TooLarge { width, height })
            }
        }
    }
}

fn filter_of(name: &str) -> Option<LineFilter> {
    LINES.iter().find(|l| l.0 == name).map(|l| l.2)
}

/// What the core of this name draws.
pub fn drawing(name: &str) -> Result<Drawing, Failure> {
    match (filter_of(name), by_scene(name)) {
        (Some(filter), _) => Ok(Drawing::Lines(filter)),
        (None, Some(order)) => Ok(Drawing::Core(order)),
        (None, None) => core(name).map(Drawing::Shaded),
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
        (m, Some(c)) if is_textured(c) => match m.map(method).transpose()? {
            None | Some(Method::Gouraud | Method::Quadratic) => Ok(()),
            Some(m) => Err(Failure::input(format!(
                "core '{c}' does not draw method '{m}'; expected method gouraud or quadratic"
            ))),
        },
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
        (false, _, None) => shaded(method_name, core_name, scene).map(Drawing::Shaded),
        // No name, no filter.
        (false, None, Some(_)) => hardware_method(None, None, scene.render.method).map(Drawing::Shaded),
    }
}

/// The method of a scene of triangles. A core that the user names must be the one that the scene's textures, lights and
/// materials take.
fn shaded(
    method_name: Option<&str>,
    core_name: Option<&str>,
    scene: &Scene,
) -> Result<Method, Failure> {
    let own = core_name.filter(|c| !is_textured(c));
    let method = hardware_method(method_name, own, scene.render.method)?;
    let Some(named) = core_name else {
        return Ok(method);
    };
    let order = order_of(method);
    // The method of a set-up goes by the name of its core.
    let takes = order_for(scene, method).map_err(Failure::input)?;
    let takes = takes
        .filter(|t| Some(*t) != order)
        .map(|t| Drawing::Core(t).name());
    match takes {
        Some(takes) if takes != named => Err(Failure::input(format!(
            "core '{named}' does not draw this scene; the one for its textures, lights and materials is '{takes}'"
        ))),
        None if order.is_none() => Err(Failure::input(format!(
            "core '{named}' does not draw this scene, which has no bump maps"
        ))),
        None if by_scene(named).is_some() => Err(Failure::input(format!(
            "core '{named}' does not draw this scene; the one for its textures, lights and materials is '{}'",
            method.name()
        ))),
        _ => Ok(method),
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
                all_cores().join(", ")
            )
        );
        assert_eq!(
            with_core(Method::Flat).unwrap_err().message,
            format!("method 'flat' has no core; cores: {}", cores().join(", "))
        );
    }

    #[test]
    fn engines_are_cores_too() {
        for (name, order, of) in ENGINES {
            assert_eq!(drawing(name).unwrap(), Drawing::Shaded(method_of(of)));
            assert_eq!(SetUp::Engine.of(of), Some(order));
            assert_eq!(set_up(None, Some(name)).unwrap(), SetUp::Engine);
            assert!(set_up(Some("host"), Some(name)).is_err());
        }
        assert_eq!(set_up(None, Some("quadratic")).unwrap(), SetUp::Host);
        assert_eq!(
            set_up(Some("engine"), Some("quadratic")).unwrap(),
            SetUp::Engine
        );
        assert_eq!(
            set_up(Some("motor"), None).unwrap_err().message,
            "unknown set-up 'motor'; the nearest is 'host' of host, engine"
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
