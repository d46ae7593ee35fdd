//! A simple dual-port memory of as many words as the frame has pixels: one synchronous read and one write per clock,
//! old data on a read that meets a write, all zeros at power-up. Written so that Yosys, Vivado and ISE infer block RAM.
//!
//! rust-hdl's own `RAM` always has 2^A words; a 320×240 frame would waste 41 % of it.

use crate::format::U;
use rust_hdl_core::prelude::*;

/// The depth memory of a triangle core: 16 bits per pixel.
pub type FrameMemory<const A: usize> = PixelMemory<A, 16>;
/// The frame memory of a line core: a colour of 24 bits per pixel. Colours are kept relative to the background (exclusive
/// or), so zeros are an empty frame of whatever background.
pub type ColourMemory<const A: usize> = PixelMemory<A, 24>;
/// What is current of a frame memory: 18 bits per page, see [`super::pages`].
pub type PageMemory<const A: usize> = PixelMemory<A, 18>;
/// Integer model of [`FrameMemory`].
pub type FrameMemoryModel = PixelMemoryModel<u16>;
/// Integer model of [`ColourMemory`].
pub type ColourMemoryModel = PixelMemoryModel<u32>;

/// Integer model of [`PageMemory`].
pub type PageMemoryModel = PixelMemoryModel<u32>;

/// `A` address bits, words of `W` bits, 32 at most. Accesses beyond the last word read nothing and write nothing.
#[derive(LogicBlock)]
pub struct PixelMemory<const A: usize, const W: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Reads; `read_data` keeps its value otherwise.
    pub read: Signal<In, Bit>,
    /// Address to read.
    pub read_address: Signal<In, U<A>>,
    /// The word read by the last clock that had `read`.
    pub read_data: Signal<Out, U<W>>,
    /// Writes.
    pub write: Signal<In, Bit>,
    /// Address to write.
    pub write_address: Signal<In, U<A>>,
    /// Word to write.
    pub write_data: Signal<In, U<W>>,
    _words: Vec<u32>,
    _name: &'static str,
    _title: &'static str,
}

impl<const A: usize> FrameMemory<A> {
    /// A memory of `words` words, at least two and at most 2^A.
    #[must_use]
    pub fn new(words: usize) -> Self {
        Self::named(words, "frame_memory", "Depth memory of {} words")
    }
}

impl<const A: usize> ColourMemory<A> {
    /// A memory of `words` words, at least two and at most 2^A.
    #[must_use]
    pub fn new(words: usize) -> Self {
        Self::named(words, "colour_memory", "Frame memory of {} colours")
    }
}

impl<const A: usize> PageMemory<A> {
    /// A memory of `words` words, at least two and at most 2^A.
    #[must_use]
    pub fn new(words: usize) -> Self {
        Self::named(words, "page_memory", "Page memory of {} words")
    }
}

impl<const A: usize> PixelMemory<A, 24> {
    /// A quarter of a texture memory, of `words` texels, at least two and at most 2^A.
    #[must_use]
    pub fn bank(words: usize) -> Self {
        Self::named(words, "texel_bank", "Texture memory of {} texels")
    }
}

impl<const A: usize, const W: usize> PixelMemory<A, W> {
    /// With the name of the module and its title, in which {} is the number of words.
    fn named(words: usize, name: &'static str, title: &'static str) -> Self {
        assert!(
            words >= 2 && words <= 1 << A,
            "a memory with {A} address bits has 2 to 2^{A} words, not {words}"
        );
        Self {
            clock: Default::default(),
            read: Default::default(),
            read_address: Default::default(),
            read_data: Default::default(),
            write: Default::default(),
            write_address: Default::default(),
            write_data: Default::default(),
            _words: vec![0; words],
            _name: name,
            _title: title,
        }
    }
}

impl<const A: usize, const W: usize> Logic for PixelMemory<A, W> {
    fn update(&mut self) {
        if self.clock.pos_edge() {
            if self.read.val() {
                if let Some(word) = self._words.get(self.read_address.val().get() as usize) {
                    self.read_data.next = U::new(u64::from(*word));
                }
            }
            if self.write.val() {
                if let Some(word) = self._words.get_mut(self.write_address.val().get() as usize) {
                    *word = self.write_data.val().get() as u32;
                }
            }
        }
    }

    fn connect(&mut self) {
        self.read_data.connect();
    }

    /// Plain Verilog for rust-hdl's own printer; the back end prints its template from the remarks instead.
    fn hdl(&self) -> Verilog {
        let words = self._words.len();
        let last = words - 1;
        let top = W - 1;
        let name = self._name;
        let title = self._title.replace("{}", &words.to_string());
        Verilog::Custom(format!(
            "//! name {name}_{words}\n\
             //! title {title} of {W} bits: one read and one write per clock.\n\
             //! equation read_data = words[read_address], old data when the same clock writes there\n\
             //! source Simple dual-port template for block RAM; zero at power-up.\n\
             //! latency One clock from read to read_data.\n\
             //! memory words={words} width={W} outside=kept\n\
             //! read address=read_address data=read_data enable=read clock=clock\n\
             //! write address=write_address data=write_data enable=write clock=clock\n\
             reg [{top}:0] words [0:{last}];\n\
             always @(posedge clock) begin\n  \
             if (write && write_address <= {last}) words[write_address] <= write_data;\n  \
             if (read && read_address <= {last}) read_data <= words[read_address];\n\
             end\n"
        ))
    }
}

crate::clocked!(PixelMemory<A, W>, const A: usize, const W: usize;
    inputs read, read_address, write, write_address, write_data;
    outputs read_data);

/// Integer model of [`PixelMemory`], with words of type `T`.
#[derive(Clone, Debug)]
pub struct PixelMemoryModel<T> {
    words: Vec<T>,
    /// The word read last.
    pub read_data: T,
}

impl<T: Copy + Default> PixelMemoryModel<T> {
    /// A cleared memory.
    #[must_use]
    pub fn new(words: usize) -> Self {
        Self {
            words: vec![T::default(); words],
            read_data: T::default(),
        }
    }

    /// Number of words.
    #[must_use]
    pub fn len(&self) -> usize {
        self.words.len()
    }

    /// Whether it has no words.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.words.is_empty()
    }

    /// One clock.
    pub fn clock(&mut self, read: Option<u64>, write: Option<(u64, T)>) {
        if let Some(word) = read.and_then(|a| self.words.get(a as usize)) {
            self.read_data = *word;
        }
        if let Some((address, data)) = write {
            if let Some(word) = self.words.get_mut(address as usize) {
                *word = data;
            }
        }
    }
}
