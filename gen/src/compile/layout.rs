//! Where the state of a design lies: one array of 64-bit words, the only thing that generated code touches.
//!
//! A signal of up to 64 bits has a word of its own, a wider one two, the low one first. Behind the signals lie the memories, their words packed in 1, 2, 4, 8 or 16 bytes each.

use super::graph::{Graph, Op, ValueId};
use crate::netlist::{Flat, MemoryId, NetlistError, SignalId};
use std::collections::HashMap;

/// Most bytes of a state: offsets stay below 2^31.
const MAX_BYTES: usize = 1 << 30;

/// A place for a signal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Slot {
    /// First word.
    pub(super) word: usize,
    /// Bits.
    pub(super) width: u32,
}

impl Slot {
    /// Reads the code.
    #[inline]
    pub(super) fn get(self, state: &[u64]) -> u128 {
        let low = u128::from(state[self.word]);
        if self.width <= 64 {
            low
        } else {
            low | u128::from(state[self.word + 1]) << 64
        }
    }

    /// Stores the low bits of a code.
    #[inline]
    pub(super) fn set(self, state: &mut [u64], code: u128) {
        if self.width <= 64 {
            state[self.word] = code as u64 & u64::MAX >> (64 - self.width);
        } else {
            let code = code & u128::MAX >> (128 - self.width);
            state[self.word] = code as u64;
            state[self.word + 1] = (code >> 64) as u64;
        }
    }
}

/// A place for a memory.
#[derive(Clone, Copy, Debug)]
pub(super) struct Words {
    /// First word of the state.
    pub(super) word: usize,
    /// Bytes of a word of the memory: a power of two up to 16.
    pub(super) bytes: usize,
    /// Words of the memory.
    pub(super) count: usize,
    /// Bits of a word of the memory.
    pub(super) width: u32,
}

impl Words {
    /// The word at an address inside the memory.
    pub(super) fn get(self, state: &[u64], address: usize) -> u128 {
        if self.bytes == 16 {
            let at = self.word + 2 * address;
            return u128::from(state[at]) | u128::from(state[at + 1]) << 64;
        }
        let at = address * self.bytes;
        let bytes = state[self.word + at / 8].to_ne_bytes();
        let mut code = [0; 8];
        code[..self.bytes].copy_from_slice(&bytes[at % 8..at % 8 + self.bytes]);
        match self.bytes {
            1 => u128::from(code[0]),
            2 => u128::from(u16::from_ne_bytes([code[0], code[1]])),
            4 => u128::from(u32::from_ne_bytes([code[0], code[1], code[2], code[3]])),
            _ => u128::from(u64::from_ne_bytes(code)),
        }
    }

    /// Stores a word at an address inside the memory.
    pub(super) fn set(self, state: &mut [u64], address: usize, code: u128) {
        if self.bytes == 16 {
            let at = self.word + 2 * address;
            state[at] = code as u64;
            state[at + 1] = (code >> 64) as u64;
            return;
        }
        let at = address * self.bytes;
        let word = &mut state[self.word + at / 8];
        let mut bytes = word.to_ne_bytes();
        let place = &mut bytes[at % 8..at % 8 + self.bytes];
        match self.bytes {
            1 => place.copy_from_slice(&(code as u8).to_ne_bytes()),
            2 => place.copy_from_slice(&(code as u16).to_ne_bytes()),
            4 => place.copy_from_slice(&(code as u32).to_ne_bytes()),
            _ => place.copy_from_slice(&(code as u64).to_ne_bytes()),
        }
        *word = u64::from_ne_bytes(bytes);
    }
}

/// The places of a design.
#[derive(Debug, Default)]
pub(super) struct Layout {
    signals: HashMap<SignalId, Slot>,
    kept: HashMap<ValueId, Slot>,
    pub(super) memories: Vec<Words>,
    /// Words in all.
    pub(super) words: usize,
}

impl Layout {
    /// Places for what the graph loads and for these values, then for the memories.
    pub(super) fn new(
        flat: &Flat<'_>,
        g: &Graph,
        loads: impl Iterator<Item = SignalId>,
        kept: impl Iterator<Item = ValueId>,
    ) -> Result<Self, NetlistError> {
        let mut l = Self::default();
        for s in loads {
            let slot = l.slot(flat.width(s) as u32);
            l.signals.insert(s, slot);
        }
        for v in kept {
            if !l.kept.contains_key(&v) && !matches!(g.op(v), Op::Load(_)) {
                let slot = l.slot(g.width(v));
                l.kept.insert(v, slot);
            }
        }
        for m in &flat.memories {
            let bytes = m.memory.width.div_ceil(8).next_power_of_two();
            let count = m.memory.words;
            l.memories.push(Words {
                word: l.words,
                bytes,
                count,
                width: m.memory.width as u32,
            });
            l.words = l
                .words
                .saturating_add(count.saturating_mul(bytes).div_ceil(8));
        }
        if l.words > MAX_BYTES / 8 {
            let what = format!("the state of the simulation exceeds {MAX_BYTES} bytes");
            return Err(NetlistError::new(&flat.name, what));
        }
        Ok(l)
    }

    fn slot(&mut self, width: u32) -> Slot {
        let word = self.words;
        self.words += if width > 64 { 2 } else { 1 };
        Slot { word, width }
    }

    /// The place of an input, register or clocked read data.
    pub(super) fn signal(&self, id: SignalId) -> Option<Slot> {
        self.signals.get(&id).copied()
    }

    /// The place where a value is found after it has been kept.
    pub(super) fn value(&self, g: &Graph, v: ValueId) -> Option<Slot> {
        match g.op(v) {
            Op::Load(s) => self.signal(s),
            _ => self.kept.get(&v).copied(),
        }
    }

    /// The place of a memory.
    pub(super) fn memory(&self, id: MemoryId) -> Words {
        self.memories[id.index()]
    }
}
