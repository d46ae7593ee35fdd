//! Conversions: up, down, between signed and unsigned, nested in expressions.

use crate::harness::case::Case;
use crate::harness::code::{circuit, drive};
use rust_hdl_core::prelude::*;
use shadegate_hdl::format::{
    bit_cast_u, signed_cast_align, signed_cast_bits, unsigned_cast_integer, Q, U,
};

/// A word in another width, alone and inside a sum.
#[derive(LogicBlock, Default)]
struct BitCast<const M: usize, const N: usize> {
    a: Signal<In, Bits<N>>,
    b: Signal<In, Bits<M>>,
    o: Signal<Out, Bits<M>>,
    sum: Signal<Out, Bits<M>>,
    same: Signal<Out, Bit>,
    back: Signal<Out, Bits<N>>,
    parity: Signal<Out, Bit>,
}

impl<const M: usize, const N: usize> Logic for BitCast<M, N> {
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = bit_cast::<M, N>(self.a.val());
        self.sum.next = bit_cast::<M, N>(!self.a.val() + 1) + self.b.val();
        self.same.next = bit_cast::<M, N>(self.a.val()) == self.b.val();
        self.back.next = bit_cast::<N, M>(bit_cast::<M, N>(self.a.val()) - self.b.val());
        self.parity.next = self.a.val().xor() ^ self.b.val().xor();
    }
}

/// A signed word in another width, alone and inside a sum.
#[derive(LogicBlock, Default)]
struct SignedBitCast<const M: usize, const N: usize> {
    a: Signal<In, Signed<N>>,
    b: Signal<In, Signed<M>>,
    o: Signal<Out, Signed<M>>,
    sum: Signal<Out, Signed<M>>,
    less: Signal<Out, Bit>,
    parity: Signal<Out, Bit>,
}

impl<const M: usize, const N: usize> Logic for SignedBitCast<M, N> {
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = signed_bit_cast::<M, N>(self.a.val());
        self.sum.next = self.b.val() - signed_bit_cast::<M, N>(self.a.val());
        self.less.next = signed_bit_cast::<M, N>(self.a.val()) < self.b.val();
        self.parity.next = unsigned_cast(self.a.val()).xor();
    }
}

circuit! {
    /// Casts inside casts.
    NestedCasts { in a: Bits<8>, b: Bits<33>, s: Signed<12>; out o: Bits<4>, p: Bits<16>, q: Bits<65>, r: Signed<8>, t: Bits<12>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = bit_cast::<4, 16>(bit_cast::<16, 8>(self.a.val()) << 4 >> 6);
        self.p.next = bit_cast::<16, 33>(self.b.val() + bit_cast::<33, 8>(self.a.val() - 1)) & bit_cast::<16, 4>(bit_cast::<4, 8>(!self.a.val()));
        self.q.next = bit_cast::<65, 33>(self.b.val()) << bit_cast::<5, 8>(self.a.val());
        self.r.next = signed_cast(self.a.val() ^ bit_cast::<8, 33>(self.b.val())) - signed_cast(self.a.val());
        self.t.next = unsigned_cast(self.s.val() + self.s.val()) ^ bit_cast::<12, 8>(self.a.val());
    }
}

circuit! {
    /// An arithmetic shift right: slice, then extend by the sign.
    ArithmeticShift { in a: Signed<16>; out o: Signed<16>, p: Signed<32>, lost: Bit; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = signed_bit_cast::<16, 9>(self.a.val().get_bits::<9>(7));
        self.p.next = signed_bit_cast::<32, 15>(self.a.val().get_bits::<15>(1));
        self.lost.next = self.a.val().get_bit(0);
    }
}

circuit! {
    /// Numbers with a width of their own.
    SizedNumbers { in a: Bits<8>, b: Bits<40>; out o: Bits<8>, p: Bits<40>, q: Bit, r: Bits<16>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val() ^ bits::<8>(0x5a);
        self.p.next = self.b.val() - bits::<40>(0x12_3456_789a_u64);
        self.q.next = Bits::<8>::from(17) < self.a.val();
        self.r.next = bit_cast::<16, 8>(bits::<8>(255) - self.a.val());
    }
}

circuit! {
    /// Conversions of the project's own words.
    MachineCasts { in a: U<8>, b: U<20>; out up: U<13>, down: U<9>, code: Q<3, 4>, low: Q<2, 5>, sum: U<12>, next: U<20>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.up.next = bit_cast_u::<13, 8>(self.a.val());
        self.down.next = bit_cast_u::<9, 20>(self.b.val() + self.b.val());
        self.code.next = signed_cast_bits::<3, 4, 8>(self.a.val());
        self.low.next = signed_cast_bits::<2, 5, 20>(self.b.val());
        self.next.next = self.b.val() + 1.into();
        self.sum.next = bit_cast_u::<12, 8>(self.a.val()) - bit_cast_u::<12, 20>(self.b.val());
    }
}

circuit! {
    /// The binary point moves; integer parts round downwards.
    FixedCasts { in a: Q<3, 5>, b: Q<7, 0>; out more: Q<3, 9>, fewer: Q<3, 2>, wider: Q<6, 5>, both: Q<8, 1>, whole: U<4>, part: U<2>, long: U<12>, exact: U<8>, cut: Q<1, 6>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.more.next = signed_cast_align::<3, 9, 3, 5>(self.a.val());
        self.fewer.next = signed_cast_align::<3, 2, 3, 5>(self.a.val());
        self.wider.next = signed_cast_align::<6, 5, 3, 5>(self.a.val());
        self.both.next = signed_cast_align::<8, 1, 3, 5>(self.a.val());
        self.whole.next = unsigned_cast_integer::<4, 3, 5>(self.a.val());
        self.part.next = unsigned_cast_integer::<2, 3, 5>(self.a.val());
        self.long.next = unsigned_cast_integer::<12, 3, 5>(self.a.val());
        self.exact.next = unsigned_cast_integer::<8, 7, 0>(self.b.val());
        self.cut.next = signed_cast_align::<1, 6, 3, 5>(self.a.val());
    }
}

macro_rules! pairs {
    ($($m:literal $n:literal),+) => {
        $(drive!(BitCast<$m, $n>; a, b); drive!(SignedBitCast<$m, $n>; a, b);)+
        fn pairs() -> Vec<Case> {
            let mut cases = vec![];
            $(
                cases.push(Case::named(concat!("bit_cast_", $m, "_", $n), BitCast::<$m, $n>::default()));
                cases.push(
                    // `signed_bit_cast` of the least number recurses for ever in rust-hdl.
                    Case::named(concat!("signed_bit_cast_", $m, "_", $n), SignedBitCast::<$m, $n>::default())
                        .keep(|v| v["a"] != 1 << ($n - 1)),
                );
            )+
            cases
        }
    };
}

pairs!(1 8, 8 2, 7 8, 8 7, 16 8, 9 16, 31 33, 33 31, 32 33, 33 32, 32 16, 63 65, 65 63, 64 65, 65 64, 64 32, 32 64, 96 17, 17 96, 128 127, 127 128, 2 128, 128 64);

pub fn cases() -> Vec<Case> {
    let mut cases: Vec<Case> = pairs();
    cases.extend([
        Case::of::<NestedCasts>(),
        Case::of::<ArithmeticShift>().keep(|v| v["a"] >> 7 != 1 << 8 && v["a"] >> 1 != 1 << 14),
        Case::of::<SizedNumbers>(),
        Case::of::<MachineCasts>(),
        Case::of::<FixedCasts>(),
    ]);
    cases
}
