//! The quadratic core: six-knot colours over a triangle, two additions per pixel and channel (Abbas 2003, chapter 7).
//!
//! Per channel I(x, y) = T5 x² + T4 xy + T3 y² + T2 x + T1 y + T0 through three vertices and three mid-edges, set up
//! directly as forward differences (Hast 2004, section 3.3, equations 3.213–3.233), never as T0…T5.
//!
//! # Range and rounding
//! Colours are Q11.N. Knots lie in 0..=1530, so at a covered centre −510 ≤ I ≤ 2040: it fits in ±2048. Difference
//! registers of thin triangles may exceed that; their residues modulo 2^(12+N) still add up to the right value, because
//! every register is a sum of the ten words and the final sum fits. With words rounded to nearest the error at a pixel is
//! at most (1 + n(n + 1)/2)·2^−(N+1) LSB, n = lines + carries + pixels from the start: 0.22 LSB for N = 20 and
//! n ≤ 960 (320×240 with its guard band).

use super::saturate::Saturate;
use crate::depth::z_buffer::ZBuffer;
use crate::format::{bit_cast_u, unsigned_cast_integer, U};
use crate::interpolate::linear_2::Linear2;
use crate::interpolate::quadratic_2::Quadratic2;
use crate::raster::shell::Shell;
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// `D` = 12 + `N`: width of a colour word; `N`: its fraction bits; `B`: width of the register bus, max(D, 32);
/// `A`: width of a frame address.
///
/// `select` is a channel mask (bit 4 red, 5 green, 6 blue, 7 depth) over a word number (bits 3 to 0); a mask of zero
/// selects the shell's words. One write may go to several channels.
#[derive(LogicBlock)]
pub struct QuadraticCore<const D: usize, const N: usize, const B: usize, const A: usize> {
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
    /// Column of the fragment before the depth verdict.
    drawn_x: Register<U<11>>,
    /// Its row.
    drawn_y: Register<U<11>>,
    /// Its red.
    drawn_red: Register<U<8>>,
    /// Its green.
    drawn_green: Register<U<8>>,
    /// Its blue.
    drawn_blue: Register<U<8>>,
    /// A visible pixel is offered.
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
    /// Its depth.
    out_depth: Register<U<16>>,
    /// Busy, one clock ago.
    was_busy: Register<Bit>,
    /// The pipeline moves.
    go: Wire<Bit>,
    /// Anything is waiting, being drawn or being cleared.
    is_busy: Wire<Bit>,
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
    /// Depth less 32768, as bits.
    depth_bits: Wire<U<16>>,
    /// The bias of the depth interpolant: depths 0 to 65535 are walked as -32768 to 32767.
    depth_bias: Constant<U<16>>,
    shell: Quiet<Shell<A>>,
    red_value: Quiet<Quadratic2<D, 11, N>>,
    green_value: Quiet<Quadratic2<D, 11, N>>,
    blue_value: Quiet<Quadratic2<D, 11, N>>,
    depth_value: Quiet<Linear2<32, 15, 16>>,
    red_byte: Quiet<Saturate>,
    green_byte: Quiet<Saturate>,
    blue_byte: Quiet<Saturate>,
    z_buffer: Quiet<ZBuffer<A>>,
}

impl<const D: usize, const N: usize, const B: usize, const A: usize> QuadraticCore<D, N, B, A> {
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
            drawn_x: Default::default(),
            drawn_y: Default::default(),
            drawn_red: Default::default(),
            drawn_green: Default::default(),
            drawn_blue: Default::default(),
            out_valid: Default::default(),
            out_x: Default::default(),
            out_y: Default::default(),
            out_red: Default::default(),
            out_green: Default::default(),
            out_blue: Default::default(),
            out_depth: Default::default(),
            was_busy: Default::default(),
            go: Default::default(),
            is_busy: Default::default(),
            accept: Default::default(),
            word: Default::default(),
            channels: Default::default(),
            selects_shell: Default::default(),
            bus_colour: Default::default(),
            bus_32: Default::default(),
            depth_bits: Default::default(),
            depth_bias: Constant::new(U::new(1 << 15)),
            shell: Default::default(),
            red_value: Default::default(),
            green_value: Default::default(),
            blue_value: Default::default(),
            depth_value: Default::default(),
            red_byte: Default::default(),
            green_byte: Default::default(),
            blue_byte: Default::default(),
            z_buffer: ZBuffer::new(pixels).into(),
        }
    }
}

impl<const D: usize, const N: usize, const B: usize, const A: usize> Logic
    for QuadraticCore<D, N, B, A>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name quadratic_core");
        comment!("title Quadratic shading core: six-knot colours, depth test, pixel stream.");
        comment!("equation I(x, y) = T5 x^2 + T4 x y + T3 y^2 + T2 x + T1 y + T0 per channel, by forward differences");
        comment!("source Abbas 2003, chapter 7 and appendix; set-up Hast 2004, equations 3.213 to 3.233.");
        comment!("latency Five clocks from start to the first pixel; then one pixel per clock.");
        dff_setup!(
            self,
            clock,
            drawn_x,
            drawn_y,
            drawn_red,
            drawn_green,
            drawn_blue,
            out_valid,
            out_x,
            out_y,
            out_red,
            out_green,
            out_blue,
            out_depth,
            was_busy
        );

        // Stages move together; only a pixel that nobody takes stops them.
        self.go.next = !self.out_valid.q.val() || self.ready.val();

        self.is_busy.next = self.shell.busy.val()
            || self.z_buffer.waiting.val()
            || self.z_buffer.clearing.val()
            || self.out_valid.q.val();

        // Register file.
        self.accept.next = self.write.val() && self.shell.load_ready.val();
        self.word.next = self.select.val().get_bits::<4>(0);
        self.channels.next = self.select.val().get_bits::<4>(4);
        self.selects_shell.next = !self.channels.val().any();
        self.bus_32.next = bit_cast_u::<32, B>(self.data.val());
        self.bus_colour.next = bit_cast_u::<D, B>(self.data.val());

        self.shell.clock.next = self.clock.val();
        self.shell.write.next = self.accept.val() && self.selects_shell.val();
        self.shell.word.next = self.word.val();
        self.shell.data.next = self.bus_32.val();
        self.shell.start.next = self.start.val();
        self.shell.hold.next = self.z_buffer.clearing.val();
        self.shell.go.next = self.go.val();

        self.red_value.clock.next = self.clock.val();
        self.red_value.write.next = self.accept.val() && self.channels.val().get_bit(0);
        self.red_value.word.next = self.word.val();
        self.red_value.data.next = self.bus_colour.val();
        self.red_value.load.next = self.shell.load.val();
        self.red_value.step.next = self.shell.step.val();
        self.red_value.carry.next = self.shell.carry.val();
        self.red_value.take.next = self.shell.take.val();
        self.red_value.run.next = self.shell.run.val();
        self.red_byte.value.next = self.red_value.value.val();

        self.green_value.clock.next = self.clock.val();
        self.green_value.write.next = self.accept.val() && self.channels.val().get_bit(1);
        self.green_value.word.next = self.word.val();
        self.green_value.data.next = self.bus_colour.val();
        self.green_value.load.next = self.shell.load.val();
        self.green_value.step.next = self.shell.step.val();
        self.green_value.carry.next = self.shell.carry.val();
        self.green_value.take.next = self.shell.take.val();
        self.green_value.run.next = self.shell.run.val();
        self.green_byte.value.next = self.green_value.value.val();

        self.blue_value.clock.next = self.clock.val();
        self.blue_value.write.next = self.accept.val() && self.channels.val().get_bit(2);
        self.blue_value.word.next = self.word.val();
        self.blue_value.data.next = self.bus_colour.val();
        self.blue_value.load.next = self.shell.load.val();
        self.blue_value.step.next = self.shell.step.val();
        self.blue_value.carry.next = self.shell.carry.val();
        self.blue_value.take.next = self.shell.take.val();
        self.blue_value.run.next = self.shell.run.val();
        self.blue_byte.value.next = self.blue_value.value.val();

        self.depth_value.clock.next = self.clock.val();
        self.depth_value.write.next = self.accept.val() && self.channels.val().get_bit(3);
        self.depth_value.word.next = self.word.val();
        self.depth_value.data.next = self.bus_32.val();
        self.depth_value.load.next = self.shell.load.val();
        self.depth_value.step.next = self.shell.step.val();
        self.depth_value.carry.next = self.shell.carry.val();
        self.depth_value.take.next = self.shell.take.val();
        self.depth_value.run.next = self.shell.run.val();

        self.depth_bits.next = unsigned_cast_integer::<16, 15, 0>(self.depth_value.value.val());
        self.z_buffer.clock.next = self.clock.val();
        self.z_buffer.go.next = self.go.val();
        self.z_buffer.clear.next = self.clear.val() && !self.is_busy.val();
        self.z_buffer.fragment.next = self.shell.fragment.val();
        self.z_buffer.address.next = self.shell.address.val();
        self.z_buffer.depth.next = self.depth_bits.val() ^ self.depth_bias.val();

        if self.go.val() {
            self.drawn_x.d.next = self.shell.x.val();
            self.drawn_y.d.next = self.shell.y.val();
            self.drawn_red.d.next = self.red_byte.level.val();
            self.drawn_green.d.next = self.green_byte.level.val();
            self.drawn_blue.d.next = self.blue_byte.level.val();
            self.out_valid.d.next = self.z_buffer.pass.val();
            self.out_x.d.next = self.drawn_x.q.val();
            self.out_y.d.next = self.drawn_y.q.val();
            self.out_red.d.next = self.drawn_red.q.val();
            self.out_green.d.next = self.drawn_green.q.val();
            self.out_blue.d.next = self.drawn_blue.q.val();
            self.out_depth.d.next = self.z_buffer.waiting_depth.val();
        }

        self.was_busy.d.next = self.is_busy.val();

        self.load_ready.next = self.shell.load_ready.val();
        self.valid.next = self.out_valid.q.val();
        self.x.next = self.out_x.q.val();
        self.y.next = self.out_y.q.val();
        self.red.next = self.out_red.q.val();
        self.green.next = self.out_green.q.val();
        self.blue.next = self.out_blue.q.val();
        self.depth.next = self.out_depth.q.val();
        self.busy.next = self.is_busy.val();
        self.done.next = self.was_busy.q.val() && !self.is_busy.val();
    }
}

crate::clocked!(QuadraticCore<D, N, B, A>, const D: usize, const N: usize, const B: usize, const A: usize;
    inputs write, select, data, start, clear, ready;
    outputs load_ready, valid, x, y, red, green, blue, depth, busy, done);
