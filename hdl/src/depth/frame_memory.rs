//! A simple dual-port memory of as many words as the frame has pixels: one synchronous read and one write per clock,
//! old data on a read that meets a write, all zeros at power-up. Written so that Yosys, Vivado and ISE infer block RAM.
//!
//! rust-hdl's own `RAM` always has 2^A words; a 320×240 frame would waste 41 % of it.

use crate::format::U;
use rust_hdl_core::prelude::*;

/// `A` address bits, 16-bit words. Accesses beyond the last word read nothing and write nothing.
#[derive(LogicBlock)]
pub struct FrameMemory<const A: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Reads; `read_data` keeps its value otherwise.
    pub read: Signal<In, Bit>,
    /// Address to read.
    pub read_address: Signal<In, U<A>>,
    /// The word read by the last clock that had `read`.
    pub read_data: Signal<Out, U<16>>,
    /// Writes.
    pub write: Signal<In, Bit>,
    /// Address to write.
    pub write_address: Signal<In, U<A>>,
    /// Word to write.
    pub write_data: Signal<In, U<16>>,
    _words: Vec<u16>,
}

impl<const A: usize> FrameMemory<A> {
    /// A memory of `words` words, at least two and at most 2^A.
    #[must_use]
    pub fn new(words: usize) -> Self {
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
        }
    }
}

impl<const A: usize> Logic for FrameMemory<A> {
    fn update(&mut self) {
        if self.clock.pos_edge() {
            if self.read.val() {
                if let Some(word) = self._words.get(self.read_address.val().get() as usize) {
                    self.read_data.next = U::new(u64::from(*word));
                }
            }
            if self.write.val() {
                if let Some(word) = self._words.get_mut(self.write_address.val().get() as usize) {
                    *word = self.write_data.val().get() as u16;
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
        Verilog::Custom(format!(
            "//! name frame_memory_{words}\n\
             //! title Depth memory of {words} words of 16 bits: one read and one write per clock.\n\
             //! equation read_data = words[read_address], old data when the same clock writes there\n\
             //! source Simple dual-port template for block RAM; zero at power-up.\n\
             //! latency One clock from read to read_data.\n\
             //! memory words={words} width=16 outside=kept\n\
             //! read address=read_address data=read_data enable=read clock=clock\n\
             //! write address=write_address data=write_data enable=write clock=clock\n\
             reg [15:0] words [0:{last}];\n\
             always @(posedge clock) begin\n  \
             if (write && write_address <= {last}) words[write_address] <= write_data;\n  \
             if (read && read_address <= {last}) read_data <= words[read_address];\n\
             end\n"
        ))
    }
}

crate::clocked!(FrameMemory<A>, const A: usize;
    inputs read, read_address, write, write_address, write_data;
    outputs read_data);

/// Integer model of [`FrameMemory`].
#[derive(Clone, Debug)]
pub struct FrameMemoryModel {
    words: Vec<u16>,
    /// The word read last.
    pub read_data: u16,
}

impl FrameMemoryModel {
    /// A cleared memory.
    #[must_use]
    pub fn new(words: usize) -> Self {
        Self {
            words: vec![0; words],
            read_data: 0,
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
    pub fn clock(&mut self, read: Option<u64>, write: Option<(u64, u16)>) {
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
