//! The textured core with affine addresses: six-knot colours times a texture, u and v linear on the screen.
//!
//! For surfaces without perspective, or so small that it does not show: affine addresses are off by at most
//! (√r − 1)/(√r + 1) of the picture's extent on the triangle, r being its ratio of depths.
//!
//! Colours as in the [quadratic core](super::quadratic), the zero words 4 to 9 making them planes (Gouraud); behind the
//! interpolants the [texture unit](crate::texture), then clamp, depth test and pixel stream. Ranges and rounding are in
//! the modules named.

use super::phong::fragment_delay::FragmentDelay;
use super::pixel_stream::PixelStream;
use crate::format::{bit_cast_u, U};
use crate::interpolate::linear_2::Linear2;
use crate::interpolate::quadratic_2::Quadratic2;
use crate::raster::shell::Shell;
use crate::simulate::{Quiet, Register, Wire};
use crate::texture::unit::TextureUnit;
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// `D`: width of a colour, `N`: its fraction bits below 1/64 LSB, `B`: width of the register bus, `K`: fraction bits of
/// an address below 2⁻¹² texel, `A`: width of a frame address.
///
/// `select` is a mask (bits 7 to 4) over a word number (bits 3 to 0). Without bit 7: bit 4 red, 5 green, 6 blue, none the
/// shell, whose word 12 is the fence. With bit 7: none depth, bit 4 u, bit 5 v, bit 6 the texture.
#[derive(LogicBlock)]
pub struct TexturedAffineCore<
    const D: usize,
    const N: usize,
    const B: usize,
    const K: usize,
    const A: usize,
> {
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
    /// Mask within colours or within the rest.
    targets: Wire<U<3>>,
    /// A colour or the shell is written.
    write_colour: Wire<Bit>,
    /// Depth, address or texture is written.
    write_other: Wire<Bit>,
    /// The shell is written.
    write_shell: Wire<Bit>,
    /// The fence is written.
    fence: Wire<Bit>,
    /// A triangle is waiting or being walked, or a pixel has no colour yet.
    walking: Wire<Bit>,
    /// Register bus as wide as a shell word.
    bus_32: Wire<U<32>>,
    /// Register bus as wide as a colour.
    bus_colour: Wire<U<D>>,
    /// Register file of the shell, edge walk, pixel counter.
    shell: Quiet<Shell<A>>,
    /// Red, 1/64 LSB.
    red_value: Quiet<Quadratic2<D, 17, N>>,
    /// Green, 1/64 LSB.
    green_value: Quiet<Quadratic2<D, 17, N>>,
    /// Blue, 1/64 LSB.
    blue_value: Quiet<Quadratic2<D, 17, N>>,
    /// u modulo 1024, 2^-12 texel.
    u_value: Quiet<Linear2<B, 21, K>>,
    /// v modulo 1024, 2^-12 texel.
    v_value: Quiet<Linear2<B, 21, K>>,
    /// Depth less 32768.
    depth_value: Quiet<Linear2<32, 15, 16>>,
    /// Texels and their product with the colour.
    texture: Quiet<TextureUnit>,
    /// Where the pixels are, stages 1 to 3.
    place_a: Quiet<FragmentDelay<A>>,
    /// Where the pixels are, stages 4 to 6.
    place_b: Quiet<FragmentDelay<A>>,
    /// Clamp, depth test, output register.
    stream: Quiet<PixelStream<A>>,
}

impl<const D: usize, const N: usize, const B: usize, const K: usize, const A: usize>
    TexturedAffineCore<D, N, B, K, A>
{
    /// A core whose depth memory has `pixels` words and whose texture memory has `texels`.
    #[must_use]
    pub fn new(pixels: usize, texels: usize) -> Self {
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
            targets: Default::default(),
            write_colour: Default::default(),
            write_other: Default::default(),
            write_shell: Default::default(),
            fence: Default::default(),
            walking: Default::default(),
            bus_32: Default::default(),
            bus_colour: Default::default(),
            shell: Default::default(),
            red_value: Default::default(),
            green_value: Default::default(),
            blue_value: Default::default(),
            u_value: Default::default(),
            v_value: Default::default(),
            depth_value: Default::default(),
            texture: TextureUnit::new(texels).into(),
            place_a: Default::default(),
            place_b: Default::default(),
            stream: PixelStream::new(pixels).into(),
        }
    }
}

impl<const D: usize, const N: usize, const B: usize, const K: usize, const A: usize> Logic
    for TexturedAffineCore<D, N, B, K, A>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name textured_affine_core");
        comment!("title Six-knot colours times a texture with affine addresses, depth test, pixel stream.");
        comment!("equation I(x, y) = colour(x, y) texel(u, v); u and v linear in x and y");
        comment!("source Abbas 2003, chapters 7 and 8; texel fetch of Zed3D 1996.");
        comment!("latency Eleven clocks from start to the first pixel; then one pixel per clock.");
        dff_setup!(self, clock, draining);
        // Register file.
        self.open.next = self.shell.load_ready.val() && !self.draining.q.val();
        self.accept.next = self.write.val() && self.open.val();
        self.word.next = self.select.val().get_bits::<4>(0);
        self.targets.next = self.select.val().get_bits::<3>(4);
        self.write_colour.next = self.accept.val() && !self.select.val().get_bit(7);
        self.write_other.next = self.accept.val() && self.select.val().get_bit(7);
        self.write_shell.next = self.write_colour.val() && !self.targets.val().any();
        self.fence.next = self.write_shell.val() && (self.word.val() == 12u64.into());
        self.bus_32.next = bit_cast_u::<32, B>(self.data.val());
        self.bus_colour.next = bit_cast_u::<D, B>(self.data.val());
        self.walking.next =
            self.shell.busy.val() || self.place_a.busy.val() || self.place_b.busy.val();
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

        self.red_value.clock.next = self.clock.val();
        self.red_value.write.next = self.write_colour.val() && self.targets.val().get_bit(0);
        self.red_value.word.next = self.word.val();
        self.red_value.data.next = self.bus_colour.val();
        self.red_value.load.next = self.shell.load.val();
        self.red_value.step.next = self.shell.step.val();
        self.red_value.carry.next = self.shell.carry.val();
        self.red_value.take.next = self.shell.take.val();
        self.red_value.run.next = self.shell.run.val();

        self.green_value.clock.next = self.clock.val();
        self.green_value.write.next = self.write_colour.val() && self.targets.val().get_bit(1);
        self.green_value.word.next = self.word.val();
        self.green_value.data.next = self.bus_colour.val();
        self.green_value.load.next = self.shell.load.val();
        self.green_value.step.next = self.shell.step.val();
        self.green_value.carry.next = self.shell.carry.val();
        self.green_value.take.next = self.shell.take.val();
        self.green_value.run.next = self.shell.run.val();

        self.blue_value.clock.next = self.clock.val();
        self.blue_value.write.next = self.write_colour.val() && self.targets.val().get_bit(2);
        self.blue_value.word.next = self.word.val();
        self.blue_value.data.next = self.bus_colour.val();
        self.blue_value.load.next = self.shell.load.val();
        self.blue_value.step.next = self.shell.step.val();
        self.blue_value.carry.next = self.shell.carry.val();
        self.blue_value.take.next = self.shell.take.val();
        self.blue_value.run.next = self.shell.run.val();

        self.u_value.clock.next = self.clock.val();
        self.u_value.write.next = self.write_other.val() && self.targets.val().get_bit(0);
        self.u_value.word.next = self.word.val();
        self.u_value.data.next = self.data.val();
        self.u_value.load.next = self.shell.load.val();
        self.u_value.step.next = self.shell.step.val();
        self.u_value.carry.next = self.shell.carry.val();
        self.u_value.take.next = self.shell.take.val();
        self.u_value.run.next = self.shell.run.val();

        self.v_value.clock.next = self.clock.val();
        self.v_value.write.next = self.write_other.val() && self.targets.val().get_bit(1);
        self.v_value.word.next = self.word.val();
        self.v_value.data.next = self.data.val();
        self.v_value.load.next = self.shell.load.val();
        self.v_value.step.next = self.shell.step.val();
        self.v_value.carry.next = self.shell.carry.val();
        self.v_value.take.next = self.shell.take.val();
        self.v_value.run.next = self.shell.run.val();

        self.depth_value.clock.next = self.clock.val();
        self.depth_value.write.next = self.write_other.val() && !self.targets.val().any();
        self.depth_value.word.next = self.word.val();
        self.depth_value.data.next = self.bus_32.val();
        self.depth_value.load.next = self.shell.load.val();
        self.depth_value.step.next = self.shell.step.val();
        self.depth_value.carry.next = self.shell.carry.val();
        self.depth_value.take.next = self.shell.take.val();
        self.depth_value.run.next = self.shell.run.val();

        self.texture.clock.next = self.clock.val();
        self.texture.go.next = self.stream.go.val();
        self.texture.write.next = self.write_other.val() && self.targets.val().get_bit(2);
        self.texture.word.next = self.word.val();
        self.texture.data.next = self.bus_32.val();
        self.texture.u.next = self.u_value.value.val();
        self.texture.v.next = self.v_value.value.val();
        self.texture.red.next = self.red_value.value.val();
        self.texture.green.next = self.green_value.value.val();
        self.texture.blue.next = self.blue_value.value.val();

        self.place_a.clock.next = self.clock.val();
        self.place_a.go.next = self.stream.go.val();
        self.place_a.fragment.next = self.shell.fragment.val();
        self.place_a.x.next = self.shell.x.val();
        self.place_a.y.next = self.shell.y.val();
        self.place_a.address.next = self.shell.address.val();
        self.place_a.depth.next = self.depth_value.value.val();

        self.place_b.clock.next = self.clock.val();
        self.place_b.go.next = self.stream.go.val();
        self.place_b.fragment.next = self.place_a.late_fragment.val();
        self.place_b.x.next = self.place_a.late_x.val();
        self.place_b.y.next = self.place_a.late_y.val();
        self.place_b.address.next = self.place_a.late_address.val();
        self.place_b.depth.next = self.place_a.late_depth.val();

        self.stream.clock.next = self.clock.val();
        self.stream.clear.next = self.clear.val();
        self.stream.ready.next = self.ready.val();
        self.stream.walking.next = self.walking.val();
        self.stream.fragment.next = self.place_b.late_fragment.val();
        self.stream.fragment_x.next = self.place_b.late_x.val();
        self.stream.fragment_y.next = self.place_b.late_y.val();
        self.stream.address.next = self.place_b.late_address.val();
        self.stream.fragment_red.next = self.texture.late_red.val();
        self.stream.fragment_green.next = self.texture.late_green.val();
        self.stream.fragment_blue.next = self.texture.late_blue.val();
        self.stream.fragment_depth.next = self.place_b.late_depth.val();

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

crate::clocked!(TexturedAffineCore<D, N, B, K, A>, const D: usize, const N: usize, const B: usize, const K: usize, const A: usize;
    inputs write, select, data, start, clear, ready;
    outputs load_ready, valid, x, y, red, green, blue, depth, busy, done);
