//! Registers: held, assigned on all paths, several at once, with an initial value, behind each other.

use crate::harness::case::Case;
use crate::harness::code::{circuit, drive};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::prelude::*;
use shadegate_hdl::format::{Q, U};
use shadegate_hdl::simulate::{Quiet, Register, Wire};

circuit! {
    /// A register that keeps its value unless told.
    HeldCounter { clock; in step: Bits<5>, go: Bit, clear: Bit; out count: Bits<9>; reg total: Bits<9>; }
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, total);
        if self.go.val() {
            self.total.d.next = self.total.q.val() + bit_cast::<9, 5>(self.step.val());
        }
        if self.clear.val() {
            self.total.d.next = 0.into();
        }
        self.count.next = self.total.q.val();
    }
}

circuit! {
    /// A register without a hold: every path assigns it.
    NoHold { clock; in a: Signed<7>, go: Bit; out o: Signed<7>; reg last: Signed<7>; }
    #[hdl_gen]
    fn update(&mut self) {
        clock!(self, clock, last);
        if self.go.val() {
            self.last.d.next = self.a.val();
        } else {
            self.last.d.next = -self.last.q.val();
        }
        self.o.next = self.last.q.val();
    }
}

circuit! {
    /// A shift register of three stages, all of which move at once.
    Delay { clock; in a: Bits<33>; out o: Bits<33>, second: Bits<33>; reg first: Bits<33>, middle: Bits<33>, last: Bits<33>; }
    #[hdl_gen]
    fn update(&mut self) {
        clock!(self, clock, first, middle, last);
        self.first.d.next = self.a.val();
        self.middle.d.next = self.first.q.val();
        self.last.d.next = self.middle.q.val();
        self.second.next = self.middle.q.val();
        self.o.next = self.last.q.val();
    }
}

circuit! {
    /// Two registers exchange their words; a third is one bit.
    Exchange { clock; in a: Bits<8>, load: Bit; out o: Bits<8>, p: Bits<8>, odd: Bit; reg left: Bits<8>, right: Bits<8>, flag: Bit; }
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, left, right, flag);
        self.left.d.next = self.right.q.val();
        self.right.d.next = self.left.q.val();
        if self.load.val() {
            self.left.d.next = self.a.val();
            self.flag.d.next = !self.flag.q.val();
        }
        self.o.next = self.left.q.val();
        self.p.next = self.right.q.val();
        self.odd.next = self.flag.q.val() ^ self.a.val().xor();
    }
}

circuit! {
    /// Registers of every kind of word.
    FormatRegisters { clock; in a: U<12>, b: Q<3, 4>, c: Signed<128>; out o: U<12>, p: Q<3, 4>, q: Signed<128>; reg x: U<12>, y: Q<3, 4>, z: Signed<128>; }
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, x, y, z);
        self.x.d.next = self.x.q.val() + self.a.val();
        if self.y.q.val() < self.b.val() {
            self.y.d.next = self.y.q.val() + self.b.val();
        }
        self.z.d.next = self.z.q.val() - self.c.val();
        self.o.next = self.x.q.val();
        self.p.next = self.y.q.val();
        self.q.next = self.z.q.val();
    }
}

/// A register that does not begin with zero: rust-hdl's widget is a module with a register and two exclusive ors.
#[derive(LogicBlock)]
struct BeginsWithNine {
    clock: Signal<In, Clock>,
    go: Signal<In, Bit>,
    o: Signal<Out, Bits<6>>,
    count: DFFWithInit<Bits<6>>,
}

impl Default for BeginsWithNine {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            go: Default::default(),
            o: Default::default(),
            count: DFFWithInit::new(9.into()),
        }
    }
}

impl Logic for BeginsWithNine {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, count);
        if self.go.val() {
            self.count.d.next = self.count.q.val() + 1;
        }
        self.o.next = self.count.q.val();
    }
}

drive!(BeginsWithNine, clock; go);

/// The project's own registers and wires, in a block that rests.
#[derive(LogicBlock, Default)]
struct Accumulator {
    clock: Signal<In, Clock>,
    a: Signal<In, Q<5, 6>>,
    go: Signal<In, Bit>,
    o: Signal<Out, Q<5, 6>>,
    sum: Register<Q<5, 6>>,
    next: Wire<Q<5, 6>>,
}

impl Logic for Accumulator {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, sum);
        self.next.next = self.sum.q.val() + self.a.val();
        if self.go.val() {
            self.sum.d.next = self.next.val();
        }
        self.o.next = self.sum.q.val();
    }
}

shadegate_hdl::clocked!(Accumulator; inputs a, go; outputs o);

/// Two of them, one fed by the other.
#[derive(LogicBlock, Default)]
struct QuietAccumulators {
    clock: Signal<In, Clock>,
    a: Signal<In, Q<5, 6>>,
    go: Signal<In, Bit>,
    o: Signal<Out, Q<5, 6>>,
    first: Quiet<Accumulator>,
    second: Quiet<Accumulator>,
}

impl Logic for QuietAccumulators {
    #[hdl_gen]
    fn update(&mut self) {
        self.first.clock.next = self.clock.val();
        self.second.clock.next = self.clock.val();
        self.first.a.next = self.a.val();
        self.first.go.next = self.go.val();
        self.second.a.next = self.first.o.val();
        self.second.go.next = !self.go.val();
        self.o.next = self.second.o.val();
    }
}

drive!(QuietAccumulators, clock; a, go);

pub fn cases() -> Vec<Case> {
    vec![
        Case::of::<HeldCounter>(),
        Case::of::<NoHold>(),
        Case::of::<Delay>(),
        Case::of::<Exchange>(),
        Case::of::<FormatRegisters>(),
        Case::of::<BeginsWithNine>(),
        Case::of::<QuietAccumulators>(),
    ]
}
