//! One colour channel of the reflection model: its three material words and two multipliers.
//!
//! The words are not double-buffered: the host writes them behind a fence, when every pixel of the material before has
//! passed. The ambient word carries half an LSB for the final rounding.

use crate::format::{signed_cast_align, signed_cast_bits, signed_cast_product, Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Latency: two clocks.
#[derive(LogicBlock, Default)]
pub struct Reflect {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Writes the ambient colour, whether the stages move or not.
    pub write_ambient: Signal<In, Bit>,
    /// Writes the diffuse colour, likewise.
    pub write_diffuse: Signal<In, Bit>,
    /// Writes the specular colour, likewise.
    pub write_specular: Signal<In, Bit>,
    /// Register bus.
    pub data: Signal<In, U<32>>,
    /// max(0, N.L), at most 1.
    pub light: Signal<In, Q<1, 16>>,
    /// Power of max(0, N.H).
    pub power: Signal<In, Q<0, 17>>,
    /// Integer part of the colour, LSB.
    pub level: Signal<Out, Q<11, 0>>,
    /// Colour without any light, with half an LSB.
    ambient: Register<Q<11, 12>>,
    /// Colour of the diffuse reflection.
    diffuse: Register<Q<11, 6>>,
    /// Colour of the highlight.
    specular: Register<Q<11, 6>>,
    /// Colour without the highlight.
    matt_1: Register<Q<11, 12>>,
    /// The highlight.
    gloss_1: Register<Q<11, 12>>,
    /// The colour.
    colour_2: Register<Q<11, 12>>,
    /// Diffuse reflection.
    reflected: Wire<Q<11, 12>>,
}

impl Logic for Reflect {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name reflect");
        comment!("title One colour channel of the reflection model.");
        comment!("equation level = ambient + diffuse * max(0, N.L) + specular * max(0, N.H)^n");
        comment!(
            "source Phong 1975 with the half-way vector of Blinn 1977; Abbas 2003, chapter 5."
        );
        comment!("latency Two clocks from light and power to level; one level per clock.");
        dff_setup!(self, clock, ambient, diffuse, specular, matt_1, gloss_1, colour_2);
        if self.write_ambient.val() {
            self.ambient.d.next = signed_cast_bits::<11, 12, 32>(self.data.val());
        }
        if self.write_diffuse.val() {
            self.diffuse.d.next = signed_cast_bits::<11, 6, 32>(self.data.val());
        }
        if self.write_specular.val() {
            self.specular.d.next = signed_cast_bits::<11, 6, 32>(self.data.val());
        }
        self.reflected.next =
            signed_cast_product::<11, 12>(self.diffuse.q.val() * self.light.val());
        if self.go.val() {
            self.matt_1.d.next = self.ambient.q.val() + self.reflected.val();
            self.gloss_1.d.next =
                signed_cast_product::<11, 12>(self.specular.q.val() * self.power.val());
            self.colour_2.d.next = self.matt_1.q.val() + self.gloss_1.q.val();
        }
        self.level.next = signed_cast_align::<11, 0, 11, 12>(self.colour_2.q.val());
    }
}

crate::clocked!(Reflect;
    inputs go, write_ambient, write_diffuse, write_specular, data, light, power;
    outputs level);
