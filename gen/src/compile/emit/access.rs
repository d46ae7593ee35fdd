//! Loads and stores of signals and memory words. Every address is inside the state: a slot's by layout, a word's
//! because its index is compared with the number of words here, next to the access.

use super::super::layout::{Slot, Words};
use super::Emitter;
use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::{types, InstBuilder, MemFlagsData, Type, Value};

/// The machine type of a word.
pub(super) fn machine(width: u32) -> Type {
    match width {
        0..=32 => types::I32,
        33..=64 => types::I64,
        _ => types::I128,
    }
}

/// All accesses are aligned and inside the state.
fn flags() -> MemFlagsData {
    MemFlagsData::trusted()
}

/// Where the machine value of a slot begins: the low half of its word when it is half as wide.
fn offset(slot: Slot) -> i32 {
    let half = machine(slot.width) == types::I32 && cfg!(target_endian = "big");
    (slot.word * 8) as i32 + if half { 4 } else { 0 }
}

impl Emitter<'_, '_> {
    fn load_at(&mut self, address: Value, offset: i32, width: u32) -> Value {
        match machine(width) {
            types::I128 => {
                let low = self.code.ins().load(types::I64, flags(), address, offset);
                let high = self
                    .code
                    .ins()
                    .load(types::I64, flags(), address, offset + 8);
                self.code.ins().iconcat(low, high)
            }
            ty => self.code.ins().load(ty, flags(), address, offset),
        }
    }

    fn store_at(&mut self, address: Value, offset: i32, width: u32, value: Value) {
        if machine(width) == types::I128 {
            let (low, high) = self.code.ins().isplit(value);
            self.code.ins().store(flags(), low, address, offset);
            self.code.ins().store(flags(), high, address, offset + 8);
        } else {
            self.code.ins().store(flags(), value, address, offset);
        }
    }

    /// The code in a slot.
    pub(super) fn load(&mut self, slot: Slot) -> Value {
        self.load_at(self.state, offset(slot), slot.width)
    }

    /// Stores a code in a slot.
    pub(super) fn store(&mut self, slot: Slot, value: Value) {
        self.store_at(self.state, offset(slot), slot.width, value);
    }

    /// Whether an address is inside a memory; `None` if it cannot be outside.
    fn inside(&mut self, words: Words, (address, width): (Value, u32)) -> Option<Value> {
        if width < usize::BITS && 1 << width <= words.count {
            return None;
        }
        let count = self.constant(words.count as u128, width);
        let less = IntCC::UnsignedLessThan;
        Some(self.code.ins().icmp(less, address, count))
    }

    /// The address of a word, whose index is inside the memory.
    fn place(&mut self, words: Words, index: Value) -> Value {
        let index = match self.code.func.dfg.value_type(index) {
            types::I32 => self.code.ins().uextend(types::I64, index),
            types::I128 => self.code.ins().ireduce(types::I64, index),
            _ => index,
        };
        let shift = i64::from(words.bytes.trailing_zeros());
        let shift = self.code.ins().iconst(types::I64, shift);
        let offset = self.code.ins().ishl(index, shift);
        self.code.ins().iadd(self.state, offset)
    }

    /// The word at an address; zero outside.
    pub(super) fn read(&mut self, words: Words, address: (Value, u32)) -> Value {
        let inside = self.inside(words, address);
        let zero = self.constant(0, address.1);
        let index = match inside {
            None => address.0,
            Some(c) => self.code.ins().select(c, address.0, zero),
        };
        let place = self.place(words, index);
        let offset = (words.word * 8) as i32;
        let value = match words.bytes {
            1 => self.code.ins().uload8(types::I32, flags(), place, offset),
            2 => self.code.ins().uload16(types::I32, flags(), place, offset),
            _ => self.load_at(place, offset, words.width),
        };
        match inside {
            None => value,
            Some(c) => {
                let zero = self.constant(0, words.width);
                self.code.ins().select(c, value, zero)
            }
        }
    }

    /// Stores a word at an address; nothing outside.
    pub(super) fn write(&mut self, words: Words, address: (Value, u32), value: Value) {
        let end = self.inside(words, address).map(|c| {
            let (store, end) = (self.code.create_block(), self.code.create_block());
            self.code.ins().brif(c, store, &[], end, &[]);
            self.code.switch_to_block(store);
            end
        });
        let place = self.place(words, address.0);
        let offset = (words.word * 8) as i32;
        match words.bytes {
            1 => {
                self.code.ins().istore8(flags(), value, place, offset);
            }
            2 => {
                self.code.ins().istore16(flags(), value, place, offset);
            }
            _ => self.store_at(place, offset, words.width, value),
        }
        if let Some(end) = end {
            self.code.ins().jump(end, &[]);
            self.code.switch_to_block(end);
        }
    }
}
