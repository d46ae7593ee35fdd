//! The gradient at a place of the map that the host wrote, or none where a material has no bumps.
//!
//! Words among those of the material: 12 a sample of the map, 13 the gradients of that sample, after which the next one is
//! meant, 14 whether there are bumps. They take effect at once: the host writes them behind a fence (see the core).

use super::fetch::BumpFetch;
use crate::format::{Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Clocks from the place to the gradient.
pub const STAGES: usize = super::fetch::STAGES;

/// Latency: six clocks.
#[derive(LogicBlock)]
pub struct BumpMap {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Writes `data` to a word of the material, whether the stages move or not.
    pub write: Signal<In, Bit>,
    /// Word of the material.
    pub word: Signal<In, U<4>>,
    /// Register bus.
    pub data: Signal<In, U<36>>,
    /// Column, less half a sample, in units of 2^-12; the map repeats.
    pub u: Signal<In, Q<21, 0>>,
    /// Row, likewise.
    pub v: Signal<In, Q<21, 0>>,
    /// F_u of six clocks ago.
    pub slope_u: Signal<Out, Q<1, 16>>,
    /// F_v of six clocks ago.
    pub slope_v: Signal<Out, Q<1, 16>>,
    /// Sample that is written next.
    sample: Register<U<12>>,
    /// The material has bumps.
    bumpy: Register<Bit>,
    /// The sample to write next is written.
    write_place: Wire<Bit>,
    /// A sample is written.
    write_sample: Wire<Bit>,
    /// Whether there are bumps is written.
    write_bumpy: Wire<Bit>,
    /// The samples.
    fetch: Quiet<BumpFetch>,
    /// One sample.
    one: Constant<U<12>>,
    /// No gradient.
    none: Constant<Q<1, 16>>,
}

impl Default for BumpMap {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            go: Default::default(),
            write: Default::default(),
            word: Default::default(),
            data: Default::default(),
            u: Default::default(),
            v: Default::default(),
            slope_u: Default::default(),
            slope_v: Default::default(),
            sample: Default::default(),
            bumpy: Default::default(),
            write_place: Default::default(),
            write_sample: Default::default(),
            write_bumpy: Default::default(),
            fetch: Default::default(),
            one: Constant::new(U::new(1)),
            none: Constant::new(Q::from_code(0)),
        }
    }
}

impl Logic for BumpMap {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name bump_map");
        comment!("title Gradient of the bumps of a material, and the words that the host writes of them.");
        comment!("equation slope = gradient of the map at (u, v), 0 without bumps");
        comment!("source Hast 2004, section 3.4.1.");
        comment!("latency Six clocks from place to slope; one slope per clock.");
        dff_setup!(self, clock, sample, bumpy);
        self.write_place.next = self.write.val() && (self.word.val() == 12u64.into());
        self.write_sample.next = self.write.val() && (self.word.val() == 13u64.into());
        self.write_bumpy.next = self.write.val() && (self.word.val() == 14u64.into());
        if self.write_place.val() {
            self.sample.d.next = self.data.val().get_bits::<12>(0);
        } else if self.write_sample.val() {
            self.sample.d.next = self.sample.q.val() + self.one.val();
        }
        if self.write_bumpy.val() {
            self.bumpy.d.next = self.data.val().get_bit(0);
        }
        self.fetch.clock.next = self.clock.val();
        self.fetch.go.next = self.go.val();
        self.fetch.u.next = self.u.val().get_bits::<18>(0);
        self.fetch.v.next = self.v.val().get_bits::<18>(0);
        self.fetch.write.next = self.write_sample.val();
        self.fetch.write_address.next = self.sample.q.val();
        self.fetch.write_data.next = self.data.val();
        self.slope_u.next = self.none.val();
        self.slope_v.next = self.none.val();
        if self.bumpy.q.val() {
            self.slope_u.next = self.fetch.slope_u.val();
            self.slope_v.next = self.fetch.slope_v.val();
        }
    }
}

crate::clocked!(BumpMap;
    inputs go, write, word, data, u, v;
    outputs slope_u, slope_v);
