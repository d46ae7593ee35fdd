//! From the least to the greatest of some numbers.

/// An interval, both ends included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Least.
    pub least: f64,
    /// Greatest.
    pub most: f64,
}

impl Range {
    /// Of no numbers: joined with anything it is that.
    pub const NONE: Self = Self {
        least: f64::INFINITY,
        most: f64::NEG_INFINITY,
    };

    /// With one more number in it.
    #[must_use]
    pub fn with(self, v: f64) -> Self {
        Self {
            least: self.least.min(v),
            most: self.most.max(v),
        }
    }

    /// Of the numbers of both.
    #[must_use]
    pub fn join(self, other: Self) -> Self {
        Self {
            least: self.least.min(other.least),
            most: self.most.max(other.most),
        }
    }

    /// Whether it is of no numbers.
    #[must_use]
    pub fn is_none(self) -> bool {
        self.least > self.most
    }
}
