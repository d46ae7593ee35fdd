//! Products of the descriptions' own words, converted at once to the bits that are wanted; shifts of machine words.

use crate::harness::case::Case;
use crate::harness::code::{circuit, drive};
use rust_hdl_core::prelude::*;
use shadegate_hdl::format::{bit_cast_product, signed_cast_product, Q, U};

circuit! {
    /// Fraction bits of a signed product dropped, kept and appended; integer bits kept and dropped.
    FixedProducts { in a: Q<2, 5>, b: Q<3, 9>; out all: Q<6, 14>, fewer: Q<6, 3>, more: Q<6, 16>, cut: Q<2, 5>, whole: Q<4, 0>, square: Q<1, 4>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.all.next = signed_cast_product::<6, 14>(self.a.val() * self.b.val());
        self.fewer.next = signed_cast_product::<6, 3>(self.a.val() * self.b.val());
        self.more.next = signed_cast_product::<6, 16>(self.b.val() * self.a.val());
        self.cut.next = signed_cast_product::<2, 5>(self.a.val() * self.b.val());
        self.whole.next = signed_cast_product::<4, 0>(self.a.val() * self.b.val());
        self.square.next = signed_cast_product::<1, 4>((self.a.val() - self.a.val()) * self.a.val())
            + signed_cast_product::<1, 4>(self.a.val() * self.a.val());
    }
}

circuit! {
    /// Factors of the widest formats: the product has more bits than any word.
    WideProducts { in a: Q<20, 40>, b: Q<30, 30>; out high: Q<50, 10>, low: Q<2, 60>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.high.next = signed_cast_product::<50, 10>(self.a.val() * self.b.val());
        self.low.next = signed_cast_product::<2, 60>(self.a.val() * self.b.val());
    }
}

circuit! {
    /// Unsigned products, whole and cut.
    MachineProducts { in a: U<11>, b: U<18>, c: U<40>; out all: U<29>, low: U<7>, cut: U<63>, sum: U<29>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.all.next = bit_cast_product::<29>(self.a.val() * self.b.val());
        self.low.next = bit_cast_product::<7>(self.b.val() * self.a.val());
        self.cut.next = bit_cast_product::<63>(self.c.val() * self.c.val());
        self.sum.next = bit_cast_product::<29>(self.a.val() * self.b.val()) + bit_cast_product::<29>(self.b.val() * self.a.val());
    }
}

circuit! {
    /// Shifts of machine words by numbers and by words, beyond their width too.
    MachineShifts { in a: U<13>, n: U<5>; out left: U<13>, right: U<13>, by_left: U<13>, by_right: U<13>, none: U<13>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.left.next = self.a.val() << 3u64;
        self.right.next = self.a.val() >> 9u64;
        self.by_left.next = self.a.val() << self.n.val();
        self.by_right.next = (self.a.val() >> self.n.val()) ^ self.a.val();
        self.none.next = self.a.val() << 13u64;
    }
}

pub fn cases() -> Vec<Case> {
    vec![
        Case::of::<FixedProducts>(),
        Case::of::<WideProducts>(),
        Case::of::<MachineProducts>(),
        Case::of::<MachineShifts>(),
    ]
}
