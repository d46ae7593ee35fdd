//! First approximations of 1/m for 1 ≤ m < 2: 1024 words of 16 bits, all of them fraction, a ROM.
//!
//! The word of an interval of m of width 2⁻¹⁰ is 1/m in its middle, rounded; so m times the word is within 2⁻¹¹ + 2⁻¹⁶
//! of 1.

use crate::format::U;
use rust_hdl_core::prelude::*;

/// Words.
pub const WORDS: usize = 1024;

/// The word of an interval.
#[must_use]
pub fn reciprocal_word(interval: usize) -> u64 {
    let middle = 1.0 + (interval as f64 + 0.5) / WORDS as f64;
    ((1 << 16) as f64 / middle).round() as u64
}

/// A clocked ROM.
#[derive(LogicBlock)]
pub struct ReciprocalTable {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Reads; `read_data` keeps its value otherwise.
    pub read: Signal<In, Bit>,
    /// Interval to read.
    pub read_address: Signal<In, U<10>>,
    /// The word read by the last clock that had `read`.
    pub read_data: Signal<Out, U<16>>,
    _words: Vec<u64>,
}

impl Default for ReciprocalTable {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            read: Default::default(),
            read_address: Default::default(),
            read_data: Default::default(),
            _words: (0..WORDS).map(reciprocal_word).collect(),
        }
    }
}

impl Logic for ReciprocalTable {
    fn update(&mut self) {
        if self.clock.pos_edge() && self.read.val() {
            self.read_data.next = U::new(self._words[self.read_address.val().get() as usize]);
        }
    }

    fn connect(&mut self) {
        self.read_data.connect();
    }

    /// Plain Verilog for rust-hdl's own printer; the back end prints its template from the remarks instead.
    fn hdl(&self) -> Verilog {
        let mut text = String::from(
            "//! name reciprocal_table\n\
             //! title First approximations of 1 / m, 1 <= m < 2, in 1024 intervals of m.\n\
             //! equation read_data = 2^16 / (1 + (read_address + 1/2) / 1024), rounded\n\
             //! source Seed of a Newton step.\n\
             //! latency One clock from read to read_data.\n\
             //! memory words=1024 width=16 outside=kept\n\
             //! read address=read_address data=read_data enable=read clock=clock\n",
        );
        for line in self._words.chunks(16) {
            let words: Vec<String> = line.iter().map(|w| format!("{w:x}")).collect();
            text += &format!("//! initial {}\n", words.join(" "));
        }
        text += "reg [15:0] words [0:1023];\n\
                 always @(posedge clock) if (read) read_data <= words[read_address];\n";
        Verilog::Custom(text)
    }
}

crate::clocked!(ReciprocalTable;
    inputs read, read_address;
    outputs read_data);
