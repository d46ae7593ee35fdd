//! The catalogue of shading methods that this crate draws, by the names users type.

use crate::shade::case::Case;
use crate::shade::{flat, gouraud, quadratic};
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
    Quadratic "quadratic" "quadratic interpolation of six colours (Abbas 2003 ch. 7; Hast 2004 §3.3)"
}

impl Method {
    /// The largest error against the truth, LSB, over all triangles, lights and materials of a case; `None` where
    /// nothing has been stated. The module of each method says whether its bound is proved or measured.
    #[must_use]
    pub fn bound(self, case: &Case) -> Option<f64> {
        Some(match self {
            // A bound of its own for every triangle: see `shade::bound`.
            Self::Auto => return None,
            Self::Exact => 0.0,
            Self::Flat => flat::bound(case),
            Self::Gouraud => gouraud::bound(case),
            Self::Quadratic => quadratic::bound(case),
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
