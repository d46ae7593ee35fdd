//! The table of weights V(D) in a read-only memory: [`super::coverage::table`], one synchronous read per clock.
//!
//! With 3 fraction bits it has 12 entries, with 4 it has 24, with 8 (the core's) 384. Distances from 1½ on, which have no
//! entry, weigh nothing.

use super::coverage::table;
use crate::format::U;
use rust_hdl_core::prelude::*;

/// `I` address bits: one integer bit of the distance, and `I` − 1 fraction bits.
#[derive(LogicBlock)]
pub struct WeightRom<const I: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Reads; `weight` keeps its value otherwise.
    pub read: Signal<In, Bit>,
    /// Leading bits of the distance.
    pub index: Signal<In, U<I>>,
    /// The weight read by the last clock that had `read`.
    pub weight: Signal<Out, U<8>>,
    _levels: Vec<u8>,
}

impl<const I: usize> Default for WeightRom<I> {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            read: Default::default(),
            index: Default::default(),
            weight: Default::default(),
            _levels: table(I as u32 - 1),
        }
    }
}

impl<const I: usize> Logic for WeightRom<I> {
    fn update(&mut self) {
        if self.clock.pos_edge() && self.read.val() {
            let level = self._levels.get(self.index.val().get() as usize);
            self.weight.next = U::new(u64::from(level.copied().unwrap_or(0)));
        }
    }

    fn connect(&mut self) {
        self.weight.connect();
    }

    /// Remarks for the back end, which prints its own template from them.
    fn hdl(&self) -> Verilog {
        let words = self._levels.len();
        let bits = I - 1;
        let levels: Vec<String> = self._levels.iter().map(|l| format!("{l:x}")).collect();
        let initial: String = levels
            .chunks(32)
            .map(|c| format!("//! initial {}\n", c.join(" ")))
            .collect();
        Verilog::Custom(format!(
            "//! name weight_rom_{bits}\n\
             //! title Weights of cone-filtered pixels by distance from the line, {bits} fraction bits.\n\
             //! equation weight = round(255 V((i + 1/2) / 2^{bits})), V = strip of one pixel convolved with a unit cone\n\
             //! source Gupta, Sproull and Sutherland 1981; Abbas 2003, section 3.3, without the gain of its tables.\n\
             //! latency One clock from read to weight.\n\
             //! memory words={words} width=8 outside=zero\n\
             //! read address=index data=weight enable=read clock=clock\n\
             {initial}"
        ))
    }
}

crate::clocked!(WeightRom<I>, const I: usize;
    inputs read, index;
    outputs weight);

/// Integer model of [`WeightRom`].
#[derive(Clone, Debug)]
pub struct WeightModel {
    levels: Vec<u8>,
    /// The weight read last.
    pub weight: u8,
}

impl WeightModel {
    /// A table for distances with so many fraction bits.
    #[must_use]
    pub fn new(fraction_bits: u32) -> Self {
        Self {
            levels: table(fraction_bits),
            weight: 0,
        }
    }

    /// One clock.
    pub fn clock(&mut self, read: Option<usize>) {
        if let Some(index) = read {
            self.weight = self.levels.get(index).copied().unwrap_or(0);
        }
    }
}
