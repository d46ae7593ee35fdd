//! Colour output: the integer part of a colour word, clamped to 0..=255.
//!
//! A six-knot colour leaves the range of its knots by up to a third (basis functions sum to 4/3 and −1/3), so the clamp
//! behind the accumulator is part of the method; Abbas' appendix omits it. The half LSB for rounding to nearest is added
//! once, to the start value.

use crate::format::{Q, U};
use crate::simulate::Wire;
use rust_hdl_core::prelude::*;

/// Combinational.
#[derive(LogicBlock)]
pub struct Saturate {
    /// Integer part of the colour in LSB, with half an LSB already added.
    pub value: Signal<In, Q<11, 0>>,
    /// Colour as a byte.
    pub level: Signal<Out, U<8>>,
    /// Integer bits above a byte.
    excess: Wire<U<3>>,
    /// Darkest byte.
    zero: Constant<U<8>>,
    /// Brightest byte.
    full: Constant<U<8>>,
}

impl Default for Saturate {
    fn default() -> Self {
        Self {
            value: Default::default(),
            level: Default::default(),
            excess: Default::default(),
            zero: Constant::new(U::new(0)),
            full: Constant::new(U::new(255)),
        }
    }
}

impl Logic for Saturate {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name saturate");
        comment!("title Clamps the integer part of a colour to a byte.");
        comment!("equation level = min(max(value, 0), 255)");
        comment!("source A six-knot colour leaves its knots by up to a third; Abbas 2003, appendix, has no clamp.");
        comment!("latency Combinational.");
        self.excess.next = self.value.val().get_bits::<3>(8);
        if self.value.val().get_bit(11) {
            self.level.next = self.zero.val();
        } else if self.excess.val().any() {
            self.level.next = self.full.val();
        } else {
            self.level.next = self.value.val().get_bits::<8>(0);
        }
    }
}

crate::ports!(Saturate;
    inputs value;
    outputs level);

/// Integer model of [`Saturate`].
#[must_use]
pub fn saturate_model(value: i64) -> u8 {
    value.clamp(0, 255) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_integer_part() {
        let mut design = Saturate::default();
        design.connect_all();
        check_all(&design).expect("connected");
        for code in -(1i64 << 11)..1 << 11 {
            design.value.next = Q::from_code(code);
            assert!(simulate(&mut design, 20));
            assert_eq!(
                design.level.val().get(),
                u64::from(saturate_model(code)),
                "code {code}"
            );
        }
    }
}
