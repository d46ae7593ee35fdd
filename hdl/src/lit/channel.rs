//! One colour channel of lit surfaces: ambient + diffuse·D + highlight·S, from the factors D and S of a pixel and the
//! three colours of its material.
//!
//! # Range and rounding
//! Factors are 0 to 65536 = 1.0. Colours are Q11.6 words of at most 682 LSB each (what a host may write; see
//! [`LARGEST`]), so the sum stays below 2048 and cannot wrap. Each product is cut to 16 fraction bits, an error below
//! 2^−16 LSB; a colour word is rounded to nearest, 2^−7 LSB each. Half an LSB for the rounding of the output is in the
//! word of the ambient colour.

use super::table_memory::{TableMemory, TableMemoryModel};
use crate::format::{
    bit_cast_u, signed_cast_align, signed_cast_bits, signed_cast_product, wrap, Q, U,
};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Largest colour that a host may write, LSB, ambient with its half LSB included: three of them stay below 2048.
pub const LARGEST: f64 = 682.0;
/// Fraction bits of a colour word.
pub const COLOUR_FRACTION_BITS: usize = 6;

/// Latency: three clocks from material, two from the factors.
#[derive(LogicBlock, Default)]
pub struct LitChannel {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move.
    pub go: Signal<In, Bit>,
    /// Material of the pixel that is a clock before its factors.
    pub material: Signal<In, U<2>>,
    /// Diffuse factor of the pixel, 65536 is 1.
    pub diffuse: Signal<In, U<17>>,
    /// Factor of its highlight.
    pub highlight: Signal<In, U<17>>,
    /// Writes `colour` to the ambient colours.
    pub write_ambient: Signal<In, Bit>,
    /// Writes `colour` to the diffuse colours.
    pub write_diffuse: Signal<In, Bit>,
    /// Writes `colour` to the colours of highlights.
    pub write_highlight: Signal<In, Bit>,
    /// Material to write.
    pub write_material: Signal<In, U<2>>,
    /// Colour to write.
    pub colour: Signal<In, U<18>>,
    /// Integer part of the colour, with half an LSB added, two clocks after the factors.
    pub value: Signal<Out, Q<11, 0>>,
    /// Ambient colour beside the products.
    base: Register<Q<11, 6>>,
    /// Diffuse colour times its factor.
    diffuse_part: Register<Q<11, 16>>,
    /// Highlight colour times its factor.
    highlight_part: Register<Q<11, 16>>,
    /// Sum of the three.
    sum: Register<Q<11, 16>>,
    /// Diffuse factor as a signed word.
    diffuse_factor: Wire<Q<1, 16>>,
    /// Factor of the highlight as a signed word.
    highlight_factor: Wire<Q<1, 16>>,
    /// Diffuse factor, one bit wider.
    diffuse_bits: Wire<U<18>>,
    /// Factor of the highlight, one bit wider.
    highlight_bits: Wire<U<18>>,
    /// Ambient colour of the pixel.
    base_colour: Wire<Q<11, 6>>,
    /// Diffuse colour of the pixel.
    diffuse_colour: Wire<Q<11, 6>>,
    /// Highlight colour of the pixel.
    highlight_colour: Wire<Q<11, 6>>,
    /// Ambient colours by material.
    ambients: Quiet<TableMemory<2, 18>>,
    /// Diffuse colours by material.
    diffuses: Quiet<TableMemory<2, 18>>,
    /// Highlight colours by material.
    highlights: Quiet<TableMemory<2, 18>>,
}

impl Logic for LitChannel {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name lit_channel");
        comment!("title One colour channel of a lit surface from its two factors.");
        comment!("equation I = ambient + diffuse D + highlight S");
        comment!("source Abbas 2003, section 6.3 and figure 6.6: the amplitude multipliers.");
        comment!("latency Two clocks from the factors to the value.");
        dff_setup!(self, clock, base, diffuse_part, highlight_part, sum);
        self.ambients.clock.next = self.clock.val();
        self.ambients.read.next = self.go.val();
        self.ambients.read_address.next = self.material.val();
        self.ambients.write.next = self.write_ambient.val();
        self.ambients.write_address.next = self.write_material.val();
        self.ambients.write_data.next = self.colour.val();
        self.diffuses.clock.next = self.clock.val();
        self.diffuses.read.next = self.go.val();
        self.diffuses.read_address.next = self.material.val();
        self.diffuses.write.next = self.write_diffuse.val();
        self.diffuses.write_address.next = self.write_material.val();
        self.diffuses.write_data.next = self.colour.val();
        self.highlights.clock.next = self.clock.val();
        self.highlights.read.next = self.go.val();
        self.highlights.read_address.next = self.material.val();
        self.highlights.write.next = self.write_highlight.val();
        self.highlights.write_address.next = self.write_material.val();
        self.highlights.write_data.next = self.colour.val();

        self.diffuse_bits.next = bit_cast_u::<18, 17>(self.diffuse.val());
        self.highlight_bits.next = bit_cast_u::<18, 17>(self.highlight.val());
        self.diffuse_factor.next = signed_cast_bits::<1, 16, 18>(self.diffuse_bits.val());
        self.highlight_factor.next = signed_cast_bits::<1, 16, 18>(self.highlight_bits.val());
        self.base_colour.next = signed_cast_bits::<11, 6, 18>(self.ambients.read_data.val());
        self.diffuse_colour.next = signed_cast_bits::<11, 6, 18>(self.diffuses.read_data.val());
        self.highlight_colour.next = signed_cast_bits::<11, 6, 18>(self.highlights.read_data.val());
        if self.go.val() {
            self.base.d.next = self.base_colour.val();
            self.diffuse_part.d.next = signed_cast_product::<11, 16>(
                self.diffuse_colour.val() * self.diffuse_factor.val(),
            );
            self.highlight_part.d.next = signed_cast_product::<11, 16>(
                self.highlight_colour.val() * self.highlight_factor.val(),
            );
            self.sum.d.next = signed_cast_align::<11, 16, 11, 6>(self.base.q.val())
                + self.diffuse_part.q.val()
                + self.highlight_part.q.val();
        }
        self.value.next = signed_cast_align::<11, 0, 11, 16>(self.sum.q.val());
    }
}

crate::clocked!(LitChannel;
    inputs go, material, diffuse, highlight, write_ambient, write_diffuse, write_highlight, write_material, colour;
    outputs value);

/// Integer model of [`LitChannel`].
#[derive(Clone, Debug)]
pub struct LitChannelModel {
    colours: [TableMemoryModel; 3],
    base: i64,
    parts: [i64; 2],
    sum: i64,
}

impl Default for LitChannelModel {
    fn default() -> Self {
        Self {
            colours: std::array::from_fn(|_| TableMemoryModel::new(2, 18)),
            base: 0,
            parts: [0; 2],
            sum: 0,
        }
    }
}

impl LitChannelModel {
    /// Integer part of the colour.
    #[must_use]
    pub fn value(&self) -> i64 {
        self.sum >> 16
    }

    /// One clock. `write` is the part (0 ambient, 1 diffuse, 2 highlight), the material and the colour.
    pub fn clock(
        &mut self,
        go: bool,
        material: u64,
        factors: [u64; 2],
        write: Option<(usize, u64, u64)>,
    ) {
        const WIDTH: usize = 28;
        if go {
            let colour = |i: usize| wrap(self.colours[i].read_data as i64, 18);
            self.sum = wrap((self.base << 10) + self.parts[0] + self.parts[1], WIDTH);
            self.base = colour(0);
            self.parts = [0, 1].map(|i| {
                let factor = wrap(factors[i] as i64, 18);
                wrap((colour(i + 1) * factor) >> 6, WIDTH)
            });
        }
        for (part, memory) in self.colours.iter_mut().enumerate() {
            let to = write.filter(|(p, ..)| *p == part);
            memory.clock(go.then_some(material), to.map(|(_, m, c)| (m, c)));
        }
    }
}
