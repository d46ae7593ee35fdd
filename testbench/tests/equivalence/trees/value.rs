//! Values of a width known at run time, computed by rust-hdl's own `Bits<N>`, `Signed<N>` and `bool`: every operation
//! here only finds the right `N` and calls theirs.

use rust_hdl_core::prelude::*;

/// Kind and width of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// `bool`
    Bit,
    /// `Bits<N>`
    Word(usize),
    /// `Signed<N>`
    Int(usize),
}

/// Operators on two values of one format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    Add,
    Subtract,
    And,
    Or,
    Xor,
    Both,
    Either,
}

/// Comparisons.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
}

/// Reductions of a word to a bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reduction {
    All,
    Any,
    Parity,
}

fn compared<T: PartialOrd>(c: Comparison, a: T, b: T) -> bool {
    match c {
        Comparison::Equal => a == b,
        Comparison::NotEqual => a != b,
        Comparison::Less => a < b,
        Comparison::LessEqual => a <= b,
        Comparison::Greater => a > b,
        Comparison::GreaterEqual => a >= b,
    }
}

fn joined<const N: usize>(op: Operator, a: Bits<N>, b: Bits<N>) -> Bits<N> {
    match op {
        Operator::Add => a + b,
        Operator::Subtract => a - b,
        Operator::And => a & b,
        Operator::Or => a | b,
        Operator::Xor => a ^ b,
        _ => unreachable!("words have no && and ||"),
    }
}

macro_rules! widths {
    ($($v:ident $n:literal),+) => {
        /// The widths that values can have.
        pub const WIDTHS: &[usize] = &[$($n),+];

        /// An unsigned word.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub enum Word { $($v(Bits<$n>)),+ }

        /// A signed word.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub enum Int { $($v(Signed<$n>)),+ }

        impl Word {
            pub fn of(width: usize, code: u128) -> Self {
                match width { $($n => Self::$v(code.to_bits()),)+ _ => unreachable!() }
            }
            pub fn number(width: usize, number: u64) -> Self {
                match width { $($n => Self::$v(number.into()),)+ _ => unreachable!() }
            }
            pub fn literal(self) -> VerilogLiteral {
                match self { $(Self::$v(x) => x.into(),)+ }
            }
            pub fn index(self) -> usize {
                match self { $(Self::$v(x) => x.index(),)+ }
            }
            pub fn not(self) -> Self {
                match self { $(Self::$v(x) => Self::$v(!x),)+ }
            }
            pub fn plus_bit(self, bit: bool) -> Self {
                match self { $(Self::$v(x) => Self::$v(x + bit),)+ }
            }
            pub fn reduce(self, how: Reduction) -> bool {
                match self { $(Self::$v(x) => match how {
                    Reduction::All => x.all(),
                    Reduction::Any => x.any(),
                    Reduction::Parity => x.xor(),
                },)+ }
            }
            pub fn binary(op: Operator, a: Self, b: Self) -> Self {
                match (a, b) { $((Self::$v(x), Self::$v(y)) => Self::$v(joined(op, x, y)),)+ _ => unreachable!() }
            }
            pub fn compare(c: Comparison, a: Self, b: Self) -> bool {
                match (a, b) { $((Self::$v(x), Self::$v(y)) => compared(c, x, y),)+ _ => unreachable!() }
            }
            pub fn shift_by(self, left: bool, by: u64) -> Self {
                match self { $(Self::$v(x) => Self::$v(if left { x << by } else { x >> by }),)+ }
            }
            pub fn shift(self, left: bool, by: Self) -> Self {
                match self { $(Self::$v(x) => Self::$v(shift_word(x, left, by)),)+ }
            }
            pub fn bit(self, at: usize) -> bool {
                match self { $(Self::$v(x) => x.get_bit(at),)+ }
            }
            pub fn replace(self, at: usize, bit: bool) -> Self {
                match self { $(Self::$v(x) => Self::$v(x.replace_bit(at, bit)),)+ }
            }
            pub fn slice(self, width: usize, at: usize) -> Self {
                match self { $(Self::$v(x) => slice_word(x, width, at),)+ }
            }
            pub fn cast(self, width: usize) -> Self {
                match self { $(Self::$v(x) => cast_word(x, width),)+ }
            }
            pub fn signed(self) -> Int {
                match self { $(Self::$v(x) => Int::$v(signed_cast(x)),)+ }
            }
        }

        impl Int {
            pub fn of(width: usize, code: u128) -> Self {
                Word::of(width, code).signed()
            }
            pub fn number(width: usize, number: i64) -> Self {
                match width { $($n => Self::$v(number.into()),)+ _ => unreachable!() }
            }
            pub fn unsigned(self) -> Word {
                match self { $(Self::$v(x) => Word::$v(unsigned_cast(x)),)+ }
            }
            pub fn negate(self) -> Self {
                match self { $(Self::$v(x) => Self::$v(-x),)+ }
            }
            pub fn binary(op: Operator, a: Self, b: Self) -> Self {
                match (a, b) {
                    $((Self::$v(x), Self::$v(y)) => Self::$v(if op == Operator::Add { x + y } else { x - y }),)+
                    _ => unreachable!(),
                }
            }
            pub fn compare(c: Comparison, a: Self, b: Self) -> bool {
                match (a, b) { $((Self::$v(x), Self::$v(y)) => compared(c, x, y),)+ _ => unreachable!() }
            }
            pub fn bit(self, at: usize) -> bool {
                match self { $(Self::$v(x) => x.get_bit(at),)+ }
            }
            pub fn slice(self, width: usize, at: usize) -> Self {
                match self { $(Self::$v(x) => slice_int(x, width, at),)+ }
            }
            /// `None` for the least number, whose cast recurses for ever in rust-hdl.
            pub fn cast(self, width: usize) -> Option<Self> {
                match self { $(Self::$v(x) => cast_int(x, width),)+ }
            }
        }

        fn shift_word<const N: usize>(x: Bits<N>, left: bool, by: Word) -> Bits<N> {
            match by { $(Word::$v(y) => if left { x << y } else { x >> y },)+ }
        }
        fn slice_word<const N: usize>(x: Bits<N>, width: usize, at: usize) -> Word {
            match width { $($n => Word::$v(x.get_bits::<$n>(at)),)+ _ => unreachable!() }
        }
        fn cast_word<const N: usize>(x: Bits<N>, width: usize) -> Word {
            match width { $($n => Word::$v(bit_cast::<$n, N>(x)),)+ _ => unreachable!() }
        }
        fn slice_int<const N: usize>(x: Signed<N>, width: usize, at: usize) -> Int {
            match width { $($n => Int::$v(x.get_bits::<$n>(at)),)+ _ => unreachable!() }
        }
        fn cast_int<const N: usize>(x: Signed<N>, width: usize) -> Option<Int> {
            if x == -x && x.sign_bit() {
                return None;
            }
            Some(match width { $($n => Int::$v(signed_bit_cast::<$n, N>(x)),)+ _ => unreachable!() })
        }
    };
}

widths!(
    W1 1, W2 2, W3 3, W7 7, W8 8, W9 9, W15 15, W16 16, W17 17, W31 31, W32 32, W33 33, W47 47, W63 63, W64 64, W65 65,
    W96 96, W127 127, W128 128
);

/// A value of any format.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    Bit(bool),
    Word(Word),
    Int(Int),
}

impl Value {
    /// The value with this code.
    pub fn of(format: Format, code: u128) -> Self {
        match format {
            Format::Bit => Self::Bit(code == 1),
            Format::Word(n) => Self::Word(Word::of(n, code)),
            Format::Int(n) => Self::Int(Int::of(n, code)),
        }
    }

    /// As rust-hdl spells its code.
    pub fn literal(self) -> VerilogLiteral {
        match self {
            Self::Bit(b) => b.into(),
            Self::Word(w) => w.literal(),
            Self::Int(i) => i.unsigned().literal(),
        }
    }

    pub fn bit(self) -> bool {
        match self {
            Self::Bit(b) => b,
            _ => unreachable!("a bit"),
        }
    }

    pub fn word(self) -> Word {
        match self {
            Self::Word(w) => w,
            _ => unreachable!("a word"),
        }
    }

    pub fn int(self) -> Int {
        match self {
            Self::Int(i) => i,
            _ => unreachable!("a signed word"),
        }
    }

    pub fn compare(c: Comparison, a: Self, b: Self) -> bool {
        match (a, b) {
            (Self::Bit(x), Self::Bit(y)) => compared(c, x, y),
            (Self::Word(x), Self::Word(y)) => Word::compare(c, x, y),
            (Self::Int(x), Self::Int(y)) => Int::compare(c, x, y),
            _ => unreachable!("values of one format"),
        }
    }
}

/// rust-hdl's products: of two 16-bit words.
pub fn product(a: Value, b: Value) -> Value {
    match (a, b) {
        (Value::Word(Word::W16(x)), Value::Word(Word::W16(y))) => Value::Word(Word::W32(x * y)),
        (Value::Int(Int::W16(x)), Value::Int(Int::W16(y))) => Value::Int(Int::W32(x * y)),
        _ => unreachable!("16 bits"),
    }
}
