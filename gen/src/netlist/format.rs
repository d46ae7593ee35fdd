//! The format of a signal, recovered from rust-hdl's type descriptor.

use rust_hdl_core::type_descriptor::{TypeDescriptor, TypeKind};
use std::fmt;

/// Widest word of the netlist; the compiled simulation keeps a word in one machine value.
pub const MAX_WIDTH: usize = 128;

/// A signal's number format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// A clock: one bit whose rising edges load registers.
    Clock,
    /// One bit, true or false.
    Bit,
    /// Unsigned word of so many bits.
    Unsigned(usize),
    /// Signed integer of so many bits, sign included.
    Signed(usize),
    /// Signed fixed point: integer bits (without the sign) and fraction bits.
    Fixed(usize, usize),
    /// One of a list of names, as its number, in so many bits.
    Enumeration(usize),
    /// Several fields side by side, the first lowest, in so many bits.
    Structure(usize),
}

impl Format {
    /// The format of a type: rust-hdl's own, and the number types of the descriptions, which are called `U<n>` and
    /// `Q<m>.<n>`. `None` for a type that is none of these, or has no bits or more than [`MAX_WIDTH`].
    #[must_use]
    pub fn from_descriptor(descriptor: &TypeDescriptor) -> Option<Self> {
        let name = descriptor.name.as_str();
        let format = match &descriptor.kind {
            TypeKind::Enum(variants) => Self::Enumeration(enumeration_width(variants.len())),
            TypeKind::Composite(fields) => {
                let widths = fields
                    .iter()
                    .map(|f| Some(Self::from_descriptor(&f.kind)?.width()));
                Self::Structure(widths.sum::<Option<usize>>()?)
            }
            _ if name == "clock" => Self::Clock,
            TypeKind::Bits(1) if name == "Bit" => Self::Bit,
            TypeKind::Bits(n) => Self::Unsigned(*n),
            TypeKind::Signed(n) => match name.strip_prefix('Q').and_then(|d| d.split_once('.')) {
                Some((integer, fraction)) => {
                    let format = Self::Fixed(integer.parse().ok()?, fraction.parse().ok()?);
                    return (format.width() == *n && *n <= MAX_WIDTH).then_some(format);
                }
                None => Self::Signed(*n),
            },
        };
        (1..=MAX_WIDTH).contains(&format.width()).then_some(format)
    }

    /// Bits of the word.
    #[must_use]
    pub fn width(self) -> usize {
        match self {
            Self::Clock | Self::Bit => 1,
            Self::Unsigned(n) | Self::Signed(n) | Self::Enumeration(n) | Self::Structure(n) => n,
            Self::Fixed(m, n) => 1 + m + n,
        }
    }

    /// Whether the most significant bit is a sign.
    #[must_use]
    pub fn signed(self) -> bool {
        matches!(self, Self::Fixed(..) | Self::Signed(_))
    }

    /// The Verilog range with its sign, such as `signed [31:0] `; empty for one bit.
    #[must_use]
    pub fn range(self) -> String {
        match self {
            Self::Clock | Self::Bit => String::new(),
            Self::Signed(_) | Self::Fixed(..) => format!("signed [{}:0] ", self.width() - 1),
            _ => format!("[{}:0] ", self.width() - 1),
        }
    }
}

/// The code whose low bits, this many of at most [`MAX_WIDTH`], are all set.
pub(crate) fn ones(width: usize) -> u128 {
    match width {
        0 => 0,
        _ => u128::MAX >> (MAX_WIDTH - width),
    }
}

/// Bits that hold the numbers of so many names; rust-hdl's own rule.
fn enumeration_width(variants: usize) -> usize {
    rust_hdl_core::bits::clog2(variants)
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Clock => write!(f, "clock"),
            Self::Bit => write!(f, "bit"),
            Self::Unsigned(n) => write!(f, "U{n}"),
            Self::Signed(n) => write!(f, "S{n}"),
            Self::Fixed(m, n) => write!(f, "Q{m}.{n}"),
            Self::Enumeration(n) => write!(f, "enumeration of {n} bits"),
            Self::Structure(n) => write!(f, "structure of {n} bits"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rust_hdl_core::prelude::{Bits, Clock, Signed, Synth};
    use shadegate_hdl::format::{Q, U};

    #[test]
    fn types_name_formats() {
        let of = |d: TypeDescriptor| Format::from_descriptor(&d);
        assert_eq!(of(bool::descriptor()), Some(Format::Bit));
        assert_eq!(of(Clock::descriptor()), Some(Format::Clock));
        assert_eq!(of(U::<17>::descriptor()), Some(Format::Unsigned(17)));
        assert_eq!(of(Q::<11, 20>::descriptor()), Some(Format::Fixed(11, 20)));
        assert_eq!(of(Bits::<8>::descriptor()), Some(Format::Unsigned(8)));
        assert_eq!(of(Bits::<1>::descriptor()), Some(Format::Unsigned(1)));
        assert_eq!(of(Signed::<8>::descriptor()), Some(Format::Signed(8)));
        assert_eq!(of(Bits::<128>::descriptor()), Some(Format::Unsigned(128)));
        assert_eq!(of(Bits::<129>::descriptor()), None);
        assert_eq!(Format::Fixed(11, 20).range(), "signed [31:0] ");
    }
}
