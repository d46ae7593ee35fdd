//! Light and half-way vector of a pixel while the gradient at its place is worked out: two stages that move with `go`.

use crate::format::Q;
use crate::simulate::Register;
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Stages of one [`VectorDelay`].
pub const STAGES: usize = 2;

/// Latency: two clocks. All parts are in units of 2^-16.
#[derive(LogicBlock, Default)]
pub struct VectorDelay {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Light along the first tangent.
    pub light_u: Signal<In, Q<17, 0>>,
    /// Light along the second tangent.
    pub light_v: Signal<In, Q<17, 0>>,
    /// Light along the normal.
    pub light_n: Signal<In, Q<17, 0>>,
    /// Half-way vector along the first tangent.
    pub half_u: Signal<In, Q<17, 0>>,
    /// Half-way vector along the second tangent.
    pub half_v: Signal<In, Q<17, 0>>,
    /// Half-way vector along the normal.
    pub half_n: Signal<In, Q<17, 0>>,
    /// Light along the first tangent, of two clocks ago.
    pub late_light_u: Signal<Out, Q<17, 0>>,
    /// Light along the second tangent, of two clocks ago.
    pub late_light_v: Signal<Out, Q<17, 0>>,
    /// Light along the normal, of two clocks ago.
    pub late_light_n: Signal<Out, Q<17, 0>>,
    /// Half-way vector along the first tangent, of two clocks ago.
    pub late_half_u: Signal<Out, Q<17, 0>>,
    /// Half-way vector along the second tangent, of two clocks ago.
    pub late_half_v: Signal<Out, Q<17, 0>>,
    /// Half-way vector along the normal, of two clocks ago.
    pub late_half_n: Signal<Out, Q<17, 0>>,
    /// Light along the first tangent, stage 1.
    light_u_1: Register<Q<17, 0>>,
    /// Light along the second tangent, stage 1.
    light_v_1: Register<Q<17, 0>>,
    /// Light along the normal, stage 1.
    light_n_1: Register<Q<17, 0>>,
    /// Half-way vector along the first tangent, stage 1.
    half_u_1: Register<Q<17, 0>>,
    /// Half-way vector along the second tangent, stage 1.
    half_v_1: Register<Q<17, 0>>,
    /// Half-way vector along the normal, stage 1.
    half_n_1: Register<Q<17, 0>>,
    /// Light along the first tangent, stage 2.
    light_u_2: Register<Q<17, 0>>,
    /// Light along the second tangent, stage 2.
    light_v_2: Register<Q<17, 0>>,
    /// Light along the normal, stage 2.
    light_n_2: Register<Q<17, 0>>,
    /// Half-way vector along the first tangent, stage 2.
    half_u_2: Register<Q<17, 0>>,
    /// Half-way vector along the second tangent, stage 2.
    half_v_2: Register<Q<17, 0>>,
    /// Half-way vector along the normal, stage 2.
    half_n_2: Register<Q<17, 0>>,
}

impl Logic for VectorDelay {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name vector_delay");
        comment!(
            "title Light and half-way vector while the gradient of a bump is worked out: two stages."
        );
        comment!("equation late = vectors of two moves ago");
        comment!("source Pipeline registers.");
        comment!("latency Two clocks.");
        dff_setup!(
            self, clock, light_u_1, light_v_1, light_n_1, half_u_1, half_v_1, half_n_1, light_u_2,
            light_v_2, light_n_2, half_u_2, half_v_2, half_n_2
        );
        if self.go.val() {
            self.light_u_1.d.next = self.light_u.val();
            self.light_v_1.d.next = self.light_v.val();
            self.light_n_1.d.next = self.light_n.val();
            self.half_u_1.d.next = self.half_u.val();
            self.half_v_1.d.next = self.half_v.val();
            self.half_n_1.d.next = self.half_n.val();
            self.light_u_2.d.next = self.light_u_1.q.val();
            self.light_v_2.d.next = self.light_v_1.q.val();
            self.light_n_2.d.next = self.light_n_1.q.val();
            self.half_u_2.d.next = self.half_u_1.q.val();
            self.half_v_2.d.next = self.half_v_1.q.val();
            self.half_n_2.d.next = self.half_n_1.q.val();
        }
        self.late_light_u.next = self.light_u_2.q.val();
        self.late_light_v.next = self.light_v_2.q.val();
        self.late_light_n.next = self.light_n_2.q.val();
        self.late_half_u.next = self.half_u_2.q.val();
        self.late_half_v.next = self.half_v_2.q.val();
        self.late_half_n.next = self.half_n_2.q.val();
    }
}

crate::clocked!(VectorDelay;
    inputs go, light_u, light_v, light_n, half_u, half_v, half_n;
    outputs late_light_u, late_light_v, late_light_n, late_half_u, late_half_v, late_half_n);
