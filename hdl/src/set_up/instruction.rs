//! The instruction word of the set-up engine: one operation on 64-bit words, and what it starts or sends.
//!
//! | bits | field |
//! |---|---|
//! | 5:0, 11:6 | registers, raw slot or constant of x and y |
//! | 13:12, 14 | where x comes from; x is divided by 256 |
//! | 16:15, 18:17 | where y comes from; how far it is moved up |
//! | 20:19 | sum, difference, reversed difference, choice by a flag |
//! | 26:21, 27 | register of the result, written |
//! | 31:28, 32 | flag, written with the sign of the result |
//! | 33 | the result is cut to whole units of a register word |
//! | 34, 36:35, 43:37, 45:44 | multiplies: limbs of y less 1, places down, exponents added to them |
//! | 46, 48:47 | divides: kind |
//! | 49, 57:50, 59:58 | sends: select code, layout |
//! | 60, 61, 62 | last instruction; the triangle is skipped if the flag is set; units of depth |

/// Where x comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum XFrom {
    /// A register.
    #[default]
    Register,
    /// The multiplier.
    Product,
    /// The divider.
    Quotient,
    /// The divider, what is left.
    Remainder,
}

/// Where y comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum YFrom {
    /// A register.
    #[default]
    Register,
    /// A word of the triangle, as the host numbers its vertices.
    Raw,
    /// A word of the triangle, vertices numbered from the top down.
    Sorted,
    /// A constant.
    Constant,
}

/// Places by which y can be moved up.
pub const Y_SHIFTS: [u32; 4] = [0, 1, 8, 26];

/// What is done with x and y.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Function {
    /// x + y.
    #[default]
    Sum,
    /// x − y.
    Difference,
    /// y − x.
    Reversed,
    /// x if the flag is set, else y.
    Choice,
}

/// A constant that y can be.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Constant {
    /// 0.
    #[default]
    Zero,
    /// 1.
    One,
    /// 127: what rounds sub-pixels up to the next pixel centre.
    Below,
    /// 128: half a pixel.
    Half,
    /// 2048: the bit of the row word above two counts of rows.
    Mirror,
    /// 2^24: half of what the multiplier's narrow operand leaves out.
    Rest,
    /// Half a unit of a colour word.
    HalfUnit,
    /// Half a unit of a depth word.
    HalfUnitDepth,
    /// Half a level and half a unit of a colour word.
    Offset,
    /// Half a depth less its bias, and half a unit of a depth word.
    OffsetDepth,
    /// Columns of the frame.
    Width,
    /// Rows of the frame.
    Height,
}

/// What is added to the places by which a product is moved down.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Exponent {
    /// Nothing.
    #[default]
    None,
    /// The exponent of the last reciprocal.
    Once,
    /// Twice that.
    Twice,
}

/// What is divided by y.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Division {
    /// x + 4096·y: a quotient of 14 bits, and the remainder.
    #[default]
    Whole,
    /// 1: 43 fraction bits.
    Fraction,
    /// 1: 24 significant bits and an exponent.
    Reciprocal,
}

/// How a word is laid out on the register bus.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Layout {
    /// The result as a channel word.
    #[default]
    Word,
    /// x above 20 bits of y.
    Edge,
    /// x above 11 bits of y.
    Rows,
}

/// One instruction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Instruction {
    /// Register of x.
    pub x: u8,
    /// Register, slot or constant of y.
    pub y: u8,
    /// Where x comes from.
    pub x_from: XFrom,
    /// x is divided by 256, rounded down.
    pub x_down: bool,
    /// Where y comes from.
    pub y_from: YFrom,
    /// Index in [`Y_SHIFTS`].
    pub y_shift: u8,
    /// What is done.
    pub function: Function,
    /// Register of the result.
    pub to: Option<u8>,
    /// The flag to read or write.
    pub flag: u8,
    /// The flag is written.
    pub flag_write: bool,
    /// The result is cut to whole units.
    pub cut: bool,
    /// Multiplies x by y: limbs, places, exponent.
    pub multiply: Option<(u8, u8, Exponent)>,
    /// Divides.
    pub divide: Option<Division>,
    /// Sends to the core.
    pub send: Option<(u8, Layout)>,
    /// The last one.
    pub end: bool,
    /// Skips the triangle if the flag is set.
    pub skip: bool,
    /// Units of depth words.
    pub depth: bool,
}

impl Instruction {
    /// The word in the program memory.
    #[must_use]
    pub fn encode(&self) -> u64 {
        let (limbs, places, exponent) = self.multiply.unwrap_or((1, 0, Exponent::None));
        let (select, layout) = self.send.unwrap_or_default();
        [
            (u64::from(self.x), 0),
            (u64::from(self.y), 6),
            (self.x_from as u64, 12),
            (u64::from(self.x_down), 14),
            (self.y_from as u64, 15),
            (u64::from(self.y_shift), 17),
            (self.function as u64, 19),
            (u64::from(self.to.unwrap_or(0)), 21),
            (u64::from(self.to.is_some()), 27),
            (u64::from(self.flag), 28),
            (u64::from(self.flag_write), 32),
            (u64::from(self.cut), 33),
            (u64::from(self.multiply.is_some()), 34),
            (u64::from(limbs - 1), 35),
            (u64::from(places), 37),
            (exponent as u64, 44),
            (u64::from(self.divide.is_some()), 46),
            (self.divide.unwrap_or_default() as u64, 47),
            (u64::from(self.send.is_some()), 49),
            (u64::from(select), 50),
            (layout as u64, 58),
            (u64::from(self.end), 60),
            (u64::from(self.skip), 61),
            (u64::from(self.depth), 62),
        ]
        .iter()
        .fold(0, |word, (field, at)| word | field << at)
    }
}
