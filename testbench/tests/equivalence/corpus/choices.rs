//! `if`, `else if`, `match` on states, numbers and bits, with and without a default.

use crate::harness::case::Case;
use crate::harness::code::{circuit, drive};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::prelude::*;

/// Five states in three bits.
#[derive(Clone, Copy, Debug, PartialEq, LogicState)]
pub enum Step {
    Idle,
    Load,
    Run,
    Drain,
    Done,
}

circuit! {
    /// A state machine that names every state.
    FullMatch { clock; in go: Bit, last: Bit; out busy: Bit, count: Bits<4>; reg step: Step, steps: Bits<4>; }
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, step, steps);
        self.busy.next = true;
        match self.step.q.val() {
            Step::Idle => {
                self.busy.next = false;
                if self.go.val() {
                    self.step.d.next = Step::Load;
                }
            }
            Step::Load => self.step.d.next = Step::Run,
            Step::Run => {
                self.steps.d.next = self.steps.q.val() + 1;
                if self.last.val() {
                    self.step.d.next = Step::Drain;
                }
            }
            Step::Drain => {
                self.step.d.next = Step::Done;
            }
            Step::Done => {
                self.step.d.next = Step::Idle;
                self.busy.next = self.go.val();
            }
        }
        self.count.next = self.steps.q.val();
    }
}

circuit! {
    /// A state machine with a default, comparisons of states and a state as a wire.
    DefaultMatch { clock; in go: Bit, a: Bits<8>; out o: Bits<8>, idle: Bit, moved: Bit; wire next: Step; reg step: Step; }
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, step);
        self.next.next = self.step.q.val();
        match self.step.q.val() {
            Step::Idle => self.next.next = Step::Run,
            Step::Run => {
                if self.go.val() {
                    self.next.next = Step::Done;
                }
            }
            _ => self.next.next = Step::Idle,
        }
        self.step.d.next = self.next.val();
        self.idle.next = self.step.q.val() == Step::Idle;
        self.moved.next = self.next.val() != self.step.q.val();
        match self.next.val() {
            Step::Run => self.o.next = self.a.val(),
            Step::Done => self.o.next = !self.a.val(),
            _ => self.o.next = 0.into(),
        }
    }
}

circuit! {
    /// A match without a default that names some states only; the others keep what was assigned before.
    PartialMatch { clock; in a: Bits<8>; out o: Bits<8>; reg step: Step, hold: Bits<8>; }
    #[allow(clippy::single_match)]
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, step, hold);
        self.o.next = self.hold.q.val();
        self.step.d.next = Step::Idle;
        match self.step.q.val() {
            Step::Idle => self.step.d.next = Step::Drain,
            Step::Drain => {
                self.hold.d.next = self.a.val();
                self.o.next = self.a.val() + 1;
                self.step.d.next = Step::Load;
            }
            _ => {}
        }
    }
}

/// One state only needs no bit, two need one.
#[derive(Clone, Copy, Debug, PartialEq, LogicState)]
pub enum Side {
    Left,
    Right,
}

circuit! {
    /// A state of one bit, as an output and converted to a word.
    OneBitState { clock; in go: Bit; out right: Bit, side: Side; reg now: Side; }
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, now);
        if self.go.val() {
            match self.now.q.val() {
                Side::Left => self.now.d.next = Side::Right,
                Side::Right => self.now.d.next = Side::Left,
            }
        }
        self.right.next = self.now.q.val() == Side::Right;
        self.side.next = self.now.q.val();
    }
}

circuit! {
    /// A match on numbers, in several radices, with a default; the second hit of a number never counts.
    MatchOnNumbers { in a: Bits<5>, b: Bits<7>; out o: Bits<7>; }
    #[hdl_gen]
    fn update(&mut self) {
        match self.a.val().index() {
            0 => self.o.next = self.b.val(),
            0x1f => self.o.next = !self.b.val(),
            7 => {
                self.o.next = self.b.val() + 1;
            }
            0b101 => self.o.next = 99.into(),
            7 => self.o.next = 1.into(),
            _ => self.o.next = bit_cast::<7, 5>(self.a.val()),
        }
    }
}

circuit! {
    /// A match on a bit.
    MatchOnBit { in a: Bit, b: Bits<4>; out o: Bits<4>; }
    #[allow(clippy::match_bool)]
    #[hdl_gen]
    fn update(&mut self) {
        match self.a.val() {
            true => self.o.next = self.b.val(),
            false => self.o.next = 15 - self.b.val(),
        }
    }
}

circuit! {
    /// A match that names every number of a word.
    MatchOnEveryNumber { in a: Bits<2>, b: Bits<4>; out o: Bits<4>; }
    #[hdl_gen]
    fn update(&mut self) {
        match self.a.val().index() {
            0 => self.o.next = self.b.val(),
            1 => self.o.next = self.b.val() >> 1,
            2 => self.o.next = self.b.val() << 1,
            3 => self.o.next = 0.into(),
            _ => self.o.next = 7.into(),
        }
    }
}

circuit! {
    /// A chain of conditions; the first that holds decides.
    Chain { in a: Bits<8>, s: Signed<8>, f: Bit; out o: Bits<3>, p: Bits<3>; }
    #[hdl_gen]
    fn update(&mut self) {
        if self.a.val() == 3 {
            self.o.next = 1.into();
        } else if self.s.val() < 0.into() && !self.f.val() {
            self.o.next = 2.into();
        } else if self.a.val().any() | self.f.val() {
            self.o.next = 3.into();
        } else {
            self.o.next = 4.into();
        }
        self.p.next = 0.into();
        if self.a.val().get_bit(0) {
            if self.a.val().get_bit(1) {
                self.p.next = 1.into();
            } else if self.a.val().all() {
                self.p.next = 2.into();
            }
        } else {
            self.p.next = 3.into();
            if self.f.val() {
                self.p.next = 5.into();
            }
        }
    }
}

circuit! {
    /// Default, then overrides; wires of one `if` read each other.
    Overrides { in a: Bits<8>, b: Bits<8>, f: Bit, g: Bit; out o: Bits<8>, p: Bits<8>; wire t: Bits<8>, u: Bits<8>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.t.next = self.a.val();
        self.u.next = 0.into();
        if self.f.val() {
            self.t.next = self.b.val() + 1;
        }
        if self.g.val() {
            self.u.next = self.t.val() ^ self.b.val();
            self.o.next = self.u.val() - 1;
        } else {
            self.o.next = self.t.val();
        }
        self.p.next = self.u.val();
        if self.u.val() == 0 {
            self.p.next = self.o.val() - self.a.val();
        }
    }
}

circuit! {
    /// Conditions that are constants.
    ConstantConditions { in a: Bits<4>; out o: Bits<4>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val();
        if false {
            self.o.next = 3.into();
        }
        if true & !false {
            self.o.next = self.a.val() ^ 5;
        }
    }
}

pub fn cases() -> Vec<Case> {
    vec![
        Case::of::<FullMatch>(),
        Case::of::<DefaultMatch>(),
        Case::of::<PartialMatch>(),
        Case::of::<OneBitState>(),
        Case::of::<MatchOnNumbers>(),
        Case::of::<MatchOnBit>(),
        Case::of::<MatchOnEveryNumber>(),
        Case::of::<Chain>(),
        Case::of::<Overrides>(),
        Case::of::<ConstantConditions>(),
    ]
}
