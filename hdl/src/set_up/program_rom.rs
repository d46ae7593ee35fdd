//! The program memory: the instructions of [`super::program`], one synchronous read per clock.

use super::program::program;
use crate::format::U;
use rust_hdl_core::prelude::*;

/// Words behind the last one read as zero, an instruction that does nothing.
#[derive(LogicBlock)]
pub struct ProgramRom {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Reads; `word` keeps its value otherwise.
    pub read: Signal<In, Bit>,
    /// Place in the program.
    pub place: Signal<In, U<9>>,
    /// The instruction read by the last clock that had `read`.
    pub word: Signal<Out, U<63>>,
    _words: Vec<u64>,
}

impl Default for ProgramRom {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            read: Default::default(),
            place: Default::default(),
            word: Default::default(),
            _words: program().iter().map(|i| i.encode()).collect(),
        }
    }
}

impl Logic for ProgramRom {
    fn update(&mut self) {
        if self.clock.pos_edge() && self.read.val() {
            let word = self._words.get(self.place.val().get() as usize);
            self.word.next = U::new(word.copied().unwrap_or(0));
        }
    }

    fn connect(&mut self) {
        self.word.connect();
    }

    /// Remarks for the back end, which prints its own template from them.
    fn hdl(&self) -> Verilog {
        let words = self._words.len();
        let codes: Vec<String> = self._words.iter().map(|w| format!("{w:x}")).collect();
        let initial: String = codes
            .chunks(8)
            .map(|c| format!("//! initial {}\n", c.join(" ")))
            .collect();
        Verilog::Custom(format!(
            "//! name set_up_program\n\
             //! title The program of the set-up engine: {words} instructions, scheduled clock by clock.\n\
             //! equation word = instruction[place], 0 (no operation) behind the last one\n\
             //! source Written by a list scheduler from the operations in hdl/src/set_up/program.rs.\n\
             //! latency One clock from read to word.\n\
             //! memory words={words} width=63 outside=zero\n\
             //! read address=place data=word enable=read clock=clock\n\
             {initial}"
        ))
    }
}

crate::clocked!(ProgramRom;
    inputs read, place;
    outputs word);
