//! Formats that rust-hdl's trees do not keep, positions, literals and widths.

use crate::{circuit, refused};
use rust_hdl_core::prelude::*;
use shadegate_hdl::format::{signed_cast_align, unsigned_cast_integer, Q, U};

circuit! {
    CastsCompared { a: Signal<In, Signed<8>>, o: Signal<Out, Bit> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = signed_bit_cast::<16, 8>(self.a.val()) < signed_bit_cast::<16, 8>(self.a.val() + self.a.val());
    }
}

circuit! {
    CastOfCast { a: Signal<In, Signed<8>>, o: Signal<Out, Signed<12>> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = signed_bit_cast::<12, 16>(signed_bit_cast::<16, 8>(self.a.val()));
    }
}

circuit! {
    AlignedCompared { a: Signal<In, Q<3, 4>>, b: Signal<In, Q<3, 4>>, o: Signal<Out, Bit> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = signed_cast_align::<5, 4, 3, 4>(self.a.val()) == signed_cast_align::<5, 4, 3, 4>(self.b.val());
    }
}

circuit! {
    IntegerShifted { a: Signal<In, Q<3, 4>>, o: Signal<Out, Bit> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = unsigned_cast_integer::<5, 3, 4>(self.a.val()).get_bit(1);
    }
}

circuit! {
    NumbersOnly { a: Signal<In, Bit>, o: Signal<Out, Bit> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val() & (3 > 2);
    }
}

circuit! {
    LongLiteral { a: Signal<In, Bits<8>>, o: Signal<Out, Bit> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val() == 300;
    }
}

circuit! {
    ComputedPosition { a: Signal<In, Bits<16>>, at: Signal<In, Bits<3>>, o: Signal<Out, Bit> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val().get_bit(self.at.val().index() + 1);
    }
}

circuit! {
    PositionBeyondFixed { a: Signal<In, Q<3, 4>>, at: Signal<In, Bits<3>>, o: Signal<Out, U<3>> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val().get_bits::<3>(self.at.val().index());
    }
}

circuit! {
    BitBeyond { a: Signal<In, U<8>>, o: Signal<Out, Bit> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val().get_bit(8);
    }
}

circuit! {
    TooWide { a: Signal<In, Bits<129>>, o: Signal<Out, Bits<129>> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val();
    }
}

circuit! {
    TooWideInside { a: Signal<In, Bits<128>>, o: Signal<Out, Bits<128>> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = bit_cast::<128, 130>(bit_cast::<130, 128>(self.a.val()) + 1);
    }
}

#[test]
fn conversions_without_a_known_target_are_refused() {
    refused! {
        CastsCompared => "module top: neither operand has a format: signed_cast(a) < signed_cast(a + a)",
        CastOfCast => "module top: a number without a type is converted: signed_cast(signed_cast(a))",
        AlignedCompared => "module top: neither operand has a format: signed_cast(a) == signed_cast(b)",
        IntegerShifted => "module top: an operand has no format: unsigned_cast(a).get_bit(1)",
        NumbersOnly => "module top: neither operand has a format: 3 > 2",
    }
}

#[test]
fn positions_and_literals_outside_their_word_are_refused() {
    refused! {
        LongLiteral => "module top: literal 300 does not fit U8: 300",
        ComputedPosition => "module top: a computed bit position has Rust's machine width, which the tree does not keep; give it a wire: at + 1",
        PositionBeyondFixed => "module top: the position can reach beyond the top of a fixed-point word, where Rust repeats the sign: a.get_bits::<3>(at)",
        BitBeyond => "module top: bits 8+:1 lie outside a word of 8 bits: a.get_bit(8)",
    }
}

#[test]
fn words_over_128_bits_are_refused() {
    refused! {
        TooWide => "module top: signal a: Bits::<129> is not a type of 1 to 128 bits that the netlist knows",
        TooWideInside => "module top: a word of 130 bits; 1 to 128 are possible: bit_cast::<130>(a)",
    }
}
