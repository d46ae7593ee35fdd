//! The catalogue of shading methods that this crate draws, by the names users type.

use crate::shade::case::Case;
use crate::shade::{
    angular, angular_single, blake, dot_product, duff, euler, flat, gouraud, hybrid, newton,
    normals, phong, polar_angle, pseudo_phong, quadratic, quadratic_adaptive,
    quadratic_adaptive_centre, quadratic_dots, reflection, slerp, spherical, spherical_cos2,
    spherical_cosn, spherical_independent, taylor, x_shading,
};
use std::fmt;
use std::str::FromStr;

/// Declares the catalogue: one line for each method is all that names need.
macro_rules! catalogue {
    ($($variant:ident $name:literal $about:literal)*) => {
        /// How the colour of a pixel is found.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Method {
            $(#[doc = $about] $variant,)*
        }

        impl Method {
            /// Every method, in the order of the catalogue.
            pub const ALL: &'static [Self] = &[$(Self::$variant,)*];
            /// Their names, in the same order.
            pub const NAMES: &'static [&'static str] = &[$($name,)*];

            /// The catalogue name.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)*
                }
            }

            /// What it does, in one line.
            #[must_use]
            pub fn about(self) -> &'static str {
                match self {
                    $(Self::$variant => $about,)*
                }
            }
        }
    };
}

catalogue! {
    Exact "exact" "every pixel from the definition, in f64: the truth"
    Flat "flat" "one colour per triangle (Bouknight 1970)"
    Gouraud "gouraud" "linear interpolation of three vertex colours (Gouraud 1971)"
    Auto "auto" "per triangle the cheapest way whose proved error is within --max-error"
    Normals "normals" "blended normals, not normalised (Abbas 2003 §5.1)"
    DotProduct "dot-product" "linear interpolation of N·L and N·H (Abbas 2003 §5.2)"
    PolarAngle "polar-angle" "linear interpolation of the angles between N and L, N and H (Abbas 2003 §5.3)"
    Angular "angular" "N, L and H turn at constant rates (Kuijk & Blake 1989, two paths)"
    AngularSingle "angular-single" "L relative to N turns at a constant rate (Kuijk & Blake 1989, one path)"
    Duff "duff" "Phong by forward differences, a root per pixel (Duff 1979)"
    Taylor "taylor" "Phong as a Taylor polynomial about the centroid (Bishop & Weimer 1986)"
    TaylorVertex "taylor-vertex" "the same about a vertex, for comparison"
    Euler "euler" "quadratic along spans by Euler's method (Hast 2004 §3.1)"
    Hybrid "hybrid" "linear diffuse term, Phong's highlight without a root (Hast 2004 §3.1)"
    Reflection "reflection" "normals made unit by a reflection, a division per pixel (Hast 2004 §3.1)"
    Newton "newton" "normals made nearly unit by one Newton step (Hast 2004 §3.5)"
    XShading "x-shading" "quadratic N·L and N·H, mid-edges by one Newton step (Hast 2004 §3.3.9)"
    XShadingCached "x-shading-cached" "the same with exact mid-edges by factors kept per mesh edge"
    PseudoPhong "pseudo-phong" "Gouraud on four parts whose vertices are Phong's (Tektronix, in Abbas 2003 §5)"
    Phong "phong" "normals blended and normalised per pixel, in single precision (Phong 1975)"
    Hemisphere "hemisphere" "a table of colours by x and y of the normal (Loisel 1996)"
    Quadratic "quadratic" "quadratic interpolation of six colours (Abbas 2003 ch. 7; Hast 2004 §3.3)"
    QuadraticDots "quadratic-dots" "quadratic interpolation of N·L and N·H, the power per pixel"
    QuadraticAdaptive "quadratic-adaptive" "quadratic on triangles cut by a safe test until an error of 1 LSB is kept"
    QuadraticAdaptiveCentre "quadratic-adaptive-centre" "quadratic on triangles cut by a probe at the centre (Abbas 2003 §7.1): it misses"
    Spherical "spherical" "N·L and N·H as oscillations along a span, true cosine and power (Abbas 2003 §6.2)"
    SphericalIndependent "spherical-independent" "N, L and H slerped each for itself (Abbas 2003 §6.1)"
    SphericalCos2 "spherical-cos2" "spherical, cos²(ax) for the highlight, a by eq. 6.12 (Abbas 2003 §6.3)"
    SphericalCos2Minimax "spherical-cos2-minimax" "spherical, cos²(ax) with the a of least maximal error"
    SphericalCos2Rom4 "spherical-cos2-rom4" "spherical, cos and cos² from ROMs of 4 address and data bits (Abbas 2003 fig. 6.6)"
    SphericalCos2Rom6 "spherical-cos2-rom6" "spherical, cos and cos² from ROMs of 6 address and data bits"
    SphericalCos2Rom8 "spherical-cos2-rom8" "spherical, cos and cos² from ROMs of 8 address and data bits"
    SphericalCosN "spherical-cosn" "spherical, the material's own cosⁿ in an 8-bit ROM"
    Blake "blake" "spherical with cosⁿ in three quadratic pieces, five additions a pixel (Blake et al. 1992 eq. 4)"
    BlakeRefit "blake-refit" "blake with a(n) and b(n) refitted"
    BlakeTrapezium "blake-trapezium" "blake on trapezia, a triangle being two with a collapsed edge"
    Slerp "slerp" "slerp of N along a span by differences (Hast 2004 §3.2)"
    SlerpChebyshev "slerp-chebyshev" "slerp by Chebyshev's recurrence (Hast 2004 eqs 3.38–3.45)"
    SlerpDeMoivre "slerp-de-moivre" "slerp by De Moivre's, edges slerped too (Hast, Barrera and Bengtsson 2003)"
    SlerpTrigFree "slerp-trig-free" "slerp set up without trigonometry (Hast 2004 eqs 3.85–3.88)"
}

impl Method {
    /// The largest error against the truth, LSB, over all triangles, lights and materials of a case; `None` where
    /// nothing has been stated. The module of each method says whether its bound is proved or measured.
    #[must_use]
    pub fn bound(self, case: &Case) -> Option<f64> {
        Some(match self {
            // A bound of its own for every triangle: see `shade::bound`.
            Self::Auto => return None,
            // It depends on the size of the table, not on the normals.
            Self::Hemisphere => return None,
            Self::Exact => 0.0,
            Self::Flat => flat::bound(case),
            Self::Gouraud => gouraud::bound(case),
            Self::Normals => normals::bound(case),
            Self::DotProduct => dot_product::bound(case),
            Self::PolarAngle => polar_angle::bound(case),
            Self::Angular => angular::bound(case),
            Self::AngularSingle => angular_single::bound(case),
            Self::Duff => duff::bound(case),
            Self::Taylor => taylor::bound(case),
            Self::TaylorVertex => taylor::vertex_bound(case),
            Self::Euler => euler::bound(case),
            Self::Hybrid => hybrid::bound(case),
            Self::Reflection => reflection::bound(case),
            Self::Newton => newton::bound(case),
            Self::XShading => x_shading::bound(case),
            Self::XShadingCached => x_shading::cached_bound(case),
            Self::PseudoPhong => pseudo_phong::bound(case),
            Self::Phong => phong::bound(case),
            Self::Quadratic => quadratic::bound(case),
            Self::QuadraticDots => quadratic_dots::bound(case),
            Self::QuadraticAdaptive => quadratic_adaptive::bound(case),
            Self::QuadraticAdaptiveCentre => quadratic_adaptive_centre::bound(case),
            Self::Spherical => spherical::bound(case),
            Self::SphericalIndependent => spherical_independent::bound(case),
            Self::SphericalCos2 => spherical_cos2::bound(case),
            Self::SphericalCos2Minimax => spherical_cos2::bound_minimax(case),
            Self::SphericalCos2Rom4 => spherical_cos2::bound_rom(case, 4),
            Self::SphericalCos2Rom6 => spherical_cos2::bound_rom(case, 6),
            Self::SphericalCos2Rom8 => spherical_cos2::bound_rom(case, 8),
            Self::SphericalCosN => spherical_cosn::bound(case),
            Self::Blake | Self::BlakeTrapezium => blake::bound(case),
            Self::BlakeRefit => blake::bound_refit(case),
            Self::Slerp => slerp::bound(case),
            Self::SlerpChebyshev => slerp::bound_chebyshev(case),
            Self::SlerpDeMoivre => slerp::bound_de_moivre(case),
            Self::SlerpTrigFree => slerp::bound_trig_free(case),
        })
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A name that is not in the catalogue.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("unknown {what} '{given}'; the nearest is '{nearest}' of {all}")]
pub struct UnknownName {
    /// What kind of name was expected.
    pub what: &'static str,
    /// What was typed.
    pub given: String,
    /// The known name with the least editing distance.
    pub nearest: String,
    /// Every known name.
    pub all: String,
}

impl UnknownName {
    /// Finds the nearest of `known`.
    #[must_use]
    pub fn new(what: &'static str, given: &str, known: &[&str]) -> Self {
        Self {
            what,
            given: given.to_owned(),
            nearest: nearest(given, known).unwrap_or_default().to_owned(),
            all: known.join(", "),
        }
    }
}

/// The known name with the least editing distance (Damerau–Levenshtein, case ignored); the first of equals.
#[must_use]
pub fn nearest<'a>(given: &str, known: &[&'a str]) -> Option<&'a str> {
    let given = given.to_lowercase();
    known
        .iter()
        .copied()
        .min_by_key(|k| strsim::damerau_levenshtein(&given, k))
}

impl FromStr for Method {
    type Err = UnknownName;

    fn from_str(s: &str) -> Result<Self, UnknownName> {
        Self::ALL
            .iter()
            .copied()
            .find(|m| m.name() == s)
            .ok_or_else(|| UnknownName::new("method", s, Self::NAMES))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_go_there_and_back() {
        for m in Method::ALL.iter().copied() {
            assert_eq!(m.to_string().parse(), Ok(m));
        }
    }

    #[test]
    fn an_unknown_name_is_answered_with_the_nearest() {
        let e = "quadratik".parse::<Method>().unwrap_err();
        let list = Method::NAMES.join(", ");
        assert_eq!(
            e.to_string(),
            format!("unknown method 'quadratik'; the nearest is 'quadratic' of {list}")
        );
    }
}
