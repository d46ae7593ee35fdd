//! From a method's name to its shader: the one place that knows all of them.

use super::shader::Shader;
use super::{exact, flat, gouraud, quadratic};
use crate::geometry::Prepared;
use crate::method::Method;

/// Something to be done with a shader, whichever it is.
pub trait Visitor {
    /// What comes of it.
    type Out;

    /// Does it.
    fn visit<S: Shader>(self, shader: &S) -> Self::Out;
}

/// Makes the shader of a method for a scene and hands it to `visitor`. One arm for each method of the catalogue; `None`
/// for `auto`, which has a plan per triangle in the place of a shader.
pub fn dispatch<V: Visitor>(p: &Prepared, method: Method, visitor: V) -> Option<V::Out> {
    Some(match method {
        Method::Auto => return None,
        Method::Exact => visitor.visit(&exact::Exact),
        Method::Flat => visitor.visit(&flat::Flat),
        Method::Gouraud => visitor.visit(&gouraud::Gouraud::new(p)),
        Method::Quadratic => visitor.visit(&quadratic::Quadratic::new(p)),
    })
}
