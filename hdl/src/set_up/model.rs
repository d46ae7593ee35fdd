//! Integer model of the set-up engine, clock by clock.

use super::divider::DividerModel;
use super::instruction::{Instruction, Layout, XFrom, YFrom};
use super::multiplier::MultiplierModel;
use super::program::program;
use super::{constant, WORD_FRACTION_BITS};
use crate::format::mask;

/// What the engine sees in one clock.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct EngineInputs {
    /// A word of a triangle: slot and data; ignored while `load_ready` is low.
    pub write: Option<(u8, u64)>,
    /// A register of the frame: 11 columns, 12 rows.
    pub frame: Option<(usize, u64)>,
    /// The words are complete.
    pub start: bool,
    /// The core takes words.
    pub ready: bool,
}

/// What it drives, given its inputs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct EngineOutputs {
    /// Words of a triangle may be written.
    pub load_ready: bool,
    /// A word for the core: select code and data.
    pub word: Option<(u8, u64)>,
    /// With the last word.
    pub start: bool,
    /// A triangle is being skipped.
    pub skip: bool,
    /// A triangle is waiting or in work.
    pub busy: bool,
}

/// State of the engine.
#[derive(Clone, Debug)]
pub struct EngineModel {
    program: &'static [Instruction],
    fraction_bits: u32,
    bus_bits: usize,
    /// Both banks of raw words.
    raw: Vec<i64>,
    /// The bank that the host writes.
    bank: usize,
    pending: bool,
    running: bool,
    place: usize,
    fetched: Option<Instruction>,
    current: Instruction,
    operands: [i64; 2],
    registers: [i64; 64],
    flags: u16,
    frame: [u64; 2],
    multiplier: MultiplierModel,
    divider: DividerModel,
    /// Triangles begun since power-up.
    pub begun: u64,
    /// Triangles skipped since power-up, modulo 2^16.
    pub skipped: u16,
}

impl EngineModel {
    /// An engine for a core whose colours have `fraction_bits`, on a bus of `bus_bits`.
    #[must_use]
    pub fn new(fraction_bits: usize, bus_bits: usize) -> Self {
        Self {
            program: program(),
            fraction_bits: fraction_bits as u32,
            bus_bits,
            raw: vec![0; 128],
            bank: 0,
            pending: false,
            running: false,
            place: 0,
            fetched: None,
            current: Instruction::default(),
            operands: [0; 2],
            registers: [0; 64],
            flags: 0,
            frame: [0; 2],
            multiplier: MultiplierModel::default(),
            divider: DividerModel::default(),
            begun: 0,
            skipped: 0,
        }
    }

    fn xy(&self) -> [i64; 2] {
        let i = &self.current;
        let x = match i.x_from {
            XFrom::Register => self.operands[0],
            XFrom::Product => self.multiplier.product,
            XFrom::Quotient => self.divider.quotient as i64,
            XFrom::Remainder => self.divider.remainder(),
        };
        let y = match i.y_from {
            YFrom::Constant => constant(i.y, self.fraction_bits, self.frame),
            _ => self.operands[1],
        };
        let shift = super::instruction::Y_SHIFTS[usize::from(i.y_shift)];
        [if i.x_down { x >> 8 } else { x }, y << shift]
    }

    fn unit_bits(&self) -> u32 {
        if self.current.depth {
            16
        } else {
            WORD_FRACTION_BITS - self.fraction_bits
        }
    }

    fn result(&self) -> i64 {
        use super::instruction::Function;
        let [x, y] = self.xy();
        let i = &self.current;
        let sum = match i.function {
            Function::Sum => x.wrapping_add(y),
            Function::Difference => x.wrapping_sub(y),
            Function::Reversed => y.wrapping_sub(x),
            Function::Choice if self.flags >> i.flag & 1 == 1 => x,
            Function::Choice => y,
        };
        if i.cut {
            sum >> self.unit_bits() << self.unit_bits()
        } else {
            sum
        }
    }

    fn skipping(&self) -> bool {
        self.current.skip && self.flags >> self.current.flag & 1 == 1
    }

    /// The engine stands still: its word is not taken.
    fn stalls(&self, ready: bool) -> bool {
        self.current.send.is_some() && !ready
    }

    /// The outputs of the current state.
    #[must_use]
    pub fn outputs(&self) -> EngineOutputs {
        let word = self.current.send.map(|(select, layout)| {
            let [x, y] = self.xy().map(|v| v as u64);
            let data = match layout {
                Layout::Word => (self.result() >> self.unit_bits()) as u64,
                Layout::Edge => (x & mask(12)) << 20 | y & mask(20),
                Layout::Rows => (x & mask(21)) << 11 | y & mask(11),
            };
            (select, data & mask(self.bus_bits))
        });
        EngineOutputs {
            load_ready: !self.pending,
            word,
            start: self.current.end,
            skip: self.skipping(),
            busy: self.pending || self.running,
        }
    }

    /// Raw slot as the memory has it: vertices in the host's order.
    fn slot(&self, i: &Instruction) -> usize {
        let y = usize::from(i.y);
        let [f01, f02, f12] = [0, 1, 2].map(|f| self.flags >> f & 1 == 1);
        let top = match (f01, f02, f12) {
            (true, true, _) => 0,
            (false, _, true) => 1,
            _ => 2,
        };
        let bottom = match (f01, f02, f12) {
            (false, false, _) => 0,
            (true, _, false) => 1,
            _ => 2,
        };
        match (i.y_from, y & 3) {
            (YFrom::Sorted, 0) => y & !3 | top,
            (YFrom::Sorted, 1) => y & !3 | (3 - top - bottom),
            (YFrom::Sorted, 2) => y & !3 | bottom,
            _ => y,
        }
    }

    /// One clock edge.
    pub fn clock(&mut self, i: &EngineInputs) {
        let go = !self.stalls(i.ready);
        let begins = !self.running && self.pending;
        if go {
            let [x, y] = self.xy();
            let result = self.result();
            let current = self.current;
            let ends = current.end || self.skipping();
            self.skipped = self.skipped.wrapping_add(u16::from(self.skipping()));
            // Operands of the next instruction are what the memories held before this edge.
            let next = self.fetched.unwrap_or_default();
            let y_operand = match next.y_from {
                YFrom::Register => self.registers[usize::from(next.y)],
                _ => self.raw[(1 - self.bank) * 64 + self.slot(&next)],
            };
            self.operands = [self.registers[usize::from(next.x)], y_operand];
            if let Some(to) = current.to {
                self.registers[usize::from(to)] = result;
            }
            if current.flag_write {
                let bit = 1 << current.flag;
                self.flags = self.flags & !bit | if result < 0 { bit } else { 0 };
            }
            let exponent = self.divider.exponent;
            self.multiplier.clock(
                current
                    .multiply
                    .map(|(limbs, places, e)| (x, y, limbs, places, e)),
                exponent,
            );
            self.divider.clock(current.divide.map(|kind| (x, y, kind)));
            self.current = if ends { Instruction::default() } else { next };
            self.fetched = (self.running && !ends)
                .then(|| self.program.get(self.place).copied().unwrap_or_default());
            self.place += 1;
            if ends {
                self.running = false;
            }
        }
        if begins {
            self.running = true;
            self.begun += 1;
            self.place = 0;
            self.bank = 1 - self.bank;
            self.pending = false;
        } else {
            if let (Some((slot, data)), false) = (i.write, self.pending) {
                let value = (data << 40) as i64 >> 40;
                self.raw[self.bank * 64 + usize::from(slot)] = value;
            }
            if let (Some((word @ (11 | 12), data)), false) = (i.frame, self.pending) {
                self.frame[word - 11] = data & mask(12);
            }
            self.pending |= i.start;
        }
    }

    /// Instructions of the program.
    #[must_use]
    pub fn length(&self) -> usize {
        self.program.len()
    }
}
