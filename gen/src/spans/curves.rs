//! What the tables of a spherical core hold for a material, and how angles address them.

use shadegate_hdl::shade::span_core::SpanKind;
use shadegate_reference::shade::curve::rom::Sample;
use shadegate_reference::shade::curve::{power, Cos2, Curve, Rom};
use std::f64::consts::FRAC_PI_2;

/// cosⁿ is cut where it falls to this, a quarter of an LSB below the rounding of 8 bits.
const CUT: f64 = 1.0 / 512.0;

/// A function in a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// cos.
    Cosine,
    /// cos².
    Square,
    /// cosⁿ.
    Power(f64),
}

impl Shape {
    /// Its value at an angle from 0 on.
    #[must_use]
    pub fn at(self, x: f64) -> f64 {
        match self {
            Self::Cosine => x.cos().max(0.0),
            Self::Square => x.cos().powi(2),
            Self::Power(n) => power(x, n),
        }
    }
}

/// One table with its scale.
#[derive(Clone, Debug)]
pub struct Curves {
    /// What is in the table.
    pub shape: Shape,
    /// Angle where the table ends.
    pub range: f64,
    /// What an angle is multiplied by before it addresses the table.
    pub scale: f64,
    /// Address and data bits.
    pub bits: u32,
}

impl Curves {
    /// The table of the diffuse term.
    #[must_use]
    pub fn diffuse(bits: usize) -> Self {
        Self::quarter(Shape::Cosine, 1.0, bits)
    }

    fn quarter(shape: Shape, scale: f64, bits: usize) -> Self {
        Self {
            shape,
            range: FRAC_PI_2,
            scale,
            bits: bits as u32,
        }
    }

    /// The table of a highlight of exponent `n`: cos² scaled by a(n) of Abbas' equation 6.12 (cosⁿ below n = 2, which
    /// cos² cannot take the place of), or cosⁿ itself over the angles where it shows.
    #[must_use]
    pub fn highlight(kind: SpanKind, n: f64) -> Self {
        match kind {
            SpanKind::SphericalPower(bits) => Self {
                range: if n > 0.0 {
                    CUT.powf(1.0 / n).acos()
                } else {
                    FRAC_PI_2
                },
                ..Self::quarter(Shape::Power(n), 1.0, bits)
            },
            SpanKind::Spherical(bits) => match Cos2::new(n).a() {
                Some(a) => Self::quarter(Shape::Square, a, bits),
                None => Self::quarter(Shape::Power(n), 1.0, bits),
            },
            _ => Self::quarter(Shape::Power(n), 1.0, 8),
        }
    }

    /// Words of the table per radian of the angle.
    #[must_use]
    pub fn density(&self) -> f64 {
        f64::from(1u32 << self.bits) / self.range * self.scale
    }

    /// The word at an address: the value in the middle of its bin.
    #[must_use]
    pub fn word(&self, address: u32) -> u64 {
        let bin = self.range / f64::from(1u32 << self.bits);
        let full = f64::from((1u32 << self.bits) - 1);
        let value = self.shape.at((f64::from(address) + 0.5) * bin);
        (value.clamp(0.0, 1.0) * full).round() as u64
    }

    /// The table as the software methods have it.
    #[must_use]
    pub fn rom(&self) -> Rom {
        Rom::new(self.bits, self.bits, self.range, Sample::Centre, |x| {
            self.shape.at(x)
        })
    }
}

impl Curve for Curves {
    fn at(&self, x: f64) -> f64 {
        let x = x.abs() * self.scale;
        if x < self.range {
            self.shape.at(x)
        } else {
            0.0
        }
    }
}
