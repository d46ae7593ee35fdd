//! A cosine as a factor: cut to 0..=1, since light does not come from behind, and since the last bit of a recurrence
//! may be beyond 1.

use super::{FACTOR_STAGES, UNIT};
use crate::format::{Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Latency: three clocks with `go`.
#[derive(LogicBlock)]
pub struct ClampFactor {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move.
    pub go: Signal<In, Bit>,
    /// Value, in units of 1/65536.
    pub value: Signal<In, Q<17, 0>>,
    /// Factor, 65536 is 1.
    pub factor: Signal<Out, U<17>>,
    /// Factor in the first stage.
    first: Register<U<17>>,
    /// Factor in the second stage.
    second: Register<U<17>>,
    /// Factor in the third stage.
    third: Register<U<17>>,
    /// Value cut to 0 to 65536.
    cut: Wire<U<17>>,
    /// No light.
    zero: Constant<U<17>>,
    /// All light.
    unit: Constant<U<17>>,
}

impl Default for ClampFactor {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            go: Default::default(),
            value: Default::default(),
            factor: Default::default(),
            first: Default::default(),
            second: Default::default(),
            third: Default::default(),
            cut: Default::default(),
            zero: Constant::new(U::new(0)),
            unit: Constant::new(U::new(UNIT)),
        }
    }
}

impl Logic for ClampFactor {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name clamp_factor");
        comment!("title Cuts a cosine to 0..1 and keeps it for three stages.");
        comment!("equation factor = min(max(value, 0), 1)");
        comment!("source Abbas 2003, section 3.3: no light from behind.");
        comment!("latency Three clocks with go.");
        dff_setup!(self, clock, first, second, third);
        if self.value.val().get_bit(17) {
            self.cut.next = self.zero.val();
        } else if self.value.val().get_bit(16) {
            self.cut.next = self.unit.val();
        } else {
            self.cut.next = self.value.val().get_bits::<17>(0);
        }
        if self.go.val() {
            self.first.d.next = self.cut.val();
            self.second.d.next = self.first.q.val();
            self.third.d.next = self.second.q.val();
        }
        self.factor.next = self.third.q.val();
    }
}

crate::clocked!(ClampFactor;
    inputs go, value;
    outputs factor);

/// Integer model of [`ClampFactor`].
#[derive(Clone, Copy, Debug, Default)]
pub struct ClampFactorModel {
    stages: [u64; FACTOR_STAGES],
}

impl ClampFactorModel {
    /// The factor of the third stage.
    #[must_use]
    pub fn factor(&self) -> u64 {
        self.stages[FACTOR_STAGES - 1]
    }

    /// One clock; `value` in units of 1/65536.
    pub fn clock(&mut self, go: bool, value: i64) {
        if go {
            let [first, second, _] = self.stages;
            self.stages = [value.clamp(0, UNIT as i64) as u64, first, second];
        }
    }
}
