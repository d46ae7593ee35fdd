//! The format of a signal, recovered from rust-hdl's type descriptor.

use std::fmt;

/// A signal's number format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// One bit, true or false (also the clock).
    Bit,
    /// Unsigned word of so many bits.
    Unsigned(usize),
    /// Signed fixed point: integer bits (without the sign) and fraction bits.
    Fixed(usize, usize),
}

impl Format {
    /// The format a descriptor names: `Bit`, `clock`, `U<n>` or `Q<m>.<n>`.
    pub fn from_descriptor(name: &str) -> Option<Self> {
        if name == "Bit" || name == "clock" {
            return Some(Self::Bit);
        }
        if let Some(n) = name.strip_prefix('U') {
            return n.parse().ok().map(Self::Unsigned);
        }
        let (m, n) = name.strip_prefix('Q')?.split_once('.')?;
        Some(Self::Fixed(m.parse().ok()?, n.parse().ok()?))
    }

    /// Bits of the word.
    pub fn width(self) -> usize {
        match self {
            Self::Bit => 1,
            Self::Unsigned(n) => n,
            Self::Fixed(m, n) => 1 + m + n,
        }
    }

    /// Whether the most significant bit is a sign.
    pub fn signed(self) -> bool {
        matches!(self, Self::Fixed(..))
    }

    /// The Verilog range with its sign, such as `signed [31:0] `; empty for one bit.
    pub fn range(self) -> String {
        match self {
            Self::Bit => String::new(),
            Self::Unsigned(n) => format!("[{}:0] ", n - 1),
            Self::Fixed(..) => format!("signed [{}:0] ", self.width() - 1),
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bit => write!(f, "bit"),
            Self::Unsigned(n) => write!(f, "U{n}"),
            Self::Fixed(m, n) => write!(f, "Q{m}.{n}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn descriptors_name_formats() {
        assert_eq!(Format::from_descriptor("Bit"), Some(Format::Bit));
        assert_eq!(Format::from_descriptor("clock"), Some(Format::Bit));
        assert_eq!(Format::from_descriptor("U17"), Some(Format::Unsigned(17)));
        assert_eq!(
            Format::from_descriptor("Q11.20"),
            Some(Format::Fixed(11, 20))
        );
        assert_eq!(Format::from_descriptor("Bits::<8>"), None);
        assert_eq!(Format::from_descriptor("Signed::<8>"), None);
        assert_eq!(Format::Fixed(11, 20).range(), "signed [31:0] ");
    }
}
