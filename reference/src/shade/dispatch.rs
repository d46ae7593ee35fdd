//! From a method's name to its shader: the one place that knows all of them.

use super::angular::Angular;
use super::angular_single::AngularSingle;
use super::dot_product::DotProduct;
use super::duff::Duff;
use super::euler::Euler;
use super::hybrid::Hybrid;
use super::lit::Lit;
use super::newton::Newton;
use super::normals::Normals;
use super::phong::Phong;
use super::polar_angle::PolarAngle;
use super::pseudo_phong::PseudoPhong;
use super::reflection::Reflection;
use super::shader::Shader;
use super::taylor::Taylor;
use super::x_shading::XShading;
use super::{
    blake, exact, flat, gouraud, hemisphere, quadratic, quadratic_adaptive,
    quadratic_adaptive_centre, quadratic_dots, slerp, spherical, spherical_cos2, spherical_cosn,
    spherical_independent,
};
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
        Method::Normals => visitor.visit(&Lit(Normals)),
        Method::DotProduct => visitor.visit(&Lit(DotProduct)),
        Method::PolarAngle => visitor.visit(&Lit(PolarAngle)),
        Method::Angular => visitor.visit(&Lit(Angular)),
        Method::AngularSingle => visitor.visit(&Lit(AngularSingle)),
        Method::Duff => visitor.visit(&Lit(Duff)),
        Method::Taylor => visitor.visit(&Lit(Taylor::Centroid)),
        Method::TaylorVertex => visitor.visit(&Lit(Taylor::Vertex)),
        Method::Euler => visitor.visit(&Lit(Euler)),
        Method::Hybrid => visitor.visit(&Lit(Hybrid)),
        Method::Reflection => visitor.visit(&Lit(Reflection)),
        Method::Newton => visitor.visit(&Lit(Newton)),
        Method::XShading => visitor.visit(&Lit(XShading::Newton)),
        Method::XShadingCached => visitor.visit(&Lit(XShading::Cached)),
        Method::PseudoPhong => visitor.visit(&PseudoPhong::new(p)),
        Method::Phong => visitor.visit(&Phong::new(p)),
        Method::Hemisphere => visitor.visit(&hemisphere::Hemisphere::new(p)),
        Method::Quadratic => visitor.visit(&quadratic::Quadratic::new(p)),
        Method::QuadraticDots => visitor.visit(&quadratic_dots::QuadraticDots),
        Method::QuadraticAdaptive => visitor.visit(&quadratic_adaptive::QuadraticAdaptive::new(
            p,
            quadratic_adaptive::TOLERANCE,
        )),
        Method::QuadraticAdaptiveCentre => {
            visitor.visit(&quadratic_adaptive_centre::QuadraticAdaptiveCentre)
        }
        Method::Spherical => visitor.visit(&spherical::SPHERICAL),
        Method::SphericalIndependent => visitor.visit(&spherical_independent::SphericalIndependent),
        Method::SphericalCos2 => visitor.visit(&spherical_cos2::matched(p)),
        Method::SphericalCos2Minimax => visitor.visit(&spherical_cos2::minimax(p)),
        Method::SphericalCos2Rom4 => visitor.visit(&spherical_cos2::roms(p, 4)),
        Method::SphericalCos2Rom6 => visitor.visit(&spherical_cos2::roms(p, 6)),
        Method::SphericalCos2Rom8 => visitor.visit(&spherical_cos2::roms(p, 8)),
        Method::SphericalCosN => visitor.visit(&spherical_cosn::new(p)),
        Method::Blake => visitor.visit(&blake::printed(p)),
        Method::BlakeRefit => visitor.visit(&blake::refit(p)),
        Method::BlakeTrapezium => visitor.visit(&blake::trapezium(p)),
        Method::Slerp => visitor.visit(&slerp::SLERP),
        Method::SlerpChebyshev => visitor.visit(&slerp::CHEBYSHEV),
        Method::SlerpDeMoivre => visitor.visit(&slerp::DE_MOIVRE),
        Method::SlerpTrigFree => visitor.visit(&slerp::TRIG_FREE),
    })
}
