//! What to measure: `--only` names methods and scenes in one list.

use super::scenes::Tessellation;
use shadegate_reference::method::UnknownName;
use shadegate_reference::Method;

/// Methods and scenes, each in the order of its catalogue.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Selection {
    /// Methods to list.
    pub methods: Vec<Method>,
    /// Spheres to draw; all, when none was named.
    pub scenes: Vec<Tessellation>,
    /// Whether scenes were named.
    pub scenes_named: bool,
    /// Whether methods were named.
    pub methods_named: bool,
}

impl Default for Selection {
    fn default() -> Self {
        Self {
            methods: Method::ALL.to_vec(),
            scenes: Tessellation::ALL.to_vec(),
            scenes_named: false,
            methods_named: false,
        }
    }
}

impl Selection {
    /// Every name that a list may hold.
    #[must_use]
    pub fn names() -> Vec<&'static str> {
        let scenes = Tessellation::ALL.iter().map(|t| t.name);
        Method::ALL.iter().map(|m| m.name()).chain(scenes).collect()
    }

    /// Reads a comma-separated list of methods and scenes. A kind that the list does not name is not restricted.
    ///
    /// # Errors
    /// An unknown name, with the nearest of all.
    pub fn parse(list: &str) -> Result<Self, UnknownName> {
        let (mut methods, mut scenes) = (Vec::new(), Vec::new());
        for name in list.split(',').map(str::trim).filter(|n| !n.is_empty()) {
            let scene = Tessellation::ALL.into_iter().find(|t| t.name == name);
            let method = Method::ALL.iter().copied().find(|m| m.name() == name);
            match (method, scene) {
                (Some(m), _) => methods.push(m),
                (None, Some(s)) => scenes.push(s),
                (None, None) => {
                    return Err(UnknownName::new("method or scene", name, &Self::names()));
                }
            }
        }
        let mut all = Self::default();
        if !methods.is_empty() {
            all.methods.retain(|m| methods.contains(m));
            all.methods_named = true;
        }
        if !scenes.is_empty() {
            all.scenes.retain(|s| scenes.contains(s));
            all.scenes_named = true;
        }
        Ok(all)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_restricts_the_kinds_it_names() {
        let s = Selection::parse(" sphere-690,gouraud, flat").unwrap();
        let names: Vec<&str> = s.methods.iter().map(|m| m.name()).collect();
        assert_eq!(names, ["flat", "gouraud"]);
        assert_eq!(s.scenes, [Tessellation::of_690()]);
        let methods = Selection::parse("gouraud").unwrap();
        assert_eq!(methods.scenes.len(), Tessellation::ALL.len());
        let scenes = Selection::parse("sphere-10k").unwrap();
        assert_eq!(scenes.methods, Method::ALL);
        assert_eq!(Selection::parse("").unwrap(), Selection::default());
    }

    #[test]
    fn an_unknown_name_is_answered_with_the_nearest_of_both_kinds() {
        let near = |given: &str| Selection::parse(given).unwrap_err().nearest;
        assert_eq!(near("goraud"), "gouraud");
        assert_eq!(near("flat,sphere-69"), "sphere-690");
    }
}
