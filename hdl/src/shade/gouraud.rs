//! The Gouraud core: colours linear over a triangle, one addition per pixel and channel (Abbas 2003, chapter 4).
//!
//! # Range and rounding
//! Colours are Q11.N; knots lie in 0..=1530 and a plane stays between its corners. Difference registers hold residues
//! modulo 2^(12+N). With words rounded to nearest the error at a pixel is at most (1 + n)·2^−(N+1) LSB, n = lines +
//! carries + pixels from the start: 0.12 LSB for N = 12 and n ≤ 960 (320×240 with its guard band).

use super::load_lanes::{self, LanePort, Lanes, OneLane, Rest};
use super::pixel_stream::PixelStream;
use crate::format::{bit_cast_u, U};
use crate::interpolate::linear_2::Linear2;
use crate::raster::shell::Shell;
use crate::simulate::{Quiet, Wire};
use rust_hdl_core::prelude::*;

/// `D` = 12 + `N`: width of a colour word; `N`: its fraction bits; `B`: width of the register bus, max(D, 32);
/// `A`: width of a frame address.
///
/// `select` is a channel mask (bit 4 red, 5 green, 6 blue, 7 depth) over a word number (bits 3 to 0); a mask of zero
/// selects the shell's words. One write may go to several channels.
#[derive(LogicBlock)]
pub struct GouraudCore<const D: usize, const N: usize, const B: usize, const A: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to the selected register words; ignored while `load_ready` is low.
    pub write: Signal<In, Bit>,
    /// Channel mask and word number.
    pub select: Signal<In, U<8>>,
    /// Register bus.
    pub data: Signal<In, U<B>>,
    /// The register words are complete; may accompany the last write. Ignored while `load_ready` is low.
    pub start: Signal<In, Bit>,
    /// Clears the depth memory; ignored while `busy`.
    pub clear: Signal<In, Bit>,
    /// The pixel is taken.
    pub ready: Signal<In, Bit>,
    /// The further lanes of the load port.
    pub lanes: LanePort<B>,
    /// Register words may be written.
    pub load_ready: Signal<Out, Bit>,
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
    /// A register write is accepted.
    accept: Wire<Bit>,
    /// Register word.
    word: Wire<U<4>>,
    /// Channel mask, 0 for the shell.
    channels: Wire<U<4>>,
    /// The shell is selected.
    selects_shell: Wire<Bit>,
    /// Register bus as wide as a colour word.
    bus_colour: Wire<U<D>>,
    /// Register bus as wide as a shell word.
    bus_32: Wire<U<32>>,
    /// Register file of the shell, edge walk, pixel counter.
    shell: Quiet<Shell<A>>,
    /// Red.
    red_value: Quiet<Linear2<D, 11, N>>,
    /// Green.
    green_value: Quiet<Linear2<D, 11, N>>,
    /// Blue.
    blue_value: Quiet<Linear2<D, 11, N>>,
    /// Depth less 32768.
    depth_value: Quiet<Linear2<32, 15, 16>>,
    /// Clamp, depth test, output register.
    stream: Quiet<PixelStream<A>>,
}

impl<const D: usize, const N: usize, const B: usize, const A: usize> GouraudCore<D, N, B, A> {
    /// A core whose depth memory has `pixels` words.
    #[must_use]
    pub fn new(pixels: usize) -> Self {
        assert!(
            D == 12 + N && B >= D && B >= 32,
            "a colour word has 12 + N bits and fits the bus"
        );
        Self {
            clock: Default::default(),
            write: Default::default(),
            select: Default::default(),
            data: Default::default(),
            start: Default::default(),
            clear: Default::default(),
            ready: Default::default(),
            lanes: Default::default(),
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
            word: Default::default(),
            channels: Default::default(),
            selects_shell: Default::default(),
            bus_colour: Default::default(),
            bus_32: Default::default(),
            shell: Default::default(),
            red_value: Default::default(),
            green_value: Default::default(),
            blue_value: Default::default(),
            depth_value: Default::default(),
            stream: PixelStream::new(pixels).into(),
        }
    }
}

/// One word per clock: `select` is decoded for all targets.
impl<const D: usize, const N: usize, const B: usize, const A: usize> load_lanes::Part<OneLane>
    for GouraudCore<D, N, B, A>
{
    #[hdl_gen]
    fn update(&mut self) {
        self.accept.next = self.write.val() && self.shell.load_ready.val();
        self.word.next = self.select.val().get_bits::<4>(0);
        self.channels.next = self.select.val().get_bits::<4>(4);
        self.selects_shell.next = !self.channels.val().any();
        self.bus_32.next = bit_cast_u::<32, B>(self.data.val());
        self.bus_colour.next = bit_cast_u::<D, B>(self.data.val());
        self.shell.word.next = self.word.val();
        self.shell.data.next = self.bus_32.val();
        self.red_value.word.next = self.word.val();
        self.red_value.data.next = self.bus_colour.val();
        self.green_value.word.next = self.word.val();
        self.green_value.data.next = self.bus_colour.val();
        self.blue_value.word.next = self.word.val();
        self.blue_value.data.next = self.bus_colour.val();
        self.depth_value.word.next = self.word.val();
        self.depth_value.data.next = self.bus_32.val();
    }
}

/// Several words per clock: each target has its own.
impl<const D: usize, const N: usize, const B: usize, const A: usize> load_lanes::Part<Lanes>
    for GouraudCore<D, N, B, A>
{
    #[hdl_gen]
    fn update(&mut self) {
        self.accept.next = self.shell.load_ready.val();
        self.word.next = self.lanes.shell_word.val();
        self.channels.next = self.lanes.channels.val();
        self.selects_shell.next = self.lanes.shell_write.val();
        self.bus_32.next = bit_cast_u::<32, B>(self.lanes.shell_data.val());
        self.bus_colour.next = bit_cast_u::<D, B>(self.lanes.first_data.val());
        self.shell.word.next = self.word.val();
        self.shell.data.next = self.bus_32.val();
        self.red_value.word.next = self.lanes.first_word.val();
        self.red_value.data.next = self.bus_colour.val();
        self.green_value.word.next = self.lanes.second_word.val();
        self.green_value.data.next = bit_cast_u::<D, B>(self.lanes.second_data.val());
        self.blue_value.word.next = self.lanes.third_word.val();
        self.blue_value.data.next = bit_cast_u::<D, B>(self.lanes.third_data.val());
        self.depth_value.word.next = self.lanes.fourth_word.val();
        self.depth_value.data.next = bit_cast_u::<32, B>(self.lanes.fourth_data.val());
    }
}

impl<const D: usize, const N: usize, const B: usize, const A: usize> load_lanes::Part<Rest>
    for GouraudCore<D, N, B, A>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name gouraud_core");
        comment!("title Gouraud shading core: linear colours, depth test, pixel stream.");
        comment!("equation I(x, y) = T2 x + T1 y + T0 per channel, by forward differences");
        comment!("source Abbas 2003, chapter 4 and figure 4.5.");
        comment!("latency Five clocks from start to the first pixel; then one pixel per clock.");

        self.shell.clock.next = self.clock.val();
        self.shell.write.next = self.accept.val() && self.selects_shell.val();
        self.shell.start.next = self.start.val();
        self.shell.hold.next = self.stream.clearing.val();
        self.shell.go.next = self.stream.go.val();

        self.red_value.clock.next = self.clock.val();
        self.red_value.write.next = self.accept.val() && self.channels.val().get_bit(0);
        self.red_value.load.next = self.shell.load.val();
        self.red_value.step.next = self.shell.step.val();
        self.red_value.carry.next = self.shell.carry.val();
        self.red_value.take.next = self.shell.take.val();
        self.red_value.run.next = self.shell.run.val();

        self.green_value.clock.next = self.clock.val();
        self.green_value.write.next = self.accept.val() && self.channels.val().get_bit(1);
        self.green_value.load.next = self.shell.load.val();
        self.green_value.step.next = self.shell.step.val();
        self.green_value.carry.next = self.shell.carry.val();
        self.green_value.take.next = self.shell.take.val();
        self.green_value.run.next = self.shell.run.val();

        self.blue_value.clock.next = self.clock.val();
        self.blue_value.write.next = self.accept.val() && self.channels.val().get_bit(2);
        self.blue_value.load.next = self.shell.load.val();
        self.blue_value.step.next = self.shell.step.val();
        self.blue_value.carry.next = self.shell.carry.val();
        self.blue_value.take.next = self.shell.take.val();
        self.blue_value.run.next = self.shell.run.val();

        self.depth_value.clock.next = self.clock.val();
        self.depth_value.write.next = self.accept.val() && self.channels.val().get_bit(3);
        self.depth_value.load.next = self.shell.load.val();
        self.depth_value.step.next = self.shell.step.val();
        self.depth_value.carry.next = self.shell.carry.val();
        self.depth_value.take.next = self.shell.take.val();
        self.depth_value.run.next = self.shell.run.val();

        self.stream.clock.next = self.clock.val();
        self.stream.clear.next = self.clear.val();
        self.stream.ready.next = self.ready.val();
        self.stream.walking.next = self.shell.busy.val();
        self.stream.fragment.next = self.shell.fragment.val();
        self.stream.fragment_x.next = self.shell.x.val();
        self.stream.fragment_y.next = self.shell.y.val();
        self.stream.address.next = self.shell.address.val();
        self.stream.fragment_red.next = self.red_value.value.val();
        self.stream.fragment_green.next = self.green_value.value.val();
        self.stream.fragment_blue.next = self.blue_value.value.val();
        self.stream.fragment_depth.next = self.depth_value.value.val();

        self.load_ready.next = self.shell.load_ready.val();
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

crate::lane_core!(GouraudCore<D, N, B, A>, const D: usize, const N: usize, const B: usize, const A: usize;
    outputs load_ready, valid, x, y, red, green, blue, depth, busy, done);
