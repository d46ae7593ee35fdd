//! The compact quadratic unit: register words in, coloured pixels out, one per clock; no depth test.
//!
//! `select` is a channel mask (bit 4 red, 5 green, 6 blue) over a word number (bits 3 to 0); a mask of zero selects the
//! words of the [`super::walk`]. One write may go to several channels.

use super::channel::CompactChannel;
use super::clamp::CompactClamp;
use super::walk::CompactWalk;
use crate::format::{bit_cast_u, U};
use crate::simulate::{Quiet, Wire};
use rust_hdl_core::prelude::*;

/// Colours Q11.20, as in the quadratic core: knots from 0 to 1530, frames of up to 512 columns and rows.
pub type CompactUnit32 = CompactUnit<32, 11, 20, 20>;
/// The word lengths that triangles of up to 512 columns and rows need: knots from 0 to 255 leave their range by a third,
/// which nine bits hold ([`super::clamp`]); differences keep 20 fraction bits, values 11.
pub type CompactUnit29 = CompactUnit<29, 8, 20, 11>;

/// `D` = 1 + `M` + `N`: width of a colour word; `V`: fraction bits of a value.
#[derive(LogicBlock, Default)]
pub struct CompactUnit<const D: usize, const M: usize, const N: usize, const V: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to the selected words; ignored while `load_ready` is low.
    pub write: Signal<In, Bit>,
    /// Channel mask and word number.
    pub select: Signal<In, U<8>>,
    /// Register bus.
    pub data: Signal<In, U<32>>,
    /// The words are complete; may accompany the last write. Ignored while `load_ready` is low.
    pub start: Signal<In, Bit>,
    /// The pixel is taken.
    pub ready: Signal<In, Bit>,
    /// Words may be written.
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
    /// A triangle is waiting or being drawn.
    pub busy: Signal<Out, Bit>,
    /// A write is accepted.
    accept: Wire<Bit>,
    /// Word number.
    word: Wire<U<4>>,
    /// Channel mask, 0 for the walk.
    channels: Wire<U<4>>,
    /// Register bus as a colour word.
    colour: Wire<U<D>>,
    /// Rows, edges, pixels.
    walk: Quiet<CompactWalk>,
    /// Red over the triangle.
    red_value: Quiet<CompactChannel<D, M, N, V>>,
    /// Green over the triangle.
    green_value: Quiet<CompactChannel<D, M, N, V>>,
    /// Blue over the triangle.
    blue_value: Quiet<CompactChannel<D, M, N, V>>,
    /// Red, clamped.
    red_byte: Quiet<CompactClamp<M>>,
    /// Green, clamped.
    green_byte: Quiet<CompactClamp<M>>,
    /// Blue, clamped.
    blue_byte: Quiet<CompactClamp<M>>,
}

impl<const D: usize, const M: usize, const N: usize, const V: usize> Logic
    for CompactUnit<D, M, N, V>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name compact_unit");
        comment!("title Quadratic colours over triangles, walked exactly, one pixel per clock, in little area.");
        comment!("equation I(x, y) = T5 x^2 + T4 x y + T3 y^2 + T2 x + T1 y + T0 per channel, by forward differences");
        comment!("source Abbas 2003, chapter 7 and appendix.");
        comment!("latency Nine clocks from start to the first pixel.");
        self.accept.next = self.write.val() && self.walk.load_ready.val();
        self.word.next = self.select.val().get_bits::<4>(0);
        self.channels.next = self.select.val().get_bits::<4>(4);
        self.colour.next = bit_cast_u::<D, 32>(self.data.val());

        self.walk.clock.next = self.clock.val();
        self.walk.write.next = self.accept.val();
        self.walk.write_walk.next = self.accept.val() && !self.channels.val().any();
        self.walk.word.next = self.word.val();
        self.walk.data.next = self.data.val();
        self.walk.start.next = self.start.val();
        self.walk.go.next = !self.walk.fragment.val() || self.ready.val();

        self.red_value.clock.next = self.clock.val();
        self.red_value.write.next = self.accept.val() && self.channels.val().get_bit(0);
        self.red_value.address.next = self.walk.address.val();
        self.red_value.data.next = self.colour.val();
        self.red_value.clear.next = self.walk.clear.val();
        self.red_value.clear_line.next = self.walk.clear_line.val();
        self.red_value.add_value.next = self.walk.add_value.val();
        self.red_value.add_line.next = self.walk.add_line.val();
        self.red_value.add_pixel.next = self.walk.add_pixel.val();
        self.red_value.pixel_step.next = self.walk.pixel_step.val();
        self.red_value.keep_bend.next = self.walk.keep_bend.val();
        self.red_value.take.next = self.walk.take.val();
        self.red_value.run.next = self.walk.run.val();

        self.green_value.clock.next = self.clock.val();
        self.green_value.write.next = self.accept.val() && self.channels.val().get_bit(1);
        self.green_value.address.next = self.walk.address.val();
        self.green_value.data.next = self.colour.val();
        self.green_value.clear.next = self.walk.clear.val();
        self.green_value.clear_line.next = self.walk.clear_line.val();
        self.green_value.add_value.next = self.walk.add_value.val();
        self.green_value.add_line.next = self.walk.add_line.val();
        self.green_value.add_pixel.next = self.walk.add_pixel.val();
        self.green_value.pixel_step.next = self.walk.pixel_step.val();
        self.green_value.keep_bend.next = self.walk.keep_bend.val();
        self.green_value.take.next = self.walk.take.val();
        self.green_value.run.next = self.walk.run.val();

        self.blue_value.clock.next = self.clock.val();
        self.blue_value.write.next = self.accept.val() && self.channels.val().get_bit(2);
        self.blue_value.address.next = self.walk.address.val();
        self.blue_value.data.next = self.colour.val();
        self.blue_value.clear.next = self.walk.clear.val();
        self.blue_value.clear_line.next = self.walk.clear_line.val();
        self.blue_value.add_value.next = self.walk.add_value.val();
        self.blue_value.add_line.next = self.walk.add_line.val();
        self.blue_value.add_pixel.next = self.walk.add_pixel.val();
        self.blue_value.pixel_step.next = self.walk.pixel_step.val();
        self.blue_value.keep_bend.next = self.walk.keep_bend.val();
        self.blue_value.take.next = self.walk.take.val();
        self.blue_value.run.next = self.walk.run.val();

        self.red_byte.value.next = self.red_value.value.val();
        self.green_byte.value.next = self.green_value.value.val();
        self.blue_byte.value.next = self.blue_value.value.val();

        self.load_ready.next = self.walk.load_ready.val();
        self.valid.next = self.walk.fragment.val();
        self.x.next = self.walk.x.val();
        self.y.next = self.walk.y.val();
        self.red.next = self.red_byte.level.val();
        self.green.next = self.green_byte.level.val();
        self.blue.next = self.blue_byte.level.val();
        self.busy.next = self.walk.busy.val();
    }
}

crate::clocked!(CompactUnit<D, M, N, V>, const D: usize, const M: usize, const N: usize, const V: usize;
    inputs write, select, data, start, ready;
    outputs load_ready, valid, x, y, red, green, blue, busy);
