//! The z-buffer: reads the stored depth, compares, writes back; one pixel per clock.
//!
//! A pixel passes when its depth is *greater* than the stored one (reversed depth: larger is nearer, 0 is the cleared
//! memory), so of equal depths the first drawn wins. The memory answers one clock after the address, and the write
//! follows in that clock; a pixel that reads the address being written would see old data, so the written depth is
//! forwarded to it. That is the only hazard: writes are complete one clock later.
//! Source: Abbas 2003, section 4.2 and figure 4.5 (read, compare, write); pipelining and forwarding are ours.

use super::frame_memory::{FrameMemory, FrameMemoryModel};
use crate::format::{mask, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// `A` is the width of a frame address. Latency: the verdict one clock after the fragment.
#[derive(LogicBlock)]
pub struct ZBuffer<const A: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The pipeline moves; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Begins to clear the memory, one word per clock; accept it only between frames.
    pub clear: Signal<In, Bit>,
    /// A fragment arrives.
    pub fragment: Signal<In, Bit>,
    /// Its frame address.
    pub address: Signal<In, U<A>>,
    /// Its depth.
    pub depth: Signal<In, U<16>>,
    /// The fragment of the clock before is visible.
    pub pass: Signal<Out, Bit>,
    /// A fragment waits for its verdict.
    pub waiting: Signal<Out, Bit>,
    /// Its depth.
    pub waiting_depth: Signal<Out, U<16>>,
    /// The memory is being cleared.
    pub clearing: Signal<Out, Bit>,
    /// A fragment waits for its verdict.
    valid: Register<Bit>,
    /// Its frame address.
    held_address: Register<U<A>>,
    /// Its depth.
    held_depth: Register<U<16>>,
    /// The word it read was written in the same clock.
    forward: Register<Bit>,
    /// The depth that was written.
    forward_depth: Register<U<16>>,
    /// The memory is being cleared.
    sweeping: Register<Bit>,
    /// Word to clear.
    sweep_address: Register<U<A>>,
    /// Depth to compare with.
    stored: Wire<U<16>>,
    /// The fragment is nearer than all before.
    visible: Wire<Bit>,
    /// One depth per pixel.
    memory: Quiet<FrameMemory<A>>,
    /// Last word of the memory.
    last_address: Constant<U<A>>,
    /// Address step.
    one_word: Constant<U<A>>,
    /// Depth of a cleared word.
    empty: Constant<U<16>>,
}

impl<const A: usize> ZBuffer<A> {
    /// A z-buffer for `pixels` pixels.
    #[must_use]
    pub fn new(pixels: usize) -> Self {
        Self {
            clock: Default::default(),
            go: Default::default(),
            clear: Default::default(),
            fragment: Default::default(),
            address: Default::default(),
            depth: Default::default(),
            pass: Default::default(),
            waiting: Default::default(),
            waiting_depth: Default::default(),
            clearing: Default::default(),
            valid: Default::default(),
            held_address: Default::default(),
            held_depth: Default::default(),
            forward: Default::default(),
            forward_depth: Default::default(),
            sweeping: Default::default(),
            sweep_address: Default::default(),
            stored: Default::default(),
            visible: Default::default(),
            memory: FrameMemory::new(pixels).into(),
            last_address: Constant::new(U::new(pixels as u64 - 1)),
            one_word: Constant::new(U::new(1)),
            empty: Constant::new(U::new(0)),
        }
    }
}

impl<const A: usize> Logic for ZBuffer<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name z_buffer");
        comment!("title Depth test at one pixel per clock over a block RAM, with write forwarding and clearing.");
        comment!("equation visible = depth > stored depth; then stored depth = depth (larger is nearer, 0 is empty)");
        comment!("source Abbas 2003, section 4.2 and figure 4.5; pipelined.");
        comment!("latency One clock from fragment to pass.");
        dff_setup!(
            self,
            clock,
            valid,
            held_address,
            held_depth,
            forward,
            forward_depth,
            sweeping,
            sweep_address
        );
        self.stored.next = self.memory.read_data.val();
        if self.forward.q.val() {
            self.stored.next = self.forward_depth.q.val();
        }
        self.visible.next = self.valid.q.val() && (self.stored.val() < self.held_depth.q.val());
        if self.go.val() {
            self.valid.d.next = self.fragment.val();
            self.held_address.d.next = self.address.val();
            self.held_depth.d.next = self.depth.val();
            self.forward.d.next =
                self.visible.val() && (self.address.val() == self.held_address.q.val());
            self.forward_depth.d.next = self.held_depth.q.val();
        }
        if self.sweeping.q.val() {
            self.sweep_address.d.next = self.sweep_address.q.val() + self.one_word.val();
            if self.sweep_address.q.val() == self.last_address.val() {
                self.sweeping.d.next = false;
            }
        } else if self.clear.val() {
            self.sweeping.d.next = true;
            self.sweep_address.d.next = 0u64.into();
        }
        self.memory.clock.next = self.clock.val();
        self.memory.read.next = self.go.val();
        self.memory.read_address.next = self.address.val();
        self.memory.write.next = (self.visible.val() && self.go.val()) || self.sweeping.q.val();
        self.memory.write_address.next = self.held_address.q.val();
        self.memory.write_data.next = self.held_depth.q.val();
        if self.sweeping.q.val() {
            self.memory.write_address.next = self.sweep_address.q.val();
            self.memory.write_data.next = self.empty.val();
        }
        self.pass.next = self.visible.val();
        self.waiting.next = self.valid.q.val();
        self.waiting_depth.next = self.held_depth.q.val();
        self.clearing.next = self.sweeping.q.val();
    }
}

crate::clocked!(ZBuffer<A>, const A: usize;
    inputs go, clear, fragment, address, depth;
    outputs pass, waiting, waiting_depth, clearing);

/// What the z-buffer sees in one clock.
#[derive(Clone, Copy, Debug, Default)]
pub struct ZBufferInputs {
    /// The pipeline moves.
    pub go: bool,
    /// Begins to clear.
    pub clear: bool,
    /// A fragment arrives.
    pub fragment: bool,
    /// Frame address.
    pub address: u64,
    /// Depth.
    pub depth: u16,
}

/// Integer model of [`ZBuffer`].
#[derive(Clone, Debug)]
pub struct ZBufferModel {
    address_bits: usize,
    memory: FrameMemoryModel,
    /// A fragment waits for its verdict.
    pub waiting: bool,
    address: u64,
    /// Its depth.
    pub depth: u16,
    forward: Option<u16>,
    sweep: Option<u64>,
}

impl ZBufferModel {
    /// A cleared z-buffer for `pixels` pixels.
    #[must_use]
    pub fn new(address_bits: usize, pixels: usize) -> Self {
        Self {
            address_bits,
            memory: FrameMemoryModel::new(pixels),
            waiting: false,
            address: 0,
            depth: 0,
            forward: None,
            sweep: None,
        }
    }

    /// The fragment of the clock before is visible.
    #[must_use]
    pub fn pass(&self) -> bool {
        self.waiting && self.forward.unwrap_or(self.memory.read_data) < self.depth
    }

    /// The memory is being cleared.
    #[must_use]
    pub fn clearing(&self) -> bool {
        self.sweep.is_some()
    }

    /// One clock edge.
    pub fn clock(&mut self, i: &ZBufferInputs) {
        let pass = self.pass();
        let write = match self.sweep {
            Some(address) => Some((address, 0)),
            None => (pass && i.go).then_some((self.address, self.depth)),
        };
        self.memory.clock(i.go.then_some(i.address), write);
        if i.go {
            self.forward = (pass && i.address == self.address).then_some(self.depth);
            self.waiting = i.fragment;
            self.address = i.address;
            self.depth = i.depth;
        }
        self.sweep = match self.sweep {
            Some(address) if address as usize + 1 == self.memory.len() => None,
            Some(address) => Some((address + 1) & mask(self.address_bits)),
            None => i.clear.then_some(0),
        };
    }
}
