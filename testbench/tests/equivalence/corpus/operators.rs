//! Expressions that Verilog's context rules would widen, narrow, group or sign in another way than Rust does.

use crate::harness::case::Case;
use crate::harness::code::{circuit, drive};
use rust_hdl_core::prelude::*;

circuit! {
    /// The carry of a sum is lost before the sum is widened.
    CarryIsLost { in a: Bits<8>, b: Bits<8>; out o: Bits<32>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = bit_cast::<32, 8>(self.a.val() + self.b.val());
    }
}

circuit! {
    /// A difference wraps before it is compared with a number.
    DifferenceCompared { in a: Bits<8>, b: Bits<8>; out above: Bit, below: Bit; }
    #[hdl_gen]
    fn update(&mut self) {
        self.above.next = (self.a.val() - self.b.val()) > 5;
        self.below.next = 250 > (self.a.val() - self.b.val());
    }
}

circuit! {
    /// All ones plus one is zero.
    IncrementWraps { in a: Bits<8>; out zero: Bit, other: Bit; }
    #[hdl_gen]
    fn update(&mut self) {
        self.zero.next = (self.a.val() + 1) == 0;
        self.other.next = 0 != (1 + self.a.val());
    }
}

circuit! {
    /// A complement has the width of its operand.
    ComplementCompared { in a: Bits<8>; out same: Bit, wide: Bits<32>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.same.next = !self.a.val() == 0xf0;
        self.wide.next = bit_cast::<32, 8>(!self.a.val());
    }
}

circuit! {
    /// In Rust `&`, `|` and `^` bind before comparisons.
    BitwiseBindsFirst { in a: Bits<8>, b: Bits<8>; out bits_and: Bit, bits_or: Bit, bits_xor: Bit; }
    #[hdl_gen]
    fn update(&mut self) {
        self.bits_and.next = self.a.val() & self.b.val() == self.a.val();
        self.bits_or.next = self.a.val() | self.b.val() != self.b.val();
        self.bits_xor.next = self.a.val() ^ self.b.val() < self.a.val();
    }
}

circuit! {
    /// Arithmetic before shifts before bitwise operators, without a parenthesis.
    RustPrecedence { in a: Bits<8>, b: Bits<8>, c: Bits<8>; out o: Bits<8>, p: Bits<8>, q: Bits<8>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val() | self.b.val() ^ self.c.val() & self.a.val() + self.b.val();
        self.p.next = self.a.val() - self.b.val() - self.c.val();
        self.q.next = self.a.val() + self.b.val() << 2 & !self.c.val() - 1;
    }
}

circuit! {
    /// Bits that leave to the left do not come back.
    ShiftedOutBitsAreLost { in a: Bits<8>; out o: Bits<8>, p: Bits<16>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = ((self.a.val() << 4) >> 4) | 1;
        self.p.next = bit_cast::<16, 8>(self.a.val() << 3) >> 3;
    }
}

circuit! {
    /// Signed words against numbers, on both sides.
    SignedAgainstNumbers { in a: Signed<8>; out negative: Bit, big: Bit, minus: Bit, sum: Signed<8>, less: Signed<8>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.negative.next = self.a.val() < 0.into();
        self.big.next = self.a.val() >= 100.into();
        self.minus.next = self.a.val() > (-5).into();
        self.sum.next = self.a.val() + 1.into();
        self.less.next = self.a.val() - (-7).into();
    }
}

circuit! {
    /// Slices of signed words are signed.
    SignedSlicesCompared { in a: Signed<8>, b: Signed<8>; out high: Bit, low: Bit; }
    #[hdl_gen]
    fn update(&mut self) {
        self.high.next = self.a.val().get_bits::<4>(4) < self.b.val().get_bits::<4>(4);
        self.low.next = self.a.val().get_bits::<4>(0) >= self.b.val().get_bits::<4>(0);
    }
}

circuit! {
    /// A signed product is whole before it is widened or summed.
    SignedProductIsWhole { in a: Signed<16>, b: Signed<16>, c: Signed<32>; out o: Signed<32>, p: Signed<48>, q: Signed<32>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = signed_bit_cast::<32, 32>(self.a.val() * self.b.val()) + self.c.val();
        self.p.next = signed_bit_cast::<48, 32>((self.a.val() + self.b.val()) * self.b.val());
        self.q.next = self.a.val() * self.b.val() - self.c.val();
    }
}

circuit! {
    /// An unsigned product is whole before it is shifted or sliced.
    ProductShiftedAndCut { in a: Bits<16>, b: Bits<16>; out o: Bits<8>, p: Bits<32>, q: Bits<12>, r: Bit, s: Bits<32>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = bit_cast::<8, 32>((self.a.val() * self.b.val()) >> 16);
        self.p.next = self.a.val() * self.b.val();
        self.q.next = (self.a.val() * self.b.val()).get_bits::<12>(11);
        self.r.next = (self.a.val() * self.b.val()).get_bit(31);
        self.s.next = (self.a.val() + 1) * (self.b.val() - 1);
    }
}

circuit! {
    /// A narrowed word is narrow for whatever comes after.
    NarrowedThenShifted { in a: Bits<16>, b: Bits<8>; out o: Bit, p: Bits<16>, parity: Bit; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = bit_cast::<8, 16>(self.a.val()) << 1 == self.b.val();
        self.p.next = bit_cast::<16, 8>(bit_cast::<8, 16>(self.a.val()) + self.b.val());
        self.parity.next = self.a.val().xor();
    }
}

circuit! {
    /// Slices and bits of expressions.
    SlicesOfExpressions { in a: Bits<8>, b: Bits<8>, w: Bits<48>; out o: Bits<4>, p: Bits<32>, q: Bit, r: Bits<3>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = (self.a.val() + self.b.val()).get_bits::<4>(2);
        self.p.next = (self.w.val() + 0xdead_beef_cafe_u64).get_bits::<32>(16);
        self.q.next = (self.a.val() - self.b.val()).get_bit(7);
        self.r.next = (!self.a.val() ^ self.b.val()).get_bits::<5>(3).get_bits::<3>(1);
    }
}

circuit! {
    /// Negation of a word, of a sum and of numbers.
    Negations { in a: Signed<8>, b: Signed<8>; out o: Signed<8>, p: Signed<8>, wide: Signed<32>, five: Signed<32>, least: Signed<8>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = -self.a.val();
        self.p.next = -(self.a.val() - self.b.val());
        self.wide.next = signed_bit_cast::<32, 8>(-self.a.val());
        self.five.next = (-5).into();
        self.least.next = (-128).into();
    }
}

circuit! {
    /// Sign extension of a word, a slice and a sum.
    SignExtension { in a: Signed<8>, b: Signed<16>; out o: Signed<32>, slice: Signed<32>, sum: Signed<32>, both: Signed<32>, more: Signed<32>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = signed_bit_cast::<32, 8>(self.a.val());
        self.slice.next = signed_bit_cast::<32, 12>(self.b.val().get_bits::<12>(4));
        self.sum.next = signed_bit_cast::<32, 16>(self.b.val() + self.b.val());
        self.both.next = signed_bit_cast::<32, 8>(self.a.val()) + signed_bit_cast::<32, 16>(self.b.val());
        self.more.next = signed_bit_cast::<32, 8>(self.a.val()) + 1.into();
    }
}

circuit! {
    /// Outputs that depend on nothing; the input only keeps the module from having none.
    AllConstant { in a: Bit; out five: Bits<8>, yes: Bit, minus: Signed<5>, wide: Bits<96>, echo: Bit; }
    #[hdl_gen]
    fn update(&mut self) {
        self.five.next = 5.into();
        self.yes.next = true;
        self.minus.next = (-3).into();
        self.wide.next = 0xfeed_u64.into();
        self.echo.next = self.a.val();
    }
}

circuit! {
    /// Every operator on bits.
    BoolOperators { in a: Bit, b: Bit, c: Bit; out bits_and: Bit, bits_or: Bit, bits_xor: Bit, bits_not: Bit, both: Bit, some: Bit, same: Bit, differ: Bit, less: Bit, mixed: Bit; }
    #[hdl_gen]
    fn update(&mut self) {
        self.bits_and.next = self.a.val() & self.b.val();
        self.bits_or.next = self.a.val() | self.b.val();
        self.bits_xor.next = self.a.val() ^ self.b.val();
        self.bits_not.next = !self.a.val();
        self.both.next = self.a.val() && !self.b.val();
        self.some.next = self.a.val() || self.b.val() && self.c.val();
        self.same.next = self.a.val() == self.b.val();
        self.differ.next = self.a.val() != (self.b.val() & self.c.val());
        self.less.next = self.a.val() < self.b.val();
        self.mixed.next = (self.a.val() ^ true) & (self.b.val() == false);
    }
}

circuit! {
    /// A bit is added to a word.
    WordPlusBit { in a: Bits<8>, b: Bits<8>, c: Bit, w: Bits<65>; out o: Bits<8>, p: Bits<8>, q: Bits<65>, one: Bits<1>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val() + self.b.val() + self.c.val();
        self.p.next = self.a.val() + (self.a.val() > self.b.val());
        self.q.next = self.w.val() + self.c.val();
        self.one.next = self.a.val().get_bits::<1>(0) + self.c.val();
    }
}

circuit! {
    /// One-bit words and bits are the same bits under two types.
    OneBitWords { in a: Bits<1>, b: Bit, c: Bits<1>; out o: Bits<1>, p: Bit, q: Bit, r: Bits<1>, s: Bits<1>, t: Bits<9>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.b.val().into();
        self.p.next = self.a.val().into();
        self.q.next = self.a.val() == self.b.val();
        self.r.next = !self.a.val() ^ self.c.val();
        self.s.next = self.a.val() + self.c.val();
        self.t.next = bit_cast::<9, 1>(self.a.val()) - bit_cast::<9, 1>(self.c.val());
    }
}

/// The least code of a signed word.
fn least(width: usize) -> u128 {
    1 << (width - 1)
}

pub fn cases() -> Vec<Case> {
    vec![
        Case::of::<CarryIsLost>(),
        Case::of::<DifferenceCompared>(),
        Case::of::<IncrementWraps>(),
        Case::of::<ComplementCompared>(),
        Case::of::<BitwiseBindsFirst>(),
        Case::of::<RustPrecedence>(),
        Case::of::<ShiftedOutBitsAreLost>(),
        Case::of::<SignedAgainstNumbers>(),
        Case::of::<SignedSlicesCompared>(),
        // `signed_bit_cast` of the least number recurses for ever in rust-hdl.
        Case::of::<SignedProductIsWhole>().keep(|v| {
            let (a, b) = (v["a"] as u16 as i16, v["b"] as u16 as i16);
            let sum = i32::from(a.wrapping_add(b));
            i32::from(a) * i32::from(b) != i32::MIN && sum * i32::from(b) != i32::MIN
        }),
        Case::of::<ProductShiftedAndCut>(),
        Case::of::<NarrowedThenShifted>(),
        Case::of::<SlicesOfExpressions>(),
        Case::of::<Negations>().keep(|v| v["a"] != least(8)),
        Case::of::<SignExtension>().keep(|v| {
            v["a"] != least(8)
                && v["b"] != least(16)
                && v["b"] >> 4 != least(12)
                && v["b"] * 2 & 0xffff != least(16)
        }),
        Case::of::<AllConstant>(),
        Case::of::<BoolOperators>(),
        Case::of::<WordPlusBit>(),
        Case::of::<OneBitWords>(),
    ]
}
