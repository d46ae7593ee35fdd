//! From address and shaded colour to the textured colour: places, four banks, bilinear mean, product; and the words that
//! the host writes: place and size of the picture, and the texels.
//!
//! Six stages, one pixel per clock: column and row, places in the banks, the texels, the rows' means, the mean, the
//! product. The texel memory is written word by word; the place counts the four banks first (columns, then rows), so
//! place 4·k + 2·(row odd) + (column odd) is word k of a bank.

use super::blend::TexelBlend;
use super::modulate::Modulate;
use super::place::TexelPlace;
use crate::depth::frame_memory::PixelMemory;
use crate::format::{bit_cast_u, Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Latency: six clocks from address and colour to the textured colour.
#[derive(LogicBlock)]
pub struct TextureUnit {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Writes a word of the texture, whether the stages move or not.
    pub write: Signal<In, Bit>,
    /// Which: 4 place, 5 size, 6 place of the next texel, 7 texel.
    pub word: Signal<In, U<4>>,
    /// Register bus.
    pub data: Signal<In, U<32>>,
    /// u, in units of 2^-12 texel.
    pub u: Signal<In, Q<21, 0>>,
    /// v likewise.
    pub v: Signal<In, Q<21, 0>>,
    /// Red, in units of 1/64 LSB.
    pub red: Signal<In, Q<17, 0>>,
    /// Green likewise.
    pub green: Signal<In, Q<17, 0>>,
    /// Blue likewise.
    pub blue: Signal<In, Q<17, 0>>,
    /// Red times texel, with half an LSB added.
    pub late_red: Signal<Out, Q<11, 0>>,
    /// Green likewise.
    pub late_green: Signal<Out, Q<11, 0>>,
    /// Blue likewise.
    pub late_blue: Signal<Out, Q<11, 0>>,
    /// Place of the next texel: word of a bank, parity of the row, parity of the column.
    write_place: Register<U<16>>,
    /// A texel is written.
    write_texel: Wire<Bit>,
    /// Bank of the texel.
    bank: Wire<U<2>>,
    /// Word of the bank.
    bank_word: Wire<U<14>>,
    /// The texel: red, green, blue.
    texel: Wire<U<24>>,
    /// The next place.
    next_place: Wire<U<16>>,
    /// One texel.
    one: Constant<U<16>>,
    /// Places and weights.
    place: Quiet<TexelPlace>,
    /// Texels of even columns and even rows.
    even_even: Quiet<PixelMemory<14, 24>>,
    /// Texels of odd columns and even rows.
    odd_even: Quiet<PixelMemory<14, 24>>,
    /// Texels of even columns and odd rows.
    even_odd: Quiet<PixelMemory<14, 24>>,
    /// Texels of odd columns and odd rows.
    odd_odd: Quiet<PixelMemory<14, 24>>,
    /// Red of the texel.
    red_texel: Quiet<TexelBlend>,
    /// Green of the texel.
    green_texel: Quiet<TexelBlend>,
    /// Blue of the texel.
    blue_texel: Quiet<TexelBlend>,
    /// Red times texel.
    red_product: Quiet<Modulate>,
    /// Green times texel.
    green_product: Quiet<Modulate>,
    /// Blue times texel.
    blue_product: Quiet<Modulate>,
}

impl TextureUnit {
    /// A unit whose memory holds so many texels, at least 8 and at most 2^16.
    #[must_use]
    pub fn new(texels: usize) -> Self {
        let bank = || PixelMemory::bank(texels / 4).into();
        Self {
            clock: Default::default(),
            go: Default::default(),
            write: Default::default(),
            word: Default::default(),
            data: Default::default(),
            u: Default::default(),
            v: Default::default(),
            red: Default::default(),
            green: Default::default(),
            blue: Default::default(),
            late_red: Default::default(),
            late_green: Default::default(),
            late_blue: Default::default(),
            write_place: Default::default(),
            write_texel: Default::default(),
            bank: Default::default(),
            bank_word: Default::default(),
            texel: Default::default(),
            next_place: Default::default(),
            one: Constant::new(U::new(1)),
            place: Default::default(),
            even_even: bank(),
            odd_even: bank(),
            even_odd: bank(),
            odd_odd: bank(),
            red_texel: Default::default(),
            green_texel: Default::default(),
            blue_texel: Default::default(),
            red_product: Default::default(),
            green_product: Default::default(),
            blue_product: Default::default(),
        }
    }
}

impl Logic for TextureUnit {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name texture_unit");
        comment!("title Four neighbouring texels in every clock, their mean, and its product with the colour.");
        comment!("equation late = colour * texel(u, v), the texel bilinear or nearest");
        comment!("source Zed3D 1996, bilinear; modulation of fixed-function hardware.");
        comment!("latency Six clocks; one pixel per clock.");
        dff_setup!(self, clock, write_place);
        self.write_texel.next = self.write.val() && (self.word.val() == 7u64.into());
        self.bank.next = self.write_place.q.val().get_bits::<2>(0);
        self.bank_word.next = self.write_place.q.val().get_bits::<14>(2);
        self.texel.next = bit_cast_u::<24, 32>(self.data.val());
        self.next_place.next = self.write_place.q.val() + self.one.val();
        if self.write_texel.val() {
            self.write_place.d.next = self.next_place.val();
        } else if self.write.val() && (self.word.val() == 6u64.into()) {
            self.write_place.d.next = bit_cast_u::<16, 32>(self.data.val());
        }

        self.place.clock.next = self.clock.val();
        self.place.go.next = self.go.val();
        self.place.write_place.next = self.write.val() && (self.word.val() == 4u64.into());
        self.place.write_size.next = self.write.val() && (self.word.val() == 5u64.into());
        self.place.data.next = self.data.val();
        self.place.u.next = self.u.val();
        self.place.v.next = self.v.val();

        self.even_even.clock.next = self.clock.val();
        self.even_even.read.next = self.go.val();
        self.even_even.read_address.next = self.place.even_even.val();
        self.even_even.write.next = self.write_texel.val() && (self.bank.val() == 0u64.into());
        self.even_even.write_address.next = self.bank_word.val();
        self.even_even.write_data.next = self.texel.val();

        self.odd_even.clock.next = self.clock.val();
        self.odd_even.read.next = self.go.val();
        self.odd_even.read_address.next = self.place.odd_even.val();
        self.odd_even.write.next = self.write_texel.val() && (self.bank.val() == 1u64.into());
        self.odd_even.write_address.next = self.bank_word.val();
        self.odd_even.write_data.next = self.texel.val();

        self.even_odd.clock.next = self.clock.val();
        self.even_odd.read.next = self.go.val();
        self.even_odd.read_address.next = self.place.even_odd.val();
        self.even_odd.write.next = self.write_texel.val() && (self.bank.val() == 2u64.into());
        self.even_odd.write_address.next = self.bank_word.val();
        self.even_odd.write_data.next = self.texel.val();

        self.odd_odd.clock.next = self.clock.val();
        self.odd_odd.read.next = self.go.val();
        self.odd_odd.read_address.next = self.place.odd_odd.val();
        self.odd_odd.write.next = self.write_texel.val() && (self.bank.val() == 3u64.into());
        self.odd_odd.write_address.next = self.bank_word.val();
        self.odd_odd.write_data.next = self.texel.val();

        self.red_texel.clock.next = self.clock.val();
        self.red_texel.go.next = self.go.val();
        self.red_texel.even_even.next = self.even_even.read_data.val().get_bits::<8>(16);
        self.red_texel.odd_even.next = self.odd_even.read_data.val().get_bits::<8>(16);
        self.red_texel.even_odd.next = self.even_odd.read_data.val().get_bits::<8>(16);
        self.red_texel.odd_odd.next = self.odd_odd.read_data.val().get_bits::<8>(16);
        self.red_texel.column_weight.next = self.place.column_weight.val();
        self.red_texel.row_weight.next = self.place.row_weight.val();

        self.green_texel.clock.next = self.clock.val();
        self.green_texel.go.next = self.go.val();
        self.green_texel.even_even.next = self.even_even.read_data.val().get_bits::<8>(8);
        self.green_texel.odd_even.next = self.odd_even.read_data.val().get_bits::<8>(8);
        self.green_texel.even_odd.next = self.even_odd.read_data.val().get_bits::<8>(8);
        self.green_texel.odd_odd.next = self.odd_odd.read_data.val().get_bits::<8>(8);
        self.green_texel.column_weight.next = self.place.column_weight.val();
        self.green_texel.row_weight.next = self.place.row_weight.val();

        self.blue_texel.clock.next = self.clock.val();
        self.blue_texel.go.next = self.go.val();
        self.blue_texel.even_even.next = self.even_even.read_data.val().get_bits::<8>(0);
        self.blue_texel.odd_even.next = self.odd_even.read_data.val().get_bits::<8>(0);
        self.blue_texel.even_odd.next = self.even_odd.read_data.val().get_bits::<8>(0);
        self.blue_texel.odd_odd.next = self.odd_odd.read_data.val().get_bits::<8>(0);
        self.blue_texel.column_weight.next = self.place.column_weight.val();
        self.blue_texel.row_weight.next = self.place.row_weight.val();

        self.red_product.clock.next = self.clock.val();
        self.red_product.go.next = self.go.val();
        self.red_product.colour.next = self.red.val();
        self.red_product.texel.next = self.red_texel.texel.val();

        self.green_product.clock.next = self.clock.val();
        self.green_product.go.next = self.go.val();
        self.green_product.colour.next = self.green.val();
        self.green_product.texel.next = self.green_texel.texel.val();

        self.blue_product.clock.next = self.clock.val();
        self.blue_product.go.next = self.go.val();
        self.blue_product.colour.next = self.blue.val();
        self.blue_product.texel.next = self.blue_texel.texel.val();

        self.late_red.next = self.red_product.level.val();
        self.late_green.next = self.green_product.level.val();
        self.late_blue.next = self.blue_product.level.val();
    }
}

crate::clocked!(TextureUnit;
    inputs go, write, word, data, u, v, red, green, blue;
    outputs late_red, late_green, late_blue);
