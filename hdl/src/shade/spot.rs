//! The quadratic-dots core under a spot: one more quadric, the place in the cone, and the light that it leaves.
//!
//! N·L, N·H and the cosine e from the axis of the spot go through six knots each; [`crate::light`] has the highlight and
//! the fall-offs, both without tables. So there is no block RAM beside the depth memory, and a change of material costs
//! ten words. A triangle that the cone does not reach is drawn in its ambient colour and needs none of the words of
//! its cosines ([`crate::light::skip`]); of a pixel outside the cone the multipliers stand still.
//!
//! # Range and rounding
//! N·L and N·H as in [`super::kappa`]. The place in the cone accumulates in Q10.(19+N), 1/(1 − g) being at most 128, and its
//! error counts at most twice, the slope of the fall-offs, in both reflections. For N = 15 and n ≤ 1023 that is another
//! 0.02 LSB, and the stages behind add [`crate::light::SPOT_ERROR_LSB`].

use super::phong::fragment_delay::FragmentDelay;
use super::pixel_stream::PixelStream;
use crate::format::{bit_cast_u, U};
use crate::interpolate::linear_2::Linear2;
use crate::interpolate::quadratic_2::Quadratic2;
use crate::light::skip::Skip;
use crate::light::spot_colour::SpotColour;
use crate::raster::shell::Shell;
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// `N`: fraction bits of the accumulators below the units of the stages behind; `B` = 30 + `N`: width of the register
/// bus; `A`: width of a frame address.
///
/// `select` is a mask (bit 4 N·L, 5 place in the lobe, 6 material, 7 depth, place in the cone and skips) over a word number (bits 3 to 0); a mask of
/// zero selects the shell's words, and word 12 the fence.
#[derive(LogicBlock)]
pub struct SpotCore<const N: usize, const B: usize, const A: usize> {
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
    /// A word of the depth, of the skips or of what goes with them is written.
    writes_depth: Wire<Bit>,
    /// Register bus as wide as a shell word.
    bus_32: Wire<U<32>>,
    /// Register file of the shell, edge walk, pixel counter.
    shell: Quiet<Shell<A>>,
    /// N.L in units of 2^-16.
    light: Quiet<Quadratic2<B, 18, N>>,
    /// Place in the lobe, (1 - N.H) / (1 - gamma), in units of 2^-19.
    lobe: Quiet<Quadratic2<B, 29, N>>,
    /// Place in the cone, (1 - e) / (1 - g), in units of 2^-19.
    cone: Quiet<Quadratic2<B, 29, N>>,
    /// Its register word.
    behind_depth: Wire<U<4>>,
    /// Depth less 32768.
    depth_value: Quiet<Linear2<32, 15, 16>>,
    /// What the triangle does without.
    skip: Quiet<Skip>,
    /// The reflection model.
    colour: Quiet<SpotColour>,
    /// Where the pixels are, stages 1 to 3.
    early: Quiet<FragmentDelay<A>>,
    /// Where the pixels are, stages 4 to 6.
    late: Quiet<FragmentDelay<A>>,
    /// Clamp, depth test, output register.
    stream: Quiet<PixelStream<A>>,
    /// Words of the depth before those of the place in the cone.
    behind: Constant<U<4>>,
}

impl<const N: usize, const B: usize, const A: usize> SpotCore<N, B, A> {
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
            writes_depth: Default::default(),
            bus_32: Default::default(),
            shell: Default::default(),
            light: Default::default(),
            lobe: Default::default(),
            cone: Default::default(),
            behind_depth: Default::default(),
            depth_value: Default::default(),
            skip: Default::default(),
            colour: Default::default(),
            early: Default::default(),
            late: Default::default(),
            stream: PixelStream::new(pixels).into(),
            behind: Constant::new(U::new(4)),
        }
    }
}

impl<const N: usize, const B: usize, const A: usize> Logic for SpotCore<N, B, A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name quadratic_dots_spot_core");
        comment!("title Quadratic dot products under a spot, the reflection model per pixel without tables, depth test, pixel stream.");
        comment!("equation I = ambient + D(e) (diffuse max(0, N.L) + specular kappa (N.H - gamma)^d); N.L, N.H and e quadratic in x and y");
        comment!("source Six-knot quadrics of Abbas 2003, chapter 7; highlight and spot of Hast 2004, equations 3.276, 3.273 and 3.274.");
        comment!("latency Eleven clocks from start to the first pixel; then one pixel per clock.");
        dff_setup!(self, clock, draining);
        // Register file.
        self.open.next = self.shell.load_ready.val() && !self.draining.q.val();
        self.accept.next = self.write.val() && self.open.val();
        self.word.next = self.select.val().get_bits::<4>(0);
        self.targets.next = self.select.val().get_bits::<4>(4);
        self.selects_shell.next = !self.targets.val().any();
        self.fence.next =
            self.accept.val() && self.selects_shell.val() && (self.word.val() == 12u64.into());
        self.bus_32.next = bit_cast_u::<32, B>(self.data.val());
        self.walking.next = self.shell.busy.val() || self.early.busy.val() || self.late.busy.val();
        if self.fence.val() {
            self.draining.d.next = true;
        } else if !self.walking.val() {
            self.draining.d.next = false;
        }

        self.shell.clock.next = self.clock.val();
        self.shell.write.next = self.accept.val() && self.selects_shell.val();
        self.shell.word.next = self.word.val();
        self.shell.data.next = self.bus_32.val();
        self.shell.start.next = self.start.val() && self.open.val();
        self.shell.hold.next = self.stream.clearing.val();
        self.shell.go.next = self.stream.go.val();

        self.light.clock.next = self.clock.val();
        self.light.write.next = self.accept.val() && self.targets.val().get_bit(0);
        self.light.word.next = self.word.val();
        self.light.data.next = self.data.val();
        self.light.load.next = self.shell.load.val();
        self.light.step.next = self.shell.step.val();
        self.light.carry.next = self.shell.carry.val();
        self.light.take.next = self.shell.take.val();
        self.light.run.next = self.shell.run.val();

        self.lobe.clock.next = self.clock.val();
        self.lobe.write.next = self.accept.val() && self.targets.val().get_bit(1);
        self.lobe.word.next = self.word.val();
        self.lobe.data.next = self.data.val();
        self.lobe.load.next = self.shell.load.val();
        self.lobe.step.next = self.shell.step.val();
        self.lobe.carry.next = self.shell.carry.val();
        self.lobe.take.next = self.shell.take.val();
        self.lobe.run.next = self.shell.run.val();

        self.depth_value.clock.next = self.clock.val();
        self.writes_depth.next = self.accept.val() && self.targets.val().get_bit(3);
        self.depth_value.write.next = self.writes_depth.val();
        self.depth_value.word.next = self.word.val();
        self.depth_value.data.next = self.bus_32.val();
        self.depth_value.load.next = self.shell.load.val();
        self.depth_value.step.next = self.shell.step.val();
        self.depth_value.carry.next = self.shell.carry.val();
        self.depth_value.take.next = self.shell.take.val();
        self.depth_value.run.next = self.shell.run.val();

        self.behind_depth.next = self.word.val() - self.behind.val();
        self.cone.clock.next = self.clock.val();
        self.cone.write.next = self.writes_depth.val();
        self.cone.word.next = self.behind_depth.val();
        self.cone.data.next = self.data.val();
        self.cone.load.next = self.shell.load.val();
        self.cone.step.next = self.shell.step.val();
        self.cone.carry.next = self.shell.carry.val();
        self.cone.take.next = self.shell.take.val();
        self.cone.run.next = self.shell.run.val();

        self.skip.clock.next = self.clock.val();
        self.skip.write.next = self.writes_depth.val() && (self.word.val() == 15u64.into());
        self.skip.data.next = self.data.val().get_bits::<2>(0);
        self.skip.load.next = self.shell.load.val();
        self.skip.take.next = self.shell.take.val();

        self.colour.clock.next = self.clock.val();
        self.colour.go.next = self.stream.go.val();
        self.colour.write.next = self.accept.val() && self.targets.val().get_bit(2);
        self.colour.word.next = self.word.val();
        self.colour.data.next = self.bus_32.val();
        self.colour.light.next = self.light.value.val();
        self.colour.place.next = self.lobe.value.val();
        self.colour.cone.next = self.cone.value.val();
        self.colour.no_highlight.next = self.skip.no_highlight.val();
        self.colour.no_diffuse.next = self.skip.no_diffuse.val();

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

crate::clocked!(SpotCore<N, B, A>, const N: usize, const B: usize, const A: usize;
    inputs write, select, data, start, clear, ready;
    outputs load_ready, valid, x, y, red, green, blue, depth, busy, done);
