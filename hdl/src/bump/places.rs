//! Where a pixel is, and how deep, while its bump is lit: eighteen stages that move with `go`.

use crate::format::{Q, U};
use crate::shade::phong::fragment_delay::FragmentDelay;
use crate::simulate::Quiet;
use rust_hdl_core::prelude::*;

/// Stages of one [`BumpPlaces`].
pub const STAGES: usize = 6 * crate::shade::phong::fragment_delay::STAGES;

/// `A` is the width of a frame address. Latency: eighteen clocks.
#[derive(LogicBlock, Default)]
pub struct BumpPlaces<const A: usize> {
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
    /// Stages 1 to 3.
    place_a: Quiet<FragmentDelay<A>>,
    /// Stages 4 to 6.
    place_b: Quiet<FragmentDelay<A>>,
    /// Stages 7 to 9.
    place_c: Quiet<FragmentDelay<A>>,
    /// Stages 10 to 12.
    place_d: Quiet<FragmentDelay<A>>,
    /// Stages 13 to 15.
    place_e: Quiet<FragmentDelay<A>>,
    /// Stages 16 to 18.
    place_f: Quiet<FragmentDelay<A>>,
}

impl<const A: usize> Logic for BumpPlaces<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name bump_places");
        comment!("title Place and depth of a pixel while its bump is lit: eighteen stages.");
        comment!("equation late = fragment of eighteen moves ago");
        comment!("source Pipeline registers.");
        comment!("latency Eighteen clocks.");
        self.place_a.clock.next = self.clock.val();
        self.place_a.go.next = self.go.val();
        self.place_a.fragment.next = self.fragment.val();
        self.place_a.x.next = self.x.val();
        self.place_a.y.next = self.y.val();
        self.place_a.address.next = self.address.val();
        self.place_a.depth.next = self.depth.val();

        self.place_b.clock.next = self.clock.val();
        self.place_b.go.next = self.go.val();
        self.place_b.fragment.next = self.place_a.late_fragment.val();
        self.place_b.x.next = self.place_a.late_x.val();
        self.place_b.y.next = self.place_a.late_y.val();
        self.place_b.address.next = self.place_a.late_address.val();
        self.place_b.depth.next = self.place_a.late_depth.val();

        self.place_c.clock.next = self.clock.val();
        self.place_c.go.next = self.go.val();
        self.place_c.fragment.next = self.place_b.late_fragment.val();
        self.place_c.x.next = self.place_b.late_x.val();
        self.place_c.y.next = self.place_b.late_y.val();
        self.place_c.address.next = self.place_b.late_address.val();
        self.place_c.depth.next = self.place_b.late_depth.val();

        self.place_d.clock.next = self.clock.val();
        self.place_d.go.next = self.go.val();
        self.place_d.fragment.next = self.place_c.late_fragment.val();
        self.place_d.x.next = self.place_c.late_x.val();
        self.place_d.y.next = self.place_c.late_y.val();
        self.place_d.address.next = self.place_c.late_address.val();
        self.place_d.depth.next = self.place_c.late_depth.val();

        self.place_e.clock.next = self.clock.val();
        self.place_e.go.next = self.go.val();
        self.place_e.fragment.next = self.place_d.late_fragment.val();
        self.place_e.x.next = self.place_d.late_x.val();
        self.place_e.y.next = self.place_d.late_y.val();
        self.place_e.address.next = self.place_d.late_address.val();
        self.place_e.depth.next = self.place_d.late_depth.val();

        self.place_f.clock.next = self.clock.val();
        self.place_f.go.next = self.go.val();
        self.place_f.fragment.next = self.place_e.late_fragment.val();
        self.place_f.x.next = self.place_e.late_x.val();
        self.place_f.y.next = self.place_e.late_y.val();
        self.place_f.address.next = self.place_e.late_address.val();
        self.place_f.depth.next = self.place_e.late_depth.val();

        self.late_fragment.next = self.place_f.late_fragment.val();
        self.late_x.next = self.place_f.late_x.val();
        self.late_y.next = self.place_f.late_y.val();
        self.late_address.next = self.place_f.late_address.val();
        self.late_depth.next = self.place_f.late_depth.val();
        self.busy.next = self.place_a.busy.val()
            || self.place_b.busy.val()
            || self.place_c.busy.val()
            || self.place_d.busy.val()
            || self.place_e.busy.val()
            || self.place_f.busy.val();
    }
}

crate::clocked!(BumpPlaces<A>, const A: usize;
    inputs go, fragment, x, y, address, depth;
    outputs late_fragment, late_x, late_y, late_address, late_depth, busy);
