//! The z-buffer: reads the stored depth, compares, writes back; one pixel per clock.
//!
//! A pixel passes when its depth is *greater* than the stored one (reversed depth: larger is nearer, 0 is an empty word),
//! so of equal depths the first drawn wins. Three stages:
//!
//! ```text
//!  fragment ──► held: word and page arrive ──► tested: compare, write
//!    address to memory and pages   stored = word, first if not present
//! ```
//!
//! # Hazard
//! A word is read two clocks before the fragment's own depth is written, so the depths of the two fragments in front may
//! be on their way. The one two in front is written in the clock in which this one reads: its depth is kept and replaces
//! the word that is read. The one just in front is compared while this one is held: if it is visible and means the same
//! pixel, its depth replaces whatever was found. Which pixels are the same is compared a clock before it is needed.
//!
//! # Clearing
//! The depth memory is never swept: [`Pages`] knows which words are of this frame. The first fragment on a word that is
//! not is visible, if its depth is not 0; so a word whose flag is set is in the memory, or on its way and forwarded.
//!
//! Source: Abbas 2003, section 4.2 and figure 4.5 (read, compare, write); pipelining and forwarding are ours.

use super::frame_memory::FrameMemory;
use super::pages::Pages;
use crate::format::U;
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

pub use super::z_buffer_model::{ZBufferInputs, ZBufferModel};

/// `A` is the width of a frame address. Latency: the verdict two clocks after the fragment.
#[derive(LogicBlock)]
pub struct ZBuffer<const A: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The pipeline moves; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Clears the memory; accept it only between frames.
    pub clear: Signal<In, Bit>,
    /// A fragment arrives.
    pub fragment: Signal<In, Bit>,
    /// Its frame address.
    pub address: Signal<In, U<A>>,
    /// Its depth.
    pub depth: Signal<In, U<16>>,
    /// The tested fragment is visible.
    pub pass: Signal<Out, Bit>,
    /// A fragment waits for its verdict.
    pub waiting: Signal<Out, Bit>,
    /// Depth of the tested fragment.
    pub tested_depth: Signal<Out, U<16>>,
    /// No fragment may come.
    pub clearing: Signal<Out, Bit>,
    /// A clear was done in the clock before.
    pub cleared: Signal<Out, Bit>,
    /// Depth of the held fragment.
    held_depth: Register<U<16>>,
    /// The held fragment means the pixel of the one just in front.
    same: Register<Bit>,
    /// The held fragment's word was written while it was read.
    forward: Register<Bit>,
    /// The depth that was written.
    forward_depth: Register<U<16>>,
    /// A fragment is tested.
    tests: Register<Bit>,
    /// Its frame address.
    address_tested: Register<U<A>>,
    /// Its depth.
    depth_tested: Register<U<16>>,
    /// Depth to compare with.
    stored: Register<U<16>>,
    /// The tested fragment is the first of this frame on its pixel.
    first: Register<Bit>,
    /// The held fragment is not nothing.
    touches: Wire<Bit>,
    /// Stored depth of the held fragment's pixel.
    found: Wire<U<16>>,
    /// The tested fragment is nearer than all before.
    visible: Wire<Bit>,
    /// Which words are of this frame.
    pages: Quiet<Pages<A>>,
    /// One depth per pixel.
    memory: Quiet<FrameMemory<A>>,
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
            tested_depth: Default::default(),
            clearing: Default::default(),
            cleared: Default::default(),
            held_depth: Default::default(),
            same: Default::default(),
            forward: Default::default(),
            forward_depth: Default::default(),
            tests: Default::default(),
            address_tested: Default::default(),
            depth_tested: Default::default(),
            stored: Default::default(),
            first: Default::default(),
            touches: Default::default(),
            found: Default::default(),
            visible: Default::default(),
            pages: Pages::new(pixels).into(),
            memory: FrameMemory::new(pixels).into(),
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
        comment!("latency Two clocks from fragment to pass.");
        dff_setup!(
            self,
            clock,
            held_depth,
            same,
            forward,
            forward_depth,
            tests,
            address_tested,
            depth_tested,
            stored,
            first
        );
        self.visible.next = self.tests.q.val()
            && (self.first.q.val() || (self.stored.q.val() < self.depth_tested.q.val()));

        self.pages.clock.next = self.clock.val();
        self.pages.go.next = self.go.val();
        self.pages.clear.next = self.clear.val();
        self.pages.fragment.next = self.fragment.val();
        self.pages.address.next = self.address.val();
        self.touches.next = self.pages.held.val() && self.held_depth.q.val().any();
        self.pages.touch.next = self.touches.val();

        // What is stored where the held fragment is, and what the two in front of it write there.
        self.found.next = self.memory.read_data.val();
        if self.forward.q.val() {
            self.found.next = self.forward_depth.q.val();
        }
        if self.same.q.val() && self.visible.val() {
            self.found.next = self.depth_tested.q.val();
        }
        if self.go.val() {
            self.held_depth.d.next = self.depth.val();
            self.same.d.next =
                self.pages.held.val() && (self.address.val() == self.pages.place.val());
            self.forward.d.next =
                self.visible.val() && (self.address.val() == self.address_tested.q.val());
            self.forward_depth.d.next = self.depth_tested.q.val();
            self.tests.d.next = self.pages.held.val();
            self.address_tested.d.next = self.pages.place.val();
            self.depth_tested.d.next = self.held_depth.q.val();
            self.stored.d.next = self.found.val();
            self.first.d.next = self.touches.val() && !self.pages.present.val();
        }

        self.memory.clock.next = self.clock.val();
        self.memory.read.next = self.go.val();
        self.memory.read_address.next = self.address.val();
        self.memory.write.next = self.visible.val() && self.go.val();
        self.memory.write_address.next = self.address_tested.q.val();
        self.memory.write_data.next = self.depth_tested.q.val();

        self.pass.next = self.visible.val();
        self.waiting.next = self.pages.held.val() || self.tests.q.val();
        self.tested_depth.next = self.depth_tested.q.val();
        self.clearing.next = self.pages.clearing.val();
        self.cleared.next = self.pages.cleared.val();
    }
}

crate::clocked!(ZBuffer<A>, const A: usize;
    inputs go, clear, fragment, address, depth;
    outputs pass, waiting, tested_depth, clearing, cleared);
