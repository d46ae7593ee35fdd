//! The Bresenham line core: the one pixel nearest to the line in every column, one per clock (Bresenham 1965; Abbas 2003,
//! section 3.1). Pixels replace what is in the frame, so there is no frame memory and nothing to clear: a `clear` is
//! answered at once, for hosts that treat all cores alike.

use super::cue::Cue;
use super::place::LanePlace;
use super::walk::LineWalk;
use crate::format::{bit_cast_u, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// `A` is the width of a frame address.
///
/// `select` is a channel mask (bit 4 red, 5 green, 6 blue) over a word number (bits 3 to 0); a mask of zero selects the
/// words of the walk. One write may go to several channels.
#[derive(LogicBlock)]
pub struct BresenhamCore<const A: usize> {
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
    /// Answered by `done`: there is no memory to clear. Ignored while `busy`.
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
    /// Weight of the pixel, always 255: a line has no depth.
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
    /// A pixel is offered.
    out_valid: Register<Bit>,
    /// Its column.
    out_x: Register<U<11>>,
    /// Its row.
    out_y: Register<U<11>>,
    /// Its red.
    out_red: Register<U<8>>,
    /// Its green.
    out_green: Register<U<8>>,
    /// Its blue.
    out_blue: Register<U<8>>,
    /// A clear is being answered.
    clearing: Register<Bit>,
    /// Busy, one clock ago.
    was_busy: Register<Bit>,
    /// The stages move.
    moves: Wire<Bit>,
    /// Anything is waiting or being drawn.
    is_busy: Wire<Bit>,
    /// Weight of every pixel.
    full: Constant<U<16>>,
}

impl<const A: usize> Default for BresenhamCore<A> {
    fn default() -> Self {
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
            out_valid: Default::default(),
            out_x: Default::default(),
            out_y: Default::default(),
            out_red: Default::default(),
            out_green: Default::default(),
            out_blue: Default::default(),
            clearing: Default::default(),
            was_busy: Default::default(),
            moves: Default::default(),
            is_busy: Default::default(),
            full: Constant::new(U::new(255)),
        }
    }
}

impl<const A: usize> Logic for BresenhamCore<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name bresenham_core");
        comment!("title Bresenham line core: one pixel per column and clock, depth cueing, pixel stream.");
        comment!("equation the pixel (x, y) of column x has |y - line(x)| <= 1/2");
        comment!("source Bresenham 1965; Abbas 2003, section 3.1.");
        comment!("latency Three clocks from start to the first pixel; then one pixel per clock.");
        dff_setup!(
            self, clock, out_valid, out_x, out_y, out_red, out_green, out_blue, clearing, was_busy
        );
        self.moves.next = !self.out_valid.q.val() || self.ready.val();
        self.is_busy.next = self.walk.busy.val() || self.out_valid.q.val() || self.clearing.q.val();
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
        self.walk.hold.next = self.clearing.q.val();
        self.walk.go.next = self.moves.val();
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

        self.lane_place.lane.next = self.walk.lane.val();
        self.lane_place.below.next = false;
        self.lane_place.major.next = self.walk.major.val();
        self.lane_place.minor.next = self.walk.minor.val();
        self.lane_place.address.next = self.walk.address.val();
        self.lane_place.steep.next = self.walk.steep.val();
        self.lane_place.falling.next = self.walk.falling.val();
        self.lane_place.frame_width.next = self.walk.frame_width.val();
        self.lane_place.frame_height.next = self.walk.frame_height.val();

        if self.moves.val() {
            self.out_valid.d.next = self.walk.active.val() && self.lane_place.in_frame.val();
            self.out_x.d.next = self.lane_place.x.val();
            self.out_y.d.next = self.lane_place.y.val();
            self.out_red.d.next = self.red_value.level.val();
            self.out_green.d.next = self.green_value.level.val();
            self.out_blue.d.next = self.blue_value.level.val();
        }
        self.clearing.d.next = self.clear.val() && !self.is_busy.val();
        self.was_busy.d.next = self.is_busy.val();

        self.load_ready.next = self.walk.load_ready.val();
        self.valid.next = self.out_valid.q.val();
        self.x.next = self.out_x.q.val();
        self.y.next = self.out_y.q.val();
        self.red.next = self.out_red.q.val();
        self.green.next = self.out_green.q.val();
        self.blue.next = self.out_blue.q.val();
        self.depth.next = self.full.val();
        self.busy.next = self.is_busy.val();
        self.done.next = self.was_busy.q.val() && !self.is_busy.val();
    }
}

crate::clocked!(BresenhamCore<A>, const A: usize;
    inputs write, select, data, start, clear, ready;
    outputs load_ready, valid, x, y, red, green, blue, depth, busy, done);
