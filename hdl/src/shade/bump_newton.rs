//! The bump core with Newton's normalisation: normals bent by a height map, lit per pixel without a square root or division.
//!
//! In the frame of the surface the normal is k·(−F_u, −F_v, 1) with k = 1 − g²/2 (Hast 2004, sections 2.3 and 3.4): the
//! [gradient](crate::bump::map) comes from a map at an affine address, light and half-way vector are
//! [quadrics](crate::bump::vectors) of their parts in that frame, so that per pixel there are 14 additions and the products of
//! [the unit](crate::bump::newton_light); then the reflection model of the [quadratic-dots core](super::quadratic_dots).
//!
//! # Range and rounding
//! See [`crate::bump`]: cosines are below 4 in any case and 19 bits hold them; addresses are residues.

use super::phong::colour::PhongColour;
use super::pixel_stream::PixelStream;
use crate::bump::newton_light::BumpNewtonLight;
use crate::bump::places::BumpPlaces;
use crate::bump::vectors::BumpVectors;
use crate::format::{bit_cast_u, U};
use crate::interpolate::linear_2::Linear2;
use crate::raster::shell::Shell;
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// `N`: fraction bits of a vector below 2⁻¹⁶, `B`: width of the register bus, `K`: fraction bits of an address below 2⁻¹²
/// sample, `A`: width of a frame address.
///
/// `select` is a target (bits 7 to 4) over a word number (bits 3 to 0). Targets: 0 the shell, whose word 12 is the fence,
/// 1 to 3 the light along both tangents and the normal, 5 to 7 the half-way vector, 4 the material, 8 depth, 9 u, 10 v.
#[derive(LogicBlock)]
pub struct BumpNewtonCore<const N: usize, const B: usize, const K: usize, const A: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to the selected register words; ignored while `load_ready` is low.
    pub write: Signal<In, Bit>,
    /// Mask and word number.
    pub select: Signal<In, U<8>>,
    /// Register bus.
    pub data: Signal<In, U<B>>,
    /// The register words are complete; may accompany the last write. Ignored while `load_ready` is low.
    pub start: Signal<In, Bit>,
    /// Clears the depth memory; ignored while `busy`.
    pub clear: Signal<In, Bit>,
    /// The pixel is taken.
    pub ready: Signal<In, Bit>,
    /// Register words may be written.
    pub load_ready: Signal<Out, Bit>,
    /// A visible pixel is offered; held until `ready`.
    pub valid: Signal<Out, Bit>,
    /// Its column.
    pub x: Signal<Out, U<11>>,
    /// Its row.
    pub y: Signal<Out, U<11>>,
    /// Red.
    pub red: Signal<Out, U<8>>,
    /// Green.
    pub green: Signal<Out, U<8>>,
    /// Blue.
    pub blue: Signal<Out, U<8>>,
    /// Depth, larger is nearer.
    pub depth: Signal<Out, U<16>>,
    /// Anything is waiting, being drawn or being cleared.
    pub busy: Signal<Out, Bit>,
    /// Pulses for one clock when `busy` falls.
    pub done: Signal<Out, Bit>,
    /// Nothing is accepted until the pixels on their way have been coloured.
    draining: Register<Bit>,
    /// Register words are taken.
    open: Wire<Bit>,
    /// A register write is accepted.
    accept: Wire<Bit>,
    /// Register word.
    word: Wire<U<4>>,
    /// What it belongs to.
    target: Wire<U<4>>,
    /// The shell is written.
    write_shell: Wire<Bit>,
    /// The material is written.
    write_material: Wire<Bit>,
    /// The fence is written.
    fence: Wire<Bit>,
    /// A triangle is waiting or being walked, or a pixel has no colour yet.
    walking: Wire<Bit>,
    /// Register bus as wide as a shell word.
    bus_32: Wire<U<32>>,
    /// Register bus as wide as a sample of the map.
    bus_36: Wire<U<36>>,
    /// Register file of the shell, edge walk, pixel counter.
    shell: Quiet<Shell<A>>,
    /// Light and half-way vector.
    vectors: Quiet<BumpVectors<B, N>>,
    /// u modulo 1024, 2^-12 sample.
    u_value: Quiet<Linear2<B, 21, K>>,
    /// v modulo 1024, 2^-12 sample.
    v_value: Quiet<Linear2<B, 21, K>>,
    /// Depth less 32768.
    depth_value: Quiet<Linear2<32, 15, 16>>,
    /// N.L and place in the lobe.
    bent_light: Quiet<BumpNewtonLight>,
    /// The reflection model.
    colour: Quiet<PhongColour>,
    /// Where the pixels are, stages 1 to 18.
    places: Quiet<BumpPlaces<A>>,
    /// Clamp, depth test, output register.
    stream: Quiet<PixelStream<A>>,
}

impl<const N: usize, const B: usize, const K: usize, const A: usize> BumpNewtonCore<N, B, K, A> {
    /// A core whose depth memory has `pixels` words.
    #[must_use]
    pub fn new(pixels: usize) -> Self {
        Self {
            clock: Default::default(),
            write: Default::default(),
            select: Default::default(),
            data: Default::default(),
            start: Default::default(),
            clear: Default::default(),
            ready: Default::default(),
            load_ready: Default::default(),
            valid: Default::default(),
            x: Default::default(),
            y: Default::default(),
            red: Default::default(),
            green: Default::default(),
            blue: Default::default(),
            depth: Default::default(),
            busy: Default::default(),
            done: Default::default(),
            draining: Default::default(),
            open: Default::default(),
            accept: Default::default(),
            word: Default::default(),
            target: Default::default(),
            write_shell: Default::default(),
            write_material: Default::default(),
            fence: Default::default(),
            walking: Default::default(),
            bus_32: Default::default(),
            bus_36: Default::default(),
            shell: Default::default(),
            vectors: Default::default(),
            u_value: Default::default(),
            v_value: Default::default(),
            depth_value: Default::default(),
            bent_light: Default::default(),
            colour: Default::default(),
            places: Default::default(),
            stream: PixelStream::new(pixels).into(),
        }
    }
}

impl<const N: usize, const B: usize, const K: usize, const A: usize> Logic
    for BumpNewtonCore<N, B, K, A>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name bump_newton_core");
        comment!("title Normals bent by a height map and normalised by a Newton step, lit per pixel, depth test, pixel stream.");
        comment!("equation I = ambient + diffuse max(0, N.L) + specular max(0, N.H)^n; N = (1 - g^2/2) (-F_u, -F_v, 1), L and H quadratic in x and y");
        comment!("source Hast 2004, sections 2.3, 3.3.6 and 3.4; Blinn 1978.");
        comment!(
            "latency Twenty-four clocks from start to the first pixel; then one pixel per clock."
        );
        dff_setup!(self, clock, draining);
        // Register file.
        self.open.next = self.shell.load_ready.val() && !self.draining.q.val();
        self.accept.next = self.write.val() && self.open.val();
        self.word.next = self.select.val().get_bits::<4>(0);
        self.target.next = self.select.val().get_bits::<4>(4);
        self.write_shell.next = self.accept.val() && (self.target.val() == 0u64.into());
        self.write_material.next = self.accept.val() && (self.target.val() == 4u64.into());
        self.fence.next = self.write_shell.val() && (self.word.val() == 12u64.into());
        self.bus_32.next = bit_cast_u::<32, B>(self.data.val());
        self.bus_36.next = bit_cast_u::<36, B>(self.data.val());
        self.walking.next = self.shell.busy.val() || self.places.busy.val();
        if self.fence.val() {
            self.draining.d.next = true;
        } else if !self.walking.val() {
            self.draining.d.next = false;
        }

        self.shell.clock.next = self.clock.val();
        self.shell.write.next = self.write_shell.val();
        self.shell.word.next = self.word.val();
        self.shell.data.next = self.bus_32.val();
        self.shell.start.next = self.start.val() && self.open.val();
        self.shell.hold.next = self.stream.clearing.val();
        self.shell.go.next = self.stream.go.val();

        self.vectors.clock.next = self.clock.val();
        self.vectors.write.next = self.accept.val();
        self.vectors.target.next = self.target.val();
        self.vectors.word.next = self.word.val();
        self.vectors.data.next = self.data.val();
        self.vectors.load.next = self.shell.load.val();
        self.vectors.step.next = self.shell.step.val();
        self.vectors.carry.next = self.shell.carry.val();
        self.vectors.take.next = self.shell.take.val();
        self.vectors.run.next = self.shell.run.val();

        self.u_value.clock.next = self.clock.val();
        self.u_value.write.next = self.accept.val() && (self.target.val() == 9u64.into());
        self.u_value.word.next = self.word.val();
        self.u_value.data.next = self.data.val();
        self.u_value.load.next = self.shell.load.val();
        self.u_value.step.next = self.shell.step.val();
        self.u_value.carry.next = self.shell.carry.val();
        self.u_value.take.next = self.shell.take.val();
        self.u_value.run.next = self.shell.run.val();

        self.v_value.clock.next = self.clock.val();
        self.v_value.write.next = self.accept.val() && (self.target.val() == 10u64.into());
        self.v_value.word.next = self.word.val();
        self.v_value.data.next = self.data.val();
        self.v_value.load.next = self.shell.load.val();
        self.v_value.step.next = self.shell.step.val();
        self.v_value.carry.next = self.shell.carry.val();
        self.v_value.take.next = self.shell.take.val();
        self.v_value.run.next = self.shell.run.val();

        self.depth_value.clock.next = self.clock.val();
        self.depth_value.write.next = self.accept.val() && (self.target.val() == 8u64.into());
        self.depth_value.word.next = self.word.val();
        self.depth_value.data.next = self.bus_32.val();
        self.depth_value.load.next = self.shell.load.val();
        self.depth_value.step.next = self.shell.step.val();
        self.depth_value.carry.next = self.shell.carry.val();
        self.depth_value.take.next = self.shell.take.val();
        self.depth_value.run.next = self.shell.run.val();

        self.bent_light.clock.next = self.clock.val();
        self.bent_light.go.next = self.stream.go.val();
        self.bent_light.write.next = self.write_material.val();
        self.bent_light.word.next = self.word.val();
        self.bent_light.data.next = self.bus_36.val();
        self.bent_light.u.next = self.u_value.value.val();
        self.bent_light.v.next = self.v_value.value.val();
        self.bent_light.light_u.next = self.vectors.light_u.val();
        self.bent_light.light_v.next = self.vectors.light_v.val();
        self.bent_light.light_n.next = self.vectors.light_n.val();
        self.bent_light.half_u.next = self.vectors.half_u.val();
        self.bent_light.half_v.next = self.vectors.half_v.val();
        self.bent_light.half_n.next = self.vectors.half_n.val();

        self.colour.clock.next = self.clock.val();
        self.colour.go.next = self.stream.go.val();
        self.colour.write.next = self.write_material.val();
        self.colour.word.next = self.word.val();
        self.colour.data.next = self.bus_32.val();
        self.colour.light.next = self.bent_light.light.val();
        self.colour.place.next = self.bent_light.place.val();

        self.places.clock.next = self.clock.val();
        self.places.go.next = self.stream.go.val();
        self.places.fragment.next = self.shell.fragment.val();
        self.places.x.next = self.shell.x.val();
        self.places.y.next = self.shell.y.val();
        self.places.address.next = self.shell.address.val();
        self.places.depth.next = self.depth_value.value.val();

        self.stream.clock.next = self.clock.val();
        self.stream.clear.next = self.clear.val();
        self.stream.ready.next = self.ready.val();
        self.stream.walking.next = self.walking.val();
        self.stream.fragment.next = self.places.late_fragment.val();
        self.stream.fragment_x.next = self.places.late_x.val();
        self.stream.fragment_y.next = self.places.late_y.val();
        self.stream.address.next = self.places.late_address.val();
        self.stream.fragment_red.next = self.colour.red.val();
        self.stream.fragment_green.next = self.colour.green.val();
        self.stream.fragment_blue.next = self.colour.blue.val();
        self.stream.fragment_depth.next = self.places.late_depth.val();

        self.load_ready.next = self.open.val();
        self.valid.next = self.stream.valid.val();
        self.x.next = self.stream.x.val();
        self.y.next = self.stream.y.val();
        self.red.next = self.stream.red.val();
        self.green.next = self.stream.green.val();
        self.blue.next = self.stream.blue.val();
        self.depth.next = self.stream.depth.val();
        self.busy.next = self.stream.busy.val();
        self.done.next = self.stream.done.val();
    }
}

crate::clocked!(BumpNewtonCore<N, B, K, A>, const N: usize, const B: usize, const K: usize, const A: usize;
    inputs write, select, data, start, clear, ready;
    outputs load_ready, valid, x, y, red, green, blue, depth, busy, done);
