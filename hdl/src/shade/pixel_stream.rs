//! The pixel stream behind the interpolants: clamp, depth test, and a register that holds each visible pixel until it is
//! taken. All cores share it.
//!
//! Four stages: the fragment (pixel registers of the interpolants), the *drawn* pixel waiting for the stored depth, the
//! *tested* pixel, the *offered* pixel. They move together; only an offered pixel that nobody takes stops them (`go`
//! falls).

use super::saturate::Saturate;
use crate::depth::z_buffer::ZBuffer;
use crate::format::{unsigned_cast_integer, Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// `A` is the width of a frame address. Latency: three clocks from a fragment to its offered pixel.
#[derive(LogicBlock)]
pub struct PixelStream<const A: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Clears the depth memory; ignored while `busy`.
    pub clear: Signal<In, Bit>,
    /// The offered pixel is taken.
    pub ready: Signal<In, Bit>,
    /// A triangle is waiting or being walked.
    pub walking: Signal<In, Bit>,
    /// A fragment arrives.
    pub fragment: Signal<In, Bit>,
    /// Its column.
    pub fragment_x: Signal<In, U<11>>,
    /// Its row.
    pub fragment_y: Signal<In, U<11>>,
    /// Its frame address.
    pub address: Signal<In, U<A>>,
    /// Its red, LSB, with half an LSB added.
    pub fragment_red: Signal<In, Q<11, 0>>,
    /// Its green, likewise.
    pub fragment_green: Signal<In, Q<11, 0>>,
    /// Its blue, likewise.
    pub fragment_blue: Signal<In, Q<11, 0>>,
    /// Its depth less 32768, with half a word added.
    pub fragment_depth: Signal<In, Q<15, 0>>,
    /// The stages move.
    pub go: Signal<Out, Bit>,
    /// Nothing may be drawn yet: a clear is not complete.
    pub clearing: Signal<Out, Bit>,
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
    /// Column of the fragment before its stored depth is here.
    drawn_x: Register<U<11>>,
    /// Its row.
    drawn_y: Register<U<11>>,
    /// Its red.
    drawn_red: Register<U<8>>,
    /// Its green.
    drawn_green: Register<U<8>>,
    /// Its blue.
    drawn_blue: Register<U<8>>,
    /// Column of the tested fragment.
    tested_x: Register<U<11>>,
    /// Its row.
    tested_y: Register<U<11>>,
    /// Its red.
    tested_red: Register<U<8>>,
    /// Its green.
    tested_green: Register<U<8>>,
    /// Its blue.
    tested_blue: Register<U<8>>,
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
    /// The stages move.
    moves: Wire<Bit>,
    /// Anything is waiting, being drawn or being cleared.
    is_busy: Wire<Bit>,
    /// Depth less 32768, as bits.
    depth_bits: Wire<U<16>>,
    /// The bias of the depth interpolant: depths 0 to 65535 are walked as -32768 to 32767.
    depth_bias: Constant<U<16>>,
    /// Red, clamped.
    red_byte: Quiet<Saturate>,
    /// Green, clamped.
    green_byte: Quiet<Saturate>,
    /// Blue, clamped.
    blue_byte: Quiet<Saturate>,
    /// Depth test.
    z_buffer: Quiet<ZBuffer<A>>,
}

impl<const A: usize> PixelStream<A> {
    /// A stream whose depth memory has `pixels` words.
    #[must_use]
    pub fn new(pixels: usize) -> Self {
        Self {
            clock: Default::default(),
            clear: Default::default(),
            ready: Default::default(),
            walking: Default::default(),
            fragment: Default::default(),
            fragment_x: Default::default(),
            fragment_y: Default::default(),
            address: Default::default(),
            fragment_red: Default::default(),
            fragment_green: Default::default(),
            fragment_blue: Default::default(),
            fragment_depth: Default::default(),
            go: Default::default(),
            clearing: Default::default(),
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
            tested_x: Default::default(),
            tested_y: Default::default(),
            tested_red: Default::default(),
            tested_green: Default::default(),
            tested_blue: Default::default(),
            out_valid: Default::default(),
            out_x: Default::default(),
            out_y: Default::default(),
            out_red: Default::default(),
            out_green: Default::default(),
            out_blue: Default::default(),
            out_depth: Default::default(),
            was_busy: Default::default(),
            moves: Default::default(),
            is_busy: Default::default(),
            depth_bits: Default::default(),
            depth_bias: Constant::new(U::new(1 << 15)),
            red_byte: Default::default(),
            green_byte: Default::default(),
            blue_byte: Default::default(),
            z_buffer: ZBuffer::new(pixels).into(),
        }
    }
}

impl<const A: usize> Logic for PixelStream<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name pixel_stream");
        comment!("title Clamp, depth test and output register of a core; valid/ready hand-over.");
        comment!("equation offered pixels = fragments nearer than everything drawn before at their place");
        comment!("source Abbas 2003, section 4.2 and figure 4.5, as a stream with back pressure.");
        comment!("latency Three clocks from fragment to valid.");
        dff_setup!(
            self,
            clock,
            drawn_x,
            drawn_y,
            drawn_red,
            drawn_green,
            drawn_blue,
            tested_x,
            tested_y,
            tested_red,
            tested_green,
            tested_blue,
            out_valid,
            out_x,
            out_y,
            out_red,
            out_green,
            out_blue,
            out_depth,
            was_busy
        );

        // Only a pixel that nobody takes stops the stages.
        self.moves.next = !self.out_valid.q.val() || self.ready.val();
        self.is_busy.next = self.walking.val()
            || self.z_buffer.waiting.val()
            || self.z_buffer.clearing.val()
            || self.z_buffer.cleared.val()
            || self.out_valid.q.val();

        self.red_byte.value.next = self.fragment_red.val();
        self.green_byte.value.next = self.fragment_green.val();
        self.blue_byte.value.next = self.fragment_blue.val();
        self.depth_bits.next = unsigned_cast_integer::<16, 15, 0>(self.fragment_depth.val());

        self.z_buffer.clock.next = self.clock.val();
        self.z_buffer.go.next = self.moves.val();
        self.z_buffer.clear.next = self.clear.val() && !self.is_busy.val();
        self.z_buffer.fragment.next = self.fragment.val();
        self.z_buffer.address.next = self.address.val();
        self.z_buffer.depth.next = self.depth_bits.val() ^ self.depth_bias.val();

        if self.moves.val() {
            self.drawn_x.d.next = self.fragment_x.val();
            self.drawn_y.d.next = self.fragment_y.val();
            self.drawn_red.d.next = self.red_byte.level.val();
            self.drawn_green.d.next = self.green_byte.level.val();
            self.drawn_blue.d.next = self.blue_byte.level.val();
            self.tested_x.d.next = self.drawn_x.q.val();
            self.tested_y.d.next = self.drawn_y.q.val();
            self.tested_red.d.next = self.drawn_red.q.val();
            self.tested_green.d.next = self.drawn_green.q.val();
            self.tested_blue.d.next = self.drawn_blue.q.val();
            self.out_valid.d.next = self.z_buffer.pass.val();
            self.out_x.d.next = self.tested_x.q.val();
            self.out_y.d.next = self.tested_y.q.val();
            self.out_red.d.next = self.tested_red.q.val();
            self.out_green.d.next = self.tested_green.q.val();
            self.out_blue.d.next = self.tested_blue.q.val();
            self.out_depth.d.next = self.z_buffer.tested_depth.val();
        }

        self.was_busy.d.next = self.is_busy.val();

        self.go.next = self.moves.val();
        self.clearing.next = self.z_buffer.clearing.val();
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

crate::clocked!(PixelStream<A>, const A: usize;
    inputs clear, ready, walking, fragment, fragment_x, fragment_y, address, fragment_red, fragment_green,
        fragment_blue, fragment_depth;
    outputs go, clearing, valid, x, y, red, green, blue, depth, busy, done);
