//! Sixteen words with one port: the word at `address` shows at once, and a write goes there at the clock. One look-up
//! table of four inputs per bit.

use crate::format::U;
use rust_hdl_core::prelude::*;

/// `D` data bits. Latency: none from `address` to `read_data`, one clock from `write`.
#[derive(LogicBlock)]
pub struct WordMemory<const D: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes.
    pub write: Signal<In, Bit>,
    /// Address to read, and to write.
    pub address: Signal<In, U<4>>,
    /// Word to write.
    pub write_data: Signal<In, U<D>>,
    /// The word at the address.
    pub read_data: Signal<Out, U<D>>,
    _words: [u64; 16],
}

impl<const D: usize> Default for WordMemory<D> {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            write: Default::default(),
            address: Default::default(),
            write_data: Default::default(),
            read_data: Default::default(),
            _words: [0; 16],
        }
    }
}

impl<const D: usize> Logic for WordMemory<D> {
    fn update(&mut self) {
        let at = self.address.val().get() as usize;
        if self.clock.pos_edge() && self.write.val() {
            self._words[at] = self.write_data.val().get();
        }
        self.read_data.next = U::new(self._words[at]);
    }

    fn connect(&mut self) {
        self.read_data.connect();
    }

    /// Plain Verilog for rust-hdl's own printer; the back end prints its template from the remarks instead.
    fn hdl(&self) -> Verilog {
        let top = D - 1;
        Verilog::Custom(format!(
            "//! name word_memory_16x{D}\n\
             //! title Sixteen words of {D} bits in look-up tables, one port.\n\
             //! equation read_data = words[address]\n\
             //! source Single-port template of distributed memory; zero at power-up, written by the host.\n\
             //! latency None from address to read_data; one clock from write.\n\
             //! memory words=16 width={D} outside=kept\n\
             //! read address=address data=read_data\n\
             //! write address=address data=write_data enable=write clock=clock\n\
             reg [{top}:0] words [0:15];\n\
             always @(posedge clock) if (write) words[address] <= write_data;\n\
             assign read_data = words[address];\n"
        ))
    }
}

crate::clocked!(WordMemory<D>, const D: usize;
    inputs write, address, write_data;
    outputs read_data);
