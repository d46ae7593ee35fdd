//! Which words of a frame memory belong to the frame that is being drawn: clearing without touching the words.
//!
//! The frame memory is divided into *pages* of eight words. The page memory keeps, for every page, a *generation* of ten
//! bits and a flag per word. A word is **present** if its page has the current generation and its flag is set; all others
//! read as empty. So the whole frame is cleared by adding one to the generation, between one clock and the next, and
//! drawing goes on at once.
//!
//! ```text
//!  slot ──► page memory ──► held: present?  flags of the page ──► page memory
//!  a fragment, or the page that is due to be renewed in a clock without one
//! ```
//!
//! # No stale word can pass
//! Generations count modulo 2¹⁰, so the generation of a page that nobody draws on must never grow 2¹⁰ clears old. A clock
//! without a fragment *renews* a page: an old one becomes an empty one of the current generation, a current one stays.
//! With P pages, Q = ⌈P / (2¹⁰ − 1)⌉ renewals are due after each clear, page after page, round and round; the s-th falls
//! in frame 1 + ⌊s / Q⌋. Two renewals of one page are P apart, hence at most ⌈P / Q⌉ ≤ 2¹⁰ − 1 frames. A page's
//! generation is that of its last renewal or later, thus at most 2¹⁰ − 1 clears old: it equals the current one only if
//! it is the current one. A clear that finds renewals still due waits for them, at most Q clocks, since nothing else
//! moves then; in 320×240 Q is 10 and the clocks around a clear nearly always suffice.
//!
//! # Reset
//! A reset forgets the generation, not the page memory. The first clear after a reset or power-up therefore writes every
//! page once, one per clock: empty, generation 0. At power-up the page memory is all zeros, which is an empty frame.
//!
//! # Hazard
//! A page is read in one clock and written in the next, and neighbours in a span share their page, so the flags that are
//! written are forwarded to a slot that reads them in the same clock. They are of the current generation.
//!
//! Source: ours. A generation per word, without flags, would need spare bits in every word and as many renewals as words.

use super::frame_memory::PageMemory;
use crate::format::{bit_cast_u, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Words of a page.
pub const PAGE: usize = 8;
/// Bits of a generation.
pub const GENERATION_BITS: usize = 10;

/// Pages of a frame of `pixels` words; a memory has two words at least.
#[must_use]
pub fn pages(pixels: usize) -> usize {
    pixels.div_ceil(PAGE).max(2)
}

/// Pages that are renewed in each frame: Q above.
#[must_use]
pub fn renewals(pixels: usize) -> usize {
    pages(pixels).div_ceil((1 << GENERATION_BITS) - 1)
}

/// `A` is the width of a frame address. Latency: one clock from a fragment to `held`, `place` and `present`.
#[derive(LogicBlock)]
pub struct Pages<const A: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The pipeline moves; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Clears the frame; accept it only while no fragment is on its way. Ignored while `clearing`.
    pub clear: Signal<In, Bit>,
    /// A fragment arrives.
    pub fragment: Signal<In, Bit>,
    /// Its frame address.
    pub address: Signal<In, U<A>>,
    /// The held fragment's word will be in the frame memory.
    pub touch: Signal<In, Bit>,
    /// The fragment of the clock before.
    pub held: Signal<Out, Bit>,
    /// Its frame address.
    pub place: Signal<Out, U<A>>,
    /// Its word in the frame memory is of this frame.
    pub present: Signal<Out, Bit>,
    /// No fragment may come.
    pub clearing: Signal<Out, Bit>,
    /// A clear was done in the clock before.
    pub cleared: Signal<Out, Bit>,
    /// A fragment is held.
    holds: Register<Bit>,
    /// Its frame address, or the page that is renewed.
    held_place: Register<U<A>>,
    /// The page is renewed.
    renewing: Register<Bit>,
    /// The page is emptied, whatever its generation.
    emptying: Register<Bit>,
    /// The page was written while it was read.
    forward: Register<Bit>,
    /// The flags that were written.
    forward_flags: Register<U<8>>,
    /// Clears so far, modulo 2^10.
    generation: Register<U<10>>,
    /// First word of the page to renew next.
    renewal: Register<U<A>>,
    /// Renewals that are due.
    due: Register<U<A>>,
    /// All generations in the memory are known.
    known: Register<Bit>,
    /// The memory is being swept.
    sweeping: Register<Bit>,
    /// A clear waits for renewals that are due.
    closing: Register<Bit>,
    /// A clear has been done.
    answer: Register<Bit>,
    /// A page is renewed in this slot.
    renews: Wire<Bit>,
    /// Address of this slot.
    slot: Wire<U<A>>,
    /// Page of this slot.
    slot_page: Wire<U<A>>,
    /// Page of the held slot.
    held_page: Wire<U<A>>,
    /// Generation of the held slot's page.
    word_generation: Wire<U<10>>,
    /// Flags of the page in this frame.
    flags: Wire<U<8>>,
    /// Which word of its page the held fragment means.
    ordinal: Wire<U<3>>,
    /// Its flag.
    flag: Wire<U<8>>,
    /// Its flag, if it is set.
    own_flag: Wire<U<8>>,
    /// Flags after this clock.
    new_flags: Wire<U<8>>,
    /// Word after this clock.
    new_word: Wire<U<18>>,
    /// The page is written.
    writes: Wire<Bit>,
    /// A clear arrives.
    asked: Wire<Bit>,
    /// Nothing is due.
    settled: Wire<Bit>,
    /// The next frame begins.
    turns: Wire<Bit>,
    /// Generation and flags of each page.
    memory: Quiet<PageMemory<A>>,
    /// First word of the last page.
    last_page: Constant<U<A>>,
    /// Words of a page.
    one_page: Constant<U<A>>,
    /// Renewals per frame.
    renewals: Constant<U<A>>,
    /// One renewal.
    one_renewal: Constant<U<A>>,
}

impl<const A: usize> Pages<A> {
    /// For a frame memory of `pixels` words.
    #[must_use]
    pub fn new(pixels: usize) -> Self {
        Self {
            clock: Default::default(),
            go: Default::default(),
            clear: Default::default(),
            fragment: Default::default(),
            address: Default::default(),
            touch: Default::default(),
            held: Default::default(),
            place: Default::default(),
            present: Default::default(),
            clearing: Default::default(),
            cleared: Default::default(),
            holds: Default::default(),
            held_place: Default::default(),
            renewing: Default::default(),
            emptying: Default::default(),
            forward: Default::default(),
            forward_flags: Default::default(),
            generation: Default::default(),
            renewal: Default::default(),
            due: Default::default(),
            known: Default::default(),
            sweeping: Default::default(),
            closing: Default::default(),
            answer: Default::default(),
            renews: Default::default(),
            slot: Default::default(),
            slot_page: Default::default(),
            held_page: Default::default(),
            word_generation: Default::default(),
            flags: Default::default(),
            ordinal: Default::default(),
            flag: Default::default(),
            own_flag: Default::default(),
            new_flags: Default::default(),
            new_word: Default::default(),
            writes: Default::default(),
            asked: Default::default(),
            settled: Default::default(),
            turns: Default::default(),
            memory: PageMemory::new(pages(pixels)).into(),
            last_page: Constant::new(U::new((PAGE * (pages(pixels) - 1)) as u64)),
            one_page: Constant::new(U::new(PAGE as u64)),
            renewals: Constant::new(U::new(renewals(pixels) as u64)),
            one_renewal: Constant::new(U::new(1)),
        }
    }
}

impl<const A: usize> Logic for Pages<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name frame_pages");
        comment!("title Which words of a frame memory are of this frame: it is cleared between two clocks.");
        comment!("equation present = generation of the page is this one and flag of the word; clear: generation + 1");
        comment!("source Ours; a page is renewed in clocks without a fragment before its generation comes round again.");
        comment!("latency One clock from fragment to present.");
        dff_setup!(
            self,
            clock,
            holds,
            held_place,
            renewing,
            emptying,
            forward,
            forward_flags,
            generation,
            renewal,
            due,
            known,
            sweeping,
            closing,
            answer
        );
        // The slot: a fragment, or a page to renew.
        self.settled.next = !self.due.q.val().any();
        self.renews.next = !self.fragment.val() && (self.sweeping.q.val() || !self.settled.val());
        self.slot.next = self.renewal.q.val();
        if self.fragment.val() {
            self.slot.next = self.address.val();
        }
        self.slot_page.next = self.slot.val() >> 3u64;
        self.held_page.next = self.held_place.q.val() >> 3u64;

        // The held slot: what its page says, and what it will say.
        self.word_generation.next = self.memory.read_data.val().get_bits::<10>(8);
        self.flags.next = 0u64.into();
        if self.word_generation.val() == self.generation.q.val() {
            self.flags.next = self.memory.read_data.val().get_bits::<8>(0);
        }
        if self.forward.q.val() {
            self.flags.next = self.forward_flags.q.val();
        }
        self.ordinal.next = self.held_place.q.val().get_bits::<3>(0);
        self.flag.next = 1u64.into();
        if self.ordinal.val() == 1u64.into() {
            self.flag.next = 2u64.into();
        }
        if self.ordinal.val() == 2u64.into() {
            self.flag.next = 4u64.into();
        }
        if self.ordinal.val() == 3u64.into() {
            self.flag.next = 8u64.into();
        }
        if self.ordinal.val() == 4u64.into() {
            self.flag.next = 16u64.into();
        }
        if self.ordinal.val() == 5u64.into() {
            self.flag.next = 32u64.into();
        }
        if self.ordinal.val() == 6u64.into() {
            self.flag.next = 64u64.into();
        }
        if self.ordinal.val() == 7u64.into() {
            self.flag.next = 128u64.into();
        }
        self.own_flag.next = self.flags.val() & self.flag.val();
        self.new_flags.next = self.flags.val();
        if self.touch.val() {
            self.new_flags.next = self.flags.val() | self.flag.val();
        }
        if self.emptying.q.val() {
            self.new_flags.next = 0u64.into();
        }
        self.new_word.next = (bit_cast_u::<18, 10>(self.generation.q.val()) << 8u64)
            | bit_cast_u::<18, 8>(self.new_flags.val());
        self.writes.next = self.touch.val() || self.renewing.q.val();

        if self.go.val() {
            self.holds.d.next = self.fragment.val();
            self.held_place.d.next = self.slot.val();
            self.renewing.d.next = self.renews.val();
            self.emptying.d.next = self.sweeping.q.val();
            self.forward.d.next =
                self.writes.val() && (self.slot_page.val() == self.held_page.val());
            self.forward_flags.d.next = self.new_flags.val();
            if self.renews.val() {
                self.renewal.d.next = self.renewal.q.val() + self.one_page.val();
                if self.renewal.q.val() == self.last_page.val() {
                    self.renewal.d.next = 0u64.into();
                    if self.sweeping.q.val() {
                        self.sweeping.d.next = false;
                        self.known.d.next = true;
                    }
                }
                if !self.settled.val() {
                    self.due.d.next = self.due.q.val() - self.one_renewal.val();
                }
            }
        }

        // Clearing: at once, or when no renewal is due, or, the first time, by a sweep.
        self.asked.next = self.clear.val() && !self.sweeping.q.val() && !self.closing.q.val();
        self.turns.next = self.settled.val()
            && (self.closing.q.val() || (self.asked.val() && self.known.q.val()));
        if self.turns.val() {
            self.generation.d.next = self.generation.q.val() + 1u64.into();
            self.forward_flags.d.next = 0u64.into();
            self.due.d.next = self.renewals.val();
            self.closing.d.next = false;
        } else if self.asked.val() {
            self.closing.d.next = self.known.q.val();
            self.sweeping.d.next = !self.known.q.val();
        }
        self.answer.d.next = self.turns.val();

        self.memory.clock.next = self.clock.val();
        self.memory.read.next = self.go.val();
        self.memory.read_address.next = self.slot_page.val();
        self.memory.write.next = self.writes.val() && self.go.val();
        self.memory.write_address.next = self.held_page.val();
        self.memory.write_data.next = self.new_word.val();

        self.held.next = self.holds.q.val();
        self.place.next = self.held_place.q.val();
        self.present.next = self.own_flag.val().any();
        self.clearing.next = self.sweeping.q.val() || self.closing.q.val();
        self.cleared.next = self.answer.q.val();
    }
}

crate::clocked!(Pages<A>, const A: usize;
    inputs go, clear, fragment, address, touch;
    outputs held, place, present, clearing, cleared);
