//! Which methods can draw which scenes. Methods that shade pixels or knots with the full reflection model draw
//! everything; those that interpolate angles, vectors or dot products have the diffuse term and one power of N·H built
//! in; a table over the normals knows no positions.

use crate::geometry::Prepared;
use crate::method::Method;
use crate::scene::{Brdf, Highlight, LightKind, Material};

/// A method that cannot draw a scene.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("method '{method}' cannot draw {what}; methods that can: {able}")]
pub struct Unsupported {
    /// The method.
    pub method: Method,
    /// What it cannot draw, such as "material 'gold' (cook-torrance)".
    pub what: String,
    /// The methods that can draw the scene, separated by commas.
    pub able: String,
}

/// What a method can draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Scope {
    /// Any material under any light.
    Everything,
    /// Any material, under lights and for viewers that are infinitely far.
    Distant,
    /// Lambert, and Blinn with a power, under any light; nothing that changes the ambient part.
    Terms,
}

fn scope(method: Method) -> Scope {
    match method {
        Method::Exact
        | Method::Flat
        | Method::Gouraud
        | Method::Auto
        | Method::Quadratic
        | Method::PseudoPhong
        | Method::Phong => Scope::Everything,
        Method::Hemisphere => Scope::Distant,
        #[allow(
            unreachable_patterns,
            reason = "whatever joins the catalogue is one of these"
        )]
        _ => Scope::Terms,
    }
}

/// Whether a method can draw a scene.
///
/// # Errors
/// What it cannot draw, and the methods that can.
pub fn supported(p: &Prepared, method: Method) -> Result<(), Unsupported> {
    let Some(what) = refusal(p, scope(method)) else {
        return Ok(());
    };
    let able = Method::ALL.iter().copied();
    let able = able.filter(|m| refusal(p, scope(*m)).is_none());
    Err(Unsupported {
        method,
        what,
        able: able.map(Method::name).collect::<Vec<_>>().join(", "),
    })
}

/// The first thing of a scene that is beyond a scope.
fn refusal(p: &Prepared, scope: Scope) -> Option<String> {
    let s = &p.surroundings;
    match scope {
        Scope::Everything => None,
        Scope::Distant if s.distant_view().is_none() => Some("with perspective".to_owned()),
        Scope::Distant => (0..s.lights()).find_map(|k| match s.light(k).0.kind {
            LightKind::Directional { .. } => None,
            LightKind::Point { .. } => Some("a point light".to_owned()),
            LightKind::Spot { .. } => Some("a spot".to_owned()),
        }),
        Scope::Terms => {
            let mut seen = vec![false; s.materials().len()];
            p.triangles.iter().find_map(|t| {
                if std::mem::replace(&mut seen[t.material], true) {
                    return None;
                }
                let m = s.material(t.material);
                beyond_terms(m).map(|why| format!("material '{}' ({why})", m.name))
            })
        }
    }
}

/// What of a material is more than ambient, N·L and a power of N·H.
fn beyond_terms(m: &Material) -> Option<&'static str> {
    match (m.brdf, m.highlight) {
        (Brdf::Phong, _) => Some("phong"),
        (Brdf::CookTorrance { .. }, _) => Some("cook-torrance"),
        (Brdf::Blinn, Highlight::Kappa { .. }) => Some("highlight 'kappa'"),
        (Brdf::Blinn, Highlight::Cos2) => Some("highlight 'cos2'"),
        (Brdf::Blinn, Highlight::Blake) => Some("highlight 'blake'"),
        (Brdf::Blinn, Highlight::Schlick) => Some("highlight 'schlick'"),
        (Brdf::Lambert, _) | (Brdf::Blinn, Highlight::Pow) => (m.shadow > 0.0).then_some("shadow"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{scene, Skips};
    use std::path::Path;

    fn prepared(name: &str, change: impl Fn(&mut Material)) -> Prepared {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../scenes/{name}.toml"));
        let mut s = scene::load(&file).unwrap();
        s.materials.iter_mut().for_each(change);
        Prepared::new(&s, Some((64, 48)), &Skips::all()).unwrap()
    }

    #[test]
    fn methods_of_the_full_model_draw_everything() {
        for name in ["spot", "materials", "teapot"] {
            let p = prepared(name, |_| ());
            for m in [
                Method::Exact,
                Method::Flat,
                Method::Gouraud,
                Method::Quadratic,
            ] {
                assert_eq!(supported(&p, m), Ok(()));
            }
        }
    }

    #[test]
    fn tables_of_normals_know_no_positions() {
        assert_eq!(
            supported(&prepared("materials", |_| ()), Method::Hemisphere),
            Ok(())
        );
        let refused = |name: &str| {
            let e = supported(&prepared(name, |_| ()), Method::Hemisphere).unwrap_err();
            assert!(e.able.starts_with("exact, flat, gouraud"), "{e}");
            assert!(!e.able.contains("hemisphere"), "{e}");
            e.to_string()
        };
        let start = "method 'hemisphere' cannot draw with perspective; methods that can: exact, ";
        assert!(refused("teapot").starts_with(start));
    }

    #[test]
    fn interpolated_terms_are_diffuse_light_and_one_power() {
        let why = |change: &dyn Fn(&mut Material)| {
            let p = prepared("sphere-168", change);
            refusal(&p, Scope::Terms)
        };
        assert_eq!(why(&|_| ()), None);
        assert_eq!(why(&|m| m.brdf = Brdf::Lambert), None);
        assert_eq!(why(&|m| m.emission.x = 1.0), None);
        let material = |what: &str| Some(format!("material 'coral' ({what})"));
        assert_eq!(why(&|m| m.brdf = Brdf::Phong), material("phong"));
        let facets = Brdf::CookTorrance { roughness: 0.3 };
        assert_eq!(why(&|m| m.brdf = facets), material("cook-torrance"));
        assert_eq!(why(&|m| m.shadow = 0.5), material("shadow"));
        let blake = material("highlight 'blake'");
        assert_eq!(why(&|m| m.highlight = Highlight::Blake), blake);
        assert_eq!(
            refusal(&prepared("spot", |m| m.shadow = 0.0), Scope::Terms),
            None
        );
    }
}
