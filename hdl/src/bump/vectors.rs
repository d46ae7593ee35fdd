//! Light and half-way vector over a triangle, turned into the frame of the surface: their six parts as quadrics.
//!
//! Linear interpolation makes the vectors too short between the vertices and highlights vanish with them; six-point
//! quadratics, the middles of the edges at unit length, keep the length without a square root per pixel (Hast 2004,
//! section 3.3.6). Parts of unit vectors at six knots stay within ±5/3 between them, so one integer bit is enough.

use crate::format::{Q, U};
use crate::interpolate::quadratic_2::Quadratic2;
use crate::simulate::{Quiet, Wire};
use rust_hdl_core::prelude::*;

/// `B`: width of the register bus, `N`: fraction bits below units of 2^-16.
#[derive(LogicBlock, Default)]
pub struct BumpVectors<const B: usize, const N: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to register word `word` of the target.
    pub write: Signal<In, Bit>,
    /// Part to write: 1 to 3 of the light, 5 to 7 of the half-way vector.
    pub target: Signal<In, U<4>>,
    /// Register word.
    pub word: Signal<In, U<4>>,
    /// Register bus.
    pub data: Signal<In, U<B>>,
    /// Moves the register words to the line registers: a new triangle begins.
    pub load: Signal<In, Bit>,
    /// Steps the line registers to the next span start.
    pub step: Signal<In, Bit>,
    /// The step is the carrying one.
    pub carry: Signal<In, Bit>,
    /// Moves the line registers to the pixel registers: a new span begins.
    pub take: Signal<In, Bit>,
    /// Steps the pixel registers.
    pub run: Signal<In, Bit>,
    /// Light along the first tangent, 2^-16.
    pub light_u: Signal<Out, Q<17, 0>>,
    /// Light along the second tangent, 2^-16.
    pub light_v: Signal<Out, Q<17, 0>>,
    /// Light along the normal, 2^-16.
    pub light_n: Signal<Out, Q<17, 0>>,
    /// Half-way vector along the first tangent, 2^-16.
    pub half_u: Signal<Out, Q<17, 0>>,
    /// Half-way vector along the second tangent, 2^-16.
    pub half_v: Signal<Out, Q<17, 0>>,
    /// Half-way vector along the normal, 2^-16.
    pub half_n: Signal<Out, Q<17, 0>>,
    /// Light along the first tangent: it is written.
    write_light_u: Wire<Bit>,
    /// Light along the second tangent: it is written.
    write_light_v: Wire<Bit>,
    /// Light along the normal: it is written.
    write_light_n: Wire<Bit>,
    /// Half-way vector along the first tangent: it is written.
    write_half_u: Wire<Bit>,
    /// Half-way vector along the second tangent: it is written.
    write_half_v: Wire<Bit>,
    /// Half-way vector along the normal: it is written.
    write_half_n: Wire<Bit>,
    /// Light along the first tangent, 2^-16.
    light_u_value: Quiet<Quadratic2<B, 17, N>>,
    /// Light along the second tangent, 2^-16.
    light_v_value: Quiet<Quadratic2<B, 17, N>>,
    /// Light along the normal, 2^-16.
    light_n_value: Quiet<Quadratic2<B, 17, N>>,
    /// Half-way vector along the first tangent, 2^-16.
    half_u_value: Quiet<Quadratic2<B, 17, N>>,
    /// Half-way vector along the second tangent, 2^-16.
    half_v_value: Quiet<Quadratic2<B, 17, N>>,
    /// Half-way vector along the normal, 2^-16.
    half_n_value: Quiet<Quadratic2<B, 17, N>>,
}

impl<const B: usize, const N: usize> Logic for BumpVectors<B, N> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name bump_vectors");
        comment!(
            "title Light and half-way vector in the frame of a surface, quadratic over a triangle."
        );
        comment!(
            "equation each part f(x, y) quadratic through its values at vertices and mid-edges"
        );
        comment!("source Hast 2004, section 3.3.6; Abbas 2003, section 2.2.3.");
        comment!(
            "latency One clock each from write, load and take to the vectors; one pair per clock."
        );
        self.write_light_u.next = self.write.val() && (self.target.val() == 1u64.into());
        self.write_light_v.next = self.write.val() && (self.target.val() == 2u64.into());
        self.write_light_n.next = self.write.val() && (self.target.val() == 3u64.into());
        self.write_half_u.next = self.write.val() && (self.target.val() == 5u64.into());
        self.write_half_v.next = self.write.val() && (self.target.val() == 6u64.into());
        self.write_half_n.next = self.write.val() && (self.target.val() == 7u64.into());

        self.light_u_value.clock.next = self.clock.val();
        self.light_u_value.write.next = self.write_light_u.val();
        self.light_u_value.word.next = self.word.val();
        self.light_u_value.data.next = self.data.val();
        self.light_u_value.load.next = self.load.val();
        self.light_u_value.step.next = self.step.val();
        self.light_u_value.carry.next = self.carry.val();
        self.light_u_value.take.next = self.take.val();
        self.light_u_value.run.next = self.run.val();
        self.light_u.next = self.light_u_value.value.val();

        self.light_v_value.clock.next = self.clock.val();
        self.light_v_value.write.next = self.write_light_v.val();
        self.light_v_value.word.next = self.word.val();
        self.light_v_value.data.next = self.data.val();
        self.light_v_value.load.next = self.load.val();
        self.light_v_value.step.next = self.step.val();
        self.light_v_value.carry.next = self.carry.val();
        self.light_v_value.take.next = self.take.val();
        self.light_v_value.run.next = self.run.val();
        self.light_v.next = self.light_v_value.value.val();

        self.light_n_value.clock.next = self.clock.val();
        self.light_n_value.write.next = self.write_light_n.val();
        self.light_n_value.word.next = self.word.val();
        self.light_n_value.data.next = self.data.val();
        self.light_n_value.load.next = self.load.val();
        self.light_n_value.step.next = self.step.val();
        self.light_n_value.carry.next = self.carry.val();
        self.light_n_value.take.next = self.take.val();
        self.light_n_value.run.next = self.run.val();
        self.light_n.next = self.light_n_value.value.val();

        self.half_u_value.clock.next = self.clock.val();
        self.half_u_value.write.next = self.write_half_u.val();
        self.half_u_value.word.next = self.word.val();
        self.half_u_value.data.next = self.data.val();
        self.half_u_value.load.next = self.load.val();
        self.half_u_value.step.next = self.step.val();
        self.half_u_value.carry.next = self.carry.val();
        self.half_u_value.take.next = self.take.val();
        self.half_u_value.run.next = self.run.val();
        self.half_u.next = self.half_u_value.value.val();

        self.half_v_value.clock.next = self.clock.val();
        self.half_v_value.write.next = self.write_half_v.val();
        self.half_v_value.word.next = self.word.val();
        self.half_v_value.data.next = self.data.val();
        self.half_v_value.load.next = self.load.val();
        self.half_v_value.step.next = self.step.val();
        self.half_v_value.carry.next = self.carry.val();
        self.half_v_value.take.next = self.take.val();
        self.half_v_value.run.next = self.run.val();
        self.half_v.next = self.half_v_value.value.val();

        self.half_n_value.clock.next = self.clock.val();
        self.half_n_value.write.next = self.write_half_n.val();
        self.half_n_value.word.next = self.word.val();
        self.half_n_value.data.next = self.data.val();
        self.half_n_value.load.next = self.load.val();
        self.half_n_value.step.next = self.step.val();
        self.half_n_value.carry.next = self.carry.val();
        self.half_n_value.take.next = self.take.val();
        self.half_n_value.run.next = self.run.val();
        self.half_n.next = self.half_n_value.value.val();
    }
}

crate::clocked!(BumpVectors<B, N>, const B: usize, const N: usize;
    inputs write, target, word, data, load, step, carry, take, run;
    outputs light_u, light_v, light_n, half_u, half_v, half_n);
