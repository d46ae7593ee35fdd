//! N·L and the place in the lobe of a pixel with bumps, whose normal is brought to unit length by reflection: the
//! gradient at its place, the factors, both cosines.

use super::cosines::BumpCosines;
use super::map::BumpMap;
use super::reflection::BumpReflection;
use super::vector_delay::VectorDelay;
use crate::format::{Q, U};
use crate::simulate::{Quiet, Wire};
use rust_hdl_core::prelude::*;

/// Clocks from place and vectors to the arguments of the reflection model.
pub const STAGES: usize = super::map::STAGES + super::reflection::STAGES + super::cosines::STAGES;

/// Latency: fourteen clocks.
#[derive(LogicBlock, Default)]
pub struct BumpReflectionLight {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Writes `data` to a word of the material, whether the stages move or not.
    pub write: Signal<In, Bit>,
    /// Word of the material: 11 scale of the lobe, 12 to 14 the map.
    pub word: Signal<In, U<4>>,
    /// Register bus.
    pub data: Signal<In, U<36>>,
    /// Column of the map, less half a sample, in units of 2^-12; the map repeats.
    pub u: Signal<In, Q<21, 0>>,
    /// Row, likewise.
    pub v: Signal<In, Q<21, 0>>,
    /// Light along the first tangent, in units of 2^-16.
    pub light_u: Signal<In, Q<17, 0>>,
    /// Light along the second tangent, in units of 2^-16.
    pub light_v: Signal<In, Q<17, 0>>,
    /// Light along the normal, in units of 2^-16.
    pub light_n: Signal<In, Q<17, 0>>,
    /// Half-way vector along the first tangent, in units of 2^-16.
    pub half_u: Signal<In, Q<17, 0>>,
    /// Half-way vector along the second tangent, in units of 2^-16.
    pub half_v: Signal<In, Q<17, 0>>,
    /// Half-way vector along the normal, in units of 2^-16.
    pub half_n: Signal<In, Q<17, 0>>,
    /// N.L of fourteen clocks ago, in units of 2^-16.
    pub light: Signal<Out, Q<18, 0>>,
    /// Its place in the lobe, in units of 2^-19.
    pub place: Signal<Out, Q<29, 0>>,
    /// The scale of the lobe is written.
    write_scale: Wire<Bit>,
    /// The gradient.
    map: Quiet<BumpMap>,
    /// The factors of its normal.
    normal: Quiet<BumpReflection>,
    /// Vectors, stages 1 and 2.
    vectors_a: Quiet<VectorDelay>,
    /// Vectors, stages 3 and 4.
    vectors_b: Quiet<VectorDelay>,
    /// Vectors, stages 5 and 6.
    vectors_c: Quiet<VectorDelay>,
    /// Vectors, stages 7 and 8.
    vectors_d: Quiet<VectorDelay>,
    /// Vectors, stages 9 and 10.
    vectors_e: Quiet<VectorDelay>,
    /// Both cosines.
    cosines: Quiet<BumpCosines>,
}

impl Logic for BumpReflectionLight {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name bump_reflection_light");
        comment!(
            "title N.L and the place in the lobe of a pixel with bumps, normalised by reflection."
        );
        comment!("equation N = (-F_u t, -F_v t, 2 t - 1), t = 4 / (g^2 + 4), g^2 = F_u^2 + F_v^2; light = N.L, place = (1 - N.H) 2^s");
        comment!("source Hast 2004, sections 2.3, 3.4.1 and 3.4.2, equations 3.269 to 3.271.");
        comment!("latency Fourteen clocks; one pair per clock.");
        self.write_scale.next = self.write.val() && (self.word.val() == 11u64.into());
        self.map.clock.next = self.clock.val();
        self.map.go.next = self.go.val();
        self.map.write.next = self.write.val();
        self.map.word.next = self.word.val();
        self.map.data.next = self.data.val();
        self.map.u.next = self.u.val();
        self.map.v.next = self.v.val();

        self.normal.clock.next = self.clock.val();
        self.normal.go.next = self.go.val();
        self.normal.slope_u.next = self.map.slope_u.val();
        self.normal.slope_v.next = self.map.slope_v.val();

        self.vectors_a.clock.next = self.clock.val();
        self.vectors_a.go.next = self.go.val();
        self.vectors_a.light_u.next = self.light_u.val();
        self.vectors_a.light_v.next = self.light_v.val();
        self.vectors_a.light_n.next = self.light_n.val();
        self.vectors_a.half_u.next = self.half_u.val();
        self.vectors_a.half_v.next = self.half_v.val();
        self.vectors_a.half_n.next = self.half_n.val();

        self.vectors_b.clock.next = self.clock.val();
        self.vectors_b.go.next = self.go.val();
        self.vectors_b.light_u.next = self.vectors_a.late_light_u.val();
        self.vectors_b.light_v.next = self.vectors_a.late_light_v.val();
        self.vectors_b.light_n.next = self.vectors_a.late_light_n.val();
        self.vectors_b.half_u.next = self.vectors_a.late_half_u.val();
        self.vectors_b.half_v.next = self.vectors_a.late_half_v.val();
        self.vectors_b.half_n.next = self.vectors_a.late_half_n.val();

        self.vectors_c.clock.next = self.clock.val();
        self.vectors_c.go.next = self.go.val();
        self.vectors_c.light_u.next = self.vectors_b.late_light_u.val();
        self.vectors_c.light_v.next = self.vectors_b.late_light_v.val();
        self.vectors_c.light_n.next = self.vectors_b.late_light_n.val();
        self.vectors_c.half_u.next = self.vectors_b.late_half_u.val();
        self.vectors_c.half_v.next = self.vectors_b.late_half_v.val();
        self.vectors_c.half_n.next = self.vectors_b.late_half_n.val();

        self.vectors_d.clock.next = self.clock.val();
        self.vectors_d.go.next = self.go.val();
        self.vectors_d.light_u.next = self.vectors_c.late_light_u.val();
        self.vectors_d.light_v.next = self.vectors_c.late_light_v.val();
        self.vectors_d.light_n.next = self.vectors_c.late_light_n.val();
        self.vectors_d.half_u.next = self.vectors_c.late_half_u.val();
        self.vectors_d.half_v.next = self.vectors_c.late_half_v.val();
        self.vectors_d.half_n.next = self.vectors_c.late_half_n.val();

        self.vectors_e.clock.next = self.clock.val();
        self.vectors_e.go.next = self.go.val();
        self.vectors_e.light_u.next = self.vectors_d.late_light_u.val();
        self.vectors_e.light_v.next = self.vectors_d.late_light_v.val();
        self.vectors_e.light_n.next = self.vectors_d.late_light_n.val();
        self.vectors_e.half_u.next = self.vectors_d.late_half_u.val();
        self.vectors_e.half_v.next = self.vectors_d.late_half_v.val();
        self.vectors_e.half_n.next = self.vectors_d.late_half_n.val();

        self.cosines.clock.next = self.clock.val();
        self.cosines.go.next = self.go.val();
        self.cosines.write_scale.next = self.write_scale.val();
        self.cosines.scale.next = self.data.val().get_bits::<3>(0);
        self.cosines.slope_u.next = self.normal.late_u.val();
        self.cosines.slope_v.next = self.normal.late_v.val();
        self.cosines.across.next = self.normal.across.val();
        self.cosines.along.next = self.normal.along.val();
        self.cosines.light_u.next = self.vectors_e.late_light_u.val();
        self.cosines.light_v.next = self.vectors_e.late_light_v.val();
        self.cosines.light_n.next = self.vectors_e.late_light_n.val();
        self.cosines.half_u.next = self.vectors_e.late_half_u.val();
        self.cosines.half_v.next = self.vectors_e.late_half_v.val();
        self.cosines.half_n.next = self.vectors_e.late_half_n.val();
        self.light.next = self.cosines.light.val();
        self.place.next = self.cosines.place.val();
    }
}

crate::clocked!(BumpReflectionLight;
    inputs go, write, word, data, u, v, light_u, light_v, light_n, half_u, half_v, half_n;
    outputs light, place);
