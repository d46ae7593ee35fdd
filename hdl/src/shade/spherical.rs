//! The spherical core: N·L and N·H along a span are cosines of angles that grow evenly, A·cos(tg − α) (Abbas 2003,
//! chapter 6, equations 6.6 to 6.11, figure 6.6). Two phase accumulators address a table of cos and a table of cos² or of
//! the material's own cosⁿ; the words are multiplied by the amplitudes A and Aⁿ of the span, and then by the colours.
//!
//! The tables are written by the host, so that one core draws with either, and with up to four materials in a frame.
//! `K`, 4 to 10, is the number of their address and data bits: 6 gives the 384 bits that the thesis proposes.
//!
//! # Range and rounding
//! See [`crate::lit::angle`] for the phase: it is within 1/32 of a table word after 1024 pixels, where the 12 bits of
//! figure 6.6 are 4 words off, and cannot wrap. A factor is then within the table's own distance from its function
//! (bins of centre values, by K: 17.6, 9.1, 4.7, 2.6, 1.2, 0.6, 0.3 LSB of full scale for cos²), and what the phase may
//! add where it misses a bin by its rounding: 1/32 of the step between two words.

use super::load_lanes::{self, LanePort, Lanes, OneLane, Rest};
use crate::format::{bit_cast_u, U};
use crate::interpolate::linear_span::LinearSpan;
use crate::lit::angle::AngleFactor;
use crate::lit::loader::TableLoader;
use crate::lit::stream::LitStream;
use crate::lit::table_memory::TableMemory;
use crate::raster::span_shell::SpanShell;
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// `A` is the width of a frame address, `K` the address and data bits of the tables; `M` = `K` + 6, `P` = `K` + 18,
/// `H` = `K` + 2. `select` is a target mask (bit 4 diffuse term, bit 5 highlight, bit 7 depth) over a word number (bits 3
/// to 0); a mask of zero selects the words of shell and tables. One write may go to several targets.
#[derive(LogicBlock)]
pub struct SphericalCore<
    const A: usize,
    const K: usize,
    const M: usize,
    const P: usize,
    const H: usize,
> {
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
    /// A table word on the register bus.
    bus_word: Wire<U<K>>,
    /// Address of the highlight table.
    power_place: Wire<U<H>>,
    /// Material, first stage.
    material_first: Register<U<2>>,
    /// Register file of the shell and the walk along a span.
    shell: Quiet<SpanShell<A>>,
    /// Strobes of the tables.
    loader: Quiet<TableLoader>,
    /// Depth less 32768.
    depth_value: Quiet<LinearSpan<15, 16>>,
    /// Diffuse factor.
    diffuse: Quiet<AngleFactor<K, M, P>>,
    /// Factor of the highlight.
    highlight: Quiet<AngleFactor<K, M, P>>,
    /// cos over a quarter of a turn.
    cosines: Quiet<TableMemory<K, K>>,
    /// The functions of the materials' highlights.
    highlights: Quiet<TableMemory<H, K>>,
    /// Colours, depth test, output register.
    stream: Quiet<LitStream<A>>,
}

impl<const A: usize, const K: usize, const M: usize, const P: usize, const H: usize>
    SphericalCore<A, K, M, P, H>
{
    /// A core whose depth memory has `pixels` words.
    #[must_use]
    pub fn new(pixels: usize) -> Self {
        assert!(
            H == K + 2 && K >= 4,
            "the highlight table has {K} + 2 address bits"
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
            targets: Default::default(),
            selects_shell: Default::default(),
            selects_diffuse: Default::default(),
            selects_highlight: Default::default(),
            bus_word: Default::default(),
            power_place: Default::default(),
            material_first: Default::default(),
            shell: Default::default(),
            loader: Default::default(),
            depth_value: Default::default(),
            diffuse: Default::default(),
            highlight: Default::default(),
            cosines: Default::default(),
            highlights: Default::default(),
            stream: LitStream::new(pixels).into(),
        }
    }
}

/// One word per clock: `select` is decoded for all targets.
impl<const A: usize, const K: usize, const M: usize, const P: usize, const H: usize>
    load_lanes::Part<OneLane> for SphericalCore<A, K, M, P, H>
{
    #[hdl_gen]
    fn update(&mut self) {
        self.accept.next = self.write.val() && self.shell.load_ready.val();
        self.word.next = self.select.val().get_bits::<4>(0);
        self.targets.next = self.select.val().get_bits::<4>(4);
        self.selects_shell.next = self.accept.val() && !self.targets.val().any();
        self.selects_diffuse.next = self.accept.val() && self.targets.val().get_bit(0);
        self.selects_highlight.next = self.accept.val() && self.targets.val().get_bit(1);
        self.shell.word.next = self.word.val();
        self.shell.data.next = self.data.val();
        self.loader.word.next = self.word.val();
        self.loader.data.next = self.data.val();
        self.depth_value.word.next = self.word.val();
        self.depth_value.data.next = self.data.val();
        self.diffuse.word.next = self.word.val();
        self.diffuse.data.next = self.data.val();
        self.bus_word.next = self.data.val().get_bits::<K>(0);
        self.highlight.word.next = self.word.val();
        self.highlight.data.next = self.data.val();
        self.stream.data.next = self.data.val();
    }
}

/// Several words per clock: each target has its own.
impl<const A: usize, const K: usize, const M: usize, const P: usize, const H: usize>
    load_lanes::Part<Lanes> for SphericalCore<A, K, M, P, H>
{
    #[hdl_gen]
    fn update(&mut self) {
        self.accept.next = self.shell.load_ready.val();
        self.word.next = self.lanes.shell_word.val();
        self.targets.next = self.lanes.channels.val();
        self.selects_shell.next = self.accept.val() && self.lanes.shell_write.val();
        self.selects_diffuse.next = self.accept.val() && self.targets.val().get_bit(0);
        self.selects_highlight.next = self.accept.val() && self.targets.val().get_bit(1);
        self.shell.word.next = self.word.val();
        self.shell.data.next = self.lanes.shell_data.val();
        self.loader.word.next = self.word.val();
        self.loader.data.next = self.lanes.shell_data.val();
        self.depth_value.word.next = self.lanes.fourth_word.val();
        self.depth_value.data.next = self.lanes.fourth_data.val();
        self.diffuse.word.next = self.lanes.first_word.val();
        self.diffuse.data.next = self.lanes.first_data.val();
        self.bus_word.next = self.lanes.shell_data.val().get_bits::<K>(0);
        self.highlight.word.next = self.lanes.second_word.val();
        self.highlight.data.next = self.lanes.second_data.val();
        self.stream.data.next = self.lanes.shell_data.val();
    }
}

impl<const A: usize, const K: usize, const M: usize, const P: usize, const H: usize>
    load_lanes::Part<Rest> for SphericalCore<A, K, M, P, H>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name spherical_core");
        comment!("title Spherical shading core: tables at evenly growing angles, amplitudes, depth test, pixel stream.");
        comment!(
            "equation I = ambient + diffuse A cos(xi) + highlight A^n f(eta), f = cos^2 or cos^n"
        );
        comment!("source Abbas 2003, chapter 6, equations 6.6 to 6.11 and figure 6.6; phase widened, nothing wraps.");
        comment!("latency Nine clocks from start to the first pixel; then one pixel per clock.");
        dff_setup!(self, clock, material_first);
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

        // Diffuse term.
        self.diffuse.clock.next = self.clock.val();
        self.diffuse.go.next = self.stream.go.val();
        self.diffuse.write.next = self.selects_diffuse.val();
        self.diffuse.take.next = self.shell.take.val();
        self.diffuse.run.next = self.shell.run.val();
        self.cosines.clock.next = self.clock.val();
        self.cosines.read.next = self.stream.go.val();
        self.cosines.read_address.next = self.diffuse.address.val();
        self.cosines.write.next = self.loader.write_cosine.val();
        self.cosines.write_address.next = self.loader.address.val().get_bits::<K>(0);
        self.cosines.write_data.next = self.bus_word.val();
        self.diffuse.table_word.next = self.cosines.read_data.val();

        // Highlight.
        self.highlight.clock.next = self.clock.val();
        self.highlight.go.next = self.stream.go.val();
        self.highlight.write.next = self.selects_highlight.val();
        self.highlight.take.next = self.shell.take.val();
        self.highlight.run.next = self.shell.run.val();
        if self.stream.go.val() {
            self.material_first.d.next = self.shell.material.val();
        }
        self.power_place.next = (bit_cast_u::<H, K>(self.highlight.address.val()) << 2u64)
            | bit_cast_u::<H, 2>(self.material_first.q.val());
        self.highlights.clock.next = self.clock.val();
        self.highlights.read.next = self.stream.go.val();
        self.highlights.read_address.next = self.power_place.val();
        self.highlights.write.next = self.loader.write_highlight.val();
        self.highlights.write_address.next = self.loader.address.val().get_bits::<H>(0);
        self.highlights.write_data.next = self.bus_word.val();
        self.highlight.table_word.next = self.highlights.read_data.val();

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

crate::lane_core!(SphericalCore<A, K, M, P, H>, const A: usize, const K: usize, const M: usize, const P: usize, const H: usize;
    outputs load_ready, valid, x, y, red, green, blue, depth, busy, done);
