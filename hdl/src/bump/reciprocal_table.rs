//! 1/(1 + x) for 0 ≤ x < 1: 256 intervals, each with its first value and its fall, a ROM.
//!
//! The chord of an interval of width w = 2^−8 is off by at most w²/8·2 on one side; it is moved by half of what it is off
//! in the middle, so 2^−19 is left, and half a unit of 2^−18 each for start and fall.

use crate::format::U;
use rust_hdl_core::prelude::*;

/// Words.
pub const WORDS: usize = 256;

/// Value at the beginning of an interval (bits 27 to 10) and its fall to the end (bits 9 to 0), both in 2^−18.
#[must_use]
pub fn reciprocal_word(interval: usize) -> u64 {
    let unit = f64::from(1 << 18);
    let value = |i: f64| unit / (1.0 + i / WORDS as f64);
    let at = interval as f64;
    let (from, to) = (value(at), value(at + 1.0));
    let lift = (value(at + 0.5) - (from + to) / 2.0) / 2.0;
    let start = ((from + lift).round() as u64).min((1 << 18) - 1);
    start << 10 | ((from - to).round() as u64)
}

/// A clocked ROM.
#[derive(LogicBlock)]
pub struct ReciprocalTable {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Reads; `read_data` keeps its value otherwise.
    pub read: Signal<In, Bit>,
    /// Interval to read.
    pub read_address: Signal<In, U<8>>,
    /// The word read by the last clock that had `read`.
    pub read_data: Signal<Out, U<28>>,
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
            "//! name bump_reciprocal_table\n\
             //! title 1 / (1 + x), 0 <= x < 1, in 256 intervals, each with its first value and its fall.\n\
             //! equation read_data[27:10] = 2^18 / (1 + read_address / 256), read_data[9:0] what it falls to the next\n\
             //! source Chords moved by half of their error.\n\
             //! latency One clock from read to read_data.\n\
             //! memory words=256 width=28 outside=kept\n\
             //! read address=read_address data=read_data enable=read clock=clock\n",
        );
        for line in self._words.chunks(8) {
            let words: Vec<String> = line.iter().map(|w| format!("{w:x}")).collect();
            text += &format!("//! initial {}\n", words.join(" "));
        }
        text += "reg [27:0] words [0:255];\n\
                 always @(posedge clock) if (read) read_data <= words[read_address];\n";
        Verilog::Custom(text)
    }
}

crate::clocked!(ReciprocalTable;
    inputs read, read_address;
    outputs read_data);
