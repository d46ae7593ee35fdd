//! Integer model of [`super::z_buffer::ZBuffer`], clock by clock.

use super::frame_memory::FrameMemoryModel;
use super::pages_model::{PagesInputs, PagesModel};

/// What the z-buffer sees in one clock.
#[derive(Clone, Copy, Debug, Default)]
pub struct ZBufferInputs {
    /// The pipeline moves.
    pub go: bool,
    /// Clears the memory.
    pub clear: bool,
    /// A fragment arrives.
    pub fragment: bool,
    /// Frame address.
    pub address: u64,
    /// Depth.
    pub depth: u16,
}

/// Integer model of [`super::z_buffer::ZBuffer`].
#[derive(Clone, Debug)]
pub struct ZBufferModel {
    memory: FrameMemoryModel,
    pages: PagesModel,
    held_depth: u16,
    same: bool,
    forward: Option<u16>,
    tests: bool,
    address: u64,
    /// Depth of the tested fragment.
    pub depth: u16,
    stored: u16,
}

impl ZBufferModel {
    /// A cleared z-buffer for `pixels` pixels.
    #[must_use]
    pub fn new(pixels: usize) -> Self {
        Self::with_pages(pixels, PagesModel::new(pixels))
    }

    /// Over pages that are renewed as `pages` has it.
    #[must_use]
    pub fn with_pages(pixels: usize, pages: PagesModel) -> Self {
        Self {
            memory: FrameMemoryModel::new(pixels),
            pages,
            held_depth: 0,
            same: false,
            forward: None,
            tests: false,
            address: 0,
            depth: 0,
            stored: 0,
        }
    }

    /// The tested fragment is visible.
    #[must_use]
    pub fn pass(&self) -> bool {
        self.tests && self.stored < self.depth
    }

    /// A fragment waits for its verdict.
    #[must_use]
    pub fn waiting(&self) -> bool {
        self.pages.held || self.tests
    }

    /// No fragment may come.
    #[must_use]
    pub fn clearing(&self) -> bool {
        self.pages.clearing()
    }

    /// A clear was done in the clock before.
    #[must_use]
    pub fn cleared(&self) -> bool {
        self.pages.cleared
    }

    /// One clock edge.
    pub fn clock(&mut self, i: &ZBufferInputs) {
        let pass = self.pass();
        let (held, place) = (self.pages.held, self.pages.place);
        let found = match (self.pages.present(), self.same && pass) {
            (false, _) => 0,
            (true, true) => self.depth,
            (true, false) => self.forward.unwrap_or(self.memory.read_data),
        };
        self.pages.clock(&PagesInputs {
            go: i.go,
            clear: i.clear,
            fragment: i.fragment.then_some(i.address),
            touch: held && self.held_depth != 0,
        });
        if i.go {
            self.memory
                .clock(Some(i.address), pass.then_some((self.address, self.depth)));
            self.same = held && i.address == place;
            self.forward = (pass && i.address == self.address).then_some(self.depth);
            (self.tests, self.address, self.depth) = (held, place, self.held_depth);
            self.stored = found;
            self.held_depth = i.depth;
        }
    }
}
