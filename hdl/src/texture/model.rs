//! Integer model of everything that textured cores have between their interpolants and the pixel stream.
//!
//! Stages that depend on nothing but what enters them are worked out when a pixel leaves them; only the places, which
//! depend on words of the texture, and the texels, which depend on the memory, are kept stage by stage.

use super::blend::blend_model;
use super::division::division_model;
use super::modulate::modulate_model;
use super::{
    select, Mapping, Texturing, ADDRESS_FRACTION_BITS, BANK_BITS, COLOUR_FRACTION_BITS,
    PERSPECTIVE_BITS, PRODUCT_FRACTION_BITS, STAGES, W_FRACTION_BITS,
};
use crate::depth::frame_memory::PixelMemoryModel;
use crate::format::mask;
use crate::interpolate::linear_2::{Controls, Linear2Model};
use crate::interpolate::quadratic_2::Quadratic2Model;
use crate::shade::phong::model::{DelayModel, Fragment};
use std::collections::VecDeque;

/// What the host writes about the picture.
#[derive(Clone, Copy, Debug, Default)]
struct Words {
    base: u64,
    nearest: bool,
    column_mask: u64,
    row_mask: u64,
    shift: u64,
    write_place: u64,
}

/// A pixel in the first stage: numbers of the even and the odd column, of the even and the odd row; weights of the odd
/// column and row.
#[derive(Clone, Copy, Debug, Default)]
struct Split {
    columns: [u64; 2],
    rows: [u64; 2],
    weights: [i64; 2],
}

impl Words {
    fn split(&self, address: [i64; 2]) -> Split {
        let one = |at: i64, pairs: u64| {
            let whole = at as u64 >> ADDRESS_FRACTION_BITS & mask(10);
            let (pair, odd) = (whole >> 1, whole & 1);
            let part = match self.nearest {
                true => 0,
                false => at & mask(ADDRESS_FRACTION_BITS) as i64,
            };
            let weight = match odd {
                0 => part,
                _ => (1 << ADDRESS_FRACTION_BITS) - part,
            };
            ([(pair + odd) & pairs, pair & pairs], weight)
        };
        let (columns, x) = one(address[0], self.column_mask);
        let (rows, y) = one(address[1], self.row_mask);
        Split {
            columns,
            rows,
            weights: [x, y],
        }
    }

    /// Places in the banks: even and odd column of the even row, then of the odd one.
    fn places(&self, s: &Split) -> [u64; 4] {
        [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(x, y)| {
            let line = (s.rows[y] << self.shift) & mask(BANK_BITS);
            (self.base + line + s.columns[x]) & mask(BANK_BITS)
        })
    }
}

/// Interpolants of an address.
#[derive(Clone, Debug)]
enum Address {
    Affine([Linear2Model; 2]),
    Quadratic([Quadratic2Model; 2]),
    /// u·w, v·w and w.
    Perspective([Linear2Model; 3]),
}

/// State of the stages and interpolants.
#[derive(Clone, Debug)]
pub struct TextureModel {
    wide: bool,
    mapping: Mapping,
    address: Address,
    words: Words,
    /// Addresses on their way through the division, oldest first.
    divided: VecDeque<[i64; 3]>,
    /// Colours on their way to the product, oldest first.
    colours: VecDeque<[i64; 3]>,
    split: Split,
    places: [u64; 4],
    place_weights: [i64; 2],
    banks: [PixelMemoryModel<u32>; 4],
    texel_weights: [i64; 2],
    /// Texels of the last two moves and their weights, oldest first: on their way through the means.
    texels: [([u32; 4], [i64; 2]); 2],
    levels: [i64; 3],
    /// Where the pixels are.
    pub delay: DelayModel,
    /// Nothing is accepted until the pixels on their way have been coloured.
    pub draining: bool,
}

impl TextureModel {
    /// The stages of a core at power-up.
    #[must_use]
    pub fn new(t: Texturing, wide: bool) -> Self {
        let stages = t.mapping.stages();
        let zeros = |n: usize| VecDeque::from(vec![[0; 3]; n]);
        Self {
            wide,
            mapping: t.mapping,
            address: match t.mapping {
                Mapping::Affine => Address::Affine(Default::default()),
                Mapping::Quadratic => Address::Quadratic(Default::default()),
                Mapping::Perspective => Address::Perspective(Default::default()),
            },
            words: Words::default(),
            divided: zeros(stages),
            colours: zeros(stages + STAGES - 1),
            split: Split::default(),
            places: [0; 4],
            place_weights: [0; 2],
            banks: [0; 4].map(|_| PixelMemoryModel::new(t.texels() / 4)),
            texel_weights: [0; 2],
            texels: Default::default(),
            levels: [0; 3],
            delay: DelayModel::new(stages + STAGES),
            draining: false,
        }
    }

    /// Integer parts of the modulated colour, with half an LSB added.
    #[must_use]
    pub fn levels(&self) -> [i64; 3] {
        self.levels
    }

    /// The values of the interpolants, in the units that the stages behind them take.
    fn values(&self) -> [i64; 3] {
        let below = self.mapping.format(self.wide).1 - ADDRESS_FRACTION_BITS;
        match &self.address {
            Address::Affine([u, v]) => [u.value() >> below, v.value() >> below, 0],
            Address::Quadratic([u, v]) => [u.value() >> below, v.value() >> below, 0],
            Address::Perspective([u, v, w]) => [
                u.value() >> (PRODUCT_FRACTION_BITS - 28),
                v.value() >> (PRODUCT_FRACTION_BITS - 28),
                w.value() >> (W_FRACTION_BITS - 39),
            ],
        }
    }

    /// One clock: an accepted write (select, data), whether the stages move, what the interpolants do, the shaded colour
    /// with [`COLOUR_FRACTION_BITS`] fraction bits, the pixel that enters.
    pub fn clock(
        &mut self,
        write: Option<(u8, u64)>,
        go: bool,
        controls: Controls,
        colour: [i64; 3],
        fragment: Fragment,
    ) {
        let place = self.words.write_place;
        let texel = write
            .filter(|(s, _)| s & 0xcf == select::TEXEL)
            .map(|(_, data)| (place & 3, place >> 2, (data & mask(24)) as u32));
        let places = self.places;
        if go {
            self.advance(colour);
            self.delay.shift(fragment);
        }
        for (i, bank) in (0u64..).zip(&mut self.banks) {
            let own = texel.filter(|t| t.0 == i).map(|t| (t.1, t.2));
            bank.clock(go.then_some(places[i as usize]), own);
        }
        if let Some((select, data)) = write {
            self.write(select, data);
        }
        self.step(write, controls);
    }

    fn advance(&mut self, colour: [i64; 3]) {
        // The last stages first.
        let (texels, [x, y]) = self.texels[0];
        let waited = self.colours.pop_front().unwrap_or(colour);
        self.colours.push_back(colour);
        self.levels = std::array::from_fn(|c| {
            let four = texels.map(|t| i64::from(t >> (16 - 8 * c) & 255));
            modulate_model(waited[c], blend_model(four, x, y))
        });
        let read = [0, 1, 2, 3].map(|i| self.banks[i].read_data);
        self.texels = [self.texels[1], (read, self.texel_weights)];
        self.texel_weights = self.place_weights;
        self.places = self.words.places(&self.split);
        self.place_weights = self.split.weights;
        let values = self.values();
        self.divided.push_back(values);
        let [u, v, w] = self.divided.pop_front().unwrap_or(values);
        self.split = self.words.split(match self.mapping {
            Mapping::Perspective => division_model(u, v, w),
            _ => [u, v],
        });
    }

    fn write(&mut self, select: u8, data: u64) {
        let w = &mut self.words;
        // Other bits of the mask may be set as well.
        match select & 0xcf {
            select::PLACE => {
                w.base = data & mask(BANK_BITS);
                w.nearest = data >> BANK_BITS & 1 == 1;
            }
            select::SIZE => {
                w.column_mask = data & mask(9);
                w.row_mask = data >> 9 & mask(9);
                w.shift = data >> 18 & mask(4);
            }
            select::WRITE_PLACE => w.write_place = data & mask(16),
            select::TEXEL => w.write_place = (w.write_place + 1) & mask(16),
            _ => {}
        }
    }

    fn step(&mut self, write: Option<(u8, u64)>, c: Controls) {
        let own = |which: usize| {
            write
                .filter(|(s, _)| s >> 7 == 1 && s >> (4 + which) & 1 == 1)
                .map(|(s, data)| (usize::from(s & 15), data))
        };
        let (int, frac) = self.mapping.format(self.wide);
        let width = 1 + int + frac;
        match &mut self.address {
            Address::Affine(all) => {
                for (i, m) in all.iter_mut().enumerate() {
                    m.clock(width, own(i), c);
                }
            }
            Address::Quadratic(all) => {
                for (i, m) in all.iter_mut().enumerate() {
                    m.clock(width, own(i), c);
                }
            }
            Address::Perspective(all) => {
                for (i, m) in all.iter_mut().enumerate() {
                    m.clock(PERSPECTIVE_BITS, own(i), c);
                }
            }
        }
    }
}

/// A shaded colour as the texture stages take it.
#[must_use]
pub fn colour_in(code: i64, fraction_bits: usize) -> i64 {
    code >> (fraction_bits - COLOUR_FRACTION_BITS)
}
