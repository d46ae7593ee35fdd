//! What a depth word measures: a choice of the host, the core compares whatever it is given.
//!
//! A core walks depth as a plane over the screen. With perspective 1/w is such a plane (w the distance from the eye along
//! the view), so depths from 1/w are exact at every pixel and triangles hide each other as they do in space. Depths from w
//! itself are exact at the corners, and along an edge the same for both triangles that share it; inside, a plane through
//! them lies too far away: between corners at w₀ and w₁, halfway on the screen, (w₀ + w₁)/2 for 2·w₀·w₁/(w₀ + w₁). So
//! faces that meet at their edges still hide each other rightly where their order at the corners tells it, but faces that
//! pierce each other do so in the wrong place. In exchange words are spread evenly over the depth of the scene: a step of
//! 1/w is (w/w₀)² times as deep at w as at the nearest w₀.
//! Without perspective depth is a plane over the screen, and both formats are the same.

use crate::stimulus::Triangle;
use shadegate_reference::{depth, Prepared};
use std::fmt;
use std::str::FromStr;

/// What a depth word is linear in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum DepthFormat {
    /// 1/w: exact on the screen.
    #[default]
    Reciprocal,
    /// w: evenly spread over the scene, exact at corners.
    Linear,
}

impl DepthFormat {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Reciprocal, Self::Linear];

    /// Name, as users type it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Reciprocal => "1/z",
            Self::Linear => "z",
        }
    }

    /// Gives the triangles of a prepared scene depths of this format: 1 the farthest corner of the scene, 65535 the
    /// nearest.
    pub fn apply(self, p: &Prepared, triangles: &mut [Triangle]) {
        if self == Self::Reciprocal {
            return;
        }
        let corners = || p.triangles.iter().flat_map(|t| t.inv_w);
        let (far, near) = (
            1.0 / corners().fold(f64::INFINITY, f64::min),
            1.0 / corners().fold(0.0, f64::max),
        );
        // Without perspective all are 1, and the depths are what they should be.
        if far > near {
            for (to, t) in triangles.iter_mut().zip(&p.triangles) {
                let nearness = |inv_w: f64| ((far - 1.0 / inv_w) / (far - near)).clamp(0.0, 1.0);
                to.depth = t.inv_w.map(|q| depth::scaled(nearness(q)));
            }
        }
    }
}

impl fmt::Display for DepthFormat {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A name that is no depth format.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("no depth format is called '{0}'; expected 1/z or z")]
pub struct UnknownDepthFormat(String);

impl FromStr for DepthFormat {
    type Err = UnknownDepthFormat;

    fn from_str(name: &str) -> Result<Self, UnknownDepthFormat> {
        let found = Self::ALL.into_iter().find(|f| f.name() == name);
        found.ok_or_else(|| UnknownDepthFormat(name.to_owned()))
    }
}
