//! Where a pixel is, and how deep, while its colour is worked out: two stages that move with `go`.

use crate::format::{Q, U};
use crate::simulate::Register;
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Stages of one [`FragmentPair`].
pub const STAGES: usize = 2;

/// `A` is the width of a frame address. Latency: two clocks.
#[derive(LogicBlock, Default)]
pub struct FragmentPair<const A: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// A fragment arrives.
    pub fragment: Signal<In, Bit>,
    /// Its column.
    pub x: Signal<In, U<11>>,
    /// Its row.
    pub y: Signal<In, U<11>>,
    /// Its frame address.
    pub address: Signal<In, U<A>>,
    /// Its depth.
    pub depth: Signal<In, Q<15, 0>>,
    /// A fragment leaves.
    pub late_fragment: Signal<Out, Bit>,
    /// Its column.
    pub late_x: Signal<Out, U<11>>,
    /// Its row.
    pub late_y: Signal<Out, U<11>>,
    /// Its frame address.
    pub late_address: Signal<Out, U<A>>,
    /// Its depth.
    pub late_depth: Signal<Out, Q<15, 0>>,
    /// A fragment is in one of the stages.
    pub busy: Signal<Out, Bit>,
    /// A fragment is in stage 1.
    fragment_1: Register<Bit>,
    /// Its column.
    x_1: Register<U<11>>,
    /// Its row.
    y_1: Register<U<11>>,
    /// Its frame address.
    address_1: Register<U<A>>,
    /// Its depth.
    depth_1: Register<Q<15, 0>>,
    /// A fragment is in stage 2.
    fragment_2: Register<Bit>,
    /// Its column.
    x_2: Register<U<11>>,
    /// Its row.
    y_2: Register<U<11>>,
    /// Its frame address.
    address_2: Register<U<A>>,
    /// Its depth.
    depth_2: Register<Q<15, 0>>,
}

impl<const A: usize> Logic for FragmentPair<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name fragment_pair");
        comment!("title Place and depth of a pixel while its colour is worked out: two stages.");
        comment!("equation late = fragment of two moves ago");
        comment!("source Pipeline registers.");
        comment!("latency Two clocks.");
        dff_setup!(
            self, clock, fragment_1, x_1, y_1, address_1, depth_1, fragment_2, x_2, y_2, address_2,
            depth_2
        );
        if self.go.val() {
            self.fragment_1.d.next = self.fragment.val();
            self.x_1.d.next = self.x.val();
            self.y_1.d.next = self.y.val();
            self.address_1.d.next = self.address.val();
            self.depth_1.d.next = self.depth.val();
            self.fragment_2.d.next = self.fragment_1.q.val();
            self.x_2.d.next = self.x_1.q.val();
            self.y_2.d.next = self.y_1.q.val();
            self.address_2.d.next = self.address_1.q.val();
            self.depth_2.d.next = self.depth_1.q.val();
        }
        self.late_fragment.next = self.fragment_2.q.val();
        self.late_x.next = self.x_2.q.val();
        self.late_y.next = self.y_2.q.val();
        self.late_address.next = self.address_2.q.val();
        self.late_depth.next = self.depth_2.q.val();
        self.busy.next = self.fragment_1.q.val() || self.fragment_2.q.val();
    }
}

crate::clocked!(FragmentPair<A>, const A: usize;
    inputs go, fragment, x, y, address, depth;
    outputs late_fragment, late_x, late_y, late_address, late_depth, busy);
