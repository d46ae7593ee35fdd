//! The power table: 512 words of 32 bits in one block RAM, written by the host, one read and one write per clock.
//!
//! A word holds hⁿ at the beginning of its interval and how far it falls to the end: start\[31:14\] and fall\[13:0\], both
//! in units of 2^−18. See [`super::power`] for what they mean.

use crate::format::U;
use rust_hdl_core::prelude::*;

/// Address bits.
pub const ADDRESS_BITS: usize = 9;
/// Words.
pub const WORDS: usize = 1 << ADDRESS_BITS;

/// All zeros at power-up.
#[derive(LogicBlock)]
pub struct PowerTable {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Reads; `read_data` keeps its value otherwise.
    pub read: Signal<In, Bit>,
    /// Interval to read.
    pub read_address: Signal<In, U<9>>,
    /// The word read by the last clock that had `read`.
    pub read_data: Signal<Out, U<32>>,
    /// Writes.
    pub write: Signal<In, Bit>,
    /// Interval to write.
    pub write_address: Signal<In, U<9>>,
    /// Word to write.
    pub write_data: Signal<In, U<32>>,
    _words: Vec<u32>,
}

impl Default for PowerTable {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            read: Default::default(),
            read_address: Default::default(),
            read_data: Default::default(),
            write: Default::default(),
            write_address: Default::default(),
            write_data: Default::default(),
            _words: vec![0; WORDS],
        }
    }
}

impl Logic for PowerTable {
    fn update(&mut self) {
        if self.clock.pos_edge() {
            if self.read.val() {
                let word = self._words[self.read_address.val().get() as usize];
                self.read_data.next = U::new(u64::from(word));
            }
            if self.write.val() {
                let word = self.write_data.val().get() as u32;
                self._words[self.write_address.val().get() as usize] = word;
            }
        }
    }

    fn connect(&mut self) {
        self.read_data.connect();
    }

    /// Plain Verilog for rust-hdl's own printer; the back end prints its template from the remarks instead.
    fn hdl(&self) -> Verilog {
        Verilog::Custom(
            "//! name power_table\n\
             //! title Table of a power function: 512 intervals, each with its first value and its fall.\n\
             //! equation read_data = words[read_address], old data when the same clock writes there\n\
             //! source Simple dual-port template for block RAM, written by the host; zero at power-up.\n\
             //! latency One clock from read to read_data.\n\
             //! memory words=512 width=32 outside=kept\n\
             //! read address=read_address data=read_data enable=read clock=clock\n\
             //! write address=write_address data=write_data enable=write clock=clock\n\
             reg [31:0] words [0:511];\n\
             always @(posedge clock) begin\n  \
             if (write) words[write_address] <= write_data;\n  \
             if (read) read_data <= words[read_address];\n\
             end\n"
                .to_string(),
        )
    }
}

crate::clocked!(PowerTable;
    inputs read, read_address, write, write_address, write_data;
    outputs read_data);
