//! Operations. A word lives in the least of 32, 64 and 128 bits, zero-extended; what may leave its width is masked.

use super::super::fold::mask;
use super::super::graph::{Op, ValueId};
use super::access::machine;
use super::Emitter;
use crate::netlist::{Operator, Reduction};
use cranelift_codegen::ir::condcodes::{CondCode, IntCC};
use cranelift_codegen::ir::{types, InstBuilder, Type, Value};

/// A machine value and the bits of its word.
type Word = (Value, u32);

fn bits(width: u32) -> u32 {
    machine(width).bits()
}

impl Emitter<'_, '_> {
    /// A constant of a width.
    pub(super) fn constant(&mut self, code: u128, width: u32) -> Value {
        match machine(width) {
            types::I128 => {
                let low = self.code.ins().iconst(types::I64, code as u64 as i64);
                let high = self
                    .code
                    .ins()
                    .iconst(types::I64, (code >> 64) as u64 as i64);
                self.code.ins().iconcat(low, high)
            }
            // The immediate is the bits of the type, zero-extended.
            ty => self.code.ins().iconst(ty, code as u64 as i64),
        }
    }

    /// Clears what is above the width.
    fn masked(&mut self, value: Value, width: u32) -> Value {
        if width == bits(width) {
            return value;
        }
        let mask = self.constant(mask(width), width);
        self.code.ins().band(value, mask)
    }

    /// The same code in another machine type; bits that do not fit are lost.
    fn convert(&mut self, value: Value, to: Type) -> Value {
        let from = self.code.func.dfg.value_type(value);
        match from.bits().cmp(&to.bits()) {
            std::cmp::Ordering::Less => self.code.ins().uextend(to, value),
            std::cmp::Ordering::Equal => value,
            std::cmp::Ordering::Greater => self.code.ins().ireduce(to, value),
        }
    }

    fn shift_constant(&mut self, by: u32) -> Value {
        self.code.ins().iconst(types::I32, i64::from(by))
    }

    /// The code as a signed number in the machine type of the width `to`.
    fn signed(&mut self, (value, width): Word, to: u32) -> Value {
        let ty = machine(to);
        if width == bits(width) {
            return match bits(width) == ty.bits() {
                true => value,
                false => self.code.ins().sextend(ty, value),
            };
        }
        let value = self.convert(value, ty);
        let by = self.shift_constant(ty.bits() - width);
        let high = self.code.ins().ishl(value, by);
        self.code.ins().sshr(high, by)
    }

    /// The word with bits replaced from a position on.
    pub(super) fn insert(&mut self, (word, width): Word, at: u32, (part, n): Word) -> Value {
        let hole = self.constant(mask(width) & !(mask(n) << at), width);
        let rest = self.code.ins().band(word, hole);
        let part = self.convert(part, machine(width));
        let by = self.shift_constant(at);
        let part = self.code.ins().ishl(part, by);
        self.code.ins().bor(rest, part)
    }

    /// A shift amount, or position, below a limit as a machine number, and whether it is below (`None`: always).
    fn amount(&mut self, (amount, width): Word, limit: u32) -> (Value, Option<Value>) {
        let always = width < 32 && (1 << width) <= limit;
        let below = (!always).then(|| {
            // The limit is at most 128: a word too narrow to hold it was always below.
            let limit = self.constant(u128::from(limit), width);
            let less = IntCC::UnsignedLessThan;
            self.code.ins().icmp(less, amount, limit)
        });
        (self.convert(amount, types::I32), below)
    }

    fn shift(&mut self, left: bool, (value, width): Word, by: Word) -> Value {
        let (by, below) = self.amount(by, width);
        let moved = if left {
            let moved = self.code.ins().ishl(value, by);
            self.masked(moved, width)
        } else {
            self.code.ins().ushr(value, by)
        };
        match below {
            None => moved,
            Some(c) => {
                let zero = self.constant(0, width);
                self.code.ins().select(c, moved, zero)
            }
        }
    }

    fn replace_bit(&mut self, (value, width): Word, position: Word, bit: Value) -> Value {
        let (by, below) = self.amount(position, width);
        let one = self.constant(1, width);
        let one = self.code.ins().ishl(one, by);
        let rest = self.code.ins().band_not(value, one);
        let bit = self.convert(bit, machine(width));
        let bit = self.code.ins().ishl(bit, by);
        let replaced = self.code.ins().bor(rest, bit);
        match below {
            None => replaced,
            Some(c) => self.code.ins().select(c, replaced, value),
        }
    }

    fn compare(&mut self, cc: IntCC, a: Value, b: Value) -> Value {
        let bit = self.code.ins().icmp(cc, a, b);
        self.code.ins().uextend(types::I32, bit)
    }

    fn reduce(&mut self, r: Reduction, (value, width): Word) -> Value {
        match r {
            Reduction::All => {
                let ones = self.constant(mask(width), width);
                self.compare(IntCC::Equal, value, ones)
            }
            Reduction::Any => {
                let zero = self.constant(0, width);
                self.compare(IntCC::NotEqual, value, zero)
            }
            Reduction::Parity => {
                let word = if bits(width) == 128 {
                    let (low, high) = self.code.ins().isplit(value);
                    self.code.ins().bxor(low, high)
                } else {
                    value
                };
                let ones = self.code.ins().popcnt(word);
                let ones = self.convert(ones, types::I32);
                self.masked(ones, 1)
            }
        }
    }

    /// A comparison of the graph: code, operands; negated on demand.
    fn comparison(&mut self, op: Op, negated: bool) -> Option<Value> {
        let (cc, a, b, signed) = match op {
            Op::Equal(a, b) => (IntCC::Equal, a, b, false),
            Op::Less(false, a, b) => (IntCC::UnsignedLessThan, a, b, false),
            Op::Less(true, a, b) => (IntCC::SignedLessThan, a, b, true),
            _ => return None,
        };
        let width = self.graph.width(a);
        let (mut x, mut y) = (self.value(a), self.value(b));
        if signed && width < bits(width) {
            // The sign moves to the top; the order stays.
            let by = self.shift_constant(bits(width) - width);
            x = self.code.ins().ishl(x, by);
            y = self.code.ins().ishl(y, by);
        }
        let cc = if negated { cc.complement() } else { cc };
        Some(self.compare(cc, x, y))
    }

    /// Computes a value whose operands are computed.
    pub(super) fn operation(&mut self, v: ValueId) -> Value {
        let (op, width) = (self.graph.op(v), self.graph.width(v));
        let ty = machine(width);
        let graph = self.graph;
        if let Some(bit) = self.comparison(op, false) {
            return bit;
        }
        let word = |e: &mut Self, v: ValueId| -> Word { (e.value(v), graph.width(v)) };
        match op {
            Op::Constant(code) => self.constant(code, width),
            Op::Load(s) => match self.layout.signal(s) {
                Some(slot) => self.load(slot),
                None => self.constant(0, width),
            },
            Op::Word(m, address) => {
                let address = word(self, address);
                self.read(self.layout.memory(m), address)
            }
            Op::Not(a) => {
                if let Some(bit) = self.comparison(graph.op(a), true) {
                    return bit;
                }
                let (a, ones) = (self.value(a), self.constant(mask(width), width));
                self.code.ins().bxor(a, ones)
            }
            Op::Negate(a) => {
                let a = self.value(a);
                let negative = self.code.ins().ineg(a);
                self.masked(negative, width)
            }
            Op::Binary(operator, a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                match operator {
                    Operator::Add => {
                        let sum = self.code.ins().iadd(a, b);
                        self.masked(sum, width)
                    }
                    Operator::Subtract => {
                        let difference = self.code.ins().isub(a, b);
                        self.masked(difference, width)
                    }
                    Operator::And => self.code.ins().band(a, b),
                    Operator::Or => self.code.ins().bor(a, b),
                    Operator::Xor => self.code.ins().bxor(a, b),
                }
            }
            Op::Product(signed, a, b) => {
                let (a, b) = (word(self, a), word(self, b));
                let (a, b) = if signed {
                    (self.signed(a, width), self.signed(b, width))
                } else {
                    (self.convert(a.0, ty), self.convert(b.0, ty))
                };
                let product = self.code.ins().imul(a, b);
                self.masked(product, width)
            }
            Op::Reduce(r, a) => {
                let a = word(self, a);
                self.reduce(r, a)
            }
            Op::ShiftLeft(a, by) | Op::ShiftRight(a, by) => {
                let (a, by) = (word(self, a), word(self, by));
                self.shift(matches!(op, Op::ShiftLeft(..)), a, by)
            }
            Op::Slice(a, at) => {
                let (a, whole) = word(self, a);
                let by = self.shift_constant(at);
                let moved = if at == 0 {
                    a
                } else {
                    self.code.ins().ushr(a, by)
                };
                let part = self.convert(moved, ty);
                if at + width == whole {
                    return part;
                }
                self.masked(part, width)
            }
            Op::ZeroExtend(a) => {
                let a = self.value(a);
                self.convert(a, ty)
            }
            Op::SignExtend(a) => {
                let a = word(self, a);
                let extended = self.signed(a, width);
                self.masked(extended, width)
            }
            Op::ReplaceBit(a, position, bit) => {
                let (a, position, bit) = (word(self, a), word(self, position), self.value(bit));
                self.replace_bit(a, position, bit)
            }
            Op::Insert(a, at, b) => {
                let (a, b) = (word(self, a), word(self, b));
                self.insert(a, at, b)
            }
            Op::Choose(c, a, b) => {
                let (c, a, b) = (self.value(c), self.value(a), self.value(b));
                self.code.ins().select(c, a, b)
            }
            Op::Equal(..) | Op::Less(..) => self.constant(0, width),
        }
    }
}
