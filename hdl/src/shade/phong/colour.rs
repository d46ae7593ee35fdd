//! From the cosines of a pixel to its colour: limits, power, three channels, and the material words they take.
//!
//! Words of the material: 0, 1, 2 ambient, diffuse and specular colour of red, 3, 4, 5 of green, 6, 7, 8 of blue; 9 an
//! interval of the power table, 10 the word of that interval, after which the next one is meant. They take effect at
//! once: the host writes them behind a fence (see the core).

use super::power::Power;
use super::reflect::Reflect;
use crate::format::{signed_cast_bits, Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Latency: six clocks, [`super::STAGES`].
#[derive(LogicBlock)]
pub struct PhongColour {
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
    /// Place in the lobe, in units of 2^-19, with half a unit added.
    pub place: Signal<In, Q<29, 0>>,
    /// Red of six clocks ago, LSB.
    pub red: Signal<Out, Q<11, 0>>,
    /// Green.
    pub green: Signal<Out, Q<11, 0>>,
    /// Blue.
    pub blue: Signal<Out, Q<11, 0>>,
    /// Interval of the power table that is written next.
    interval: Register<U<9>>,
    /// max(0, N.L), at most 1.
    light_1: Register<U<18>>,
    /// The same, one clock later.
    light_2: Register<U<18>>,
    /// The same, two clocks later.
    light_3: Register<U<18>>,
    /// The same, three clocks later.
    light_4: Register<U<18>>,
    /// The same as a number.
    cosine: Wire<Q<1, 16>>,
    /// Bits of N.L at and above 1.
    above: Wire<U<2>>,
    /// The interval is written.
    write_interval: Wire<Bit>,
    /// The word of an interval is written.
    write_table: Wire<Bit>,
    /// Power of N.H.
    lobe_power: Quiet<Power>,
    /// Red.
    red_sum: Quiet<Reflect>,
    /// Green.
    green_sum: Quiet<Reflect>,
    /// Blue.
    blue_sum: Quiet<Reflect>,
    /// One interval.
    one: Constant<U<9>>,
    /// 1 in units of 2^-16.
    full: Constant<U<18>>,
}

impl Default for PhongColour {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            go: Default::default(),
            write: Default::default(),
            word: Default::default(),
            data: Default::default(),
            light: Default::default(),
            place: Default::default(),
            red: Default::default(),
            green: Default::default(),
            blue: Default::default(),
            interval: Default::default(),
            light_1: Default::default(),
            light_2: Default::default(),
            light_3: Default::default(),
            light_4: Default::default(),
            cosine: Default::default(),
            above: Default::default(),
            write_interval: Default::default(),
            write_table: Default::default(),
            lobe_power: Default::default(),
            red_sum: Default::default(),
            green_sum: Default::default(),
            blue_sum: Default::default(),
            one: Constant::new(U::new(1)),
            full: Constant::new(U::new(1 << 16)),
        }
    }
}

impl Logic for PhongColour {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name phong_colour");
        comment!("title The reflection model of one light, per pixel.");
        comment!("equation colour = ambient + diffuse * max(0, N.L) + specular * max(0, N.H)^n in each channel");
        comment!(
            "source Phong 1975 with the half-way vector of Blinn 1977; Abbas 2003, chapter 5."
        );
        comment!("latency Six clocks from light and place to the colour; one colour per clock.");
        dff_setup!(self, clock, interval, light_1, light_2, light_3, light_4);
        // Material.
        self.write_table.next = self.write.val() && (self.word.val() == 10u64.into());
        self.write_interval.next = self.write.val() && (self.word.val() == 9u64.into());
        if self.write_interval.val() {
            self.interval.d.next = self.data.val().get_bits::<9>(0);
        }
        if self.write_table.val() {
            self.interval.d.next = self.interval.q.val() + self.one.val();
        }

        // Limits.
        self.above.next = self.light.val().get_bits::<2>(16);
        if self.go.val() {
            self.light_1.d.next = self.light.val().get_bits::<18>(0);
            if self.light.val().get_bit(18) {
                self.light_1.d.next = 0u64.into();
            } else if self.above.val().any() {
                self.light_1.d.next = self.full.val();
            }
            self.light_2.d.next = self.light_1.q.val();
            self.light_3.d.next = self.light_2.q.val();
            self.light_4.d.next = self.light_3.q.val();
        }
        self.cosine.next = signed_cast_bits::<1, 16, 18>(self.light_4.q.val());

        self.lobe_power.clock.next = self.clock.val();
        self.lobe_power.go.next = self.go.val();
        self.lobe_power.place.next = self.place.val();
        self.lobe_power.write.next = self.write_table.val();
        self.lobe_power.write_address.next = self.interval.q.val();
        self.lobe_power.write_data.next = self.data.val();

        self.red_sum.clock.next = self.clock.val();
        self.red_sum.go.next = self.go.val();
        self.red_sum.write_ambient.next = self.write.val() && (self.word.val() == 0u64.into());
        self.red_sum.write_diffuse.next = self.write.val() && (self.word.val() == 1u64.into());
        self.red_sum.write_specular.next = self.write.val() && (self.word.val() == 2u64.into());
        self.red_sum.data.next = self.data.val();
        self.red_sum.light.next = self.cosine.val();
        self.red_sum.power.next = self.lobe_power.power.val();

        self.green_sum.clock.next = self.clock.val();
        self.green_sum.go.next = self.go.val();
        self.green_sum.write_ambient.next = self.write.val() && (self.word.val() == 3u64.into());
        self.green_sum.write_diffuse.next = self.write.val() && (self.word.val() == 4u64.into());
        self.green_sum.write_specular.next = self.write.val() && (self.word.val() == 5u64.into());
        self.green_sum.data.next = self.data.val();
        self.green_sum.light.next = self.cosine.val();
        self.green_sum.power.next = self.lobe_power.power.val();

        self.blue_sum.clock.next = self.clock.val();
        self.blue_sum.go.next = self.go.val();
        self.blue_sum.write_ambient.next = self.write.val() && (self.word.val() == 6u64.into());
        self.blue_sum.write_diffuse.next = self.write.val() && (self.word.val() == 7u64.into());
        self.blue_sum.write_specular.next = self.write.val() && (self.word.val() == 8u64.into());
        self.blue_sum.data.next = self.data.val();
        self.blue_sum.light.next = self.cosine.val();
        self.blue_sum.power.next = self.lobe_power.power.val();

        self.red.next = self.red_sum.level.val();
        self.green.next = self.green_sum.level.val();
        self.blue.next = self.blue_sum.level.val();
    }
}

crate::clocked!(PhongColour;
    inputs go, write, word, data, light, place;
    outputs red, green, blue);
