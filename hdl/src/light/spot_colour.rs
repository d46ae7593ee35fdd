//! From the cosines of a pixel to its colour under a spot: limits, highlight, spot, three channels.
//!
//! What the spot sends scales both reflections, D·max(0, N·L) and D·κ(N·H − γ)^d, before they meet the colours of the
//! material: two multipliers, where scaling the light's colour would take one per channel and reflection. Words of the
//! material as in [`super::kappa_colour`]; bit 3 of word 9 chooses the hard fall-off.

use super::highlight::Highlight;
use super::spot::Spot;
use crate::format::{bit_cast_product, bit_cast_u, signed_cast_bits, Q, U};
use crate::shade::phong::reflect::Reflect;
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Latency: six clocks, [`super::STAGES`].
#[derive(LogicBlock)]
pub struct SpotColour {
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
    /// Place in the cone, in units of 2^-19, less or plus half of 2^-17.
    pub cone: Signal<In, Q<29, 0>>,
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
    /// The fall-off is the hard one.
    hard: Register<Bit>,
    /// max(0, N.L), at most 1.
    light_1: Register<U<18>>,
    /// The same, one clock later.
    light_2: Register<U<18>>,
    /// The same, two clocks later.
    light_3: Register<U<18>>,
    /// The same times the light of the spot.
    light_4: Register<U<18>>,
    /// The highlight times the light of the spot.
    gloss_4: Register<U<17>>,
    /// N.L times the light of the spot, whole.
    lit: Wire<U<35>>,
    /// The highlight as bits.
    gloss_bits: Wire<U<17>>,
    /// The highlight times the light of the spot, whole.
    glossed: Wire<U<34>>,
    /// The same with a sign bit.
    gloss_wide: Wire<U<18>>,
    /// The highlight as a number.
    gloss: Wire<Q<0, 17>>,
    /// N.L as a number.
    cosine: Wire<Q<1, 16>>,
    /// Bits of N.L at and above 1.
    above: Wire<U<2>>,
    /// The word of the curves is written.
    write_curve: Wire<Bit>,
    /// There is no light on the triangle.
    dark: Wire<Bit>,
    /// Power of N.H.
    power: Quiet<Highlight>,
    /// Light of the spot.
    spot: Quiet<Spot>,
    /// Red.
    red_sum: Quiet<Reflect>,
    /// Green.
    green_sum: Quiet<Reflect>,
    /// Blue.
    blue_sum: Quiet<Reflect>,
    /// 1 in units of 2^-16.
    full: Constant<U<18>>,
}

impl Default for SpotColour {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            go: Default::default(),
            write: Default::default(),
            word: Default::default(),
            data: Default::default(),
            light: Default::default(),
            place: Default::default(),
            cone: Default::default(),
            no_highlight: Default::default(),
            no_diffuse: Default::default(),
            red: Default::default(),
            green: Default::default(),
            blue: Default::default(),
            degree: Default::default(),
            hard: Default::default(),
            light_1: Default::default(),
            light_2: Default::default(),
            light_3: Default::default(),
            light_4: Default::default(),
            gloss_4: Default::default(),
            lit: Default::default(),
            gloss_bits: Default::default(),
            glossed: Default::default(),
            gloss_wide: Default::default(),
            gloss: Default::default(),
            cosine: Default::default(),
            above: Default::default(),
            write_curve: Default::default(),
            dark: Default::default(),
            power: Default::default(),
            spot: Default::default(),
            red_sum: Default::default(),
            green_sum: Default::default(),
            blue_sum: Default::default(),
            full: Constant::new(U::new(1 << 16)),
        }
    }
}

impl Logic for SpotColour {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name spot_colour");
        comment!("title The reflection model of one spot, per pixel, without tables.");
        comment!("equation colour = ambient + D (diffuse max(0, N.L) + specular kappa (N.H - gamma)^d) in each channel");
        comment!("source Phong 1975, Blinn 1977; highlight and spot D of Hast 2004, equations 3.276, 3.273 and 3.274.");
        comment!("latency Six clocks from the cosines to the colour; one colour per clock.");
        dff_setup!(self, clock, degree, hard, light_1, light_2, light_3, light_4, gloss_4);
        // Material.
        self.write_curve.next = self.write.val() && (self.word.val() == 9u64.into());
        if self.write_curve.val() {
            self.degree.d.next = self.data.val().get_bits::<3>(0);
            self.hard.d.next = self.data.val().get_bit(3);
        }

        self.dark.next = self.no_highlight.val() && self.no_diffuse.val();
        self.power.clock.next = self.clock.val();
        self.power.go.next = self.go.val();
        self.power.degree.next = self.degree.q.val();
        self.power.place.next = self.place.val();
        self.power.off.next = self.no_highlight.val();

        self.spot.clock.next = self.clock.val();
        self.spot.go.next = self.go.val();
        self.spot.hard.next = self.hard.q.val();
        self.spot.place.next = self.cone.val();
        self.spot.off.next = self.dark.val();

        self.lit.next = bit_cast_product::<35>(self.light_3.q.val() * self.spot.light.val());
        self.gloss_bits.next = self.power.highlight.val().get_bits::<17>(0);
        self.glossed.next = bit_cast_product::<34>(self.gloss_bits.val() * self.spot.light.val());

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
            self.light_4.d.next = self.lit.val().get_bits::<18>(17);
            self.gloss_4.d.next = self.glossed.val().get_bits::<17>(17);
            if self.spot.out.val() {
                self.light_4.d.next = 0u64.into();
            }
            if self.spot.out.val() || self.power.skip.val() {
                self.gloss_4.d.next = 0u64.into();
            }
        }
        self.gloss_wide.next = bit_cast_u::<18, 17>(self.gloss_4.q.val());
        self.gloss.next = signed_cast_bits::<0, 17, 18>(self.gloss_wide.val());
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

crate::clocked!(SpotColour;
    inputs go, write, word, data, light, place, cone, no_highlight, no_diffuse;
    outputs red, green, blue);
