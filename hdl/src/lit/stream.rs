//! Behind the factors of a span core: three channels of colour, the way of a fragment's place beside them, and the
//! pixel stream that all cores share.
//!
//! A fragment enters with its place and material in the stage of the pixel registers; its factors arrive three stages
//! later, its colours are complete after five, and there it enters the pixel stream. All stages move together.

use super::channel::LitChannel;
use super::place::PlaceStage;
use crate::format::{Q, U};
use crate::shade::pixel_stream::PixelStream;
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// `A` is the width of a frame address. Latency: eight clocks from a fragment to its offered pixel.
#[derive(LogicBlock)]
pub struct LitStream<const A: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Clears the depth memory; ignored while `busy`.
    pub clear: Signal<In, Bit>,
    /// The offered pixel is taken.
    pub ready: Signal<In, Bit>,
    /// A span is waiting or being drawn.
    pub walking: Signal<In, Bit>,
    /// A fragment arrives.
    pub fragment: Signal<In, Bit>,
    /// Its column.
    pub fragment_x: Signal<In, U<11>>,
    /// Its row.
    pub fragment_y: Signal<In, U<11>>,
    /// Its frame address.
    pub address: Signal<In, U<A>>,
    /// Its depth less 32768, with half a word added.
    pub fragment_depth: Signal<In, Q<15, 0>>,
    /// Its material.
    pub material: Signal<In, U<2>>,
    /// Diffuse factor of the fragment three stages before.
    pub diffuse: Signal<In, U<17>>,
    /// Factor of its highlight.
    pub highlight: Signal<In, U<17>>,
    /// `data` is a colour.
    pub write_colour: Signal<In, Bit>,
    /// Material\[31:30\], cell\[29:26\], colour\[17:0\].
    pub data: Signal<In, U<32>>,
    /// The stages move.
    pub go: Signal<Out, Bit>,
    /// The depth memory is being cleared.
    pub clearing: Signal<Out, Bit>,
    /// A visible pixel is offered; held until `ready`.
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
    /// Depth, larger is nearer.
    pub depth: Signal<Out, U<16>>,
    /// Anything is waiting, being drawn or being cleared.
    pub busy: Signal<Out, Bit>,
    /// Pulses for one clock when `busy` falls.
    pub done: Signal<Out, Bit>,
    /// Material, first stage.
    material_first: Register<U<2>>,
    /// Material, second stage.
    material_second: Register<U<2>>,
    /// Cell of the colour that is written.
    colour_cell: Wire<U<4>>,
    /// Its material.
    colour_material: Wire<U<2>>,
    /// The colour.
    colour: Wire<U<18>>,
    /// The stages move.
    moves: Wire<Bit>,
    /// First stage.
    stage_1: Quiet<PlaceStage<A>>,
    /// Second stage.
    stage_2: Quiet<PlaceStage<A>>,
    /// Third stage: the factors are here.
    stage_3: Quiet<PlaceStage<A>>,
    /// Fourth stage: the products.
    stage_4: Quiet<PlaceStage<A>>,
    /// Fifth stage: the colours.
    stage_5: Quiet<PlaceStage<A>>,
    /// Red.
    red_part: Quiet<LitChannel>,
    /// Green.
    green_part: Quiet<LitChannel>,
    /// Blue.
    blue_part: Quiet<LitChannel>,
    /// Clamp, depth test, output register.
    stream: Quiet<PixelStream<A>>,
}

impl<const A: usize> LitStream<A> {
    /// A stream whose depth memory has `pixels` words.
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
            fragment_depth: Default::default(),
            material: Default::default(),
            diffuse: Default::default(),
            highlight: Default::default(),
            write_colour: Default::default(),
            data: Default::default(),
            go: Default::default(),
            clearing: Default::default(),
            valid: Default::default(),
            x: Default::default(),
            y: Default::default(),
            red: Default::default(),
            green: Default::default(),
            blue: Default::default(),
            depth: Default::default(),
            busy: Default::default(),
            done: Default::default(),
            material_first: Default::default(),
            material_second: Default::default(),
            colour_cell: Default::default(),
            colour_material: Default::default(),
            colour: Default::default(),
            moves: Default::default(),
            stage_1: Default::default(),
            stage_2: Default::default(),
            stage_3: Default::default(),
            stage_4: Default::default(),
            stage_5: Default::default(),
            red_part: Default::default(),
            green_part: Default::default(),
            blue_part: Default::default(),
            stream: PixelStream::new(pixels).into(),
        }
    }
}

impl<const A: usize> Logic for LitStream<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name lit_stream");
        comment!(
            "title Colours of lit fragments from their factors, then depth test and pixel stream."
        );
        comment!("equation I = ambient + diffuse D + highlight S in every channel");
        comment!("source Abbas 2003, section 6.3 and figure 6.6; the stages overlap.");
        comment!("latency Eight clocks from fragment to valid.");
        dff_setup!(self, clock, material_first, material_second);
        self.moves.next = self.stream.go.val();
        if self.moves.val() {
            self.material_first.d.next = self.material.val();
            self.material_second.d.next = self.material_first.q.val();
        }
        self.colour_cell.next = self.data.val().get_bits::<4>(26);
        self.colour_material.next = self.data.val().get_bits::<2>(30);
        self.colour.next = self.data.val().get_bits::<18>(0);

        self.stage_1.clock.next = self.clock.val();
        self.stage_1.go.next = self.moves.val();
        self.stage_1.fragment.next = self.fragment.val();
        self.stage_1.x.next = self.fragment_x.val();
        self.stage_1.y.next = self.fragment_y.val();
        self.stage_1.address.next = self.address.val();
        self.stage_1.depth.next = self.fragment_depth.val();

        self.stage_2.clock.next = self.clock.val();
        self.stage_2.go.next = self.moves.val();
        self.stage_2.fragment.next = self.stage_1.fragment_out.val();
        self.stage_2.x.next = self.stage_1.x_out.val();
        self.stage_2.y.next = self.stage_1.y_out.val();
        self.stage_2.address.next = self.stage_1.address_out.val();
        self.stage_2.depth.next = self.stage_1.depth_out.val();

        self.stage_3.clock.next = self.clock.val();
        self.stage_3.go.next = self.moves.val();
        self.stage_3.fragment.next = self.stage_2.fragment_out.val();
        self.stage_3.x.next = self.stage_2.x_out.val();
        self.stage_3.y.next = self.stage_2.y_out.val();
        self.stage_3.address.next = self.stage_2.address_out.val();
        self.stage_3.depth.next = self.stage_2.depth_out.val();

        self.stage_4.clock.next = self.clock.val();
        self.stage_4.go.next = self.moves.val();
        self.stage_4.fragment.next = self.stage_3.fragment_out.val();
        self.stage_4.x.next = self.stage_3.x_out.val();
        self.stage_4.y.next = self.stage_3.y_out.val();
        self.stage_4.address.next = self.stage_3.address_out.val();
        self.stage_4.depth.next = self.stage_3.depth_out.val();

        self.stage_5.clock.next = self.clock.val();
        self.stage_5.go.next = self.moves.val();
        self.stage_5.fragment.next = self.stage_4.fragment_out.val();
        self.stage_5.x.next = self.stage_4.x_out.val();
        self.stage_5.y.next = self.stage_4.y_out.val();
        self.stage_5.address.next = self.stage_4.address_out.val();
        self.stage_5.depth.next = self.stage_4.depth_out.val();

        self.red_part.clock.next = self.clock.val();
        self.red_part.go.next = self.moves.val();
        self.red_part.material.next = self.material_second.q.val();
        self.red_part.diffuse.next = self.diffuse.val();
        self.red_part.highlight.next = self.highlight.val();
        self.red_part.write_ambient.next =
            self.write_colour.val() && (self.colour_cell.val() == 0u64.into());
        self.red_part.write_diffuse.next =
            self.write_colour.val() && (self.colour_cell.val() == 1u64.into());
        self.red_part.write_highlight.next =
            self.write_colour.val() && (self.colour_cell.val() == 2u64.into());
        self.red_part.write_material.next = self.colour_material.val();
        self.red_part.colour.next = self.colour.val();

        self.green_part.clock.next = self.clock.val();
        self.green_part.go.next = self.moves.val();
        self.green_part.material.next = self.material_second.q.val();
        self.green_part.diffuse.next = self.diffuse.val();
        self.green_part.highlight.next = self.highlight.val();
        self.green_part.write_ambient.next =
            self.write_colour.val() && (self.colour_cell.val() == 3u64.into());
        self.green_part.write_diffuse.next =
            self.write_colour.val() && (self.colour_cell.val() == 4u64.into());
        self.green_part.write_highlight.next =
            self.write_colour.val() && (self.colour_cell.val() == 5u64.into());
        self.green_part.write_material.next = self.colour_material.val();
        self.green_part.colour.next = self.colour.val();

        self.blue_part.clock.next = self.clock.val();
        self.blue_part.go.next = self.moves.val();
        self.blue_part.material.next = self.material_second.q.val();
        self.blue_part.diffuse.next = self.diffuse.val();
        self.blue_part.highlight.next = self.highlight.val();
        self.blue_part.write_ambient.next =
            self.write_colour.val() && (self.colour_cell.val() == 6u64.into());
        self.blue_part.write_diffuse.next =
            self.write_colour.val() && (self.colour_cell.val() == 7u64.into());
        self.blue_part.write_highlight.next =
            self.write_colour.val() && (self.colour_cell.val() == 8u64.into());
        self.blue_part.write_material.next = self.colour_material.val();
        self.blue_part.colour.next = self.colour.val();
        self.stream.clock.next = self.clock.val();
        self.stream.clear.next = self.clear.val();
        self.stream.ready.next = self.ready.val();
        self.stream.walking.next = self.walking.val()
            || self.stage_1.fragment_out.val()
            || self.stage_2.fragment_out.val()
            || self.stage_3.fragment_out.val()
            || self.stage_4.fragment_out.val()
            || self.stage_5.fragment_out.val();
        self.stream.fragment.next = self.stage_5.fragment_out.val();
        self.stream.fragment_x.next = self.stage_5.x_out.val();
        self.stream.fragment_y.next = self.stage_5.y_out.val();
        self.stream.address.next = self.stage_5.address_out.val();
        self.stream.fragment_red.next = self.red_part.value.val();
        self.stream.fragment_green.next = self.green_part.value.val();
        self.stream.fragment_blue.next = self.blue_part.value.val();
        self.stream.fragment_depth.next = self.stage_5.depth_out.val();

        self.go.next = self.stream.go.val();
        self.clearing.next = self.stream.clearing.val();
        self.valid.next = self.stream.valid.val();
        self.x.next = self.stream.x.val();
        self.y.next = self.stream.y.val();
        self.red.next = self.stream.red.val();
        self.green.next = self.stream.green.val();
        self.blue.next = self.stream.blue.val();
        self.depth.next = self.stream.depth.val();
        self.busy.next = self.stream.busy.val();
        self.done.next = self.stream.done.val();
    }
}

crate::clocked!(LitStream<A>, const A: usize;
    inputs clear, ready, walking, fragment, fragment_x, fragment_y, address, fragment_depth, material, diffuse,
        highlight, write_colour, data;
    outputs go, clearing, valid, x, y, red, green, blue, depth, busy, done);
