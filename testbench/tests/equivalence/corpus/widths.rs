//! Every operator of words, at widths around the limits of machine words and of the simulators' own words.

use crate::harness::case::Case;
use crate::harness::code::drive;
use rust_hdl_core::prelude::*;
use shadegate_hdl::format::{Q, U};

/// Every operator of unsigned words.
#[derive(LogicBlock, Default)]
struct UnsignedWords<const N: usize> {
    a: Signal<In, Bits<N>>,
    b: Signal<In, Bits<N>>,
    carry: Signal<In, Bit>,
    amount: Signal<In, Bits<8>>,
    sum: Signal<Out, Bits<N>>,
    difference: Signal<Out, Bits<N>>,
    with_carry: Signal<Out, Bits<N>>,
    bits_and: Signal<Out, Bits<N>>,
    bits_or: Signal<Out, Bits<N>>,
    bits_xor: Signal<Out, Bits<N>>,
    bits_not: Signal<Out, Bits<N>>,
    left: Signal<Out, Bits<N>>,
    right: Signal<Out, Bits<N>>,
    next: Signal<Out, Bits<N>>,
    mirrored: Signal<Out, Bits<N>>,
    equal: Signal<Out, Bit>,
    different: Signal<Out, Bit>,
    less: Signal<Out, Bit>,
    at_most: Signal<Out, Bit>,
    more: Signal<Out, Bit>,
    at_least: Signal<Out, Bit>,
    all: Signal<Out, Bit>,
    any: Signal<Out, Bit>,
    parity: Signal<Out, Bit>,
    is_one: Signal<Out, Bit>,
}

impl<const N: usize> Logic for UnsignedWords<N> {
    #[hdl_gen]
    fn update(&mut self) {
        self.sum.next = self.a.val() + self.b.val();
        self.difference.next = self.a.val() - self.b.val();
        self.with_carry.next = self.a.val() + self.carry.val();
        self.bits_and.next = self.a.val() & self.b.val();
        self.bits_or.next = self.a.val() | self.b.val();
        self.bits_xor.next = self.a.val() ^ self.b.val();
        self.bits_not.next = !self.a.val();
        self.left.next = self.a.val() << self.amount.val();
        self.right.next = self.a.val() >> self.amount.val();
        self.next.next = self.a.val() + 1;
        self.mirrored.next = 1 - self.a.val();
        self.equal.next = self.a.val() == self.b.val();
        self.different.next = self.a.val() != self.b.val();
        self.less.next = self.a.val() < self.b.val();
        self.at_most.next = self.a.val() <= self.b.val();
        self.more.next = self.a.val() > self.b.val();
        self.at_least.next = self.a.val() >= self.b.val();
        self.all.next = self.a.val().all();
        self.any.next = self.a.val().any();
        self.parity.next = self.a.val().xor();
        self.is_one.next = self.a.val() == 1;
    }
}

/// Every operator of signed words.
#[derive(LogicBlock, Default)]
struct SignedWords<const N: usize> {
    a: Signal<In, Signed<N>>,
    b: Signal<In, Signed<N>>,
    word: Signal<In, Bits<N>>,
    sum: Signal<Out, Signed<N>>,
    difference: Signal<Out, Signed<N>>,
    negative: Signal<Out, Signed<N>>,
    cast: Signal<Out, Signed<N>>,
    back: Signal<Out, Bits<N>>,
    mixed: Signal<Out, Bits<N>>,
    equal: Signal<Out, Bit>,
    different: Signal<Out, Bit>,
    less: Signal<Out, Bit>,
    at_most: Signal<Out, Bit>,
    more: Signal<Out, Bit>,
    at_least: Signal<Out, Bit>,
    below_cast: Signal<Out, Bit>,
    top: Signal<Out, Bit>,
}

impl<const N: usize> Logic for SignedWords<N> {
    #[hdl_gen]
    fn update(&mut self) {
        self.sum.next = self.a.val() + self.b.val();
        self.difference.next = self.a.val() - self.b.val();
        self.negative.next = -self.a.val();
        self.cast.next = signed_cast(self.word.val());
        self.back.next = unsigned_cast(self.a.val());
        self.mixed.next = unsigned_cast(self.a.val() - self.b.val()) ^ self.word.val();
        self.equal.next = self.a.val() == self.b.val();
        self.different.next = self.a.val() != self.b.val();
        self.less.next = self.a.val() < self.b.val();
        self.at_most.next = self.a.val() <= self.b.val();
        self.more.next = self.a.val() > self.b.val();
        self.at_least.next = self.a.val() >= self.b.val();
        self.below_cast.next = self.a.val() < signed_cast(self.word.val() + 1);
        self.top.next = (self.a.val() + self.b.val()).get_bit(0) ^ self.a.val().get_bit(0);
    }
}

/// Every operator of the project's unsigned words.
#[derive(LogicBlock, Default)]
struct MachineWords<const N: usize> {
    a: Signal<In, U<N>>,
    b: Signal<In, U<N>>,
    sum: Signal<Out, U<N>>,
    difference: Signal<Out, U<N>>,
    bitwise: Signal<Out, U<N>>,
    next: Signal<Out, U<N>>,
    equal: Signal<Out, Bit>,
    less: Signal<Out, Bit>,
    at_least: Signal<Out, Bit>,
    any: Signal<Out, Bit>,
    bottom: Signal<Out, Bit>,
}

impl<const N: usize> Logic for MachineWords<N> {
    #[hdl_gen]
    fn update(&mut self) {
        self.sum.next = self.a.val() + self.b.val();
        self.difference.next = self.a.val() - self.b.val();
        self.bitwise.next = (self.a.val() & !self.b.val()) | (self.a.val() ^ self.b.val());
        self.next.next = self.a.val() + 1.into();
        self.equal.next = self.a.val() == self.b.val();
        self.less.next = self.a.val() < self.b.val();
        self.at_least.next = self.a.val() >= self.b.val();
        self.any.next = self.a.val().any();
        self.bottom.next = self.a.val().get_bit(0);
    }
}

/// Every operator of the project's fixed-point words.
#[derive(LogicBlock, Default)]
struct FixedWords<const M: usize, const N: usize> {
    a: Signal<In, Q<M, N>>,
    b: Signal<In, Q<M, N>>,
    sum: Signal<Out, Q<M, N>>,
    difference: Signal<Out, Q<M, N>>,
    bits_not: Signal<Out, Q<M, N>>,
    equal: Signal<Out, Bit>,
    less: Signal<Out, Bit>,
    at_most: Signal<Out, Bit>,
    sum_above: Signal<Out, Bit>,
}

impl<const M: usize, const N: usize> Logic for FixedWords<M, N> {
    #[hdl_gen]
    fn update(&mut self) {
        self.sum.next = self.a.val() + self.b.val();
        self.difference.next = self.a.val() - self.b.val();
        self.bits_not.next = !(self.a.val() - self.b.val());
        self.equal.next = self.a.val() == self.b.val();
        self.less.next = self.a.val() < self.b.val();
        self.at_most.next = self.a.val() <= self.b.val();
        self.sum_above.next = self.a.val() + self.b.val() > self.a.val();
    }
}

macro_rules! at_widths {
    ($cases:ident, $type:ident, $stem:literal, $($w:literal)+) => {
        $($cases.push(Case::named(&format!("{}_{}", $stem, $w), $type::<$w>::default()));)+
    };
}

macro_rules! drive_widths {
    ($type:ident, $ports:tt, $($w:literal)+) => { $(drive_widths!(@ $type, $w, $ports);)+ };
    (@ $type:ident, $w:literal, ($($port:ident),+)) => { drive!($type<$w>; $($port),+); };
}

drive_widths!(UnsignedWords, (a, b, carry, amount), 1 2 3 7 8 9 15 16 17 31 32 33 47 63 64 65 96 127 128);
drive_widths!(SignedWords, (a, b, word), 1 2 3 7 8 9 15 16 17 31 32 33 47 63 64 65 96 127 128);
drive_widths!(MachineWords, (a, b), 1 2 7 8 17 31 32 33 63);
drive!(FixedWords<0, 7>; a, b);
drive!(FixedWords<3, 0>; a, b);
drive!(FixedWords<11, 20>; a, b);
drive!(FixedWords<20, 42>; a, b);

pub fn cases() -> Vec<Case> {
    let mut cases = vec![
        Case::named("fixed_0_7", FixedWords::<0, 7>::default()),
        Case::named("fixed_3_0", FixedWords::<3, 0>::default()),
        Case::named("fixed_11_20", FixedWords::<11, 20>::default()),
        Case::named("fixed_20_42", FixedWords::<20, 42>::default()),
    ];
    at_widths!(cases, UnsignedWords, "unsigned", 1 2 3 7 8 9 15 16 17 31 32 33 47 63 64 65 96 127 128);
    at_widths!(cases, SignedWords, "signed", 1 2 3 7 8 9 15 16 17 31 32 33 47 63 64 65 96 127 128);
    at_widths!(cases, MachineWords, "machine", 1 2 7 8 17 31 32 33 63);
    cases
}
