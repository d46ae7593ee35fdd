//! Integer model of [`super::pages::Pages`], clock by clock.

use super::frame_memory::PageMemoryModel;
use super::pages::{pages, renewals, GENERATION_BITS, PAGE};
use crate::format::mask;

/// What the pages see in one clock.
#[derive(Clone, Copy, Debug, Default)]
pub struct PagesInputs {
    /// The pipeline moves.
    pub go: bool,
    /// Clears the frame.
    pub clear: bool,
    /// Frame address of a fragment that arrives.
    pub fragment: Option<u64>,
    /// The held fragment's word will be in the frame memory.
    pub touch: bool,
}

/// Integer model of [`super::pages::Pages`].
#[derive(Clone, Debug)]
pub struct PagesModel {
    memory: PageMemoryModel,
    /// A fragment is held.
    pub held: bool,
    /// Its frame address, or the page that is renewed.
    pub place: u64,
    renewing: bool,
    emptying: bool,
    /// Flags that were written while they were read.
    forward: Option<u32>,
    generation: u32,
    renewal: u64,
    due: u64,
    known: bool,
    sweeping: bool,
    closing: bool,
    /// A clear was done in the clock before.
    pub cleared: bool,
    pages: u64,
    renewals: u64,
}

impl PagesModel {
    /// At power-up, for a frame memory of `pixels` words.
    #[must_use]
    pub fn new(pixels: usize) -> Self {
        Self::with_renewals(pixels, renewals(pixels) as u64)
    }

    /// With another number of renewals per frame than safety asks for.
    #[must_use]
    pub fn with_renewals(pixels: usize, renewals: u64) -> Self {
        Self {
            memory: PageMemoryModel::new(pages(pixels)),
            held: false,
            place: 0,
            renewing: false,
            emptying: false,
            forward: None,
            generation: 0,
            renewal: 0,
            due: 0,
            known: false,
            sweeping: false,
            closing: false,
            cleared: false,
            pages: pages(pixels) as u64,
            renewals,
        }
    }

    /// No fragment may come.
    #[must_use]
    pub fn clearing(&self) -> bool {
        self.sweeping || self.closing
    }

    /// Flags of the held slot's page in this frame.
    fn flags(&self) -> u32 {
        let word = self.memory.read_data;
        let current = word >> PAGE == self.generation;
        let read = if current { word & 0xff } else { 0 };
        self.forward.unwrap_or(read)
    }

    fn flag(&self) -> u32 {
        1 << (self.place % PAGE as u64)
    }

    /// The held fragment's word in the frame memory is of this frame.
    #[must_use]
    pub fn present(&self) -> bool {
        self.flags() & self.flag() != 0
    }

    /// One clock edge.
    pub fn clock(&mut self, i: &PagesInputs) {
        let settled = self.due == 0;
        let renews = i.fragment.is_none() && (self.sweeping || !settled);
        let page = |address: u64| address / PAGE as u64;
        let slot = i.fragment.unwrap_or(self.renewal);
        let flags = match (self.emptying, i.touch) {
            (true, _) => 0,
            (false, true) => self.flags() | self.flag(),
            (false, false) => self.flags(),
        };
        let word = self.generation << PAGE | flags;
        let writes = i.touch || self.renewing;
        let (asked, was_sweeping) = (i.clear && !self.clearing(), self.sweeping);
        if i.go {
            let write = writes.then_some((page(self.place), word));
            self.memory.clock(Some(page(slot)), write);
            self.forward = (writes && page(slot) == page(self.place)).then_some(flags);
            self.held = i.fragment.is_some();
            self.place = slot;
            self.renewing = renews;
            self.emptying = was_sweeping;
            if renews {
                let last = page(self.renewal) + 1 == self.pages;
                self.renewal = if last { 0 } else { self.renewal + PAGE as u64 };
                if last && self.sweeping {
                    (self.sweeping, self.known) = (false, true);
                }
                self.due = self.due.saturating_sub(1);
            }
        }
        // Nobody asks in the clock in which a sweep ends.
        let known = self.known;
        self.cleared = settled && (self.closing || asked && known);
        if self.cleared {
            self.generation = (self.generation + 1) & mask(GENERATION_BITS) as u32;
            self.forward = self.forward.map(|_| 0);
            self.due = self.renewals;
            self.closing = false;
        } else if asked {
            (self.closing, self.sweeping) = (known, !known);
        }
    }
}
