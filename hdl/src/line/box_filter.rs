//! The box-filtered line core: two pixels per column, one per clock, weighted by their shares of the line's row and blended
//! with what is in the frame (Abbas 2003, section 3.2).
//!
//! The weights are exact to their rounding, see [`super::box_weight`]. As in the method they ignore the slope.

use super::box_weight::BoxWeight;
use super::cue::Cue;
use super::place::LanePlace;
use super::stream::LineStream;
use super::walk::LineWalk;
use crate::format::{bit_cast_u, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// `A` is the width of a frame address.
///
/// `select` is a channel mask (bit 4 red, 5 green, 6 blue) over a word number (bits 3 to 0); a mask of zero selects the
/// words of the walk and of the weights. One write may go to several channels.
#[derive(LogicBlock)]
pub struct BoxCore<const A: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to the selected register words; ignored while `load_ready` is low.
    pub write: Signal<In, Bit>,
    /// Channel mask and word number.
    pub select: Signal<In, U<8>>,
    /// Register bus.
    pub data: Signal<In, U<32>>,
    /// The register words are complete; may accompany the last write. Ignored while `load_ready` is low.
    pub start: Signal<In, Bit>,
    /// Clears the frame memory to the background; ignored while `busy`.
    pub clear: Signal<In, Bit>,
    /// The pixel is taken.
    pub ready: Signal<In, Bit>,
    /// Register words may be written.
    pub load_ready: Signal<Out, Bit>,
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
    /// Weight of the pixel, 0 to 255: a line has no depth.
    pub depth: Signal<Out, U<16>>,
    /// Anything is waiting, being drawn or being cleared.
    pub busy: Signal<Out, Bit>,
    /// Pulses for one clock when `busy` falls.
    pub done: Signal<Out, Bit>,
    /// A register write is accepted.
    accept: Wire<Bit>,
    /// A word of the walk or the weights is written.
    line_write: Wire<Bit>,
    /// Register word.
    word: Wire<U<4>>,
    /// Channel mask, 0 for the walk and the weights.
    channels: Wire<U<4>>,
    /// The line moves to its next column.
    advance: Wire<Bit>,
    /// Register file and walk.
    walk: Quiet<LineWalk<A>>,
    /// Red.
    red_value: Quiet<Cue>,
    /// Green.
    green_value: Quiet<Cue>,
    /// Blue.
    blue_value: Quiet<Cue>,
    /// Place of the pixel.
    lane_place: Quiet<LanePlace<A>>,
    /// Weights of the two lanes.
    weights: Quiet<BoxWeight>,
    /// Weight of the fragment that was taken last.
    weight: Register<U<8>>,
    /// Colour of an empty frame.
    background: Register<U<24>>,
    /// Blending, frame memory, output register.
    stream: Quiet<LineStream<A>>,
}

impl<const A: usize> BoxCore<A> {
    /// A core whose frame memory has `pixels` words.
    #[must_use]
    pub fn new(pixels: usize) -> Self {
        Self {
            clock: Default::default(),
            write: Default::default(),
            select: Default::default(),
            data: Default::default(),
            start: Default::default(),
            clear: Default::default(),
            ready: Default::default(),
            load_ready: Default::default(),
            valid: Default::default(),
            x: Default::default(),
            y: Default::default(),
            red: Default::default(),
            green: Default::default(),
            blue: Default::default(),
            depth: Default::default(),
            busy: Default::default(),
            done: Default::default(),
            accept: Default::default(),
            line_write: Default::default(),
            word: Default::default(),
            channels: Default::default(),
            advance: Default::default(),
            walk: Default::default(),
            red_value: Default::default(),
            green_value: Default::default(),
            blue_value: Default::default(),
            lane_place: Default::default(),
            weights: Default::default(),
            weight: Default::default(),
            background: Default::default(),
            stream: LineStream::new(pixels).into(),
        }
    }
}

impl<const A: usize> Logic for BoxCore<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name box_core");
        comment!("title Box-filtered line core: weights without drift, blending, pixel stream.");
        comment!(
            "equation colour = old (1 - w) + line w, w = 1 - f and f in the two pixels of a column"
        );
        comment!("source Abbas 2003, section 3.2, with floor for the Round of equation 3.8.");
        comment!("latency Five clocks from start to the first pixel; then one pixel per clock.");
        dff_setup!(self, clock, background, weight);
        // Register file.
        self.accept.next = self.write.val() && self.walk.load_ready.val();
        self.word.next = self.select.val().get_bits::<4>(0);
        self.channels.next = self.select.val().get_bits::<4>(4);
        self.line_write.next = self.accept.val() && !self.channels.val().any();

        self.walk.clock.next = self.clock.val();
        self.walk.write.next = self.line_write.val();
        self.walk.word.next = self.word.val();
        self.walk.data.next = bit_cast_u::<24, 32>(self.data.val());
        self.walk.start.next = self.start.val();
        self.walk.hold.next = self.stream.clearing.val();
        self.walk.go.next = self.stream.go.val();
        self.walk.whole.next = false;
        self.advance.next = self.walk.run.val() && self.walk.turn.val();

        self.red_value.clock.next = self.clock.val();
        self.red_value.write.next = self.accept.val() && self.channels.val().get_bit(0);
        self.red_value.word.next = self.word.val();
        self.red_value.data.next = self.data.val();
        self.red_value.load.next = self.walk.load.val();
        self.red_value.advance.next = self.advance.val();

        self.green_value.clock.next = self.clock.val();
        self.green_value.write.next = self.accept.val() && self.channels.val().get_bit(1);
        self.green_value.word.next = self.word.val();
        self.green_value.data.next = self.data.val();
        self.green_value.load.next = self.walk.load.val();
        self.green_value.advance.next = self.advance.val();

        self.blue_value.clock.next = self.clock.val();
        self.blue_value.write.next = self.accept.val() && self.channels.val().get_bit(2);
        self.blue_value.word.next = self.word.val();
        self.blue_value.data.next = self.data.val();
        self.blue_value.load.next = self.walk.load.val();
        self.blue_value.advance.next = self.advance.val();

        self.weights.clock.next = self.clock.val();
        self.weights.write.next = self.line_write.val();
        self.weights.word.next = self.word.val();
        self.weights.data.next = bit_cast_u::<17, 32>(self.data.val());
        self.weights.load.next = self.walk.load.val();
        self.weights.advance.next = self.advance.val();
        self.weights.rises.next = self.walk.rises.val();
        self.weights.upper.next = self.walk.lane.val().any();
        if self.stream.moving.val() {
            self.weight.d.next = self.weights.weight.val();
        }

        self.lane_place.lane.next = self.walk.lane.val();
        self.lane_place.below.next = false;
        self.lane_place.major.next = self.walk.major.val();
        self.lane_place.minor.next = self.walk.minor.val();
        self.lane_place.address.next = self.walk.address.val();
        self.lane_place.steep.next = self.walk.steep.val();
        self.lane_place.falling.next = self.walk.falling.val();
        self.lane_place.frame_width.next = self.walk.frame_width.val();
        self.lane_place.frame_height.next = self.walk.frame_height.val();

        // The background is a word of the frame, not of a line.
        if self.line_write.val() && (self.word.val() == 12u64.into()) {
            self.background.d.next = self.data.val().get_bits::<24>(0);
        }

        self.stream.clock.next = self.clock.val();
        self.stream.clear.next = self.clear.val();
        self.stream.ready.next = self.ready.val();
        self.stream.walking.next = self.walk.busy.val();
        self.stream.fragment.next = self.walk.active.val() && self.lane_place.in_frame.val();
        self.stream.fragment_x.next = self.lane_place.x.val();
        self.stream.fragment_y.next = self.lane_place.y.val();
        self.stream.address.next = self.lane_place.place.val();
        self.stream.fragment_red.next = self.red_value.level.val();
        self.stream.fragment_green.next = self.green_value.level.val();
        self.stream.fragment_blue.next = self.blue_value.level.val();
        self.stream.weight.next = self.weight.q.val();
        self.stream.background.next = self.background.q.val();

        self.load_ready.next = self.walk.load_ready.val();
        self.valid.next = self.stream.valid.val();
        self.x.next = self.stream.x.val();
        self.y.next = self.stream.y.val();
        self.red.next = self.stream.red.val();
        self.green.next = self.stream.green.val();
        self.blue.next = self.stream.blue.val();
        self.depth.next = bit_cast_u::<16, 8>(self.stream.coverage.val());
        self.busy.next = self.stream.busy.val();
        self.done.next = self.stream.done.val();
    }
}

crate::clocked!(BoxCore<A>, const A: usize;
    inputs write, select, data, start, clear, ready;
    outputs load_ready, valid, x, y, red, green, blue, depth, busy, done);
