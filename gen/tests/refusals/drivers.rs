//! Latches, undriven and doubly driven signals, and reads that depend on the order of assignments.

use crate::{circuit, refused};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::prelude::*;

circuit! {
    Latch { a: Signal<In, Bits<8>>, f: Signal<In, Bit>, o: Signal<Out, Bits<8>> }
    #[hdl_gen]
    fn update(&mut self) {
        if self.f.val() {
            self.o.next = self.a.val();
        }
    }
}

circuit! {
    WireLatch { a: Signal<In, Bits<2>>, o: Signal<Out, Bits<2>>, t: Signal<Local, Bits<2>> }
    #[hdl_gen]
    fn update(&mut self) {
        match self.a.val().index() {
            0 => self.t.next = 1.into(),
            1 => self.t.next = 2.into(),
            _ => {}
        }
        self.o.next = self.t.val();
    }
}

circuit! {
    NoDriver { a: Signal<In, Bits<8>>, o: Signal<Out, Bits<8>>, t: Signal<Local, Bits<8>> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val() + self.t.val();
    }
}

circuit! {
    NoOutputDriver { a: Signal<In, Bits<8>>, o: Signal<Out, Bits<8>>, p: Signal<Out, Bit> }
    #[hdl_gen]
    fn update(&mut self) {
        self.p.next = self.a.val().any();
    }
}

circuit! {
    Child { a: Signal<In, Bits<8>>, o: Signal<Out, Bits<8>> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val();
    }
}

circuit! {
    NoChildInput { o: Signal<Out, Bits<8>>, child: Child }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.child.o.val();
    }
}

circuit! {
    JoinedAndAssigned { a: Signal<In, Bits<8>>, o: Signal<Out, Bits<8>>, first: Child, second: Child }
    #[hdl_gen]
    fn update(&mut self) {
        self.first.a.next = self.a.val();
        Signal::<Out, Bits<8>>::join(&mut self.first.o, &mut self.second.a);
        self.second.a.next = 3.into();
        self.o.next = self.second.o.val();
    }
}

circuit! {
    JoinedTwice { a: Signal<In, Bits<8>>, o: Signal<Out, Bits<8>>, first: Child, second: Child }
    #[hdl_gen]
    fn update(&mut self) {
        self.first.a.next = self.a.val();
        Signal::<Out, Bits<8>>::join(&mut self.first.o, &mut self.second.a);
        Signal::<Out, Bits<8>>::join(&mut self.first.o, &mut self.second.a);
        self.o.next = self.second.o.val();
    }
}

circuit! {
    JoinInsideIf { a: Signal<In, Bits<8>>, o: Signal<Out, Bits<8>>, first: Child, second: Child }
    #[hdl_gen]
    fn update(&mut self) {
        self.first.a.next = self.a.val();
        if self.a.val().any() {
            Signal::<Out, Bits<8>>::join(&mut self.first.o, &mut self.second.a);
        }
        self.o.next = self.second.o.val();
    }
}

circuit! {
    RegisterWithoutHold { clock: Signal<In, Clock>, f: Signal<In, Bit>, o: Signal<Out, Bit>, r: DFF<Bit> }
    #[hdl_gen]
    fn update(&mut self) {
        clock!(self, clock, r);
        if self.f.val() {
            self.r.d.next = true;
        }
        self.o.next = self.r.q.val();
    }
}

circuit! {
    RegisterWithoutClock { clock: Signal<In, Clock>, f: Signal<In, Bit>, o: Signal<Out, Bit>, r: DFF<Bit> }
    #[hdl_gen]
    fn update(&mut self) {
        self.r.d.next = self.f.val();
        self.o.next = self.r.q.val();
    }
}

circuit! {
    TwoClocksOfOneRegister { clock: Signal<In, Clock>, other: Signal<In, Clock>, o: Signal<Out, Bit>, r: DFF<Bit> }
    #[hdl_gen]
    fn update(&mut self) {
        self.r.clock.next = self.clock.val();
        self.r.clock.next = self.other.val();
        self.r.d.next = !self.r.q.val();
        self.o.next = self.r.q.val();
    }
}

circuit! {
    ReadBetween { a: Signal<In, Bits<8>>, f: Signal<In, Bit>, o: Signal<Out, Bits<8>>, t: Signal<Local, Bits<8>> }
    #[hdl_gen]
    fn update(&mut self) {
        self.t.next = 0.into();
        self.o.next = self.t.val();
        if self.f.val() {
            self.t.next = self.a.val();
        }
    }
}

circuit! {
    ReadOfItself { a: Signal<In, Bits<8>>, o: Signal<Out, Bits<8>> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val();
        self.o.next = self.o.val() + 1;
    }
}

circuit! {
    ConditionBetween { a: Signal<In, Bits<8>>, o: Signal<Out, Bits<8>> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val();
        if self.o.val() == 3 {
            self.o.next = 4.into();
        }
    }
}

#[test]
fn latches_are_refused() {
    refused! {
        Latch => "module top: output o is not assigned on every path: that would be a latch",
        WireLatch => "module top: wire t is not assigned on every path: that would be a latch",
        RegisterWithoutHold => "module top: register r has no value on some path and no hold default; name it in dff_setup",
    }
}

#[test]
fn undriven_signals_are_refused() {
    refused! {
        NoDriver => "module top: wire t has no driver",
        NoOutputDriver => "module top: output o has no driver",
        NoChildInput => "module top: input a of child has no driver",
        RegisterWithoutClock => "module top: register r is never assigned or has no clock",
    }
}

#[test]
fn doubly_driven_signals_are_refused() {
    refused! {
        JoinedAndAssigned => "module top: second_a is driven twice, by a join or link and by an assignment",
        JoinedTwice => "module top: second.a is joined twice: join or link",
        JoinInsideIf => "module top: a join or link stands inside a condition: join or link",
        TwoClocksOfOneRegister => "module top: register r has two clocks, clock and other: r.clock.next = other",
    }
}

#[test]
fn reads_between_two_assignments_are_refused() {
    refused! {
        ReadBetween => "module top: wire t is read between two of its assignments; give the earlier value a wire of its own",
        ReadOfItself => "module top: output o is read between two of its assignments; give the earlier value a wire of its own",
        ConditionBetween => "module top: output o is read between two of its assignments; give the earlier value a wire of its own",
    }
}

circuit! {
    ReadInOneBranch { a: Signal<In, Bits<8>>, f: Signal<In, Bit>, o: Signal<Out, Bits<8>>, t: Signal<Local, Bits<8>> }
    #[hdl_gen]
    fn update(&mut self) {
        self.t.next = 1.into();
        self.o.next = 0.into();
        if self.f.val() {
            self.t.next = self.a.val();
            self.o.next = self.t.val() + 1;
        } else {
            self.t.next = 5.into();
        }
    }
}

#[test]
fn a_read_behind_the_last_assignment_of_its_path_is_not_refused() {
    refused! { ReadInOneBranch => "not refused" }
}
