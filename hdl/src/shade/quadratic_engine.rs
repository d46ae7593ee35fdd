//! The quadratic core behind a set-up engine: a host sends corners, depths and knots instead of register words.
//!
//! `select` is as in the other cores a channel mask over a word number; one bit of the mask counts, the lowest. Raw words
//! are numbered by vertex: 0 to 2 (mask 0: x; depth; colours at the vertices) and 4 to 6 (mask 0: y; colours at the
//! mid-edge opposite to vertex 0, 1, 2). See [`crate::set_up`] for formats, range and rounding.

use super::quadratic::QuadraticCore;
use crate::format::{bit_cast_u, U};
use crate::set_up::engine::SetUpEngine;
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// `D` = 12 + `N`: width of a colour word; `N`: its fraction bits; `B`: width of the register bus, max(D, 32);
/// `A`: width of a frame address.
#[derive(LogicBlock)]
pub struct QuadraticEngineCore<const D: usize, const N: usize, const B: usize, const A: usize> {
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
    /// A write of the host is accepted.
    accept: Wire<Bit>,
    /// Word number.
    word: Wire<U<4>>,
    /// Channel mask, 0 for corners and frame.
    channels: Wire<U<4>>,
    /// Corners or frame are selected.
    selects_shell: Wire<Bit>,
    /// A register of the frame is selected.
    selects_frame: Wire<Bit>,
    /// Slot of vertex 0.
    group: Wire<U<6>>,
    /// Slot within the group.
    offset: Wire<U<3>>,
    /// The host writes a register of the frame.
    frame_write: Wire<Bit>,
    /// `busy` in the clock before.
    was_busy: Register<Bit>,
    /// Something is waiting, in work or being cleared.
    any_busy: Wire<Bit>,
    /// Corners and knots to register words.
    engine: Quiet<SetUpEngine<N, B>>,
    /// Register words to pixels.
    core: Quiet<QuadraticCore<D, N, B, A>>,
}

impl<const D: usize, const N: usize, const B: usize, const A: usize>
    QuadraticEngineCore<D, N, B, A>
{
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
            selects_frame: Default::default(),
            group: Default::default(),
            offset: Default::default(),
            frame_write: Default::default(),
            was_busy: Default::default(),
            any_busy: Default::default(),
            engine: Default::default(),
            core: QuadraticCore::new(pixels).into(),
        }
    }
}

impl<const D: usize, const N: usize, const B: usize, const A: usize> Logic
    for QuadraticEngineCore<D, N, B, A>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name quadratic_engine_core");
        comment!("title Quadratic shading core with its own set-up: raw triangles in, pixels out.");
        comment!("equation I(x, y) = T5 x^2 + T4 x y + T3 y^2 + T2 x + T1 y + T0 per channel, through six knots");
        comment!(
            "source Abbas 2003, chapter 7; set-up after Hast 2004, section 3.3, by set_up_engine."
        );
        comment!("latency The engine's clocks and five from start to the first pixel; then one pixel per clock.");
        dff_setup!(self, clock, was_busy);
        self.accept.next = self.write.val() && self.engine.load_ready.val();
        self.word.next = self.select.val().get_bits::<4>(0);
        self.offset.next = self.select.val().get_bits::<3>(0);
        self.channels.next = self.select.val().get_bits::<4>(4);
        self.selects_shell.next = !self.channels.val().any();
        self.selects_frame.next = self.selects_shell.val() && self.word.val().get_bit(3);
        self.group.next = 0u64.into();
        if self.channels.val().get_bit(3) {
            self.group.next = 8u64.into();
        }
        if self.channels.val().get_bit(2) {
            self.group.next = 32u64.into();
        }
        if self.channels.val().get_bit(1) {
            self.group.next = 24u64.into();
        }
        if self.channels.val().get_bit(0) {
            self.group.next = 16u64.into();
        }
        self.frame_write.next = self.accept.val() && self.selects_frame.val();

        self.engine.clock.next = self.clock.val();
        self.engine.write.next = self.accept.val() && !self.selects_frame.val();
        self.engine.slot.next = self.group.val() | bit_cast_u::<6, 3>(self.offset.val());
        self.engine.data.next = self.data.val().get_bits::<24>(0);
        self.engine.frame_write.next = self.frame_write.val();
        self.engine.frame_word.next = self.word.val();
        self.engine.start.next = self.start.val();
        self.engine.ready.next = self.core.load_ready.val();

        // The frame width goes to both.
        self.core.clock.next = self.clock.val();
        self.core.write.next = self.frame_write.val();
        self.core.select.next = self.select.val();
        self.core.data.next = self.data.val();
        if self.engine.core_write.val() {
            self.core.write.next = true;
            self.core.select.next = self.engine.core_select.val();
            self.core.data.next = self.engine.core_data.val();
        }
        self.core.start.next = self.engine.core_start.val();
        self.core.clear.next = self.clear.val() && !self.engine.busy.val();
        self.core.ready.next = self.ready.val();

        self.any_busy.next = self.core.busy.val() || self.engine.busy.val();
        self.was_busy.d.next = self.any_busy.val();
        self.load_ready.next = self.engine.load_ready.val();
        self.valid.next = self.core.valid.val();
        self.x.next = self.core.x.val();
        self.y.next = self.core.y.val();
        self.red.next = self.core.red.val();
        self.green.next = self.core.green.val();
        self.blue.next = self.core.blue.val();
        self.depth.next = self.core.depth.val();
        self.busy.next = self.any_busy.val();
        self.done.next = self.was_busy.q.val() && !self.any_busy.val();
    }
}

crate::clocked!(QuadraticEngineCore<D, N, B, A>, const D: usize, const N: usize, const B: usize, const A: usize;
    inputs write, select, data, start, clear, ready;
    outputs load_ready, valid, x, y, red, green, blue, depth, busy, done);
