//! Structures of fields, and interfaces with `join` and `link`.

use crate::harness::case::Case;
use crate::harness::code::{circuit, drive};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::prelude::*;

/// A state inside a structure.
#[derive(Clone, Copy, Debug, PartialEq, LogicState)]
pub enum Kind {
    Plain,
    Odd,
    Even,
}

/// Fields of several kinds side by side.
#[derive(Clone, Copy, Debug, Default, PartialEq, LogicStruct)]
pub struct Request {
    valid: Bit,
    address: Bits<7>,
    kind: Kind,
    data: Bits<40>,
}

circuit! {
    /// Fields assigned one by one, and read in expressions.
    Fields { in a: Bits<7>, d: Bits<40>, v: Bit; out address: Bits<7>, data: Bits<40>, valid: Bit, odd: Bit, all: Request; wire r: Request; }
    #[hdl_gen]
    fn update(&mut self) {
        self.r.next.valid = self.v.val() & self.a.val().any();
        self.r.next.address = self.a.val() + 1;
        self.r.next.kind = Kind::Plain;
        if self.a.val().get_bit(0) {
            self.r.next.kind = Kind::Odd;
        } else if self.v.val() {
            self.r.next.kind = Kind::Even;
        }
        self.r.next.data = self.d.val();
        if self.v.val() {
            self.r.next.data = !self.d.val();
        }
        self.address.next = self.r.val().address ^ self.a.val();
        self.data.next = self.r.val().data - 1;
        self.valid.next = !self.r.val().valid;
        self.odd.next = self.r.val().kind == Kind::Odd;
        self.all.next = self.r.val();
    }
}

circuit! {
    /// Fields of a register's next value; the others are held.
    FieldRegister { clock; in a: Bits<7>, d: Bits<40>, v: Bit, w: Bit; out data: Bits<40>, state: Bits<2>, all: Request; reg r: Request; }
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, r);
        self.r.d.next.valid = self.v.val();
        if self.v.val() {
            self.r.d.next.address = self.a.val();
            self.r.d.next.data = self.d.val() + self.r.q.val().data;
        }
        match self.r.q.val().kind {
            Kind::Plain => self.r.d.next.kind = Kind::Odd,
            Kind::Odd => {
                if self.w.val() {
                    self.r.d.next.kind = Kind::Even;
                }
            }
            Kind::Even => self.r.d.next.kind = Kind::Plain,
        }
        self.data.next = self.r.q.val().data;
        self.state.next = 0.into();
        if self.r.q.val().kind == Kind::Even {
            self.state.next = 2.into();
        }
        self.all.next = self.r.q.val();
    }
}

/// The sending side of a bus.
#[derive(LogicInterface, Default)]
#[join = "Listener"]
struct Talker {
    pub data: Signal<Out, Bits<8>>,
    pub valid: Signal<Out, Bit>,
    pub ready: Signal<In, Bit>,
}

/// The receiving side.
#[derive(LogicInterface, Default)]
#[join = "Talker"]
struct Listener {
    pub data: Signal<In, Bits<8>>,
    pub valid: Signal<In, Bit>,
    pub ready: Signal<Out, Bit>,
}

/// Sends what it counts.
#[derive(LogicBlock, Default)]
struct Sender {
    pub clock: Signal<In, Clock>,
    pub step: Signal<In, Bits<8>>,
    pub bus: Talker,
    count: DFF<Bits<8>>,
}

impl Logic for Sender {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, count);
        self.bus.data.next = self.count.q.val();
        self.bus.valid.next = self.step.val().any();
        if self.bus.ready.val() {
            self.count.d.next = self.count.q.val() + self.step.val();
        }
    }
}

/// Takes every other word.
#[derive(LogicBlock, Default)]
struct Receiver {
    pub clock: Signal<In, Clock>,
    pub bus: Listener,
    pub total: Signal<Out, Bits<8>>,
    sum: DFF<Bits<8>>,
    turn: DFF<Bit>,
}

impl Logic for Receiver {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, sum, turn);
        self.bus.ready.next = self.turn.q.val();
        self.turn.d.next = !self.turn.q.val();
        if self.bus.valid.val() & self.turn.q.val() {
            self.sum.d.next = self.sum.q.val() + self.bus.data.val();
        }
        self.total.next = self.sum.q.val();
    }
}

circuit! {
    /// Two children joined to each other.
    JoinedChildren { clock; in step: Bits<8>; out total: Bits<8>, seen: Bits<8>; part sender: Sender, receiver: Receiver; }
    #[hdl_gen]
    fn update(&mut self) {
        self.sender.clock.next = self.clock.val();
        self.receiver.clock.next = self.clock.val();
        self.sender.step.next = self.step.val();
        Talker::join(&mut self.sender.bus, &mut self.receiver.bus);
        self.total.next = self.receiver.total.val();
        self.seen.next = self.sender.bus.data.val() ^ 1;
    }
}

/// A parent whose own bus is its child's.
#[derive(LogicBlock, Default)]
struct LinkedSender {
    pub clock: Signal<In, Clock>,
    pub step: Signal<In, Bits<8>>,
    pub bus: Talker,
    sender: Sender,
}

impl Logic for LinkedSender {
    #[hdl_gen]
    fn update(&mut self) {
        self.sender.clock.next = self.clock.val();
        self.sender.step.next = self.step.val() >> 1;
        Talker::link(&mut self.bus, &mut self.sender.bus);
    }
}

drive!(LinkedSender, clock; step, bus.ready);

/// A listening bus handed down, beside a join of single signals.
#[derive(LogicBlock, Default)]
struct LinkedReceiver {
    pub clock: Signal<In, Clock>,
    pub bus: Listener,
    pub total: Signal<Out, Bits<8>>,
    receiver: Receiver,
}

impl Logic for LinkedReceiver {
    #[hdl_gen]
    fn update(&mut self) {
        self.receiver.clock.next = self.clock.val();
        Listener::link(&mut self.bus, &mut self.receiver.bus);
        self.total.next = !self.receiver.total.val();
    }
}

drive!(LinkedReceiver, clock; bus.data, bus.valid);

circuit! {
    /// Three levels: linked parents joined.
    LinkedAndJoined { clock; in step: Bits<8>; out total: Bits<8>; part sender: LinkedSender, receiver: LinkedReceiver; }
    #[hdl_gen]
    fn update(&mut self) {
        self.sender.clock.next = self.clock.val();
        self.receiver.clock.next = self.clock.val();
        self.sender.step.next = self.step.val();
        Listener::join(&mut self.receiver.bus, &mut self.sender.bus);
        self.total.next = self.receiver.total.val();
    }
}

/// Several lanes, each joined in a loop.
#[derive(LogicBlock, Default)]
struct JoinedLanes {
    clock: Signal<In, Clock>,
    step: Signal<In, Bits<8>>,
    total: [Signal<Out, Bits<8>>; 3],
    sender: [Sender; 3],
    receiver: [Receiver; 3],
}

impl Logic for JoinedLanes {
    #[hdl_gen]
    fn update(&mut self) {
        for i in 0..3 {
            self.sender[i].clock.next = self.clock.val();
            self.receiver[i].clock.next = self.clock.val();
            self.sender[i].step.next = self.step.val() + i.to_bits();
            Talker::join(&mut self.sender[i].bus, &mut self.receiver[2 - i].bus);
            self.total[i].next = self.receiver[i].total.val();
        }
    }
}

drive!(JoinedLanes, clock; step);

pub fn cases() -> Vec<Case> {
    vec![
        Case::of::<Fields>(),
        Case::of::<FieldRegister>(),
        Case::of::<JoinedChildren>(),
        Case::of::<LinkedSender>(),
        Case::of::<LinkedReceiver>(),
        Case::of::<LinkedAndJoined>(),
        Case::of::<JoinedLanes>(),
    ]
}
