//! N·L and the place in the lobe for a normal that is not normalised: one root for both cosines.

use super::cosine::Cosine;
use super::inverse_root::InverseRoot;
use super::lobe_place::LobePlace;
use crate::format::{Q, U};
use crate::simulate::{Quiet, Register};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Clocks from the dot products to the arguments of the reflection model.
pub const STAGES: usize = 9;
/// Fraction bits of the dot products and of the squared length.
pub const FRACTION_BITS: usize = 28;
/// Their integer bits.
pub const INTEGER_BITS: usize = 1;
/// Register word of the scale of the lobe, among those of the material.
pub const SCALE_WORD: usize = 11;
/// Largest s for which the highlight stays within half an LSB.
pub const MAX_SCALE: u32 = 5;
/// Largest exponent, with that s.
pub const MAX_EXPONENT: f64 = 600.0;

/// Latency: nine clocks.
#[derive(LogicBlock, Default)]
pub struct UnitCosines {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Writes the scale, whether the stages move or not.
    pub write_scale: Signal<In, Bit>,
    /// Scale s of the lobe.
    pub scale: Signal<In, U<3>>,
    /// N.L of the normal as it is, in units of 2^-28.
    pub light_dot: Signal<In, Q<29, 0>>,
    /// N.H likewise.
    pub half_dot: Signal<In, Q<29, 0>>,
    /// N.N likewise.
    pub square: Signal<In, Q<29, 0>>,
    /// N.L of the unit normal of nine clocks ago, in units of 2^-16.
    pub light: Signal<Out, Q<18, 0>>,
    /// Its place in the lobe, in units of 2^-19.
    pub place: Signal<Out, Q<29, 0>>,
    /// Scale s of the lobe.
    held_scale: Register<U<3>>,
    /// One over the length of the normal.
    inverse_root: Quiet<InverseRoot>,
    /// N.L of the unit normal.
    light_cosine: Quiet<Cosine>,
    /// N.H of the unit normal.
    half_cosine: Quiet<Cosine>,
    /// Arguments of the reflection model.
    arguments: Quiet<LobePlace>,
}

impl Logic for UnitCosines {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name unit_cosines");
        comment!("title N.L and the place in the lobe for a normal that is not normalised.");
        comment!("equation light = p / sqrt(q); place = (1 - h / sqrt(q)) 2^s");
        comment!("source Duff 1979; Hast 2004, equation 2.44.");
        comment!("latency Nine clocks.");
        dff_setup!(self, clock, held_scale);
        if self.write_scale.val() {
            self.held_scale.d.next = self.scale.val();
        }
        self.inverse_root.clock.next = self.clock.val();
        self.inverse_root.go.next = self.go.val();
        self.inverse_root.square.next = self.square.val();

        self.light_cosine.clock.next = self.clock.val();
        self.light_cosine.go.next = self.go.val();
        self.light_cosine.dot.next = self.light_dot.val();
        self.light_cosine.root.next = self.inverse_root.root.val();
        self.light_cosine.once.next = self.inverse_root.once.val();
        self.light_cosine.twice.next = self.inverse_root.twice.val();

        self.half_cosine.clock.next = self.clock.val();
        self.half_cosine.go.next = self.go.val();
        self.half_cosine.dot.next = self.half_dot.val();
        self.half_cosine.root.next = self.inverse_root.root.val();
        self.half_cosine.once.next = self.inverse_root.once.val();
        self.half_cosine.twice.next = self.inverse_root.twice.val();

        self.arguments.clock.next = self.clock.val();
        self.arguments.go.next = self.go.val();
        self.arguments.light_cosine.next = self.light_cosine.cosine.val();
        self.arguments.half_cosine.next = self.half_cosine.cosine.val();
        self.arguments.scale.next = self.held_scale.q.val();
        self.light.next = self.arguments.light.val();
        self.place.next = self.arguments.place.val();
    }
}

crate::clocked!(UnitCosines;
    inputs go, write_scale, scale, light_dot, half_dot, square;
    outputs light, place);
