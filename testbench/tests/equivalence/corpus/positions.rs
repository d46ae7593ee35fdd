//! Bits and slices by constant and run-time position, up to and beyond the top where Rust allows it.

use crate::harness::case::Case;
use crate::harness::code::{circuit, drive};
use rust_hdl_core::prelude::*;
use shadegate_hdl::format::{Q, U};

circuit! {
    /// Constant positions of an unsigned word; slices may reach beyond the top and find zeros there.
    ConstantPositions { in a: Bits<8>; out low: Bit, high: Bit, middle: Bits<3>, top: Bits<4>, beyond: Bits<6>, none: Bits<4>, wider: Bits<12>, whole: Bits<8>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.low.next = self.a.val().get_bit(0);
        self.high.next = self.a.val().get_bit(7);
        self.middle.next = self.a.val().get_bits::<3>(2);
        self.top.next = self.a.val().get_bits::<4>(4);
        self.beyond.next = self.a.val().get_bits::<6>(5);
        self.none.next = self.a.val().get_bits::<4>(8);
        self.wider.next = self.a.val().get_bits::<12>(3);
        self.whole.next = self.a.val().get_bits::<8>(0);
    }
}

circuit! {
    /// The same of a signed word: the slice is signed, but zeros come in from beyond the top.
    SignedPositions { in a: Signed<8>; out high: Bit, top: Signed<4>, beyond: Signed<6>, none: Signed<4>, wider: Signed<12>, whole: Signed<8>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.high.next = self.a.val().get_bit(7);
        self.top.next = self.a.val().get_bits::<4>(4);
        self.beyond.next = self.a.val().get_bits::<6>(5);
        self.none.next = self.a.val().get_bits::<4>(8);
        self.whole.next = self.a.val().get_bits::<8>(0);
        self.wider.next = self.a.val().get_bits::<12>(3);
    }
}

circuit! {
    /// Run-time positions that cannot leave the word.
    RunTimeBit { in a: Bits<8>, at: Bits<3>, s: Signed<16>, deep: Bits<4>, w: Bits<65>, far: Bits<6>; out o: Bit, p: Bit, q: Bit, r: Bit; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val().get_bit(self.at.val().index());
        self.p.next = self.s.val().get_bit(self.deep.val().index());
        self.q.next = self.w.val().get_bit(self.far.val().index());
        self.r.next = (self.a.val() + 1).get_bit(self.at.val().index());
    }
}

circuit! {
    /// Run-time slices; a slice may reach beyond the top, its position may be the width.
    RunTimeSlice { in a: Bits<9>, at: Bits<4>, s: Signed<9>, w: Bits<96>, far: Bits<7>; out o: Bits<4>, p: Signed<4>, q: Bits<32>, r: Bits<12>, t: Signed<12>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val().get_bits::<4>(self.at.val().index());
        self.p.next = self.s.val().get_bits::<4>(self.at.val().index());
        self.q.next = self.w.val().get_bits::<32>(self.far.val().index());
        self.r.next = self.a.val().get_bits::<12>(self.at.val().index());
        self.t.next = self.s.val().get_bits::<12>(self.at.val().index());
    }
}

circuit! {
    /// A position that could leave the word but does not.
    RunTimeBitOfOddWidth { in a: Bits<5>, at: Bits<3>; out o: Bit, p: Bits<5>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val().get_bit(self.at.val().index());
        self.p.next = self.a.val().replace_bit(self.at.val().index(), true);
    }
}

circuit! {
    /// A bit is replaced at a constant and at a run-time position.
    ReplacedBits { in a: Bits<8>, b: Bit, at: Bits<3>, w: Bits<64>, far: Bits<6>; out o: Bits<8>, p: Bits<8>, q: Bits<8>, r: Bits<64>, s: Bits<8>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val().replace_bit(3, self.b.val());
        self.p.next = self.a.val().replace_bit(0, false).replace_bit(7, self.a.val().get_bit(0));
        self.q.next = self.a.val().replace_bit(self.at.val().index(), self.b.val());
        self.r.next = self.w.val().replace_bit(self.far.val().index(), self.b.val());
        self.s.next = (self.a.val() + 3).replace_bit(self.at.val().index(), !self.b.val());
    }
}

circuit! {
    /// The project's unsigned words give zeros beyond their top.
    MachineWordPositions { in a: U<13>, at: Bits<4>; out high: Bit, middle: U<5>, beyond: U<9>, none: U<3>, chosen: Bit, slice: U<6>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.high.next = self.a.val().get_bit(12);
        self.middle.next = self.a.val().get_bits::<5>(4);
        self.beyond.next = self.a.val().get_bits::<9>(9);
        self.none.next = self.a.val().get_bits::<3>(13);
        self.chosen.next = self.a.val().get_bit(self.at.val().index());
        self.slice.next = self.a.val().get_bits::<6>(self.at.val().index());
    }
}

circuit! {
    /// The project's fixed-point words repeat their sign beyond their top.
    FixedWordPositions { in a: Q<3, 5>, at: Bits<3>; out sign: Bit, middle: U<4>, beyond: U<9>, none: U<3>, wider: U<16>, chosen: Bit; }
    #[hdl_gen]
    fn update(&mut self) {
        self.sign.next = self.a.val().get_bit(8);
        self.middle.next = self.a.val().get_bits::<4>(2);
        self.beyond.next = self.a.val().get_bits::<9>(4);
        self.none.next = self.a.val().get_bits::<3>(9);
        self.wider.next = self.a.val().get_bits::<16>(0);
        self.chosen.next = self.a.val().get_bit(self.at.val().index());
    }
}

circuit! {
    /// Shifts by constants, from none to all of the width and beyond.
    ConstantShifts { in a: Bits<9>, w: Bits<65>; out none: Bits<9>, one: Bits<9>, eight: Bits<9>, gone: Bits<9>, far: Bits<9>, wide: Bits<65>, right: Bits<65>, over: Bits<65>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.none.next = self.a.val() << 0;
        self.one.next = self.a.val() >> 1;
        self.eight.next = self.a.val() << 8;
        self.gone.next = self.a.val() << 9;
        self.far.next = self.a.val() >> 100;
        self.wide.next = self.w.val() << 33;
        self.right.next = self.w.val() >> 64;
        self.over.next = self.w.val() << 65;
    }
}

circuit! {
    /// Shifts by signals of several widths and by expressions; a shifted number has 64 bits.
    RunTimeShifts { in a: Bits<8>, n: Bits<3>, m: Bits<12>, w: Bits<40>; out left: Bits<8>, right: Bits<8>, far: Bits<8>, wide: Bits<40>, sum: Bits<40>, mask: Bits<64>, low: Bits<8>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.left.next = self.a.val() << self.n.val();
        self.right.next = self.a.val() >> self.n.val();
        self.far.next = (self.a.val() + 1) >> self.m.val();
        self.wide.next = self.w.val() << self.m.val();
        self.sum.next = self.w.val() >> (self.n.val() + 1);
        self.mask.next = (1 << self.m.val()) - 1;
        self.low.next = bit_cast::<8, 64>(5 << self.n.val());
    }
}

pub fn cases() -> Vec<Case> {
    vec![
        Case::of::<ConstantPositions>(),
        Case::of::<SignedPositions>(),
        Case::of::<RunTimeBit>(),
        // rust-hdl panics when a slice begins beyond the width.
        Case::of::<RunTimeSlice>().keep(|v| v["at"] <= 9 && v["far"] <= 96),
        Case::of::<RunTimeBitOfOddWidth>().keep(|v| v["at"] < 5),
        Case::of::<ReplacedBits>(),
        Case::of::<MachineWordPositions>(),
        Case::of::<FixedWordPositions>(),
        Case::of::<ConstantShifts>(),
        Case::of::<RunTimeShifts>(),
    ]
}
