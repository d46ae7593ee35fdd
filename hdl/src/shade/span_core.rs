//! The span cores as one type: which datapath, which tables.

use super::blake::BlakeCore;
use super::chebyshev::ChebyshevCore;
use super::device::{laned, Core, DesignVisitor};
use super::slerp::SlerpCore;
use super::span_bound::error_bound;
use super::spherical::SphericalCore;

/// Which span core.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SpanKind {
    /// Cosines by differences, power by chords.
    Slerp,
    /// Cosines by Chebyshev's recurrence, power by chords.
    Chebyshev,
    /// Tables of this many address and data bits, 4 to 10, at evenly growing angles: cos and cos².
    Spherical(usize),
    /// The same core whose host writes cosⁿ of the material.
    SphericalPower(usize),
    /// Quadratic pieces with the printed coefficients.
    Blake,
    /// The same core whose host takes refitted coefficients.
    BlakeRefit,
    /// The same core whose host finds the ends of spans by way of trapezia, with the printed coefficients.
    BlakeTrapezium,
}

/// Spherical core with tables of 4 bits.
pub type Spherical4<const A: usize> = SphericalCore<A, 4, 10, 22, 6>;
/// Spherical core with tables of 5 bits.
pub type Spherical5<const A: usize> = SphericalCore<A, 5, 11, 23, 7>;
/// Spherical core with tables of 6 bits.
pub type Spherical6<const A: usize> = SphericalCore<A, 6, 12, 24, 8>;
/// Spherical core with tables of 7 bits.
pub type Spherical7<const A: usize> = SphericalCore<A, 7, 13, 25, 9>;
/// Spherical core with tables of 8 bits.
pub type Spherical8<const A: usize> = SphericalCore<A, 8, 14, 26, 10>;
/// Spherical core with tables of 9 bits.
pub type Spherical9<const A: usize> = SphericalCore<A, 9, 15, 27, 11>;
/// Spherical core with tables of 10 bits.
pub type Spherical10<const A: usize> = SphericalCore<A, 10, 16, 28, 12>;

impl SpanKind {
    /// Name of the core in the catalogue.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Slerp => "slerp",
            Self::Chebyshev => "chebyshev",
            Self::Spherical(_) | Self::SphericalPower(_) => "spherical",
            Self::Blake | Self::BlakeRefit | Self::BlakeTrapezium => "blake",
        }
    }

    /// Largest arithmetic error of a colour before the final rounding, LSB, on spans of up to `run` pixels.
    #[must_use]
    pub fn error_bound(self, run: u32) -> f64 {
        error_bound(self, run)
    }

    /// Calls `f` with the description for frame addresses of `A` bits.
    pub(super) fn with_design<const A: usize, R>(self, core: &Core, f: impl DesignVisitor<R>) -> R {
        match self {
            Self::Slerp => laned!(core, f, SlerpCore<A>),
            Self::Chebyshev => laned!(core, f, ChebyshevCore<A>),
            Self::Blake | Self::BlakeRefit | Self::BlakeTrapezium => {
                laned!(core, f, BlakeCore<A>)
            }
            Self::Spherical(bits) | Self::SphericalPower(bits) => match bits {
                0..=4 => laned!(core, f, Spherical4<A>),
                5 => laned!(core, f, Spherical5<A>),
                6 => laned!(core, f, Spherical6<A>),
                7 => laned!(core, f, Spherical7<A>),
                8 => laned!(core, f, Spherical8<A>),
                9 => laned!(core, f, Spherical9<A>),
                _ => laned!(core, f, Spherical10<A>),
            },
        }
    }
}
