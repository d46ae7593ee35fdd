//! The Blake core: cosⁿ in three quadratic pieces, so that both factors are quadratics of the pixel's place and cost two
//! additions each (Blake, Disselkoen and Kuijk 1992, equation 4; five additions and three registers for one channel,
//! where the fifth adds the two terms: here the colours of three channels are put to them by [`crate::lit::channel`]).
//!
//! A piece ends between two pixels. The host cuts a span where the pieces of either term end and writes each part as a
//! span of its own; the shell takes them without a bubble, so that pieces change at run time, as often as needed, and
//! printed and refitted coefficients differ in the words alone.
//!
//! # Range and rounding
//! Factors are walked in units of 2^−16, Q17.14: value, change and bend are each within 2^−31 of full scale, after k
//! pixels (1 + k + k(k − 1)/2)·2^−31, 0.06 LSB at 1024 pixels and 255 LSB. |value| ≤ 1, |change| ≤ 2 and |bend| ≤ 4 are
//! residues modulo 4 on the way to values that fit.

use super::load_lanes::{self, LanePort, Lanes, OneLane, Rest};
use crate::format::U;
use crate::interpolate::linear_span::LinearSpan;
use crate::interpolate::quadratic_span::QuadraticSpan;
use crate::lit::clamp::ClampFactor;
use crate::lit::loader::TableLoader;
use crate::lit::stream::LitStream;
use crate::raster::span_shell::SpanShell;
use crate::simulate::{Quiet, Wire};
use rust_hdl_core::prelude::*;

/// `A` is the width of a frame address. `select` is a target mask (bit 4 diffuse term, bit 5 highlight, bit 7 depth)
/// over a word number (bits 3 to 0); a mask of zero selects the words of shell and tables. One write may go to several
/// targets.
#[derive(LogicBlock)]
pub struct BlakeCore<const A: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to the selected register words; ignored while `load_ready` is low.
    pub write: Signal<In, Bit>,
    /// Target mask and word number.
    pub select: Signal<In, U<8>>,
    /// Register bus.
    pub data: Signal<In, U<32>>,
    /// The register words are complete; may accompany the last write. Ignored while `load_ready` is low.
    pub start: Signal<In, Bit>,
    /// Clears the depth memory; ignored while `busy`.
    pub clear: Signal<In, Bit>,
    /// The pixel is taken.
    pub ready: Signal<In, Bit>,
    /// The further lanes of the load port.
    pub lanes: LanePort<32>,
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
    /// Target mask, 0 for the shell and the tables.
    targets: Wire<U<4>>,
    /// Shell or tables are selected.
    selects_shell: Wire<Bit>,
    /// The diffuse term is selected.
    selects_diffuse: Wire<Bit>,
    /// The highlight is selected.
    selects_highlight: Wire<Bit>,
    /// Register file of the shell and the walk along a span.
    shell: Quiet<SpanShell<A>>,
    /// Strobes of the tables.
    loader: Quiet<TableLoader>,
    /// Depth less 32768.
    depth_value: Quiet<LinearSpan<15, 16>>,
    /// Diffuse term in units of 1/65536.
    light: Quiet<QuadraticSpan<17, 14>>,
    /// Highlight in units of 1/65536.
    half: Quiet<QuadraticSpan<17, 14>>,
    /// Diffuse factor.
    diffuse: Quiet<ClampFactor>,
    /// Factor of the highlight.
    highlight: Quiet<ClampFactor>,
    /// Colours, depth test, output register.
    stream: Quiet<LitStream<A>>,
}

impl<const A: usize> BlakeCore<A> {
    /// A core whose depth memory has `pixels` words.
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
            targets: Default::default(),
            selects_shell: Default::default(),
            selects_diffuse: Default::default(),
            selects_highlight: Default::default(),
            shell: Default::default(),
            loader: Default::default(),
            depth_value: Default::default(),
            light: Default::default(),
            half: Default::default(),
            diffuse: Default::default(),
            highlight: Default::default(),
            stream: LitStream::new(pixels).into(),
        }
    }
}

/// One word per clock: `select` is decoded for all targets.
impl<const A: usize> load_lanes::Part<OneLane> for BlakeCore<A> {
    #[hdl_gen]
    fn update(&mut self) {
        self.accept.next = self.write.val() && self.shell.load_ready.val();
        self.word.next = self.select.val().get_bits::<4>(0);
        self.targets.next = self.select.val().get_bits::<4>(4);
        self.selects_shell.next = self.accept.val() && !self.targets.val().any();
        self.shell.word.next = self.word.val();
        self.shell.data.next = self.data.val();
        self.loader.word.next = self.word.val();
        self.loader.data.next = self.data.val();
        self.depth_value.word.next = self.word.val();
        self.depth_value.data.next = self.data.val();
        self.light.word.next = self.word.val();
        self.light.data.next = self.data.val();
        self.half.word.next = self.word.val();
        self.half.data.next = self.data.val();
        self.stream.data.next = self.data.val();
    }
}

/// Several words per clock: each target has its own.
impl<const A: usize> load_lanes::Part<Lanes> for BlakeCore<A> {
    #[hdl_gen]
    fn update(&mut self) {
        self.accept.next = self.shell.load_ready.val();
        self.word.next = self.lanes.shell_word.val();
        self.targets.next = self.lanes.channels.val();
        self.selects_shell.next = self.accept.val() && self.lanes.shell_write.val();
        self.shell.word.next = self.word.val();
        self.shell.data.next = self.lanes.shell_data.val();
        self.loader.word.next = self.word.val();
        self.loader.data.next = self.lanes.shell_data.val();
        self.depth_value.word.next = self.lanes.fourth_word.val();
        self.depth_value.data.next = self.lanes.fourth_data.val();
        self.light.word.next = self.lanes.first_word.val();
        self.light.data.next = self.lanes.first_data.val();
        self.half.word.next = self.lanes.second_word.val();
        self.half.data.next = self.lanes.second_data.val();
        self.stream.data.next = self.lanes.shell_data.val();
    }
}

impl<const A: usize> load_lanes::Part<Rest> for BlakeCore<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name blake_core");
        comment!("title Blake shading core: angular interpolation with quadratic pieces, depth test, pixel stream.");
        comment!("equation I = ambient + diffuse q(psi, 1) + highlight q(psi, n), q quadratic between the ends of its pieces");
        comment!("source Blake, Disselkoen and Kuijk 1992, equations 4 to 8, section 3 and appendix; errata put right by the host.");
        comment!("latency Nine clocks from start to the first pixel; then one pixel per clock.");
        self.selects_diffuse.next = self.accept.val() && self.targets.val().get_bit(0);
        self.selects_highlight.next = self.accept.val() && self.targets.val().get_bit(1);
        self.shell.clock.next = self.clock.val();
        self.shell.write.next = self.selects_shell.val();
        self.shell.start.next = self.start.val();
        self.shell.hold.next = self.stream.clearing.val();
        self.shell.go.next = self.stream.go.val();
        self.loader.clock.next = self.clock.val();
        self.loader.write.next = self.selects_shell.val();
        self.depth_value.clock.next = self.clock.val();
        self.depth_value.write.next = self.accept.val() && self.targets.val().get_bit(3);
        self.depth_value.take.next = self.shell.take.val();
        self.depth_value.run.next = self.shell.run.val();

        // The two terms.
        self.light.clock.next = self.clock.val();
        self.light.write.next = self.selects_diffuse.val();
        self.light.take.next = self.shell.take.val();
        self.light.run.next = self.shell.run.val();
        self.half.clock.next = self.clock.val();
        self.half.write.next = self.selects_highlight.val();
        self.half.take.next = self.shell.take.val();
        self.half.run.next = self.shell.run.val();
        self.diffuse.clock.next = self.clock.val();
        self.diffuse.go.next = self.stream.go.val();
        self.diffuse.value.next = self.light.value.val();
        self.highlight.clock.next = self.clock.val();
        self.highlight.go.next = self.stream.go.val();
        self.highlight.value.next = self.half.value.val();

        // Colours and pixels.
        self.stream.clock.next = self.clock.val();
        self.stream.clear.next = self.clear.val();
        self.stream.ready.next = self.ready.val();
        self.stream.walking.next = self.shell.busy.val();
        self.stream.fragment.next = self.shell.fragment.val();
        self.stream.fragment_x.next = self.shell.x.val();
        self.stream.fragment_y.next = self.shell.y.val();
        self.stream.address.next = self.shell.address.val();
        self.stream.fragment_depth.next = self.depth_value.value.val();
        self.stream.material.next = self.shell.material.val();
        self.stream.diffuse.next = self.diffuse.factor.val();
        self.stream.highlight.next = self.highlight.factor.val();
        self.stream.write_colour.next = self.loader.write_colour.val();
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

crate::lane_core!(BlakeCore<A>, const A: usize;
    outputs load_ready, valid, x, y, red, green, blue, depth, busy, done);
