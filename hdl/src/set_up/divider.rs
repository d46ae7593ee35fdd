//! The divider.

use super::instruction::Division;
use super::schedule::steps;

/// Integer model of the divider.
#[derive(Clone, Copy, Debug, Default)]
pub struct DividerModel {
    rest: u64,
    divisor: u64,
    /// The quotient so far.
    pub quotient: u64,
    /// Zeros before the first one of a reciprocal.
    pub exponent: u8,
    left: u8,
    normal: bool,
}

impl DividerModel {
    /// What a whole division leaves.
    #[must_use]
    pub fn remainder(&self) -> i64 {
        (self.rest >> 14) as i64
    }

    /// One clock: x, y, kind.
    pub fn clock(&mut self, start: Option<(i64, i64, Division)>) {
        const MASK: u64 = (1 << 48) - 1;
        if let Some((x, y, kind)) = start {
            let y = y as u64;
            (self.rest, self.divisor) = match kind {
                Division::Whole => ((x as u64).wrapping_add(y << 12), y << 13),
                _ => (1, y),
            };
            self.rest &= MASK;
            self.divisor &= MASK;
            self.quotient = 0;
            self.left = steps(kind) as u8;
            self.normal = kind == Division::Reciprocal;
            if self.normal {
                self.exponent = 0;
            }
        } else if self.left > 0 {
            let fits = self.rest >= self.divisor;
            let rest = self.rest.wrapping_sub(if fits { self.divisor } else { 0 });
            self.rest = rest << 1 & MASK;
            let full = self.normal && self.quotient >> 23 & 1 == 1;
            if !full {
                self.quotient = (self.quotient << 1 | u64::from(fits)) & ((1 << 44) - 1);
                if self.normal && self.quotient == 0 {
                    self.exponent = (self.exponent + 1) & 63;
                }
            }
            self.left -= 1;
        }
    }
}
