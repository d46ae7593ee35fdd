//! A shaded colour that waits for the perspective division: three stages that move with `go`.

use crate::format::Q;
use crate::simulate::Register;
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Stages of one [`ColourDelay`].
pub const STAGES: usize = 3;

/// Latency: three clocks.
#[derive(LogicBlock, Default)]
pub struct ColourDelay {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Red, in units of 1/64 LSB.
    pub red: Signal<In, Q<17, 0>>,
    /// Green likewise.
    pub green: Signal<In, Q<17, 0>>,
    /// Blue likewise.
    pub blue: Signal<In, Q<17, 0>>,
    /// Red of three clocks ago.
    pub late_red: Signal<Out, Q<17, 0>>,
    /// Green of three clocks ago.
    pub late_green: Signal<Out, Q<17, 0>>,
    /// Blue of three clocks ago.
    pub late_blue: Signal<Out, Q<17, 0>>,
    /// Red, stage 1.
    red_1: Register<Q<17, 0>>,
    /// Green.
    green_1: Register<Q<17, 0>>,
    /// Blue.
    blue_1: Register<Q<17, 0>>,
    /// Red, stage 2.
    red_2: Register<Q<17, 0>>,
    /// Green.
    green_2: Register<Q<17, 0>>,
    /// Blue.
    blue_2: Register<Q<17, 0>>,
    /// Red, stage 3.
    red_3: Register<Q<17, 0>>,
    /// Green.
    green_3: Register<Q<17, 0>>,
    /// Blue.
    blue_3: Register<Q<17, 0>>,
}

impl Logic for ColourDelay {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name colour_delay");
        comment!("title A shaded colour while its texture address is worked out: three stages.");
        comment!("equation late = colour of three moves ago");
        comment!("source Pipeline registers.");
        comment!("latency Three clocks.");
        dff_setup!(
            self, clock, red_1, green_1, blue_1, red_2, green_2, blue_2, red_3, green_3, blue_3
        );
        if self.go.val() {
            self.red_1.d.next = self.red.val();
            self.green_1.d.next = self.green.val();
            self.blue_1.d.next = self.blue.val();
            self.red_2.d.next = self.red_1.q.val();
            self.green_2.d.next = self.green_1.q.val();
            self.blue_2.d.next = self.blue_1.q.val();
            self.red_3.d.next = self.red_2.q.val();
            self.green_3.d.next = self.green_2.q.val();
            self.blue_3.d.next = self.blue_2.q.val();
        }
        self.late_red.next = self.red_3.q.val();
        self.late_green.next = self.green_3.q.val();
        self.late_blue.next = self.blue_3.q.val();
    }
}

crate::clocked!(ColourDelay;
    inputs go, red, green, blue;
    outputs late_red, late_green, late_blue);
