//! The quadratic-dots core: six-knot N·L and N·H over a triangle, the reflection model per pixel; ours.
//!
//! N·L and N·H are smooth where the colour has an edge or a peak, so two quadrics, at two additions per pixel each, do
//! for them what three cannot do for the colour: 0.4 LSB from Phong shading where six-knot colours have 5.4 (spread 20°,
//! n = 20). The power comes from a table in block RAM for any n from 1 to 2048, the three channels from six multipliers,
//! so the cost does not depend on the number of channels. One light; taylor and x-shading differ in set-up alone.
//!
//! # Materials
//! Colours and power table belong to a material, not to a triangle: one table, reloaded behind a *fence*. A write to
//! shell word 12 lowers `load_ready` until every pixel before it has been coloured; then the host writes the material.
//! A change costs the drained pipeline and 521 words, so objects should be drawn material by material; several tables
//! would cost a block RAM each and buy nothing for such a scene.
//!
//! # Range and rounding
//! N·L accumulates in Q2.(16+N), t = (1 − N·H)·2^s in Q10.(19+N), see [`super::phong::power`]; knots within ±2 make both
//! fit, and differences of thin triangles are residues as in [`super::quadratic`]. With n = lines + carries + pixels the
//! accumulators are off by at most (1 + n(n + 1)/2)·2^−(17+N) and ·2^−(20+N); one LSB of 255 is that times 255, and times
//! 255·19.4 for the lobe, whatever the exponent. For N = 15 and n ≤ 1023 that is 0.03 + 0.08 LSB, and the stages behind add
//! [`super::phong::ERROR_LSB`], 0.05: faithful, since the half for rounding to nearest comes on top.

use super::load_lanes::{self, LanePort, Lanes, OneLane, Rest};
use super::phong::colour::PhongColour;
use super::phong::fragment_delay::FragmentDelay;
use super::pixel_stream::PixelStream;
use crate::format::{bit_cast_u, U};
use crate::interpolate::linear_2::Linear2;
use crate::interpolate::quadratic_2::Quadratic2;
use crate::raster::shell::Shell;
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// `N`: fraction bits of the accumulators below the units of the stages behind; `B` = 30 + `N`: width of the register
/// bus; `A`: width of a frame address.
///
/// `select` is a mask (bit 4 N·L, 5 place in the lobe, 6 material, 7 depth) over a word number (bits 3 to 0); a mask of
/// zero selects the shell's words, and word 12 the fence.
#[derive(LogicBlock)]
pub struct QuadraticDotsCore<const N: usize, const B: usize, const A: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to the selected register words; ignored while `load_ready` is low.
    pub write: Signal<In, Bit>,
    /// Mask and word number.
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
    /// Nothing is accepted until the pixels on their way have been coloured.
    draining: Register<Bit>,
    /// Register words are taken.
    open: Wire<Bit>,
    /// A register write is accepted.
    accept: Wire<Bit>,
    /// Register word.
    word: Wire<U<4>>,
    /// Mask, 0 for the shell.
    targets: Wire<U<4>>,
    /// The shell is selected.
    selects_shell: Wire<Bit>,
    /// The fence is written.
    fence: Wire<Bit>,
    /// A triangle is waiting or being walked, or a pixel has no colour yet.
    walking: Wire<Bit>,
    /// Register bus as wide as a shell word.
    bus_32: Wire<U<32>>,
    /// Register file of the shell, edge walk, pixel counter.
    shell: Quiet<Shell<A>>,
    /// N.L in units of 2^-16.
    light: Quiet<Quadratic2<B, 18, N>>,
    /// Place in the lobe, (1 - N.H) 2^s, in units of 2^-19.
    lobe: Quiet<Quadratic2<B, 29, N>>,
    /// Depth less 32768.
    depth_value: Quiet<Linear2<32, 15, 16>>,
    /// The reflection model.
    colour: Quiet<PhongColour>,
    /// Where the pixels are, stages 1 to 3.
    early: Quiet<FragmentDelay<A>>,
    /// Where the pixels are, stages 4 to 6.
    late: Quiet<FragmentDelay<A>>,
    /// Clamp, depth test, output register.
    stream: Quiet<PixelStream<A>>,
}

impl<const N: usize, const B: usize, const A: usize> QuadraticDotsCore<N, B, A> {
    /// A core whose depth memory has `pixels` words.
    #[must_use]
    pub fn new(pixels: usize) -> Self {
        assert!(B == 30 + N, "the bus is as wide as a word of the lobe");
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
            draining: Default::default(),
            open: Default::default(),
            accept: Default::default(),
            word: Default::default(),
            targets: Default::default(),
            selects_shell: Default::default(),
            fence: Default::default(),
            walking: Default::default(),
            bus_32: Default::default(),
            shell: Default::default(),
            light: Default::default(),
            lobe: Default::default(),
            depth_value: Default::default(),
            colour: Default::default(),
            early: Default::default(),
            late: Default::default(),
            stream: PixelStream::new(pixels).into(),
        }
    }
}

/// One word per clock: `select` is decoded for all targets.
impl<const N: usize, const B: usize, const A: usize> load_lanes::Part<OneLane>
    for QuadraticDotsCore<N, B, A>
{
    #[hdl_gen]
    fn update(&mut self) {
        self.open.next = self.shell.load_ready.val() && !self.draining.q.val();
        self.accept.next = self.write.val() && self.open.val();
        self.word.next = self.select.val().get_bits::<4>(0);
        self.targets.next = self.select.val().get_bits::<4>(4);
        self.selects_shell.next = !self.targets.val().any();
        self.fence.next =
            self.accept.val() && self.selects_shell.val() && (self.word.val() == 12u64.into());
        self.bus_32.next = bit_cast_u::<32, B>(self.data.val());
        self.shell.word.next = self.word.val();
        self.shell.data.next = self.bus_32.val();
        self.light.word.next = self.word.val();
        self.light.data.next = self.data.val();
        self.lobe.word.next = self.word.val();
        self.lobe.data.next = self.data.val();
        self.depth_value.word.next = self.word.val();
        self.depth_value.data.next = self.bus_32.val();
        self.colour.word.next = self.word.val();
        self.colour.data.next = self.bus_32.val();
    }
}

/// Several words per clock: each target has its own.
impl<const N: usize, const B: usize, const A: usize> load_lanes::Part<Lanes>
    for QuadraticDotsCore<N, B, A>
{
    #[hdl_gen]
    fn update(&mut self) {
        self.open.next = self.shell.load_ready.val() && !self.draining.q.val();
        self.accept.next = self.open.val();
        self.word.next = self.lanes.shell_word.val();
        self.targets.next = self.lanes.channels.val();
        self.selects_shell.next = self.lanes.shell_write.val();
        self.fence.next =
            self.accept.val() && self.selects_shell.val() && (self.word.val() == 12u64.into());
        self.bus_32.next = bit_cast_u::<32, B>(self.lanes.shell_data.val());
        self.shell.word.next = self.word.val();
        self.shell.data.next = self.bus_32.val();
        self.light.word.next = self.lanes.first_word.val();
        self.light.data.next = self.lanes.first_data.val();
        self.lobe.word.next = self.lanes.second_word.val();
        self.lobe.data.next = self.lanes.second_data.val();
        self.depth_value.word.next = self.lanes.fourth_word.val();
        self.depth_value.data.next = bit_cast_u::<32, B>(self.lanes.fourth_data.val());
        self.colour.word.next = self.lanes.third_word.val();
        self.colour.data.next = bit_cast_u::<32, B>(self.lanes.third_data.val());
    }
}

impl<const N: usize, const B: usize, const A: usize> load_lanes::Part<Rest>
    for QuadraticDotsCore<N, B, A>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name quadratic_dots_core");
        comment!("title Quadratic dot products, the reflection model per pixel, depth test, pixel stream.");
        comment!("equation I = ambient + diffuse max(0, N.L) + specular max(0, N.H)^n; N.L and N.H quadratic in x and y");
        comment!("source Six-knot quadrics of Abbas 2003, chapter 7, of the dot products instead of the colours.");
        comment!("latency Eleven clocks from start to the first pixel; then one pixel per clock.");
        dff_setup!(self, clock, draining);
        self.walking.next = self.shell.busy.val() || self.early.busy.val() || self.late.busy.val();
        if self.fence.val() {
            self.draining.d.next = true;
        } else if !self.walking.val() {
            self.draining.d.next = false;
        }

        self.shell.clock.next = self.clock.val();
        self.shell.write.next = self.accept.val() && self.selects_shell.val();
        self.shell.start.next = self.start.val() && self.open.val();
        self.shell.hold.next = self.stream.clearing.val();
        self.shell.go.next = self.stream.go.val();

        self.light.clock.next = self.clock.val();
        self.light.write.next = self.accept.val() && self.targets.val().get_bit(0);
        self.light.load.next = self.shell.load.val();
        self.light.step.next = self.shell.step.val();
        self.light.carry.next = self.shell.carry.val();
        self.light.take.next = self.shell.take.val();
        self.light.run.next = self.shell.run.val();

        self.lobe.clock.next = self.clock.val();
        self.lobe.write.next = self.accept.val() && self.targets.val().get_bit(1);
        self.lobe.load.next = self.shell.load.val();
        self.lobe.step.next = self.shell.step.val();
        self.lobe.carry.next = self.shell.carry.val();
        self.lobe.take.next = self.shell.take.val();
        self.lobe.run.next = self.shell.run.val();

        self.depth_value.clock.next = self.clock.val();
        self.depth_value.write.next = self.accept.val() && self.targets.val().get_bit(3);
        self.depth_value.load.next = self.shell.load.val();
        self.depth_value.step.next = self.shell.step.val();
        self.depth_value.carry.next = self.shell.carry.val();
        self.depth_value.take.next = self.shell.take.val();
        self.depth_value.run.next = self.shell.run.val();

        self.colour.clock.next = self.clock.val();
        self.colour.go.next = self.stream.go.val();
        self.colour.write.next = self.accept.val() && self.targets.val().get_bit(2);
        self.colour.light.next = self.light.value.val();
        self.colour.place.next = self.lobe.value.val();

        self.early.clock.next = self.clock.val();
        self.early.go.next = self.stream.go.val();
        self.early.fragment.next = self.shell.fragment.val();
        self.early.x.next = self.shell.x.val();
        self.early.y.next = self.shell.y.val();
        self.early.address.next = self.shell.address.val();
        self.early.depth.next = self.depth_value.value.val();

        self.late.clock.next = self.clock.val();
        self.late.go.next = self.stream.go.val();
        self.late.fragment.next = self.early.late_fragment.val();
        self.late.x.next = self.early.late_x.val();
        self.late.y.next = self.early.late_y.val();
        self.late.address.next = self.early.late_address.val();
        self.late.depth.next = self.early.late_depth.val();

        self.stream.clock.next = self.clock.val();
        self.stream.clear.next = self.clear.val();
        self.stream.ready.next = self.ready.val();
        self.stream.walking.next = self.walking.val();
        self.stream.fragment.next = self.late.late_fragment.val();
        self.stream.fragment_x.next = self.late.late_x.val();
        self.stream.fragment_y.next = self.late.late_y.val();
        self.stream.address.next = self.late.late_address.val();
        self.stream.fragment_red.next = self.colour.red.val();
        self.stream.fragment_green.next = self.colour.green.val();
        self.stream.fragment_blue.next = self.colour.blue.val();
        self.stream.fragment_depth.next = self.late.late_depth.val();

        self.load_ready.next = self.open.val();
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

crate::lane_core!(QuadraticDotsCore<N, B, A>, const N: usize, const B: usize, const A: usize;
    outputs load_ready, valid, x, y, red, green, blue, depth, busy, done);
