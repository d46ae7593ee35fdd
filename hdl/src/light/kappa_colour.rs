//! From the cosines of a pixel to its colour: limits, highlight, three channels, and the material words they take.
//!
//! Words of the material: 0, 1, 2 ambient, diffuse and specular colour of red, 3, 4, 5 of green, 6, 7, 8 of blue; 9 the
//! degree of the highlight (bits 2 to 0). They take effect at once: the host writes them behind a fence (see the core).

use super::highlight::Highlight;
use crate::format::{signed_cast_bits, Q, U};
use crate::shade::phong::reflect::Reflect;
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Latency: six clocks, [`super::STAGES`].
#[derive(LogicBlock)]
pub struct KappaColour {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Writes `data` to a word of the material, whether the stages move or not.
    pub write: Signal<In, Bit>,
    /// Word of the material.
    pub word: Signal<In, U<4>>,
    /// Register bus.
    pub data: Signal<In, U<32>>,
    /// N.L, in units of 2^-16, with half a unit added.
    pub light: Signal<In, Q<18, 0>>,
    /// Place in the lobe, in units of 2^-19, less half of 2^-17.
    pub place: Signal<In, Q<29, 0>>,
    /// The triangle has no highlight.
    pub no_highlight: Signal<In, Bit>,
    /// The triangle has no diffuse reflection.
    pub no_diffuse: Signal<In, Bit>,
    /// Red of six clocks ago, LSB.
    pub red: Signal<Out, Q<11, 0>>,
    /// Green.
    pub green: Signal<Out, Q<11, 0>>,
    /// Blue.
    pub blue: Signal<Out, Q<11, 0>>,
    /// Degree of the highlight.
    degree: Register<U<3>>,
    /// max(0, N.L), at most 1.
    light_1: Register<U<18>>,
    /// The same, one clock later.
    light_2: Register<U<18>>,
    /// The same, two clocks later.
    light_3: Register<U<18>>,
    /// The same, three clocks later.
    light_4: Register<U<18>>,
    /// The highlight, one clock later.
    gloss_4: Register<Q<0, 17>>,
    /// The highlight that goes to the channels.
    gloss: Wire<Q<0, 17>>,
    /// N.L as a number.
    cosine: Wire<Q<1, 16>>,
    /// Bits of N.L at and above 1.
    above: Wire<U<2>>,
    /// The word of the curves is written.
    write_curve: Wire<Bit>,
    /// Power of N.H.
    power: Quiet<Highlight>,
    /// Red.
    red_sum: Quiet<Reflect>,
    /// Green.
    green_sum: Quiet<Reflect>,
    /// Blue.
    blue_sum: Quiet<Reflect>,
    /// 1 in units of 2^-16.
    full: Constant<U<18>>,
}

impl Default for KappaColour {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            go: Default::default(),
            write: Default::default(),
            word: Default::default(),
            data: Default::default(),
            light: Default::default(),
            place: Default::default(),
            no_highlight: Default::default(),
            no_diffuse: Default::default(),
            red: Default::default(),
            green: Default::default(),
            blue: Default::default(),
            degree: Default::default(),
            light_1: Default::default(),
            light_2: Default::default(),
            light_3: Default::default(),
            light_4: Default::default(),
            gloss_4: Default::default(),
            gloss: Default::default(),
            cosine: Default::default(),
            above: Default::default(),
            write_curve: Default::default(),
            power: Default::default(),
            red_sum: Default::default(),
            green_sum: Default::default(),
            blue_sum: Default::default(),
            full: Constant::new(U::new(1 << 16)),
        }
    }
}

impl Logic for KappaColour {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name kappa_colour");
        comment!("title The reflection model of one light, per pixel, without tables.");
        comment!("equation colour = ambient + diffuse max(0, N.L) + specular kappa (N.H - gamma)^d in each channel");
        comment!("source Phong 1975, Blinn 1977; highlight of Hast 2004, equation 3.276.");
        comment!("latency Six clocks from the cosines to the colour; one colour per clock.");
        dff_setup!(self, clock, degree, light_1, light_2, light_3, light_4, gloss_4);
        // Material.
        self.write_curve.next = self.write.val() && (self.word.val() == 9u64.into());
        if self.write_curve.val() {
            self.degree.d.next = self.data.val().get_bits::<3>(0);
        }

        self.power.clock.next = self.clock.val();
        self.power.go.next = self.go.val();
        self.power.degree.next = self.degree.q.val();
        self.power.place.next = self.place.val();
        self.power.off.next = self.no_highlight.val();

        // Limits.
        self.above.next = self.light.val().get_bits::<2>(16);
        if self.go.val() {
            self.light_1.d.next = self.light.val().get_bits::<18>(0);
            if self.light.val().get_bit(18) || self.no_diffuse.val() {
                self.light_1.d.next = 0u64.into();
            } else if self.above.val().any() {
                self.light_1.d.next = self.full.val();
            }
            self.light_2.d.next = self.light_1.q.val();
            self.light_3.d.next = self.light_2.q.val();
            self.light_4.d.next = self.light_3.q.val();
            self.gloss_4.d.next = self.power.highlight.val();
        }
        self.gloss.next = self.gloss_4.q.val();
        self.cosine.next = signed_cast_bits::<1, 16, 18>(self.light_4.q.val());

        self.red_sum.clock.next = self.clock.val();
        self.red_sum.go.next = self.go.val();
        self.red_sum.write_ambient.next = self.write.val() && (self.word.val() == 0u64.into());
        self.red_sum.write_diffuse.next = self.write.val() && (self.word.val() == 1u64.into());
        self.red_sum.write_specular.next = self.write.val() && (self.word.val() == 2u64.into());
        self.red_sum.data.next = self.data.val();
        self.red_sum.light.next = self.cosine.val();
        self.red_sum.power.next = self.gloss.val();

        self.green_sum.clock.next = self.clock.val();
        self.green_sum.go.next = self.go.val();
        self.green_sum.write_ambient.next = self.write.val() && (self.word.val() == 3u64.into());
        self.green_sum.write_diffuse.next = self.write.val() && (self.word.val() == 4u64.into());
        self.green_sum.write_specular.next = self.write.val() && (self.word.val() == 5u64.into());
        self.green_sum.data.next = self.data.val();
        self.green_sum.light.next = self.cosine.val();
        self.green_sum.power.next = self.gloss.val();

        self.blue_sum.clock.next = self.clock.val();
        self.blue_sum.go.next = self.go.val();
        self.blue_sum.write_ambient.next = self.write.val() && (self.word.val() == 6u64.into());
        self.blue_sum.write_diffuse.next = self.write.val() && (self.word.val() == 7u64.into());
        self.blue_sum.write_specular.next = self.write.val() && (self.word.val() == 8u64.into());
        self.blue_sum.data.next = self.data.val();
        self.blue_sum.light.next = self.cosine.val();
        self.blue_sum.power.next = self.gloss.val();

        self.red.next = self.red_sum.level.val();
        self.green.next = self.green_sum.level.val();
        self.blue.next = self.blue_sum.level.val();
    }
}

crate::clocked!(KappaColour;
    inputs go, write, word, data, light, place, no_highlight, no_diffuse;
    outputs red, green, blue);
