//! A table that the host writes: a simple dual-port memory of 2^A words, one synchronous read and one write per clock,
//! old data on a read that meets a write, zeros at power-up. Small ones become look-up tables, large ones block RAM.

use crate::format::{mask, U};
use rust_hdl_core::prelude::*;

/// `A` address bits, `D` data bits.
#[derive(LogicBlock)]
pub struct TableMemory<const A: usize, const D: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Reads; `read_data` keeps its value otherwise.
    pub read: Signal<In, Bit>,
    /// Address to read.
    pub read_address: Signal<In, U<A>>,
    /// The word read by the last clock that had `read`.
    pub read_data: Signal<Out, U<D>>,
    /// Writes.
    pub write: Signal<In, Bit>,
    /// Address to write.
    pub write_address: Signal<In, U<A>>,
    /// Word to write.
    pub write_data: Signal<In, U<D>>,
    _words: Vec<u64>,
}

impl<const A: usize, const D: usize> Default for TableMemory<A, D> {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            read: Default::default(),
            read_address: Default::default(),
            read_data: Default::default(),
            write: Default::default(),
            write_address: Default::default(),
            write_data: Default::default(),
            _words: vec![0; 1 << A],
        }
    }
}

impl<const A: usize, const D: usize> Logic for TableMemory<A, D> {
    fn update(&mut self) {
        if self.clock.pos_edge() {
            if self.read.val() {
                let word = self._words[self.read_address.val().get() as usize];
                self.read_data.next = U::new(word);
            }
            if self.write.val() {
                let at = self.write_address.val().get() as usize;
                self._words[at] = self.write_data.val().get();
            }
        }
    }

    fn connect(&mut self) {
        self.read_data.connect();
    }

    /// Plain Verilog for rust-hdl's own printer; the back end prints its template from the remarks instead.
    fn hdl(&self) -> Verilog {
        let words = 1u64 << A;
        let (last, top) = (words - 1, D - 1);
        Verilog::Custom(format!(
            "//! name table_memory_{words}x{D}\n\
             //! title Table of {words} words of {D} bits: one read and one write per clock.\n\
             //! equation read_data = words[read_address], old data when the same clock writes there\n\
             //! source Simple dual-port template; zero at power-up, written by the host.\n\
             //! latency One clock from read to read_data.\n\
             //! memory words={words} width={D} outside=kept\n\
             //! read address=read_address data=read_data enable=read clock=clock\n\
             //! write address=write_address data=write_data enable=write clock=clock\n\
             reg [{top}:0] words [0:{last}];\n\
             always @(posedge clock) begin\n  \
             if (write) words[write_address] <= write_data;\n  \
             if (read) read_data <= words[read_address];\n\
             end\n"
        ))
    }
}

crate::clocked!(TableMemory<A, D>, const A: usize, const D: usize;
    inputs read, read_address, write, write_address, write_data;
    outputs read_data);

/// Integer model of [`TableMemory`].
#[derive(Clone, Debug)]
pub struct TableMemoryModel {
    words: Vec<u64>,
    data_bits: usize,
    /// The word read last.
    pub read_data: u64,
}

impl TableMemoryModel {
    /// A table of zeros.
    #[must_use]
    pub fn new(address_bits: usize, data_bits: usize) -> Self {
        Self {
            words: vec![0; 1 << address_bits],
            data_bits,
            read_data: 0,
        }
    }

    /// One clock; addresses are taken modulo the size.
    pub fn clock(&mut self, read: Option<u64>, write: Option<(u64, u64)>) {
        let last = self.words.len() - 1;
        if let Some(address) = read {
            self.read_data = self.words[address as usize & last];
        }
        if let Some((address, data)) = write {
            self.words[address as usize & last] = data & mask(self.data_bits);
        }
    }
}
