//! The known expressions whose meaning rust-hdl's own printer loses, each a description with one output.

use crate::harness::case::Case;
use crate::harness::code::{circuit, drive};
use rust_hdl_core::prelude::*;

/// A trap.
pub struct Trap {
    /// The right side of the assignment, without `self.` and `.val()`.
    pub rust: &'static str,
    /// Why rust-hdl's Verilog means something else.
    pub why: &'static str,
    /// The description.
    pub case: Case,
}

impl Trap {
    fn new(rust: &'static str, why: &'static str, case: Case) -> Self {
        Self { rust, why, case }
    }
}

circuit! {
    Carry { in a: Bits<8>, b: Bits<8>; out o: Bits<32>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = bit_cast::<32, 8>(self.a.val() + self.b.val());
    }
}

circuit! {
    Difference { in a: Bits<8>, b: Bits<8>; out o: Bit; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = (self.a.val() - self.b.val()) > 5;
    }
}

circuit! {
    Increment { in a: Bits<8>; out o: Bit; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = (self.a.val() + 1) == 0;
    }
}

circuit! {
    Complement { in a: Bits<8>; out o: Bit; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = !self.a.val() == 0xf0;
    }
}

circuit! {
    Precedence { in a: Bits<8>, b: Bits<8>; out o: Bit; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val() & self.b.val() == self.a.val();
    }
}

circuit! {
    WideComplement { in a: Bits<8>; out o: Bits<32>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = bit_cast::<32, 8>(!self.a.val());
    }
}

circuit! {
    ShiftedOut { in a: Bits<8>; out o: Bits<8>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = ((self.a.val() << 4) >> 4) | 1;
    }
}

circuit! {
    BelowZero { in s: Signed<8>; out o: Bit; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.s.val() < 0.into();
    }
}

circuit! {
    SignedPlusOne { in s: Signed<8>; out o: Signed<32>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = signed_bit_cast::<32, 8>(self.s.val()) + 1.into();
    }
}

circuit! {
    SignedSumCast { in s: Signed<8>; out o: Signed<32>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = signed_bit_cast::<32, 8>(self.s.val() + 1.into());
    }
}

circuit! {
    SliceCompare { in s: Signed<8>, t: Signed<8>; out o: Bit; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.s.val().get_bits::<4>(4) < self.t.val().get_bits::<4>(4);
    }
}

circuit! {
    SignedProduct { in p: Signed<16>, r: Signed<16>; out o: Signed<48>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = signed_bit_cast::<48, 32>(self.p.val() * self.r.val());
    }
}

circuit! {
    CutProduct { in p: Bits<16>, r: Bits<16>; out o: Bits<8>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = bit_cast::<8, 32>((self.p.val() * self.r.val()) >> 16);
    }
}

circuit! {
    NarrowShift { in p: Bits<16>; out o: Bits<16>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = bit_cast::<16, 8>(bit_cast::<8, 16>(self.p.val()) << 1);
    }
}

circuit! {
    SlicedSum { in a: Bits<8>, b: Bits<8>; out o: Bits<4>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = (self.a.val() + self.b.val()).get_bits::<4>(2);
    }
}

circuit! {
    Constant { in a: Bit; out o: Bits<8>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = 5.into();
    }
}

circuit! {
    MinusFive { in a: Bit; out o: Signed<8>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = (-5).into();
    }
}

/// A Rust constant, which is no signal.
const LIMIT: u64 = 5;

circuit! {
    RustConstant { in a: Bits<8>; out o: Bits<8>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val() & LIMIT;
    }
}

/// The same as a generic.
#[derive(LogicBlock, Default)]
struct Generic<const N: u64> {
    a: Signal<In, Bits<8>>,
    o: Signal<Out, Bits<8>>,
}

impl<const N: u64> Logic for Generic<N> {
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val() + N;
    }
}

drive!(Generic<7>; a);

/// What is not Verilog at all, and what this project says of it.
pub fn invalid() -> Vec<Trap> {
    vec![
        Trap::new(
            "a & LIMIT",
            "the name of a Rust constant",
            Case::of::<RustConstant>(),
        ),
        Trap::new(
            "a + N",
            "the name of a generic",
            Case::named("generic", Generic::<7>::default()),
        ),
    ]
}

/// A choice of two.
#[derive(Clone, Copy, Debug, PartialEq, LogicState)]
pub enum Side {
    Left,
    Right,
}

circuit! {
    Guard { in a: Bit, f: Bit; out o: Bits<2>; wire side: Side; }
    #[hdl_gen]
    fn update(&mut self) {
        self.side.next = Side::Left;
        if self.a.val() {
            self.side.next = Side::Right;
        }
        match self.side.val() {
            Side::Left if self.f.val() => self.o.next = 1.into(),
            Side::Left => self.o.next = 2.into(),
            Side::Right => self.o.next = 3.into(),
        }
    }
}

/// A guard, of which rust-hdl's tree keeps no trace: no back end can see it.
pub fn guard() -> Trap {
    Trap::new(
        "match side { Side::Left if f => 1, Side::Left => 2, .. }",
        "the guard is dropped",
        Case::of::<Guard>(),
    )
}

/// All of them, in the order of the document.
pub fn traps() -> Vec<Trap> {
    vec![
        Trap::new(
            "bit_cast::<32, 8>(a + b)",
            "the carry is kept; Rust wraps at 8 bits",
            Case::of::<Carry>(),
        ),
        Trap::new(
            "(a - b) > 5",
            "the literal's 32 bits widen the difference",
            Case::of::<Difference>(),
        ),
        Trap::new(
            "(a + 1) == 0",
            "the literal's 32 bits keep the carry",
            Case::of::<Increment>(),
        ),
        Trap::new(
            "!a == 0xf0",
            "the literal's 32 bits widen the complement",
            Case::of::<Complement>(),
        ),
        Trap::new(
            "a & b == a",
            "Verilog compares first",
            Case::of::<Precedence>(),
        ),
        Trap::new(
            "bit_cast::<32, 8>(!a)",
            "inverted after it was extended",
            Case::of::<WideComplement>(),
        ),
        Trap::new(
            "((a << 4) >> 4) | 1",
            "bits survive in the wider context",
            Case::of::<ShiftedOut>(),
        ),
        Trap::new(
            "s < 0.into()",
            "an unsigned literal makes the comparison unsigned",
            Case::of::<BelowZero>(),
        ),
        Trap::new(
            "signed_bit_cast::<32, 8>(s) + 1.into()",
            "an unsigned literal makes the sum unsigned: no sign is extended",
            Case::of::<SignedPlusOne>().keep(|v| v["s"] != 0x80),
        ),
        Trap::new(
            "signed_bit_cast::<32, 8>(s + 1.into())",
            "the literal makes the cast's argument 32 bits, without a sign",
            Case::of::<SignedSumCast>().keep(|v| v["s"] != 0x7f),
        ),
        Trap::new(
            "s.get_bits::<4>(4) < t.get_bits::<4>(4)",
            "part-selects are unsigned",
            Case::of::<SliceCompare>(),
        ),
        Trap::new(
            "signed_bit_cast::<48, 32>(p * r)",
            "the argument of `$signed` is 16 bits wide",
            Case::of::<SignedProduct>().keep(|v| !(v["p"] == 0x8000 && v["r"] == 0x8000)),
        ),
        Trap::new(
            "bit_cast::<8, 32>((p * r) >> 16)",
            "the product has 16 bits only",
            Case::of::<CutProduct>(),
        ),
        Trap::new(
            "bit_cast::<16, 8>(bit_cast::<8, 16>(p) << 1)",
            "a mask does not narrow the context",
            Case::of::<NarrowShift>(),
        ),
        Trap::new(
            "(a + b).get_bits::<4>(2)",
            "expressions cannot be sliced in Verilog",
            Case::of::<SlicedSum>(),
        ),
        Trap::new(
            "5.into()",
            "`always @(*)` with nothing to wait for never runs",
            Case::of::<Constant>(),
        ),
        Trap::new(
            "(-5).into()",
            "`always @(*)` with nothing to wait for never runs",
            Case::of::<MinusFive>(),
        ),
    ]
}
