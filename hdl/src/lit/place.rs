//! One stage of the way that a fragment's place takes beside its colour.

use crate::format::{Q, U};
use crate::simulate::Register;
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// `A` is the width of a frame address. Latency: one clock with `go`.
#[derive(LogicBlock, Default)]
pub struct PlaceStage<const A: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move.
    pub go: Signal<In, Bit>,
    /// A fragment arrives.
    pub fragment: Signal<In, Bit>,
    /// Its column.
    pub x: Signal<In, U<11>>,
    /// Its row.
    pub y: Signal<In, U<11>>,
    /// Its frame address.
    pub address: Signal<In, U<A>>,
    /// Its depth less 32768.
    pub depth: Signal<In, Q<15, 0>>,
    /// The stage holds a fragment.
    pub fragment_out: Signal<Out, Bit>,
    /// Its column.
    pub x_out: Signal<Out, U<11>>,
    /// Its row.
    pub y_out: Signal<Out, U<11>>,
    /// Its frame address.
    pub address_out: Signal<Out, U<A>>,
    /// Its depth less 32768.
    pub depth_out: Signal<Out, Q<15, 0>>,
    /// The stage holds a fragment.
    held: Register<Bit>,
    /// Its column.
    held_x: Register<U<11>>,
    /// Its row.
    held_y: Register<U<11>>,
    /// Its frame address.
    held_address: Register<U<A>>,
    /// Its depth less 32768.
    held_depth: Register<Q<15, 0>>,
}

impl<const A: usize> Logic for PlaceStage<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name place_stage");
        comment!("title One stage of the way of a fragment's place beside its colour.");
        comment!("equation out = in, one clock later");
        comment!("source Ours.");
        comment!("latency One clock with go.");
        dff_setup!(self, clock, held, held_x, held_y, held_address, held_depth);
        if self.go.val() {
            self.held.d.next = self.fragment.val();
            self.held_x.d.next = self.x.val();
            self.held_y.d.next = self.y.val();
            self.held_address.d.next = self.address.val();
            self.held_depth.d.next = self.depth.val();
        }
        self.fragment_out.next = self.held.q.val();
        self.x_out.next = self.held_x.q.val();
        self.y_out.next = self.held_y.q.val();
        self.address_out.next = self.held_address.q.val();
        self.depth_out.next = self.held_depth.q.val();
    }
}

crate::clocked!(PlaceStage<A>, const A: usize;
    inputs go, fragment, x, y, address, depth;
    outputs fragment_out, x_out, y_out, address_out, depth_out);
