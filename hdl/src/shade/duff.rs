//! The Duff core: N·L and N·H linear and |N|² quadratic over a triangle, a root per pixel: Phong shading itself.
//!
//! Where light and viewer are far, N·L = p/√q with p linear and q = |N|² quadratic on the screen (Duff 1979; Hast 2004,
//! equations 2.44 and 3.234–3.241), for the blended normal with its perspective weights. So the cosines are exact but for
//! arithmetic, however far the normals spread: the yardstick for the cores that approximate them. Per pixel four
//! additions, one over a root by table and Newton step, two products; then the reflection model of the
//! [quadratic-dots core](super::quadratic_dots), with its power table, fence and material words.
//!
//! # Range and rounding
//! Normals are scaled so that no vertex exceeds length 1; the host refuses triangles whose |N|² falls below 2^−6. All three
//! accumulate in Q1.(28+N); with n = lines + carries + pixels N·L and N·H are off by at most (1 + n)·2^−(29+N), |N|² by
//! (1 + n(n + 1)/2)·2^−(29+N). For N = 15, n ≤ 1023 and |N|² ≥ 1/4 a cosine is then within 2.1e−6, nearly all from the
//! root ([`super::phong::inverse_root`]); magnified by at most 255·19.4·2^s for the highlight. That is 0.08 LSB for n ≤ 144
//! (s ≤ 3), 0.33 for n ≤ 600 (s = 5), which is the largest exponent that the core takes.

use super::load_lanes::{self, LanePort, Lanes, OneLane, Rest};
use super::phong::colour::PhongColour;
use super::phong::fragment_delay::FragmentDelay;
use super::phong::unit_cosines::UnitCosines;
use super::pixel_stream::PixelStream;
use crate::format::{bit_cast_u, U};
use crate::interpolate::linear_2::Linear2;
use crate::interpolate::quadratic_2::Quadratic2;
use crate::raster::shell::Shell;
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// `N`: fraction bits of the accumulators below units of 2^−28; `B` = 30 + `N`: width of the register bus; `A`: width of a
/// frame address.
///
/// `select` is a mask (bit 4 N·L in words 0 to 3 and N·H in words 4 to 7, bit 5 |N|², 6 material, 7 depth) over a word
/// number (bits 3 to 0); a mask of zero selects the shell's words, and word 12 the fence.
#[derive(LogicBlock)]
pub struct DuffCore<const N: usize, const B: usize, const A: usize> {
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
    /// A word of N.L or N.H is written.
    writes_dots: Wire<Bit>,
    /// It is one of N.H.
    second: Wire<Bit>,
    /// Word of N.L or N.H.
    dot_word: Wire<U<4>>,
    /// The same within the four of each.
    low_word: Wire<U<2>>,
    /// N.L of the blended normal.
    light: Quiet<Linear2<B, 29, N>>,
    /// N.H of the blended normal.
    half: Quiet<Linear2<B, 29, N>>,
    /// N.N of the blended normal.
    square: Quiet<Quadratic2<B, 29, N>>,
    /// Scale of the lobe on the bus.
    scale: Wire<U<3>>,
    /// The cosines of the unit normal.
    cosines: Quiet<UnitCosines>,
    /// Depth less 32768.
    depth_value: Quiet<Linear2<32, 15, 16>>,
    /// The reflection model.
    colour: Quiet<PhongColour>,
    /// Where the pixels are, stages 1 to 3.
    place_a: Quiet<FragmentDelay<A>>,
    /// Stages 4 to 6.
    place_b: Quiet<FragmentDelay<A>>,
    /// Stages 7 to 9.
    place_c: Quiet<FragmentDelay<A>>,
    /// Stages 10 to 12.
    place_d: Quiet<FragmentDelay<A>>,
    /// Stages 13 to 15.
    place_e: Quiet<FragmentDelay<A>>,
    /// Clamp, depth test, output register.
    stream: Quiet<PixelStream<A>>,
}

impl<const N: usize, const B: usize, const A: usize> DuffCore<N, B, A> {
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
            scale: Default::default(),
            writes_dots: Default::default(),
            second: Default::default(),
            dot_word: Default::default(),
            low_word: Default::default(),
            light: Default::default(),
            half: Default::default(),
            square: Default::default(),
            cosines: Default::default(),
            depth_value: Default::default(),
            colour: Default::default(),
            place_a: Default::default(),
            place_b: Default::default(),
            place_c: Default::default(),
            place_d: Default::default(),
            place_e: Default::default(),
            stream: PixelStream::new(pixels).into(),
        }
    }
}

/// One word per clock: `select` is decoded for all targets.
impl<const N: usize, const B: usize, const A: usize> load_lanes::Part<OneLane>
    for DuffCore<N, B, A>
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
        self.walking.next = self.shell.busy.val()
            || self.place_a.busy.val()
            || self.place_b.busy.val()
            || self.place_c.busy.val()
            || self.place_d.busy.val()
            || self.place_e.busy.val();
        self.shell.word.next = self.word.val();
        self.shell.data.next = self.bus_32.val();
        self.writes_dots.next = self.accept.val() && self.targets.val().get_bit(0);
        self.second.next = self.word.val().get_bit(2);
        self.low_word.next = self.word.val().get_bits::<2>(0);
        self.dot_word.next = bit_cast_u::<4, 2>(self.low_word.val());
        self.light.data.next = self.data.val();
        self.half.data.next = self.data.val();
        self.square.word.next = self.word.val();
        self.square.data.next = self.data.val();
        self.depth_value.word.next = self.word.val();
        self.depth_value.data.next = self.bus_32.val();
        self.scale.next = self.data.val().get_bits::<3>(0);
        self.cosines.write_scale.next =
            self.accept.val() && self.targets.val().get_bit(2) && (self.word.val() == 11u64.into());
        self.colour.word.next = self.word.val();
        self.colour.data.next = self.bus_32.val();
    }
}

/// Several words per clock: each target has its own.
impl<const N: usize, const B: usize, const A: usize> load_lanes::Part<Lanes> for DuffCore<N, B, A> {
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
        self.walking.next = self.shell.busy.val()
            || self.place_a.busy.val()
            || self.place_b.busy.val()
            || self.place_c.busy.val()
            || self.place_d.busy.val()
            || self.place_e.busy.val();
        self.shell.word.next = self.word.val();
        self.shell.data.next = self.bus_32.val();
        self.writes_dots.next = self.accept.val() && self.targets.val().get_bit(0);
        self.second.next = self.lanes.first_word.val().get_bit(2);
        self.low_word.next = self.lanes.first_word.val().get_bits::<2>(0);
        self.dot_word.next = bit_cast_u::<4, 2>(self.low_word.val());
        self.light.data.next = self.lanes.first_data.val();
        self.half.data.next = self.lanes.first_data.val();
        self.square.word.next = self.lanes.second_word.val();
        self.square.data.next = self.lanes.second_data.val();
        self.depth_value.word.next = self.lanes.fourth_word.val();
        self.depth_value.data.next = bit_cast_u::<32, B>(self.lanes.fourth_data.val());
        self.scale.next = self.lanes.third_data.val().get_bits::<3>(0);
        self.cosines.write_scale.next = self.accept.val()
            && self.targets.val().get_bit(2)
            && (self.lanes.third_word.val() == 11u64.into());
        self.colour.word.next = self.lanes.third_word.val();
        self.colour.data.next = bit_cast_u::<32, B>(self.lanes.third_data.val());
    }
}

impl<const N: usize, const B: usize, const A: usize> load_lanes::Part<Rest> for DuffCore<N, B, A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name duff_core");
        comment!("title Phong shading by a root per pixel, depth test, pixel stream.");
        comment!("equation I = ambient + diffuse max(0, p/sqrt(q)) + specular max(0, h/sqrt(q))^n; p, h linear, q quadratic in x and y");
        comment!("source Duff 1979; Hast 2004, equations 2.44 and 3.234 to 3.241.");
        comment!("latency Twenty clocks from start to the first pixel; then one pixel per clock.");
        dff_setup!(self, clock, draining);
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
        self.light.write.next = self.writes_dots.val() && !self.second.val();
        self.light.word.next = self.dot_word.val();
        self.light.load.next = self.shell.load.val();
        self.light.step.next = self.shell.step.val();
        self.light.carry.next = self.shell.carry.val();
        self.light.take.next = self.shell.take.val();
        self.light.run.next = self.shell.run.val();

        self.half.clock.next = self.clock.val();
        self.half.write.next = self.writes_dots.val() && self.second.val();
        self.half.word.next = self.dot_word.val();
        self.half.load.next = self.shell.load.val();
        self.half.step.next = self.shell.step.val();
        self.half.carry.next = self.shell.carry.val();
        self.half.take.next = self.shell.take.val();
        self.half.run.next = self.shell.run.val();

        self.square.clock.next = self.clock.val();
        self.square.write.next = self.accept.val() && self.targets.val().get_bit(1);
        self.square.load.next = self.shell.load.val();
        self.square.step.next = self.shell.step.val();
        self.square.carry.next = self.shell.carry.val();
        self.square.take.next = self.shell.take.val();
        self.square.run.next = self.shell.run.val();

        self.depth_value.clock.next = self.clock.val();
        self.depth_value.write.next = self.accept.val() && self.targets.val().get_bit(3);
        self.depth_value.load.next = self.shell.load.val();
        self.depth_value.step.next = self.shell.step.val();
        self.depth_value.carry.next = self.shell.carry.val();
        self.depth_value.take.next = self.shell.take.val();
        self.depth_value.run.next = self.shell.run.val();

        self.cosines.clock.next = self.clock.val();
        self.cosines.go.next = self.stream.go.val();
        self.cosines.scale.next = self.scale.val();
        self.cosines.light_dot.next = self.light.value.val();
        self.cosines.half_dot.next = self.half.value.val();
        self.cosines.square.next = self.square.value.val();

        self.colour.clock.next = self.clock.val();
        self.colour.go.next = self.stream.go.val();
        self.colour.write.next = self.accept.val() && self.targets.val().get_bit(2);
        self.colour.light.next = self.cosines.light.val();
        self.colour.place.next = self.cosines.place.val();

        self.place_a.clock.next = self.clock.val();
        self.place_a.go.next = self.stream.go.val();
        self.place_a.fragment.next = self.shell.fragment.val();
        self.place_a.x.next = self.shell.x.val();
        self.place_a.y.next = self.shell.y.val();
        self.place_a.address.next = self.shell.address.val();
        self.place_a.depth.next = self.depth_value.value.val();

        self.place_b.clock.next = self.clock.val();
        self.place_b.go.next = self.stream.go.val();
        self.place_b.fragment.next = self.place_a.late_fragment.val();
        self.place_b.x.next = self.place_a.late_x.val();
        self.place_b.y.next = self.place_a.late_y.val();
        self.place_b.address.next = self.place_a.late_address.val();
        self.place_b.depth.next = self.place_a.late_depth.val();

        self.place_c.clock.next = self.clock.val();
        self.place_c.go.next = self.stream.go.val();
        self.place_c.fragment.next = self.place_b.late_fragment.val();
        self.place_c.x.next = self.place_b.late_x.val();
        self.place_c.y.next = self.place_b.late_y.val();
        self.place_c.address.next = self.place_b.late_address.val();
        self.place_c.depth.next = self.place_b.late_depth.val();

        self.place_d.clock.next = self.clock.val();
        self.place_d.go.next = self.stream.go.val();
        self.place_d.fragment.next = self.place_c.late_fragment.val();
        self.place_d.x.next = self.place_c.late_x.val();
        self.place_d.y.next = self.place_c.late_y.val();
        self.place_d.address.next = self.place_c.late_address.val();
        self.place_d.depth.next = self.place_c.late_depth.val();

        self.place_e.clock.next = self.clock.val();
        self.place_e.go.next = self.stream.go.val();
        self.place_e.fragment.next = self.place_d.late_fragment.val();
        self.place_e.x.next = self.place_d.late_x.val();
        self.place_e.y.next = self.place_d.late_y.val();
        self.place_e.address.next = self.place_d.late_address.val();
        self.place_e.depth.next = self.place_d.late_depth.val();

        self.stream.clock.next = self.clock.val();
        self.stream.clear.next = self.clear.val();
        self.stream.ready.next = self.ready.val();
        self.stream.walking.next = self.walking.val();
        self.stream.fragment.next = self.place_e.late_fragment.val();
        self.stream.fragment_x.next = self.place_e.late_x.val();
        self.stream.fragment_y.next = self.place_e.late_y.val();
        self.stream.address.next = self.place_e.late_address.val();
        self.stream.fragment_red.next = self.colour.red.val();
        self.stream.fragment_green.next = self.colour.green.val();
        self.stream.fragment_blue.next = self.colour.blue.val();
        self.stream.fragment_depth.next = self.place_e.late_depth.val();

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

crate::lane_core!(DuffCore<N, B, A>, const N: usize, const B: usize, const A: usize;
    outputs load_ready, valid, x, y, red, green, blue, depth, busy, done);
