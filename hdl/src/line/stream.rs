//! The pixel stream of a filtering line core: reads the old colour, blends, writes back and hands over the finished pixel.
//!
//! ```text
//! fragment ──► fetched ──► mixed ──► offered
//!   read        old colour,   weighted      sum ─► colour memory
//!   address     weight        difference         └► output
//! ```
//!
//! A fragment must not read a pixel that is still being mixed. Within a line no pixel comes twice; the next line may
//! begin on one of the last two. Such a fragment waits until that pixel is written: one or two clocks, no data to
//! forward, and one comparison per stage. Everything else flows at one pixel per clock, and only an offered pixel that
//! nobody takes stops it. Fragments of weight 0 are dropped.
//! Source: Abbas 2003, section 3.3 (second stage: look up, read, write); the pipeline and its interlock are ours.

use super::blend::Blend;
use crate::depth::frame_memory::ColourMemory;
use crate::format::{bit_cast_u, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// `A` is the width of a frame address. Latency: three clocks from a fragment to its offered pixel.
#[derive(LogicBlock)]
pub struct LineStream<const A: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Clears the frame memory; ignored while `busy`.
    pub clear: Signal<In, Bit>,
    /// The offered pixel is taken.
    pub ready: Signal<In, Bit>,
    /// A line is waiting or being walked.
    pub walking: Signal<In, Bit>,
    /// A fragment arrives.
    pub fragment: Signal<In, Bit>,
    /// Its column.
    pub fragment_x: Signal<In, U<11>>,
    /// Its row.
    pub fragment_y: Signal<In, U<11>>,
    /// Its frame address.
    pub address: Signal<In, U<A>>,
    /// Red of the line.
    pub fragment_red: Signal<In, U<8>>,
    /// Green of the line.
    pub fragment_green: Signal<In, U<8>>,
    /// Blue of the line.
    pub fragment_blue: Signal<In, U<8>>,
    /// Weight of the fragment that arrived last, of 255.
    pub weight: Signal<In, U<8>>,
    /// Colour of an empty frame: red, green, blue.
    pub background: Signal<In, U<24>>,
    /// The stages move.
    pub moving: Signal<Out, Bit>,
    /// The stages move and the fragment is taken.
    pub go: Signal<Out, Bit>,
    /// The frame memory is being cleared.
    pub clearing: Signal<Out, Bit>,
    /// A pixel is offered; held until `ready`.
    pub valid: Signal<Out, Bit>,
    /// Its column.
    pub x: Signal<Out, U<11>>,
    /// Its row.
    pub y: Signal<Out, U<11>>,
    /// Red.
    pub red: Signal<Out, U<8>>,
    /// Green.
    pub green: Signal<Out, U<8>>,
    /// Blue.
    pub blue: Signal<Out, U<8>>,
    /// Its weight, of 255.
    pub coverage: Signal<Out, U<8>>,
    /// Anything is waiting, being drawn or being cleared.
    pub busy: Signal<Out, Bit>,
    /// Pulses for one clock when `busy` falls.
    pub done: Signal<Out, Bit>,
    /// A fragment waits for its old colour.
    fetched: Register<Bit>,
    /// Its column.
    fetched_x: Register<U<11>>,
    /// Its row.
    fetched_y: Register<U<11>>,
    /// Its frame address.
    fetched_address: Register<U<A>>,
    /// Red of the line.
    fetched_red: Register<U<8>>,
    /// Green of the line.
    fetched_green: Register<U<8>>,
    /// Blue of the line.
    fetched_blue: Register<U<8>>,
    /// A pixel is being mixed.
    mixed: Register<Bit>,
    /// Its column.
    mixed_x: Register<U<11>>,
    /// Its row.
    mixed_y: Register<U<11>>,
    /// Its frame address.
    mixed_address: Register<U<A>>,
    /// Its weight.
    mixed_weight: Register<U<8>>,
    /// A pixel is offered.
    out_valid: Register<Bit>,
    /// Its column.
    out_x: Register<U<11>>,
    /// Its row.
    out_y: Register<U<11>>,
    /// Its colour: red, green, blue.
    out_colour: Register<U<24>>,
    /// Its weight.
    out_weight: Register<U<8>>,
    /// Busy, one clock ago.
    was_busy: Register<Bit>,
    /// The memory is being cleared.
    sweeping: Register<Bit>,
    /// Word to clear.
    sweep_address: Register<U<A>>,
    /// The stages move.
    moves: Wire<Bit>,
    /// The fragment's pixel is still on its way to the memory.
    conflict: Wire<Bit>,
    /// Anything is waiting, being drawn or being cleared.
    is_busy: Wire<Bit>,
    /// Old colour of the fetched fragment.
    old: Wire<U<24>>,
    /// Red of the mixed pixel, in place.
    red_bits: Wire<U<24>>,
    /// Green of the mixed pixel, in place.
    green_bits: Wire<U<24>>,
    /// Blue of the mixed pixel, in place.
    blue_bits: Wire<U<24>>,
    /// Colour of the mixed pixel.
    colour: Wire<U<24>>,
    /// Red.
    red_blend: Quiet<Blend>,
    /// Green.
    green_blend: Quiet<Blend>,
    /// Blue.
    blue_blend: Quiet<Blend>,
    /// One colour per pixel, relative to the background.
    memory: Quiet<ColourMemory<A>>,
    /// Last word of the memory.
    last_address: Constant<U<A>>,
    /// Address step.
    one_word: Constant<U<A>>,
}

impl<const A: usize> LineStream<A> {
    /// A stream whose frame memory has `pixels` words.
    #[must_use]
    pub fn new(pixels: usize) -> Self {
        Self {
            clock: Default::default(),
            clear: Default::default(),
            ready: Default::default(),
            walking: Default::default(),
            fragment: Default::default(),
            fragment_x: Default::default(),
            fragment_y: Default::default(),
            address: Default::default(),
            fragment_red: Default::default(),
            fragment_green: Default::default(),
            fragment_blue: Default::default(),
            weight: Default::default(),
            background: Default::default(),
            moving: Default::default(),
            go: Default::default(),
            clearing: Default::default(),
            valid: Default::default(),
            x: Default::default(),
            y: Default::default(),
            red: Default::default(),
            green: Default::default(),
            blue: Default::default(),
            coverage: Default::default(),
            busy: Default::default(),
            done: Default::default(),
            fetched: Default::default(),
            fetched_x: Default::default(),
            fetched_y: Default::default(),
            fetched_address: Default::default(),
            fetched_red: Default::default(),
            fetched_green: Default::default(),
            fetched_blue: Default::default(),
            mixed: Default::default(),
            mixed_x: Default::default(),
            mixed_y: Default::default(),
            mixed_address: Default::default(),
            mixed_weight: Default::default(),
            out_valid: Default::default(),
            out_x: Default::default(),
            out_y: Default::default(),
            out_colour: Default::default(),
            out_weight: Default::default(),
            was_busy: Default::default(),
            sweeping: Default::default(),
            sweep_address: Default::default(),
            moves: Default::default(),
            conflict: Default::default(),
            is_busy: Default::default(),
            old: Default::default(),
            red_bits: Default::default(),
            green_bits: Default::default(),
            blue_bits: Default::default(),
            colour: Default::default(),
            red_blend: Default::default(),
            green_blend: Default::default(),
            blue_blend: Default::default(),
            memory: ColourMemory::new(pixels).into(),
            last_address: Constant::new(U::new(pixels as u64 - 1)),
            one_word: Constant::new(U::new(1)),
        }
    }
}

impl<const A: usize> Logic for LineStream<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name line_stream");
        comment!("title Blending and output of a line core: old colour, weighted sum, frame memory, hand-over.");
        comment!("equation colour = round((old (255 - weight) + new weight) / 255), written back and offered");
        comment!("source Abbas 2003, section 3.3, second stage; a fragment waits for its own pixel of the line before.");
        comment!("latency Three clocks from fragment to valid; one pixel per clock.");
        dff_setup!(
            self,
            clock,
            fetched,
            fetched_x,
            fetched_y,
            fetched_address,
            fetched_red,
            fetched_green,
            fetched_blue,
            mixed,
            mixed_x,
            mixed_y,
            mixed_address,
            mixed_weight,
            out_valid,
            out_x,
            out_y,
            out_colour,
            out_weight,
            was_busy,
            sweeping,
            sweep_address
        );

        // Only a pixel that nobody takes stops the stages; a fragment waits for its own pixel.
        self.moves.next = !self.out_valid.q.val() || self.ready.val();
        self.conflict.next = self.fragment.val()
            && ((self.fetched.q.val() && (self.address.val() == self.fetched_address.q.val()))
                || (self.mixed.q.val() && (self.address.val() == self.mixed_address.q.val())));
        self.is_busy.next = self.walking.val()
            || self.fetched.q.val()
            || self.mixed.q.val()
            || self.sweeping.q.val()
            || self.out_valid.q.val();

        self.old.next = self.memory.read_data.val() ^ self.background.val();
        self.red_blend.clock.next = self.clock.val();
        self.red_blend.go.next = self.moves.val();
        self.red_blend.old.next = self.old.val().get_bits::<8>(16);
        self.red_blend.target.next = self.fetched_red.q.val();
        self.red_blend.weight.next = self.weight.val();
        self.green_blend.clock.next = self.clock.val();
        self.green_blend.go.next = self.moves.val();
        self.green_blend.old.next = self.old.val().get_bits::<8>(8);
        self.green_blend.target.next = self.fetched_green.q.val();
        self.green_blend.weight.next = self.weight.val();
        self.blue_blend.clock.next = self.clock.val();
        self.blue_blend.go.next = self.moves.val();
        self.blue_blend.old.next = self.old.val().get_bits::<8>(0);
        self.blue_blend.target.next = self.fetched_blue.q.val();
        self.blue_blend.weight.next = self.weight.val();
        self.red_bits.next = bit_cast_u::<24, 8>(self.red_blend.level.val());
        self.green_bits.next = bit_cast_u::<24, 8>(self.green_blend.level.val());
        self.blue_bits.next = bit_cast_u::<24, 8>(self.blue_blend.level.val());
        self.colour.next =
            (self.red_bits.val() << 16u64) | (self.green_bits.val() << 8u64) | self.blue_bits.val();

        if self.moves.val() {
            self.fetched.d.next = self.fragment.val() && !self.conflict.val();
            self.fetched_x.d.next = self.fragment_x.val();
            self.fetched_y.d.next = self.fragment_y.val();
            self.fetched_address.d.next = self.address.val();
            self.fetched_red.d.next = self.fragment_red.val();
            self.fetched_green.d.next = self.fragment_green.val();
            self.fetched_blue.d.next = self.fragment_blue.val();
            self.mixed.d.next = self.fetched.q.val() && self.weight.val().any();
            self.mixed_x.d.next = self.fetched_x.q.val();
            self.mixed_y.d.next = self.fetched_y.q.val();
            self.mixed_address.d.next = self.fetched_address.q.val();
            self.mixed_weight.d.next = self.weight.val();
            self.out_valid.d.next = self.mixed.q.val();
            self.out_x.d.next = self.mixed_x.q.val();
            self.out_y.d.next = self.mixed_y.q.val();
            self.out_colour.d.next = self.colour.val();
            self.out_weight.d.next = self.mixed_weight.q.val();
        }

        if self.sweeping.q.val() {
            self.sweep_address.d.next = self.sweep_address.q.val() + self.one_word.val();
            if self.sweep_address.q.val() == self.last_address.val() {
                self.sweeping.d.next = false;
            }
        } else if self.clear.val() && !self.is_busy.val() {
            self.sweeping.d.next = true;
            self.sweep_address.d.next = 0u64.into();
        }
        self.memory.clock.next = self.clock.val();
        self.memory.read.next = self.moves.val();
        self.memory.read_address.next = self.address.val();
        self.memory.write.next = (self.mixed.q.val() && self.moves.val()) || self.sweeping.q.val();
        self.memory.write_address.next = self.mixed_address.q.val();
        self.memory.write_data.next = self.colour.val() ^ self.background.val();
        if self.sweeping.q.val() {
            self.memory.write_address.next = self.sweep_address.q.val();
            self.memory.write_data.next = 0u64.into();
        }

        self.was_busy.d.next = self.is_busy.val();
        self.moving.next = self.moves.val();
        self.go.next = self.moves.val() && !self.conflict.val();
        self.clearing.next = self.sweeping.q.val();
        self.valid.next = self.out_valid.q.val();
        self.x.next = self.out_x.q.val();
        self.y.next = self.out_y.q.val();
        self.red.next = self.out_colour.q.val().get_bits::<8>(16);
        self.green.next = self.out_colour.q.val().get_bits::<8>(8);
        self.blue.next = self.out_colour.q.val().get_bits::<8>(0);
        self.coverage.next = self.out_weight.q.val();
        self.busy.next = self.is_busy.val();
        self.done.next = self.was_busy.q.val() && !self.is_busy.val();
    }
}

crate::clocked!(LineStream<A>, const A: usize;
    inputs clear, ready, walking, fragment, fragment_x, fragment_y, address, fragment_red, fragment_green,
        fragment_blue, weight, background;
    outputs moving, go, clearing, valid, x, y, red, green, blue, coverage, busy, done);
