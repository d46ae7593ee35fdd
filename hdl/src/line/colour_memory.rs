//! The frame memory of a line core: one colour of 24 bits per pixel, one synchronous read and one write per clock, old
//! data on a read that meets a write, all zeros at power-up.
//!
//! Colours are kept relative to the background (exclusive or), so zeros are an empty frame of whatever background.

use crate::format::U;
use rust_hdl_core::prelude::*;

/// `A` address bits, 24-bit words. Accesses beyond the last word read nothing and write nothing.
#[derive(LogicBlock)]
pub struct ColourMemory<const A: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Reads; `read_data` keeps its value otherwise.
    pub read: Signal<In, Bit>,
    /// Address to read.
    pub read_address: Signal<In, U<A>>,
    /// The word read by the last clock that had `read`.
    pub read_data: Signal<Out, U<24>>,
    /// Writes.
    pub write: Signal<In, Bit>,
    /// Address to write.
    pub write_address: Signal<In, U<A>>,
    /// Word to write.
    pub write_data: Signal<In, U<24>>,
    _words: Vec<u32>,
}

impl<const A: usize> ColourMemory<A> {
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

impl<const A: usize> Logic for ColourMemory<A> {
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

    /// Remarks for the back end, which prints its own template from them.
    fn hdl(&self) -> Verilog {
        let words = self._words.len();
        Verilog::Custom(format!(
            "//! name colour_memory_{words}\n\
             //! title Frame memory of {words} colours of 24 bits: one read and one write per clock.\n\
             //! equation read_data = words[read_address], old data when the same clock writes there\n\
             //! source Simple dual-port template for block RAM; zero at power-up.\n\
             //! latency One clock from read to read_data.\n\
             //! memory words={words} width=24 outside=kept\n\
             //! read address=read_address data=read_data enable=read clock=clock\n\
             //! write address=write_address data=write_data enable=write clock=clock\n"
        ))
    }
}

crate::clocked!(ColourMemory<A>, const A: usize;
    inputs read, read_address, write, write_address, write_data;
    outputs read_data);

/// Integer model of [`ColourMemory`].
#[derive(Clone, Debug)]
pub struct ColourMemoryModel {
    words: Vec<u32>,
    /// The word read last.
    pub read_data: u32,
}

impl ColourMemoryModel {
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
    pub fn words(&self) -> usize {
        self.words.len()
    }

    /// One clock.
    pub fn clock(&mut self, read: Option<u64>, write: Option<(u64, u32)>) {
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
